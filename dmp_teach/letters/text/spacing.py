"""How far apart letters and words stand: by the white between them, not by their boxes, so that text looks even.

The white between two letters is their horizontal distance at each height, counted to a limit, because the eye does not
look deep into the openings of a c or under the arm of a T. Its mean is the same for all pairs, and ink keeps a distance
from ink at every height.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.ndimage import maximum_filter1d

from dmp_teach.letters.compose.geometry import evenly, long
from dmp_teach.letters.text.connection_points import leaving, meeting, needed
from dmp_teach.trajectory import Array, Trajectory

Strokes = tuple[Trajectory, ...]

WHITE = 0.33  # the mean distance of two letters, in x-heights
DEEP = 0.50  # white counts to this depth
CLEAR = 0.12  # ink is never nearer to ink than this
LINKED = 0.28  # the mean distance of two letters that are joined, without the way between them
SIGN = 0.24  # what stands at the height of a sign (a full stop, a hyphen) keeps this distance from it, in x-heights
PAST = 0.12  # a sign that nothing stands beside, as an apostrophe after an o, is so far past the letter
BESIDE = 0.15  # a letter that is seen so far up and down is beside a sign ...
AROUND = 0.30  # ... and then keeps that distance as far up and down as this
SPACE = 0.5  # what two words stand farther apart than two letters, in x-heights ...
APART = 0.6  # ... and at least this much white is between them, along the lean of the hand and straight across ...
ACROSS = 0.5  # ... as far up and down as an eye looks that goes from the one to the other
BANDS = 25  # in an x-height
LOWEST, HIGHEST = -2.0, 4.0  # in x-heights, from the writing line


def distance(
    left: Sequence[Trajectory], right: Sequence[Trajectory], x_height: float, white: float = WHITE
) -> float:
    """How far the strokes `right` are moved to the right of where they are, to follow `left`; may be negative [m].

    Args:
        left: A letter on the writing line y = 0.
        right: The next one, on the same line.
        x_height: The height of a small letter without a stem [m].
        white: The mean distance that they get, in x-heights.
    """
    right_edge, left_edge = _edge(left, x_height, 1), _edge(right, x_height, -1)
    apart = -left_edge - right_edge
    top = max(1.0, min(_top(left, x_height), _top(right, x_height)))
    zone = slice(round(-LOWEST * BANDS), round((min(top, HIGHEST) - LOWEST) * BANDS))
    overlap = _overlap(right_edge, left_edge, CLEAR)
    if not np.isfinite(overlap):  # the one ends under the other
        overlap = float(right_edge.max() + left_edge.max())
    return x_height * max(CLEAR + overlap, _moved_to_white(apart[zone], white, DEEP))


def linked_distance(glyphs: Sequence[Strokes], bodies: Sequence[Strokes], x_height: float) -> float:
    """The same for two letters that are joined: by their white, and so that the way between them is not too steep.

    Args:
        glyphs: The two letters, with dots, crosses and accents.
        bodies: The strokes of each that are joined: the last of the one to the first of the other.
        x_height: As in `distance`.
    """
    end, start = bodies[0][-1], bodies[1][0]
    a = leaving(end, x_height)
    here = end.position[a]
    left = [_part(end, slice(a + 1)) if stroke is end else stroke for stroke in glyphs[0]]
    right, step = glyphs[1], 0.0
    for _ in range(3):
        step = distance(left, right, x_height, LINKED)
        met = meeting(here - (step, 0.0), start, x_height)
        step += max(0.0, needed(here - (step, 0.0), start.position[met.sample], x_height))
        met = meeting(here - (step, 0.0), start, x_height)
        cut = slice(0 if met.back else met.sample, None)
        right = [_part(start, cut) if stroke is start else stroke for stroke in glyphs[1]]
    return step


def word_distance(
    left: Sequence[Trajectory], right: Sequence[Trajectory], x_height: float, lean: float
) -> float:
    """The same for two words: a space more than their letters, and white that no overhanging letter fills.

    Args:
        left: A word on the writing line y = 0.
        right: The next one.
        x_height: As in `distance`.
        lean: Of the hand, x gained for each y: words of a hand that leans are parted by white that leans.
    """
    across = x_height * _overlap(_edge(left, x_height, 1), _edge(right, x_height, -1), ACROSS)
    white = APART * x_height + max(across, _reach(left, right, lean))
    return max(distance(left, right, x_height) + SPACE * x_height, white)


def distance_to_sign(
    left: Sequence[Trajectory], right: Sequence[Trajectory], x_height: float, lean: float
) -> float:
    """The same where one of them is a sign: beside what is at its height, else right after all of it.

    Args:
        left: As in `distance`.
        right: As in `distance`.
        x_height: As in `distance`.
        lean: As in `word_distance`; an apostrophe is past an o, and a comma past a quotation mark, along it.
    """
    right_edge, left_edge = _edge(left, x_height, 1), _edge(right, x_height, -1)
    if np.isfinite(_overlap(right_edge, left_edge, BESIDE)):
        return x_height * (SIGN + _overlap(right_edge, left_edge, AROUND))
    return PAST * x_height + _reach(left, right, lean)


def _part(stroke: Trajectory, part: slice) -> Trajectory:
    return Trajectory(stroke.t[part], stroke.position[part])


def _moved_to_white(apart: Array, white: float, deep: float) -> float:
    """By how much distances (B,) grow so that their mean, each counted to `deep` at most, is `white`."""
    least = float(apart.min()) if np.isfinite(apart).any() else 0.0
    low, high = (
        -least - 10,
        deep - least,
    )  # the mean only grows with the move, and is `deep` at the latest there
    for _ in range(50):
        middle = (low + high) / 2
        if np.minimum(apart + middle, deep).mean() < white:
            low = middle
        else:
            high = middle
    return high


def _edge(strokes: Sequence[Trajectory], x_height: float, side: int) -> Array:
    """How far to the right (side 1) or to the left (side -1) ink reaches in each band of height [x-heights]."""
    edge = np.full(round((HIGHEST - LOWEST) * BANDS), -np.inf)
    for stroke in strokes:
        path = stroke.position / x_height
        dense, _ = evenly(path, max(2, int(4 * BANDS * long(path))))
        band = np.clip(((dense[:, 1] - LOWEST) * BANDS).astype(int), 0, len(edge) - 1)
        np.maximum.at(edge, band, side * dense[:, 0])
    return edge


def _overlap(right_edge: Array, left_edge: Array, near: float) -> float:
    """How far ink reaches over ink, both seen so far up and down [x-heights]; -inf where none is beside any."""
    bands = 2 * round(near * BANDS) + 1
    wide = maximum_filter1d(right_edge, bands, mode="nearest") + maximum_filter1d(
        left_edge, bands, mode="nearest"
    )
    return float(wide.max())


def _reach(left: Sequence[Trajectory], right: Sequence[Trajectory], lean: float) -> float:
    """How far ink reaches over ink along a line that leans, at whatever heights they are [m]."""
    ends, begins = (
        np.concatenate([s.position @ (1.0, -lean) for s in strokes]) for strokes in (left, right)
    )
    return float(ends.max() - begins.min())


def _top(strokes: Sequence[Trajectory], x_height: float) -> float:
    return max(float(stroke.position[:, 1].max()) for stroke in strokes) / x_height
