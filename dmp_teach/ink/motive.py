"""Motion capture as OptiTrack's Motive exports it: CSV with a few rows of header and one row a frame.

The header is found by its content: the row `Frame, Time`, and above it the rows that say of every column its type
(`Marker`, `Rigid Body`, ...), its name, and its quantity (`Position`, ...). Rows are counted as in an editor, from 1.
"""

import csv
import io
import re
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.trajectory import Array

LONGEST_STEP = 60.0  # nobody waits longer inside a take [s]
PEN = 0.004  # a marker that stays within this much is no pen, however long it was seen [m]
METRES = {"meters": 1.0, "metres": 1.0, "centimeters": 0.01, "millimeters": 0.001, "inches": 0.0254, "feet": 0.3048}
BODY_MARKER = re.compile(r"RigidBody \d+:Marker\d+")
Rows = list[list[str]]


@dataclass(frozen=True)
class Take:
    """One marker's way through a take, before anybody fills or cuts it.

    Args:
        name: The file's name, without its folder, for messages.
        marker: The marker's name.
        t: Times, strictly increasing, shape (T,) [s].
        position: The marker in the cameras' world, NaN where they did not see it, shape (T, 3) [m].
        frame: The frame number of each sample, as the file has it, length T.
        row: The row of each sample in the file, from 1, shape (T,).
        others: The names of the other markers that could be the pen.
    """

    name: str
    marker: str
    t: Array
    position: Array
    frame: list[str]
    row: np.ndarray
    others: tuple[str, ...] = ()

    @property
    def choice(self) -> str:
        """Which other markers could be named, in a sentence."""
        if not self.others:
            return "The file has no other marker that could be the pen."
        return f"Other markers that could be named with marker=...: {', '.join(map(repr, self.others))}."

    def at(self, k: int) -> str:
        """Where sample k stands in the file, in words."""
        return f"frame {self.frame[k]} (row {self.row[k]})"

    def part(self, start: int, end: int) -> "Take":
        """The samples `start:end`."""
        cut = slice(start, end)
        return replace(self, t=self.t[cut], position=self.position[cut], frame=self.frame[cut], row=self.row[cut])


def read_take(data: bytes, name: str, marker: str | None = None) -> Take:
    """The pen's marker from a Motive CSV file.

    Args:
        data: The file.
        name: Its name, for messages.
        marker: The marker's name; None takes, of all markers that are not the ones of a rigid body
            (`RigidBody 1:Marker1`) and that move, the one that was seen most.

    Raises:
        RecordingError: It is not such a CSV; has no such marker; a cell is no number; time does not increase; the unit
            is unknown.
    """
    rows = _rows(data, name)
    head = _head(rows, name)
    scale = _scale(rows[:head], name)
    columns = _markers(rows[:head], rows[head], name)
    body = [(k, row) for k, row in enumerate(rows[head + 1 :], head + 2) if any(cell.strip() for cell in row)]
    if not body:
        raise RecordingError(f"{name} has a header but no frames under it; export the take again.")
    chosen, others = _chosen(columns, body, marker, scale, name)
    _check_width(body, len(rows[head]), name)
    t = np.array([_number(row, 1, f"{name}, row {k}", "Time") for k, row in body])
    _check_time(t, body, name)
    xyz = [
        [_number(row, columns[chosen][axis], f"{name}, row {k}", f"{chosen[0]!r} {axis}", True) for axis in "XYZ"]
        for k, row in body
    ]
    position = np.array(xyz) * scale
    position[~np.isfinite(position).all(axis=1)] = np.nan
    return Take(name, chosen[0], t, position, [row[0] for _, row in body], np.array([k for k, _ in body]), others)


def _rows(data: bytes, name: str) -> Rows:
    """The file as cells, or a sentence that says why not."""
    if b"\0" in data:
        raise RecordingError(f"{name} is not text; export the take from Motive as CSV.")
    try:
        text = io.StringIO(data.decode("utf-8-sig", errors="replace"), newline="")
        return list(csv.reader(text, skipinitialspace=True))
    except csv.Error as error:
        raise RecordingError(f"{name} is not a CSV file: {error}. Export the take from Motive as CSV.") from None


def _head(rows: Rows, name: str) -> int:
    """The row, from 0, that begins `Frame, Time`."""
    for k, row in enumerate(rows):
        cells = [cell.strip().lower() for cell in row[:2]]
        if len(cells) == 2 and cells[0] == "frame" and cells[1].startswith("time"):
            return k
        if row and re.match(r"\s*frame\s*[;\t]\s*time", row[0], re.IGNORECASE):
            raise RecordingError(f"{name}, row {k + 1}: columns are not separated by commas; export with commas.")
    raise RecordingError(f"{name} has no header row that begins 'Frame,Time'; export the take from Motive as CSV.")


