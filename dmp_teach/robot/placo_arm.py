"""The arm solved by PlaCo, which no other module knows of."""

# ruff: noqa: D102 (`Solver` says what each method does)
from __future__ import annotations

from xml.etree import ElementTree as ET

import numpy as np
import placo

from dmp_teach.files import ASSETS
from dmp_teach.robot.arm import JOINTS, STEP_COST, Solver
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.quiet import quiet
from dmp_teach.trajectory import Array


class PlacoSolver(Solver):
    """PlaCo's robot and its solver, which does not keep its robot alive."""

    name = "PlaCo"

    def __init__(self) -> None:
        super().__init__()
        with quiet():
            self._robot = placo.RobotWrapper("", 0, _bare_urdf())
        self._solver = solver = self._robot.make_solver()
        self._speeds = [self._robot.get_joint_v_offset(name) for name in JOINTS]
        # With a free base the robot flies to the page.
        solver.mask_fbase(True)
        for name in self.model.joint_names:
            if name not in JOINTS:
                solver.mask_dof(name)
        solver.enable_joint_limits(True)
        self._tip = solver.add_position_task("pen_tip", np.zeros(3))
        self._axis = solver.add_axisalign_task(
            "pen_tip", np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])
        )
        self._posture = solver.add_joints_task()
        solver.add_regularization_task(STEP_COST)

    def place(self, q: Array, down: Array, torso: bool, upright: float) -> None:
        self._robot.reset()
        for name, value in zip(JOINTS, q, strict=True):
            self._robot.set_joint(name, float(value))
        self._robot.update_kinematics()
        (self._solver.unmask_dof if torso else self._solver.mask_dof)("torso_lift_joint")
        self._axis.targetAxis_world = down
        self._tip.configure("tip", "soft", 1.0)
        self._axis.configure("axis", "soft", upright)
        self._posture.set_joints(dict(zip(JOINTS, q.tolist(), strict=True)))

    def prefer(self, weight: float) -> None:
        self._posture.configure("posture", "soft", weight)

    def bound(self, seconds: float | None) -> None:
        self._solver.enable_velocity_limits(seconds is not None)
        self._solver.dt = seconds or 1 / MOTION_RATE

    def go(self, target: Array, steps: int) -> None:
        self._tip.target_world = target
        for _ in range(steps):
            self._solver.solve(True)
            self._robot.update_kinematics()

    def joints(self) -> Array:
        return np.array([self._robot.get_joint(name) for name in JOINTS])

    def pen(self) -> Array:
        return self._robot.get_T_world_frame("pen_tip")

    def place_of(self, link: str) -> Array:
        return self._robot.get_T_world_frame(link)[:3, 3]

    def jacobian(self) -> Array:
        return self._robot.frame_jacobian("pen_tip", "local_world_aligned")[:, self._speeds]


def _bare_urdf() -> str:
    """Return the robot's URDF without shells and collision shapes, which PlaCo need not load."""
    root = ET.parse(ASSETS / "fetch.urdf").getroot()
    for link in root.iter("link"):
        for element in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(element)
    return ET.tostring(root, encoding="unicode")
