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


def read_points(text: str, channels: int, least: int, most: int = MOST_POINTS) -> Array:
    """Return the points of a trace, NaN for an unknown value.

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
    # Of each channel: its value, its difference and its second one, and which of them is written.
    states, orders = [[np.nan, 0.0, 0.0] for _ in range(channels)], [0] * channels
    rows: list[list[float]] = [[]]
    for match in TOKEN.finditer(text):
        sign, number, minus, digits, word, comma, odd = match.groups()
        row, place = rows[-1], text[match.start() : match.start() + 20]
        if digits:
            number = str(int(minus + digits, 16))
        if odd or (number and not abs(float(number)) < TOO_LARGE):
            raise RecordingError(f"has {place.strip()!r} where a number should be.")
        if comma:
            _fill(rows, states, least)
            rows.append([])
        elif len(row) == channels:
            raise RecordingError(f"has more than {channels} values in a point near {place!r}.")
        elif word == "?":
            row.append(np.nan)
        else:
            k = len(row)
            orders[k] = "!'\"".index(sign) if sign else orders[k]
            row.append(_next(states[k], orders[k], WORDS[word] if word else float(number)))
        if len(rows) > most + 1:
            raise RecordingError(f"has more than {most} points; cut it.")
    if rows[-1] or len(rows) == 1:
        _fill(rows, states, least)
    return np.array([row for row in rows if row])


def _next(state: list[float], order: int, number: float | None) -> float:
    """Return the next value of a channel; a `number` of None goes on as before."""
    if number is not None:
        state[order] = number
    if order == 0:
        state[1:] = [0.0, 0.0]
    for k in range(order, 0, -1):
        state[k - 1] += state[k]
    return state[0]


def _fill(rows: list[list[float]], states: list[list[float]], least: int) -> None:
    """Give the last point the values that it leaves out."""
    row = rows[-1]
    if len(row) < least:
        raise RecordingError(
            f"has {len(row)} values in point {len(rows) - 1}, but its channels need {least}."
        )
    row += [state[0] for state in states[len(row) :]]
