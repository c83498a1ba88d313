"""Random ink: strokes of any shape, size and place, to see what a primitive cannot learn."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.studies.experiments.variants import rms
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

KINDS = ("waves", "closed", "corners", "straight")
RATES = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0)
"""Turns of the pen in a second [Hz]; a hand that writes makes 2 to 5."""


@dataclass(frozen=True, eq=False)
class RandomInkErrors(Tabled):
    """How near random ink was drawn.

    Args:
        kinds: Of ink, A names.
        rates: Turns of the pen in a second, shape (R,) [Hz].
        error: Root mean square distance in parts of the ink's size, shape (A, R, S) for S pieces each.
        miss: How far from a goal that moved by the ink's own size the drawing ended, in parts of that size, (A, R, S).
    """

    kinds: tuple[str, ...]
    rates: Array
    error: Array
    miss: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("rates", "error", "miss"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    def rows(self) -> Rows:
        """Medians over the pieces."""
        return tuple(
            {
                "ink": kind,
                "turns a second [Hz]": float(rate),
                "rms [% of size]": 100 * float(np.median(self.error[a, r])),
                "goal missed [% of size]": 100 * float(np.median(self.miss[a, r])),
            }
            for a, kind in enumerate(self.kinds)
            for r, rate in enumerate(self.rates)
        )


def learn_random_ink(
    settings: Settings | None = None,
    rates: Sequence[float] = RATES,
    pieces: int = 15,
    seed: int = 0,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> RandomInkErrors:
    """Random ink from 3 mm to 0.5 m, anywhere, of 2 s at 120 samples a second, learned and drawn to two goals.

    Args:
        settings: `Settings.star()` unless given.
        rates: Turns of the pen in a second [Hz].
        pieces: How many of each kind and rate.
        seed: Of the random numbers; the same seed gives the same ink.
        executor: Any `concurrent.futures.Executor`; a piece of work is one kind at one rate.
        progress: Called as `progress(done, total)`.
    """
    work = [
        (kind, float(rate), pieces, seed, as_settings(settings)) for kind in KINDS for rate in rates
    ]
    found = np.array(run(_tried, work, executor, progress)).reshape(
        len(KINDS), len(rates), 2, pieces
    )
    return RandomInkErrors(KINDS, np.asarray(rates), found[:, :, 0], found[:, :, 1])


def draw_random_ink(kind: str, rate: float, rng: np.random.Generator) -> Trajectory:
    """One stroke of 2 s in 2-D at 120 samples a second, of random size and place, at rest at both ends.

    Args:
        kind: "waves" (smooth, crossing itself), "closed" (the same, ending where it began), "corners" (straight pieces)
            or "straight".
        rate: Turns in a second [Hz]; a straight stroke has none, and is only faster or slower along its way.
        rng: Where the random numbers come from.
    """
    t = np.linspace(0, 1, 241)
    eased = t**3 * (10 - 15 * t + 6 * t**2)
    turns = max(1, round(2 * rate))
    if kind == "straight":
        path = (eased + 0.5 * np.sin(np.pi * turns * eased) / (np.pi * turns))[
            :, None
        ] * rng.normal(size=2)
    elif kind == "corners":
        corners = np.cumsum(rng.normal(size=(turns + 1, 2)), axis=0)
        path = np.column_stack(
            [np.interp(eased * turns, np.arange(turns + 1), axis) for axis in corners.T]
        )
    else:
        waves = np.arange(max(1, turns - 2), turns + 1)
        angle = 2 * np.pi * eased[:, None] * (waves / 2 if kind == "waves" else np.ceil(waves / 2))
        path = np.sin(angle + rng.uniform(0, 2 * np.pi, len(waves))) @ rng.normal(
            size=(len(waves), 2)
        )
    path = path / np.ptp(path, axis=0).max()
    return Trajectory(2 * t, path * 0.003 * (0.5 / 0.003) ** rng.uniform() + rng.normal(size=2))


def _tried(work: tuple[str, float, int, int, Settings]) -> Array:
    """Errors and misses of one kind at one rate, shape (2, S)."""
    kind, rate, pieces, seed, settings = work
    found = []
    for number in range(pieces):
        rng = np.random.default_rng([seed, KINDS.index(kind), round(1000 * rate), number])
        ink = draw_random_ink(kind, rate, rng)
        size = float(np.ptp(ink.position, axis=0).max())
        learned = DMP.imitate(ink, settings)
        angle = rng.uniform(0, 2 * np.pi)
        goal = learned.goal + size * np.array([np.cos(angle), np.sin(angle)])
        miss = np.linalg.norm(learned.rollout(goal=goal).position[-1] - goal)
        found.append((rms(learned.rollout().position - ink.position) / size, miss / size))
    return np.array(found).T
