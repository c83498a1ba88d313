"""The pauses of a pen between strokes of different letters."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dmp_teach.letters.compose.piece import Piece
from dmp_teach.trajectory import Array

# Between strokes of different letters: a pause [s], and the speed in the air [m/s].
PAUSE_BETWEEN_STROKES = 0.36
SPEED_BETWEEN_STROKES = 1.0
LONGEST_PAUSE = 0.6
# Between parts of what was one stroke [s].
SHORTEST_PAUSE = 0.01


def pause_before(here: Array, there: Array) -> float:
    """Return how long the pen is in the air from `here` (2,) to `there` (2,) [s]."""
    flight = float(np.linalg.norm(there - here)) / SPEED_BETWEEN_STROKES
    return min(PAUSE_BETWEEN_STROKES + flight, LONGEST_PAUSE)


def begin_times(pieces: Sequence[Piece]) -> list[float]:
    """Return when each stroke of a composed letter begins [s]."""
    begins = [float(pieces[0].primitive.times[0])]
    for before, after in pairwise(pieces):
        pause = max(after.primitive.times[0] - before.primitive.times[-1], SHORTEST_PAUSE)
        if not after.follows(before):
            pause = pause_before(before.at("goal"), after.at("start"))
        begins.append(begins[-1] + before.primitive.duration + pause)
    return begins
