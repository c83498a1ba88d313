"""DMP* against the original form at equal numbers of kernels: error and time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings, as_settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.variants import Variant, rms
from dmp_teach.studies.inputs import Stroke, strokes_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

REPEATS = 5
TIMED = 12  # strokes
_TIMES: dict[tuple, float] = {}


@dataclass(frozen=True, eq=False)
class OriginalComparison(Tabled):
    """Both forms on every stroke that the original form can learn.

    Args:
        strokes: S names.
        kernels: How many, the same for both, shape (S,).
        error: Of DMP* and of the original form, root mean square, shape (S, 2) [m].
        time_ratio: How long DMP* takes to learn and draw, in parts of what the original form takes: the median over a
            dozen strokes, the quickest of five tries each. Measured once in a process, then kept.
    """

    strokes: tuple[str, ...]
    kernels: Array
    error: Array
    time_ratio: float

    def __post_init__(self) -> None:
        """Lock the arrays."""
        object.__setattr__(self, "kernels", locked(self.kernels, dtype=int))
        object.__setattr__(self, "error", locked(self.error))

    def rows(self) -> Rows:
        """One for each stroke."""
        return tuple(
            {
                "stroke": name,
                "kernels": int(n),
                "DMP* [mm]": float(1e3 * e[0]),
                "original [mm]": float(1e3 * e[1]),
            }
            for name, n, e in zip(self.strokes, self.kernels, self.error, strict=True)
        )


def compare_with_original(
    recordings: Any = None,
    settings: Settings | None = None,
    original: Settings | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> OriginalComparison:
    """Error and time of DMP* beside the original form, N = Num/10 for both.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        settings: Of DMP*; `Settings.star()` unless given.
        original: Of the original form; `Settings.original()` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke. Times are taken here.
        progress: Called as `progress(done, total)`.
    """
    variants = (
        Variant(as_settings(settings)),
        Variant(as_settings(original, Settings.original, "original")),
    )
    strokes = strokes_of(recordings)
    found = run(_errors, [(stroke, *variants) for stroke in strokes], executor, progress)
    kept = [(stroke, each) for stroke, each in zip(strokes, found, strict=True) if each is not None]
    names, error = (
        tuple(stroke.name for stroke, _ in kept),
        np.array([each for _, each in kept]).reshape(-1, 2),
    )
    kernels = [variants[0].on(stroke.path).n_kernels for stroke, _ in kept]
    return OriginalComparison(
        names, kernels, error, _time_ratio([stroke.path for stroke, _ in kept[:TIMED]], variants)
    )


def _errors(piece: tuple[Stroke, Variant, Variant]) -> tuple[float, float] | None:
    """Both errors of one stroke [m]; None where the original form refuses it."""
    stroke, *variants = piece
    try:
        drawn = [
            DMP.imitate(stroke.path, variant.on(stroke.path)).rollout().position
            for variant in variants
        ]
    except SettingError:
        return None
    return tuple(rms(path - stroke.path.position) for path in drawn)


def _time_ratio(paths: Sequence[Trajectory], variants: tuple[Variant, Variant]) -> float:
    """How long the first variant takes, in parts of the second; the same again for the same strokes."""
    key = (variants, *(path.position.tobytes() for path in paths))
    if key not in _TIMES:
        pairs = [
            [_quickest(lambda v=v, p=p: DMP.imitate(p, v.on(p)).rollout()) for v in variants]
            for p in paths
        ]
        _TIMES[key] = float(np.median([a / b for a, b in pairs])) if pairs else 1.0
    return _TIMES[key]


def _quickest(task: Callable[[], Any]) -> float:
    """The shortest of a few tries [s]."""
    tries = []
    for _ in range(REPEATS):
        begin = perf_counter()
        task()
        tries.append(perf_counter() - begin)
    return min(tries)
