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


def read_points(text: str, channels: int, least: int, most: int = MOST_POINTS) -> Array:
    """Return the points of a trace, a column for each channel, NaN for an unknown value.

    Args:
        text: What the trace holds.
        channels: How many there are: C. Those that a point leaves out keep their last value.
        least: How many a point must have.
        most: More points than this are refused.

    Returns:
        Shape (K, C).

    Raises:
        RecordingError: A sign that has no place in a trace, too few or too many values in a point,
            or too many points.
    """
    states = [_ChannelState() for _ in range(channels)]
    rows: list[list[float]] = []
    row: list[float] = []

    def end_point() -> None:
        if len(row) < least:
            raise RecordingError(
                f"has {len(row)} values in point {len(rows)}, but its channels need {least}."
            )
        rows.append([*row, *(state.value for state in states[len(row) :])])
        row.clear()

    for match in TOKEN.finditer(text):
        sign, number, minus, digits, word, comma, odd = match.groups()
        place = text[match.start() : match.start() + 20]
        if digits:
            number = str(int(minus + digits, 16))
        if odd or (number and not abs(float(number)) < TOO_LARGE):
            raise RecordingError(f"has {place.strip()!r} where a number should be.")
        if comma:
            end_point()
        elif len(row) == channels:
            raise RecordingError(f"has more than {channels} values in a point near {place!r}.")
        elif word == "?":
            row.append(np.nan)
        else:
            row.append(states[len(row)].next(sign, WORDS[word] if word else float(number)))
        if len(rows) > most:
            raise RecordingError(f"has more than {most} points; cut it.")
    if row or not rows:
        end_point()
    return np.array(rows)
