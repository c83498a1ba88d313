"""What is doubtful in a take: the pen is lost while it writes, or leaps; told, and not refused."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from dmp_teach.formats.motive.table import list_names
from dmp_teach.formats.motive.take import Take
from dmp_teach.segmentation import Flags, Spans, find_leaps
from dmp_teach.trajectory import Array

# A gap up to this long, and one frame more, is filled with a straight line without a word.
LONGEST_FILLED_GAP = 0.1  # [s]
EDGE = 0.02  # a stroke that ends so soon before the marker is lost goes on [s]
BESIDE_WRITING = 0.5  # a leap this soon before or after the writing has cut it short [s]


def find_doubts(take: Take, position: Array, strokes: Spans) -> tuple[tuple[str, ...], Flags]:
    """Return a sentence for each doubt, and which samples of strokes are doubtful (T,).

    Args:
        take: From the first sample that the cameras saw to the last.
        position: The pen on its page with its gaps filled, shape (T, 3) [m].
        strokes: As (first sample, one after the last).
    """
    _, leap = find_leaps(take.t, position)
    leap[~take.is_seen] = 0.0
    is_ink = np.zeros(len(leap), dtype=bool)
    for a, b in strokes:
        is_ink[a:b] = True
    doubtful = leap > 0
    longest = LONGEST_FILLED_GAP + float(np.median(np.diff(take.t)))
    notes = _gaps(take, strokes, longest, doubtful) + _edges(take, strokes, longest)
    notes += _leaps(take, leap, strokes, is_ink)
    faults, pen = take.table.faults, take.pen
    if faults:
        notes.append(f"Left out: {len(faults)} rows or cells. The first: {faults[0]}")
    left = pen.left[(pen.left > take.first) & (pen.left < take.first + len(leap) - 1)] - take.first
    if len(left):
        doubtful[left] = True
        notes.append(
            f"The marker leaps away farther than a hand moves, {len(left)} times, first at "
            f"{take.at(left[0])}: left out, as if it were not seen."
        )
    if pen.rivals:
        notes.append(
            f"Taken for the pen is {pen.name!r}, which is nearest to the paper of the markers that "
            f"move; others could be named with marker=...: {list_names(pen.rivals)}."
        )
    return tuple(notes), doubtful & is_ink


def _gaps(take: Take, strokes: Spans, longest: float, doubtful: Flags) -> list[str]:
    """Return where a gap, of empty cells or missing rows, leaves a hole in a stroke.

    `doubtful` (T,) becomes true there.
    """
    notes = []
    for before, after in pairwise(np.flatnonzero(take.is_seen)):
        gap = take.t[after] - take.t[before]
        inside = [k for k, (a, b) in enumerate(strokes) if before < b - 1 and after > a]
        if gap > longest and inside:
            doubtful[before : after + 1] = True
            notes.append(
                f"The marker is lost for {gap:.2f} s after {take.at(before)}, inside stroke "
                f"{inside[0]}: a straight line is there. Fill it in Motive, or record again."
            )
    return notes


def _edges(take: Take, strokes: Spans, longest: float) -> list[str]:
    """Return where the take goes on without the marker, which was writing."""
    t, whole, last = take.t, take.table.t, len(strokes) - 1
    sides = (
        (0, 0, t[strokes[0][0]] - t[0], t[0] - whole[0], "is first seen at"),
        (-1, last, t[-1] - t[strokes[last][1] - 1], whole[-1] - t[-1], "is lost for good after"),
    )
    return [
        f"The marker {verb} {take.at(edge % len(t))}, inside stroke {number}, of which "
        f"{unseen:.2f} s may be missing. Mend it in Motive, or record again."
        for edge, number, away, unseen, verb in sides
        if unseen > longest and away <= EDGE
    ]


def _leaps(take: Take, size: Array, strokes: Spans, is_ink: Flags) -> list[str]:
    """Return how often the marker leaps, as where it flickers, or another one is taken for it.

    A leap off the paper looks like a lift, so lifts are searched, too, and a moment before and
    after the writing; `size` (T,) is how far each sample leaps [m].
    """
    first, last = take.t[strokes[0][0]], take.t[strokes[-1][1] - 1]
    near = (take.t >= first - BESIDE_WRITING) & (take.t <= last + BESIDE_WRITING)
    leaps = np.flatnonzero((size > 0) & near)
    if not len(leaps):
        return []
    where = "inside a stroke" if is_ink[leaps].any() else "beside a stroke"
    return [
        f"The marker jumps by up to {size[leaps].max() * 1e3:.1f} mm {where}, which no pen does: "
        f"at {len(leaps)} samples from {take.at(leaps[0])} to {take.at(leaps[-1])}."
    ]
