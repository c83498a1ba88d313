"""Takes of one stroke: written again and again by one hand, never twice alike."""

from __future__ import annotations

import numpy as np
import scipy

from dmp_teach.arguments import LARGEST_SEED, check_whole, checked
from dmp_teach.trajectory import Array, Trajectory

# Standard deviations from take to take, shares of what varies; wobbles of the stroke's size.
SIZE, WIDTH, LEAN, PACE, PLACE = 0.05, 0.03, 0.05, 0.08, 0.015
# How far the pen strays, and over which share of the stroke it comes back.
WOBBLES = ((0.015, 1 / 8), (0.004, 1 / 30))
HURRY = 0.02
MOST_TAKES = 10_000


@checked
def draw_takes(stroke: Trajectory, number: int, seed: int = 0) -> tuple[Trajectory, ...]:
    """Draw takes of a stroke as one hand would write them, about 6 % of its size apart.

    They differ in size, width, lean, place and pace, in where the pen hurries, and by a slow and a
    quicker wobble. The first n of more takes are those of n.

    Args:
        stroke: What the hand means, at any number of dimensions; the first two lean.
        number: How many.
        seed: Whose hand; the same seed gives the same takes.

    Raises:
        SettingError: No such number, or seed.
    """
    check_whole("number", number, 0, MOST_TAKES)
    check_whole("seed", seed, 0, LARGEST_SEED)
    return tuple(_draw_take(stroke, np.random.default_rng([seed, n])) for n in range(number))


def _draw_take(stroke: Trajectory, rng: np.random.Generator) -> Trajectory:
    """Draw one take."""
    path, count = stroke.position, stroke.dimensions
    middle, size = path.mean(axis=0), float(np.ptp(path, axis=0).max())
    matrix = np.diag(np.exp(SIZE * rng.normal() + WIDTH * rng.normal(size=count)))
    matrix[0, -1] += LEAN * rng.normal() * (count > 1)
    drawn = middle + (path - middle) @ matrix.T + PLACE * size * rng.normal(size=count)
    for share, width in WOBBLES:
        drawn = drawn + share * size * _wobble(path.shape, width, rng)
    u = (stroke.t - stroke.t[0]) / stroke.duration
    waves = np.sin(np.pi * np.outer(u, [1, 2, 3])) / [1, 2, 3]
    clock = u + waves @ (HURRY * rng.normal(size=3))
    return Trajectory(stroke.duration * np.exp(PACE * rng.normal()) * clock, drawn)


def _wobble(shape: tuple[int, ...], width: float, rng: np.random.Generator) -> Array:
    """Return a smooth path of standard deviation 1 that forgets itself over a share of its way."""
    samples = width * shape[0]
    margin = int(4 * samples) + 1
    noise = rng.normal(size=(shape[0] + 2 * margin, shape[1]))
    smooth = scipy.ndimage.gaussian_filter1d(noise, samples, axis=0)[margin:-margin]
    return smooth * np.sqrt(2 * np.sqrt(np.pi) * samples)
