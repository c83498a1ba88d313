"""Whether the joints' motors are strong enough for a motion."""

from __future__ import annotations

import numpy as np

from dmp_teach.robot.arm import torques
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.motion import Motion


def too_heavy(motion: Motion, model: Model) -> tuple[str, ...]:
    """A sentence for each joint that needs more than its motor gives: when, how much, and what to change."""
    limits = np.array([model.joint(name).effort for name in motion.joint_names])
    share = np.abs(motion.torque) / limits
    return tuple(
        _told(motion, joint, limits[joint]) for joint in np.flatnonzero(share.max(axis=0) > 1)
    )


def _told(motion: Motion, joint: int, limit: float) -> str:
    """The sentence for one joint, about the moment at which it needs most."""
    row = int(np.abs(motion.torque[:, joint]).argmax())
    q = motion.q[row : row + 1]
    needed, weight = (
        abs(motion.torque[row, joint]),
        abs(torques(q, 0 * q, 0 * q, motion.joint_names)[0, joint]),
    )
    unit = "N" if motion.joint_names[joint] == "torso_lift_joint" else "N m"
    if weight < limit:
        # what is not weight goes with the square of the speed
        longer = np.ceil(10 * np.sqrt((needed - weight) / (limit - weight))) / 10
        cure = f"Write slower: there the pen must take {longer:g} times as long"
    else:
        cure = "The weight of the arm alone is too much: move the page nearer"
    name = motion.joint_names[joint]
    return f"{name} needs {needed:.1f} {unit} after {motion.t[row]:.2f} s, but its motor gives {limit:g} {unit}. {cure}."
