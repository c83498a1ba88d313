"""Ink of our own for the robot's tests: smooth, of any size and speed, in one to three strokes."""

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from dmp_teach.trajectory import Trajectory


def law(examples=40, **strategies):
    """What must hold for all ink; nothing here is timed."""
    # The solver that a fixture names is the same for all examples.
    fixed = [HealthCheck.function_scoped_fixture]
    few = settings(deadline=None, max_examples=examples, suppress_health_check=fixed)
    return lambda test: few(given(**strategies)(test))


def wave(duration=1.2, rate=120, start=0.0, *, width=0.06, height=0.1, seed=0):
    """A smooth stroke that begins and ends at full speed, like one cut at a lift."""
    t = np.arange(round(duration * rate) + 1) / rate
    a, b, c, d = np.random.default_rng(seed).uniform(0, 2 * np.pi, 4)
    x = width / 2 * np.sin(2.6 * t / duration + a) + width / 6 * np.sin(7 * t / duration + b)
    y = height / 2 * np.sin(4.1 * t / duration + c) + height / 6 * np.sin(6 * t / duration + d)
    return Trajectory(start + t, np.column_stack([x, y]))


def fitting(strokes, page, most=0.19):
    """The height at which ink fits on a page, at most `most` [m]."""
    extent = np.ptp(np.concatenate([stroke.position for stroke in strokes]), axis=0)
    return min(most, ((page.size - 0.0102) / np.maximum(extent, 1e-9)).min() * extent[1])


def distances(points, path):
    """From each point to the polyline through `path` [m], by the pieces at its nearest corners."""
    corners = cKDTree(path).query(points, min(30, len(path)))[1]
    pieces = np.clip(np.concatenate([corners - 1, corners], axis=1), 0, len(path) - 2)
    away, along = points[:, None] - path[pieces], (path[1:] - path[:-1])[pieces]
    part = (away * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-30)
    return np.linalg.norm(away - np.clip(part, 0, 1)[..., None] * along, axis=-1).min(axis=1)


LETTER = (wave(1.0, seed=1, start=0.4), wave(0.8, seed=2, start=1.9))


@st.composite
def letters(draw, rates=(60, 120, 240, 100)):
    """One to three strokes on one clock, of 15 to 190 mm, as slow and as fast as people write."""
    size, clock, strokes = draw(st.floats(0.015, 0.1)), 0.0, []
    for _ in range(draw(st.integers(1, 3))):
        duration = draw(st.floats(0.3, 2.5))
        rate = draw(st.sampled_from(rates))
        strokes.append(
            wave(
                duration,
                rate,
                clock,
                width=size,
                height=1.4 * size,
                seed=draw(st.integers(0, 10**6)),
            )
        )
        clock = strokes[-1].t[-1] + draw(st.floats(0.05, 3))
    return tuple(strokes)
