"""Goals near the start: what a small change of the goal demands of the pen and of the joints."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.joint_demand import arm_at_table, greatest_acceleration
from dmp_teach.studies.inputs import RecordingsLike, named_strokes
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory

GOAL_OFFSETS = (0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005)
"""How far the goal is from the start [m]."""


@dataclass(frozen=True, eq=False, repr=False)
class GoalsNearStart(Tabled):
    """Strokes whose goal was brought near their start in one coordinate, and then moved.

    The last axes of the arrays (L, C, 2, 2) are the goal near the start and moved, and what draws:
    the original form and DMP*.

    Args:
        ways: How near, shape (L,) [m].
        shift: How far the goal then moved [m].
        acceleration: The greatest of the pen [m/s2].
        speed: The greatest share of a joint's speed limit.
        effort: The greatest share of a joint's torque limit.
    """

    ways: Array
    shift: float
    acceleration: Array
    speed: Array
    effort: Array

    @property
    def growth(self) -> Array:
        """The median growth of the acceleration by the original form and DMP*, shape (L, 2)."""
        return np.median(self.acceleration[:, :, 1] / self.acceleration[:, :, 0], axis=1)

    @property
    def broken(self) -> Array:
        """The share of those within all limits before that break one, both forms, (L, 2)."""
        demand = np.maximum(self.speed, self.effort)
        kept = demand[:, :, 0] <= 1
        return ((demand[:, :, 1] > 1) & kept).sum(axis=1) / np.maximum(kept.sum(axis=1), 1)

    @property
    def columns(self) -> Columns:
        """A row for each offset of the goal."""
        return {
            "g from y0 [mm]": 1e3 * self.ways,
            "original, times the acceleration": self.growth[:, 0],
            "DMP*, times": self.growth[:, 1],
            "original over a joint's limit [%]": 100 * self.broken[:, 0],
            "DMP* over a joint's limit [%]": 100 * self.broken[:, 1],
        }


@checked
def change_goals_near_start(
    recordings: RecordingsLike = None,
    shift: float = 0.01,
    ways: Sequence[float] = GOAL_OFFSETS,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalsNearStart:
    """Bend every stroke so that its goal is near its start, learn it, and move its goal.

    The joints' speeds and torques are those of the Fetch writing on a table (`joint_demand`).

    Args:
        recordings: Recordings, files or strokes of 2 dimensions; None takes our own alphabets.
        shift: How far the goal moves, in the same coordinate [m].
        ways: How near the goal is to the start in that coordinate [m].
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: As in `claims`; a piece of work is one stroke.
        progress: As in `claims`.
    """
    forms = (as_settings(original, Settings.original, "original"), as_settings(settings))
    pieces = [(stroke.path, tuple(ways), shift, *forms) for stroke in named_strokes(recordings)]
    found = [each for each in run(_demands, pieces, executor, progress) if each.size]
    demand = np.concatenate(found, axis=1)
    return GoalsNearStart(np.asarray(ways), shift, demand[..., 0], demand[..., 1], demand[..., 2])


def close_up(path: Trajectory, axis: int, way: float) -> Trajectory:
    """Bend a path more and more so that in one coordinate it ends `way` [m] from its start."""
    u = np.linspace(0, 1, len(path))
    bent = path.position.copy()
    bent[:, axis] += (way - (bent[-1, axis] - bent[0, axis])) * (3 * u**2 - 2 * u**3)
    return Trajectory(path.t, bent)


def _demands(piece: tuple[Trajectory, tuple, float, Settings, Settings]) -> Array:
    """Return acceleration, speed and effort of one stroke, shape (L, 2 or fewer, 2, 2, 3)."""
    path, ways, shift, *forms = piece
    columns = []
    for axis in range(2):
        bent = [close_up(path, axis, way) for way in ways]
        try:
            columns.append([_demands_of_both(each, axis, shift, forms) for each in bent])
        except SettingError:
            # The other coordinate ends where it began: the original form refuses it.
            continue
    return np.array(columns).swapaxes(0, 1) if columns else np.empty(0)


def _demands_of_both(
    path: Trajectory, axis: int, shift: float, forms: Sequence[Settings]
) -> list[list[list[float]]]:
    """Return the demands to the goal and to the moved one, of both forms."""
    learned, moved = [DMP.imitate(path, form) for form in forms], shift * np.eye(2)[axis]
    return [
        [[greatest_acceleration(each), *arm_at_table().demand(each)] for each in drawn]
        for drawn in (
            [form.rollout() for form in learned],
            [form.rollout(goal=form.goal + moved) for form in learned],
        )
    ]
