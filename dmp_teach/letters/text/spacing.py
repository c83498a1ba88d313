"""The spacing of letters and words: by the white between them, not by their boxes.

The white between two letters is their horizontal distance at each height, counted to a limit,
because the eye does not look deep into the openings of a c or under the arm of a T. Its mean is the
same for all pairs, and ink keeps a distance from ink at every height.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import scipy

from dmp_teach.letters.compose.geometry import resample_evenly
from dmp_teach.letters.text.connection_points import find_meeting, leaving_sample, missing_run
from dmp_teach.trajectory import Array, Trajectory, path_length

Strokes = tuple[Trajectory, ...]

# Lengths are in x-heights. The mean white between letters and between connected ones, without the
# connection; white counts to this depth, and ink is never nearer to ink than the clearance.
LETTER_WHITE = 0.33
CONNECTED_WHITE = 0.28
WHITE_DEPTH = 0.50
CLEARANCE = 0.12
# A sign keeps this distance from ink seen so far up and down, if there is ink this near to its
# height; else it stands so far past the letter, as an apostrophe after an o.
SIGN_WHITE = 0.24
SIGN_VIEW = 0.30
SIGN_NEIGHBOURHOOD = 0.15
SIGN_AFTER_INK = 0.12
# Two words stand this much farther apart than two letters, with at least this white between them,
# along the lean of the hand and across, as far up and down as an eye looks.
WORD_SPACE = 0.5
WORD_WHITE = 0.6
WORD_VIEW = 0.5
# Heights are seen in bands, from the lowest to the highest above the writing line.
BANDS_PER_X_HEIGHT = 25
LOWEST_BAND = -2.0
HIGHEST_BAND = 4.0


def letter_spacing(
    left: Strokes, right: Strokes, x_height: float, white: float = LETTER_WHITE
) -> float:
    """Return how far right a letter is moved to follow another; may be negative [m].

    Both stand on the line y = 0; `white` is the mean distance that they get, in x-heights.
    """
    right_edge, left_edge = _edge(left, x_height, 1), _edge(right, x_height, -1)
    apart = -left_edge - right_edge
    top = max(1.0, min(_top(left, x_height), _top(right, x_height), HIGHEST_BAND))
    zone = slice(
        round(-LOWEST_BAND * BANDS_PER_X_HEIGHT), round((top - LOWEST_BAND) * BANDS_PER_X_HEIGHT)
    )
    overlap = _overlap(right_edge, left_edge, CLEARANCE)
    if not np.isfinite(overlap):
        # The one ends under the other.
        overlap = float(right_edge.max() + left_edge.max())
    return x_height * max(CLEARANCE + overlap, _shift_to_white(apart[zone], white))


def connected_spacing(
    glyphs: Sequence[Strokes], bodies: Sequence[Strokes], x_height: float
) -> float:
    """Return the same for two connected letters, between which the way must not be too steep.

    `bodies` are the strokes of each glyph that are connected: the last of the one to the first of
    the other.
    """
    end, start = bodies[0][-1], bodies[1][0]
    a = leaving_sample(end, x_height)
    here = end.position[a]
    left = tuple(_part(end, slice(a + 1)) if each is end else each for each in glyphs[0])
    right, step = glyphs[1], 0.0
    for _ in range(3):
        step = letter_spacing(left, right, x_height, CONNECTED_WHITE)
        met = find_meeting(here - (step, 0.0), start, x_height)
        step += max(0.0, missing_run(here - (step, 0.0), start.position[met.sample], x_height))
        met = find_meeting(here - (step, 0.0), start, x_height)
        kept = slice(0 if met.back else met.sample, None)
        right = tuple(_part(start, kept) if each is start else each for each in glyphs[1])
    return step


def word_spacing(left: Strokes, right: Strokes, x_height: float, lean: float) -> float:
    """Return the same for two words: a space more, and white that no overhanging letter fills.

    The white between words leans as the words do: `lean` is the x gained for each y.
    """
    right_edge, left_edge = _edge(left, x_height, 1), _edge(right, x_height, -1)
    across = x_height * _overlap(right_edge, left_edge, WORD_VIEW)
    white = WORD_WHITE * x_height + max(across, _overlap_along(left, right, lean))
    return max(letter_spacing(left, right, x_height) + WORD_SPACE * x_height, white)


def sign_spacing(left: Strokes, right: Strokes, x_height: float, lean: float) -> float:
    """Return the same where one is a sign: beside what is at its height, else after all of it.

    An apostrophe is past an o along the lean of the hand.
    """
    right_edge, left_edge = _edge(left, x_height, 1), _edge(right, x_height, -1)
    if np.isfinite(_overlap(right_edge, left_edge, SIGN_NEIGHBOURHOOD)):
        return x_height * (SIGN_WHITE + _overlap(right_edge, left_edge, SIGN_VIEW))
    return SIGN_AFTER_INK * x_height + _overlap_along(left, right, lean)


def _part(stroke: Trajectory, part: slice) -> Trajectory:
    return Trajectory(stroke.t[part], stroke.position[part])


def _shift_to_white(apart: Array, white: float) -> float:
    """Return by how much distances (B,) grow so that their mean, each limited, is `white`.

    The sum of min(a + m, depth) over all bands is the least of the sums in which only the k
    smallest are not limited; so the shift m is the greatest that one of these asks for.
    """
    narrow = np.sort(apart[np.isfinite(apart)])
    if not len(narrow):
        return -np.inf
    k = np.arange(1, len(narrow) + 1)
    limited = (len(apart) - k) * WHITE_DEPTH
    return float(((len(apart) * white - limited - np.cumsum(narrow)) / k).max())


@lru_cache(maxsize=512)
def _edge(strokes: Strokes, x_height: float, side: int) -> Array:
    """Return how far right (side 1) or left (-1) ink reaches in each band [x-heights]."""
    edge = np.full(round((HIGHEST_BAND - LOWEST_BAND) * BANDS_PER_X_HEIGHT), -np.inf)
    for stroke in strokes:
        path = stroke.position / x_height
        dense, _ = resample_evenly(path, max(2, int(4 * BANDS_PER_X_HEIGHT * path_length(path))))
        band = ((dense[:, 1] - LOWEST_BAND) * BANDS_PER_X_HEIGHT).astype(int)
        np.maximum.at(edge, np.clip(band, 0, len(edge) - 1), side * dense[:, 0])
    return edge


def _overlap(right_edge: Array, left_edge: Array, view: float) -> float:
    """Return how far ink reaches over ink within a view up and down [x-heights]; -inf if none."""
    bands = 2 * round(view * BANDS_PER_X_HEIGHT) + 1
    right, left = (
        scipy.ndimage.maximum_filter1d(edge, bands, mode="nearest")
        for edge in (right_edge, left_edge)
    )
    return float((right + left).max())


def _overlap_along(left: Strokes, right: Strokes, lean: float) -> float:
    """Return how far ink reaches over ink along a line that leans, at whatever heights [m]."""
    ends, begins = (
        np.concatenate([s.position @ (1.0, -lean) for s in strokes]) for strokes in (left, right)
    )
    return float(ends.max() - begins.min())


def _top(strokes: Strokes, x_height: float) -> float:
    return max(float(stroke.position[:, 1].max()) for stroke in strokes) / x_height
