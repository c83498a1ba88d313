"""The torques and masses of the robot with some joints that move and all others held at rest."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from dmp_teach.files import ASSETS
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.model.rotation import cross, rotate
from dmp_teach.robot.model.urdf import Body, read_bodies
from dmp_teach.trajectory import Array

_GRAVITY = np.array([0, 0, 0, 0, 0, 9.81])
"""A robot that stands feels as one that is accelerated upwards [m/s^2]."""


class ReducedRobot:
    """The robot with some joints that move and all others held at rest.

    Where `pen_slide_joint` is among them, the pen is the sprung one.

    Raises:
        JointError: A joint that the robot does not have.
    """

    def __init__(self, joint_names: Sequence[str]) -> None:
        path = ASSETS / ("fetch_sprung.urdf" if "pen_slide_joint" in joint_names else "fetch.urdf")
        self._model = Model.load(path)
        self._names = tuple(joint_names)
        self._joints = [self._model.joint(name) for name in joint_names]
        self._bodies = self._melt(read_bodies(path))

    def _melt(self, bodies: dict[str, Body]) -> dict[tuple[int, ...], tuple[str, Body]]:
        """Return what moves as one: by the joints that carry it, its first link and its body."""
        carriers: dict[str, tuple[int, ...]] = {self._model.root: ()}
        for joint in self._model.joints:
            own = (self._names.index(joint.name),) if joint.name in self._names else ()
            carriers[joint.child] = carriers[joint.parent] + own
        poses = self._model.link_poses(np.zeros(len(self._names)), self._names)
        melted = {}
        for joint in self._joints:
            columns = carriers[joint.child]
            back = np.linalg.inv(poses[joint.child][0])
            parts = [
                bodies[link].seen_from(back @ poses[link][0])
                for link in bodies
                if carriers[link] == columns
            ]
            melted[columns] = joint.child, Body.joined(parts)
        return dict(sorted(melted.items(), key=lambda item: len(item[0])))

    def torques(self, q: Array, v: Array, a: Array) -> Array:
        """Return the torques (T, J) [N m, N] of positions, velocities and accelerations (T, J).

        M(q) a + C(q, v) v + g(q), by the recursive Newton-Euler algorithm (Featherstone 2008, table
        5.1), without friction and with the pen in the air. All vectors are spatial ones at the
        origin of the world, turning first, for all samples at once (T, 6).
        """
        poses = self._model.link_poses(q, self._names)
        still = np.zeros((len(q), 6))
        moves: dict[tuple[int, ...], tuple[Array, Array]] = {(): (still, still + _GRAVITY)}
        axes = {}
        needed = np.zeros(np.shape(v))
        for carriers, (link, body) in self._bodies.items():
            V, A = moves[carriers[:-1]]
            column = carriers[-1]
            joint = self._joints[column]
            S = axes[column] = _axis(poses[link], joint.axis, joint.type == "prismatic")
            A = A + a[:, column, None] * S + v[:, column, None] * _carried(V, S)
            V = V + v[:, column, None] * S
            moves[carriers] = V, A
            force = _force(poses[link], body, V, A)
            for number in carriers:
                needed[:, number] += np.einsum("ti,ti->t", axes[number], force)
        return needed

    def inertia(self, q: Array) -> Array:
        """Return the mass matrix at each position (T, J), (T, J, J) [kg m^2, kg m, kg]."""
        still = np.zeros(q.shape)
        held = self.torques(q, still, still)
        pushes = np.eye(q.shape[1])
        return np.stack([self.torques(q, still, still + each) - held for each in pushes], axis=2)


@lru_cache(maxsize=4)
def load_reduced_robot(joint_names: tuple[str, ...]) -> ReducedRobot:
    """Return the robot that moves only in some joints, built once."""
    return ReducedRobot(joint_names)


def _axis(X: Array, axis: Array, slides: bool) -> Array:
    """Return the velocity of all that a joint carries where it moves by 1 a second (T, 6)."""
    along = X[:, :3, :3] @ axis
    return np.hstack([0 * along, along] if slides else [along, cross(X[:, :3, 3], along)])


def _carried(V: Array, S: Array) -> Array:
    """Return how an axis S (T, 6) changes that is carried at velocity V (T, 6), (T, 6)."""
    turning, sliding = V[:, :3], V[:, 3:]
    turned = cross(turning, S[:, 3:]) + cross(sliding, S[:, :3])
    return np.hstack([cross(turning, S[:, :3]), turned])


def _force(X: Array, body: Body, V: Array, A: Array) -> Array:
    """Return what moves a body so: the moment about the world's origin and the force (T, 6)."""
    R = X[:, :3, :3]
    back = np.swapaxes(R, 1, 2)
    place = R @ body.centre + X[:, :3, 3]
    turning = V[:, :3]
    spin = rotate(R, rotate(back, turning) @ body.inertia)
    spun = rotate(R, rotate(back, A[:, :3]) @ body.inertia)
    speed = V[:, 3:] + cross(turning, place)
    force = body.mass * (A[:, 3:] + cross(A[:, :3], place) + cross(turning, speed))
    return np.hstack([spun + cross(turning, spin) + cross(place, force), force])
