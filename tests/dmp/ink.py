"""Random ink for the laws: smooth or not, straight, closed and crossing, in 1 to 3 dimensions."""

import math
from contextlib import suppress
from itertools import product

import numpy as np
from hypothesis import strategies as st

from dmp_teach.dmp.kernels import KERNELS
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError
from dmp_teach.trajectory import Trajectory


def letter(n=300, duration=2.5, *, dimensions=2, size=0.1, seed=0, begin=0.0):
    """A path of a few turns, as smooth as a hand is: five random waves, slow at both ends."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, n)
    eased = t**3 * (10 - 15 * t + 6 * t**2)
    waves = np.sin(np.pi * eased[:, None] * np.arange(1, 6) + rng.uniform(0, 2 * np.pi, 5))
    return Trajectory(
        begin + duration * t,
        size * waves @ rng.normal(size=(5, dimensions)) / 5 + rng.normal(size=dimensions),
    )


@st.composite
def letters(draw):
    """Smooth letters of any length, size and rate that a pad or a camera gives."""
    duration = draw(st.floats(0.3, 6.0))
    n = max(6, round(duration * draw(st.sampled_from([30, 60, 120, 240]))))
    about = {
        "dimensions": st.integers(1, 3),
        "size": st.floats(0.005, 0.3),
        "seed": st.integers(0, 10**6),
    }
    return letter(n, duration, begin=draw(st.floats(-5, 100)), **draw(st.fixed_dictionaries(about)))


@st.composite
def scrawls(draw):
    """Anything that is a trajectory: straight, closed, still, noise; 2 to 2000 samples."""
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    n = draw(st.one_of(st.integers(2, 60), st.integers(2, 2000)))
    dimensions, duration = draw(st.integers(1, 3)), draw(st.floats(0.01, 20.0))
    u = np.linspace(0, 1, n)[:, None]
    kind = draw(st.sampled_from(["straight", "closed", "still", "noise", "walk"]))
    path = {
        "straight": u * rng.normal(size=dimensions),
        "closed": np.sin(2 * np.pi * u * rng.integers(1, 4, size=dimensions)),
        "still": np.zeros((n, dimensions)),
        "noise": rng.normal(size=(n, dimensions)),
        "walk": np.cumsum(rng.normal(size=(n, dimensions)), axis=0) / n,
    }[kind]
    t = duration * u[:, 0]
    if draw(st.booleans()) and n > 2:
        t = np.sort(rng.uniform(0, duration, n)) + 1e-6 * np.arange(n)
    return Trajectory(t, path * draw(st.floats(1e-5, 1.0)))


# What a path of parts u (T, 1) of its time is, for random numbers and D dimensions.
INK = {
    "waves": lambda u, rng, D: (
        letter(len(u), dimensions=D, seed=int(rng.integers(10**6)), size=1.0).position
    ),
    "crossing": lambda u, rng, D: (
        np.sin(2 * np.pi * u * rng.integers(1, 4, D) + rng.uniform(0, 6, D))
        + u * rng.normal(size=D)
    ),
    "closed": lambda u, rng, D: np.sin(2 * np.pi * u * rng.integers(1, 4, D)),
    "straight": lambda u, rng, D: u**3 * (10 - 15 * u + 6 * u**2) * rng.normal(size=D),
    "cut off": lambda u, rng, D: np.cos(3 * u * rng.uniform(0.5, 2, D) + rng.uniform(0, 6, D)),
    "walk": lambda u, rng, D: np.cumsum(rng.normal(size=(len(u), D)), axis=0) / np.sqrt(len(u)),
}


@st.composite
def any_ink(draw):
    """Ink of every kind, 1 to 3 dimensions, 5 to 5000 samples, 0.1 mm to 1 m, times even or not."""
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    n = draw(st.one_of(st.integers(5, 60), st.integers(61, 600), st.integers(601, 5000)))
    duration = float(np.clip(n / draw(st.sampled_from([30, 60, 120, 240, 1000])), 0.02, 30))
    path = INK[draw(st.sampled_from(sorted(INK)))](
        np.linspace(0, 1, n)[:, None], rng, draw(st.integers(1, 3))
    )
    t = np.linspace(0, duration, n)
    if draw(st.integers(0, 4)) == 0:
        t[1:-1] += rng.uniform(-0.4, 0.4, n - 2) * t[1]
    return Trajectory(draw(st.sampled_from([0.0, 12.5])) + t, path * 10 ** draw(st.floats(-4, 0)))


def kernel_settings():
    """Every kernel in the settings that it goes with: widths, sigmas, places and sides."""
    widths, sigmas = (0.7, 1.0, 2.5, math.inf), (0.5, math.inf)
    sides = ("middles", "both"), ("ends", "both"), ("grid", "one")
    for kernel, width, sigma, (centers, side) in product(KERNELS, widths, sigmas, sides):
        chosen = {
            "kernel": kernel,
            "kernel_width": width,
            "kernel_sigma": sigma,
            "kernel_centers": centers,
            "kernel_sides": side,
        }
        with suppress(SettingError):
            Settings(**chosen)
            yield chosen


def in_all_its_steps(p, goal):
    """The rollout of a primitive to a goal, a sample for each step, shape (M + 1, D)."""
    return p.rollout(goal=goal, dt=p.duration / p.steps).position


def to_the_end(pen, push=lambda t: None):
    """All that a `Stepper` draws; `push` is what disturbs it at a time, or None."""
    times, positions = [pen.t], [pen.position]
    while not pen.over:
        pen = pen.step(push(pen.t))
        times.append(pen.t)
        positions.append(pen.position)
    return Trajectory(times, positions)


def rms(path, other):
    """Root mean square distance of two paths, in mm."""
    return 1e3 * float(np.sqrt(((path - other) ** 2).sum(axis=1).mean()))
