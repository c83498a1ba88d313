"""How far apart two shapes are: letters whatever their strokes, and lines that were laid along each other."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from dmp_teach.scoring.resampling import features, ink_of, strokes_of
from dmp_teach.trajectory import Array

POINTS = 48  # of a letter
LEANS = np.linspace(
    -0.45, 0.45, 5
)  # of one letter against the other, as shears: up to 24 degrees to either side
BAND = 0.2  # how far, in parts of their length, two lines may be out of step


def warped(line: Array, other: Array) -> float:
    """Dynamic time warping: how far apart two lines are if each may wait for the other, in their unit.

    Root mean square distance of (P, 2) and (P, 2) along the cheapest way through all pairs of their points that goes
    on in both and leaves out none, at most a fifth of the line out of step (Sakoe and Chiba 1978), divided by P. Give
    it points at equal ways along, or at equal times to ask the tempo, too.
    """
    from dtaidistance import dtw, dtw_ndim  # noqa: PLC0415 (it takes a while to load)

    window = max(2, round(BAND * len(line)))
    a, b = np.ascontiguousarray(line), np.ascontiguousarray(other)
    # its C library is quick where it could be built; the Python beside it does the same sums
    sums = dtw_ndim.distance(a, b, window=window, use_c=dtw.dtw_cc is not None)
    return float(sums / np.sqrt(len(line)))


def procrustes(points: Array, others: Array) -> float:
    """Full Procrustes distance of points (P, 2) that belong together: 0 is the same shape, 1 the most, no unit.

    sqrt(1 - rho^2), where rho is the correlation of the centred points, scaled to size 1, in the turn that suits them
    best (Gower 1975; Kendall 1984). Place, size and turn do not count; a mirror image is another shape, other than in
    `scipy.spatial.procrustes`.
    """
    a, b = (each - each.mean(axis=0) for each in (points, others))
    # turns of the plane are complex numbers of length 1: the best one makes this sum real
    together = abs(np.vdot(a[:, 0] + 1j * a[:, 1], b[:, 0] + 1j * b[:, 1])) ** 2
    sizes = (a**2).sum() * (b**2).sum()
    return float(np.sqrt(max(0.0, 1 - together / sizes))) if sizes > 0 else 0.0


def letter_distance(letter: Any, other: Any, upright: bool = True) -> float:
    """How different two letters look, whatever their strokes: 0 is the same, two hands' a about 0.2, a and D 0.35.

    Both become 48 points evenly along their ink, with its direction as a third coordinate, moved to their middles and
    scaled to an rms radius of 1: root mean square distance of every point from the nearest of the other letter, both
    ways (modified Hausdorff distance, Dubuisson and Jain 1994, with squares). Size, place, tempo, sampling rate and
    the number, order and direction of strokes do not count.

    Args:
        letter: A `Recording`, a `Letter` or strokes.
        other: The same.
        upright: Whether a lean or small turn does not count either: the best of shears up to 24 degrees is taken.
            Whose hand it is shows in the lean, too: False there.

    Raises:
        LetterError: One is nothing, something else, or all in one place.
    """
    return float(letter_distances([letter], [other], upright)[0, 0])


def letter_distances(letters: Iterable[Any], others: Iterable[Any], upright: bool = True) -> Array:
    """`letter_distance` of every letter from every other, shape (L, M); a class of 30 in seconds.

    Args:
        letters: `Recording`s, `Letter`s or strokes, L of them.
        others: The same, M of them.
        upright: As in `letter_distance`.

    Raises:
        LetterError: One is nothing, something else, or all in one place.
    """
    leans = LEANS if upright else np.zeros(1)
    there = np.stack([_clouds(each, -leans / 2) for each in others], axis=1)
    squares = (there**2).sum(axis=3, keepdims=True)
    there = np.concatenate([-2 * there, squares, np.ones_like(squares)], axis=3)
    return np.array([_nearest(_clouds(each, leans / 2), there) for each in letters])


def _clouds(letter: Any, leans: Array) -> Array:
    """A letter as points in four dimensions, once for each lean, shape (len(leans), POINTS, 4)."""
    ink = ink_of(strokes_of(letter), POINTS)
    evenly = (
        np.linspace(0, len(ink.place) - 1, POINTS).round().astype(int)
    )  # all, but for letters of very many strokes
    sheared = np.stack([[[1.0, lean], [0.0, 1.0]] for lean in leans])
    place, along = (
        np.einsum("pd,led->lpe", each[evenly], sheared) for each in (ink.place, ink.along)
    )
    place /= np.sqrt((place**2).sum(axis=2).mean(axis=1))[:, None, None]
    along /= np.maximum(np.linalg.norm(along, axis=2, keepdims=True), 1e-12)
    return features(place, along).astype(np.float32)


def _nearest(clouds: Array, others: Array) -> Array:
    """The least distance of clouds (K, P, 4) from the others (K, M, P, 6), each with its own lean, shape (M,).

    The others bring their squares: one product of matrices gives |a|^2 + |b|^2 - 2 a b at once.
    """
    k, m, p, _ = others.shape
    squares = (clouds**2).sum(axis=2, keepdims=True)
    mine = np.concatenate([clouds, np.ones_like(squares), squares], axis=2)
    apart = (mine @ others.reshape(k, m * p, 6).swapaxes(1, 2)).reshape(k, p, m, p)
    near = apart.min(axis=3).mean(axis=1) + apart.min(axis=1).mean(axis=2)
    return np.sqrt(np.maximum(near.min(axis=0), 0) / 2).astype(float)
