"""Smooth what the arm is asked for: the pen's path stays, its acceleration no longer steps.

Touching box kernels make the acceleration of a learned stroke step at each of their edges. The
stroke drawn instead is the smoothest on the same path: least squared fourth differences (Whittaker
1923), a little sooner or later at each place. Where the path forces a step, the pen takes longer;
what that leaves, the whole stroke does.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import scipy

from dmp_teach.robot.pen_path import (
    MOTION_RATE,
    PenPath,
    connect_strokes,
    ease_in_and_out,
    interpolate,
)
from dmp_teach.trajectory import Array, Trajectory

LARGEST_STEP = 0.18
"""The pen's acceleration may change so much from sample to sample, less than in a lift [m/s^2]."""

PATH_TOLERANCE = 2e-5
"""No smoothed stroke leaves its path by more [m]."""

# At the samples; between two of them the stroke may be a little farther off [m].
_AIM = 0.92 * PATH_TOLERANCE
# Half of a wave so long passes: of ripple, where nothing else holds the path, and of a hand's [s].
_RIPPLE = 0.08
_HAND = 0.12
# The part of the hand's largest step that is allowed, where that is more than LARGEST_STEP.
_SHARE = 0.62
# With kernels that touch, the median of the steps is a tenth of the larger ones; a hand's is a
# quarter or more.
_SPARSE = 0.22
# So many `PATH_TOLERANCE`s may a place go along the path, where the pen is faster than this [m/s].
_ALONG = 10.0
_FAST = 0.01
# Solutions for each clock, and clocks, at most.
_SOLVES = 30
_ROUNDS = 12
# How much longer a place may take in one round, at most.
_SLOWER = 1.5
# In fewer samples nothing is smoothed.
_FEWEST = 10


def measure_steps(path: Array) -> Array:
    """Return how the acceleration along a path (T, D) [m] changes each sample, (T - 3,) [m/s^2]."""
    return np.linalg.norm(np.diff(path, n=3, axis=0), axis=1) * MOTION_RATE**2


def connect_smoothly(strokes: tuple[Trajectory, ...]) -> PenPath:
    """Return the pen's path over strokes that lie on the page, each of them smoothed [m]."""
    return connect_strokes(tuple(smooth_stroke(stroke) for stroke in strokes))


def smooth_stroke(stroke: Trajectory) -> Trajectory:
    """Return a stroke (T, 2) on the same path whose acceleration changes by at most `LARGEST_STEP`.

    By more, where a hand's does on that path. One that is so smooth is returned as it is, and where
    the acceleration changes all the time, not step by step, it is a hand's: the pen is not slowed.
    """
    curve, n = interpolate(stroke), int(np.ceil(stroke.duration * MOTION_RATE))
    times = np.linspace(stroke.t[0], stroke.t[-1], n + 1)
    path = curve(times)
    if n < _FEWEST:
        return stroke
    steps = measure_steps(path)
    rough = steps.max()
    if rough <= LARGEST_STEP:
        return stroke
    hand = _solve(path, np.tile(np.eye(2), (n + 1, 1, 1)), _HAND)
    limit = max(LARGEST_STEP, _SHARE * _measure_drawn(hand).max())
    stepwise = np.median(steps) < _SPARSE * np.percentile(steps, 95)
    best, least = path, np.inf
    for _ in range(_ROUNDS if stepwise else 1):
        path = _smooth(curve, times)
        # Where all takes longer, steps fall with its third power.
        longer = np.cbrt(_measure_drawn(path) / limit)
        needed = (len(path) - 1) * max(1, longer.max())
        if needed < least:
            best, least = path, needed
        times = _slow_down(times, longer)
        if len(times) > least:
            break
    if measure_steps(best).max() >= rough:
        return stroke
    samples = least if stepwise else len(best) - 1
    return Trajectory(stroke.t[0] + np.linspace(0, samples / MOTION_RATE, len(best)), best)


def _measure_drawn(path: Array) -> Array:
    """Return the steps at each sample (T,) of a path (T, 2) that is drawn from rest to rest."""
    last = len(path) - 1
    lasts, clock = ease_in_and_out(last / MOTION_RATE)
    shown = clock(np.arange(int(np.ceil(lasts * MOTION_RATE)) + 1) / MOTION_RATE) * MOTION_RATE
    shown = np.clip(shown, 0, last)
    steps = np.zeros(last + 1)
    drawn = scipy.interpolate.CubicSpline(np.arange(last + 1), path)(shown)
    np.maximum.at(steps, shown[1:-2].round().astype(int), measure_steps(drawn))
    return steps


def _slow_down(times: Array, longer: Array) -> Array:
    """Return times (T',) in which every place takes so much `longer` (T,), and those about it."""
    longer = scipy.ndimage.maximum_filter1d(np.clip(longer, 1, _SLOWER), 25)
    longer = scipy.ndimage.uniform_filter1d(longer, 17)
    clock = np.append(0, np.cumsum((longer[1:] + longer[:-1]) / 2))
    return np.interp(np.linspace(0, clock[-1], int(np.ceil(clock[-1])) + 1), clock, times)


def _smooth(curve: Callable[[Array], Array], times: Array) -> Array:
    """Return the smoothest path (T, 2) within `PATH_TOLERANCE` of a curve, about on its clock."""
    path = curve(times)
    v = np.gradient(path, axis=0) * MOTION_RATE
    forward = v / ((v**2).sum(axis=1) + _FAST**2)[:, None]
    weights = np.eye(2) - (1 - _ALONG**-2) * v[:, :, None] * forward[:, None, :]
    weights[[0, -1]] *= 1e6
    for _ in range(_SOLVES):
        smooth = _solve(path, weights, _RIPPLE)
        later = times + ((smooth - path) * forward).sum(axis=1)
        miss = np.linalg.norm(smooth - curve(np.clip(later, times[0], times[-1])), axis=1)
        if miss.max() <= _AIM:
            break
        weights *= (np.maximum(miss / (0.9 * _AIM), 1) ** 1.5)[:, None, None]
    smooth = path + (smooth - path) * min(1, _AIM / max(miss.max(), _AIM))
    smooth[[0, -1]] = path[[0, -1]]
    return smooth


def _solve(path: Array, weights: Array, period: float) -> Array:
    """Return the path (T, 2) of least squared fourth differences and weighted distance (T, 2, 2).

    The matrix has x and y of a sample side by side, and its upper diagonals are the rows of
    `banded`: those of the fourth differences, D'D, are every other one.
    """
    n, order = len(path), 4
    differences = np.array([1.0, -4.0, 6.0, -4.0, 1.0])
    banded = np.zeros((2 * order + 1, n, 2))
    for first, one in enumerate(differences):
        for second, other in enumerate(differences[first:], start=first):
            banded[2 * (order - second + first), second : n - order + second] += one * other
    banded *= (period * MOTION_RATE / (2 * np.pi)) ** (2 * order)
    banded[-1] += np.einsum("nii->ni", weights)
    banded[-2, :, 1] += weights[:, 0, 1]
    aim = np.einsum("nij,nj->ni", weights, path).ravel()
    return scipy.linalg.solveh_banded(banded.reshape(-1, 2 * n), aim).reshape(n, 2)
