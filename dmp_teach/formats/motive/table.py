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
from dmp_teach.trajectory import Array

HEADER = re.compile(
    rb"(?:^|[\r\n])[^,;\r\n]{0,8}frame[\"\t ]{0,8}([,;\t])[\"\t ]{0,8}time", re.IGNORECASE
)
TYPES = re.compile(rb"Format Version|\b(?:Marker|Rigid Body|Bone)\b", re.IGNORECASE)
MOST_NAMES = 20  # in a sentence
LONGEST_NAME = 60  # in a sentence [characters]
LONGEST_ROW_STEP = 60.0  # no take waits longer from row to row [s]
MOST_FAULTS = 0.02  # of the rows may have no time
LENGTH_UNITS = {"m": 1.0, "meter": 1.0, "metre": 1.0}
LENGTH_UNITS |= {"cm": 0.01, "centimeter": 0.01, "centimetre": 0.01}
LENGTH_UNITS |= {"mm": 0.001, "millimeter": 0.001, "millimetre": 0.001}
KINDS_OF_COLUMNS = {"marker": {"marker", "rigid body marker"}, "rigid body": {"rigid body"}}
UTF16_MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
Rows = list[list[str]]
AxisColumns = dict[str, int]  # of "X", "Y" and "Z", from 0
MarkerKey = tuple[str, int]  # a marker's name, and which of several of that name


@dataclass(frozen=True)
class Table:
    """What a file holds.

    Args:
        body: The frames, each with its row in the file, from 1; empty rows left out.
        t: Their times, strictly increasing, shape (T,) [s].
        scale: Metres in one of its units of length.
        markers: The columns of every marker.
        bodies: The columns of every rigid body; fewer than three for one without a position.
        faults: Why rows and cells were left out.
    """

    body: list[tuple[int, list[str]]]
    t: Array
    scale: float
    markers: dict[MarkerKey, AxisColumns]
    bodies: dict[MarkerKey, AxisColumns]
    faults: list[str]


def has_motive_header(data: bytes) -> bool:
    """Tell whether a file has the row `Frame,Time`, and says of its columns what they follow."""
    header = _find_header(data)
    return header is not None and TYPES.search(data[:100_000].replace(b"\0", b"")) is not None


def _find_header(data: bytes) -> re.Match[bytes] | None:
    """Return the beginning of the row `Frame,Time`, and the sign between its columns."""
    return HEADER.search(data[:100_000].replace(b"\0", b""))


def read_table(data: bytes) -> Table:
    """Read the table in a file's bytes.

    Raises:
        RecordingError: It is no such CSV, its unit is unknown, a row has more cells than the
            header, as after a decimal comma, or a time cannot be.
    """
    header = _find_header(data)
    rows = _rows(data, "," if header is None else header[1].decode())
    head = next((k for k, row in enumerate(rows) if _is_head(row)), None)
    if head is None:
        raise RecordingError(
            "there is no header row that begins 'Frame,Time'; export the take from Motive as CSV."
        )
    columns = len(rows[head])
    body = []
    for k, row in enumerate(rows[head + 1 :], head + 2):
        if any(cell.strip() for cell in row[columns:]):
            raise RecordingError(
                f"row {k}: there are {len(row)} cells, but the header has {columns} columns. Is "
                "there a decimal comma, such as 0,5? Export with points."
            )
        if any(cell.strip() for cell in row):
            body.append((k, row))
    if not body:
        raise RecordingError("has a header but no frames under it; export the take again.")
    body, t, faults = _in_time(body)
    top = rows[:head]
    markers, bodies = (_columns_of(kind, top, rows[head]) for kind in ("marker", "rigid body"))
    return Table(body, t, _scale(top), markers, bodies, faults)


