"""Plain tables: text with a row of numbers for each sample, as spreadsheets and scripts write it.

Columns may be divided by commas, semicolons, tabs, bars or spaces, numbers may have a decimal
comma, and the line above them may name the columns and their units. An empty line, or one of
words, lifts the pen.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.columns import COLUMN_UNITS, FEWEST_ROWS, read_columns
from dmp_teach.formats.plain_text import decode_text
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.strangers import describe_stranger
from dmp_teach.ink import Recording

BEGIN_OF_TABLE = 20_000  # bytes of a file in which a table shows
MOST_TABLE_ROWS = 200_000
MOST_COLUMNS = 64
EVENTS = {"down": 1.0, "start": 1.0, "true": 1.0}
EVENTS |= {"up": 0.0, "end": 0.0, "cancel": 0.0, "false": 0.0}
EVENT = re.compile(rf"(?:pen|pointer|touch|mouse)?({'|'.join(EVENTS)})")
CLOCK_TIME = re.compile(r"(?:.*[t ])?(\d+):(\d\d):(\d\d(?:\.\d*)?)(?:z|[+-]\d\d:?\d\d)?")
LETTER_COLUMN = re.compile(
    r"(?:letter|char|character|label|trial|sample|demo|writer|user|subject)s?\W*(?:id)?"
)
DECIMAL_COMMA = re.compile(r"\s*-?\d+,\d+(?:\s+-?\d+,\d+)+\s*")
SIGN_BEFORE = re.compile(r"^\s*(?:#|%|//|\")?\s*")


def is_table(data: bytes) -> bool:
    """Tell whether a file is text with rows of numbers, and of no kind that has a name."""
    if b"\0" in data[:BEGIN_OF_TABLE] and not data.startswith(b"\xff\xfe"):
        return False
    if describe_stranger(data) is not None:
        return False
    lines = decode_text(data[:BEGIN_OF_TABLE]).rstrip().splitlines()
    sign = _divider(lines)
    count = sum(_numbers(line, sign) is not None for line in lines)
    return count >= FEWEST_ROWS or (count > 0 and 2 * count >= len(lines))


def read_table_of_text(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in a table; errors as `read_columns`."""
    lines = decode_text(data).rstrip().splitlines()
    if len(lines) > MOST_TABLE_ROWS:
        raise RecordingError(f"has more than {MOST_TABLE_ROWS} rows; cut it.")
    sign = _divider(lines)
    rows = [_numbers(line, sign) for line in lines]
    first = next((k for k, row in enumerate(rows) if row is not None), 0)
    width = len(rows[first] or ())
    if not 0 < width <= MOST_COLUMNS:
        raise RecordingError(f"has {width} columns; give t, x, y, and z or pressure.")
    names = _names(lines[:first], sign, width)
    _refuse_several(lines[first:], names or [], sign)
    odd = next((k for k, row in enumerate(rows) if row and len(row) > width), None)
    if odd is not None:
        raise RecordingError(
            f"row {odd + 1} has {len(rows[odd] or ())} cells, but the first one {width}; are there "
            "decimal commas? Write points."
        )
    values = np.full((len(rows) - first, width), np.nan)
    for k, row in enumerate(rows[first:]):
        values[k, : len(row or ())] = row or ()
    # Line ends of two signs may show as an empty line after each row.
    filled = ~np.isnan(values).all(axis=1)
    return read_columns(values if filled.mean() >= 0.6 else values[filled], names, name, options)


def _divider(lines: Sequence[str]) -> str | None:
    """Return the sign between columns; None for spaces."""
    for line in lines:
        if DECIMAL_COMMA.fullmatch(line):
            return "\t" if "\t" in line else None
        for sign in (";", "\t", ",", "|", None):
            row = _numbers(line, sign)
            if row is not None and np.isfinite(row).sum() > 1:
                return sign
    return None


def _cells(line: str, sign: str | None) -> list[str]:
    """Return the cells of a line, without spaces and quotation marks."""
    return [cell.strip().strip("\"'").strip() for cell in line.split(sign)]


def _numbers(line: str, sign: str | None) -> list[float] | None:
    """Return the numbers in a line; None where fewer than half of its cells are one."""
    cells = [cell.lower() for cell in _cells(line.strip("\r\n |[]"), sign)]
    row = [_number(cell if sign == "," else cell.replace(",", ".")) for cell in cells]
    found = int(np.isfinite(row).sum())
    if found < 2 or 2 * found < len(row):
        return None
    return [value if abs(value) < 1e100 else np.nan for value in row]


def _number(text: str) -> float:
    """Return the number in a cell, 1 or 0 for a word such as "penup", seconds for a time of day."""
    clock, event = CLOCK_TIME.fullmatch(text[:MOST_COLUMNS]), EVENT.fullmatch(text)
    if clock:
        return 3600 * float(clock[1]) + 60 * float(clock[2]) + float(clock[3])
    if event:
        return EVENTS[event[1]]
    try:
        return float(text.replace("_", "x"))
    except ValueError:
        return np.nan


def _refuse_several(lines: Sequence[str], names: Sequence[str], sign: str | None) -> None:
    """Raise a RecordingError where a column says of a table that it holds several letters."""
    for k, name in enumerate(names):
        if LETTER_COLUMN.fullmatch(name.strip().lower()):
            said = {cells[k] for line in lines if len(cells := _cells(line, sign)) > k}
            if 1 < len(said) <= len(lines) / FEWEST_ROWS:
                raise RecordingError(
                    f"holds {len(said)} letters, as its column {name[:40]!r} says; save each as a "
                    "table of its own."
                )


def _names(above: Sequence[str], sign: str | None, width: int) -> list[str] | None:
    """Return the names of the columns from the lines above them, however they are divided.

    A line of units below the names is added to them; None without any names.
    """
    units: list[str] = []
    for line in reversed(above):
        split = [_cells(SIGN_BEFORE.sub("", line), each) for each in (sign, ",", ";", "\t", None)]
        cells = next((each for each in split if len(each) == width and _has_word(each)), None)
        if cells is None:
            continue
        bare = [cell.strip("[]()").lower() for cell in cells]
        if not units and all(cell in COLUMN_UNITS or not cell for cell in bare):
            units = bare
        elif units:
            return [f"{cell} [{unit}]" for cell, unit in zip(cells, units, strict=True)]
        else:
            return cells
    return None


def _has_word(cells: Sequence[str]) -> bool:
    """Tell whether a cell is no number."""
    return any(re.search("[A-Za-z]", cell) for cell in cells)


FORMAT = Format("plain table", (".csv", ".txt", ".tsv"), is_table, read_table_of_text)
