"""The same letter by pink, another inverse-kinematics library on pinocchio: measured, and imported
nowhere else.

Its fairest and fastest settings that we found: a model of the seven joints that move, which is
smaller than ours (the others are locked where ours are masked); its own frame task, with no cost on
the pen's turning about itself; its own posture task and joint limits, and none on speeds, as ours;
DAQP; one solution and one update a sample.
"""

from xml.etree import ElementTree as ET

import daqp
import numpy as np
import pinocchio
from pink import Configuration, build_ik, solve_ik
from pink.limits import ConfigurationLimit
from pink.tasks import FrameTask, PostureTask

from dmp_teach.files.writing import ASSETS
from dmp_teach.robot.model.kinematics import REST
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.trajectory import Array

POSITION, AXIS, POSTURE, DAMPING = 1.0, 0.3, 1e-3, 1e-6
"""Costs of 1 m, 1 rad of the pen's axis and a posture, and the damping, of the least error."""


class PinkArm:
    """Pink, ready to follow the pen of one motion.

    Args:
        motion: Ours.
        lean: Hand pink's problem straight to DAQP, past pink's `solve_ik` and the checks in it.
    """

    def __init__(self, motion: Motion, lean: bool = False) -> None:
        self._solve = _straight if lean else _as_documented
        full = pinocchio.buildModelFromXML(_bare_urdf())
        self._names = motion.joint_names[1:]
        still = dict(REST) | {motion.joint_names[0]: motion.q[0, 0]}
        q = _packed(full, still)
        locked = [full.getJointId(name) for name in list(full.names)[1:] if name not in self._names]
        self._model = pinocchio.buildReducedModel(full, locked, q)
        self._start = _packed(self._model, dict(zip(self._names, motion.q[0, 1:], strict=True)))
        self._torso, self._path = motion.q[0, 0], motion.target
        self._limits = [ConfigurationLimit(self._model)]

    def follow(self) -> Array:
        """The joints along the path, the torso first, shape (T, J) [rad, m]."""
        arm = Configuration(self._model, self._model.createData(), self._start)
        tip = FrameTask("pen_tip", position_cost=POSITION, orientation_cost=[AXIS, AXIS, 0.0])
        posture = PostureTask(cost=POSTURE)
        posture.set_target(self._start)
        tip.set_target_from_configuration(arm)
        tasks, limits, solve = [tip, posture], self._limits, self._solve
        target = tip.transform_target_to_world
        states = np.empty((len(self._path), self._model.nq))
        for row, place in enumerate(self._path):
            target.translation = place
            arm.integrate_inplace(solve(arm, tasks, limits), 1 / MOTION_RATE)
            states[row] = arm.q
        return np.column_stack([np.full(len(states), self._torso), self._unpacked(states)])

    def _unpacked(self, states: Array) -> Array:
        """Pinocchio's states (T, n) as joint positions (T, J - 1)."""
        columns = []
        for name in self._names:
            joint = self._model.joints[self._model.getJointId(name)]
            first = states[:, joint.idx_q]
            columns.append(
                first if joint.nq == 1 else np.unwrap(np.arctan2(states[:, joint.idx_q + 1], first))
            )
        return np.column_stack(columns)


def _as_documented(arm: Configuration, tasks: list, limits: list) -> Array:
    return solve_ik(
        arm,
        tasks,
        1 / MOTION_RATE,
        solver="daqp",
        damping=DAMPING,
        limits=limits,
        safety_break=False,
    )


def _straight(arm: Configuration, tasks: list, limits: list) -> Array:
    problem = build_ik(arm, tasks, 1 / MOTION_RATE, DAMPING, limits)
    sides = len(problem.h)
    low, kinds = np.full(sides, -np.inf), np.zeros(sides, np.int32)
    step, _, found, _ = daqp.solve(problem.P, problem.q, problem.G, problem.h, low, kinds)
    if found != 1:
        raise ArithmeticError(f"DAQP found no solution: {found}.")
    return step * MOTION_RATE


def _packed(model: pinocchio.Model, positions: dict[str, float]) -> Array:
    """A state of pinocchio with these joint positions, all others at 0."""
    state = pinocchio.neutral(model)
    for name, value in positions.items():
        joint = model.joints[model.getJointId(name)]
        state[joint.idx_q : joint.idx_q + joint.nq] = (
            value if joint.nq == 1 else (np.cos(value), np.sin(value))
        )
    return state


def _bare_urdf() -> str:
    """The robot's URDF without shells and solids."""
    root = ET.parse(ASSETS / "fetch.urdf").getroot()
    for link in root.iter("link"):
        for element in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(element)
    return ET.tostring(root, encoding="unicode")
