"""The number of kernels and their width, chosen by validation on samples that were left out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, KERNELS_PER_SECOND, Settings, as_settings
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.ink import Recording
from dmp_teach.studies.inputs import list_letters
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, rms

# The smallest number is chosen whose error is at most this many times the least one, or at most
# this: as near as DMP* is asked to come to a hand, a third of a pen's line [m].
ERROR_MARGIN = 1.1
ERROR_TOLERANCE = 0.0003

FEWEST_VALIDATION_SAMPLES = 6
# How many numbers are tried, up to this share of the samples that are shown.
NUMBERS_TRIED = 24
LARGEST_SHARE_OF_SAMPLES = 0.5
WIDTHS_TRIED = (0.5, 2 / 3, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 7.0, 10.0, 20.0, 40.0, np.inf)


@dataclass(frozen=True, eq=False, repr=False)
class Choice(Tabled):
    """A setting chosen by validation, and the curve that it was chosen from.

    Args:
        name: "n_kernels" or "kernel_width [1/N]".
        candidates: What was tried, rising, shape (K,).
        error: Root mean square distance of the samples that were not shown, shape (K,) [m].
        taught: The same of the samples that were shown, shape (K,) [m].
        best: The candidate of the least error.
        chosen: The smallest candidate whose error is at most 1.1 times the least, or `tolerance`;
            for widths, the best.
        tenth: Num/10, the paper's number of kernels.
        twelve_a_second: 12 kernels a second, our number of kernels.
        samples: Num, how many samples the stroke has.
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

    @property
    def columns(self) -> Columns:
        """A row for each candidate, marked where it is the best or chosen."""
        marks = {self.best: "least error", self.chosen: "chosen"}
        return {
            self.name: self.candidates,
            "not shown [mm]": 1e3 * self.error,
            "shown [mm]": 1e3 * self.taught,
            "": [marks.get(x, "") for x in self.candidates],
        }

    def __str__(self) -> str:
        return f"{self.table()}\n{self.sentence}"

    @property
    def sentence(self) -> str:
        """The choice beside the paper's rule and ours."""
        return (
            f"Chosen: {self.name} = {self.chosen:g}. The paper's Num/10 is {self.tenth} for "
            f"{self.samples} samples; 12 kernels a second are {self.twelve_a_second}."
        )


@checked
def choose_kernels(
    trajectory: Trajectory | Recording,
    settings: Settings | None = None,
    candidates: Sequence[int] | None = None,
    tolerance: float = ERROR_TOLERANCE,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Choice:
    """Choose how many kernels one stroke needs: learned from every second sample, tried on others.

    Args:
        trajectory: A stroke (`Trajectory`), or a recording of one stroke. For a letter of several,
            choose for each of `recording.strokes()`: they need different numbers.
        settings: All but the number; `Settings.star()` unless given.
        candidates: Numbers of kernels; None: 24 of them, from 2 to half of the samples that are
            shown, with Num/10 and 12 a second among them.
        tolerance: An error below which more kernels gain nothing [m]; 0 for validation alone.
        executor: As in `claims`; a piece of work is one candidate.
        progress: As in `claims`.

    Raises:
        TrajectoryError: Several strokes, or fewer than 6 samples.
        SettingError: A number that is out of range or greater than the samples that are shown.
    """
    path, base = _one_stroke(trajectory), as_settings(settings)
    shown = (len(path) + 1) // 2
    if candidates is None:
        most = max(2, round(LARGEST_SHARE_OF_SAMPLES * shown))
        spread = np.round(np.geomspace(min(2, most), most, NUMBERS_TRIED)).astype(int)
        candidates = [*spread.tolist(), *(n for n in _rules_of_thumb(path) if n <= shown)]
    named = {n: replace(base, n_kernels=n) for n in sorted(candidates)}
    found = run(_validate, [(path, each) for each in named.values()], executor, progress)
    return _choice("n_kernels", path, named, found, tolerance)


@checked
def choose_width(
    trajectory: Trajectory | Recording,
    settings: Settings | None = None,
    candidates: Sequence[float] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Choice:
    """Choose how wide kernels should be, in 1/N, by the same validation.

    Args:
        trajectory: As in `choose_kernels`.
        settings: All but the width; `Settings.star()` unless given.
        candidates: Kernel widths [1/N].
        executor: As in `claims`; a piece of work is one candidate.
        progress: As in `claims`.

    Raises:
        TrajectoryError: As in `choose_kernels`.
        SettingError: A width that is out of range.
    """
    path, base = _one_stroke(trajectory), as_settings(settings)
    widths = sorted(WIDTHS_TRIED if candidates is None else candidates)
    named = {width: replace(base, kernel_width=width) for width in widths}
    found = run(_validate, [(path, each) for each in named.values()], executor, progress)
    return _choice("kernel_width [1/N]", path, named, found)


# Any: a number of kernels, or a width.
def _choice(
    name: str,
    path: Trajectory,
    named: Mapping[Any, Settings],
    found: Sequence[tuple[float, float]],
    tolerance: float | None = None,
) -> Choice:
    """Return the choice among settings, the best of them where there is no tolerance."""
    if not named:
        raise SettingError("candidates is empty; give at least one, or None for ours.")
    values, (error, taught) = list(named), np.array(found).T
    best = chosen = values[int(error.argmin())]
    if tolerance is not None:
        near_enough = error <= max(ERROR_MARGIN * error.min(), tolerance)
        chosen = values[int(np.argmax(near_enough))]
    rules = _rules_of_thumb(path)
    tried = np.array(values, dtype=float)
    return Choice(name, tried, error, taught, best, chosen, *rules, len(path), named[chosen])


def _rules_of_thumb(path: Trajectory) -> tuple[int, int]:
    """Return Num/10, and 12 kernels a second."""
    return max(1, round(len(path) / 10)), max(1, round(KERNELS_PER_SECOND * path.duration))


def _one_stroke(trajectory: Trajectory | Recording) -> Trajectory:
    """Return the one stroke of what was given, checked."""
    strokes = list_letters((trajectory,))[0].strokes
    if len(strokes) != 1:
        raise TrajectoryError(
            f"This letter has {len(strokes)} strokes, which need kernels of their own: choose for "
            "each of recording.strokes()."
        )
    if len(strokes[0]) < FEWEST_VALIDATION_SAMPLES:
        raise TrajectoryError(
            f"The stroke has {len(strokes[0])} samples, but validation needs "
            f"{FEWEST_VALIDATION_SAMPLES}."
        )
    return strokes[0]


def _validate(piece: tuple[Trajectory, Settings]) -> tuple[float, float]:
    """Return the errors of samples 1, 3, 5 ..., and of 0, 2, 4 ..., which were learned."""
    path, settings = piece
    shown = Trajectory(path.t[::2], path.position[::2])
    drawn = DMP.imitate(shown, settings).rollout()
    hidden = np.arange(1, len(path), 2)
    hidden = hidden[path.t[hidden] <= shown.t[-1]]
    between = CubicSpline(drawn.t, drawn.position)(path.t[hidden])
    return rms(between - path.position[hidden]), rms(drawn.position - shown.position)
