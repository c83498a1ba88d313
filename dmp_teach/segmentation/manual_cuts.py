"""Cuts moved by hand: strokes as pairs of samples, changed at times that somebody reads off a plot."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.trajectory import Array

Spans = tuple[tuple[int, int], ...]


def timed(t: Array, times: Sequence[tuple[float, float]]) -> Spans:
    """Strokes from pairs (first, last) of times [s], both ends part of the stroke."""
    try:
        pairs = [(first, last) for first, last in times]
    except (TypeError, ValueError):
        raise RecordingError(
            f"Strokes are {times!r}, but must be pairs (first, last) of times [s], such as [(0.7, 2.4), (3.6, 8.2)]."
        ) from None
    return tuple((_sample(t, first), _sample(t, last) + 1) for first, last in pairs)


def moved(t: Array, spans: Spans, stroke: int, end: str, time: float) -> Spans:
    """One end ("start" or "end") of a stroke at another time [s]; the other strokes stay."""
    number = _number(spans, stroke)
    if end not in ("start", "end"):
        raise RecordingError(f"end is {end!r}, but must be 'start' or 'end'.")
    (a, b), at = spans[number], _sample(t, time)
    earliest = a + 1 if end == "end" else spans[number - 1][1] if number else 0
    latest = (
        b - 2
        if end == "start"
        else (spans[number + 1][0] if number + 1 < len(spans) else len(t)) - 1
    )
    if not earliest <= at <= latest:
        raise RecordingError(
            f"Stroke {number} cannot {end} at {float(time):.3f} s: its {end} lies between {t[earliest]:.3f} and "
            f"{t[latest]:.3f} s, so that it is a stroke and touches no other. Move or join that one first."
        )
    return _replaced(spans, number, 1, [(at, b) if end == "start" else (a, at + 1)])


def split(t: Array, spans: Spans, stroke: int, time: float) -> Spans:
    """A stroke in two: the second one begins at a time [s], and no sample is lost."""
    number = _number(spans, stroke)
    (a, b), at = spans[number], _sample(t, time)
    if not a + 2 <= at <= b - 2:
        raise RecordingError(
            f"Stroke {number} lasts from {t[a]:.3f} to {t[b - 1]:.3f} s and cannot be split at {float(time):.3f} s: "
            "both parts need 2 samples."
        )
    return _replaced(spans, number, 1, [(a, at), (at, b)])


def joined(spans: Spans, stroke: int) -> Spans:
    """A stroke and the next one as one stroke, with whatever lies between them."""
    number = _number(spans, stroke)
    if number + 1 == len(spans):
        raise RecordingError(f"Stroke {number} is the last one, so there is none to join it with.")
    return _replaced(spans, number, 2, [(spans[number][0], spans[number + 1][1])])


def without(spans: Spans, stroke: int) -> Spans:
    """The other strokes."""
    number = _number(spans, stroke)
    if len(spans) == 1:
        raise RecordingError("This is the only stroke, and a letter has at least one.")
    return _replaced(spans, number, 1, [])


def _replaced(spans: Spans, number: int, count: int, new: list[tuple[int, int]]) -> Spans:
    """`count` strokes from `number` on, replaced."""
    return (*spans[:number], *new, *spans[number + count :])


def _number(spans: Spans, stroke: int) -> int:
    """The stroke that is meant, counted from 0, or from the end if negative."""
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
    """The sample nearest to a time [s] of the recording."""
    half = float(np.diff(t).max()) / 2
    if (
        isinstance(time, bool)
        or not isinstance(time, Real)
        or not t[0] - half <= time <= t[-1] + half
    ):
        raise RecordingError(
            f"A cut is at {time!r} s, but must be a time of the recording, from {t[0]:.3f} to {t[-1]:.3f} s."
        )
    return int(np.argmin(np.abs(t - float(time))))
