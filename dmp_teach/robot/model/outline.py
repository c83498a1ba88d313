"""The robot as it is seen from above."""

from __future__ import annotations

from functools import cache

import numpy as np
import scipy

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
    points = np.concatenate(shells)[:, :2]
    return locked(points[scipy.spatial.ConvexHull(points).vertices])
