"""Why a take is refused: its marker is no pen's, is lost while it writes, or leaps.

Each refusal is a check of its own; `CHECKS` is the order in which they are asked.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import LARGEST_INK
from dmp_teach.formats.motive.take import Take
from dmp_teach.segmentation import Spans
from dmp_teach.trajectory import Array

FEWEST_FRAMES = 20  # fewer samples are no letter
SMALLEST_TAKE = 0.004  # no marker at a hand that writes moves less [m]
# A gap up to this long is filled with a straight line anywhere; a longer one only off the ink.
LONGEST_FILLED_GAP = 0.1  # [s]
EDGE = 0.05  # how long a marker is watched before it is lost, or after it is found [s]
WRITING_SPEED = 0.03  # a marker that is lost slower than this had written all there was [m/s]
FLATNESS = 3.0  # ink lies this much wider on its paper than off it
LEAP = 0.004  # a step that is this much longer than its neighbours was no pen ... [m]
PEN_ACCELERATION = 8.0  # ... unless a pen could do it between two samples ... [m/s2]
AIR_ACCELERATION = 50.0  # ... or a hand in the air, or one that knocks on the paper [m/s2]
BESIDE_WRITING = 0.5  # a leap this soon before or after the writing has cut it short [s]
LEAP_OVER_NOISE = 4.0  # a marker that flickers all the time does not leap


@dataclass(frozen=True)
class Writing:
    """What a take wrote.

    Args:
        take: From the first sample that the cameras saw to the last.
        filled: Its positions with its gaps filled, shape (T, 3) [m].
        strokes: Its strokes, as (first sample, one after the last).
        up: The direction out of the paper, as the user said it.
    """

    take: Take
    filled: Array
    strokes: Spans
    up: str


def check_take_size(take: Take, filled: Array) -> None:
    """Raise where the whole way (T, 3) of the marker is far larger or smaller than a hand's."""
    size = float(np.ptp(filled, axis=0).max())
    if SMALLEST_TAKE < size < LARGEST_INK:
        return
    away = np.abs(take.position - np.nanmedian(take.position, axis=0)).max(axis=1)
    far = ""
    if np.nanmax(away) > LARGEST_INK / 2 > np.nanmedian(away):
        far = f" It is {np.nanmax(away):.4g} m off at {take.at(int(np.nanargmax(away)))}."
    raise RecordingError(
        f"{take.name}: marker {take.marker!r} moves within {size:.4g} m, but a writing hand "
        f"within {SMALLEST_TAKE} to {LARGEST_INK} m.{far} Is 'Length Units' in row 1 right, and "
        f"is this marker the pen? {take.choice}"
    )


def check_writing(writing: Writing) -> None:
    """Raise a RecordingError of the first of `CHECKS` that a writing does not pass."""
    for check in CHECKS:
        check(writing)


def _check_gaps(writing: Writing) -> None:
    """Raise where a long gap, of empty cells or of missing rows, leaves a hole in a stroke."""
    take = writing.take
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    longest = _longest_gap(take)
    for before, after in pairwise(seen):
        gap = take.t[after] - take.t[before]
        if gap <= longest:
            continue
        for number, (a, b) in enumerate(writing.strokes):
            if before < b - 1 and after > a:
                raise RecordingError(
                    f"{take.name}: marker {take.marker!r} is lost for {gap:.2f} s after "
                    f"{take.at(before)}, inside stroke {number}; gaps up to {LONGEST_FILLED_GAP} s "
                    f"can be filled. Fill it in Motive, or record again. {take.choice}"
                )


def _check_edges(writing: Writing) -> None:
    """Raise where the take goes on without the marker, which was writing: a stroke is cut short."""
    take, strokes = writing.take, writing.strokes
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    ends = [
        (seen, take.unseen[0], 0, "before", "is first seen at"),
        (seen[::-1], take.unseen[1], len(strokes) - 1, "after", "is lost for good after"),
    ]
    for edge, unseen, number, side, verb in ends:
        near = edge[np.abs(take.t[edge] - take.t[edge[0]]) <= EDGE]
        near = near[(near >= strokes[number][0]) & (near < strokes[number][1])]
        if unseen <= _longest_gap(take) or len(near) < 2:
            continue
        if _speed_on_paper(writing, near[0], near[-1]) > WRITING_SPEED:
            raise RecordingError(
                f"{take.name}: marker {take.marker!r} {verb} {take.at(int(edge[0]))}, inside "
                f"stroke {number}: the take has {unseen:.2f} s {side} that, but not the marker. "
                f"Mend it in Motive, or record again. {take.choice}"
            )


