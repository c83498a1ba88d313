"""When the points of flat ink were written: from a file's own times, its rate, or its durations."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.hand_pace import LIFT_DURATION
from dmp_teach.formats.inkml.channels import TraceFormat
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.trajectory import Array

TAP = 0.02  # how long a single point lasts [s]
SHORTEST_STEP = 0.0002  # no pen is looked at more often: such times are no milliseconds [s]
LONGEST_STEP = 1.0  # nor so seldom [s]
LONGEST_STROKE = 3600.0  # [s]


def trace_times(
    values: Array | None, form: TraceFormat, offset: str | None, duration: str | None, count: int
) -> Array | None:
    """Return the times of a trace (K,) [s]; None where the file does not tell them.

    Args:
        values: Its channel T, shape (K,), or None.
        form: Its format: the unit of T (milliseconds where it names none), and the sample rate.
        offset: Its `timeOffset` [ms].
        duration: Its `duration` [ms].
        count: K.

    Raises:
        RecordingError: No unit, and milliseconds would be too slow for any pen.
    """
    begin = 0.001 * (finite_number(offset) or 0.0)
    known = [] if values is None else values[np.isfinite(values)]
    if values is not None and len(known) and (count == 1 or np.ptp(known) > 0):
        return begin + values * _time_scale(values, form.channels["T"].scale)
    if form.rate is not None:
        return begin + np.arange(count) / form.rate
    seconds = 0.001 * (finite_number(duration) or 0.0)
    return begin + np.linspace(0.0, seconds, count) if seconds > 0 and count > 1 else None


def _time_scale(values: Array, scale: float | None) -> float:
    """Return the seconds in a unit of times (K,), which without a unit are ms where that can be."""
    if scale is not None:
        return scale
    step = float(np.nanmedian(np.diff(values))) if len(values) > 2 else 1.0
    if step * 0.001 > LONGEST_STEP:
        raise RecordingError(
            f"has points {step:.4g} apart in channel T, which says no unit, and would be "
            "milliseconds; give it its unit, such as units='us'."
        )
    return 1.0 if 0 < step * 0.001 < SHORTEST_STEP else 0.001


def on_one_clock(strokes: Sequence[tuple[Array, Array]]) -> list[tuple[Array, Array]]:
    """Return strokes one after the other, each time once.

    A point at the time of the one before it is left out. A single point is a dot, and lasts 20 ms.
    A stroke that begins before the one before it has ended, for its clock was its own, begins a
    pause after that one.

    Args:
        strokes: Times (K,) [s] and rows (K, D) of each.

    Raises:
        RecordingError: Time runs back inside a stroke, or a stroke takes more than an hour.
    """
    laid: list[tuple[Array, Array]] = []
    for number, (times, rows) in enumerate(strokes):
        t, row = _each_time_once(number, times, rows)
        overlaps = bool(laid) and t[0] <= laid[-1][0][-1]
        laid.append((t - t[0] + laid[-1][0][-1] + LIFT_DURATION if overlaps else t, row))
    return laid


def _each_time_once(number: int, t: Array, rows: Array) -> tuple[Array, Array]:
    """Return a stroke with each time once, and a point as a dot."""
    with np.errstate(all="ignore"):
        step = np.diff(t)
        long = t[-1] - t[0]
    if (step < 0).any() or not long < LONGEST_STROKE:
        fault = f"takes {long:.4g} s" if not long < LONGEST_STROKE else "has times that run back"
        raise RecordingError(f"stroke {number} {fault}; is the unit of channel T right?")
    fresh = np.concatenate([[True], step > 0])
    if np.count_nonzero(fresh) == 1:
        return np.array([t[0], t[0] + TAP]), np.repeat(rows[:1], 2, axis=0)
    return t[fresh], rows[fresh]
