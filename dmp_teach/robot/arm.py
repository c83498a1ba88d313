"""Inverse kinematics of the writing arm: what its two solvers, PlaCo's and ours, have in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np

from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.model.proximity import Proximity
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.slices import Slices
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

STEP_COST = 1e-4
"""What a step of all joints by 1 costs, beside a miss of the tip by 1 m."""

# What being 1 away from the preferred posture costs: while the arm moves, and while it settles.
_LIKING, _LIKING_AT_REST = 1e-6, 1e-5


class Solver(ABC):
    """An arm that goes where its pen should be, a step at a time.

    In each step the joints move so that least is left of w1 |tip|^2 + w2 |axis|^2 + w3 |posture|^2
    + `STEP_COST` |step|^2, linearised, within the joints' limits. Every method starts from what it
    is given, never from what was done before.
    """

    name: str
    """Who solves, as `Motion.solver` says it."""

    def __init__(self) -> None:
        self.model = Model.load()
        joints = [self.model.joint(name) for name in JOINTS]
        self.lower, self.upper = np.array([(joint.lower, joint.upper) for joint in joints]).T
        self.fastest = np.array([joint.velocity for joint in joints])
        self.turning = np.array([joint.type == "continuous" for joint in joints])
        self.proximity = Proximity(JOINTS, grown=SAFETY_SHELL)
        # Any: what `reach.posture`, of which this module knows nothing, has found out by page.
        self.verdicts: dict[object, Any] = {}

    @abstractmethod
    def place(self, q: Array, down: Array, torso: bool, upright: float) -> None:
        """Take a posture and prefer it, as in `stand`; the pen looks along `down` (3,)."""

    @abstractmethod
    def prefer(self, weight: float) -> None:
        """Say how much the preferred posture weighs beside 1 m of the tip."""

    @abstractmethod
    def bound(self, seconds: float | None) -> None:
        """Bound a step by what the joints can do in so many seconds; None: not at all."""

    @abstractmethod
    def go(self, target: Array, steps: int) -> None:
        """Take some steps to a place in the world (3,) [m]."""

    @abstractmethod
    def joints(self) -> Array:
        """Return the joint positions, shape (J,) [rad, m], turns for ever within half a turn."""

    @abstractmethod
    def pen(self) -> Array:
        """Return the pose of the pen's tip in the world, shape (4, 4) [m]."""

    @abstractmethod
    def place_of(self, link: str) -> Array:
        """Return the origin of a link in the world, shape (3,) [m]."""

    @abstractmethod
    def jacobian(self) -> Array:
        """Return the Jacobian of the pen's tip in the world, its velocity first, shape (6, J)."""

    def stand(
        self, q: Array | Sequence[float], normal: Array, torso: bool, upright: float = 0.1
    ) -> None:
        """Take a posture q (J,) [rad, m], and prefer it from now on.

        The pen looks against `normal` (3,), turned by 1e-9 rad because there is no way from an axis
        to its exact opposite; `upright` says how much its axis weighs against 1 m of
        its tip; the torso moves only where `torso` is set.
        """
        down = 1e-9 * np.roll(normal, -1) - normal
        self.place(np.asarray(q, dtype=float), down, torso, upright)
        self.prefer(_LIKING)
        self.bound(None)

    def approach(self, target: Array, finer: Sequence[float] = (0.1,)) -> None:
        """Go to a place (3,) [m], or as near as the arm gets, in steps that cannot run away.

        Far from its target a full step of the solver throws the arm about. Speed limits bound the
        step: by what a joint does in 0.1 s, then in each finer time.
        """
        for seconds in finer:
            self.bound(seconds)
            self.go(target, 50)
        self.bound(None)

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
        self.prefer(_LIKING_AT_REST)
        self.go(target, 120)
        self.prefer(_LIKING)
        self.go(target, 20)

    def speeds(self, q: Array) -> Array:
        """Return the speeds between samples (T, J) as parts of the joints' limits, (T - 1, J)."""
        return np.abs(np.diff(q, axis=0)) * MOTION_RATE / self.fastest

    def follow(
        self,
        start: Array,
        normal: Array,
        path: Array,
        solves: int = 1,
    ) -> Slices[Array]:
        """Solve for the joints along a path (T, 3) in the world, shape (T, J) [rad, m], unwrapped.

        The arm stands at `start` before, its torso stays, and the pen looks against `normal`; every
        sample gets so many `solves`. In slices, which yield "joints" and how much is done.
        """
        self.stand(start, normal, torso=False)
        self.glide(path[0])
        self.settle(path[0])
        q = np.empty((len(path), len(JOINTS)))
        for row, target in enumerate(path):
            if row % 60 == 0:
                yield "joints", row / len(path)
            self.go(target, solves)
            q[row] = self.joints()
        yield "joints", 1.0
        q[:, self.turning] = np.unwrap(q[:, self.turning], axis=0)
        return q
