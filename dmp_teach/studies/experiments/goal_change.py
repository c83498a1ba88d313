"""Strokes whose goal moves: DMP* beside the original form (the paper's figures 7 and 8)."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, fields

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError, shown
from dmp_teach.studies.experiments.variants import Variant
from dmp_teach.studies.inputs import RecordingsLike, named_strokes
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, rms

AXIS_NAMES = "xyz"
# A coordinate that is straighter than this share of the stroke's size cannot be turned over.
LEAST_BEND = 0.05


@dataclass(frozen=True)
class GoalChange:
    """One stroke whose goal moved by one shift, drawn by both forms.

    Args:
        stroke: Its name.
        shift: How far the goal moved, by coordinate [m].
        factor: (g' - y0) / (g - y0), by coordinate: what the original form stretches the stroke by.
        turned_over: Whether DMP* as it was drawn runs against the demonstration in some coordinate
            that is not straight: the products of their offsets from the chord sum to less than 0.
        original_turned_over: The same for the original form.
        star: DMP* from the demonstration, root mean square [m]; a stroke that slides along can be
            |shift| off.
        original: The original form from the demonstration, root mean square [m].
        star_velocity: The same for velocities [m/s].
        original_velocity: The same for velocities [m/s].
        original_farthest: The greatest distance of the original form from the demonstration [m].
    """

    stroke: str
    shift: tuple[float, ...]
    factor: tuple[float, ...]
    turned_over: bool
    original_turned_over: bool
    star: float
    original: float
    star_velocity: float
    original_velocity: float
    original_farthest: float

    @property
    def mirrored(self) -> bool:
        """Whether the original form turns a coordinate over: its factor is negative."""
        return min(self.factor) < 0

    @property
    def distance(self) -> float:
        """How far the goal moved [m]."""
        return float(np.linalg.norm(self.shift))


@dataclass(frozen=True, eq=False, repr=False)
class GoalChanges(Tabled):
    """Every stroke with every shift of its goal.

    Args:
        cases: One for each stroke and shift.
        refused: Strokes that the original form cannot learn, since a coordinate ends where it
            began.
    """

    cases: tuple[GoalChange, ...]
    refused: tuple[str, ...] = ()

    @property
    def mirrored(self) -> int:
        """In how many cases the original form turns a coordinate over."""
        return sum(case.mirrored for case in self.cases)

    @property
    def turned_over(self) -> int:
        """In how many cases DMP* does."""
        return sum(case.turned_over for case in self.cases)

    @checked
    def values(self, name: str) -> Array:
        """Return one figure of every case, such as `values("star")`, shape (C,)."""
        if not all(hasattr(case, name) for case in self.cases):
            known = ", ".join(each.name for each in fields(GoalChange))
            raise SettingError(f"There is no figure {shown(name)}; there are: {known}.")
        return np.array([getattr(case, name) for case in self.cases])

    @property
    def columns(self) -> Columns:
        """A row for each case."""
        return {
            "stroke": self.values("stroke"),
            "shift [mm]": 1e3 * self.values("shift"),
            "factor": self.values("factor"),
            "mirrored": self.values("mirrored"),
            "DMP* [mm]": 1e3 * self.values("star"),
            "original [mm]": 1e3 * self.values("original"),
            "DMP* [mm/s]": 1e3 * self.values("star_velocity"),
            "original [mm/s]": 1e3 * self.values("original_velocity"),
        }


@checked
def change_goals_1d(
    recordings: RecordingsLike = None,
    shift: float = 0.01,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalChanges:
    """Move the goal of each coordinate of each stroke by `shift` to either side.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shift: How far the goal moves [m]; the paper's is 0.01 m.
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: As in `claims`; a piece of work is one coordinate.
        progress: As in `claims`.
    """
    forms = both_forms(settings, original)
    pieces = [
        (
            f"{stroke.name} {AXIS_NAMES[axis]}",
            Trajectory(stroke.path.t, stroke.path.position[:, axis]),
            ((shift,), (-shift,)),
            *forms,
        )
        for stroke in named_strokes(recordings)
        for axis in range(stroke.path.dimensions)
    ]
    return _collected(run(_change_goal, pieces, executor, progress))


@checked
def change_goals_2d(
    recordings: RecordingsLike = None,
    shift: float = 0.1,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> GoalChanges:
    """Move the goal of each stroke by `shift` right, left, up and down.

    Args:
        recordings: As in `change_goals_1d`.
        shift: How far the goal moves [m]; the paper's is 0.1 m.
        settings: As in `change_goals_1d`.
        original: As in `change_goals_1d`.
        executor: As in `claims`; a piece of work is one stroke.
        progress: As in `claims`.
    """
    forms = both_forms(settings, original)
    shifts = ((shift, 0.0), (-shift, 0.0), (0.0, shift), (0.0, -shift))
    pieces = [(each.name, each.path, shifts, *forms) for each in named_strokes(recordings)]
    return _collected(run(_change_goal, pieces, executor, progress))


def both_forms(
    settings: Settings | None = None, original: Settings | None = None
) -> tuple[Settings, Settings]:
    """Return the settings of DMP* and of the original form."""
    return as_settings(settings), as_settings(original, Settings.original, "original")


def goal_factor(learned: DMP, shift: Array) -> Array:
    """Return (g' - y0) / (g - y0), by coordinate."""
    return (learned.goal + shift - learned.start) / (learned.goal - learned.start)


def _collected(found: Sequence[tuple[GoalChange, ...] | str]) -> GoalChanges:
    """Return the cases of all strokes."""
    cases = tuple(case for each in found if not isinstance(each, str) for case in each)
    return GoalChanges(cases, tuple(each for each in found if isinstance(each, str)))


def _change_goal(
    piece: tuple[str, Trajectory, tuple, Settings, Settings],
) -> tuple[GoalChange, ...] | str:
    """Return one stroke with all shifts; its name where the original form refuses it."""
    name, path, shifts, settings, original = piece
    star = DMP.imitate(path, Variant(settings, share=None).on(path))
    try:
        old = DMP.imitate(path, Variant(original, share=None).on(path))
    except SettingError:
        return name
    return tuple(_case(name, path, np.array(shift), star, old) for shift in shifts)


def _case(name: str, path: Trajectory, shift: Array, star: DMP, old: DMP) -> GoalChange:
    """Return one stroke with one shift."""
    drawn = [learned.rollout(goal=learned.goal + shift).position for learned in (star, old)]
    apart = [each - path.position for each in drawn]
    speed = [rms(np.gradient(each, path.t, axis=0)) for each in apart]
    bend = _from_chord(path.position)
    bent = np.sqrt((bend**2).mean(axis=0)) > LEAST_BEND * np.ptp(path.position, axis=0).max()
    turned = [bool(((_from_chord(each) * bend).sum(axis=0)[bent] < 0).any()) for each in drawn]
    return GoalChange(
        stroke=name,
        shift=tuple(map(float, shift)),
        factor=tuple(map(float, goal_factor(old, shift))),
        turned_over=turned[0],
        original_turned_over=turned[1],
        star=rms(apart[0]),
        original=rms(apart[1]),
        star_velocity=speed[0],
        original_velocity=speed[1],
        original_farthest=float(np.linalg.norm(apart[1], axis=1).max()),
    )


def _from_chord(path: Array) -> Array:
    """Return the offsets of a path (T, D) from an even way along its chord."""
    along = np.linspace(0, 1, len(path))[:, None]
    return path - path[0] - along * (path[-1] - path[0])
