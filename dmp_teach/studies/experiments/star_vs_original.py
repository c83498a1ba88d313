"""DMP* against the original form at equal numbers of kernels: error and time."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.variants import Variant
from dmp_teach.studies.inputs import RecordingsLike, Stroke, named_strokes
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory, rms

REPEATS_PER_TIMING = 5
TIMED_STROKES = 6
_TIMES: dict[tuple, float] = {}


@dataclass(frozen=True, eq=False, repr=False)
class OriginalComparison(Tabled):
    """Both forms on every stroke that the original form can learn.

    Args:
        strokes: S names.
        kernels: How many, the same for both, shape (S,).
        error: Of DMP* and of the original form, root mean square, shape (S, 2) [m].
        time_ratio: How long DMP* takes to learn and draw, as a share of what the original form
            takes: the median over six strokes, the quickest of five tries each. Measured once
            in a process, then kept.
    """

    strokes: tuple[str, ...]
    kernels: NDArray[np.int_]
    error: Array
    time_ratio: float

    @property
    def columns(self) -> Columns:
        """A row for each stroke."""
        star, original = 1e3 * self.error.T
        heads = ("stroke", "kernels", "DMP* [mm]", "original [mm]")
        return dict(zip(heads, (self.strokes, self.kernels, star, original), strict=True))


def compare_with_original(
    recordings: RecordingsLike = None,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> OriginalComparison:
    """Compare error and time of DMP* with the original form, N = Num/10 for both.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: As in `claims`; a piece is one stroke, timed here.
        progress: As in `claims`.
    """
    star = Variant(as_settings(settings))
    variants = (star, Variant(as_settings(original, Settings.original, "original")))
    strokes = named_strokes(recordings)
    found = run(_errors_of_both, [(stroke, *variants) for stroke in strokes], executor, progress)
    kept = [stroke for stroke, each in zip(strokes, found, strict=True) if each is not None]
    return OriginalComparison(
        tuple(stroke.name for stroke in kept),
        np.array([star.on(stroke.path).n_kernels for stroke in kept]),
        np.array([each for each in found if each is not None]).reshape(-1, 2),
        time_ratio([stroke.path for stroke in kept], star.settings, variants[1].settings),
    )


def _errors_of_both(piece: tuple[Stroke, Variant, Variant]) -> list[float] | None:
    """Return both errors of one stroke [m]; None where the original form refuses it."""
    stroke, *variants = piece
    path = stroke.path
    try:
        drawn = [DMP.imitate(path, each.on(path)).rollout().position for each in variants]
    except SettingError:
        return None
    return [rms(position - path.position) for position in drawn]


def time_ratio(paths: Sequence[Trajectory], settings: Settings, original: Settings) -> float:
    """Return the time of the settings over that of the original, kept for the same strokes."""
    variants, paths = (Variant(settings), Variant(original)), paths[:TIMED_STROKES]
    key = (variants, *(path.position.tobytes() for path in paths))
    if key not in _TIMES:
        ratios = [_quickest(path, variants[0]) / _quickest(path, variants[1]) for path in paths]
        _TIMES[key] = float(np.median(ratios)) if ratios else 1.0
    return _TIMES[key]


def _quickest(path: Trajectory, variant: Variant) -> float:
    """Return the shortest time of a few tries to learn and draw a stroke [s]."""
    tries = []
    for _ in range(REPEATS_PER_TIMING):
        begin = perf_counter()
        DMP.imitate(path, variant.on(path)).rollout()
        tries.append(perf_counter() - begin)
    return min(tries)
