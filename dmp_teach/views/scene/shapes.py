"""What stands around the robot: the sheet, the table or the board that carries it, and the floor."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.robot import Page
from dmp_teach.trajectory import Array, locked

PAPER = (1.0, 0.992, 0.965, 1.0)
WOOD = (0.80, 0.62, 0.42, 1.0)
WOOD_EDGE = (0.66, 0.49, 0.32, 1.0)
STEEL = (0.45, 0.47, 0.50, 1.0)
BOARD = (0.78, 0.81, 0.84, 1.0)

LIGHTS = (
    ("/Grid", "visible", False),
    ("/Axes", "visible", False),
    ("/Lights/SpotLight", "visible", True),
    ("/Lights/SpotLight/<object>", "intensity", 0.40),
    ("/Lights/SpotLight/<object>", "penumbra", 0.6),
    ("/Lights/SpotLight/<object>", "castShadow", True),
    ("/Lights/PointLightNegativeX", "visible", False),
    ("/Lights/PointLightPositiveX", "visible", False),
    ("/Lights/AmbientLight/<object>", "intensity", 0.58),
    ("/Lights/FillLight/<object>", "intensity", 0.22),
)
"""Of the things that meshcat's viewer starts with: a lamp with soft shadows, light from all sides, no grid, no axes."""

_MARGIN = 0.10
_THICK = 0.022


@dataclass(frozen=True, eq=False)
class Shape:
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
    faces: Array
    color: tuple[float, float, float, float]

    def moved(self, X: Array) -> Shape:
        """The same, at the pose `X` (4, 4)."""
        R = X[:3, :3]
        return Shape(
            self.name, self.vertices @ R.T + X[:3, 3], self.normals @ R.T, self.faces, self.color
        )


def around(page: Page) -> tuple[Shape, ...]:
    """The sheet and what carries it: a wooden table, or a board on two posts where the page is steep."""
    flat = page.normal[2] > 0.5
    width, height = page.width + 2 * _MARGIN, page.height + 2 * _MARGIN
    inset, under = 0.05, -0.003 - _THICK
    sheet = slab("page", (page.width, page.height), (-0.0012, 0.0), 0.0, PAPER)
    top = slab("top", (width, height), (under, -0.003), 0.03, WOOD if flat else BOARD)
    rail_size, rail_z = (width - inset, height - inset), (-0.06 if flat else -0.04, under)
    rail = slab("rail", rail_size, rail_z, 0.01, WOOD_EDGE if flat else STEEL)
    plates = tuple(shape.moved(page.X_world_page) for shape in (sheet, top, rail))
    return plates + _legs(
        page, width - inset - 0.03, height - inset - 0.03, 0.05 if flat else 0.032
    )


def lamp(page: Page) -> Array:
    """Where the lamp hangs: high, on the left, and always before the page, shape (3,) [m]."""
    return 2.2 * page.normal + (0.3, 1.8, 2.2)


def _legs(page: Page, width: float, height: float, behind: float) -> tuple[Shape, ...]:
    """A round steel leg under every corner, down to the floor; none where a corner is under the floor."""
    corners = [(sx * width / 2, sy * height / 2, -behind) for sx in (-1, 1) for sy in (-1, 1)]
    tops = page.to_world(corners)
    return tuple(
        leg(f"leg{number}", top, 0.014) for number, top in enumerate(tops) if top[2] > 0.03
    )


def slab(
    name: str, size: tuple[float, float], z: tuple[float, float], radius: float, color: tuple
) -> Shape:
    """A plate with rounded corners, flat in x and y, from the lower to the upper `z` [m]."""
    outline, sideways = _rounded(*size, radius)
    return _prism(name, (outline, sideways), z, color)


def leg(name: str, top: Array, radius: float) -> Shape:
    """A round post from the floor to `top` (3,) [m]."""
    angles = np.linspace(0, 2 * np.pi, 20, endpoint=False)
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    return _prism(name, (top[:2] + radius * circle, circle), (0.0, top[2]), STEEL)


def floor(radius: float = 2.0) -> Shape:
    """A disc that only shows the shadows which fall on it."""
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    rim = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(48)])
    faces = np.column_stack([np.zeros(48, int), np.arange(1, 49), np.roll(np.arange(1, 49), -1)])
    up = np.tile((0.0, 0.0, 1.0), (49, 1))
    return Shape(
        "floor", locked(np.vstack([np.zeros(3), radius * rim])), up, faces, (0.0, 0.0, 0.0, 0.16)
    )


def _rounded(width: float, height: float, radius: float) -> tuple[Array, Array]:
    """The outline of a rounded rectangle, counter-clockwise, and its normals, both (P, 2)."""
    turn = np.linspace(0, np.pi / 2, 7 if radius > 0 else 2)
    points, normals = [], []
    for quarter, (sx, sy) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
        angles = turn + quarter * np.pi / 2
        outward = np.column_stack([np.cos(angles), np.sin(angles)])
        normals.append(outward)
        points.append((sx * (width / 2 - radius), sy * (height / 2 - radius)) + radius * outward)
    return np.vstack(points), np.vstack(normals)


def _prism(name: str, around: tuple[Array, Array], z: tuple[float, float], color: tuple) -> Shape:
    """An outline (P, 2) with its normals (P, 2), counter-clockwise and convex, pulled up from `z` to `z` [m]."""
    outline, sideways = around
    count = len(outline)
    bottom, top = (np.column_stack([outline, np.full(count, height)]) for height in z)
    wall_normals = np.column_stack([sideways, np.zeros(count)])
    up = np.tile((0.0, 0.0, 1.0), (count, 1))
    vertices = np.vstack([bottom, top, bottom, top])
    normals = np.vstack([wall_normals, wall_normals, -up, up])
    here, after = np.arange(count), np.roll(np.arange(count), -1)
    walls = np.vstack(
        [
            np.column_stack([here, after, after + count]),
            np.column_stack([here, after + count, here + count]),
        ]
    )
    fan = np.column_stack([np.zeros(count - 2, int), np.arange(1, count - 1), np.arange(2, count)])
    faces = np.vstack([walls, fan[:, ::-1] + 2 * count, fan + 3 * count])
    return Shape(name, locked(vertices), locked(normals), locked(faces, np.uint32), color)
