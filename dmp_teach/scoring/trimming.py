"""Strokes that stop too soon or go on too far: a piece at one end that only one of two writings has.

Without this a hook that was forgotten would make a letter narrow, and an e that was not closed a turned one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from dmp_teach.scoring.linear_map import centred, solved
from dmp_teach.scoring.matching import Matching
from dmp_teach.trajectory import Array

PLAIN = 0.0003  # of two fits that are as near, the one that changes the model less
PARTS = (
    np.arange(1, 11) / 20
)  # of a stroke that are tried; of one that lacks more than half no end is missing
FINER = np.array([-1, -0.5, 0.5, 1]) / 40  # and then beside the best of them
MOST = 4  # so many are looked at closely

Line = tuple[Array, Array]
"""The points of a pair, laid along each other: the writing's and the model's, each (P, 2)."""


@dataclass(frozen=True)
class Trim:
    """A piece that one side has and the other has not.

    Args:
        pair: The number of the pair of strokes.
        missing: Whether the writing lacks it; otherwise it is too much.
        first: Whether it is at the beginning of the stroke of the model; otherwise at its end.
        part: How much of the longer side's stroke it is, from 0 to 1.
    """

    pair: int
    missing: bool
    first: bool
    part: float

    def beside(self) -> Iterator[Trim]:
        """A little more, and a little less."""
        for step in FINER:
            yield Trim(self.pair, self.missing, self.first, float(self.part + step))


def likely(matching: Matching, lines: Sequence[Line], size: float) -> list[Trim]:
    """The few that leave the lines nearest, point by point, of all that could be.

    That could be at either end of every stroke that is one stroke on both sides, and not a loop on both.

    Args:
        matching: Which strokes belong together.
        lines: What is laid along each other, for every pair.
        size: Of the model [m].
    """
    both = np.array([[centred(each) for each in line] for line in lines])
    found: list[tuple[float, Trim]] = []
    for number, pair in enumerate(matching.pairs):
        if len(pair.strokes) == len(pair.others) == 1 and not pair.laid.loop:
            rest = np.delete(both, number, axis=0)
            for missing in (True, False):
                mine, yours = lines[number]
                shorter = _left(mine.shape[0]) @ (yours if missing else mine)
                sides = (mine, shorter) if missing else (shorter, yours)
                costs = _costs(rest, *(centred(side) for side in sides), size)
                found += [
                    (c, Trim(number, missing, *end))
                    for c, end in zip(costs.tolist(), _ends(), strict=True)
                ]
    return [trim for _, trim in sorted(found, key=lambda each: each[0])[:MOST]]


def _ends() -> list[tuple[bool, float]]:
    """At which end, and how much of the stroke."""
    return [(first, float(part)) for first in (True, False) for part in PARTS]


@cache
def _left(points: int) -> Array:
    """For each of `_ends` the matrix that makes a line of so many points of what is left, shape (E, P, P)."""
    return np.stack([_kept(np.eye(points), first, part) for first, part in _ends()])


def _kept(points: Array, first: bool, part: float) -> Array:
    """As many points evenly along what is left of points (P, D)."""
    at = np.linspace(part if first else 0.0, 1.0 if first else 1.0 - part, len(points))
    own = np.linspace(0.0, 1.0, len(points))
    return np.column_stack([np.interp(at, own, axis) for axis in points.T])


def _costs(rest: Array, mine: Array, yours: Array, size: float) -> Array:
    """How far the lines are apart, each pair in its place, and how much the model is changed, for each of `_ends`.

    Args:
        rest: The other pairs, both sides, shape (N - 1, 2, P, 2).
        mine: The writing's line, shape (P, 2) or (E, P, 2).
        yours: The model's, in the other of these shapes.
        size: Of the model [m].
    """
    mine, yours = np.broadcast_arrays(mine, yours)
    a, b = rest[:, 0].reshape(-1, 2), rest[:, 1].reshape(-1, 2)
    squares, model = (side**2 for side in (mine, yours))
    squares, model = squares.sum(axis=(1, 2)) + (a**2).sum(), model.sum(axis=(1, 2)) + (b**2).sum()
    scale = np.sqrt(squares / np.maximum(model, 1e-30))
    spread, together = (
        np.swapaxes(yours, 1, 2) @ yours + b.T @ b,
        np.swapaxes(mine, 1, 2) @ yours + a.T @ b,
    )
    linear = solved(spread + 1e-30 * np.eye(2), together, scale)
    off = (
        squares
        - 2 * (linear * together).sum(axis=(1, 2))
        + ((linear @ spread) * linear).sum(axis=(1, 2))
    )
    changed = ((linear / np.maximum(scale, 1e-30)[:, None, None] - np.eye(2)) ** 2).sum(axis=(1, 2))
    count = len(a) + mine.shape[1]
    parts = np.array([part for _, part in _ends()])
    return off / count / np.maximum(scale * size, 1e-30) ** 2 + PLAIN * (changed + parts**2)


def line_without(points: Array, trim: Trim) -> Array:
    """As many points evenly along a line (P, 2) without the piece at its end."""
    return _kept(points, trim.first, trim.part)


def ink_without(count: int, trim: Trim, backwards: bool) -> slice:
    """Which of so many points along the ink are left; `backwards`: they run from the other end than the model's."""
    gone = min(round(trim.part * count), count - 2)
    return slice(gone, count) if trim.first != backwards else slice(0, count - gone)
