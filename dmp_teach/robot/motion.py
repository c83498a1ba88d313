"""What the robot will do: joints, pen tip and ink on one clock."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from dmp_teach.robot.arm import torques
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Array, Trajectory, locked


@dataclass(frozen=True, eq=False)
class Motion:
    """A planned movement of the whole robot.

    Args:
        t: Times from 0, evenly spaced, shape (T,) [s].
        q: Joint positions, shape (T, J) [rad, m].
        joint_names: J names, in the order of the columns of `q`.
        tip: Where the nib is, by forward kinematics of `assets/fetch.urdf`, in the world, shape (T, 3) [m].
        target: Where the nib was asked to be, in the world, shape (T, 3) [m].
        pen_down: True exactly while the nib is meant to be on the letter, shape (T,).
        page: The sheet.
        strokes: The strokes as they were placed on the page (page frame, origin at its centre) [m].
        notes: What was changed on the way, in sentences ("slowed from 1.83 s to 2.10 s: elbow_flex_joint").
    """

    t: Array
    q: Array
    joint_names: tuple[str, ...]
    tip: Array
    target: Array
    pen_down: Array
    page: Page
    strokes: tuple[Trajectory, ...]
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Lock every array and tuple."""
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name in ("t", "q", "tip", "target"):
                object.__setattr__(self, field.name, locked(value))
            elif field.name == "pen_down":
                object.__setattr__(self, field.name, locked(value, dtype=bool))
            elif field.name in ("joint_names", "strokes", "notes"):
                object.__setattr__(self, field.name, tuple(value))

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @property
    def tip_error(self) -> float:
        """Root mean square distance of the nib from where it was asked to be [m]."""
        return float(np.sqrt(np.mean(np.sum((self.tip - self.target) ** 2, axis=1))))

    @cached_property
    def torque(self) -> Array:
        """What the joints' motors must give, without friction, shape (T, J) [N m, N]: see `arm.torques`.

        Computed when first asked for, with velocities and accelerations by central differences.

        Raises:
            MissingPartError: PlaCo, which brings pinocchio, is not on this platform.
        """
        v = np.gradient(self.q, self.t, axis=0)
        return locked(torques(self.q, v, np.gradient(v, self.t, axis=0), self.joint_names))

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        error = f"tip error {1000 * self.tip_error:.3f} mm rms"
        return f"Motion({self.duration:.2f} s, {len(self.joint_names)} joints, {error})"
