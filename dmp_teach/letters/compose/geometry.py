"""The shape of strokes: how straight they are, where their corners are, points on them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dmp_teach.trajectory import Array, Trajectory, arc_lengths, interpolate_points, path_length

# A corner turns by more than this within this share of the stroke's size before and behind it.
CORNER_ANGLE = np.radians(62)
CORNER_REACH = 0.07
# Nothing shorter than this share of the stroke is cut off.
SHORTEST_PART = 0.12


def straightness(path: Array) -> float:
    """Return chord over length of a path (T, 2): 1 for a line, 0 for a ring."""
    return float(np.linalg.norm(path[-1] - path[0])) / max(path_length(path), 1e-12)


def is_upright(path: Array) -> bool:
    """Return whether a path (T, 2) leads more up or down than sideways."""
    across, up = np.abs(path[-1] - path[0])
    return bool(up > across)


def resample_evenly(path: Array, points: int) -> tuple[Array, Array]:
    """Resample a path (T, 2) at equal arc length: the points, and the fractional row of each."""
    arc = arc_lengths(path)
    even = np.linspace(0, arc[-1], points)
    resampled = interpolate_points(even, arc, path)
    return resampled, np.interp(even, arc, np.arange(len(arc)))


def find_corners(stroke: Trajectory) -> tuple[int, ...]:
    """Find the samples at which a stroke turns sharply: the foot of an n, the waist of a B.

    A turn is the angle between the chords into a point and out of it, `CORNER_REACH` of the size
    long.
    """
    path = stroke.position
    size, total = float(np.ptp(path, axis=0).max()), path_length(path)
    step = max(CORNER_REACH * size / 8, total / 4000)
    if size <= 0 or total < 4 * CORNER_REACH * size:
        return ()
    even, rows = resample_evenly(path, max(3, round(total / step)))
    reach = max(1, round(CORNER_REACH * size * (len(even) - 1) / total))
    into, out = even[reach:-reach] - even[: -2 * reach], even[2 * reach :] - even[reach:-reach]
    across = into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0]
    turn = np.abs(np.arctan2(across, (into * out).sum(axis=1)))
    found: list[int] = []
    least = max(reach, round(SHORTEST_PART * len(even)))
    for k in np.argsort(-turn, kind="stable"):
        place = int(k) + reach
        clear = all(abs(place - other) > reach for other in found)
        if turn[k] > CORNER_ANGLE and clear and least < place < len(even) - 1 - least:
            found.append(place)
    return tuple(round(rows[place]) for place in sorted(found))


def cut_at_corners(stroke: Trajectory) -> tuple[Trajectory, ...]:
    """Cut a stroke at its corners; each part begins with the last sample of the one before."""
    corners = [k for k in find_corners(stroke) if 1 < k < len(stroke) - 2]
    parts = [slice(a, b + 1) for a, b in pairwise([0, *corners, len(stroke) - 1])]
    return tuple(Trajectory(stroke.t[part], stroke.position[part]) for part in parts)


def find_bar_and_bowl(strokes: Sequence[Trajectory]) -> tuple[int, int]:
    """Return the numbers of the straighter and the other one of the two longest strokes."""
    two = sorted(np.argsort([path_length(s.position) for s in strokes])[-2:])
    bar = two[int(np.argmax([straightness(strokes[k].position) for k in two]))]
    return int(bar), int(next(k for k in two if k != bar))


def x_crossings(path: Array, height: float) -> Array:
    """Return the x of every crossing of a path (T, 2) with a height, as written [m]."""
    y = path[:, 1]
    below, above = np.minimum(y[:-1], y[1:]), np.maximum(y[:-1], y[1:])
    k = np.flatnonzero((below <= height) & (height <= above))
    rise = y[k + 1] - y[k]
    part = np.where(rise == 0, 0.0, (height - y[k]) / np.where(rise == 0, 1.0, rise))
    return path[k, 0] + part * (path[k + 1, 0] - path[k, 0])


def x_near_height(path: Array, height: float) -> float | None:
    """Return the x of a path (T, 2) at a height up to a tenth of it beyond its ends [m]."""
    low, high = path[:, 1].min(), path[:, 1].max()
    near = min(max(height, low), high)
    return float(x_crossings(path, near)[-1]) if abs(near - height) <= 0.1 * (high - low) else None


def box_middle(path: Array) -> Array:
    """Return the middle of the bounding box of a path (T, 2), shape (2,)."""
    return (path.min(axis=0) + path.max(axis=0)) / 2
