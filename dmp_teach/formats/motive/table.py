"""The table in a Motive CSV file: its header, its columns by marker, its cells, its times.

The header is found by its content: the row `Frame, Time`, and above it the rows that say of every
column its type (`Marker`, `Rigid Body`, ...), its name, and its quantity (`Position`, ...). Rows
are counted as in an editor, from 1.
"""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.plain_text import decode_text
from dmp_teach.formats.units import METRES
from dmp_teach.trajectory import Array

HEADER = re.compile(
    rb"(?:^|[\r\n])[^,;\r\n]{0,8}frame[\"\t ]{0,8}([,;\t])[\"\t ]{0,8}time", re.IGNORECASE
)
TYPES = re.compile(rb"Format Version|\b(?:Marker|Rigid Body|Bone)\b", re.IGNORECASE)
MOST_NAMES = 20  # in a sentence
LONGEST_NAME = 60  # in a sentence [characters]
LONGEST_ROW_STEP = 60.0  # no take waits longer from row to row [s]
MOST_FAULTS = 0.02  # of the rows may have no time
FARTHEST_SAMPLE = 1e6  # farther is no farther [m]
MARKERS, BODIES = {"marker", "rigid body marker"}, {"rigid body"}
AxisColumns = dict[str, int]  # of "X", "Y" and "Z", from 0
MarkerKey = tuple[str, int]  # a marker's name, and which of several of that name


@dataclass(frozen=True)
class Track:
    """Where a marker was seen.

    Args:
        seen: The frames' places in the table, from 0, shape (K,).
        points: Its positions there, shape (K, 3) [m].
    """

    seen: np.ndarray
    points: Array


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

    def at(self, k: int) -> str:
        """Say where a frame stands in the file: its number and its row."""
        place, row = self.body[k]
        return f"frame {row[0]} (row {place})"

    def track(self, key: MarkerKey) -> Track:
        """Return where a marker or a body was seen; a cell that is no number is a fault."""
        whole = (each[key] for each in (self.bodies, self.markers) if len(each.get(key, ())) == 3)
        columns = next(whole)
        seen: list[int] = []
        points: list[list[float]] = []
        for k, (place, row) in enumerate(self.body):
            if max(columns.values()) >= len(row) or not row[columns["X"]].strip():
                continue
            try:
                points.append(
                    [_cell_number(row, columns[a], place, f"{key[0]!r} {a}") for a in "XYZ"]
                )
                seen.append(k)
            except RecordingError as error:
                self.faults.append(str(error))
        places = np.reshape(points, (-1, 3)) * self.scale
        return Track(np.array(seen, dtype=int), places.clip(-FARTHEST_SAMPLE, FARTHEST_SAMPLE))


def _find_header(data: bytes) -> re.Match[bytes] | None:
    """Return the beginning of the row `Frame,Time`, and the sign between its columns."""
    return HEADER.search(data[:100_000].replace(b"\0", b""))


def has_motive_header(data: bytes) -> bool:
    """Tell whether a file has the row `Frame,Time`, and says of its columns what they follow."""
    about = TYPES.search(data[:100_000].replace(b"\0", b""))
    return about is not None and _find_header(data) is not None


def read_table(data: bytes) -> Table:
    """Read the table in a file's bytes.

    Raises:
        RecordingError: It is no such CSV, its unit is unknown, a row has more cells than the
            header, as after a decimal comma, or a time cannot be.
    """
    header = _find_header(data)
    text = io.StringIO(decode_text(data), newline="")
    sign = "," if header is None else header[1].decode()
    try:
        rows = list(csv.reader(text, delimiter=sign, skipinitialspace=True, strict=True))
    except csv.Error as error:
        raise RecordingError(
            f"is not a CSV file: {error}. Export the take from Motive as CSV."
        ) from None
    begins = ([cell.strip().lower() for cell in (*row[:2], "", "")] for row in rows)
    head = next(
        (k for k, (a, b, *_) in enumerate(begins) if a == "frame" and b[:4] == "time"), None
    )
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
    markers, bodies = (_columns_of(kinds, top, rows[head]) for kinds in (MARKERS, BODIES))
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
            time = _cell_number(row, 1, place, "Time")
            if times and not 0 < time - times[-1] <= LONGEST_ROW_STEP:
                raise RecordingError(
                    f"row {place}, column 2 (Time): {time:.6g} s after {times[-1]:.6g} s; time "
                    f"must increase from row to row, by at most {LONGEST_ROW_STEP:.0f} s. Export "
                    "the take again, with points and more decimals, or delete the row."
                )
        except RecordingError as error:
            faults.append(str(error))
            continue
        body.append((place, row))
        times.append(time)
    if len(faults) > MOST_FAULTS * len(rows):
        raise RecordingError(faults[0])
    return body, np.array(times), faults


def _scale(top: list[list[str]]) -> float:
    """Return the metres in a unit of the file, which is metres where it says nothing."""
    for k, row in enumerate(top, 1):
        for key, value in pairwise(row):
            if key.strip().lower() == "length units":
                unit = value.strip().lower().rstrip(".").removesuffix("s")
                if unit not in METRES:
                    raise RecordingError(
                        f"row {k}: 'Length Units' is {value[:40]!r}, but must be Meters, "
                        "Centimeters or Millimeters; export again."
                    )
                return METRES[unit]
    return 1.0


def _columns_of(
    wanted: set[str], top: list[list[str]], axes: list[str]
) -> dict[MarkerKey, AxisColumns]:
    """Return the columns X, Y, Z of the Position of every thing of a type; twins are counted."""
    low = [[cell.strip().lower() for cell in row] for row in top]
    kinds = next((k for k, row in enumerate(low) if wanted & {*row}), len(top))
    if kinds + 1 >= len(top):
        return {}
    no_quantities = [""] * len(axes)
    quantities = next((row for row in low[kinds + 1 :] if "position" in row), no_quantities)
    found: dict[MarkerKey, AxisColumns] = {}
    twins = Counter[tuple[str, str]]()
    columns = zip(low[kinds], top[kinds + 1], quantities, axes, strict=False)
    for j, (kind, name, what, letter) in enumerate(columns):
        label, axis = name.strip(), letter.strip().upper()
        if kind in wanted and label:
            found.setdefault((label, 0), {})
            if what == "position" and axis in ("X", "Y", "Z"):
                found.setdefault((label, twins[label, axis]), {})[axis] = j
                twins[label, axis] += 1
    return found


def list_names(names: Iterable[str]) -> str:
    """Return names for a sentence, each once, not too many and none too long."""
    short = (n if len(n) <= LONGEST_NAME else f"{n[:LONGEST_NAME]} ..." for n in names)
    shown = list(dict.fromkeys(short))
    return ", ".join(map(repr, shown[:MOST_NAMES])) + (", ..." if len(shown) > MOST_NAMES else "")


def _cell_number(row: list[str], column: int, place: int, what: str) -> float:
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
