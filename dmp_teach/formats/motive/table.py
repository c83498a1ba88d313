"""The table in a Motive CSV file: its header, its columns by marker, its cells, its times.

The header is found by its content: the row `Frame, Time`, and above it the rows that say of every
column its type (`Marker`, `Rigid Body`, ...), its name, and its quantity (`Position`, ...). Rows
are counted as in an editor, from 1.
"""

from __future__ import annotations

import codecs
import csv
import io
import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.trajectory import Array

MOST_NAMES = 20  # in a sentence
LONGEST_NAME = 60  # in a sentence [characters]
LONGEST_ROW_STEP = 60.0  # no take waits longer from row to row [s]
METRES_BY_NAMES = {
    1.0: ("m", "meter", "meters", "metre", "metres"),
    0.01: ("cm", "centimeter", "centimeters", "centimetre", "centimetres"),
    0.001: ("mm", "millimeter", "millimeters", "millimetre", "millimetres"),
    0.0254: ("in", "inch", "inches"),
    0.3048: ("ft", "foot", "feet"),
}
LENGTH_UNITS = {name: metres for metres, names in METRES_BY_NAMES.items() for name in names}
OTHER_COMMA = re.compile(r"[\"\s]*frame[\"\s]*([;\t])[\"\s]*time", re.IGNORECASE)
# Times with more decimals do not repeat because they were rounded, with fewer they are uneven.
FEW_DECIMALS = 3
UTF16_MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
Rows = list[list[str]]
MarkerKey = tuple[str, int]  # a marker's name, and which of several of that name


@dataclass(frozen=True)
class Table:
    """What a file holds.

    Args:
        name: The file's name, for messages.
        top: The rows over `Frame, Time`.
        axes: That row.
        body: The frames under it, each with its row in the file, from 1; empty rows left out.
        scale: Metres in one of its units of length.
        markers: The columns X, Y, Z of every marker.
        bodies: The names of the rigid bodies.
    """

    name: str
    top: Rows
    axes: list[str]
    body: list[tuple[int, list[str]]]
    scale: float
    markers: dict[MarkerKey, dict[str, int]]
    bodies: frozenset[str]


def read_table(data: bytes, name: str) -> Table:
    """Read the table in a file's bytes.

    Raises:
        RecordingError: It is no such CSV, has no markers, or its unit is unknown.
    """
    rows = _rows(data, name)
    head = _head(rows, name)
    top, scale = rows[:head], _scale(rows[:head], name)
    markers = _markers(top, rows[head], name)
    body = [
        (k, row)
        for k, row in enumerate(rows[head + 1 :], head + 2)
        if any(cell.strip() for cell in row)
    ]
    if not body:
        raise RecordingError(f"{name} has a header but no frames under it; export the take again.")
    return Table(name, top, rows[head], body, scale, markers, _bodies(top))


def _rows(data: bytes, name: str) -> Rows:
    """Return the file as cells."""
    wide = data.startswith(UTF16_MARKS)  # as Excel saves Unicode
    if b"\0" in data and not wide:
        raise RecordingError(f"{name} is not text; export the take from Motive as CSV.")
    try:
        text = io.StringIO(
            data.decode("utf-16" if wide else "utf-8-sig", errors="replace"), newline=""
        )
        return list(csv.reader(text, skipinitialspace=True))
    except csv.Error as error:
        raise RecordingError(
            f"{name} is not a CSV file: {error}. Export the take from Motive as CSV."
        ) from None


def _head(rows: Rows, name: str) -> int:
    """Return the row, from 0, that begins `Frame, Time`."""
    for k, row in enumerate(rows):
        cells = [cell.strip().lower() for cell in row[:2]]
        if len(cells) == 2 and cells[0] == "frame" and cells[1].startswith("time"):
            return k
        if row and (other := OTHER_COMMA.match(row[0])):
            sign = "semicolons" if other[1] == ";" else "tabs"
            raise RecordingError(
                f"{name}, row {k + 1}: columns are not separated by commas but by {sign}; export "
                "with commas."
            )
    raise RecordingError(
        f"{name} has no header row that begins 'Frame,Time'; export the take from Motive as CSV."
    )


def _header_value(top: Rows, wanted: str) -> tuple[int, str] | None:
    """Return what the first rows say of something, and in which row, from 1."""
    for k, row in enumerate(top, 1):
        for key, value in pairwise(row):
            if key.strip().lower() == wanted:
                return k, value.strip()
    return None


def _scale(top: Rows, name: str) -> float:
    """Return the metres in a unit of the file, which is metres where it says nothing."""
    said = _header_value(top, "length units")
    if said is None:
        return 1.0
    if (unit := said[1].lower().rstrip(".")) not in LENGTH_UNITS:
        raise RecordingError(
            f"{name}, row {said[0]}: 'Length Units' is {said[1][:40]!r}, but must be Meters, "
            "Centimeters, Millimeters, "
            "Inches or Feet; export again."
        )
    return LENGTH_UNITS[unit]


def _type_row(top: Rows, kind: str) -> int | None:
    """Return the row, from 0, that says of some column that it is of this type."""
    return next(
        (k for k, row in enumerate(top) if any(cell.strip().lower() == kind for cell in row)), None
    )


