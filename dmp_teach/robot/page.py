"""The sheet of paper in the robot's world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers, checked
from dmp_teach.errors import PageError, shown
from dmp_teach.trajectory import Array
from dmp_teach.values import Value, locked

A4 = (0.210, 0.297)

# Columns: the page's right, its up, and out of the paper, in the world.
_TABLE = locked([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
_BOARD = locked([[0, 0, -1], [-1, 0, 0], [0, 1, 0]])


@dataclass(frozen=True, eq=False, repr=False)
class Page(Value):
    """A sheet in the robot's world.

    Its origin is at its centre, x points right, y up the page, z out of the paper.

    Args:
        X_world_page: Pose of the page in the world, shape (4, 4) [m].
        width: Along the page's x [m].
        height: Along the page's y [m].

    Raises:
        PageError: A pose that is not a rigid motion, or a size that is not positive.
    """

    X_world_page: Array
    width: float = A4[0]
    height: float = A4[1]

    def __post_init__(self) -> None:
        X = _four_by_four(self.X_world_page)
        R = X[:3, :3]
        rigid = np.allclose(R.T @ R, np.eye(3), atol=1e-9) and np.linalg.det(R) > 0
        if not rigid or not np.allclose(X[3], (0, 0, 0, 1)):
            raise PageError(
                "X_world_page must be a rigid pose: a rotation, a place, and 0 0 0 1 in its last "
                "row."
            )
        if np.abs(X[:3, 3]).max() > 10:
            place = ", ".join(f"{value:g}" for value in X[:3, 3])
            raise PageError(
                f"The page's centre is at ({place}) m, 10 m or more from the robot; is that in "
                "millimetres?"
            )
        for name in ("width", "height"):
            value = check_finite(name, getattr(self, name), "a length in metres, such as 0.21")
            if not 0.01 <= value <= 2.0:
                hint = " Is that in millimetres?" if value >= 10 else ""
                raise PageError(
                    f"The page's {name} is {value:g} m, but must be between 0.01 and 2 m.{hint}"
                )
            object.__setattr__(self, name, value)
        object.__setattr__(self, "X_world_page", X)
        super().__post_init__()

    @classmethod
    @checked
    def table(
        cls,
        x: float = 0.70,
        y: float = 0.0,
        z: float = 0.72,
        width: float = A4[0],
        height: float = A4[1],
        *,
        tilt: float = 0.0,
        turn: float = 0.0,
        yaw: float = 0.0,
    ) -> Page:
        """Lay a sheet on a table or a desk: its right is the world's -y, its up is +x.

        Args:
            x: Where its centre is, ahead of the robot [m].
            y: To the robot's left [m].
            z: Over the floor [m].
            width: Along the page's x: 0.148 for A5 upright, 0.297 for A4 on its side [m].
            height: Along the page's y [m].
            tilt: How far its top is raised, about the page's own x axis [rad].
            turn: How far the sheet is turned on its desk, to the left as one reads it [rad].
            yaw: How far the desk with its sheet is turned about the vertical, to the robot's left
                [rad].

        Raises:
            PageError: What is no number, or so large that it must have been meant in another unit.
        """
        return cls(_pose("table", (x, y, z), tilt, turn, yaw), width, height)

    @classmethod
    @checked
    def board(
        cls,
        x: float = 0.90,
        y: float = 0.0,
        z: float = 1.10,
        width: float = A4[0],
        height: float = A4[1],
        *,
        tilt: float = 0.0,
        turn: float = 0.0,
        yaw: float = 0.0,
    ) -> Page:
        """Hang a sheet on a whiteboard before the robot: its right is the world's -y, its up +z.

        Everything else is as for `table`; a board that leans back has a negative `tilt`.
        """
        return cls(_pose("board", (x, y, z), tilt, turn, yaw), width, height)

    @property
    def kind(self) -> str:
        """Whether it lies more like a sheet on a "table" or on a "board"."""
        return "table" if self.normal[2] > np.sqrt(0.5) else "board"

    @property
    def angles(self) -> tuple[float, float, float]:
        """Its `tilt`, `turn` and `yaw` from a table or board, whichever is its kind [rad]."""
        normal = self.normal
        lean = np.arctan2(np.hypot(normal[0], normal[1]), normal[2])
        yaw = np.arctan2(-normal[1], -normal[0]) if np.sin(lean) > 1e-7 else 0.0
        upright = 0.0 if self.kind == "table" else np.pi / 2
        found = []
        for tilt, about in (
            (lean - upright, yaw),
            (-lean - upright, yaw - np.copysign(np.pi, yaw)),
        ):
            straight = _pose(self.kind, (0, 0, 0), tilt, 0.0, about)[:3, :3]
            across = straight.T @ self.X_world_page[:3, 0]
            found.append((float(tilt), float(np.arctan2(across[1], across[0])), float(about)))
        return min(found, key=lambda angles: sum(map(abs, angles)))

    @property
    def size(self) -> Array:
        """Width and height, shape (2,) [m]."""
        return np.array([self.width, self.height], dtype=float)

    @checked
    def moved(self, shift: ArrayLike) -> Page:
        """Return the same sheet, its centre shifted by (3,) in the world [m]."""
        X = self.X_world_page.copy()
        step = _points("shift", shift, (3,))
        if step.ndim > 1:
            raise PageError(f"shift has shape {step.shape}, but must be 3 numbers [m].")
        X[:3, 3] += step
        return Page(X, self.width, self.height)

    def rounded(self) -> Page:
        """Return the page that one gets by typing what is shown of this one."""
        return getattr(Page, self.kind)(**self._words())

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={value:.7g}" for name, value in self._words().items())
        return f"Page.{self.kind}({words})"

    def _words(self) -> dict[str, float]:
        """Return what to type to get it, to a micrometre, by name."""
        usual = getattr(Page, self.kind)()
        size = (np.inf, np.inf) if tuple(self.size) != A4 else A4
        values = (*self.X_world_page[:3, 3], *self.size, *self.angles)
        usual_values = (*usual.X_world_page[:3, 3], *size, 0.0, 0.0, 0.0)
        names = ("x", "y", "z", "width", "height", "tilt", "turn", "yaw")
        return {
            name: round(float(value), 6)
            for name, value, left_out in zip(names, values, usual_values, strict=True)
            if abs(value - left_out) > 5e-7
        }

    @property
    def normal(self) -> Array:
        """Out of the paper, in the world, shape (3,)."""
        return self.X_world_page[:3, 2]

    @checked
    def to_world(self, points: ArrayLike) -> Array:
        """Return points of the page in the world (..., 3) [m].

        Args:
            points: On the page, (..., 2), or (..., 3) with a height over the paper [m].
        """
        points = _points("points", points, (2, 3))
        X = self.X_world_page
        return points @ X[:3, : points.shape[-1]].T + X[:3, 3]

    @checked
    def to_page(self, points: ArrayLike) -> Array:
        """Return points of the world (..., 3) in the page's frame (..., 3) [m]."""
        X = self.X_world_page
        return (_points("points", points, (3,)) - X[:3, 3]) @ X[:3, :3]


