"""The pen through a take that Motive exported, before it is cut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import LARGEST_INK
from dmp_teach.formats.motive.markers import Pen, find_pen
from dmp_teach.formats.motive.table import Table, list_names, read_table
from dmp_teach.segmentation import Flags, find_leaps
from dmp_teach.trajectory import Array, interpolate_points

FEWEST_FRAMES = 20  # fewer samples are no letter
SMALLEST_TAKE = 0.004  # no marker at a hand that writes moves less [m]


@dataclass(frozen=True)
class Take:
    """The pen from the first sample that the cameras saw to the last.

    Args:
        table: The file.
        pen: Which marker it is.
        first: The frame of its first sample, as a place in the table.
        position: In the cameras' world, with straight lines where they lost it, shape (T, 3) [m].
        is_seen: Whether they saw it, shape (T,).
    """

    table: Table
    pen: Pen
    first: int
    position: Array
    is_seen: Flags

    @property
    def t(self) -> Array:
        """Times, strictly increasing, shape (T,) [s]."""
        return self.table.t[self.first : self.first + len(self.position)]

    def at(self, k: int) -> str:
        """Say where sample k stands in the file."""
        return self.table.at(self.first + k)


def read_take(data: bytes, marker: str | None, out: Array) -> Take:
    """Read the pen's marker from a Motive CSV file.

    Args:
        data: The file.
        marker: The marker's name; None finds it.
        out: The direction out of the paper, shape (3,).

    Raises:
        RecordingError: As `read_table` and `find_pen`, or the marker was hardly seen or did not
            move as a hand does.
    """
    table = read_table(data)
    pen = find_pen(table, marker, out)
    seen, points, t = pen.track.seen, pen.track.points, table.t
    other = f"Other markers that could be named with marker=...: {list_names(pen.others)}."
    choice = other if pen.others else "The file has no other marker that could be the pen."
    if len(seen) < FEWEST_FRAMES:
        raise RecordingError(
            f"marker {pen.name!r} was seen in {len(seen)} frames, but a letter needs "
            f"{FEWEST_FRAMES}; record again. {choice}"
        )
    on_way, _ = find_leaps(t[seen], points)
    # Where the unit is wrong, all that moves is off any way.
    middle = np.quantile(points, [0.1, 0.9], axis=0)
    size = float(max(np.ptp(part, axis=0).max() for part in (points[on_way], middle)))
    if not SMALLEST_TAKE < size < LARGEST_INK:
        away = np.abs(points - np.median(points, axis=0)).max(axis=1)
        raise RecordingError(
            f"marker {pen.name!r} moves within {size:.4g} m, but a writing hand within "
            f"{SMALLEST_TAKE} to {LARGEST_INK} m. It is {away.max():.4g} m off at "
            f"{table.at(seen[np.argmax(away)])}. Is 'Length Units' in row 1 right, and is this "
            f"marker the pen? {choice}"
        )
    frames = np.arange(seen[0], seen[-1] + 1)
    position = interpolate_points(t[frames], t[seen][on_way], points[on_way])
    position[seen - seen[0]] = points
    return Take(table, pen, int(seen[0]), position, np.isin(frames, seen))
