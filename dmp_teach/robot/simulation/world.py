"""The robot with its pen at its page, under gravity: one world of pybullet, one step at a time."""

from __future__ import annotations

from functools import partial
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import scipy

from dmp_teach.files import ASSETS
from dmp_teach.robot.model.kinematics import REST
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array

PENS = {"sprung": ASSETS / "fetch_sprung.urdf", "rigid": ASSETS / "fetch.urdf"}
"""The robot with a pen that slides on a spring, or with one that is held fast."""

SLIDE_JOINT = "pen_slide_joint"

RIGID_PRESS = 0.0005
"""A rigid pen that is to write must be pressed a little, too [m]."""

NIB_RADIUS = 0.0015
"""Radius of the ball at the pen's tip [m]."""

# The pen's spring: its stiffness [N/m], and its damping, 0.7 of what would be critical [N s/m].
_STIFFNESS = 100.0
_DAMPING = 1.6
# Of the nib on the paper.
_FRICTION = 0.15
_GRAVITY = 9.81
# How far the table reaches beyond the sheet, and how thick it is [m].
_TABLE_MARGIN = 0.10
_TABLE_DEPTH = 0.02


class StepResult(NamedTuple):
    """Joints q [rad, m] and v (J,), the pen's slide last, where a step has led.

    And what position motors needed for it, shape (J,) [N m, N], and the `force` with which nib and
    paper push each other [N].
    """

    q: list[float]
    v: list[float]
    effort: list[float]
    force: float


class World:
    """A Fetch bolted to the floor, its arm where a motion begins, and a page where it really lies.

    Args as in `simulate`; `number` is that of the client of pybullet.
    """

    def __init__(
        self, bullet: ModuleType, number: int, motion: Motion, page: Page, pen: str
    ) -> None:
        self.bullet = bullet
        self._number = number
        self.call("setGravity", 0, 0, -_GRAVITY)
        self.call("setTimeStep", motion.duration / (len(motion.t) - 1))
        self.call("setPhysicsEngineParameter", deterministicOverlappingPairs=1)
        flags = bullet.URDF_USE_INERTIA_FROM_FILE | bullet.URDF_IGNORE_VISUAL_SHAPES
        self.robot = self.call("loadURDF", str(PENS[pen]), useFixedBase=True, flags=flags)
        self.facts = [
            self.call("getJointInfo", self.robot, n)
            for n in range(self.call("getNumJoints", self.robot))
        ]
        numbers = {fact[1].decode(): fact[0] for fact in self.facts}
        links = {fact[12].decode(): fact[0] for fact in self.facts}
        self.arm = [numbers[name] for name in motion.joint_names]
        self.limits = np.array([self.facts[n][10] for n in self.arm])
        self._slide = numbers.get(SLIDE_JOINT)
        self._tip = links["pen_tip"]
        self._pushed = 0.0
        self._place(motion.q[0])
        self._page = self._lay(page)
        self._read = [*self.arm, *([] if self._slide is None else [self._slide])]
        self.send = partial(bullet.setJointMotorControlArray, self.robot, physicsClientId=number)

    def call(self, name: str, *args: Any, **options: Any) -> Any:
        """Call one of pybullet's functions in this world; it has no types."""
        return getattr(self.bullet, name)(*args, **options, physicsClientId=self._number)

    @property
    def links(self) -> range:
        """Numbers of the robot's links, without its base."""
        return range(len(self.facts))

    def step(self) -> StepResult:
        """Let one step of time pass, after the motors have been set."""
        if self._slide is not None:
            # A motor's torque lasts for one step, and adds up if it is set twice.
            self.call(
                "setJointMotorControl2",
                self.robot,
                self._slide,
                self.bullet.TORQUE_CONTROL,
                force=-_STIFFNESS * self._pushed,
            )
        self.call("stepSimulation")
        states = self.call("getJointStates", self.robot, self._read)
        q = [state[0] for state in states]
        if self._slide is not None:
            self._pushed = q[-1]
        arm = states[: len(self.arm)]
        points = self.call("getContactPoints", self.robot, self._page, self._tip, -1)
        force = sum(point[9] for point in points)
        return StepResult(q, [state[1] for state in arm], [state[3] for state in arm], force)

    def _place(self, q: Array) -> None:
        """Put the robot where it starts, with all else held; only the nib can touch anything."""
        for number in range(-1, len(self.facts)):
            self.call("setCollisionFilterGroupMask", self.robot, number, 0, 0)
        self.call("setCollisionFilterGroupMask", self.robot, self._tip, 1, 1)
        self.call("changeDynamics", self.robot, self._tip, lateralFriction=1.0)
        for number, position in zip(self.arm, q, strict=True):
            self.call("resetJointState", self.robot, number, position, 0.0)
            # Not the URDF's damping: at full speed it would ask more of the wrist's roll than its
            # motor has (5 N m s/rad, 2.27 rad/s, 7.36 N m).
            self.call("changeDynamics", self.robot, number, jointDamping=0.0)
        for fact in self.facts:
            number = fact[0]
            position = REST.get(fact[1].decode(), 0.0)
            if fact[2] == self.bullet.JOINT_FIXED or number in self.arm:
                continue
            control = {
                "controlMode": self.bullet.POSITION_CONTROL,
                "targetPosition": position,
                "force": fact[10],
            }
            if number == self._slide:
                # No motor: the spring is ours.
                control = {"controlMode": self.bullet.VELOCITY_CONTROL, "force": 0.0}
                self.call("changeDynamics", self.robot, number, jointDamping=_DAMPING)
            self.call("resetJointState", self.robot, number, position, 0.0)
            self.call("setJointMotorControl2", self.robot, number, **control)

    def _lay(self, page: Page) -> int:
        """Lay the sheet on its table or board: a box whose upper face is the paper."""
        halves = [page.width / 2 + _TABLE_MARGIN, page.height / 2 + _TABLE_MARGIN, _TABLE_DEPTH / 2]
        box = self.call("createCollisionShape", self.bullet.GEOM_BOX, halfExtents=halves)
        turn = scipy.spatial.transform.Rotation.from_matrix(page.X_world_page[:3, :3]).as_quat()
        middle = page.to_world((0.0, 0.0, -_TABLE_DEPTH / 2))
        body = self.call("createMultiBody", 0, box, -1, middle.tolist(), turn.tolist())
        self.call("changeDynamics", body, -1, lateralFriction=_FRICTION)
        return body
