"""The points of an InkML trace: values, differences and second differences, as the recommendation has them.

A value may follow a sign: ! says that it is meant as it stands, ' that it is the difference from the last one, and "
the change of that difference. The sign holds for its channel until the next one. * keeps the last value (or goes on
with the last difference), ? is a value that nobody knows, T and F are true and false, # begins a hexadecimal number.
Spaces may be left out where a sign divides.
"""

from __future__ import annotations

import re

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.inkml.channels import TraceFormat
from dmp_teach.trajectory import Array

TOKEN = re.compile(
    r"([!'\"]?)\s*(?:([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)|([+-]?)#([0-9A-Fa-f]{1,12})|([TF*?]))|(,)|(\S)"
)
TOO_LARGE = 1e100
MOST = 300_000  # points in a file


class _Counter:
    """One channel on its way through a trace."""

    def __init__(self):
        self.sign, self.value, self.step, self.bend = "!", np.nan, 0.0, 0.0

    def next(self, sign: str, number: float | None) -> float:
        """The next value; a `number` of None goes on as before."""
        self.sign = sign or self.sign
        if self.sign == "!":
            self.value = self.value if number is None else number
            self.step = self.bend = 0.0
        elif self.sign == "'":
            self.step = self.step if number is None else number
            self.value += self.step
        else:
            self.bend = self.bend if number is None else number
            self.step += self.bend
            self.value += self.step
        return self.value


def points_of(text: str, form: TraceFormat, most: int = MOST) -> Array:
    """The points of a trace, shape (K, C), a column for each channel; NaN where a value is not known.

    Args:
        text: What the trace holds.
        form: Its channels.
        most: More points than this are refused.

    Raises:
        RecordingError: A sign that has no place in a trace, too few or too many values in a point, or too many points.
    """
    counters = [_Counter() for _ in form.channels]
    regular = sum(channel.regular for channel in form.channels)
    rows, row = [], []
    for match in TOKEN.finditer(text):
        sign, number, minus, digits, word, comma, odd = match.groups()
        if odd or len(row) > len(counters) - (not comma):
            _refuse(odd, text, match.start(), len(counters))
        if comma:
            _finish(rows, row, counters, regular)
            row = []
            if len(rows) > most:
                raise RecordingError(f"has more than {most} points; cut it.")
            continue
        if digits:
            number = str(int(minus + digits, 16))
        if number and not abs(float(number)) < TOO_LARGE:
            _refuse(number, text, match.start(), len(counters))
        counter = counters[len(row)]
        known = {"T": 1.0, "F": 0.0}.get(word) if word else float(number)
        row.append(np.nan if word == "?" else counter.next(sign, known))
    if row or not rows:
        _finish(rows, row, counters, regular)
    return np.array(rows, dtype=float).reshape(len(rows), len(counters))


def _finish(rows: list, row: list, counters: list[_Counter], regular: int) -> None:
    """End a point: what may be left out keeps its last value."""
    if len(row) < regular:
        raise RecordingError(
            f"has {len(row)} values in point {len(rows)}, but its channels need {regular}."
        )
    rows.append(row + [counter.value for counter in counters[len(row) :]])


def _refuse(odd: str | None, text: str, place: int, channels: int) -> None:
    """Say what has no place in a trace."""
    if odd:
        raise RecordingError(f"has {text[place : place + 20].strip()!r} where a number should be.")
    raise RecordingError(
        f"has more than {channels} values in a point near {text[place : place + 20]!r}."
    )
