"""What a pen's speed and acceleration ask of the Fetch's joints, told from its model alone (no PlaCo).

    v = J(q) q'           the fastest joints' limits weigh most: q' = W^2 J^T (J W^2 J^T)^-1 v, W = diag(limits)
    tau = M(q) q''        M: the masses of the links as points at their centres, gravity left out

At the posture of the arm over a table. The rows of J are the pen tip's velocity and the leaning of the pen. The torso
stays, as it does in `Fetch().write`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from xml.etree import ElementTree as ET

import numpy as np

from dmp_teach.robot import JOINTS, START_POSTURES, Model
from dmp_teach.trajectory import Array, Trajectory, locked

ARM = JOINTS[1:]
STEP = 1e-5  # of the difference quotients [rad]
TABLE = np.array(
    [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]]
)  # right on the page is the world's -y, up is its +x


@dataclass(frozen=True, eq=False)
class ArmAtTable:
    """The arm over a table.

    Args:
        speed: Parts of the joints' speed limits for a pen velocity of 1 m/s along x or y of the page, shape (7, 2).
        effort: Parts of their torque limits for a pen acceleration of 1 m/s2, shape (7, 2).
    """

    speed: Array
    effort: Array

    def asked(self, path: Trajectory) -> tuple[float, float]:
        """The greatest part of any joint's speed limit, and of any torque limit, that a path on the page asks for.

        Args:
            path: 2-D [m].
        """
        velocity = np.gradient(path.position, path.t, axis=0)
        acceleration = np.gradient(velocity, path.t, axis=0)
        return float(np.abs(velocity @ self.speed.T).max()), float(
            np.abs(acceleration @ self.effort.T).max()
        )


def greatest_acceleration(path: Trajectory) -> float:
    """The greatest acceleration along a path [m/s2]."""
    velocity = np.gradient(path.position, path.t, axis=0)
    return float(np.linalg.norm(np.gradient(velocity, path.t, axis=0), axis=1).max())


@cache
def arm_at_table() -> ArmAtTable:
    """The arm of `assets/fetch.urdf` in its posture over a table."""
    model, q = Model.load(), np.asarray(START_POSTURES[0])
    limits = np.array([(joint.velocity, joint.effort) for joint in map(model.joint, ARM)])
    moved = q + STEP * np.vstack([np.zeros((1, len(JOINTS))), np.eye(len(JOINTS))[1:]])
    poses = model.link_poses(moved, JOINTS)
    tip = poses["pen_tip"]
    J = np.vstack([_rate(tip[:, :3, 3]), _rate(tip[:, :2, 2])])  # the pen's axis may not lean
    W2 = np.diag(limits[:, 0] ** 2)
    joints = W2 @ J.T @ np.linalg.inv(J @ W2 @ J.T) @ np.vstack([TABLE.T, np.zeros((2, 2))])
    M = np.zeros((len(ARM), len(ARM)))
    for link, (mass, centre) in _masses(model).items():
        Jc = _rate(poses[link][:, :3, :3] @ centre + poses[link][:, :3, 3])
        M += mass * Jc.T @ Jc
    return ArmAtTable(locked(joints / limits[:, :1]), locked(M @ joints / limits[:, 1:]))


def _rate(values: Array) -> Array:
    """How `values` (1 + 7, K), the first at the posture, change with each joint, shape (K, 7)."""
    return (values[1:] - values[0]).T / STEP


def _masses(model: Model) -> dict[str, tuple[float, Array]]:
    """Mass [kg] and centre of mass in the link's frame (3,) [m] of every link that has one."""
    found = {}
    for link in ET.parse(model.path).getroot().iter("link"):
        inertial = link.find("inertial")
        if inertial is not None:
            origin = inertial.find("origin")
            centre = "0 0 0" if origin is None else origin.get("xyz", "0 0 0")
            found[link.get("name")] = (
                float(inertial.find("mass").get("value")),
                np.array(centre.split(), float),
            )
    return found
