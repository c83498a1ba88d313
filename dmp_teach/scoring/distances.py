"""Measure how different two letters look, whatever their strokes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.scoring.arguments import LetterLike, to_strokes
from dmp_teach.scoring.resampling import POINTS_TO_COMPARE, features, resample
from dmp_teach.trajectory import Array

# Of one letter against the other, as shears: up to 24 degrees to either side.
COMPARED_SHEARS = np.linspace(-0.45, 0.45, 5)


@checked
def letter_distance(letter: LetterLike, other: LetterLike, upright: bool = True) -> float:
    """Measure how different two letters look: 0 is the same, two hands' a about 0.2, a and D 0.35.

    Both become 48 points at equal arc length, with the direction of the ink as a third coordinate,
    moved to their centroids and scaled to an rms radius of 1: root mean square distance of every
    point from the nearest of the other letter, both ways (modified Hausdorff distance, Dubuisson
    and Jain 1994, with squares). Size, place, tempo, sampling rate and the number, order and
    direction of strokes do not count.

    Args:
        letter: A `Recording`, a `Letter` or strokes.
        other: The same.
        upright: Whether a lean or small turn does not count either: the best of shears up to
            24 degrees is taken. Whose hand it is shows in the lean, too: False there.

    Raises:
        LetterError: One is nothing, something else, or all in one place.
    """
    return float(letter_distances([letter], [other], upright)[0, 0])


def letter_distances(
    letters: Iterable[LetterLike], others: Iterable[LetterLike], upright: bool = True
) -> Array:
    """Compute `letter_distance` of every letter from every other, shape (L, M).

    A class of 30 takes seconds.

    Args:
        letters: `Recording`s, `Letter`s or strokes, L of them.
        others: The same, M of them.
        upright: As in `letter_distance`.

    Raises:
        LetterError: One is nothing, something else, or all in one place.
    """
    there = compared(others, upright)
    return np.array([distances_from(letter, there) for letter in letters])


@dataclass(frozen=True, eq=False)
class Compared:
    """Letters that others are compared with, prepared once.

    Args:
        shears: Of the others, which they share half and half with these, shape (K,).
        clouds: Features, their squares and ones, shape (K, M, 48, 6).
    """

    shears: Array
    clouds: Array


def compared(letters: Iterable[LetterLike], upright: bool = True) -> Compared:
    """Prepare letters to be compared with, for `distances_from`; raises as `letter_distance`."""
    shears = COMPARED_SHEARS if upright else np.zeros(1)
    there = np.stack([_sheared_features(each, -shears / 2) for each in letters], axis=1)
    squares = (there**2).sum(axis=3, keepdims=True)
    there = np.concatenate([-2 * there, squares, np.ones_like(squares)], axis=3)
    return Compared(shears, there)


def distances_from(letter: LetterLike, others: Compared) -> Array:
    """Compute `letter_distance` of a letter from each of the others, shape (M,)."""
    return _least_distances(_sheared_features(letter, others.shears / 2), others.clouds)


def _sheared_features(letter: LetterLike, shears: Array) -> Array:
    """Return the features of a letter under each shear, shape (len(shears), 48, 4)."""
    ink = resample(to_strokes(letter), POINTS_TO_COMPARE).normalized()
    # A letter of very many strokes has more points than asked for.
    kept = np.linspace(0, len(ink.points) - 1, POINTS_TO_COMPARE).round().astype(int)
    matrices = np.stack([[[1.0, shear], [0.0, 1.0]] for shear in shears])
    points, directions = (
        np.einsum("pd,led->lpe", each[kept], matrices) for each in (ink.points, ink.directions)
    )
    points /= np.sqrt((points**2).sum(axis=2).mean(axis=1))[:, None, None]
    directions /= np.maximum(np.linalg.norm(directions, axis=2, keepdims=True), 1e-12)
    return features(points, directions).astype(np.float32)


def _least_distances(clouds: Array, others: Array) -> Array:
    """Return the least distance of clouds (K, P, 4) from others (K, M, P, 6), shape (M,).

    The others bring their squares: one product of matrices gives |a|^2 + |b|^2 - 2 a b at once.
    """
    k, m, p, _ = others.shape
    squares = (clouds**2).sum(axis=2, keepdims=True)
    mine = np.concatenate([clouds, np.ones_like(squares), squares], axis=2)
    apart = (mine @ others.reshape(k, m * p, 6).swapaxes(1, 2)).reshape(k, p, m, p)
    near = apart.min(axis=3).mean(axis=1) + apart.min(axis=1).mean(axis=2)
    return np.sqrt(np.maximum(near.min(axis=0), 0) / 2).astype(float)
