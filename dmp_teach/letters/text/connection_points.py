"""The points where a pen that does not lift leaves one letter and meets the next.

It leaves low on the right (a, n, e: from the hook on the writing line) or high (o, r, v, w). It
meets the next letter where that heads for it: on the up stroke of letters that begin with one, else
on the first stroke, which it follows backwards to its start, as over the bow of an a or up the stem
of an n.

Heights and lengths among the constants are in x-heights.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.trajectory import Array, Trajectory, all_points, arc_lengths, path_length

# A mark (a dot, a cross, an accent) is shorter than this share of the letter's longest stroke.
LONGEST_MARK = 0.6
# A pen that ends farther left than this share of its letter lifts, and one that ends this low.
LEFTMOST_END = 0.4
LOWEST_END = -0.25
# A stroke that ends above this leaves high.
HIGH_END = 0.6
# The end of a stroke, where the pen would come to rest, is cut off: this much, and more of a low
# end that rises above the hook.
END_CUT = 0.10
HOOK_HEIGHT = 0.20
LONGEST_END_CUT = 0.35
# A high end that rises steeper, as of v and w, is a peak: the pen rests there.
PEAK_HEADING = np.radians(50.0)

# Letters whose first heading is between these begin with an up stroke.
UP_STROKE_HEADINGS = np.radians((-35.0, 72.0))
# A letter whose first heading is steeper than this cannot be met: its stem begins at its foot.
STEM_FROM_FOOT = np.pi / 2 + 0.3
# On an up stroke a pen from below meets the part that has this heading; one from above meets a
# long one at this height.
RISING_HEADING = np.radians(15.0)
LONG_UP_STROKE_HEIGHT = 0.85
# A stroke whose first heading is this near to straight down is a stem; a short one begins below
# this height, and one that leans farther left, as that of a v, is met at its start.
STEM_DEVIATION = np.radians(57.0)
SHORT_STEM_HEIGHT = 1.2
LEFT_LEAN = np.radians(102.0)
# A pen from below meets a stem or a bow no higher than this; from above a bow no higher than that,
# so that the connection dips, and a long stem this much higher than it comes from.
HIGHEST_FROM_BELOW = 0.90
HIGHEST_FROM_ABOVE = 0.80
CLIMB_TO_STEM = 0.35

# No connection from below rises steeper, and none from above is shorter.
STEEPEST_CONNECTION = np.radians(56.0)
SHORTEST_RUN = 0.42

Samples = NDArray[np.intp]


def split_marks(
    character: str, strokes: Sequence[Trajectory]
) -> tuple[tuple[Trajectory, ...], tuple[Trajectory, ...]]:
    """Split a letter into the strokes that are connected and the marks that follow the word.

    A mark is short, or leads back to the left, as in an x. Capitals and digits have none.
    """
    if not character.islower():
        return tuple(strokes), ()
    lengths = [path_length(stroke.position) for stroke in strokes]
    is_long = [own >= LONGEST_MARK * max(lengths) for own in lengths]
    leads_back = [stroke.position[-1, 0] < stroke.position[0, 0] for stroke in strokes]
    main = is_long.index(True)
    is_body = [
        k == main or (k > main and is_long[k] and not leads_back[k]) for k in range(len(strokes))
    ]
    body = tuple(s for s, own in zip(strokes, is_body, strict=True) if own)
    return body, tuple(s for s, own in zip(strokes, is_body, strict=True) if not own)


def can_leave(character: str, body: Sequence[Trajectory], x_height: float) -> bool:
    """Return whether a small letter ends on its right, neither falling nor below the line."""
    path = all_points(body)
    left, right = path[:, 0].min(), path[:, 0].max()
    end, ahead = path[-1], path[-1] - path[-min(len(body[-1]), 12)]
    falls = ahead[1] < -abs(ahead[0]) or end[1] < LOWEST_END * x_height
    is_right = end[0] >= left + LEFTMOST_END * (right - left)
    return bool(character.islower() and is_right and not falls)


def can_arrive(character: str, body: Sequence[Trajectory], x_height: float) -> bool:
    """Return whether a pen may come to a letter: not to capitals, digits, or the foot of an ß."""
    if not character.islower():
        return False
    heading = _first_heading(body[0], x_height)
    return not UP_STROKE_HEADINGS[1] < heading < STEM_FROM_FOOT


@dataclass(frozen=True)
class Meeting:
    """A sample where a pen meets a stroke, going `back` to its start first, or resting there."""

    sample: int
    back: bool = False
    rests: bool = False


def leaving_sample(stroke: Trajectory, x_height: float) -> int:
    """Return where the pen leaves a stroke: before it comes to rest, and low on a hook."""
    path = stroke.position
    if ends_in_peak(path, x_height):
        return len(path) - 1
    left = _length_left(path)
    last = max(1, int((left >= END_CUT * x_height).sum()) - 1)
    while (
        path[last, 1] > HOOK_HEIGHT * x_height
        and path[-1, 1] < HIGH_END * x_height
        and left[last] < LONGEST_END_CUT * x_height
    ):
        last -= 1
    return int(np.clip(last, 1, len(path) - 2))


def find_meeting(here: Array, stroke: Trajectory, x_height: float) -> Meeting:
    """Find where a pen from `here` (2,) would pass along a stroke in the stroke's own heading."""
    low, high = UP_STROKE_HEADINGS
    if low < _first_heading(stroke, x_height) < high:
        return _on_up_stroke(here, stroke.position, x_height)
    return _on_the_way_back(here, stroke, x_height)


