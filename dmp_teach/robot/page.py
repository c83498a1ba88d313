"""The sheet of paper, as the robot sees it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import PageError
from dmp_teach.trajectory import Array, locked

A4 = (0.210, 0.297)


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
        X = np.array(self.X_world_page, dtype=float)
        R = X[:3, :3]
        if X.shape != (4, 4) or not np.isfinite(X).all():
            raise PageError(f"X_world_page has shape {X.shape}, but must be 4 by 4 finite numbers.")
        rigid = np.allclose(R.T @ R, np.eye(3), atol=1e-9) and np.linalg.det(R) > 0
        if not rigid or not np.allclose(X[3], (0, 0, 0, 1)):
            raise PageError("X_world_page must be a rigid pose: a rotation, a place, and 0 0 0 1 in its last row.")
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
        return cls(_pose(right=(0, -1, 0), up=(1, 0, 0), centre=(x, y, z)), width, height)

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
        return cls(_pose(right=(0, -1, 0), up=(0, 0, 1), centre=(x, y, z)), width, height)

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


def _pose(right: ArrayLike, up: ArrayLike, centre: ArrayLike) -> Array:
    """A pose from two directions and a place."""
    X = np.eye(4)
    X[:3, 0], X[:3, 1], X[:3, 3] = right, up, centre
    X[:3, 2] = np.cross(right, up)
    return X
