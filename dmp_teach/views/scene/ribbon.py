"""Ink as a mesh: WebGL's lines are one pixel wide, so a stroke is a ribbon of triangles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import Motion
from dmp_teach.trajectory import Array, Trajectory, path_length
from dmp_teach.values import locked
from dmp_teach.views.scene.packing import Faces

DOT_CORNERS = 8

MAX_DOTS = 2000
"""Dots of a ribbon: a long text is drawn a little less round, so that its file stays small."""

_SHARP_BEND = np.radians(20)
_TINY_STEP = 1e-12


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
    first: NDArray[np.bool_]
    vertices: Array
    faces: Faces
    ends: NDArray[np.int_]
    owners: NDArray[np.int_]

    def triangles(self, t: float) -> int:
        """Return how many triangles are drawn at time `t` [s]: those of every dot reached."""
        reached = int(np.searchsorted(self.t, t + 1e-9, side="right"))
        return int(self.ends[reached - 1]) if reached else 0


def build_ribbon(
    strokes: Sequence[Trajectory],
    width: float | Callable[[Array], Array],
    height: float,
    spacing: float = 0.0007,
    max_dots: int = MAX_DOTS,
) -> Ribbon:
    """Build the mesh of some strokes; without strokes it is empty.

    Args:
        strokes: 2-D, in the page's frame, one after the other in time [s], [m].
        width: Of the ribbon [m]; or what gives it at times (P,) [s].
        height: Over the paper [m].
        spacing: Between two dots [m]; wider where there would be more than `max_dots`.
        max_dots: Dots in all, or a few more.
    """
    spacing = max(spacing, sum(path_length(stroke.position) for stroke in strokes) / max_dots)
    walks = [_space_dots(stroke, spacing) for stroke in strokes]
    t = np.concatenate([np.empty(0), *(times for times, _ in walks)])
    dots = np.concatenate([np.empty((0, 2)), *(places for _, places in walks)])
    first = np.concatenate([np.empty(0, bool), *(np.arange(len(times)) == 0 for times, _ in walks)])
    widths = width(t) if callable(width) else np.full(len(t), width)
    vertices, faces, ends, owners = _build_mesh(dots, first, widths, height)
    return Ribbon(
        locked(t),
        locked(dots),
        locked(first, bool),
        locked(vertices),
        locked(faces, np.uint32),
        locked(ends, int),
        locked(owners, int),
    )


def find_pen_down_rows(motion: Motion) -> NDArray[np.int_]:
    """Return the first row of each interval with the pen down, and the first after it (K, 2)."""
    flags = np.concatenate([[False], motion.pen_down, [False]])
    return np.flatnonzero(flags[1:] != flags[:-1]).reshape(-1, 2)


def find_inked_strokes(motion: Motion) -> tuple[Trajectory, ...]:
    """Return the nib's path on the page wherever the pen is down, from time 0."""
    on_page = motion.page.to_page(motion.tip)[:, :2]
    t = motion.t - motion.t[0]
    return tuple(
        Trajectory(t[start:stop], on_page[start:stop])
        for start, stop in find_pen_down_rows(motion)
        if stop - start > 1
    )


def _space_dots(stroke: Trajectory, spacing: float) -> tuple[Array, Array]:
    """Return dots at equal arc lengths and the pen's times there; one for a pen at rest."""
    steps = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
    # A pen at rest moves by a tiny step, so that its way always grows.
    way = np.concatenate([[0.0], (steps + _TINY_STEP).cumsum()])
    count = int(np.ceil(way[-1] / spacing)) + 1 if way[-1] > 1e-6 else 1
    places = np.linspace(0.0, way[-1], count)
    columns = [np.interp(places, way, stroke.position[:, column]) for column in range(2)]
    return np.interp(places, way, stroke.t), np.column_stack(columns)


def _build_mesh(
    dots: Array, first: NDArray[np.bool_], widths: Array, height: float
) -> tuple[Array, Faces, NDArray[np.int_], NDArray[np.int_]]:
    """Return vertices, faces, ends and owners of a ribbon.

    Corners 0 and half of a dot stand square to the line: between them lie the pieces. Whole dots
    are drawn at ends and where the line bends, so that these are round.
    """
    along = np.where(
        first[:, None], np.roll(dots, -1, axis=0) - dots, dots - np.roll(dots, 1, axis=0)
    )
    heading = np.arctan2(along[:, 1], along[:, 0])
    bend = np.abs(np.angle(np.exp(1j * (np.roll(heading, -1) - heading)))) > _SHARP_BEND
    whole = first | np.roll(first, -1) | bend
    turns = 2 * np.pi * np.arange(DOT_CORNERS) / DOT_CORNERS
    angles = heading[:, None] + np.pi / 2 + turns
    directions = np.stack([np.cos(angles), np.sin(angles)], axis=2)
    flat = dots[:, None] + widths[:, None, None] / 2 * directions
    corners = np.concatenate([flat, np.full((*flat.shape[:2], 1), height)], axis=2)
    half = DOT_CORNERS // 2
    kept = whole[:, None] | (np.arange(DOT_CORNERS) % half == 0)
    number = np.cumsum(kept).reshape(kept.shape) - 1
    here = number[:, (0, half)].T
    there = np.where(first, here, np.roll(here, 1, axis=1))
    piece = [[here[0], there[0], there[1]], [here[0], there[1], here[1]]]
    fan = [[number[:, 0], number[:, k], number[:, k + 1]] for k in range(1, DOT_CORNERS - 1)]
    faces = np.array(piece + fan).transpose(2, 0, 1)
    drawn = whole[:, None] | (np.arange(DOT_CORNERS) < len(piece))
    return corners[kept], faces[drawn], drawn.sum(axis=1).cumsum(), kept.nonzero()[0]
