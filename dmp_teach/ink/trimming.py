"""Strokes that stop too soon or go on too far: a piece at one end that only one of two writings has.

Without this a hook that was forgotten would make a letter narrow, and an e that was not closed a turned one.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from dmp_teach.ink.matching import Matching
from dmp_teach.trajectory import Array

PARTS = np.arange(1, 11) / 20  # of a stroke that are tried; of one that lacks more than half no end is missing
FINER = np.array([-1, -0.5, 0.5, 1]) / 40  # and then beside the best of them


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

    def beside(self) -> Iterator["Trim"]:
        """A little more, and a little less."""
        for step in FINER:
            yield Trim(self.pair, self.missing, self.first, float(self.part + step))


def trims(matching: Matching) -> Iterator[Trim]:
    """All that could be: at either end of every stroke that is one stroke on both sides, and not a loop on both."""
    for number, pair in enumerate(matching.pairs):
        if len(pair.strokes) == len(pair.others) == 1 and not pair.laid.loop:
            for missing in (True, False):
                for first in (True, False):
                    yield from (Trim(number, missing, first, float(part)) for part in PARTS)


def line_without(points: Array, trim: Trim) -> Array:
    """As many points evenly along a line (P, 2) without the piece at its end."""
    at = np.linspace(trim.part if trim.first else 0.0, 1.0 if trim.first else 1.0 - trim.part, len(points))
    own = np.linspace(0.0, 1.0, len(points))
    return np.column_stack([np.interp(at, own, axis) for axis in points.T])


def ink_without(count: int, trim: Trim, backwards: bool) -> slice:
    """Which of so many points along the ink are left; `backwards`: they run from the other end than the model's."""
    gone = min(round(trim.part * count), count - 2)
    return slice(gone, count) if trim.first != backwards else slice(0, count - gone)
