"""Find a piece at one end of a stroke that only one of two writings has.

Without this a hook that was forgotten would make a letter narrow, and an e that was not closed a
turned one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from dmp_teach.scoring.linear_map import centre, solve_linear_map
from dmp_teach.scoring.matching import Matching
from dmp_teach.trajectory import Array, interpolate_points

# Of two fits that are as near, the one that changes the model less is taken.
CHANGE_PENALTY = 0.0003
# Parts of a stroke that are tried; of one that lacks more than half no end is missing ...
TRIED_PARTS = np.arange(1, 11) / 20
# ... and then steps beside the best of them.
FINER_STEPS = np.array([-1, -0.5, 0.5, 1]) / 40
# The number of trims that are fitted in full.
MOST_FITTED_TRIMS = 4

Line = tuple[Array, Array]
"""The aligned points of a pair: the writing's and the model's, each (P, 2)."""


@dataclass(frozen=True)
class Trim:
    """A piece that one side has and the other has not.

    Args:
        pair: The number of the pair of strokes.
        missing: Whether the writing lacks it; otherwise it is too much.
        first: Whether it is at the beginning of the model's stroke; otherwise at its end.
        part: How much of the longer side's stroke it is, from 0 to 1.
    """

    pair: int
    missing: bool
    first: bool
    part: float

    def refine(self) -> Iterator[Trim]:
        """Yield trims of a little more, and a little less."""
        for step in FINER_STEPS:
            yield Trim(self.pair, self.missing, self.first, float(self.part + step))


def find_likely_trims(matching: Matching, lines: Sequence[Line], size: float) -> list[Trim]:
    """Find the few trims that leave the lines nearest, point by point.

    A trim may be at either end of every stroke that is one stroke on both sides, and not a loop.

    Args:
        matching: Which strokes belong together.
        lines: The aligned points of every pair.
        size: Of the model [m].
    """
    both = np.array([[centre(each) for each in line] for line in lines])
    found: list[tuple[float, Trim]] = []
    for number, pair in enumerate(matching.pairs):
        if len(pair.strokes) == len(pair.others) == 1 and not pair.alignment.loop:
            rest = np.delete(both, number, axis=0)
            mine, yours = lines[number]
            shorten = _shortenings(len(mine))
            for missing, one, other in (
                (True, mine, shorten @ yours),
                (False, shorten @ mine, yours),
            ):
                costs = _trim_costs(rest, centre(one), centre(other), size)
                found += [
                    (cost, Trim(number, missing, *end))
                    for cost, end in zip(costs.tolist(), _tried_ends(), strict=True)
                ]
    return [trim for _, trim in sorted(found, key=lambda each: each[0])[:MOST_FITTED_TRIMS]]


def _tried_ends() -> list[tuple[bool, float]]:
    """Return at which end, and how much of the stroke, is tried."""
    return [(first, float(part)) for first in (True, False) for part in TRIED_PARTS]


@cache
def _shortenings(points: int) -> Array:
    """Return the matrices that shorten and resample a line, for each end, (E, P, P)."""
    return np.stack([_shorten(np.eye(points), first, part) for first, part in _tried_ends()])


def _shorten(points: Array, first: bool, part: float) -> Array:
    """Return as many points evenly along points (P, D) without a part at an end."""
    at = np.linspace(part if first else 0.0, 1.0 if first else 1.0 - part, len(points))
    own = np.linspace(0.0, 1.0, len(points))
    return interpolate_points(at, own, points)


def _trim_costs(rest: Array, mine: Array, yours: Array, size: float) -> Array:
    """Return how far the lines are apart plus how much the model is changed, for each trim.

    Args:
        rest: The other pairs, both sides, shape (N - 1, 2, P, 2).
        mine: The writing's line, shape (P, 2) or (E, P, 2).
        yours: The model's, in the other of these shapes.
        size: Of the model [m].
    """
    mine, yours = np.broadcast_arrays(mine, yours)
    a, b = rest[:, 0].reshape(-1, 2), rest[:, 1].reshape(-1, 2)
    squares = (mine**2).sum(axis=(1, 2)) + (a**2).sum()
    model_squares = (yours**2).sum(axis=(1, 2)) + (b**2).sum()
    scale = np.sqrt(squares / np.maximum(model_squares, 1e-30))
    yours_yours = np.swapaxes(yours, 1, 2) @ yours + b.T @ b
    mine_yours = np.swapaxes(mine, 1, 2) @ yours + a.T @ b
    linear = solve_linear_map(yours_yours + 1e-30 * np.eye(2), mine_yours, scale)
    cross = (linear * mine_yours).sum(axis=(1, 2))
    off = squares - 2 * cross + ((linear @ yours_yours) * linear).sum(axis=(1, 2))
    relative = linear / np.maximum(scale, 1e-30)[:, None, None]
    changed = ((relative - np.eye(2)) ** 2).sum(axis=(1, 2))
    parts = np.array([part for _, part in _tried_ends()])
    mean = off / (len(a) + mine.shape[1]) / np.maximum(scale * size, 1e-30) ** 2
    return mean + CHANGE_PENALTY * (changed + parts**2)


def trim_line(points: Array, trim: Trim) -> Array:
    """Return as many points evenly along a line (P, 2) without the piece at its end."""
    return _shorten(points, trim.first, trim.part)


def kept_points(count: int, trim: Trim, backwards: bool) -> slice:
    """Return which of `count` points along the ink a trim leaves.

    Args:
        count: Of points along the ink.
        trim: What is left out.
        backwards: Whether the points run from the other end than the model's.
    """
    gone = min(round(trim.part * count), count - 2)
    return slice(gone, count) if trim.first != backwards else slice(0, count - gone)
