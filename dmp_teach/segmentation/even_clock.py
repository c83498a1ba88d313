"""Put a pen's motion on an even clock, without what is faster than a hand.

Where a marker leaps as no pen does, it flickers, or another one is taken for it. The samples
between two leaps are a piece. The pen's way is the row of pieces with the most samples in which
each goes on where the last one was going. Where one does not, that costs as much as a quarter of a
second of samples: so a marker that leaps for good is followed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from dmp_teach.errors import RecordingError
from dmp_teach.filtering import lowpass
from dmp_teach.trajectory import Array, interpolate_points

Flags = NDArray[np.bool_]
Spans = tuple[tuple[int, int], ...]
"""Strokes as pairs (start, end) of samples, the end not included."""

MOST_EVEN_SAMPLES_EACH = 100  # a clock that needs more for each sample of its own is broken
LEAP = 0.003  # a step so far from where the pen was going is one ... [m]
PEN_ACCELERATION = 8.0  # ... beside what a pen can do in that time [m/s2] ...
PEN_SPEED = 1.0  # ... and a hand [m/s]
LEAP_COST = 0.25  # leaving out so much is as bad as one leap [s]
MOST_BREAKS = 3000  # of so much noise nothing is told apart
MOST_LEFT_OUT = 60  # pieces between two that go on


@dataclass(frozen=True)
class PenMotion:
    """A recording on an even clock.

    Args:
        dt: Its step [s].
        raw: The height as it was, shape (K,) [m].
        z: The height, low-passed at 12 Hz, shape (K,) [m].
        rise: The rate of that, shape (K,) [m/s].
        speed: Over the page, shape (K,) [m/s].
        path: On the page, low-passed at 10 Hz, shape (K, 2) [m].
    """

    dt: float
    raw: Array
    z: Array
    rise: Array
    speed: Array
    path: Array


def to_even_clock(t: Array, position: Array) -> PenMotion:
    """Resample a recording on an even clock from `t[0]` on, without leaps, and low-pass it.

    Raises:
        RecordingError: Its own clock is too uneven.
    """
    dt = float(np.median(np.diff(t)))
    samples = round((t[-1] - t[0]) / dt) + 1
    if samples > MOST_EVEN_SAMPLES_EACH * len(t):
        raise RecordingError(
            f"{len(t)} samples, mostly {dt:.3g} s apart, are spread over {t[-1] - t[0]:.6g} s: too "
            "uneven to find strokes. Cut the recording at its longest break."
        )
    clock = np.linspace(t[0], t[-1], max(2, samples))
    dt = float(clock[1] - clock[0])
    even = interpolate_points(clock, t, straightened(t, position))
    z, path = lowpass_hertz(even[:, 2], dt, 12.0), lowpass_hertz(even[:, :2], dt, 10.0)
    speed = np.linalg.norm(np.gradient(path, dt, axis=0), axis=1)
    return PenMotion(dt, even[:, 2], z, np.gradient(z, dt), speed, path)


def lowpass_hertz(values: Array, dt: float, cutoff: float) -> Array:
    """Return `values` (K, ...) without what is faster than `cutoff` [Hz], not delayed."""
    if len(values) < 12:
        return values
    return lowpass(values, min(cutoff * dt, 0.4), padding=9)


def find_runs(flags: Flags) -> list[tuple[int, int]]:
    """Find where `flags` (K,) stay true: pairs (start, end), the end not included."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int)))
    return [(int(a), int(b)) for a, b in edges.reshape(-1, 2)]


def straightened(t: Array, position: Array, least: float = 0.0) -> Array:
    """Return a pen's way (T, D) with straight lines where it leaps by more than `least` [m]."""
    on_way, size = find_leaps(t, position)
    kept = on_way | (size <= least)
    return position if kept.all() else interpolate_points(t, t[kept], position[kept])


def find_leaps(t: Array, position: Array) -> tuple[Flags, Array]:
    """Find the samples of a marker that are on the pen's way.

    Args:
        t: Times, strictly increasing, shape (T,) [s].
        position: Shape (T, D) [m].

    Returns:
        Whether a sample is on it (T,), and how far a leap there is, shape (T,) [m]: from the way to
        a sample beside it, or from one part of the way to the next.
    """
    on_way, size = np.ones(len(t), dtype=bool), np.zeros(len(t))
    if len(t) < 4:
        return on_way, size
    dt = np.diff(t)
    velocity = np.diff(position, axis=0) / dt[:, None]
    near = np.concatenate([velocity[1:2], velocity, velocity[-2:-1]])
    off = (np.linalg.norm(velocity - each, axis=1) * dt for each in (near[:-2], near[2:]))
    breaks = np.flatnonzero(np.minimum(*off) > _reach(dt)) + 1
    if 0 < len(breaks) < MOST_BREAKS:
        edges = np.concatenate([[0], breaks, [len(t)]])
        course = scipy.ndimage.median_filter(velocity, (9, 1), mode="nearest")
        on_way[:] = False
        for piece, leap in _longest_row(t, position, course, edges):
            on_way[edges[piece] : edges[piece + 1]] = True
            size[edges[piece]] = leap
        way = interpolate_points(t, t[on_way], position[on_way])
        size = np.maximum(size, np.linalg.norm(position - way, axis=1))
    return on_way, size


def _reach(seconds: Array) -> Array:
    """Return how far from its course a pen may be after so long [m]."""
    return LEAP + np.minimum(PEN_ACCELERATION * seconds**2, PEN_SPEED * seconds)


def _longest_row(
    t: Array, position: Array, course: Array, edges: np.ndarray
) -> list[tuple[int, float]]:
    """Return the pieces, between `edges`, that are the pen's way, and how far it leaps to each."""
    first, last = edges[:-1], edges[1:] - 1
    cost = LEAP_COST / float(np.median(np.diff(t)))
    score = (last - first + 1).astype(float)
    source, leap = np.full(len(first), -1), np.zeros(len(first))
    for j in range(1, len(first)):
        i = np.arange(max(0, j - 1 - MOST_LEFT_OUT), j)
        away = t[first[j]] - t[last[i]]
        pace = (course[np.maximum(last[i] - 1, 0)] + course[min(first[j], len(course) - 1)]) / 2
        off = np.linalg.norm(position[first[j]] - position[last[i]] - pace * away[:, None], axis=1)
        leaps = (off > _reach(away)) | (i == j - 1)
        total = score[i] - cost * leaps
        best = int(np.argmax(total))
        if total[best] > 0:
            score[j] += total[best]
            source[j], leap[j] = i[best], off[best] * leaps[best]
    row, k = [], int(np.argmax(score))
    while k >= 0:
        row.append((k, float(leap[k])))
        k = int(source[k])
    return row
