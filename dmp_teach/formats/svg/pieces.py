"""Strokes from the lines of a drawing: pieces that go on are one, and a repeated line is one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice, pairwise

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
    is_back = (lengths > PIECE * np.ptp(even, axis=(0, 1)).max()) & (
        (even[:, -1] - even[:, 0]) @ FORWARD < 0
    )
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
    rows = [[strokes[0]]]
    for before, way in pairwise(strokes):
        if not _meet(before, way, slack):
            rows.append([])
        rows[-1].append(way)
    whole = [way for row in rows for way in ([np.concatenate(row)] if _goes_on(row) else row)]
    return _joined_either_way(whole, slack), sum(len(row) - 1 for row in rows if not _goes_on(row))


def _joined_either_way(strokes: Sequence[Array], slack: float) -> list[Array]:
    """Return strokes (K, 2) with those in one that do where each may be turned round."""
    rows = [[strokes[0]]]
    for way in strokes[1:]:
        last = rows[-1][-1]
        pairs = [
            (before, after)
            for before in ([last] if len(rows[-1]) > 1 else [last, last[::-1]])
            for after in (way, way[::-1])
            if _meet(before, after, slack)
        ]
        if pairs:
            rows[-1][-1:] = pairs[0]
        else:
            rows.append([way])
    whole: list[Array] = []
    kept = iter(strokes)
    for row in rows:
        own = list(islice(kept, len(row)))
        is_one = len(row) >= FEWEST_TURNED and _goes_on(row)
        whole += [np.concatenate(row)] if is_one else own
    return whole


def _meet(before: Array, after: Array, slack: float) -> bool:
    """Tell whether a way (K, 2) begins where another ends, and neither is a dot."""
    is_dot = not min(path_length(after), path_length(before)) > 0
    return not is_dot and bool(np.abs(after[0] - before[-1]).max() <= slack)


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
