"""How many kernels, and how wide: chosen by drawing samples that were not shown."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from dmp_teach.dmp import DMP, KERNELS_PER_SECOND, Settings, as_settings
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.studies.experiments.variants import rms
from dmp_teach.studies.inputs import letters_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

ENOUGH = 1.1
"""The smallest number whose error is at most this many times the least one is chosen ..."""

TOLERANCE = 0.0003
"""... or at most this: as near as DMP* is asked to come to a hand, a third of a pen's line [m]."""

FEWEST_SAMPLES = 6
NUMBERS, MOST_NUMBERS = 24, 0.5
CHOICE_WIDTHS = (0.5, 2 / 3, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 7.0, 10.0, 20.0, 40.0, np.inf)


@dataclass(frozen=True, eq=False)
class Choice(Tabled):
    """A setting chosen by validation, and the curve that it was chosen from.

    Args:
        name: "n_kernels" or "kernel_width [1/N]".
        candidates: What was tried, rising, shape (K,).
        error: Root mean square distance of the samples that were not shown, at each, shape (K,) [m].
        taught: The same of the samples that were shown, shape (K,) [m].
        best: The candidate of the least error.
        chosen: The smallest candidate whose error is at most `ENOUGH` times the least, or `tolerance`; for widths, the
            best.
        tenth: Num/10, the paper's number of kernels.
        twelve_a_second: 12 kernels a second, our number of kernels.
        samples: Num, how many samples the strokes have.
        settings: What was given, with the choice in it, ready for `DMP.imitate`.
    """

    name: str
    candidates: Array
    error: Array
    taught: Array
    best: float
    chosen: float
    tenth: int
    twelve_a_second: int
    samples: int
    settings: Settings

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("candidates", "error", "taught"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    def rows(self) -> Rows:
        """A row for each candidate, with a word where there is something to say."""
        marks = {self.best: "least error", self.chosen: "chosen"}
        return tuple(
            {
                self.name: int(x) if self.name == "n_kernels" else float(x),
                "not shown [mm]": float(1e3 * e),
                "shown [mm]": float(1e3 * s),
                "": marks.get(x, ""),
            }
            for x, e, s in zip(self.candidates, self.error, self.taught, strict=True)
        )

    def __str__(self) -> str:
        """The table, and a sentence under it."""
        return f"{self.table()}\n{self.sentence}"

    @property
    def sentence(self) -> str:
        """The choice beside the paper's rule and ours."""
        return (
            f"Chosen: {self.name} = {self.chosen:g}. The paper's Num/10 is {self.tenth} for {self.samples} samples; "
            f"12 kernels a second are {self.twelve_a_second}."
        )


def choose_kernels(
    trajectory: Any,
    settings: Settings | None = None,
    candidates: Sequence[int] | None = None,
    tolerance: float = TOLERANCE,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Choice:
    """How many kernels one stroke needs: learned from every second sample, tried on the others.

    Args:
        trajectory: A stroke (`Trajectory`), or a recording of one stroke. For a letter of several, choose for each of
            `recording.strokes()`: they need different numbers.
        settings: All but the number; `Settings.star()` unless given.
        candidates: Numbers of kernels; None: 24 of them, from 2 to half of the samples that are shown, with Num/10 and
            12 a second among them.
        tolerance: An error below which nobody gains anything from more kernels [m]; 0 to go by validation alone.
        executor: Any `concurrent.futures.Executor`; a piece of work is one candidate.
        progress: Called as `progress(done, total)`.

    Raises:
        TrajectoryError: Several strokes, or fewer than 6 samples.
        SettingError: A number that is out of range or greater than the number of samples that are shown.
    """
    path, base = _one_stroke(trajectory), as_settings(settings)
    rules = _rules(path)
    shown = (len(path) + 1) // 2
    if candidates is None:
        most = max(2, round(MOST_NUMBERS * shown))
        numbers = np.unique(np.round(np.geomspace(min(2, most), most, NUMBERS)).astype(int))
        candidates = sorted({*numbers.tolist(), *(n for n in rules if n <= shown)})
    candidates = sorted(candidates)
    named = [replace(base, n_kernels=n) for n in candidates]
    error, taught = _validated(path, named, executor, progress)
    enough = int(np.argmax(error <= max(ENOUGH * error.min(), tolerance)))
    picked = replace(base, n_kernels=candidates[enough])
    best, chosen = candidates[int(error.argmin())], candidates[enough]
    return Choice("n_kernels", candidates, error, taught, best, chosen, *rules, len(path), picked)


def choose_width(
    trajectory: Any,
    settings: Settings | None = None,
    candidates: Sequence[float] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Choice:
    """How wide kernels should be, in 1/N, by the same validation; arguments and errors as `choose_kernels`."""
    path, base = _one_stroke(trajectory), as_settings(settings)
    candidates = sorted(CHOICE_WIDTHS if candidates is None else candidates)
    named = [replace(base, kernel_width=width) for width in candidates]
    error, taught = _validated(path, named, executor, progress)
    best = candidates[int(error.argmin())]
    picked = replace(base, kernel_width=best)
    return Choice(
        "kernel_width [1/N]",
        candidates,
        error,
        taught,
        best,
        best,
        *_rules(path),
        len(path),
        picked,
    )


def _rules(path: Trajectory) -> tuple[int, int]:
    """Num/10, and 12 kernels a second."""
    return max(1, round(len(path) / 10)), max(1, round(KERNELS_PER_SECOND * path.duration))


def _one_stroke(trajectory: Any) -> Trajectory:
    """The stroke of whatever was given, or a sentence."""
    strokes = (
        (trajectory,)
        if isinstance(trajectory, Trajectory)
        else letters_of((trajectory,))[0].strokes
    )
    if len(strokes) != 1:
        raise TrajectoryError(
            f"This letter has {len(strokes)} strokes, which need kernels of their own: choose for each of "
            "recording.strokes()."
        )
    if len(strokes[0]) < FEWEST_SAMPLES:
        raise TrajectoryError(
            f"The stroke has {len(strokes[0])} samples, but validation needs {FEWEST_SAMPLES}."
        )
    return strokes[0]


def _validated(
    path: Trajectory,
    settings: Sequence[Settings],
    executor: Executor | None,
    progress: Progress | None,
) -> tuple[Array, Array]:
    """The errors of the samples that were not shown, and of those that were, shape (K,) each [m]."""
    if not settings:
        raise SettingError("candidates is empty; give at least one, or None for ours.")
    found = np.array(run(_tried, [(path, each) for each in settings], executor, progress))
    return found[:, 0], found[:, 1]


def _tried(piece: tuple[Trajectory, Settings]) -> tuple[float, float]:
    """Learned from samples 0, 2, 4 ...; the errors of 1, 3, 5 ..., by a cubic through the drawing, and of 0, 2, 4."""
    path, settings = piece
    shown = Trajectory(path.t[::2], path.position[::2])
    drawn = DMP.imitate(shown, settings).rollout()
    hidden = np.arange(1, len(path), 2)
    hidden = hidden[path.t[hidden] <= shown.t[-1]]
    between = CubicSpline(drawn.t, drawn.position)(path.t[hidden])
    return rms(between - path.position[hidden]), rms(drawn.position - shown.position)
