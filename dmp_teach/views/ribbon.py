"""Ink as a mesh: a line is one pixel wide in WebGL, so a stroke of the pen is a ribbon of small triangles."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.robot.motion import Motion
from dmp_teach.trajectory import Array, Trajectory, locked

CORNERS = 8
"""A dot of ink is a polygon of so many corners; the pen's strokes get round ends and round corners from it."""

TRIANGLES_PER_DOT = CORNERS
"""A dot (CORNERS - 2 triangles) and the piece that leads to it from the dot before (2)."""

_MOST_DOTS = 4000


@dataclass(frozen=True, eq=False)
class Ribbon:
    """A flat ribbon on the page, in the order in which it is drawn.

    Args:
        t: When each dot is drawn, never decreasing, shape (P,) [s].
        dots: Where the middle of each dot is, in the page's frame, shape (P, 2) [m].
        first: True where a stroke begins, shape (P,).
        vertices: Corners in the page's frame, shape (P * 12, 3) [m].
        faces: Corners of triangles, `TRIANGLES_PER_DOT` for each dot, shape (P * 8, 3).
    """

    t: Array
    dots: Array
    first: Array
    vertices: Array
    faces: Array

    def triangles(self, t: float) -> int:
        """How many triangles the pen has drawn at time `t` [s]: those of every dot that it has reached."""
        return TRIANGLES_PER_DOT * int(np.searchsorted(self.t, t + 1e-9, side="right"))


def ribbon(strokes: Sequence[Trajectory], width: float, height: float, spacing: float = 0.0007) -> Ribbon:
    """The mesh of some strokes.

    Args:
        strokes: 2-D, in the page's frame, one after the other in time [s], [m].
        width: Of the ribbon [m].
        height: Over the paper [m].
        spacing: Between two dots [m]; wider where there are so many strokes that the file would grow large.

    Returns:
        A `Ribbon`; without strokes an empty one.
    """
    length = sum(np.linalg.norm(np.diff(s.position, axis=0), axis=1).sum() for s in strokes)
    spacing = max(spacing, float(length) / _MOST_DOTS)
    walks = [_walk(stroke, spacing) for stroke in strokes]
    t = np.concatenate([np.empty(0), *(walk[0] for walk in walks)])
    dots = np.concatenate([np.empty((0, 2)), *(walk[1] for walk in walks)])
    first = np.concatenate([np.empty(0, bool), *(np.arange(len(walk[0])) == 0 for walk in walks)])
    vertices, faces = _mesh(dots, first, width, height)
    return Ribbon(locked(t), locked(dots), locked(first, bool), locked(vertices), locked(faces, np.uint32))


def inked(motion: Motion) -> tuple[Trajectory, ...]:
    """What the nib writes, stroke by stroke: its path on the page wherever the pen is down, from time 0."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], motion.pen_down, [False]]).astype(int)))
    on_page = motion.page.to_page(motion.tip)[:, :2]
    t = motion.t - motion.t[0]
    pieces = ((start, stop) for start, stop in edges.reshape(-1, 2) if stop - start > 1)
    return tuple(Trajectory(t[start:stop], on_page[start:stop]) for start, stop in pieces)


def _walk(stroke: Trajectory, spacing: float) -> tuple[Array, Array]:
    """Dots at equal distances along a stroke, with the time at which the pen comes to each; a stroke at rest is one."""
    way = np.concatenate([[0.0], np.linalg.norm(np.diff(stroke.position, axis=0), axis=1).cumsum()])
    way, moved = np.unique(way, return_index=True)
    dots = np.linspace(0.0, way[-1], max(1, int(np.ceil(way[-1] / spacing)) + 1)) if way[-1] > 0 else way[:1]
    columns = [np.interp(dots, way, stroke.position[moved, column]) for column in range(2)]
    return np.interp(dots, way, stroke.t[moved]), np.column_stack(columns)


def _mesh(dots: Array, first: Array, width: float, height: float) -> tuple[Array, Array]:
    """For each dot 4 corners of the piece that leads to it (none, at the start of a stroke) and the dot's own."""
    before = np.where(first[:, None], dots, np.roll(dots, 1, axis=0))
    along = dots - before
    length = np.linalg.norm(along, axis=1, keepdims=True)
    side = np.divide(along, length, out=np.zeros_like(along), where=length > 0)[:, ::-1] * (-width / 2, width / 2)
    angles = 2 * np.pi * (np.arange(CORNERS) + 0.5) / CORNERS
    corner = width / 2 * np.column_stack([np.cos(angles), np.sin(angles)])
    piece = np.stack([before - side, dots - side, dots + side, before + side], axis=1)
    flat = np.concatenate([piece, dots[:, None] + corner], axis=1)
    vertices = np.concatenate([flat, np.full((*flat.shape[:2], 1), height)], axis=2).reshape(-1, 3)
    fan = [(4, 4 + k, 5 + k) for k in range(1, CORNERS - 1)]
    pattern = np.array([(0, 1, 2), (0, 2, 3), *fan])
    faces = (pattern + (4 + CORNERS) * np.arange(len(dots))[:, None, None]).reshape(-1, 3)
    return vertices, faces
