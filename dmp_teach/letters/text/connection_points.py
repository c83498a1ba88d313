"""Where a pen that does not lift leaves a letter, and where it meets the next.

It leaves low on the right (a, n, e: from the hook on the writing line) or high (o, r, v, w). It meets the next letter
where that heads for it: on the up stroke of letters that begin with one, else on the first stroke, which it follows
backwards to its start, as over the bow of an a or up the stem of an n.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.letters.compose.geometry import long
from dmp_teach.trajectory import Array, Trajectory, ways

INNER = 0.4  # a pen that ends farther left than this part of its letter lifts
MARK = 0.6  # a stroke shorter than this part of the longest is a dot, a cross or an accent
HIGH = 0.6  # a stroke that ends above this leaves high, in x-heights
LOW = -0.25  # a stroke that ends below this lifts
OFF = 0.10  # this much is taken off a stroke's end, where the pen would come to rest, in x-heights
HOOK = 0.20  # more is taken off a low end that rises above this ...
MOST_OFF = 0.35  # ... but not more than this
STEM = 0.90  # a pen from below meets a stem or a bow no higher than this
DIPPED = 0.80  # from above it meets a bow no higher than this, so that the connection dips
CLIMB = 0.35  # from above it meets a long stem this much higher than it comes from
UP_STROKE = np.radians(
    (-35.0, 72.0)
)  # letters whose first heading is between these begin with an up stroke
LONG_FROM = 0.85  # from above it meets a long up stroke at this height, in x-heights
UPRIGHT = np.radians(
    57.0
)  # a stroke whose first heading is no farther from straight down begins with a stem ...
SHORT = 1.2  # ... a short one below this height, in x-heights
RISING = np.radians(15.0)  # from this heading on, a pen from below may meet it
LEANING = np.radians(102.0)  # a stroke that leans farther left, as that of a v, is met at its start
STEEPEST = np.radians(56.0)  # no connection from below rises steeper than this
RUN = 0.42  # a connection from above is no shorter than this, in x-heights
PEAK = np.radians(
    50.0
)  # a high end that rises steeper, as of v and w, is a peak: the pen rests there


def body_and_marks(
    character: str, strokes: Sequence[Trajectory]
) -> tuple[tuple[Trajectory, ...], tuple[Trajectory, ...]]:
    """The strokes that a word is joined by, and those that come after it: dots, crosses, accents of small letters.

    A mark is short, or leads back to the left as the second stroke of an x does. Capitals and digits have none.
    """
    if not character.islower():
        return tuple(strokes), ()
    longest = max(long(stroke.position) for stroke in strokes)

    def is_mark(stroke: Trajectory) -> bool:
        back = stroke.position[-1, 0] < stroke.position[0, 0]
        return bool(back or long(stroke.position) < MARK * longest)

    main = next(k for k, stroke in enumerate(strokes) if long(stroke.position) >= MARK * longest)
    body = tuple(s for k, s in enumerate(strokes) if k == main or (k > main and not is_mark(s)))
    return body, tuple(s for s in strokes if s not in body)


def can_leave(character: str, body: Sequence[Trajectory], x_height: float) -> bool:
    """Whether the pen may go on without lifting: from a small letter that ends on its right, neither down nor below."""
    path = np.concatenate([stroke.position for stroke in body])
    left, right = path[:, 0].min(), path[:, 0].max()
    end, ahead = path[-1], path[-1] - path[-min(len(body[-1]), 12)]
    falls = ahead[1] < -abs(ahead[0]) or end[1] < LOW * x_height
    return bool(character.islower() and end[0] >= left + INNER * (right - left) and not falls)


def can_arrive(character: str, body: Sequence[Trajectory], x_height: float) -> bool:
    """Whether the pen may come to a letter without lifting: not to capitals, digits, or the foot of a stem, as of ß."""
    if not character.islower():
        return False
    heading = _first_heading(body[0], x_height)
    return not UP_STROKE[1] < heading < np.pi / 2 + 0.3


@dataclass(frozen=True)
class Meeting:
    """Where a pen meets the next stroke.

    Args:
        sample: Of that stroke.
        back: Whether the pen follows the stroke backwards to its start first.
        rests: Whether it comes to rest there.
    """

    sample: int
    back: bool = False
    rests: bool = False


def leaving(stroke: Trajectory, x_height: float) -> int:
    """The sample at which the pen leaves a stroke: before it comes to rest, and low on a hook."""
    path = stroke.position
    if peaks(path, x_height):
        return len(path) - 1
    left = _left(path)
    last = max(1, int((left >= OFF * x_height).sum()) - 1)
    while (
        path[last, 1] > HOOK * x_height
        and path[-1, 1] < HIGH * x_height
        and left[last] < MOST_OFF * x_height
    ):
        last -= 1
    return int(np.clip(last, 1, len(path) - 2))


def meeting(here: Array, stroke: Trajectory, x_height: float) -> Meeting:
    """Where a pen that comes from `here` (2,) meets a stroke: where it would pass by in the direction of the stroke."""
    if UP_STROKE[0] < _first_heading(stroke, x_height) < UP_STROKE[1]:
        return _on_up_stroke(here, stroke.position, x_height)
    return _on_the_way_back(here, stroke, x_height)


def _on_up_stroke(here: Array, path: Array, x_height: float) -> Meeting:
    """On the first, rising part of a stroke (T, 2); from above, as soon as can be, or well up a long one."""
    heading, way = np.unwrap(headings(path)), ways(path) / x_height
    near = max(1, int(np.searchsorted(way, OFF)))
    ends = near + np.flatnonzero((heading[near:] > UP_STROKE[1] + 0.1) | (way[near:] > 1.0))
    some = np.arange(near, max(near + 1, int(ends[0])) if len(ends) else len(path) - 1)
    if here[1] > HIGH * x_height:
        higher = some[path[some, 1] > LONG_FROM * x_height]
        return Meeting(int(higher[0]) if path[some[-1], 1] > x_height else near)
    rising = some[heading[some] > RISING]
    return Meeting(_along(here, path, heading, rising) if len(rising) else near)


def _on_the_way_back(here: Array, stroke: Trajectory, x_height: float) -> Meeting:
    """Somewhere after the start of a stroke, to which the pen then has to go back; or at its start, with a rest."""
    path, first = stroke.position, _first_heading(stroke, x_height)
    high, short = here[1] > HIGH * x_height, path[0, 1] < SHORT * x_height
    if abs(first + np.pi / 2) < UPRIGHT and (first + np.pi > LEANING or (high and short)):
        return Meeting(0, rests=True)
    top = (
        STEM * x_height if not high else DIPPED * x_height if short else here[1] + CLIMB * x_height
    )
    falls = np.flatnonzero((ways(path) > 0.05 * x_height) & (path[:, 1] < 0.4 * x_height))
    some = np.arange(1, max(2, int(falls[0])) if len(falls) else len(path) // 2)
    below = some[path[some, 1] <= top]
    return Meeting(_along(here, path, headings(-path), below if len(below) else some), back=True)


def needed(here: Array, there: Array, x_height: float) -> float:
    """How much farther right `there` (2,) has to be for a good connection from `here` (2,) [m]; may be negative."""
    right, up = there - here
    if here[1] > HIGH * x_height:
        return float(RUN * x_height - right)
    return float(up / np.tan(STEEPEST) - right)


def peaks(path: Array, x_height: float) -> bool:
    """Whether a stroke ends high, and upwards."""
    k = max(0, int((_left(path) >= 0.2 * x_height).sum()) - 1)
    right, up = path[-1] - path[k]
    return bool(path[-1, 1] > HIGH * x_height and PEAK < np.arctan2(up, right) < np.pi - PEAK)


def headings(path: Array) -> Array:
    """The heading at every point of a path (T, 2), shape (T,) [rad]."""
    ahead = np.gradient(path, axis=0)
    return np.arctan2(ahead[:, 1], ahead[:, 0])


def _along(here: Array, path: Array, heading: Array, some: Array) -> int:
    """Which of some samples is passed in its own heading by a pen that comes straight from `here` (2,)."""
    towards = path[some] - here
    along = np.column_stack([np.cos(heading[some]), np.sin(heading[some])])
    return int(
        some[
            np.argmax(
                (towards * along).sum(axis=1) / np.maximum(np.linalg.norm(towards, axis=1), 1e-12)
            )
        ]
    )


def _first_heading(stroke: Trajectory, x_height: float) -> float:
    """The heading of a stroke's first fifth of an x-height [rad]."""
    path = stroke.position
    k = int(np.clip(np.searchsorted(ways(path), 0.2 * x_height), 1, len(path) - 1))
    return float(np.arctan2(*(path[k] - path[0])[::-1]))


def _left(path: Array) -> Array:
    return ways(path[::-1])[::-1]
