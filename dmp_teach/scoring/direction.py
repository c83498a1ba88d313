"""Find a round part of a stroke that was written the other way round.

An 'a' whose bowl goes round with the clock leaves the same ink: only the way of the pen tells.
At each place it is asked in which direction the pens went. A place that is gone over up and down
by either pen tells nothing; where both went once, and against each other, the part is the other
way round.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.scoring.alignment import Alignment
from dmp_teach.scoring.linear_map import centre
from dmp_teach.scoring.resampling import DIRECTION_WEIGHT, rms_radius, squared_distances
from dmp_teach.trajectory import Array

# A smaller part of a stroke is no part of its own: loose writing turns back where it began.
LEAST_PART = 0.18
# Against the pen's way a point lies nearer to the other line than along it by this factor ...
LARGEST_SHARE_AGAINST = 0.5
# ... where along it none is near [squared radii].
LEAST_DISTANCE_ALONG = 0.15
# A part that turns by less is no round one [degrees].
LEAST_TURNING = 120.0


@dataclass(frozen=True)
class OtherWay:
    """A part of a stroke that was written the other way.

    Args:
        point: The middle of it on the other line, shape (2,) [m].
        turning: By how much the other line turns to the left there [degrees].
    """

    point: Array
    turning: float

    @property
    def is_round(self) -> bool:
        """Whether the part goes round."""
        return abs(self.turning) >= LEAST_TURNING


def find_other_way(alignment: Alignment) -> OtherWay | None:
    """Find the part of the one line that goes another way than the other line; None without."""
    mine, yours = (centre(line) / (rms_radius(centre(line)) or 1.0) for line in alignment.lines)
    along = squared_distances(_with_ways(mine, 1), _with_ways(yours, 1))
    against = squared_distances(_with_ways(mine, -1), _with_ways(yours, 1))
    turned_back = [
        _are_turned_back(along.min(axis=side), against.min(axis=side)) for side in (0, 1)
    ]
    both = turned_back[0] & turned_back[1][against.argmin(axis=0)]
    if both.mean() < LEAST_PART:
        return None
    x, y = _ways(yours).T
    turns = np.arctan2(x[:-1] * y[1:] - y[:-1] * x[1:], x[:-1] * x[1:] + y[:-1] * y[1:])
    turning = float(np.degrees(turns[both[:-1] & both[1:]].sum()))
    return OtherWay(alignment.others[both].mean(axis=0), turning)


def _are_turned_back(along: Array, against: Array) -> NDArray[np.bool_]:
    """Return of which points the other line is near only against their way."""
    return (against < LARGEST_SHARE_AGAINST * along) & (along > LEAST_DISTANCE_ALONG)


def _with_ways(line: Array, sign: int) -> Array:
    """Return points (P, 2) with the pen's way there, or the opposite, (P, 4)."""
    return np.concatenate([line, sign * DIRECTION_WEIGHT * _ways(line)], axis=1)


def _ways(line: Array) -> Array:
    """Return the pen's way at each point of a line as unit vectors (P, 2)."""
    ways = np.gradient(line, axis=0)
    return ways / np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-12)