def _markers(top: Rows, axes: list[str], name: str) -> dict[MarkerKey, dict[str, int]]:
    """Return the columns X, Y, Z of every marker; twins of one name are counted."""
    kinds = _type_row(top, "marker")
    if kinds is None or kinds + 1 >= len(top):
        raise RecordingError(
            f"{name} has no marker columns: no row over 'Frame,Time' says 'Marker'. Export with "
            "markers switched on."
        )
    quantities = next(
        (row for row in top[kinds + 1 :] if any(c.strip().lower() == "position" for c in row)), []
    )
    found: dict[MarkerKey, dict[str, int]] = {}
    twins: dict[tuple[str, str], int] = {}
    for j, cells in enumerate(zip(top[kinds], top[kinds + 1], quantities, axes, strict=False)):
        kind, label, quantity, axis = (cell.strip() for cell in cells)
        axis = axis.upper()
        if kind.lower() != "marker" or quantity.lower() != "position" or axis not in list("XYZ"):
            continue
        twin = twins[label, axis] = twins.get((label, axis), -1) + 1
        found.setdefault((label, twin), {})[axis] = j
    whole = {key: columns for key, columns in found.items() if len(columns) == 3}
    if not whole:
        raise RecordingError(
            f"{name}, rows {kinds + 1} to {len(top) + 1}: no marker has the columns X, Y and Z of "
            "its Position. Export "
            "the positions of the markers."
        )
    return whole


def _bodies(top: Rows) -> frozenset[str]:
    """Return the names of the rigid bodies."""
    kinds = _type_row(top, "rigid body")
    if kinds is None or kinds + 1 >= len(top):
        return frozenset()
    named = zip(top[kinds], top[kinds + 1], strict=False)
    return frozenset(
        label.strip() for kind, label in named if kind.strip().lower() == "rigid body"
    ) - {""}


def list_names(names: Iterable[str]) -> str:
    """Return names for a sentence, each once, not too many and none too long."""
    shown = list(
        dict.fromkeys(
            name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]} ..." for name in names
        )
    )
    return ", ".join(map(repr, shown[:MOST_NAMES])) + (", ..." if len(shown) > MOST_NAMES else "")


def check_width(table: Table) -> None:
    """Raise where a row has more cells than the header, as after a decimal comma."""
    columns = len(table.axes)
    for k, row in table.body:
        if any(cell.strip() for cell in row[columns:]):
            raise RecordingError(
                f"{table.name}, row {k}: there are {len(row)} cells, but the header has {columns} "
                "columns. "
                "Is there a decimal comma, such as 0,5? Export with points."
            )


def cell_number(
    row: list[str], column: int, place: str, what: str, may_be_empty: bool = False
) -> float:
    """Return the number in a cell, NaN for an empty one where that may be."""
    cell = row[column].strip() if column < len(row) else ""
    if not cell and may_be_empty:
        return np.nan
    try:
        value = float(cell.replace("_", "x"))  # Python takes 1_0 for ten
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        shown = cell if len(cell) < 40 else f"{cell[:36]} ..."
        cure = (
            "leave the cell empty where the camera saw nothing"
            if may_be_empty
            else "every frame needs its time"
        )
        raise RecordingError(
            f"{place}, column {column + 1} ({what}): {shown!r} is not a number; {cure}."
        )
    return value


def frame_times(table: Table) -> Array:
    """Return the times of the frames (T,) [s], strictly increasing.

    Times that were rounded to hundredths, or so much that they repeat, come from the frames'
    numbers and the rate instead, where that gives the same times, rounded.

    Raises:
        RecordingError: Time stands still, runs back or leaps.
    """
    t = np.array([cell_number(row, 1, f"{table.name}, row {k}", "Time") for k, row in table.body])
    stands = bool((np.diff(t) == 0).any())
    decimals = max(len(row[1].strip().partition(".")[2]) for _, row in table.body)
    rounded = stands and 1 <= decimals <= FEW_DECIMALS
    if (rounded or 1 <= decimals < FEW_DECIMALS) and (
        exact := _times_from_frames(table, t, 10.0**-decimals)
    ) is not None:
        return exact
    odd = np.flatnonzero((np.diff(t) <= 0) | (np.diff(t) > LONGEST_ROW_STEP))
    if not len(odd):
        return t
    k, cure = int(odd[0]) + 1, "Export the take again, or delete the row."
    if stands and decimals == 0 and _is_torn(table, k):
        cure = "Is there a decimal comma, such as 0,5? Export with points."
    elif rounded:
        cure = "Export the times with more decimals."
    raise RecordingError(
        f"{table.name}, row {table.body[k][0]}, column 2 (Time): {t[k]:.6g} s after "
        f"{t[k - 1]:.6g} s; time must "
        f"increase from row to row, by at most {LONGEST_ROW_STEP:.0f} s. {cure}"
    )


def _times_from_frames(table: Table, t: Array, ulp: float) -> Array | None:
    """Return times from the frames' numbers and the rate; None where those are others, rounded."""
    frames = np.array([finite_number(row[0]) or 0.0 for _, row in table.body])
    if (np.diff(frames) <= 0).any() or (frames != np.round(frames)).any():
        return None
    for wanted in ("export frame rate", "capture frame rate"):
        said = _header_value(table.top, wanted)
        rate = finite_number(said[1]) if said else None
        if rate is None or not 1 <= rate <= 10_000:
            continue
        exact = frames / rate
        off = t - exact
        if np.ptp(off) <= 1.01 * ulp and np.diff(exact).max() <= LONGEST_ROW_STEP:
            return exact if np.abs(off).max() <= 1.01 * ulp else exact + np.median(off)
    return None


def _is_torn(table: Table, k: int) -> bool:
    """Tell whether two frames look as if their numbers were torn at a decimal comma."""
    rows = [row for _, row in table.body[k - 1 : k + 1]]
    digits = all(re.fullmatch(r"\d{2,}", row[2].strip()) for row in rows if len(row) > 2)
    return digits or all(len(row) > len(table.axes) for row in rows)
