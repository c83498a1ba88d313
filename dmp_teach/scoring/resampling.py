"""Ink as points at equal ways along it, which know nothing of tempo, sampling rate or number of samples."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.errors import LetterError, kind_of
from dmp_teach.trajectory import Array, Trajectory, length, ways

DIRECTION = (
    0.3  # a quarter of a turn in direction counts as much as twice this much in place [radii]
)
FEWEST = 3  # points of even the shortest stroke


@dataclass(frozen=True)
class Ink:
    """A letter as points, moved to its middle and scaled to an rms radius of 1.

    Args:
        place: Points evenly spaced over all the ink, shape (P, 2) [radii].
        along: The direction of the ink there, as a unit vector; its sign means nothing, shape (P, 2).
        stroke: Which stroke each point belongs to, from 0, increasing, shape (P,).
        lengths: How long each stroke is, shape (S,) [radii].
    """

    place: Array
    along: Array
    stroke: np.ndarray
    lengths: Array

    def features(self) -> Array:
        """Place, and direction as a double angle, in which up and down are one; shape (P, 4)."""
        return features(self.place, self.along)

    def of(self, strokes: Sequence[int]) -> np.ndarray:
        """Which points belong to these strokes, shape (P,) of bool."""
        asked = np.zeros(len(self.lengths), dtype=bool)
        asked[list(strokes)] = True
        return asked[self.stroke]

    def without(self, strokes: Sequence[int]) -> Ink:
        """The same points, moved and scaled as if these strokes were not there."""
        kept = self.place[~self.of(strokes)]
        middle = kept.mean(axis=0)
        radius = rms_radius(kept - middle)
        return Ink((self.place - middle) / radius, self.along, self.stroke, self.lengths / radius)

    def turned(self, by: Array) -> Ink:
        """Turned, mirrored or leaned by a matrix, shape (2, 2), and scaled to an rms radius of 1 again."""
        place, along = self.place @ by.T, self.along @ by.T
        along /= np.maximum(np.sqrt((along**2).sum(axis=1, keepdims=True)), 1e-12)
        return Ink(place / rms_radius(place), along, self.stroke, self.lengths)


def ink_of(strokes: Sequence[Trajectory], points: int) -> Ink:
    """Strokes as so many points; each stroke has points by its length, and a few even if it is a dot.

    A letter of so many strokes that this takes more points than asked for has more points.
    """
    place, along, number, lengths = spread(strokes, points)
    centred = place - place.mean(axis=0)
    radius = rms_radius(centred)
    return Ink(centred / radius, along, number, lengths / radius)


def spread(strokes: Sequence[Trajectory], points: int) -> tuple[Array, Array, np.ndarray, Array]:
    """Points evenly over all ink (P, 2) [m], its direction (P, 2), stroke (P,), and the strokes' lengths (S,) [m]."""
    lengths = np.array([length(stroke.position) for stroke in strokes])
    shares = np.maximum(FEWEST, np.round(points * lengths / lengths.sum()).astype(int))
    shares[np.argmax(shares)] = max(FEWEST, shares.max() + points - shares.sum())
    place, along = zip(
        *(evenly(stroke.position, n) for stroke, n in zip(strokes, shares, strict=True)),
        strict=True,
    )
    return (
        np.concatenate(place),
        np.concatenate(along),
        np.repeat(np.arange(len(strokes)), shares),
        lengths,
    )


def evenly(path: Array, points: int) -> tuple[Array, Array]:
    """So many points in the middles of equal pieces of a path, and the direction of each, both of shape (points, 2)."""
    way = ways(path)
    at = (np.arange(points) + 0.5) * way[-1] / points
    half = 0.5 * way[-1] / points
    asked = np.concatenate([at, at - half, at + half])
    found = np.column_stack([np.interp(asked, way, axis) for axis in path.T])
    step = found[2 * points :] - found[points : 2 * points]
    long = np.linalg.norm(step, axis=1, keepdims=True)
    return found[:points], np.divide(step, long, out=np.zeros_like(step), where=long > 0)


def features(place: Array, along: Array) -> Array:
    """Points (..., 2) and their directions (..., 2) as points in four dimensions, (..., 4)."""
    x, y = along[..., 0], along[..., 1]
    return np.concatenate(
        [place, np.stack([DIRECTION * (x * x - y * y), DIRECTION * 2 * x * y], axis=-1)], axis=-1
    )


def size_of(strokes: Iterable[Trajectory]) -> float:
    """The larger side of the box around strokes [m]."""
    return float(np.ptp(np.concatenate([stroke.position for stroke in strokes]), axis=0).max())


def rms_radius(centred: Array) -> float:
    """Root mean square distance from the origin of points (P, 2)."""
    return float(np.sqrt(np.einsum("pd,pd->", centred, centred) / len(centred)))


def listed(letter: Any) -> tuple[Any, ...]:
    """The strokes of a recording, or of what a learned letter writes, or what was given, as a tuple, unchecked."""
    if isinstance(letter, Trajectory):
        return (letter,)
    if callable(getattr(letter, "write", None)):
        return tuple(letter.write())
    given = letter.strokes() if callable(getattr(letter, "strokes", None)) else letter
    return tuple(given) if isinstance(given, Iterable) else (given,)


def strokes_of(letter: Any, name: str = "letter") -> tuple[Trajectory, ...]:
    """The strokes of a recording, of what a learned letter writes, or of strokes, in the order of writing.

    Raises:
        LetterError: Something else, nothing, strokes that are not flat, or a letter that is all in one place.
    """
    strokes = listed(letter)
    wrong = [each for each in strokes if not isinstance(each, Trajectory)]
    if wrong or not strokes:
        what = kind_of(wrong[0]) if wrong else "nothing"
        raise LetterError(
            f"{name} must be a Recording, a Letter or its strokes (Trajectory), but is {what}."
        )
    for k, stroke in enumerate(strokes):
        if stroke.dimensions != 2:
            raise LetterError(
                f"Stroke {k} of {name} has {stroke.dimensions} dimensions, but ink has 2, right and up; "
                "leave out the height, or give the recording."
            )
    if not max(length(stroke.position) for stroke in strokes) > 0:
        raise LetterError(
            f"{name} is a dot: the pen never moves. A letter has at least one stroke with a length."
        )
    return strokes
