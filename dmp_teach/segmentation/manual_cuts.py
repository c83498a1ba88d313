"""Cut strokes by hand, at times [s] that are read off a plot."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.segmentation.even_clock import Spans
from dmp_teach.trajectory import Array


def cut_at_times(t: Array, times: Sequence[tuple[float, float]]) -> Spans:
    """Return strokes from pairs (first, last) of times [s], both ends part of the stroke."""
    try:
        pairs = [(first, last) for first, last in times]
    except (TypeError, ValueError):
        raise RecordingError(
            f"Strokes are {times!r}, but must be pairs (first, last) of times [s], such as "
            "[(0.7, 2.4), (3.6, 8.2)]."
        ) from None
    return tuple((_sample(t, first), _sample(t, last) + 1) for first, last in pairs)


def _sample(t: Array, time: float) -> int:
    """Return the sample nearest to a time [s] of the recording."""
    half = float(np.diff(t).max()) / 2
    is_number = isinstance(time, Real) and not isinstance(time, bool)
    if not is_number or not t[0] - half <= time <= t[-1] + half:
        raise RecordingError(
            f"A cut is at {time!r} s, but must be a time of the recording, from {t[0]:.3f} to "
            f"{t[-1]:.3f} s."
        )
    return int(np.argmin(np.abs(t - float(time))))
