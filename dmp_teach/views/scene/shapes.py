"""What stands around the robot: the sheet, the table or board that carries it, and the floor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.robot import Page
from dmp_teach.trajectory import Array
from dmp_teach.values import locked
from dmp_teach.views.scene.packing import Faces

Rgba = tuple[float, float, float, float]

PAPER_RGBA = (1.0, 0.992, 0.965, 1.0)
WOOD_RGBA = (0.80, 0.62, 0.42, 1.0)
WOOD_EDGE_RGBA = (0.66, 0.49, 0.32, 1.0)
STEEL_RGBA = (0.45, 0.47, 0.50, 1.0)
BOARD_RGBA = (0.62, 0.67, 0.72, 1.0)
SHADOW_RGBA = (0.0, 0.0, 0.0, 0.16)

_MARGIN_OF_TABLE = 0.10
_PLATE_TOP = -0.003
_PLATE_BOTTOM = _PLATE_TOP - 0.022
_RAIL_INSET = 0.05


@dataclass(frozen=True, eq=False)
class ColoredMesh:
    """A mesh of one colour, in the world.

    Args:
        name: Short, and different from all others.
        vertices: Shape (V, 3) [m].
        normals: Unit vectors out of the surface, shape (V, 3).
        faces: Counter-clockwise seen from outside, shape (F, 3).
        color: Red, green, blue and opacity between 0 and 1.
    """

    name: str
    vertices: Array
    normals: Array
    faces: Faces
    color: Rgba

    def moved(self, X: Array) -> ColoredMesh:
        """Return the same shape at the pose `X` (4, 4)."""
        R = X[:3, :3]
        vertices = self.vertices @ R.T + X[:3, 3]
        return ColoredMesh(self.name, vertices, self.normals @ R.T, self.faces, self.color)


def build_surroundings(page: Page) -> tuple[ColoredMesh, ...]:
    """Build the sheet and what carries it: a wooden table, or a board where the page is steep."""
    is_table = page.normal[2] > 0.5
    width = page.width + 2 * _MARGIN_OF_TABLE
    height = page.height + 2 * _MARGIN_OF_TABLE
    rail_size = (width - _RAIL_INSET, height - _RAIL_INSET)
    rail_z = (-0.06 if is_table else -0.04, _PLATE_BOTTOM)
    plates = (
        _build_slab("page", (page.width, page.height), (-0.0012, 0.0), 0.0, PAPER_RGBA),
        _build_slab(
            "top",
            (width, height),
            (_PLATE_BOTTOM, _PLATE_TOP),
            0.03,
            WOOD_RGBA if is_table else BOARD_RGBA,
        ),
        _build_slab("rail", rail_size, rail_z, 0.01, WOOD_EDGE_RGBA if is_table else STEEL_RGBA),
    )
    legs = _build_legs(page, rail_size[0] - 0.03, rail_size[1] - 0.03, 0.05 if is_table else 0.032)
    return (*(plate.moved(page.X_world_page) for plate in plates), *legs)


def place_lamp(page: Page) -> Array:
    """Return where the lamp hangs: high, left and before the page, shape (3,) [m]."""
    return 2.2 * page.normal + (-0.4, 0.6, 2.2)


def build_floor(radius: float = 2.0) -> ColoredMesh:
    """Build a disc that only shows the shadows which fall on it."""
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    rim = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(48)])
    vertices = locked(np.vstack([np.zeros(3), radius * rim]))
    corners = np.arange(1, 49)
    faces = np.column_stack([np.zeros(48, int), corners, np.roll(corners, -1)])
    return ColoredMesh("floor", vertices, np.tile((0.0, 0.0, 1.0), (49, 1)), faces, SHADOW_RGBA)


def _build_legs(page: Page, width: float, height: float, behind: float) -> tuple[ColoredMesh, ...]:
    """Build a round leg under every corner down to the floor, if the corner is above it."""
    corners = [(sx * width / 2, sy * height / 2, -behind) for sx in (-1, 1) for sy in (-1, 1)]
    angles = np.linspace(0, 2 * np.pi, 20, endpoint=False)
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    return tuple(
        _build_prism(f"leg{number}", top[:2] + 0.014 * circle, circle, (0.0, top[2]), STEEL_RGBA)
        for number, top in enumerate(page.to_world(corners))
        if top[2] > 0.03
    )


def _build_slab(
    name: str, size: tuple[float, float], z: tuple[float, float], radius: float, color: Rgba
) -> ColoredMesh:
    """Build a plate with rounded corners, flat in x and y, from the lower to the upper `z` [m]."""
    turn = np.linspace(0, np.pi / 2, 7 if radius > 0 else 2)
    points, normals = [], []
    for quarter, (sx, sy) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
        angles = turn + quarter * np.pi / 2
        outward = np.column_stack([np.cos(angles), np.sin(angles)])
        normals.append(outward)
        points.append((sx * (size[0] / 2 - radius), sy * (size[1] / 2 - radius)) + radius * outward)
    return _build_prism(name, np.vstack(points), np.vstack(normals), z, color)


def _build_prism(
    name: str, outline: Array, sideways: Array, z: tuple[float, float], color: Rgba
) -> ColoredMesh:
    """Pull a convex outline (P, 2) with its normals (P, 2) from the lower to the upper `z` [m]."""
    count = len(outline)
    bottom, top = (np.column_stack([outline, np.full(count, height)]) for height in z)
    wall_normals = np.column_stack([sideways, np.zeros(count)])
    up = np.tile((0.0, 0.0, 1.0), (count, 1))
    vertices = np.vstack([bottom, top, bottom, top])
    normals = np.vstack([wall_normals, wall_normals, -up, up])
    here = np.arange(count)
    after = np.roll(here, -1)
    lower_walls = np.column_stack([here, after, after + count])
    upper_walls = np.column_stack([here, after + count, here + count])
    fan = np.column_stack([np.zeros(count - 2, int), np.arange(1, count - 1), np.arange(2, count)])
    faces = np.vstack([lower_walls, upper_walls, fan[:, ::-1] + 2 * count, fan + 3 * count])
    return ColoredMesh(name, locked(vertices), locked(normals), locked(faces, np.uint32), color)
