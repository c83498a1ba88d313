"""The demand of a pen's speed and acceleration on the Fetch's joints, from its model alone.

    v = J(q) q'         solved by q' = W^2 J^T (J W^2 J^T)^-1 v with W = diag(limits): the fastest
                        joints move most
    tau = M(q) q''      M: the masses of the links as points at their centres, without gravity

At the posture of the arm over a table. The rows of J are the pen tip's velocity and the leaning of
the pen. The torso stays, as it does in `Fetch().write`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from xml.etree import ElementTree as ET

import numpy as np

from dmp_teach.robot import JOINTS, START_POSTURES, Model
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import locked

ARM_JOINTS = JOINTS[1:]
# Of the difference quotients [rad].
JOINT_STEP = 1e-5
# Right on the page is the world's -y, up is its +x.
PAGE_AXES = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])


@dataclass(frozen=True, eq=False)
class ArmAtTable:
    """The arm over a table: shares of the joints' limits by x and y of the page, shape (7, 2) each.

    Of the speed limits for a pen velocity of 1 m/s, of the torque limits for an acceleration of 1
    m/s2.
    """

    speed: Array
    effort: Array

    def demand(self, path: Trajectory) -> tuple[float, float]:
        """Return the greatest shares of any joint's speed and torque limits along a path [m]."""
        velocity, acceleration = _derivatives(path)
        speed, effort = velocity @ self.speed.T, acceleration @ self.effort.T
        return float(np.abs(speed).max()), float(np.abs(effort).max())


def greatest_acceleration(path: Trajectory) -> float:
    """Return the greatest acceleration along a path [m/s2]."""
    return float(np.linalg.norm(_derivatives(path)[1], axis=1).max())


@cache
def arm_at_table() -> ArmAtTable:
    """Return the arm of `assets/fetch.urdf` in its posture over a table."""
    model, q = Model.load(), np.asarray(START_POSTURES[0])
    limits = np.array([(each.velocity, each.effort) for each in map(model.joint, ARM_JOINTS)])
    moved = q + JOINT_STEP * np.vstack([np.zeros((1, len(JOINTS))), np.eye(len(JOINTS))[1:]])
    poses = model.link_poses(moved, JOINTS)
    tip = poses["pen_tip"]
    # The pen's axis may not lean.
    J = np.vstack([_jacobian(tip[:, :3, 3]), _jacobian(tip[:, :2, 2])])
    W2 = np.diag(limits[:, 0] ** 2)
    joints = W2 @ J.T @ np.linalg.inv(J @ W2 @ J.T) @ np.vstack([PAGE_AXES.T, np.zeros((2, 2))])
    M = np.zeros((len(ARM_JOINTS), len(ARM_JOINTS)))
    for link, mass, centre in _masses(model):
        Jc = _jacobian(poses[link][:, :3, :3] @ centre + poses[link][:, :3, 3])
        M += mass * Jc.T @ Jc
    return ArmAtTable(locked(joints / limits[:, :1]), locked(M @ joints / limits[:, 1:]))


def _derivatives(path: Trajectory) -> tuple[Array, Array]:
    """Return velocity [m/s] and acceleration [m/s2], shape (T, D) each."""
    velocity = np.gradient(path.position, path.t, axis=0)
    return velocity, np.gradient(velocity, path.t, axis=0)


def _jacobian(values: Array) -> Array:
    """Return how `values` (1 + 7, K), the first at the posture, change with the joints, (K, 7)."""
    return (values[1:] - values[0]).T / JOINT_STEP


def _masses(model: Model) -> list[tuple[str, float, Array]]:
    """Return name, mass [kg] and centre of mass in its frame (3,) [m] of every link with a mass."""
    found = []
    for link in ET.parse(model.path).getroot().iter("link"):
        mass, origin = link.find("inertial/mass"), link.find("inertial/origin")
        if mass is not None:
            centre = "0 0 0" if origin is None else origin.get("xyz", "0 0 0")
            place = np.array(centre.split(), float)
            found.append((link.get("name", ""), float(mass.get("value", 0)), place))
    return found
