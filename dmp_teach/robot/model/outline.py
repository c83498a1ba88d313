"""The robot as it is seen from above."""

from __future__ import annotations

from functools import cache

import numpy as np

from dmp_teach.robot.model.kinematics import Model
from dmp_teach.trajectory import Array
from dmp_teach.values import locked

ROBOT_PARTS = (
    ("base_link", "l_wheel_link", "r_wheel_link"),
    ("torso_fixed_link", "torso_lift_link"),
    ("head_pan_link", "head_tilt_link"),
)
"""Links that make one outline each: the base, the torso, the head."""


@cache
def outline_from_above(links: tuple[str, ...]) -> Array:
    """Return the hull of some links' shells, seen from above, shape (n, 2) [m]."""
    model = Model.load()
    poses = model.link_poses(np.empty((1, 0)), ())
    shells = []
    for piece in model.visuals:
        if piece.link in links:
            X = poses[piece.link][0] @ piece.X_link_visual
            shells.append(piece.vertices @ X[:3, :3].T + X[:3, 3])
    return locked(_hull(np.concatenate(shells)[:, :2]))


def _hull(points: Array) -> Array:
    """Return the convex hull of points (N, 2) counterclockwise, shape (n, 2).

    Two chains from left to right and back (Andrew 1979): a page in the browser draws it before it
    has SciPy.
    """
    hull: list[list[float]] = []
    ordered = np.unique(points, axis=0).tolist()
    for side in (ordered, ordered[::-1]):
        chain: list[list[float]] = []
        for x, y in side:
            while len(chain) > 1:
                (x0, y0), (x1, y1) = chain[-2:]
                if (x1 - x0) * (y - y0) > (y1 - y0) * (x - x0):
                    break
                chain.pop()
            chain.append([x, y])
        hull += chain[:-1]
    return np.array(hull)
