"""The decay term of DMP*, and what a moved goal does to the pen in its first moment."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.studies.inputs import Stroke, strokes_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, locked


@dataclass(frozen=True, eq=False)
class InitialAcceleration(Tabled):
    """What a goal that moved by `shift` adds to the acceleration of the first sample.

    Args:
        strokes: S names.
        shift: How far the goal moved [m].
        without: Without the term -K (g - y0) s: K times the shift, shape (S,) [m/s2].
        with_term: With it, as the paper prints it, shape (S,) [m/s2].
        fed: With it, and with the change of the way fed forward, as `Settings.star()` does, shape (S,) [m/s2].
    """

    strokes: tuple[str, ...]
    shift: float
    without: Array
    with_term: Array
    fed: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("without", "with_term", "fed"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    def rows(self) -> Rows:
        """One for each stroke."""
        return tuple(
            {
                "stroke": name,
                "without the term [m/s2]": float(a),
                "with it [m/s2]": float(b),
                "with it, goal fed forward [m/s2]": float(c),
            }
            for name, a, b, c in zip(
                self.strokes, self.without, self.with_term, self.fed, strict=True
            )
        )


def measure_initial_acceleration(
    recordings: Any = None,
    shift: float = 0.01,
    settings: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> InitialAcceleration:
    """Each stroke drawn to a goal that moved, and the acceleration that this adds to its first sample.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shift: How far the goal moves, along the first coordinate [m].
        settings: Of DMP*; `Settings.star()` unless given. Feed-forward is tried both ways.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke.
        progress: Called as `progress(done, total)`.
    """
    strokes = strokes_of(recordings)
    pieces = [(stroke, shift, as_settings(settings)) for stroke in strokes]
    found = np.array(run(_first, pieces, executor, progress))
    return InitialAcceleration(tuple(stroke.name for stroke in strokes), shift, *found.T)


def _first(piece: tuple[Stroke, float, Settings]) -> tuple[float, float, float]:
    """The three accelerations of one stroke [m/s2]."""
    stroke, shift, settings = piece
    printed, fed = (
        DMP.imitate(stroke.path, replace(settings, feed_goal=feed)) for feed in (False, True)
    )
    K = printed.settings.alpha**2 / 4 / printed.duration**2
    return K * shift, _added(printed, shift), _added(fed, shift)


def _added(learned: DMP, shift: float) -> float:
    """What the shift adds to the acceleration in the spring's first two steps [m/s2]."""
    moved = learned.goal + shift * np.eye(len(learned.goal))[0]
    dt = learned.duration / learned.steps
    added = learned.rollout(goal=moved, dt=dt).position[:3] - learned.rollout(dt=dt).position[:3]
    return float(np.abs(added[2] - 2 * added[1] + added[0]).max() / dt**2)
