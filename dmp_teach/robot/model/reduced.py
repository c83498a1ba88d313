"""The robot in pinocchio, which PlaCo brings: its masses and its collision shapes.

Neither pinocchio nor coal has types: their modules and values are Any.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from dmp_teach.errors import MissingPartError
from dmp_teach.files import ASSETS
from dmp_teach.robot.model.kinematics import REST, Model
from dmp_teach.trajectory import Array


class ReducedRobot:
    """The robot with some joints that move and all others held at rest.

    Where `pen_slide_joint` is among them, the pen is the sprung one.

    Raises:
        JointError: A joint that the robot does not have.
        MissingPartError: PlaCo, which brings pinocchio, is not on this platform.
    """

    def __init__(self, joint_names: Sequence[str]) -> None:
        self._pinocchio = pinocchio = load_pinocchio()
        path = ASSETS / ("fetch_sprung.urdf" if "pen_slide_joint" in joint_names else "fetch.urdf")
        ours = Model.load(path)
        for name in joint_names:
            ours.joint(name)
        full = pinocchio.buildModelFromUrdf(str(path))
        shapes = pinocchio.buildGeomFromUrdf(full, str(path), pinocchio.GeometryType.COLLISION)
        self.links = [full.frames[shape.parentFrame].name for shape in shapes.geometryObjects]
        rest = pinocchio.neutral(full)
        for name, value in REST.items():
            rest[full.joints[full.getJointId(name)].idx_q] = value
        still = [n for n, name in enumerate(full.names) if n and name not in joint_names]
        self.model, self.geometry = pinocchio.buildReducedModel(full, shapes, still, rest)
        self.joint_ids = [self.model.getJointId(name) for name in joint_names]

    def configurations(self, q: Array) -> Array:
        """Return pinocchio's configurations (T, nq) for joint positions (T, J) [rad, m]."""
        found = np.zeros((len(q), self.model.nq))
        for angle, number in zip(q.T, self.joint_ids, strict=True):
            joint = self.model.joints[number]
            if joint.nq == 1:
                found[:, joint.idx_q] = angle
            else:
                # A joint that turns for ever is held as the cosine and sine of its angle.
                found[:, joint.idx_q] = np.cos(angle)
                found[:, joint.idx_q + 1] = np.sin(angle)
        return found

    def torques(self, q: Array, v: Array, a: Array) -> Array:
        """Return the torques (T, J) [N m, N] of positions, velocities and accelerations (T, J).

        M(q) a + C(q, v) v + g(q), by the recursive Newton-Euler algorithm (Featherstone 2008, table
        5.1), without friction and with the pen in the air.
        """
        data = self.model.createData()
        configurations = self.configurations(q)
        order = [self.model.joints[number].idx_v for number in self.joint_ids]
        needed = np.empty_like(v)
        speeds = np.empty_like(v)
        pushes = np.empty_like(v)
        speeds[:, order] = v
        pushes[:, order] = a
        for row, moment in enumerate(configurations):
            needed[row] = self._pinocchio.rnea(self.model, data, moment, speeds[row], pushes[row])
        return needed[:, order]

    def inertia(self, q: Array) -> list[Array]:
        """Return the mass matrix at each of the positions (T, J), (J, J) [kg m^2, kg m, kg]."""
        data = self.model.createData()
        order = [self.model.joints[number].idx_v for number in self.joint_ids]
        upper = [self._pinocchio.crba(self.model, data, each) for each in self.configurations(q)]
        return [(M + np.triu(M, 1).T)[np.ix_(order, order)] for M in map(np.triu, upper)]


@lru_cache(maxsize=4)
def load_reduced_robot(joint_names: tuple[str, ...]) -> ReducedRobot:
    """Return the robot that moves only in some joints, built once."""
    return ReducedRobot(joint_names)


def load_pinocchio() -> Any:
    """Import pinocchio, or say what is missing."""
    try:
        import pinocchio  # noqa: PLC0415 (loaded when a robot is needed, not before)
    except (ImportError, OSError) as error:
        raise explain_missing_placo(error) from None
    return pinocchio


def explain_missing_placo(error: Exception) -> MissingPartError:
    """Return the error where PlaCo, or what it brings, cannot be imported."""
    return MissingPartError(
        f"The robot's joints are solved by PlaCo, which is not here ({error}). Letters, sliders "
        "and plots work without it. On Linux and macOS: python3 -m pip install placo; on Windows "
        "use WSL, or a notebook hub."
    )
