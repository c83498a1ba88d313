"""Random ink: strokes of any shape, size and place, to see what a primitive cannot learn."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from dmp_teach.arguments import LARGEST_SEED, check_whole, checked
from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError, shown
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, interpolate_points, rms

# Half of the samples in a second [Hz].
LARGEST_RATE = 60.0
INK_KINDS = ("waves", "closed", "corners", "straight")
TURN_RATES = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0)
"""Turns of the pen in a second [Hz]; a hand that writes makes 2 to 5."""


@dataclass(frozen=True, eq=False, repr=False)
class RandomInkErrors(Tabled):
    """The errors of random ink.

    Args:
        kinds: Of ink, A names.
        rates: Turns of the pen in a second, shape (R,) [Hz].
        error: Root mean square distance as a share of the ink's size, shape (A, R, S) for S pieces.
        miss: How far from a goal that moved by the ink's own size the rollout ended, as a share of
            that size, shape (A, R, S).
    """

    kinds: tuple[str, ...]
    rates: Array
    error: Array
    miss: Array

    @property
    def columns(self) -> Columns:
        """Medians over the pieces, a row for each kind and rate."""
        return {
            "ink": np.repeat(self.kinds, len(self.rates)),
            "turns a second [Hz]": np.tile(self.rates, len(self.kinds)),
            "rms [% of size]": 100 * np.median(self.error, axis=2).ravel(),
            "goal missed [% of size]": 100 * np.median(self.miss, axis=2).ravel(),
        }


@checked
def learn_random_ink(
    settings: Settings | None = None,
    rates: Sequence[float] = TURN_RATES,
    pieces: int = 15,
    seed: int = 0,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> RandomInkErrors:
    """Learn random ink from 3 mm to 0.5 m, anywhere, and draw it to two goals.

    Args:
        settings: `Settings.star()` unless given.
        rates: Turns of the pen in a second [Hz].
        pieces: How many of each kind and rate.
        seed: Of the random numbers; the same seed gives the same ink.
        executor: As in `claims`; a piece is one kind at one rate.
        progress: As in `claims`.
    """
    form = as_settings(settings)
    check_whole("pieces", pieces, 1, 10_000)
    check_whole("seed", seed, 0, LARGEST_SEED)
    work = [(kind, float(rate), pieces, seed, form) for kind in INK_KINDS for rate in rates]
    shape = (len(INK_KINDS), len(rates), 2, pieces)
    found = np.array(run(_errors_and_misses, work, executor, progress)).reshape(shape)
    return RandomInkErrors(INK_KINDS, np.asarray(rates), found[:, :, 0], found[:, :, 1])


@checked
def draw_random_ink(kind: str, rate: float, rng: np.random.Generator) -> Trajectory:
    """Draw one stroke of 2 s in 2-D at 120 samples a second, at rest at both ends.

    Args:
        kind: "waves" (smooth, crossing itself), "closed" (the same, ending where it began),
            "corners" (straight pieces) or "straight".
        rate: Turns in a second [Hz]; a straight stroke has none, and is only faster or slower.
        rng: Of the shape, size and place.

    Raises:
        SettingError: No such kind, or a rate that so few samples cannot show.
    """
    if kind not in INK_KINDS:
        raise SettingError(f"kind is {shown(kind)}, but must be one of: {', '.join(INK_KINDS)}.")
    if not 0 <= rate <= LARGEST_RATE:
        raise SettingError(f"rate is {shown(rate)}, but must be from 0 to {LARGEST_RATE:g} Hz.")
    t = np.linspace(0, 1, 241)
    eased = t**3 * (10 - 15 * t + 6 * t**2)
    turns = max(1, round(2 * rate))
    if kind == "straight":
        along = eased + 0.5 * np.sin(np.pi * turns * eased) / (np.pi * turns)
        path = along[:, None] * rng.normal(size=2)
    elif kind == "corners":
        corners = np.cumsum(rng.normal(size=(turns + 1, 2)), axis=0)
        knots = np.arange(turns + 1)
        path = interpolate_points(eased * turns, knots, corners)
    else:
        waves = np.arange(max(1, turns - 2), turns + 1)
        angle = 2 * np.pi * eased[:, None] * (waves / 2 if kind == "waves" else np.ceil(waves / 2))
        phase = rng.uniform(0, 2 * np.pi, len(waves))
        path = np.sin(angle + phase) @ rng.normal(size=(len(waves), 2))
    path = path / np.ptp(path, axis=0).max()
    return Trajectory(2 * t, path * 0.003 * (0.5 / 0.003) ** rng.uniform() + rng.normal(size=2))


def _errors_and_misses(work: tuple[str, float, int, int, Settings]) -> Array:
    """Return errors and misses of one kind at one rate, shape (2, S)."""
    kind, rate, pieces, seed, settings = work
    found = []
    for number in range(pieces):
        rng = np.random.default_rng([seed, INK_KINDS.index(kind), round(1000 * rate), number])
        ink = draw_random_ink(kind, rate, rng)
        size = float(np.ptp(ink.position, axis=0).max())
        learned = DMP.imitate(ink, settings)
        angle = rng.uniform(0, 2 * np.pi)
        goal = learned.goal + size * np.array([np.cos(angle), np.sin(angle)])
        miss = np.linalg.norm(learned.rollout(goal=goal).position[-1] - goal)
        found.append((rms(learned.rollout().position - ink.position) / size, miss / size))
    return np.array(found).T