def _in_time(
    rows: list[tuple[int, list[str]]],
) -> tuple[list[tuple[int, list[str]]], Array, list[str]]:
    """Return the rows whose time is after that of the row before, their times, and why others not.

    Raises:
        RecordingError: More than a few have no such time.
    """
    body, faults = [], []
    times: list[float] = []
    for place, row in rows:
        try:
            time = cell_number(row, 1, place, "Time")
        except RecordingError as error:
            faults.append(str(error))
            continue
        if times and not 0 < time - times[-1] <= LONGEST_ROW_STEP:
            faults.append(
                f"row {place}, column 2 (Time): {time:.6g} s after {times[-1]:.6g} s; time must "
                f"increase from row to row, by at most {LONGEST_ROW_STEP:.0f} s. Export the take "
                "again, with points and more decimals, or delete the row."
            )
            continue
        body.append((place, row))
        times.append(time)
    if len(faults) > MOST_FAULTS * len(rows):
        raise RecordingError(faults[0])
    return body, np.array(times), faults


def _rows(data: bytes, sign: str) -> Rows:
    """Return the file as cells."""
    encoding = "utf-16" if data.startswith(UTF16_MARKS) else "utf-8-sig"
    try:
        text = io.StringIO(data.decode(encoding, errors="replace"), newline="")
        return list(csv.reader(text, delimiter=sign, skipinitialspace=True, strict=True))
    except csv.Error as error:
        raise RecordingError(
            f"is not a CSV file: {error}. Export the take from Motive as CSV."
        ) from None


def _is_head(row: list[str]) -> bool:
    """Tell whether a row begins `Frame, Time`."""
    cells = [cell.strip().lower() for cell in row[:2]]
    return len(cells) == 2 and cells[0] == "frame" and cells[1].startswith("time")


def _scale(top: Rows) -> float:
    """Return the metres in a unit of the file, which is metres where it says nothing."""
    for k, row in enumerate(top, 1):
        for key, value in pairwise(row):
            if key.strip().lower() != "length units":
                continue
            if (unit := value.strip().lower().rstrip(".").removesuffix("s")) not in LENGTH_UNITS:
                raise RecordingError(
                    f"row {k}: 'Length Units' is {value[:40]!r}, but must be Meters, Centimeters "
                    "or Millimeters; export again."
                )
            return LENGTH_UNITS[unit]
    return 1.0


def _columns_of(what: str, top: Rows, axes: list[str]) -> dict[MarkerKey, AxisColumns]:
    """Return the columns X, Y, Z of the Position of every thing of a type; twins are counted."""
    wanted = KINDS_OF_COLUMNS[what]
    kinds = next(
        (k for k, row in enumerate(top) if wanted & {cell.strip().lower() for cell in row}), None
    )
    if kinds is None or kinds + 1 >= len(top):
        return {}
    quantities = next(
        (row for row in top[kinds + 1 :] if "position" in (cell.strip().lower() for cell in row)),
        [""] * len(axes),
    )
    found: dict[MarkerKey, AxisColumns] = {}
    twins: dict[tuple[str, str], int] = {}
    for j, cells in enumerate(zip(top[kinds], top[kinds + 1], quantities, axes, strict=False)):
        kind, label, quantity, axis = (cell.strip() for cell in cells)
        if kind.lower() not in wanted or not label:
            continue
        found.setdefault((label, 0), {})
        if quantity.lower() == "position" and axis.upper() in list("XYZ"):
            twin = twins[label, axis] = twins.get((label, axis), -1) + 1
            found.setdefault((label, twin), {})[axis.upper()] = j
    return found


def list_names(names: Iterable[str]) -> str:
    """Return names for a sentence, each once, not too many and none too long."""
    shown = list(
        dict.fromkeys(
            name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]} ..." for name in names
        )
    )
    return ", ".join(map(repr, shown[:MOST_NAMES])) + (", ..." if len(shown) > MOST_NAMES else "")


def cell_number(row: list[str], column: int, place: int, what: str) -> float:
    """Return the number in a cell of a row, which is at a `place` in the file."""
    cell = row[column].strip() if column < len(row) else ""
    try:
        value = float(cell.replace("_", "x").replace(",", "."))  # Python takes 1_0 for ten
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        shown = cell if len(cell) < 40 else f"{cell[:36]} ..."
        raise RecordingError(
            f"row {place}, column {column + 1} ({what}): {shown!r} is not a number; leave the cell "
            "empty where the camera saw nothing; every frame needs its time."
        )
    return value
