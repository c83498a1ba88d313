"""How the joints and the ink change over time, in the words of the browser's animation."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.spatial.transform import Rotation

from dmp_teach.robot import Joint
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.packing import Track
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.stage import robot_model


@lru_cache(maxsize=1)
def link_paths() -> dict[str, str]:
    """Where each link stands in the viewer's tree: under the link that carries it."""
    model = robot_model()
    paths = {model.root: f"robot/{model.root}"}
    for joint in model.joints:
        paths[joint.child] = f"{paths[joint.parent]}/{joint.child}"
    return paths


def joint_track(joint: Joint, times: Array, positions: Array) -> Track:
    """How one joint moves its link.

    Args:
        joint: A joint that turns or slides.
        times: Of the keys, shape (K,) [s].
        positions: At the keys, shape (K,) [rad or m].
    """
    poses = joint.pose(positions)
    if joint.type == "prismatic":
        return Track("position", "vector3", times, poses[:, :3, 3])
    return Track("quaternion", "quaternion", times, _rounded(poses[:, :3, :3]))


def _rounded(turns: Array) -> Array:
    """Quaternions x, y, z, w (K, 4) in steps of a part of 65 000: 0.03 mm at the end of the arm, in fewer bytes."""
    return np.rint(Rotation.from_matrix(turns).as_quat() * 65536) / 65536


def ink_track(ink: Ribbon) -> Track:
    """How many corners of triangles are drawn: up to the dot that the pen has reached."""
    times = np.unique(np.append(0.0, ink.t))
    counts = np.array([3 * ink.triangles(t) for t in times])
    return Track("drawRange[count]", "number", times, counts, stepped=True)
