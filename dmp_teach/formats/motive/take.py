"""Motion capture as OptiTrack's Motive exports it: CSV with a few rows of header and one row a frame.

The table is read by `motive_table`, and `motive_markers` says which of its markers is the pen.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.formats.motive.markers import Way, pen_pieces
from dmp_teach.formats.motive.table import (
    Key,
    Table,
    check_width,
    listed,
    number,
    read_table,
    times,
)
from dmp_teach.trajectory import Array


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
        unseen: How long the file goes on before the first sample and after the last one, without the marker [s].
    """

    name: str
    marker: str
    t: Array
    position: Array
    frame: list[str]
    row: np.ndarray
    others: tuple[str, ...] = ()
    unseen: tuple[float, float] = (0.0, 0.0)

    @property
    def choice(self) -> str:
        """Which other markers could be named, in a sentence."""
        if not self.others:
            return "The file has no other marker that could be the pen."
        return f"Other markers that could be named with marker=...: {listed(self.others)}."

    def at(self, k: int) -> str:
        """Where sample k stands in the file, in words."""
        return f"frame {self.frame[k]} (row {self.row[k]})"

    def part(self, start: int, end: int) -> Take:
        """The samples `start:end`."""
        cut = slice(start, end)
        return replace(
            self,
            t=self.t[cut],
            position=self.position[cut],
            frame=self.frame[cut],
            row=self.row[cut],
        )


def read_take(data: bytes, name: str, marker: str | None = None) -> Take:
    """The pen's marker from a Motive CSV file.

    Args:
        data: The file.
        name: Its name, for messages.
        marker: The marker's name; None takes, of all markers that are not the ones of a rigid body
            (`RigidBody 1:Marker1`) and that move, the one that was seen most. Either is followed where it goes on
            under another name.

    Raises:
        RecordingError: It is not such a CSV; has no such marker; a cell is no number; time does not increase; the unit
            is unknown.
    """
    table = read_table(data, name)
    check_width(table)
    t = times(table)
    pieces, ways, others = pen_pieces(table, t, marker)
    position = _positions(table, pieces, ways)
    rows = np.array([k for k, _ in table.body])
    label = ", then ".join(label for label, _ in _in_order(pieces, ways))
    return Take(name, label, t, position, [row[0] for _, row in table.body], rows, others)


def _positions(table: Table, pieces: list[Key], ways: list[Way]) -> Array:
    """The pen in the cameras' world (T, 3) [m], NaN where nobody saw it."""
    source = np.zeros(len(table.body), dtype=int)
    for number_of_piece, way in enumerate(ways[1:], start=1):
        source[way.seen] = number_of_piece
    columns = [table.markers[key] for key in pieces]
    xyz = [
        [
            number(
                row,
                columns[piece][axis],
                f"{table.name}, row {k}",
                f"{pieces[piece][0]!r} {axis}",
                True,
            )
            for axis in "XYZ"
        ]
        for piece, (k, row) in zip(source.tolist(), table.body, strict=True)
    ]
    position = np.array(xyz) * table.scale
    position[~np.isfinite(position).all(axis=1)] = np.nan
    return position


def _in_order(pieces: list[Key], ways: list[Way]) -> list[Key]:
    """The pieces of the pen's way, the first seen first."""
    if len(pieces) == 1:
        return pieces
    return [key for _, key in sorted(zip((int(way.seen[0]) for way in ways), pieces, strict=True))]
