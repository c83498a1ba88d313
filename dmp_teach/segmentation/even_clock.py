"""Put a pen's motion on an even clock, without what is faster than a hand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.filtering import lowpass
from dmp_teach.segmentation.leaps import Flags, straightened
from dmp_teach.trajectory import Array, interpolate_points

Spans = tuple[tuple[int, int], ...]
"""Strokes as pairs (start, end) of samples, the end not included."""

# A clock that needs more even samples than this for each of its own is broken.
MOST_EVEN_SAMPLES_EACH = 100


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