def _on_up_stroke(here: Array, path: Array, x_height: float) -> Meeting:
    """Return a point on the first, rising part; from above the first, or well up a long one."""
    heading, arc = np.unwrap(headings(path)), arc_lengths(path) / x_height
    near = max(1, int(np.searchsorted(arc, END_CUT)))
    steep = heading[near:] > UP_STROKE_HEADINGS[1] + 0.1
    ends = near + np.flatnonzero(steep | (arc[near:] > 1.0))
    some = np.arange(near, max(near + 1, int(ends[0])) if len(ends) else len(path) - 1)
    if here[1] > HIGH_END * x_height:
        higher = some[path[some, 1] > LONG_UP_STROKE_HEIGHT * x_height]
        return Meeting(int(higher[0]) if path[some[-1], 1] > x_height else near)
    rising = some[heading[some] > RISING_HEADING]
    return Meeting(_along(here, path, heading, rising) if len(rising) else near)


def _on_the_way_back(here: Array, stroke: Trajectory, x_height: float) -> Meeting:
    """Return a point from which the pen goes back to the start, or the start, with a rest."""
    path, first = stroke.position, _first_heading(stroke, x_height)
    high, short = here[1] > HIGH_END * x_height, path[0, 1] < SHORT_STEM_HEIGHT * x_height
    is_stem, leans = abs(first + np.pi / 2) < STEM_DEVIATION, first + np.pi > LEFT_LEAN
    if is_stem and (leans or (high and short)):
        return Meeting(0, rests=True)
    top = HIGHEST_FROM_BELOW * x_height
    if high:
        top = HIGHEST_FROM_ABOVE * x_height if short else here[1] + CLIMB_TO_STEM * x_height
    falls = np.flatnonzero((arc_lengths(path) > 0.05 * x_height) & (path[:, 1] < 0.4 * x_height))
    some = np.arange(1, max(2, int(falls[0])) if len(falls) else len(path) // 2)
    below = some[path[some, 1] <= top]
    return Meeting(_along(here, path, headings(-path), below if len(below) else some), back=True)


def missing_run(here: Array, there: Array, x_height: float) -> float:
    """Return how much farther right `there` (2,) must be for a good connection [m]; or less."""
    right, up = there - here
    if here[1] > HIGH_END * x_height:
        return float(SHORTEST_RUN * x_height - right)
    return float(up / np.tan(STEEPEST_CONNECTION) - right)


def ends_in_peak(path: Array, x_height: float) -> bool:
    """Return whether a stroke ends high, and upwards."""
    k = max(0, int((_length_left(path) >= 0.2 * x_height).sum()) - 1)
    right, up = path[-1] - path[k]
    rises = PEAK_HEADING < np.arctan2(up, right) < np.pi - PEAK_HEADING
    return bool(path[-1, 1] > HIGH_END * x_height and rises)


def headings(path: Array) -> Array:
    """Return the heading at every point of a path (T, 2), shape (T,) [rad]."""
    ahead = np.gradient(path, axis=0)
    return np.arctan2(ahead[:, 1], ahead[:, 0])


def _along(here: Array, path: Array, heading: NDArray[np.floating], some: Samples) -> int:
    """Return which sample a pen straight from `here` (2,) passes in the sample's own heading."""
    towards = path[some] - here
    along = np.column_stack([np.cos(heading[some]), np.sin(heading[some])])
    apart = np.maximum(np.linalg.norm(towards, axis=1), 1e-12)
    return int(some[np.argmax((towards * along).sum(axis=1) / apart)])


def _first_heading(stroke: Trajectory, x_height: float) -> float:
    """Return the heading of a stroke's first fifth of an x-height [rad]."""
    path = stroke.position
    k = int(np.clip(np.searchsorted(arc_lengths(path), 0.2 * x_height), 1, len(path) - 1))
    return float(np.arctan2(*(path[k] - path[0])[::-1]))


def _length_left(path: Array) -> Array:
    """Return the arc length from every point of a path to its end, shape (T,) [m]."""
    return arc_lengths(path[::-1])[::-1]
