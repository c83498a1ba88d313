"""Joints and ink over time, as tracks of the browser's animation."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import scipy

from dmp_teach.robot import Joint
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.packing import KeyframeTrack
from dmp_teach.views.scene.ribbon import Ribbon
from dmp_teach.views.scene.stage import BROKEN_PEN, load_robot_model

# A pen breaks in that time [s].
SNAP = 0.05


@lru_cache(maxsize=1)
def find_link_paths() -> dict[str, str]:
    """Return where each link stands in the viewer's tree: under the link that carries it."""
    model = load_robot_model()
    paths = {model.root: f"robot/{model.root}"}
    for joint in model.joints:
        paths[joint.child] = f"{paths[joint.parent]}/{joint.child}"
    return paths


def build_joint_track(joint: Joint, times: Array, positions: Array) -> KeyframeTrack:
    """Return how a joint moves its link: positions (K,) [rad or m] at the keys' times (K,) [s]."""
    poses = joint.pose(positions)
    if joint.type == "prismatic":
        return KeyframeTrack("position", "vector3", times, poses[:, :3, 3])
    turns = scipy.spatial.transform.Rotation.from_matrix(poses[:, :3, :3]).as_quat()
    # Steps of 1/65536 are 0.03 mm at the end of the arm, and compress well.
    return KeyframeTrack("quaternion", "quaternion", times, np.rint(turns * 65536) / 65536)


def build_break_track(t: float) -> KeyframeTrack:
    """Return how a pen breaks at a time [s]: it snaps, and hangs in its holder."""
    whole, broken = scipy.spatial.transform.Rotation.from_matrix(
        [np.eye(3), BROKEN_PEN[:3, :3]]
    ).as_quat()
    times = np.array([0.0, t, t + SNAP])
    return KeyframeTrack("quaternion", "quaternion", times, np.array([whole, whole, broken]))


def build_ink_track(ink: Ribbon) -> KeyframeTrack:
    """Return how many corners of triangles are drawn: up to the dot that the pen has reached."""
    times = np.unique(np.append(0.0, ink.t))
    counts = np.array([3 * ink.triangles(t) for t in times])
    return KeyframeTrack("drawRange[count]", "number", times, counts, stepped=True)
