"""Strokes from the lines of a drawing: pieces that go on are one, and a repeated line is one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import scipy

from dmp_teach.trajectory import Array, arc_lengths, interpolate_points, path_length

REPEATED = 0.03  # how far apart two lines may be that are one drawn twice [share of its size]
COMPARED = 24  # points
PIECE = 0.2  # a line so short may be the piece of one that goes back [share of the drawing]
FORWARD = np.array([1.0, 0.6])  # lines are compared as if they went there
MEETING = 1e-3  # how near the end of a piece the next one begins [share of the drawing]
SMOOTH = 0.5  # cosine of the largest turn where a pen goes on
FEWEST_TURNED = 4  # pieces that meet, before any of them is turned
NARROW = 0.2  # how wide a closed line may be that is an outline [share of its size]


def unrepeated(strokes: Sequence[Array]) -> list[Array]:
    """Return strokes, points (K, 2) each, without those that were drawn before."""
    strokes = list({way.tobytes(): way for way in strokes}.values())
    along = [arc_lengths(way) for way in strokes]
    shares = np.linspace(0, 1, COMPARED)
    even = np.array(
        [interpolate_points(shares * s[-1], s, way) for s, way in zip(along, strokes, strict=True)]
    )
    lengths = np.ptp(even, axis=1).max(axis=1)
    is_long = lengths > PIECE * np.ptp(even, axis=(0, 1)).max()
    is_back = is_long & ((even[:, -1] - even[:, 0]) @ FORWARD < 0)
    even[is_back] = even[is_back, ::-1]
    slacks = REPEATED * lengths + 1e-6
    marks = even[:, [0, COMPARED // 2, -1]].reshape(-1, 6)
    near = scipy.spatial.KDTree(marks).query_ball_point(marks, slacks, p=np.inf)
    is_new = np.ones(len(strokes), bool)
    for k, others in enumerate(near):
        before = [j for j in others if j < k and is_new[j]]
        apart = np.abs(even[before] - even[k]).max(axis=(1, 2), initial=0.0)
        is_new[k] = not (apart < slacks[k]).any()
    return [way for way, is_first in zip(strokes, is_new, strict=True) if is_first]


def joined(strokes: Sequence[Array]) -> tuple[list[Array], int]:
    """Return strokes (K, 2) with pieces that continue each other in one.

    A hand that draws on a tablet may leave a path for each piece of a stroke: where most of a row
    of pieces that meet end to end go on without a bend, all of them are one stroke. Of a longer row
    each piece may go either way, as in drawings of machines.

    Returns:
        The strokes, and how many begin where the one before ends, with a bend.
    """
    slack = MEETING * np.ptp(np.concatenate(strokes), axis=0).max()
    whole, bends = [], 0
    for row, own in _rows(strokes, slack, may_turn=False):
        whole += [np.concatenate(row)] if _goes_on(row) else own
        bends += 0 if _goes_on(row) else len(row) - 1
    turned = []
    for row, own in _rows(whole, slack, may_turn=True):
        turned += [np.concatenate(row)] if len(row) >= FEWEST_TURNED and _goes_on(row) else own
    return turned, bends


def _rows(
    strokes: Sequence[Array], slack: float, *, may_turn: bool
) -> list[tuple[list[Array], list[Array]]]:
    """Return rows of strokes (K, 2) that meet end to end: as they go on, and as they were."""
    turns = (1, -1) if may_turn else (1,)
    rows: list[tuple[list[Array], list[Array]]] = [([strokes[0]], [strokes[0]])]
    for way in strokes[1:]:
        row, own = rows[-1]
        pairs = [
            (before, after)
            for before in [row[-1][::turn] for turn in (turns if len(row) == 1 else (1,))]
            for after in [way[::turn] for turn in turns]
            if _meet(before, after, slack)
        ]
        if pairs:
            row[-1:] = pairs[0]
            own.append(way)
        else:
            rows.append(([way], [way]))
    return rows


def _meet(before: Array, after: Array, slack: float) -> bool:
    """Tell whether a way (K, 2) begins where another ends, and neither is a dot."""
    is_near = np.abs(after[0] - before[-1]).max() <= slack
    return bool(is_near) and min(path_length(after), path_length(before)) > 0


def _goes_on(row: Sequence[Array]) -> bool:
    """Tell whether ways (K, 2) that meet go on without a bend, most of them."""
    turns = [-_heading(after) @ _heading(before[::-1]) for before, after in pairwise(row)]
    return bool(turns) and bool(np.median(turns) > SMOOTH)


def _heading(way: Array) -> Array:
    """Return in which direction a way (K, 2) begins, shape (2,)."""
    steps = way[1:] - way[0]
    step = steps[np.flatnonzero(np.abs(steps).max(axis=1) > 0)[0]]
    return step / np.linalg.norm(step)


def area_of(way: Array) -> float:
    """Return the area in a closed way (K, 2), negative where it runs clockwise."""
    x, y = (way - way[0]).T
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2


def is_outline(parts: Sequence[Array]) -> bool:
    """Tell whether ways (K, 2) run round a long narrow area, as the edge of a line does.

    A way within the box of a larger one is the edge of a hole.
    """
    if not all(np.array_equal(way[0], way[-1]) and path_length(way) > 0 for way in parts):
        return False
    size = np.ptp(np.concatenate(parts), axis=0).max()
    steps = [np.diff(way, axis=0) for way in parts]
    headings = [np.arctan2(*step[np.abs(step).max(axis=1) > 0].T) for step in steps]
    is_simple = min(np.ptp(np.unwrap(heading)) for heading in headings) > np.pi
    areas = np.abs([area_of(way) for way in parts])
    low, high = (np.array([end(way, axis=0) for way in parts]) for end in (np.min, np.max))
    whole = np.argmax(areas)
    is_hole = ((low > low[whole]) & (high < high[whole])).all(axis=1)
    width = 2 * abs(sum(np.where(is_hole, -areas, areas))) / sum(map(path_length, parts))
    return bool(is_simple and width < NARROW * size)
