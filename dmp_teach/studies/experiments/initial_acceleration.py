"""The decay term of DMP*, and what a moved goal adds to the initial acceleration."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.studies.inputs import RecordingsLike, Stroke, named_strokes
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array


@dataclass(frozen=True, eq=False, repr=False)
class InitialAcceleration(Tabled):
    """The acceleration (S,) [m/s2] that a goal that moved by `shift` adds to the first sample.

    Args:
        strokes: S names.
        shift: How far the goal moved [m].
        without: Without the term -K (g - y0) s: K times the shift.
        with_term: With it, as the paper prints it.
        fed: With it, and the change of the goal fed forward, as `Settings.star()` does.
    """

    strokes: tuple[str, ...]
    shift: float
    without: Array
    with_term: Array
    fed: Array

    @property
    def columns(self) -> Columns:
        """A row for each stroke."""
        return {
            "stroke": self.strokes,
            "without the term [m/s2]": self.without,
            "with it [m/s2]": self.with_term,
            "with it, goal fed forward [m/s2]": self.fed,
        }


@checked
def measure_initial_acceleration(
    recordings: RecordingsLike = None,
    shift: float = 0.01,
    settings: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> InitialAcceleration:
    """Measure what a moved goal adds to the acceleration of each stroke's first sample.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shift: How far the goal moves, along the first coordinate [m].
        settings: Of DMP*; `Settings.star()` unless given. Feed-forward is tried both ways; steps
            are explicit, since a lagged spring has no input in its first.
        executor: As in `claims`; a piece of work is one stroke.
        progress: As in `claims`.
    """
    strokes, form = named_strokes(recordings), as_settings(settings)
    found = np.array(run(_first, [(stroke, shift, form) for stroke in strokes], executor, progress))
    return InitialAcceleration(tuple(stroke.name for stroke in strokes), shift, *found.T)


def _first(piece: tuple[Stroke, float, Settings]) -> tuple[float, float, float]:
    """Return the three accelerations of one stroke [m/s2]."""
    stroke, shift, settings = piece
    explicit = replace(settings, integrator="explicit")
    printed, fed = (
        DMP.imitate(stroke.path, replace(explicit, feed_goal=feed)) for feed in (False, True)
    )
    # Settings of a primitive are complete: alpha is a number.
    D = (printed.settings.alpha or 0.0) / printed.duration
    K = (D / 2 / settings.damping) ** 2
    return K * shift, _added(printed, shift), _added(fed, shift)


def _added(learned: DMP, shift: float) -> float:
    """Return what the shift adds to the acceleration in the first two steps [m/s2]."""
    moved = learned.goal + shift * np.eye(len(learned.goal))[0]
    dt = learned.duration / learned.steps
    added = learned.rollout(goal=moved, dt=dt).position[:3] - learned.rollout(dt=dt).position[:3]
    return float(np.abs(added[2] - 2 * added[1] + added[0]).max() / dt**2)
