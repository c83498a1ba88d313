"""One stroke whose goal moves, drawn by both forms (the paper's figures 6 and 7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.dmp import DMP
from dmp_teach.studies.experiments.goal_change import both_forms, goal_factor
from dmp_teach.trajectory import Array, Trajectory, locked


@dataclass(frozen=True, eq=False)
class Traces:
    """One coordinate over time, shown and drawn to a goal that moved.

    Args:
        stroke: Its name.
        t: From 0, shape (T,) [s].
        shift: How far the goal moved [m].
        position: Of "demonstration", "DMP*" and "original", shape (T,) each [m].
        velocity: The same, shape (T,) each [m/s].
    """

    stroke: str
    t: Array
    shift: float
    position: dict[str, Array]
    velocity: dict[str, Array]


@dataclass(frozen=True, eq=False)
class GoalPaths:
    """One stroke on the page, shown and drawn to a goal that moved.

    Args:
        stroke: Its name.
        shift: How far the goal moved, shape (2,) [m].
        paths: Of "demonstration", "DMP*" and "original", shape (T, 2) each [m].
        factor: (g' - y0) / (g - y0), shape (2,).
    """

    stroke: str
    shift: Array
    paths: dict[str, Array]
    factor: Array


def trace_goal_change(
    stroke: Trajectory, axis: int = 0, shift: float = 0.01, name: str = ""
) -> Traces:
    """Draw position and velocity of one coordinate whose goal moved, as the paper's figure 6.

    Args:
        stroke: As it was shown.
        axis: Which coordinate.
        shift: How far its goal moves [m].
        name: What the stroke is called.
    """
    one, t = Trajectory(stroke.t, stroke.position[:, axis]), stroke.t - stroke.t[0]
    drawn, _ = _drawn_to(one, np.array([shift]))
    position = {label: locked(path[:, 0]) for label, path in drawn.items()}
    velocity = {label: locked(np.gradient(path, t)) for label, path in position.items()}
    return Traces(name, locked(t), shift, position, velocity)


def draw_goal_change(
    stroke: Trajectory, shift: Sequence[float] = (0.1, 0.0), name: str = ""
) -> GoalPaths:
    """Draw one stroke whose goal moved by both forms, as the paper's figure 7 draws the letter a.

    Args:
        stroke: As it was shown, 2-D.
        shift: How far its goal moves [m].
        name: What the stroke is called.
    """
    moved = np.asarray(shift, dtype=float)
    drawn, learned = _drawn_to(stroke, moved)
    paths = {label: locked(path) for label, path in drawn.items()}
    return GoalPaths(name, locked(moved), paths, locked(goal_factor(learned, moved)))


def _drawn_to(stroke: Trajectory, shift: Array) -> tuple[dict[str, Array], DMP]:
    """Return the demonstration and both forms' rollouts to a moved goal, and the original form."""
    star, original = (DMP.imitate(stroke, settings) for settings in both_forms())
    return {
        "demonstration": stroke.position,
        "DMP*": star.rollout(goal=star.goal + shift).position,
        "original": original.rollout(goal=original.goal + shift).position,
    }, original
