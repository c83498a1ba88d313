"""Goals near the start: what a small change of the goal asks of the pen and of the Fetch's joints."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.joint_demand import arm_at_table, greatest_acceleration
from dmp_teach.studies.inputs import strokes_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

WAYS = (0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005)
"""How far the goal is from the start [m]."""


@dataclass(frozen=True, eq=False)
class GoalsNearStart(Tabled):
    """Strokes whose goal was brought near their start in one coordinate, and then moved.

    Args:
        ways: How near, shape (L,) [m].
        shift: How far the goal then moved [m].
        acceleration: The greatest of the pen, as shown, drawn by the original form and by DMP*, shape (L, C, 3) [m/s2].
        speed: The greatest part of a joint's speed limit that it asks for, shape (L, C, 3).
        effort: The greatest part of a joint's torque limit, shape (L, C, 3).
    """

    ways: Array
    shift: float
    acceleration: Array
    speed: Array
    effort: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("ways", "acceleration", "speed", "effort"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    @property
    def growth(self) -> Array:
        """How many times as large as shown the acceleration gets, medians, for original and DMP*, shape (L, 2)."""
        return np.median(self.acceleration[:, :, 1:] / self.acceleration[:, :, :1], axis=1)

    @property
    def broken(self) -> Array:
        """The share of those that kept all limits as shown and break one when drawn, for both forms, shape (L, 2)."""
        asked = np.maximum(self.speed, self.effort)
        kept = asked[:, :, :1] <= 1
        return ((asked[:, :, 1:] > 1) & kept).sum(axis=1) / np.maximum(kept.sum(axis=1), 1)

    def rows(self) -> Rows:
        """A row for each way."""
        return tuple(
            {
                "g from y0 [mm]": float(1e3 * way),
                "original, times the acceleration": float(growth[0]),
                "DMP*, times": float(growth[1]),
                "original over a joint's limit [%]": float(100 * broken[0]),
                "DMP* over a joint's limit [%]": float(100 * broken[1]),
            }
            for way, growth, broken in zip(self.ways, self.growth, self.broken, strict=True)
        )


def change_goals_near_start(
    recordings: Any = None,
    shift: float = 0.01,
    ways: Sequence[float] = WAYS,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalsNearStart:
    """Every stroke bent so that its goal is near its start in one coordinate, learned, and its goal moved by `shift`.

    The joints' speeds and torques are those of the Fetch writing on a table (`limits.arm_at_table`).

    Args:
        recordings: Recordings, files or strokes of 2 dimensions; None takes our own alphabets.
        shift: How far the goal moves, in the same coordinate [m].
        ways: How near the goal is to the start in that coordinate [m].
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke.
        progress: Called as `progress(done, total)`.
    """
    both = (as_settings(original, Settings.original, "original"), as_settings(settings))
    pieces = [(stroke.path, tuple(ways), shift, *both) for stroke in strokes_of(recordings)]
    found = np.concatenate(
        [each for each in run(_asked, pieces, executor, progress) if each.size], axis=1
    )
    return GoalsNearStart(np.asarray(ways), shift, found[..., 0], found[..., 1], found[..., 2])


def closed_up(path: Trajectory, axis: int, way: float) -> Trajectory:
    """The path bent, gently and more and more, so that in one coordinate it ends `way` [m] from its start."""
    u = np.linspace(0, 1, len(path))
    bent = path.position.copy()
    bent[:, axis] += (way - (bent[-1, axis] - bent[0, axis])) * (3 * u**2 - 2 * u**3)
    return Trajectory(path.t, bent)


def _asked(piece: tuple[Trajectory, tuple, float, Settings, Settings]) -> Array:
    """Acceleration, speed and effort of one stroke, shape (L, 2 coordinates or fewer, 3, 3)."""
    path, ways, shift, original, settings = piece
    columns = []
    for axis in range(2):
        try:
            columns.append(
                [
                    _three(closed_up(path, axis, way), axis, shift, original, settings)
                    for way in ways
                ]
            )
        except SettingError:
            continue  # the other coordinate ends where it began: the original form refuses it
    return np.array(columns).swapaxes(0, 1) if columns else np.empty(0)


def _three(
    path: Trajectory, axis: int, shift: float, original: Settings, settings: Settings
) -> list:
    """What is asked for by the stroke as shown, by the original form and by DMP*."""
    old, star = DMP.imitate(path, original), DMP.imitate(path, settings)
    moved = shift * np.eye(2)[axis]
    drawn = (
        star.rollout(),
        old.rollout(goal=old.goal + moved),
        star.rollout(goal=star.goal + moved),
    )
    return [[greatest_acceleration(each), *arm_at_table().asked(each)] for each in drawn]
