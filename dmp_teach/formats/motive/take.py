"""The pen's marker through a take that Motive exported: a few rows of header, one row a frame."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.formats.motive.markers import Track, find_pen_tracks
from dmp_teach.formats.motive.table import (
    MarkerKey,
    Table,
    cell_number,
    check_width,
    frame_times,
    list_names,
    read_table,
)
from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Take:
    """One marker's way through a take, before it is filled or cut.

    Args:
        name: The file's name, without its folder, for messages.
        marker: The marker's name.
        t: Times, strictly increasing, shape (T,) [s].
        position: The marker in the cameras' world, NaN where they did not see it, shape (T, 3) [m].
        frame: The frame number of each sample, as the file has it, length T.
        row: The row of each sample in the file, from 1, shape (T,).
        others: The names of the other markers that could be the pen.
        unseen: How long the file goes on before the first sample and after the last one, without
            the marker [s].
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
        return f"Other markers that could be named with marker=...: {list_names(self.others)}."

    def at(self, k: int) -> str:
        """Say where sample k stands in the file."""
        return f"frame {self.frame[k]} (row {self.row[k]})"

    def part(self, start: int, end: int) -> Take:
        """Return the samples `start:end`."""
        cut = slice(start, end)
        before, after = self.unseen
        return replace(
            self,
            t=self.t[cut],
            position=self.position[cut],
            frame=self.frame[cut],
            row=self.row[cut],
            unseen=(
                before + float(self.t[start] - self.t[0]),
                after + float(self.t[-1] - self.t[end - 1]),
            ),
        )


def read_take(data: bytes, name: str, marker: str | None = None) -> Take:
    """Read the pen's marker from a Motive CSV file.

    Args:
        data: The file.
        name: Its name, for messages.
        marker: The marker's name; None takes, of all markers that are not the ones of a rigid body
            (`RigidBody 1:Marker1`) and that move, the one that was seen most. Either is followed
            where it goes on under another name.

    Raises:
        RecordingError: It is not such a CSV; has no such marker; a cell is no number; time does not
            increase; the unit is unknown.
    """
    table = read_table(data, name)
    check_width(table)
    t = frame_times(table)
    pieces, tracks, others = find_pen_tracks(table, t, marker)
    position = _positions(table, pieces, tracks)
    rows = np.array([k for k, _ in table.body])
    label = ", then ".join(label for label, _ in _in_order(pieces, tracks))
    return Take(name, label, t, position, [row[0] for _, row in table.body], rows, others)


def _positions(table: Table, pieces: list[MarkerKey], tracks: list[Track]) -> Array:
    """Return the pen in the cameras' world (T, 3) [m], NaN where no camera saw it."""
    source = np.zeros(len(table.body), dtype=int)
    for piece, track in enumerate(tracks[1:], start=1):
        source[track.seen] = piece
    columns = [table.markers[key] for key in pieces]
    xyz = [
        [
            cell_number(
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


def _in_order(pieces: list[MarkerKey], tracks: list[Track]) -> list[MarkerKey]:
    """Return the markers of the pen in the order in which they were seen."""
    if len(pieces) == 1:
        return pieces
    return [
        key for _, key in sorted(zip((int(track.seen[0]) for track in tracks), pieces, strict=True))
    ]
