"""One stroke whose goal moves, drawn by both forms (the paper's figures 7 and 8)."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, check_point
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.goal_change import both_forms, goal_factor
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value, locked


@dataclass(frozen=True, eq=False, repr=False)
class GoalPaths(Value):
    """One stroke, or one coordinate of it, shown and drawn to a goal that moved.

    Args:
        stroke: Its name.
        t: From 0, shape (T,) [s].
        shift: How far the goal moved, shape (D,) [m].
        paths: Of "demonstration", "DMP*" and "original", shape (T, D) each [m]; without "original"
            where that cannot learn the stroke, since a coordinate ends where it began.
        factor: (g' - y0) / (g - y0), shape (D,); infinite in such a coordinate.
    """

    stroke: str
    t: Array
    shift: Array
    paths: dict[str, Array]
    factor: Array

    @property
    def velocities(self) -> dict[str, Array]:
        """The velocity along each of the paths, shape (T, D) each [m/s]."""
        return {name: np.gradient(path, self.t, axis=0) for name, path in self.paths.items()}

    def __repr__(self) -> str:
        return f"GoalPaths({self.stroke!r}, goal moved by {self.shift} m: {', '.join(self.paths)})"


@checked
def trace_goal_change(
    stroke: Trajectory, axis: int = 0, shift: float = 0.01, name: str = ""
) -> GoalPaths:
    """Draw one coordinate whose goal moved by both forms, as the paper's figure 7.

    Args:
        stroke: As it was shown.
        axis: Which coordinate.
        shift: How far its goal moves [m].
        name: What the stroke is called.
    """
    return draw_goal_change(Trajectory(stroke.t, stroke.position[:, axis]), (shift,), name)


@checked
def draw_goal_change(
    stroke: Trajectory, shift: Sequence[float] = (0.1, 0.0), name: str = ""
) -> GoalPaths:
    """Draw one stroke whose goal moved by both forms, as the paper's figure 8 draws the letter a.

    Args:
        stroke: As it was shown.
        shift: How far its goal moves, for each coordinate [m].
        name: What the stroke is called.
    """
    moved = locked(check_point("shift", shift, stroke.dimensions))
    forms = dict(zip(("DMP*", "original"), both_forms(), strict=True))
    star = DMP.imitate(stroke, forms.pop("DMP*"))
    learned = {"DMP*": star}
    with suppress(SettingError):
        learned["original"] = DMP.imitate(stroke, forms["original"])
    paths = {"demonstration": stroke.position}
    paths |= {form: each.rollout(goal=each.goal + moved).position for form, each in learned.items()}
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = locked(goal_factor(star, moved))
    return GoalPaths(name, locked(stroke.t - stroke.t[0]), moved, paths, factor)
