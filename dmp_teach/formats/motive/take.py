"""The pen through a take that Motive exported, before it is filled or cut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import LARGEST_INK
from dmp_teach.formats.motive.markers import Pen, find_pen
from dmp_teach.formats.motive.table import list_names, read_table
from dmp_teach.segmentation import find_leaps
from dmp_teach.trajectory import Array, interpolate_points

FEWEST_FRAMES = 20  # fewer samples are no letter
SMALLEST_TAKE = 0.004  # no marker at a hand that writes moves less [m]


@dataclass(frozen=True)
class Take:
    """The pen from the first sample that the cameras saw to the last.

    Args:
        pen: Which marker it is.
        t: Times, strictly increasing, shape (T,) [s].
        position: In the cameras' world, with straight lines where they lost it, shape (T, 3) [m].
        is_seen: Whether they saw it, shape (T,).
        frames: Frame number and row in the file of each sample, length T.
        unseen: How long the file goes on before the first sample and after the last one, without
            the marker [s].
        left: The samples in which its marker is where the pen cannot be.
        faults: Why rows and cells of the file were left out.
    """

    pen: Pen
    t: Array
    position: Array
    is_seen: np.ndarray
    frames: list[tuple[str, int]]
    unseen: tuple[float, float]
    left: np.ndarray
    faults: list[str]

    def at(self, k: int) -> str:
        """Say where sample k stands in the file."""
        return at_frame(self.frames[k])


def at_frame(frame: tuple[str, int]) -> str:
    """Say where a frame, its number and its row, stands in the file."""
    return f"frame {frame[0]} (row {frame[1]})"


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
    seen, points = pen.track.seen, pen.track.points
    other = f"Other markers that could be named with marker=...: {list_names(pen.others)}."
    choice = other if pen.others else "The file has no other marker that could be the pen."
    if len(seen) < FEWEST_FRAMES:
        raise RecordingError(
            f"marker {pen.name!r} was seen in {len(seen)} frames, but a letter needs "
            f"{FEWEST_FRAMES}; record again. {choice}"
        )
    frames, t = [(row[0], k) for k, row in table.body], table.t
    on_way, _ = find_leaps(t[seen], points)
    size = float(np.ptp(points[on_way], axis=0).max())
    # Where the unit is wrong, all that moves is off any way.
    size = max(size, float(np.ptp(np.quantile(points, [0.1, 0.9], axis=0), axis=0).max()))
    if not SMALLEST_TAKE < size < LARGEST_INK:
        away = np.abs(points - np.median(points, axis=0)).max(axis=1)
        worst = at_frame(frames[seen[np.argmax(away)]])
        raise RecordingError(
            f"marker {pen.name!r} moves within {size:.4g} m, but a writing hand within "
            f"{SMALLEST_TAKE} to {LARGEST_INK} m. It is {away.max():.4g} m off at {worst}. "
            f"Is 'Length Units' in row 1 right, and is this marker the pen? {choice}"
        )
    first, last = seen[0], seen[-1]
    part = slice(first, last + 1)
    filled = interpolate_points(t[part], t[seen][on_way], points[on_way])
    filled[seen - first] = points
    is_seen = np.isin(np.arange(first, last + 1), seen)
    unseen = float(t[first] - t[0]), float(t[-1] - t[last])
    left = pen.left[(pen.left > first) & (pen.left < last)] - first
    return Take(pen, t[part], filled, is_seen, frames[part], unseen, left, table.faults)
