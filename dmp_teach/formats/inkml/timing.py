"""When the points of flat ink were written: from a file's own times, its rate, or its durations."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.hand_pace import PAUSE
from dmp_teach.formats.inkml.channels import TraceFormat
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.trajectory import Array

TAP = 0.02  # how long a single point lasts [s]
FASTEST = 0.0002  # no pen is looked at more often: such times are no milliseconds [s]
SLOWEST = 1.0  # nor so seldom [s]
LONGEST = 3600.0  # nobody writes one stroke so long [s]


def times_of(
    values: Array | None, form: TraceFormat, offset: str | None, duration: str | None, count: int
) -> Array | None:
    """The times of a trace (K,) [s]; None where the file does not tell them.

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
    if (
        values is not None
        and np.isfinite(values).any()
        and (count == 1 or np.nanmax(values) > np.nanmin(values))
    ):
        scale = form.find("T").scale
        if scale is None:
            step = float(np.nanmedian(np.diff(values))) if count > 2 else 1.0
            if step * 0.001 > SLOWEST:
                raise RecordingError(
                    f"has points {step:.4g} apart in channel T, which says no unit, and would be milliseconds; give it "
                    "its unit, such as units='us'."
                )
            scale = 1.0 if 0 < step * 0.001 < FASTEST else 0.001
        return begin + values * scale
    if form.rate is not None:
        return begin + np.arange(count) / form.rate
    seconds = 0.001 * (finite_number(duration) or 0.0)
    return begin + np.linspace(0.0, seconds, count) if seconds > 0 and count > 1 else None


def one_clock(strokes: Sequence[tuple[Array, Array]]) -> list[tuple[Array, Array]]:
    """Strokes one after the other, each time once.

    A point at the time of the one before it is left out. A single point is a dot, and lasts 20 ms. A stroke that begins
    before the one before it has ended, for its clock was its own, begins a pause after that one.

    Args:
        strokes: Times (K,) [s] and rows (K, D) of each.

    Raises:
        RecordingError: Time runs back inside a stroke, or a stroke takes more than an hour.
    """
    laid: list[tuple[Array, Array]] = []
    for number, (times, rows) in enumerate(strokes):
        t, row = _once(number, times, rows)
        overlaps = bool(laid) and t[0] <= laid[-1][0][-1]
        laid.append((t - t[0] + laid[-1][0][-1] + PAUSE if overlaps else t, row))
    return laid


def _once(number: int, t: Array, rows: Array) -> tuple[Array, Array]:
    """A stroke with each time once, and a point as a dot; raise where its times cannot be."""
    with np.errstate(all="ignore"):
        step, long = np.diff(t), t[-1] - t[0]
    if (step < 0).any() or not long < LONGEST:
        fault = f"takes {long:.4g} s" if not long < LONGEST else "has times that run back"
        raise RecordingError(f"stroke {number} {fault}; is the unit of channel T right?")
    fresh = np.concatenate([[True], step > 0])
    if np.count_nonzero(fresh) == 1:
        return np.array([t[0], t[0] + TAP]), np.repeat(rows[:1], 2, axis=0)
    return t[fresh], rows[fresh]