def _points(name: str, values: ArrayLike, widths: tuple[int, ...]) -> Array:
    """Return `values` as points of so many numbers (..., D), or raise a PageError."""
    try:
        found = as_numbers(values)
    except ValueError:
        found = np.empty(0)
    if found.ndim == 0 or found.shape[-1] not in widths:
        many = " or ".join(map(str, widths))
        raise PageError(f"{name} is {shown(values)}, but must be points of {many} numbers [m].")
    return found


def _four_by_four(values: ArrayLike) -> Array:
    """Return `values` as a (4, 4) array of finite numbers, or raise a PageError."""
    try:
        X = as_numbers(values)
    except ValueError as error:
        raise PageError(f"X_world_page must be 4 by 4 numbers, but: {error}.") from None
    if X.shape != (4, 4) or not np.isfinite(X).all():
        raise PageError(f"X_world_page has shape {X.shape}, but must be 4 by 4 finite numbers.")
    return X


def _pose(kind: str, centre: Sequence[float], tilt: float, turn: float, yaw: float) -> Array:
    """Return the pose (4, 4) of a sheet on a table or a board."""
    X = np.eye(4)
    X[:3, 3] = [
        check_finite(name, value, "a place in metres, such as 0.7")
        for name, value in zip("xyz", centre, strict=True)
    ]
    on_the_desk = _turn_about(0, _angle("tilt", tilt)) @ _turn_about(2, _angle("turn", turn))
    flat = _TABLE if kind == "table" else _BOARD
    X[:3, :3] = _turn_about(2, _angle("yaw", yaw)) @ flat @ on_the_desk
    return X


def _turn_about(axis: int, angle: float) -> Array:
    """Return the rotation (3, 3) by an angle [rad] about x (0), y (1) or z (2)."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[[i, j], [i, j]] = np.cos(angle)
    R[j, i] = np.sin(angle)
    R[i, j] = -R[j, i]
    return R


def _angle(name: str, value: float) -> float:
    """Return an angle of at most a whole turn [rad], or raise a PageError."""
    angle = check_finite(name, value, "an angle in radians, such as 0.35")
    if abs(angle) > 2 * np.pi:
        raise PageError(
            f"{name} is {angle:g} rad, more than a whole turn. If that is in degrees, write "
            f"{np.radians(angle):.4g}."
        )
    return angle


def check_page(page: object) -> None:
    """Raise a PageError unless it is a page."""
    if not isinstance(page, Page):
        raise PageError(
            f"page is {shown(page)}, but must be a Page, such as Page.table() or Page.board()."
        )


def check_finite(name: str, value: float, meaning: str) -> float:
    """Return a finite number, or raise a PageError that says what it should be."""
    try:
        found = float(value)
    except (OverflowError, TypeError, ValueError):
        found = np.nan
    if not np.isfinite(found):
        raise PageError(f"{name} is {shown(value)}, but must be {meaning}.")
    return found
