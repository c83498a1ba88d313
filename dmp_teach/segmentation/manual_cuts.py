"""Change strokes by hand, at times [s] that are read off a plot."""

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


def move_cut(t: Array, spans: Spans, stroke: int, end: str, time: float) -> Spans:
    """Return the strokes with one end ("start" or "end") of one at another time [s]."""
    number = _number(spans, stroke)
    if end not in ("start", "end"):
        raise RecordingError(f"end is {end!r}, but must be 'start' or 'end'.")
    (a, b), at = spans[number], _sample(t, time)
    if end == "start":
        earliest = spans[number - 1][1] if number else 0
        latest = b - 2
    else:
        earliest = a + 1
        latest = (spans[number + 1][0] if number + 1 < len(spans) else len(t)) - 1
    if not earliest <= at <= latest:
        raise RecordingError(
            f"Stroke {number} cannot {end} at {float(time):.3f} s: its {end} lies between "
            f"{t[earliest]:.3f} and {t[latest]:.3f} s, so that it is a stroke and touches no "
            "other. Move or join that one first."
        )
    return _replaced(spans, number, 1, [(at, b) if end == "start" else (a, at + 1)])


def split_stroke(t: Array, spans: Spans, stroke: int, time: float) -> Spans:
    """Return the strokes with one cut in two: the second part begins at a time [s]."""
    number = _number(spans, stroke)
    (a, b), at = spans[number], _sample(t, time)
    if not a + 2 <= at <= b - 2:
        raise RecordingError(
            f"Stroke {number} lasts from {t[a]:.3f} to {t[b - 1]:.3f} s and cannot be split at "
            f"{float(time):.3f} s: both parts need 2 samples."
        )
    return _replaced(spans, number, 1, [(a, at), (at, b)])


def merge_with_next(spans: Spans, stroke: int) -> Spans:
    """Return the strokes with one and the next as one, with whatever lies between them."""
    number = _number(spans, stroke)
    if number + 1 == len(spans):
        raise RecordingError(f"Stroke {number} is the last one, so there is none to join it with.")
    return _replaced(spans, number, 2, [(spans[number][0], spans[number + 1][1])])


def drop_stroke(spans: Spans, stroke: int) -> Spans:
    """Return the other strokes."""
    number = _number(spans, stroke)
    if len(spans) == 1:
        raise RecordingError("This is the only stroke, and a letter has at least one.")
    return _replaced(spans, number, 1, [])


def _replaced(spans: Spans, number: int, count: int, new: list[tuple[int, int]]) -> Spans:
    """Return the strokes with `count` of them from `number` on replaced."""
    return (*spans[:number], *new, *spans[number + count :])


def _number(spans: Spans, stroke: int) -> int:
    """Return the number of a stroke, counted from 0, or from the end if negative."""
    if (
        isinstance(stroke, bool)
        or not isinstance(stroke, (int, np.integer))
        or not -len(spans) <= stroke < len(spans)
    ):
        raise RecordingError(
            f"stroke is {stroke!r}, but must be a whole number from 0 to {len(spans) - 1}."
        )
    return int(stroke) % len(spans)


def _sample(t: Array, time: float) -> int:
    """Return the sample nearest to a time [s] of the recording."""
    half = float(np.diff(t).max()) / 2
    if (
        isinstance(time, bool)
        or not isinstance(time, Real)
        or not t[0] - half <= time <= t[-1] + half
    ):
        raise RecordingError(
            f"A cut is at {time!r} s, but must be a time of the recording, from {t[0]:.3f} to "
            f"{t[-1]:.3f} s."
        )
    return int(np.argmin(np.abs(t - float(time))))