def _check_leaps(writing: Writing) -> None:
    """Raise where the marker leaps, as it does when the cameras take another one for it.

    A leap is a step far from the mean of its neighbours; where the marker flickers all the time it
    is noise. A leap off the paper looks like a lift, so lifts are searched, too, and a moment
    before and after the writing.
    """
    take, strokes = writing.take, writing.strokes
    step = np.diff(writing.filled, axis=0)
    off = np.zeros(len(take.t))
    off[2:-1] = np.linalg.norm(step[1:-1] - (step[:-2] + step[2:]) / 2, axis=1)
    is_ink = np.zeros(len(off), dtype=bool)
    for a, b in strokes:
        is_ink[a:b] = True
    limit = _leap_limits(take, is_ink)
    first, last = strokes[0][0], strokes[-1][1] - 1
    start, end = np.searchsorted(take.t, take.t[[first, last]] + [-BESIDE_WRITING, BESIDE_WRITING])
    for k in np.flatnonzero(off[start:end] > limit[start:end]) + start:
        near = np.concatenate([off[max(start, k - 15) : max(start, k - 2)], off[k + 3 : k + 16]])
        if not len(near) or off[k] > LEAP_OVER_NOISE * np.quantile(near, 0.9):
            where = "inside a stroke" if is_ink[k] else "beside a stroke"
            raise RecordingError(
                f"{take.name}, {take.at(k)}: {take.marker!r} jumps by {off[k] * 1e3:.1f} mm "
                f"{where}, which no pen does. Mend the take in Motive. {take.choice}"
            )


def _check_ink(writing: Writing) -> None:
    """Raise where hardly anything was written: a page seen from the wrong side, or no letter."""
    take, samples = writing.take, sum(b - a for a, b in writing.strokes)
    if samples < FEWEST_FRAMES:
        raise RecordingError(
            f"{take.name}: marker {take.marker!r} writes in {samples} frames only, but a letter "
            f"needs {FEWEST_FRAMES}. Does up={writing.up!r} point out of the paper? Otherwise "
            f"record again. {take.choice}"
        )


CHECKS: tuple[Callable[[Writing], None], ...] = (
    _check_gaps,
    _check_edges,
    _check_leaps,
    _check_ink,
)


def _longest_gap(take: Take) -> float:
    """Return how long a gap may be that is filled anywhere [s]."""
    return LONGEST_FILLED_GAP + float(np.median(np.diff(take.t)))


def _leap_limits(take: Take, is_ink: np.ndarray) -> Array:
    """Return how far from its neighbours' mean a step may be, shape (T,) [m]."""
    dt = float(np.median(np.diff(take.t)))
    is_seen = np.convolve(np.isfinite(take.position[:, 0]), np.ones(5), "same") == 5
    in_air = np.where(is_seen, LEAP + AIR_ACCELERATION * dt**2, np.inf)
    return np.where(is_ink, LEAP + PEN_ACCELERATION * dt**2, in_air)


def _speed_on_paper(writing: Writing, one: int, other: int) -> float:
    """Return how fast the marker goes from one sample to another, a lift not counted [m/s]."""
    take = writing.take
    ink = np.concatenate([take.position[a:b] for a, b in writing.strokes])
    ink = ink[np.isfinite(ink[:, 0])]
    _, spread, directions = np.linalg.svd(np.cov(ink.T))
    # A bar does not tell how its paper lies.
    is_flat = spread[1] > FLATNESS**2 * spread[2]
    along = directions[: 2 if is_flat else 1] @ (take.position[other] - take.position[one])
    return float(np.linalg.norm(along) / abs(take.t[other] - take.t[one]))