def _scale(top: Rows, name: str) -> float:
    """Metres in a unit of the file, from `Length Units` in its first rows; metres where it says nothing."""
    for k, row in enumerate(top, 1):
        for key, value in pairwise(row):
            if key.strip().lower() == "length units":
                if value.strip().lower() not in METRES:
                    raise RecordingError(f"{name}, row {k}: 'Length Units' is {value!r}, but must be Meters.")
                return METRES[value.strip().lower()]
    return 1.0


def _markers(top: Rows, axes: list[str], name: str) -> dict[tuple[str, int], dict[str, int]]:
    """The columns X, Y, Z of every marker; twins of one name are counted."""
    kinds = next((k for k, row in enumerate(top) if any(cell.strip().lower() == "marker" for cell in row)), None)
    if kinds is None or kinds + 1 >= len(top):
        raise RecordingError(
            f"{name} has no marker columns: no row over 'Frame,Time' says 'Marker'. Export with markers switched on."
        )
    quantities = next((row for row in top[kinds + 1 :] if any(c.strip().lower() == "position" for c in row)), [])
    found: dict[tuple[str, int], dict[str, int]] = {}
    for j, (kind, label, quantity, axis) in enumerate(zip(top[kinds], top[kinds + 1], quantities, axes, strict=False)):
        if (
            kind.strip().lower() != "marker"
            or quantity.strip().lower() != "position"
            or axis.strip().upper() not in list("XYZ")
        ):
            continue
        twin = 0
        while axis.strip().upper() in found.get((label.strip(), twin), {}):
            twin += 1
        found.setdefault((label.strip(), twin), {})[axis.strip().upper()] = j
    whole = {key: columns for key, columns in found.items() if len(columns) == 3}
    if not whole:
        raise RecordingError(
            f"{name}, rows {kinds + 1} to {len(top) + 1}: no marker has the columns X, Y and Z of its Position. Export "
            "the positions of the markers."
        )
    return whole


def _chosen(
    columns: dict, body: list, marker: str | None, scale: float, name: str
) -> tuple[tuple[str, int], tuple[str, ...]]:
    """The marker that was asked for, or, of those that could be the pen and move, the one seen most; and the others."""
    named = {key: j for key, j in columns.items() if key[0] == marker}
    free = {key: j for key, j in columns.items() if not BODY_MARKER.fullmatch(key[0])}
    pool = free if marker is None else named
    if not pool:
        names = ", ".join(dict.fromkeys(repr(label) for label, _ in (free or columns))) or "none"
        wanted = "no marker that could be the pen" if marker is None else f"no marker {marker!r}"
        raise RecordingError(f"{name} has {wanted}. Markers that could be named with marker=...: {names}.")
    worth = {key: _worth(body, j, scale) for key, j in pool.items()}
    chosen = max(worth, key=worth.get)
    return chosen, tuple(dict.fromkeys(label for label, _ in free if label != chosen[0]))


def _worth(body: list, axes: dict[str, int], scale: float) -> tuple[bool, int]:
    """Whether a marker moves as a pen does, and in how many frames it was seen: the pen has most of both."""
    rows = [row for _, row in body if len(row) > max(axes.values()) and row[axes["X"]].strip()]
    points = [[_finite(row[j]) * scale for j in axes.values()] for row in rows]
    moves = bool(points) and bool((np.ptp(np.array(points), axis=0) > PEN).any())
    return moves, len(rows)


def _finite(cell: str) -> float:
    """The number in a cell; 0 where there is none."""
    try:
        value = float(cell)
    except ValueError:
        return 0.0
    return value if abs(value) < 1e100 else 0.0


def _check_width(body: list, columns: int, name: str) -> None:
    """Raise where a row has more cells than the header: a decimal comma shifts all that follows it."""
    for k, row in body:
        if any(cell.strip() for cell in row[columns:]):
            raise RecordingError(
                f"{name}, row {k}: there are {len(row)} cells, but the header has {columns} columns. "
                "Is there a decimal comma, such as 0,5? Export with points."
            )


def _number(row: list[str], column: int, place: str, what: str, may_be_empty: bool = False) -> float:
    """The number in a cell, NaN for an empty one where that may be."""
    cell = row[column].strip() if column < len(row) else ""
    if not cell and may_be_empty:
        return np.nan
    try:
        value = float(cell.replace("_", "x"))  # Python takes 1_0 for ten
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        shown = cell if len(cell) < 40 else f"{cell[:36]} ..."
        cure = "leave the cell empty where the camera saw nothing" if may_be_empty else "every frame needs its time"
        raise RecordingError(f"{place}, column {column + 1} ({what}): {shown!r} is not a number; {cure}.")
    return value


def _check_time(t: Array, body: list, name: str) -> None:
    """Raise if time stands still, runs back or leaps."""
    odd = np.flatnonzero((np.diff(t) <= 0) | (np.diff(t) > LONGEST_STEP))
    if len(odd):
        k = int(odd[0]) + 1
        raise RecordingError(
            f"{name}, row {body[k][0]}, column 2 (Time): {t[k]:.6g} s after {t[k - 1]:.6g} s; time must increase from "
            f"row to row, by at most {LONGEST_STEP:.0f} s. Export the take again, or delete the row."
        )
