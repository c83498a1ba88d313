"""A planned movement of the robot: joints, pen tip and ink on one clock."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot.model.kinematics import Model
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
        """The torques of the joints' motors, without friction, shape (T, J) [N m, N].

        By `ReducedRobot.torques`, when first used, with velocities and accelerations by central
        differences.
        """
        v = np.gradient(self.q, self.t, axis=0)
        a = np.gradient(v, self.t, axis=0)
        return locked(load_reduced_robot(self.joint_names).torques(self.q, v, a))

    def __repr__(self) -> str:
        error = f"tip error {1000 * self.tip_error:.3f} mm rms"
        return f"Motion({self.duration:.2f} s, {len(self.joint_names)} joints, {error})"


def describe_overloads(motion: Motion, model: Model) -> tuple[str, ...]:
    """Return a sentence for each joint that needs more than its motor gives, with the cure."""
    limits = np.array([model.joint(name).effort for name in motion.joint_names])
    share = np.abs(motion.torque) / limits
    overloaded = np.flatnonzero(share.max(axis=0) > 1)
    return tuple(_describe_overload(motion, joint, limits[joint]) for joint in overloaded)


def _describe_overload(motion: Motion, joint: int, limit: float) -> str:
    """Return the sentence for one joint, about the moment at which it needs most."""
    row = int(np.abs(motion.torque[:, joint]).argmax())
    q = motion.q[row : row + 1]
    needed = abs(motion.torque[row, joint])
    weight = abs(load_reduced_robot(motion.joint_names).torques(q, 0 * q, 0 * q)[0, joint])
    if weight < limit:
        # What is not weight goes with the square of the speed.
        longer = np.ceil(10 * np.sqrt((needed - weight) / (limit - weight))) / 10
        cure = f"Write slower: there the pen must take {longer:g} times as long"
    else:
        cure = "The weight of the arm alone is too much: move the page nearer"
    name = motion.joint_names[joint]
    unit = "N" if name == "torso_lift_joint" else "N m"
    return (
        f"{name} needs {needed:.1f} {unit} after {motion.t[row]:.2f} s, but its motor gives "
        f"{limit:g} {unit}. {cure}."
    )
