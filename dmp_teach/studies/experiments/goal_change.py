"""What happens to a stroke when its goal moves: DMP* beside the original form (the paper's figures 6 and 7) as data."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.variants import rms
from dmp_teach.studies.inputs import strokes_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

AXES = "xyz"
CURVED = 0.05  # a coordinate that leaves its straight way by less, in parts of the stroke's size, cannot be turned over


@dataclass(frozen=True)
class GoalChange:
    """One stroke whose goal moved by one shift, drawn by both forms.

    Args:
        stroke: Its name.
        shift: How far the goal moved, by coordinate [m].
        factor: (g' - y0) / (g - y0), by coordinate: what the original form stretches the stroke by.
        mirrored: Whether a factor is negative: the original form turns that coordinate over.
        turned_over: Whether DMP* as it was drawn runs against the demonstration in some coordinate that is not straight
            (its way from the straight line between its ends has a negative product with the demonstration's).
        original_turned_over: The same for the original form.
        star: DMP* from the demonstration, root mean square [m]; a stroke that slides along can be |shift| off.
        original: The original form from the demonstration, root mean square [m].
        star_velocity: The same for velocities [m/s].
        original_velocity: The same for velocities [m/s].
        star_miss: Where DMP* ended, from the goal [m].
        original_farthest: The farthest that the original form gets from the demonstration [m].
    """

    stroke: str
    shift: tuple[float, ...]
    factor: tuple[float, ...]
    mirrored: bool
    turned_over: bool
    original_turned_over: bool
    star: float
    original: float
    star_velocity: float
    original_velocity: float
    star_miss: float
    original_farthest: float

    @property
    def distance(self) -> float:
        """How far the goal moved [m]."""
        return float(np.linalg.norm(self.shift))


@dataclass(frozen=True, eq=False)
class GoalChanges(Tabled):
    """Every stroke with every shift of its goal.

    Args:
        cases: One for each stroke and shift.
        refused: Strokes that the original form cannot learn, since a coordinate ends where it began.
    """

    cases: tuple[GoalChange, ...]
    refused: tuple[str, ...] = ()

    @property
    def mirrored(self) -> int:
        """In how many cases the original form turns a coordinate over: (g' - y0) / (g - y0) < 0."""
        return sum(case.mirrored for case in self.cases)

    @property
    def turned_over(self) -> int:
        """In how many cases DMP* does."""
        return sum(case.turned_over for case in self.cases)

    def values(self, name: str) -> Array:
        """One figure of every case, such as `values("star")`, shape (C,)."""
        return np.array([getattr(case, name) for case in self.cases])

    def rows(self) -> Rows:
        """One for each case."""
        return tuple(
            {
                "stroke": case.stroke,
                "shift [mm]": tuple(1e3 * x for x in case.shift),
                "factor": case.factor,
                "mirrored": case.mirrored,
                "DMP* [mm]": 1e3 * case.star,
                "original [mm]": 1e3 * case.original,
                "DMP* [mm/s]": 1e3 * case.star_velocity,
                "original [mm/s]": 1e3 * case.original_velocity,
            }
            for case in self.cases
        )


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


def change_goals_1d(
    recordings: Any = None,
    shift: float = 0.01,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalChanges:
    """Each coordinate of each stroke for itself, its goal moved by `shift` to either side (the paper: 0.01 m).

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shift: How far the goal moves [m].
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke.
        progress: Called as `progress(done, total)`.
    """
    pieces = []
    for stroke in strokes_of(recordings):
        for axis in range(stroke.path.dimensions):
            one = Trajectory(stroke.path.t, stroke.path.position[:, axis])
            pieces.append(
                (
                    f"{stroke.name} {AXES[axis]}",
                    one,
                    ((shift,), (-shift,)),
                    *_both(settings, original),
                )
            )
    return _together(run(_moved, pieces, executor, progress))


def change_goals_2d(
    recordings: Any = None,
    shift: float = 0.1,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalChanges:
    """Each stroke, its goal moved by `shift` right, left, up and down (the paper: 0.1 m); else as `change_goals_1d`."""
    shifts = ((shift, 0.0), (-shift, 0.0), (0.0, shift), (0.0, -shift))
    strokes = strokes_of(recordings)
    pieces = [(stroke.name, stroke.path, shifts, *_both(settings, original)) for stroke in strokes]
    return _together(run(_moved, pieces, executor, progress))


def trace_goal_change(
    stroke: Trajectory, axis: int = 0, shift: float = 0.01, name: str = ""
) -> Traces:
    """Position and velocity of one coordinate of one stroke whose goal moved, as the paper draws them.

    Args:
        stroke: As it was shown.
        axis: Which coordinate.
        shift: How far its goal moves [m].
        name: What the stroke is called.
    """
    one, t = Trajectory(stroke.t, stroke.position[:, axis]), stroke.t - stroke.t[0]
    drawn = {"demonstration": one.position[:, 0]}
    for label, settings in zip(("DMP*", "original"), _both(None, None), strict=True):
        learned = DMP.imitate(one, settings)
        drawn[label] = learned.rollout(goal=learned.goal + shift).position[:, 0]
    position = {label: locked(path) for label, path in drawn.items()}
    return Traces(
        name,
        locked(t),
        shift,
        position,
        {k: locked(np.gradient(p, t)) for k, p in position.items()},
    )


def _both(settings: Settings | None, original: Settings | None) -> tuple[Settings, Settings]:
    """The settings of DMP* and of the original form."""
    return as_settings(settings), as_settings(original, Settings.original, "original")


def _together(found: Sequence) -> GoalChanges:
    """The cases of all strokes."""
    cases = tuple(case for each in found if not isinstance(each, str) for case in each)
    return GoalChanges(cases, tuple(each for each in found if isinstance(each, str)))


def _moved(
    piece: tuple[str, Trajectory, tuple, Settings, Settings],
) -> tuple[GoalChange, ...] | str:
    """One stroke with all shifts; its name where the original form refuses it."""
    name, path, shifts, settings, original = piece
    star = DMP.imitate(path, _fitting(settings, path))
    try:
        old = DMP.imitate(path, _fitting(original, path))
    except SettingError:
        return name
    return tuple(_case(name, path, np.array(shift), star, old) for shift in shifts)


def _fitting(settings: Settings, path: Trajectory) -> Settings:
    """The settings, with no more kernels than samples."""
    number = settings.n_kernels
    return settings if number is None else replace(settings, n_kernels=min(number, len(path)))


def _case(name: str, path: Trajectory, shift: Array, star: DMP, old: DMP) -> GoalChange:
    """One stroke with one shift."""
    drawn = [learned.rollout(goal=learned.goal + shift).position for learned in (star, old)]
    apart = [each - path.position for each in drawn]
    speed = [rms(np.gradient(each, path.t, axis=0)) for each in apart]
    factor = (old.goal + shift - old.start) / (old.goal - old.start)
    bent = _bent(path.position)
    curved = np.sqrt((bent**2).mean(axis=0)) > CURVED * np.ptp(path.position, axis=0).max()
    turned = [bool(((_bent(each) * bent).sum(axis=0)[curved] < 0).any()) for each in drawn]
    return GoalChange(
        stroke=name,
        shift=tuple(map(float, shift)),
        factor=tuple(map(float, factor)),
        mirrored=bool((factor < 0).any()),
        turned_over=turned[0],
        original_turned_over=turned[1],
        star=rms(apart[0]),
        original=rms(apart[1]),
        star_velocity=speed[0],
        original_velocity=speed[1],
        star_miss=float(np.linalg.norm(drawn[0][-1] - star.goal - shift)),
        original_farthest=float(np.linalg.norm(apart[1], axis=1).max()),
    )


def _bent(path: Array) -> Array:
    """A path (T, D) without the straight and even way from its start to its end."""
    along = np.linspace(0, 1, len(path))[:, None]
    return path - path[0] - along * (path[-1] - path[0])


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


def draw_goal_change(
    stroke: Trajectory, shift: Sequence[float] = (0.1, 0.0), name: str = ""
) -> GoalPaths:
    """One stroke whose goal moved, drawn by both forms, as the paper's figure 7 draws the letter a.

    Args:
        stroke: As it was shown, 2-D.
        shift: How far its goal moves [m].
        name: What the stroke is called.
    """
    moved, drawn = np.asarray(shift, dtype=float), {"demonstration": stroke.position}
    for label, settings in zip(("DMP*", "original"), _both(None, None), strict=True):
        learned = DMP.imitate(stroke, settings)
        drawn[label] = learned.rollout(goal=learned.goal + moved).position
    factor = (learned.goal + moved - learned.start) / (learned.goal - learned.start)
    return GoalPaths(
        name, locked(moved), {k: locked(path) for k, path in drawn.items()}, locked(factor)
    )
