"""Ink as a mesh: a line is one pixel wide in WebGL, so a stroke of the pen is a ribbon of small triangles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.robot import Motion
from dmp_teach.trajectory import Array, Trajectory, length, locked

CORNERS = 8
"""A dot of ink is a polygon of so many corners."""

_BEND = np.radians(20)
"""Where the line bends more than this, and at its ends, a whole dot is drawn: ends and corners are round [rad]."""

MOST_DOTS = 2000
"""Of a ribbon: a long text is drawn a little less round, so that its file stays small."""
_STILL = 1e-12
"""A pen at rest counts as moving so little, so that its way always grows [m]."""


@dataclass(frozen=True, eq=False)
class Ribbon:
    """A flat ribbon on the page, in the order in which it is drawn.

    Args:
        t: When the pen reaches each dot, never decreasing, shape (P,) [s].
        dots: Where the middle of the line is, in the page's frame, shape (P, 2) [m].
        first: True where a stroke begins, shape (P,).
        vertices: Corners in the page's frame, shape (V, 3) [m].
        faces: Numbers of corners, shape (F, 3).
        ends: How many of the triangles lead up to each dot, with the dot's own, shape (P,).
        owners: Which dot each corner belongs to, shape (V,).
    """

    t: Array
    dots: Array
    first: Array
    vertices: Array
    faces: Array
    ends: Array
    owners: Array

    def triangles(self, t: float) -> int:
        """How many triangles the pen has drawn at time `t` [s]: those of every dot that it has reached."""
        reached = int(np.searchsorted(self.t, t + 1e-9, side="right"))
        return int(self.ends[reached - 1]) if reached else 0


def ribbon(
    strokes: Sequence[Trajectory],
    width: float | Callable[[Array], Array],
    height: float,
    spacing: float = 0.0007,
    most: int = MOST_DOTS,
) -> Ribbon:
    """The mesh of some strokes.

    Args:
        strokes: 2-D, in the page's frame, one after the other in time [s], [m].
        width: Of the ribbon [m]; or what gives it at times (P,) [s].
        height: Over the paper [m].
        spacing: Between two dots [m]; wider where there would be more than `most`.
        most: Dots in all, or a few more.

    Returns:
        A `Ribbon`; without strokes an empty one.
    """
    spacing = max(spacing, sum(length(stroke.position) for stroke in strokes) / most)
    walks = [_walk(stroke, spacing) for stroke in strokes]
    t = np.concatenate([np.empty(0), *(walk[0] for walk in walks)])
    dots = np.concatenate([np.empty((0, 2)), *(walk[1] for walk in walks)])
    first = np.concatenate([np.empty(0, bool), *(np.arange(len(walk[0])) == 0 for walk in walks)])
    widths = width(t) if callable(width) else np.full(len(t), width)
    vertices, faces, ends, owners = _mesh(dots, first, widths, height)
    whole = locked(faces, np.uint32), locked(ends, int), locked(owners, int)
    return Ribbon(locked(t), locked(dots), locked(first, bool), locked(vertices), *whole)


def inked(motion: Motion) -> tuple[Trajectory, ...]:
    """What the nib writes, stroke by stroke: its path on the page wherever the pen is down, from time 0."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], motion.pen_down, [False]]).astype(int)))
    on_page = motion.page.to_page(motion.tip)[:, :2]
    t = motion.t - motion.t[0]
    pieces = ((start, stop) for start, stop in edges.reshape(-1, 2) if stop - start > 1)
    return tuple(Trajectory(t[start:stop], on_page[start:stop]) for start, stop in pieces)


def _walk(stroke: Trajectory, spacing: float) -> tuple[Array, Array]:
    """Dots at equal distances along a stroke, with the time at which the pen comes to each; a stroke at rest is one."""
    steps = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
    way = np.concatenate([[0.0], (steps + _STILL).cumsum()])
    count = int(np.ceil(way[-1] / spacing)) + 1 if way[-1] > 1e-6 else 1
    dots = np.linspace(0.0, way[-1], count)
    columns = [np.interp(dots, way, stroke.position[:, column]) for column in range(2)]
    return np.interp(dots, way, stroke.t), np.column_stack(columns)


def _mesh(
    dots: Array, first: Array, widths: Array, height: float
) -> tuple[Array, Array, Array, Array]:
    """Corners 0 and 4 of a dot stand square to the line; pieces between them, and whole dots where it bends."""
    along = np.where(
        first[:, None], np.roll(dots, -1, axis=0) - dots, dots - np.roll(dots, 1, axis=0)
    )
    heading = np.arctan2(along[:, 1], along[:, 0])
    bend = np.abs(np.angle(np.exp(1j * (np.roll(heading, -1) - heading)))) > _BEND
    whole = first | np.roll(first, -1) | bend
    angles = heading[:, None] + np.pi / 2 + 2 * np.pi * np.arange(CORNERS) / CORNERS
    flat = dots[:, None] + widths[:, None, None] / 2 * np.stack(
        [np.cos(angles), np.sin(angles)], axis=2
    )
    corners = np.concatenate([flat, np.full((*flat.shape[:2], 1), height)], axis=2)
    half = CORNERS // 2
    kept = whole[:, None] | (np.arange(CORNERS) % half == 0)
    number = np.cumsum(kept).reshape(kept.shape) - 1
    here = number[:, (0, half)].T
    there = np.where(first, here, np.roll(here, 1, axis=1))
    piece = [[here[0], there[0], there[1]], [here[0], there[1], here[1]]]
    fan = [[number[:, 0], number[:, k], number[:, k + 1]] for k in range(1, CORNERS - 1)]
    faces = np.array(piece + fan).transpose(2, 0, 1)
    drawn = whole[:, None] | (np.arange(CORNERS) < len(piece))
    return corners[kept], faces[drawn], drawn.sum(axis=1).cumsum(), kept.nonzero()[0]
