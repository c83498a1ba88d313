"""Give ink the times of a hand: slow in bends, quick on the straight, at rest at both ends.

The speed follows the two-thirds power law, v = gain * bend^(-1/3) (Lacquaniti, Terzuolo, Viviani
1983), and a letter of twice the size is written twice as fast (isochrony; Viviani, Terzuolo 1982).
The hand never gains or loses speed faster than it can, and its speed changes smoothly. The ink
stays where it is: only when the pen is there is made.
"""

from __future__ import annotations

import numpy as np
import scipy

from dmp_teach.errors import RecordingError
from dmp_teach.trajectory import Array, arc_lengths, interpolate_points, path_length

HAND_RATE = 120.0  # samples a second
HAND_PACE = 1.5  # letter sizes a second, on an arc whose radius is a quarter of the size
MOST_ACCELERATION = 12.0  # the most that speed changes [letter sizes/s2]
STRAIGHT_PACE = 2.0  # no faster than this many times the pace, however straight
PIECES_PER_SIZE = 400  # pieces to a length of the letter's size
MOST_PIECES_OF_STROKE = 40_000  # pieces to one stroke
MOST_STROKES = 1000
LONGEST_INK = 1000  # how long the way of a letter may be, all strokes together [letter sizes]
BEND_WINDOW = 0.012  # bends are seen through a window of this share of the size
SPEED_WINDOW = 0.03  # how long a change of speed takes [s]
LIFT_DURATION = 0.4  # how long the pen is in the air between two strokes [s]
DOT_DURATION = 0.1  # how long it stands on a dot [s]


def at_hand_pace(strokes: list[Array]) -> list[tuple[Array, Array]]:
    """Return strokes without times as a hand would write them.

    Args:
        strokes: Points in the order of writing, shape (K, 2) each [m]; further columns, such as a
            pressure, go along.

    Returns:
        Times (T,) and the same ways (T, D), one after the other on a clock that begins at 0.

    Raises:
        RecordingError: A way too long for a hand.
    """
    size = max(float(np.ptp(np.concatenate(strokes)[:, :2], axis=0).max()), 1e-6)
    way = sum(path_length(points[:, :2]) for points in strokes)
    if len(strokes) > MOST_STROKES or way > LONGEST_INK * size:
        raise RecordingError(
            f"{len(strokes)} strokes that are {way / size:.0f} times as long as the ink is large "
            f"are no letter: at most {MOST_STROKES} strokes of {LONGEST_INK} times its size can "
            "be written at a hand's pace."
        )
    written, clock = [], 0.0
    for points in strokes:
        t, position = _written(points, size)
        written.append((clock + t, position))
        clock += float(t[-1]) + LIFT_DURATION
    return written


def _written(points: Array, size: float) -> tuple[Array, Array]:
    """Return times (T,) from 0 and positions (T, D) of one stroke."""
    way = arc_lengths(points[:, :2])
    kept = np.concatenate([[True], np.diff(way) > 0])
    points, way, length = points[kept], way[kept], float(way[-1])
    if length < 1e-4 * size:
        t = np.linspace(0.0, DOT_DURATION, round(DOT_DURATION * HAND_RATE) + 1)
        return t, np.repeat(points[:1], len(t), axis=0)
    s = np.linspace(
        0.0, length, int(np.clip(length / size * PIECES_PER_SIZE, 24, MOST_PIECES_OF_STROKE)) + 1
    )
    speed = _speed(interpolate_points(s, way, points[:, :2]), s[1], size)
    moments = np.concatenate([[0.0], np.cumsum(2 * s[1] / (speed[1:] + speed[:-1]))])
    t, along = _smooth(moments, s)
    return t, interpolate_points(along, way, points)


def _speed(even: Array, ds: float, size: float) -> Array:
    """Return how fast the pen is at points (K, 2) that are `ds` apart [m/s]."""
    blur = BEND_WINDOW * size / ds
    heading = scipy.ndimage.gaussian_filter1d(
        np.gradient(even, ds, axis=0), blur, axis=0, mode="nearest"
    )
    turning = np.gradient(heading, ds, axis=0)
    norm = np.maximum(np.hypot(*heading.T), 0.05)
    bend = np.abs(heading[:, 0] * turning[:, 1] - heading[:, 1] * turning[:, 0]) / norm**3
    pace = HAND_PACE * size
    speed = np.minimum(
        pace * (np.maximum(bend, 1e-9 / size) * size / 4) ** (-1 / 3), STRAIGHT_PACE * pace
    )
    # Where the pen turns back there is no bend, but it stands still.
    speed *= np.minimum(norm, 1.0)
    # v^2 changes by at most 2 a ds from point to point.
    slack = 2 * MOST_ACCELERATION * size * ds * np.arange(len(even))
    square = speed**2
    square[[0, -1]] = 0.0
    square = np.minimum.accumulate(square - slack) + slack
    return np.sqrt((np.minimum.accumulate((square - slack[::-1])[::-1]) + slack)[::-1])


def _smooth(moments: Array, s: Array) -> tuple[Array, Array]:
    """Return an even clock (T,) and the smoothed arc length (T,), at rest at both ends."""
    count = max(int(np.ceil((moments[-1] + 6 * SPEED_WINDOW) * HAND_RATE)), 8)
    t = np.arange(count + 1) / HAND_RATE
    along = scipy.ndimage.gaussian_filter1d(
        np.interp(t - 3 * SPEED_WINDOW, moments, s), SPEED_WINDOW * HAND_RATE, mode="nearest"
    )
    along = (along - along[0]) * s[-1] / (along[-1] - along[0])
    return t, np.maximum.accumulate(along)
