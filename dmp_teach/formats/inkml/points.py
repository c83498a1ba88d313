"""The points of an InkML trace: values, differences and second differences.

A value may follow a sign: ! says that it is meant as it stands, ' that it is the difference from
the last one, and " the change of that difference. The sign holds for its channel until the next
one. * keeps the last value (or goes on with the last difference), ? is an unknown value, T and F
are true and false, # begins a hexadecimal number. Spaces may be left out where a sign divides.
"""

from __future__ import annotations

import re

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.inkml.channels import TraceFormat
from dmp_teach.trajectory import Array

DECIMAL = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
TOKEN = re.compile(rf"([!'\"]?)\s*(?:({DECIMAL})|([+-]?)#([0-9A-Fa-f]{{1,12}})|([TF*?]))|(,)|(\S)")
WORDS = {"T": 1.0, "F": 0.0, "*": None}
TOO_LARGE = 1e100
MOST_POINTS = 300_000  # in a file


class _ChannelState:
    """One channel on its way through a trace."""

    def __init__(self) -> None:
        self.sign, self.value = "!", np.nan
        self.step = self.bend = 0.0

    def next(self, sign: str, number: float | None) -> float:
        """Return the next value; a `number` of None goes on as before."""
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


def read_points(text: str, form: TraceFormat, most: int = MOST_POINTS) -> Array:
    """Return the points of a trace, a column for each channel, NaN for an unknown value.

    Args:
        text: What the trace holds.
        form: Its channels.
        most: More points than this are refused.

    Returns:
        Shape (K, C).

    Raises:
        RecordingError: A sign that has no place in a trace, too few or too many values in a point,
            or too many points.
    """
    states = [_ChannelState() for _ in form.channels]
    regular = sum(channel.is_regular for channel in form.channels.values())
    rows: list[list[float]] = []
    row: list[float] = []
    for match in TOKEN.finditer(text):
        sign, number, minus, digits, word, comma, odd = match.groups()
        place = text[match.start() : match.start() + 20]
        if digits:
            number = str(int(minus + digits, 16))
        if odd or (number and not abs(float(number)) < TOO_LARGE):
            raise RecordingError(f"has {place.strip()!r} where a number should be.")
        if len(row) > len(states) - (not comma):
            raise RecordingError(f"has more than {len(states)} values in a point near {place!r}.")
        if comma:
            rows.append(_whole_row(row, states, regular, len(rows)))
            row = []
            if len(rows) > most:
                raise RecordingError(f"has more than {most} points; cut it.")
        elif word == "?":
            row.append(np.nan)
        else:
            row.append(states[len(row)].next(sign, WORDS[word] if word else float(number)))
    if row or not rows:
        rows.append(_whole_row(row, states, regular, len(rows)))
    return np.array(rows).reshape(len(rows), len(states))


def _whole_row(
    row: list[float], states: list[_ChannelState], regular: int, number: int
) -> list[float]:
    """Return a point with the last value of each channel that it leaves out."""
    if len(row) < regular:
        raise RecordingError(
            f"has {len(row)} values in point {number}, but its channels need {regular}."
        )
    return row + [state.value for state in states[len(row) :]]
