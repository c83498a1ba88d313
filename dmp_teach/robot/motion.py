"""A planned movement of the robot: joints, pen tip and ink on one clock."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot.model.reduced import load_reduced_robot
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array, Trajectory, rms
from dmp_teach.values import Value, locked

BoolArray = NDArray[np.bool_]


@dataclass(frozen=True, eq=False, repr=False)
class Motion(Value):
    """A planned movement of the whole robot.

    Args:
        t: Times from 0, evenly spaced, shape (T,) [s].
        q: Joint positions, shape (T, J) [rad, m].
        joint_names: J names, in the order of the columns of `q`.
        tip: Where the nib is, by forward kinematics of `assets/fetch.urdf`, in the world, shape
            (T, 3) [m].
        target: Where the nib should be, in the world, shape (T, 3) [m].
        pen_down: True exactly while the nib is meant to be on the letter, shape (T,).
        page: The sheet.
        strokes: The strokes as they were placed on the page (page frame, origin at its centre) [m].
        notes: What was changed on the way, in sentences ("slowed from 1.83 s to 2.10 s:
            elbow_flex_joint").
        solver: What solved the joints: "PlaCo" or "NumPy".
    """

    t: Array
    q: Array
    joint_names: tuple[str, ...]
    tip: Array
    target: Array
    pen_down: BoolArray
    page: Page
    strokes: tuple[Trajectory, ...]
    notes: tuple[str, ...] = ()
    solver: str = ""

    def __post_init__(self) -> None:
        for name in ("joint_names", "strokes", "notes"):
            object.__setattr__(self, name, tuple(getattr(self, name)))
        super().__post_init__()

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @property
    def tip_error(self) -> float:
        """Root mean square distance of the nib from where it should be [m]."""
        return rms(self.tip - self.target)

    @cached_property
    def torque(self) -> Array:
        """The torques of the joints' motors, without friction, shape (T, J) [N m, N]."""
        return locked(compute_torques(self.q, self.t, self.joint_names))

    def __repr__(self) -> str:
        error = f"tip error {1000 * self.tip_error:.3f} mm rms"
        return f"Motion({self.duration:.2f} s, {len(self.joint_names)} joints, {error})"


def compute_torques(q: Array, t: Array, joint_names: tuple[str, ...]) -> Array:
    """Return the torques (T, J) [N m, N] of joint positions (T, J) at times (T,), without friction.

    By `ReducedRobot.torques`, with velocities and accelerations by central differences.
    """
    v = np.gradient(q, t, axis=0)
    return load_reduced_robot(joint_names).torques(q, v, np.gradient(v, t, axis=0))
