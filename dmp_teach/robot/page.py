"""The sheet of paper, as the robot sees it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import PageError
from dmp_teach.trajectory import Array, locked

A4 = (0.210, 0.297)

# Columns: the page's right, its up, and out of the paper, in the world.
_TABLE = locked([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
_BOARD = locked([[0, 0, -1], [-1, 0, 0], [0, 1, 0]])


@dataclass(frozen=True, eq=False)
class Page:
    """A sheet in the robot's world: origin at its centre, x right, y up the page, z out of the paper.

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
        """Copy, check and lock."""
        X = _four_by_four(self.X_world_page)
        R = X[:3, :3]
        rigid = np.allclose(R.T @ R, np.eye(3), atol=1e-9) and np.linalg.det(R) > 0
        if not rigid or not np.allclose(X[3], (0, 0, 0, 1)):
            raise PageError("X_world_page must be a rigid pose: a rotation, a place, and 0 0 0 1 in its last row.")
        if np.abs(X[:3, 3]).max() > 10:
            place = ", ".join(f"{value:g}" for value in X[:3, 3])
            raise PageError(
                f"The page's centre is at ({place}) m, 10 m or more from the robot; is that in millimetres?"
            )
        for name, value in (("width", self.width), ("height", self.height)):
            if not (np.isfinite(value) and 0.01 <= value <= 2.0):
                raise PageError(f"The page's {name} is {value} m, but must be between 0.01 and 2 m.")
        object.__setattr__(self, "X_world_page", locked(X))

    @classmethod
    def table(
        cls,
        x: float = 0.70,
        y: float = 0.0,
        z: float = 0.72,
        width: float = A4[0],
        height: float = A4[1],
    ) -> "Page":
        """A sheet flat on a table: its right is the world's -y, its up is +x [m]."""
        return cls(_pose(_TABLE, (x, y, z)), width, height)

    @classmethod
    def board(
        cls,
        x: float = 0.90,
        y: float = 0.0,
        z: float = 1.10,
        width: float = A4[0],
        height: float = A4[1],
    ) -> "Page":
        """A sheet on a whiteboard that faces the robot: its right is the world's -y, its up is +z [m]."""
        return cls(_pose(_BOARD, (x, y, z)), width, height)

    @property
    def kind(self) -> str | None:
        """How it lies: "table", "board", or None for any other way."""
        for kind, pose in (("table", _TABLE), ("board", _BOARD)):
            if np.allclose(self.X_world_page[:3, :3], pose, atol=1e-9):
                return kind
        return None

    @property
    def size(self) -> Array:
        """Width and height, shape (2,) [m]."""
        return np.array([self.width, self.height], dtype=float)

    def moved(self, shift: ArrayLike) -> "Page":
        """The same sheet, its centre shifted by (3,) in the world [m]."""
        X = self.X_world_page.copy()
        X[:3, 3] += np.asarray(shift, dtype=float)
        return Page(X, self.width, self.height)

    def __repr__(self) -> str:
        """What one types to get it."""
        sheet = "" if tuple(self.size) == A4 else f", width={self.width:g}, height={self.height:g}"
        if self.kind is None:
            return f"Page(X_world_page={np.round(self.X_world_page, 4).tolist()}{sheet})"
        standard = getattr(Page, self.kind)().X_world_page[:3, 3]
        moved = zip("xyz", self.X_world_page[:3, 3], standard, strict=True)
        where = ", ".join(f"{axis}={value:.4g}" for axis, value, usual in moved if abs(value - usual) > 1e-9)
        return f"Page.{self.kind}({(where + sheet).removeprefix(', ')})"

    @property
    def normal(self) -> Array:
        """Out of the paper, in the world, shape (3,)."""
        return self.X_world_page[:3, 2]

    def to_world(self, points: ArrayLike) -> Array:
        """Points of the page, (..., 2) or (..., 3) with a height over the paper, in the world (..., 3) [m]."""
        points = np.asarray(points, dtype=float)
        R, centre = self.X_world_page[:3, :3], self.X_world_page[:3, 3]
        return points @ R[:, : points.shape[-1]].T + centre

    def to_page(self, points: ArrayLike) -> Array:
        """Points of the world (..., 3) in the page's frame (..., 3) [m]."""
        R, centre = self.X_world_page[:3, :3], self.X_world_page[:3, 3]
        return (np.asarray(points, dtype=float) - centre) @ R


def _four_by_four(values: ArrayLike) -> Array:
    """`values` as a (4, 4) array of finite numbers, or a sentence that says what they are."""
    try:
        X = np.array(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise PageError(f"X_world_page must be 4 by 4 numbers, but: {error}.") from None
    if X.shape != (4, 4) or not np.isfinite(X).all():
        raise PageError(f"X_world_page has shape {X.shape}, but must be 4 by 4 finite numbers.")
    return X


def _pose(R_world_page: Array, centre: ArrayLike) -> Array:
    """A pose (4, 4) from a turn (3, 3) and a place (3,) [m]."""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = R_world_page, centre
    return X
