"""Find where a marker leaps as no pen does: it flickers, or another one is taken for it.

The samples between two leaps are a piece. The pen's way is the row of pieces with the most samples
in which each goes on where the last one was going. Where one does not, that costs as much as a
quarter of a second of samples: so a marker that leaps for good is followed.
"""

from __future__ import annotations

import numpy as np
import scipy
from numpy.typing import NDArray

from dmp_teach.trajectory import Array, interpolate_points

Flags = NDArray[np.bool_]

LEAP = 0.003  # a step so far from where the pen was going is one ... [m]
PEN_ACCELERATION = 8.0  # ... beside what a pen can do in that time [m/s2] ...
PEN_SPEED = 1.0  # ... and a hand [m/s]
LEAP_COST = 0.25  # leaving out so much is as bad as one leap [s]
MOST_BREAKS = 3000  # of so much noise nothing is told apart
MOST_LEFT_OUT = 60  # pieces between two that go on


def straightened(t: Array, position: Array, least: float = 0.0) -> Array:
    """Return a pen's way (T, D) with straight lines where it leaps by more than `least` [m]."""
    on_way, size = find_leaps(t, position)
    kept = on_way | (size <= least)
    return position if kept.all() else interpolate_points(t, t[kept], position[kept])


def find_leaps(t: Array, position: Array) -> tuple[Flags, Array]:
    """Find the samples of a marker that are on the pen's way.

    Args:
        t: Times, strictly increasing, shape (T,) [s].
        position: Shape (T, D) [m].

    Returns:
        Whether a sample is on it (T,), and how far a leap there is, shape (T,) [m]: from the way to
        a sample beside it, or from one part of the way to the next.
    """
    on_way, size = np.ones(len(t), dtype=bool), np.zeros(len(t))
    if len(t) < 4:
        return on_way, size
    dt = np.diff(t)
    velocity = np.diff(position, axis=0) / dt[:, None]
    near = np.concatenate([velocity[1:2], velocity, velocity[-2:-1]])
    off = (np.linalg.norm(velocity - each, axis=1) * dt for each in (near[:-2], near[2:]))
    breaks = np.flatnonzero(np.minimum(*off) > _reach(dt)) + 1
    if 0 < len(breaks) < MOST_BREAKS:
        edges = np.concatenate([[0], breaks, [len(t)]])
        course = scipy.ndimage.median_filter(velocity, (9, 1), mode="nearest")
        on_way[:] = False
        for piece, leap in _longest_row(t, position, course, edges):
            on_way[edges[piece] : edges[piece + 1]] = True
            size[edges[piece]] = leap
        way = interpolate_points(t, t[on_way], position[on_way])
        size = np.maximum(size, np.linalg.norm(position - way, axis=1))
    return on_way, size


def _reach(seconds: Array) -> Array:
    """Return how far from its course a pen may be after so long [m]."""
    return LEAP + np.minimum(PEN_ACCELERATION * seconds**2, PEN_SPEED * seconds)


def _longest_row(
    t: Array, position: Array, course: Array, edges: np.ndarray
) -> list[tuple[int, float]]:
    """Return the pieces, between `edges`, that are the pen's way, and how far it leaps to each."""
    first, last = edges[:-1], edges[1:] - 1
    cost = LEAP_COST / float(np.median(np.diff(t)))
    score = (last - first + 1).astype(float)
    source, leap = np.full(len(first), -1), np.zeros(len(first))
    for j in range(1, len(first)):
        i = np.arange(max(0, j - 1 - MOST_LEFT_OUT), j)
        away = t[first[j]] - t[last[i]]
        pace = (course[np.maximum(last[i] - 1, 0)] + course[min(first[j], len(course) - 1)]) / 2
        off = np.linalg.norm(position[first[j]] - position[last[i]] - pace * away[:, None], axis=1)
        leaps = (off > _reach(away)) | (i == j - 1)
        total = score[i] - cost * leaps
        best = int(np.argmax(total))
        if total[best] > 0:
            score[j] += total[best]
            source[j], leap[j] = i[best], off[best] * leaps[best]
    row, k = [], int(np.argmax(score))
    while k >= 0:
        row.append((k, float(leap[k])))
        k = int(source[k])
    return row
