"""Lay one ink on another where they are nearest, and measure how far apart they are.

The middle of the ink is no place to lay it by: a line that is gone over twice pulls it. Here a
point belongs to the nearest place of the other ink, and the shift is what leaves both the nearest.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from dmp_teach.scoring.resampling import Resampled, dot, squared_distances
from dmp_teach.trajectory import Array

MOST_SHIFTS = 40
# A shift that is smaller ends the search [parts of the larger side of the other ink].
SMALLEST_SHIFT = 3e-4


def lay_on(ink: Resampled, other: Resampled) -> Array:
    """Return the shift (2,) that brings an ink nearest to another, by least squares, both ways.

    Nearest places are found again after each shift (Besl and McKay 1992), from where the boxes of
    the inks and where their middles lie on each other; the better end is taken.
    """
    box = other.points.max(axis=0) + other.points.min(axis=0)
    box -= ink.points.max(axis=0) + ink.points.min(axis=0)
    middle = other.points.mean(axis=0) - ink.points.mean(axis=0)
    found = [_follow_nearest(ink, other, start) for start in (box / 2, middle)]
    return min(found, key=lambda shift: rms_apart(replace(ink, points=ink.points + shift), other))


def rms_apart(ink: Resampled, other: Resampled) -> float:
    """Return how far two inks are from the nearest of each other (rms, both ways) [as points]."""
    squares = [dot(away, away).mean() for away in ways_to_nearest(ink, other)]
    return float(np.sqrt(np.mean(squares)))


def ways_to_nearest(ink: Resampled, other: Resampled) -> tuple[Array, Array]:
    """Return what leads every point to the nearest place of the other ink, and the reverse."""
    apart = squared_distances(ink.points, other.points)
    return _to_line(ink.points, other, apart.argmin(axis=1)), _to_line(
        other.points, ink, apart.argmin(axis=0)
    )


def _to_line(points: Array, ink: Resampled, vertex: NDArray[np.intp]) -> Array:
    """Return what leads points (P, 2) to the nearest place of ink beside its vertices (P,)."""
    pieces = np.minimum(np.maximum(vertex + np.array([[-1], [0]]), 0), len(ink.points) - 2)
    begin, along = ink.points[pieces], ink.points[pieces + 1] - ink.points[pieces]
    # Between two strokes there is no ink, only their ends.
    gap = ink.stroke[pieces] != ink.stroke[pieces + 1]
    begin = np.where(gap[..., None], ink.points[vertex], begin)
    along = np.where(gap[..., None], 0.0, along)
    at = dot(points - begin, along) / np.maximum(dot(along, along), 1e-30)
    away = begin + np.minimum(np.maximum(at, 0), 1)[..., None] * along - points
    nearer = dot(away, away).argmin(axis=0)
    return away[nearer, np.arange(len(points))]


def _follow_nearest(ink: Resampled, other: Resampled, shift: Array) -> Array:
    """Return the shift at which the nearest places are those that it was found from."""
    least = SMALLEST_SHIFT * float(np.ptp(other.points, axis=0).max())
    for _ in range(MOST_SHIFTS):
        there, back = ways_to_nearest(replace(ink, points=ink.points + shift), other)
        step = (there.mean(axis=0) - back.mean(axis=0)) / 2
        shift = shift + step
        if np.hypot(*step) < least:
            break
    return shift
