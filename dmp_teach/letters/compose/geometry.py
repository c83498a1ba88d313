"""The shape of strokes: how straight, where their corners are, how far apart; no two writers order them alike."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dmp_teach.trajectory import Array, Trajectory, ways
from dmp_teach.trajectory import length as long

REACH = 0.07  # a corner is seen over this way before and behind it, in parts of the stroke's size
SHARP = np.radians(62)  # a turn by more than this within that way is a corner
SHORT = 0.12  # nothing shorter than this part of the stroke is cut off


def straightness(path: Array) -> float:
    """The way from end to end in parts of the way along a path (T, 2): 1 for a line, 0 for a ring."""
    return float(np.linalg.norm(path[-1] - path[0])) / max(long(path), 1e-12)


def is_upright(path: Array) -> bool:
    """Whether a path (T, 2) leads more up or down than sideways."""
    across, up = np.abs(path[-1] - path[0])
    return bool(up > across)


def evenly(path: Array, points: int) -> tuple[Array, Array]:
    """So many points at equal ways along a path (T, 2), and the (uneven) row of `path` where each of them is."""
    way = ways(path)
    even = np.linspace(0, way[-1], points)
    return np.column_stack([np.interp(even, way, axis) for axis in path.T]), np.interp(
        even, way, np.arange(len(way))
    )


def corners(stroke: Trajectory) -> tuple[int, ...]:
    """The samples at which a stroke turns sharply: the foot of an n, the waist of a B, the ends of a Z.

    A turn is the angle between the way into a point and the way out of it, `REACH` of the stroke's size long each.
    """
    path = stroke.position
    size, length = float(np.ptp(path, axis=0).max()), long(path)
    step = max(REACH * size / 8, length / 4000)
    if size <= 0 or length < 4 * REACH * size:
        return ()
    even, rows = evenly(path, max(3, round(length / step)))
    reach = max(1, round(REACH * size * (len(even) - 1) / length))
    into, out = even[reach:-reach] - even[: -2 * reach], even[2 * reach :] - even[reach:-reach]
    across = into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0]
    turn = np.abs(np.arctan2(across, (into * out).sum(axis=1)))
    found, least = [], max(reach, round(SHORT * len(even)))
    for k in np.argsort(-turn, kind="stable"):
        place = k + reach
        clear = all(abs(place - other) > reach for other in found)
        if turn[k] > SHARP and clear and least < place < len(even) - 1 - least:
            found.append(int(place))
    return tuple(round(rows[place]) for place in sorted(found))


def cut(stroke: Trajectory) -> tuple[Trajectory, ...]:
    """A stroke in parts, cut at its corners; each begins with the sample at which the one before ended."""
    edges = [0, *(k for k in corners(stroke) if 1 < k < len(stroke) - 2), len(stroke) - 1]
    parts = [slice(a, b + 1) for a, b in pairwise(edges)]
    return tuple(Trajectory(stroke.t[part], stroke.position[part]) for part in parts)


def bar_and_bowl(strokes: Sequence[Trajectory]) -> tuple[int, int]:
    """The numbers of the straightest stroke, and of the longest of the others."""
    length = [long(s.position) for s in strokes]
    two = sorted(np.argsort(length)[-2:])
    bar = two[int(np.argmax([straightness(strokes[k].position) for k in two]))]
    return int(bar), int(next(k for k in two if k != bar))


def nearest(path: Array, point: Array) -> Array:
    """The point of a path (T, 2), taken as a line through its points, that is nearest to `point` (2,) [m]."""
    a, d = path[:-1], np.diff(path, axis=0)
    part = np.clip(((point - a) * d).sum(axis=1) / np.maximum((d * d).sum(axis=1), 1e-18), 0, 1)
    on = a + part[:, None] * d
    return on[np.argmin(((on - point) ** 2).sum(axis=1))]


def crossings(path: Array, height: float) -> Array:
    """Where a path (T, 2) is at this height: the x of every crossing, in the order of writing [m]."""
    y = path[:, 1]
    below, above = np.minimum(y[:-1], y[1:]), np.maximum(y[:-1], y[1:])
    k = np.flatnonzero((below <= height) & (height <= above))
    rise = y[k + 1] - y[k]
    part = np.where(rise == 0, 0.0, (height - y[k]) / np.where(rise == 0, 1.0, rise))
    return path[k, 0] + part * (path[k + 1, 0] - path[k, 0])


def row_of(path: Array, place: str) -> int | None:
    """The sample of a path (T, 2) at a place by its name: one of its ends, or what is outermost; None: no such name."""
    goes_down = path[-1, 1] < path[0, 1]
    ends = {
        "start": 0,
        "goal": -1,
        "upper": 0 if goes_down else -1,
        "lower": -1 if goes_down else 0,
    }
    if place in ends:
        return ends[place]
    outermost = {"top": path[:, 1], "bottom": -path[:, 1], "left": -path[:, 0], "right": path[:, 0]}
    return int(np.argmax(outermost[place])) if place in outermost else None


def across(path: Array, height: float) -> float | None:
    """Where a path (T, 2) is at a height, or at its end if that is higher or lower by a tenth of it at most."""
    low, high = path[:, 1].min(), path[:, 1].max()
    near = min(max(height, low), high)
    return float(crossings(path, near)[-1]) if abs(near - height) <= 0.1 * (high - low) else None


def middle_of(path: Array) -> Array:
    """The middle of the box around a path (T, 2), shape (2,)."""
    return (path.min(axis=0) + path.max(axis=0)) / 2
