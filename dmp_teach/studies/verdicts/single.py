"""What is asked of single strokes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from time import perf_counter

import numpy as np

from dmp_teach.dmp import DMP, Settings
from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.variants import Variant, rms_error
from dmp_teach.studies.inputs import Stroke, Written, named_strokes
from dmp_teach.trajectory import Trajectory

REPEATS_PER_TIMING = 5
TIMED_STROKES = 6
_TIMES: dict[tuple, float] = {}


def can_learn_original(stroke: Stroke) -> bool:
    """Return whether the original form can learn a stroke: no coordinate ends where it began."""
    try:
        DMP.imitate(stroke.path, Settings.original(n_kernels=1))
    except SettingError:
        return False
    return True


def has_open_stroke(letter: Written) -> bool:
    """Return whether the original form can learn any of a letter's strokes."""
    return any(map(can_learn_original, named_strokes(letter)))


def tell_strokes(letters: Iterable[Written]) -> str:
    """Return what is counted where strokes of letters are, such as "strokes of 5 letters"."""
    count = len(list(letters))
    return f"strokes of {count} letter{'s' * (count != 1)}"


def find_stray(piece: tuple[Trajectory, Settings]) -> float:
    """Return how far one stroke gets from its start where that is its goal [m]."""
    learned = DMP.imitate(*piece)
    away = learned.rollout(goal=learned.start).position - learned.start
    return float(np.linalg.norm(away, axis=1).max())


def find_error(piece: tuple[Trajectory, Variant, float, float]) -> float:
    """Return the error of one stroke as a share of its size."""
    path, variant, stretch, pace = piece
    t, position = path.t, path.position
    if pace != 1:
        t = np.linspace(t[0], t[-1], max(12, round(len(t) / pace)))
        position = np.column_stack([np.interp(t, path.t, x) for x in path.position.T])
        t = t[0] + (t - t[0]) / pace
    path = Trajectory(t, stretch * position)
    error = rms_error(path, variant.on(path))
    return error / float(np.ptp(path.position, axis=0).max())


def time_ratio(paths: Sequence[Trajectory], settings: Settings, other: Settings) -> float:
    """Return how long one way takes to learn and draw, as a share of what another takes.

    The median over six strokes, the quickest of five tries each, N = Num/10 for both. Measured once
    in a process, then kept.
    """
    variants, paths = (Variant(settings), Variant(other)), paths[:TIMED_STROKES]
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
