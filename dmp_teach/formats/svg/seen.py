"""What one sees of a drawing: painted one over the other, cut by views, clips and the page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from dmp_teach.errors import RecordingError
from dmp_teach.segmentation import find_runs
from dmp_teach.trajectory import Array, arc_lengths, interpolate_points, path_length

PALE = 1 / 12  # a colour that differs less from what is under it is not seen [share of white]
LOOK_STEP = 1 / 1000  # between the places that are looked at [share of the drawing]
MOST_PLACES = 100_000  # that are looked at
SLACK = 1e-3  # so near an edge is on both of its sides [share of the drawing]
CRUMB = 0.01  # a shorter rest of a cut line is left out [share of the drawing]
MOST_LOOKS = 5e7  # places times edges
CORNERS = np.array([[1, 1], [-1, 1], [1, -1], [-1, -1]])
BESIDE, CUT, PAINTED, COVERED = range(1, 5)  # why something is not seen
WHY_UNSEEN = {
    BESIDE: "beside the page",
    CUT: "cut away by a clip (clip-path) or a drawing within the drawing (svg, symbol)",
    PAINTED: "painted in the colour of what is below",
    COVERED: "painted over",
}


@dataclass(frozen=True)
class Outline:
    """Where an area is.

    Args:
        parts: Its edges, points (K, 2) each, closed by themselves [m].
        is_even_odd: Whether where two parts overlap is a hole, whichever way they run.
    """

    parts: Sequence[Array]
    is_even_odd: bool = False

    @property
    def size(self) -> float:
        """How large its largest part is [m]."""
        return float(max(np.ptp(part, axis=0).max() for part in self.parts))

    def holds(self, points: Array, slack: float) -> Array:
        """Return whether points (N, 2) are inside: 1, outside: 0, or near an edge: between."""
        inside = np.zeros(len(points))
        starts = np.concatenate([*self.parts, np.empty((0, 2))])
        ends = np.concatenate([*(np.roll(part, -1, axis=0) for part in self.parts), starts[:0]])
        low, high = starts.min(axis=0, initial=np.inf), starts.max(axis=0, initial=-np.inf)
        near = np.flatnonzero(((points >= low - slack) & (points <= high + slack)).all(axis=1))
        if len(near) * len(starts) > MOST_LOOKS:
            raise RecordingError("has areas with too many edges over its lines; simplify it.")
        if not len(near):
            return inside
        x, y = (points[near, None] + slack * CORNERS).transpose(2, 0, 1)
        turns = np.zeros(x.shape, int)
        for (x0, y0), (x1, y1) in zip(starts, ends, strict=True):
            crossed = (y0 <= y) != (y1 <= y)
            crossed &= x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)
            turns += crossed * (1 if y1 > y0 else -1)
        inside[near] = (turns % 2 if self.is_even_odd else turns != 0).mean(axis=1)
        return inside


# Why, and outlines of which one holds what is seen.
Clip = tuple[int, Sequence[Outline]]


@dataclass(frozen=True)
class Painted:
    """A line or an area, as it is painted.

    Args:
        ways: Lines that may be strokes, points (K, 2) each, y up [m].
        colour: Red, green, blue and opacity, shape (4,).
        clips: What cuts it.
        width: Of a line [m].
        area: Where it is painted all over, and its way is only its middle; None for a line.
    """

    ways: Sequence[Array]
    colour: Array
    clips: Sequence[Clip]
    width: float = 0.0
    area: Outline | None = None


def look_at(
    painted: Sequence[Painted], paper: Array
) -> tuple[list[tuple[Array, Painted]], Counter[int], int]:
    """Return what one sees of a drawing, the lowest first, on a page of a colour (4,).

    Returns:
        Ways, points (K, 2) each, with what they are of; how many lines are not seen, or not
        whole, by why; and how many areas of a colour are not the ground of all lines.
    """
    ways = [(k, way) for k, each in enumerate(painted) for way in each.ways]
    size = float(np.ptp(np.concatenate([way for _, way in ways]), axis=0).max())
    step = max(LOOK_STEP * size, sum(path_length(way) for _, way in ways) / MOST_PLACES)
    dense = [_dense(way, step) for _, way in ways]
    owner = np.repeat([k for k, _ in ways], [len(each) for each in dense])
    why, areas = _why_unseen(painted, paper, np.concatenate(dense), owner, SLACK * size)
    seen, unseen = [], Counter[int]()
    ends = np.cumsum([len(each) for each in dense])[:-1]
    for (k, way), whole, hidden in zip(ways, dense, np.split(why, ends), strict=True):
        if not hidden.any():
            seen.append((way, painted[k]))
            continue
        if painted[k].area is None:
            unseen[int(hidden[hidden > 0][0])] += 1
        runs = [whole[start:end] for start, end in find_runs(hidden == 0)]
        seen += [(run, painted[k]) for run in runs if path_length(run) >= CRUMB * size]
    return seen, unseen, areas


def _why_unseen(
    painted: Sequence[Painted], paper: Array, points: Array, owner: Array, slack: float
) -> tuple[Array, int]:
    """Return why each of `points` (N, 2) is not seen, 0 where it is, and the number of areas.

    Each is a place on one of `painted`, its `owner` (N,).
    """
    why, areas = np.zeros(len(points), int), 0
    under = np.tile(paper[:3], (len(points), 1))
    held = {}
    for clip in {id(clip): clip for each in painted for clip in each.clips}.values():
        reason, outlines = clip
        each_holds = [outline.holds(points, slack) for outline in outlines]
        held[id(clip)] = np.max([np.zeros(len(points)), *each_holds], axis=0)
        owned = [k for k, each in enumerate(painted) if id(clip) in map(id, each.clips)]
        why[np.isin(owner, owned) & (held[id(clip)] == 0)] = reason
    for k, each in enumerate(painted):
        if each.area is None:
            continue
        inside, opacity = each.area.holds(points, slack), each.colour[3]
        for clip in each.clips:
            inside = inside * held[id(clip)]
        if 1 - opacity < PALE:
            why[(owner < k) & (inside == 1)] = COVERED
        above = (owner > k) & (inside > 0)
        under[above] = (1 - opacity) * under[above] + opacity * each.colour[:3]
        is_ground = (inside[owner != k] > 0).all()
        areas += int(is_seen(each.colour, paper) and not is_ground)
    colours = np.array([each.colour for each in painted])[owner]
    is_pale = is_seen(colours, under) == 0
    erasing = is_pale & (why == 0) & (1 - colours[:, 3] < PALE)
    why[is_pale] = PAINTED
    rubbers = np.unique(owner[erasing])
    places = scipy.spatial.KDTree(points if len(rubbers) else points[:1])
    for k in rubbers:
        found = places.query_ball_point(points[erasing & (owner == k)], painted[k].width / 2)
        under_it = np.unique(np.concatenate(found)).astype(int)
        why[under_it[owner[under_it] < k]] = COVERED
    return why, areas


def is_seen(paint: Array, under: Array) -> Array:
    """Return whether colours (..., 4) are seen over others, shape (..., 3) or (..., 4)."""
    apart = np.abs(paint[..., :3] - under[..., :3]).max(axis=-1)
    return np.asarray(apart * paint[..., 3] > PALE)


def _dense(way: Array, step: float) -> Array:
    """Return a way (K, 2) with its own points and more, at most a `step` apart, shape (N, 2)."""
    along = arc_lengths(way)
    if not along[-1] > step > 0:
        return way
    return interpolate_points(np.union1d(along, np.arange(0, along[-1], step)), along, way)
