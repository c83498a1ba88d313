"""A demonstration made ready: even times, no trembling, enough samples for the spring."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import scipy

from dmp_teach.filtering import extend_oddly, lowpass
from dmp_teach.trajectory import Array, Trajectory

# Times are even if none is off by more than this part of a step.
UNEVEN_PART = 0.01
# Smoothing cannot work below these: samples a second, and samples.
LEAST_SMOOTHING_RATE = 25.0
LEAST_SMOOTHING_SAMPLES = 20


def prepare_demonstration(
    trajectory: Trajectory, cutoff: float | None, least_steps: float
) -> tuple[Array, tuple[str, ...]]:
    """Return the path of a demonstration at even times, (M + 1, D), and notes on what was done.

    M is a multiple of the demonstration's own steps, at least `least_steps`; smoothing begins at
    `cutoff` [Hz], or never. First and last sample are the demonstrated ones.
    """
    # Each coordinate in one piece of memory: what is done to it then runs along the whole path.
    path, steps = np.asfortranarray(trajectory.position), len(trajectory) - 1
    notes: tuple[str, ...] = ()
    # A clock that began long ago is coarse: let it change nothing.
    rate = float(f"{steps / trajectory.duration:.6g}")
    if not has_even_times(trajectory.t):
        # Akima's curve does not swing out beside a crooked sample, as a spline does.
        times = trajectory.t - trajectory.t[0]
        curve = scipy.interpolate.Akima1DInterpolator(times, path, method="makima")
        path = _sample(curve, times, path, steps)
        least_steps = max(least_steps, 4 * steps)
        notes += (f"Times were uneven: resampled at {rate:.4g} samples a second.",)
    if cutoff is not None:
        least_rate = max(LEAST_SMOOTHING_RATE, 2.2 * cutoff)
        least = max(LEAST_SMOOTHING_SAMPLES, math.ceil(rate / cutoff))
        if rate < least_rate or len(path) < least:
            notes += (
                f"Not smoothed: {len(path)} samples at {rate:.4g} a second; a filter of "
                f"{cutoff:g} Hz needs at least {least} samples at {least_rate:g} a second.",
            )
        else:
            path = smooth(path, cutoff / rate)
    if steps < least_steps:
        finer = steps * math.ceil(least_steps / steps)
        times = np.linspace(0, 1, steps + 1)
        path = _sample(scipy.interpolate.CubicSpline(times, path), times, path, finer)
    return path, notes


def sharpen_bends(path: Array, spacing: float) -> Array:
    """Return `path` (T, D) with its bends as much too sharp as touching kernels will round them.

    A box kernel averages the forcing over its cell and then holds the average: together a triangle
    as wide as two cells, which rounds a bend by h^2/12 y'' (h: the `spacing` of the kernels, in
    samples). The second difference over one spacing is h^2 y'', so a twelfth of it is taken off
    beforehand. The ends stay.
    """
    far = min(max(1, round(spacing)), len(path) - 1)
    around = extend_oddly(path, far)
    bend = around[2 * far :] - 2 * path + around[: -2 * far]
    return path - bend * ((spacing / far) ** 2 / 12)


def has_even_times(t: Array) -> bool:
    """Check that every sample is where an even clock would have taken it, to 1/100 of a step."""
    steps = len(t) - 1
    step = (t[-1] - t[0]) / steps
    return bool(np.abs(t - t[0] - step * np.arange(steps + 1)).max() <= UNEVEN_PART * step)


def smooth(path: Array, cutoff: float) -> Array:
    """Low-pass `path` (T, D) at `cutoff` [cycles a sample]; its ends stay."""
    smoothed = lowpass(path, cutoff, min(len(path) - 1, math.ceil(3 / cutoff)))
    first, last = path[0] - smoothed[0], path[-1] - smoothed[-1]
    along = np.arange(len(path)) / (len(path) - 1)
    smoothed = smoothed + np.multiply.outer(last - first, along).T
    smoothed += first
    # To the last bit.
    smoothed[0], smoothed[-1] = path[0], path[-1]
    return smoothed


def _sample(curve: Callable[[Array], Array], times: Array, path: Array, steps: int) -> Array:
    """Return a curve through `path` at `steps` + 1 even times; the ends to the last bit."""
    even = curve(np.linspace(times[0], times[-1], steps + 1))
    even[0], even[-1] = path[0], path[-1]
    return even
