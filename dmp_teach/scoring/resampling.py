"""Resample strokes at equal arc length, whatever their tempo and sampling rate."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.trajectory import (
    Array,
    Trajectory,
    all_points,
    arc_lengths,
    interpolate_points,
    path_length,
)

# Points over all the ink of a letter, by their use: scores depend on these numbers.
POINTS_TO_MATCH = 64
POINTS_TO_FIT = 96
POINTS_TO_COMPARE = 48
# Points along each of two aligned lines, and along a stroke for its slant.
POINTS_TO_ALIGN = 32
POINTS_FOR_SLANT = 64

# A quarter turn in direction counts as much as twice this much in place [radii].
DIRECTION_WEIGHT = 0.3
FEWEST_POINTS_OF_STROKE = 3


@dataclass(frozen=True, eq=False)
class Resampled:
    """The ink of a letter as points at equal arc length.

    Args:
        points: Over all the ink, shape (P, 2) [m, or radii where normalized].
        directions: Of the ink there, as unit vectors whose sign means nothing, shape (P, 2).
        stroke: Which stroke each point belongs to, from 0, increasing, shape (P,).
        lengths: Arc length of each stroke, shape (S,) [as points].
    """

    points: Array
    directions: Array
    stroke: NDArray[np.int_]
    lengths: Array

    def features(self) -> Array:
        """Return `features` of the points and directions, shape (P, 4)."""
        return features(self.points, self.directions)

    def is_of(self, strokes: Sequence[int]) -> NDArray[np.bool_]:
        """Return which points belong to these strokes, shape (P,)."""
        chosen = np.zeros(len(self.lengths), dtype=bool)
        chosen[list(strokes)] = True
        return chosen[self.stroke]

    def only(self, kept: slice | NDArray[np.bool_]) -> Resampled:
        """Return some of the points; the lengths stay."""
        points, directions = self.points[kept], self.directions[kept]
        return Resampled(points, directions, self.stroke[kept], self.lengths)

    def normalized(self) -> Resampled:
        """Return the ink moved to its centroid and scaled to an rms radius of 1."""
        return self._normalized_by(self.points)

    def without(self, strokes: Sequence[int]) -> Resampled:
        """Return all points, normalized as if these strokes did not exist."""
        return self._normalized_by(self.points[~self.is_of(strokes)])

    def _normalized_by(self, some: Array) -> Resampled:
        """Return the ink with the centroid of some points at 0 and their rms radius 1."""
        centroid = some.mean(axis=0)
        radius = rms_radius(some - centroid)
        points = (self.points - centroid) / radius
        return Resampled(points, self.directions, self.stroke, self.lengths / radius)

    def transformed(self, matrix: Array) -> Resampled:
        """Return the ink mapped by a matrix (2, 2) and scaled to an rms radius of 1."""
        points, directions = self.points @ matrix.T, self.directions @ matrix.T
        directions /= np.maximum(np.sqrt((directions**2).sum(axis=1, keepdims=True)), 1e-12)
        return Resampled(points / rms_radius(points), directions, self.stroke, self.lengths)


def resample(strokes: Sequence[Trajectory], count: int) -> Resampled:
    """Resample strokes with `count` points, shared out by length and at least 3 for each stroke.

    A letter of very many strokes has more than `count` points.
    """
    lengths = np.array([path_length(stroke.position) for stroke in strokes])
    shares = np.round(count * lengths / lengths.sum()).astype(int)
    shares = np.maximum(FEWEST_POINTS_OF_STROKE, shares)
    longest = shares.max() + count - shares.sum()
    shares[np.argmax(shares)] = max(FEWEST_POINTS_OF_STROKE, longest)
    pieces = [resample_path(s.position, n) for s, n in zip(strokes, shares, strict=True)]
    points, directions = (np.concatenate(each) for each in zip(*pieces, strict=True))
    return Resampled(points, directions, np.repeat(np.arange(len(strokes)), shares), lengths)


def resample_path(path: Array, count: int) -> tuple[Array, Array]:
    """Return the middles of equal pieces of a path and its directions there, both (count, 2)."""
    way = arc_lengths(path)
    at = (np.arange(count) + 0.5) * way[-1] / count
    half = 0.5 * way[-1] / count
    wanted = np.concatenate([at, at - half, at + half])
    found = interpolate_points(wanted, way, path)
    step = found[2 * count :] - found[count : 2 * count]
    norm = np.linalg.norm(step, axis=1, keepdims=True)
    return found[:count], np.divide(step, norm, out=np.zeros_like(step), where=norm > 0)


def features(points: Array, directions: Array) -> Array:
    """Return points (..., 2) and directions (..., 2) as one feature vector each, (..., 4).

    A direction becomes a double angle, in which up and down are one.
    """
    x, y = directions[..., 0], directions[..., 1]
    angle = [DIRECTION_WEIGHT * (x * x - y * y), DIRECTION_WEIGHT * 2 * x * y]
    return np.concatenate([points, np.stack(angle, axis=-1)], axis=-1)


def squared_distances(a: Array, b: Array) -> Array:
    """Return squared distances of points (..., P, D) from points (Q, D), shape (..., P, Q)."""
    apart = dot(a, a)[..., None] + dot(b, b) - 2 * a @ b.T
    return np.maximum(apart, 0.0, out=apart)


def dot(a: Array, b: Array) -> Array:
    """Return the dot product of each vector of `a` (..., D) with that of `b`, shape (...)."""
    # Many times as fast as (a * b).sum(axis=-1), whose loop is over D.
    products: Array = np.einsum("...d,...d->...", a, b)
    return products


def size_of(strokes: Iterable[Trajectory]) -> float:
    """Return the larger side of the bounding box of strokes [m]."""
    return float(np.ptp(all_points(strokes), axis=0).max())


def rms_radius(centred: Array) -> float:
    """Return the root mean square distance of points (P, 2) from the origin."""
    return float(np.sqrt(np.einsum("pd,pd->", centred, centred) / len(centred)))
