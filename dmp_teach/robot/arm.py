"""Inverse kinematics of the writing arm, by PlaCo, which no other module knows of."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from dmp_teach.files import ASSETS
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.model.proximity import Proximity
from dmp_teach.robot.model.reduced import explain_missing_placo
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.quiet import quiet
from dmp_teach.trajectory import Array

JOINTS = (
    "torso_lift_joint",
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "upperarm_roll_joint",
    "elbow_flex_joint",
    "forearm_roll_joint",
    "wrist_flex_joint",
    "wrist_roll_joint",
)
"""The joints that write; all others stand still."""

SAFETY_SHELL = 0.0075
"""Where a posture is judged, all parts are thought to be so much larger on every side [m]."""

_here = threading.local()


class Solver:
    """PlaCo's robot and its solver, which does not keep its robot alive.

    Every method starts from what it is given, never from what was done before.

    Raises:
        MissingPartError: PlaCo is not on this platform.
    """

    def __init__(self) -> None:
        placo = _placo()
        self.model = Model.load()
        joints = [self.model.joint(name) for name in JOINTS]
        self.lower, self.upper = np.array([(joint.lower, joint.upper) for joint in joints]).T
        self.fastest = np.array([joint.velocity for joint in joints])
        with quiet():
            self._robot = placo.RobotWrapper("", 0, _bare_urdf())
        self._solver = solver = self._robot.make_solver()
        self._turning = [joint.type == "continuous" for joint in joints]
        self._speeds = [self._robot.get_joint_v_offset(name) for name in JOINTS]
        solver.dt = 1 / MOTION_RATE
        # With a free base the robot flies to the page.
        solver.mask_fbase(True)
        for name in self.model.joint_names:
            if name not in JOINTS:
                self.mask(name)
        solver.enable_joint_limits(True)
        self._tip = solver.add_position_task("pen_tip", np.zeros(3))
        self._axis = solver.add_axisalign_task(
            "pen_tip", np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, -1.0])
        )
        self._posture = solver.add_joints_task()
        solver.add_regularization_task(1e-4)
        self.proximity = Proximity(JOINTS, grown=SAFETY_SHELL)
        # Any: what `reach.posture`, of which this module knows nothing, has found out by page.
        self.verdicts: dict[object, Any] = {}

    def mask(self, name: str, masked: bool = True) -> None:
        """Hold a joint still, or let it go; raise a JointError for one that there is not."""
        (self._solver.mask_dof if masked else self._solver.unmask_dof)(self.model.joint(name).name)

    def stand(
        self, q: Array | Sequence[float], normal: Array, torso: bool, upright: float = 0.1
    ) -> None:
        """Take a posture q (J,) [rad, m], and prefer it from now on.

        The pen looks against `normal` (3,), turned by 1e-9 rad because PlaCo knows no way from an
        axis to its exact opposite; `upright` says how much its axis weighs against 1 m of its tip.
        """
        self._robot.reset()
        for name, value in zip(JOINTS, q, strict=True):
            self._robot.set_joint(self.model.joint(name).name, float(value))
        self._robot.update_kinematics()
        self.mask("torso_lift_joint", not torso)
        self._solver.dt = 1 / MOTION_RATE
        self._solver.enable_velocity_limits(False)
        self._axis.targetAxis_world = -normal + 1e-9 * np.array([normal[1], normal[2], normal[0]])
        self._tip.configure("tip", "soft", 1.0)
        self._axis.configure("axis", "soft", upright)
        self._posture.set_joints(
            {name: float(value) for name, value in zip(JOINTS, q, strict=True)}
        )
        self._posture.configure("posture", "soft", 1e-6)

    def go(self, target: Array, steps: int) -> None:
        """Take some steps to a place in the world (3,) [m]."""
        self._tip.target_world = target
        for _ in range(steps):
            self._solver.solve(True)
            self._robot.update_kinematics()

    def approach(self, target: Array, finer: Sequence[float] = (0.1,)) -> None:
        """Go to a place (3,) [m], or as near as the arm gets, in steps that cannot run away.

        Far from its target a full step of the solver throws the arm about. Speed limits bound the
        step: by what a joint does in 0.1 s, then in each finer time.
        """
        self._solver.enable_velocity_limits(True)
        for self._solver.dt in finer:
            self.go(target, 50)
        self._solver.dt = 1 / MOTION_RATE
        self._solver.enable_velocity_limits(False)

    def glide(self, target: Array) -> None:
        """Go straight to a place (3,) [m], 2 cm at a time."""
        start = self.pen()[:3, 3]
        steps = int(np.ceil(np.linalg.norm(target - start) / 0.02)) + 1
        for part in np.arange(1, steps + 1) / steps:
            self.go(start + part * (target - start), 3)
        self.go(target, 10)

    def settle(self, target: Array) -> None:
        """Wait at a place (3,) [m] until the posture has come to rest.

        A posture that weighs more than a tenth of the regularisation never does: it goes round in
        circles of 3 mm.
        """
        self._posture.configure("posture", "soft", 1e-5)
        self.go(target, 120)
        self._posture.configure("posture", "soft", 1e-6)
        self.go(target, 20)

    def joints(self) -> Array:
        """Return the joint positions, shape (J,) [rad, m]."""
        return np.array([self._robot.get_joint(name) for name in JOINTS])

    def pen(self) -> Array:
        """Return the pose of the pen's tip in the world, shape (4, 4) [m]."""
        return self._robot.get_T_world_frame("pen_tip")

    def place_of(self, link: str) -> Array:
        """Return the origin of a link in the world, shape (3,) [m]."""
        return self._robot.get_T_world_frame(link)[:3, 3]

    def jacobian(self) -> Array:
        """Return the Jacobian of the pen's tip in the world, its velocity first, shape (6, J)."""
        return self._robot.frame_jacobian("pen_tip", "local_world_aligned")[:, self._speeds]

    def speeds(self, q: Array) -> Array:
        """Return the speeds between samples (T, J) as parts of the joints' limits, (T - 1, J)."""
        return np.abs(np.diff(q, axis=0)) * MOTION_RATE / self.fastest

    def follow(
        self,
        start: Array,
        normal: Array,
        path: Array,
        report: Callable[[str, float], object],
        solves: int = 1,
    ) -> Array:
        """Solve for the joints along a path (T, 3) in the world, shape (T, J) [rad, m], unwrapped.

        The arm stands at `start` before, its torso stays, and the pen looks against `normal`; every
        sample gets so many `solves`. `report` is called with "joints" and how much is done.
        """
        self.stand(start, normal, torso=False)
        self.glide(path[0])
        self.settle(path[0])
        q = np.empty((len(path), len(JOINTS)))
        for row, target in enumerate(path):
            if row % 60 == 0:
                report("joints", row / len(path))
            self.go(target, solves)
            q[row] = self.joints()
        report("joints", 1.0)
        q[:, self._turning] = np.unwrap(q[:, self._turning], axis=0)
        return q


def get_solver() -> Solver:
    """Return the solver of this thread: PlaCo's must not be shared, and each one leaks 0.35 MB."""
    if not hasattr(_here, "solver"):
        _here.solver = Solver()
    return _here.solver


def _bare_urdf() -> str:
    """Return the robot's URDF without shells and collision shapes, which PlaCo need not load."""
    root = ET.parse(ASSETS / "fetch.urdf").getroot()
    for link in root.iter("link"):
        for element in [*link.findall("visual"), *link.findall("collision")]:
            link.remove(element)
    return ET.tostring(root, encoding="unicode")


def _placo() -> Any:
    """Import PlaCo, or say what is missing; it has no types."""
    try:
        import placo  # noqa: PLC0415 (loaded when a robot is needed, not before)
    except (ImportError, OSError) as error:
        raise explain_missing_placo(error) from None
    return placo
