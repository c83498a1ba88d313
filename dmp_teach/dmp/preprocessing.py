"""A demonstration made ready for learning: even times, no trembling, enough samples for the spring."""

from __future__ import annotations

import math

import numpy as np
from scipy.interpolate import Akima1DInterpolator, CubicSpline, PPoly

from dmp_teach.filtering import extend_oddly, lowpass
from dmp_teach.trajectory import Array, Trajectory

EVEN = 0.01  # times are even if none is off by more than this part of a step
LEAST_RATE, LEAST_SAMPLES = 25.0, 20  # smoothing cannot work below these


def prepared(
    trajectory: Trajectory, cutoff: float | None, least_steps: float
) -> tuple[Array, tuple[str, ...]]:
    """The path at even times.

    Args:
        trajectory: What was shown.
        cutoff: Where smoothing begins [Hz], or None.
        least_steps: How many steps the path must have at least.

    Returns:
        Positions, shape (M + 1, D) with M a multiple of the demonstration's own steps, and notes on
        what was done or could not be done. First and last sample are the demonstrated ones.
    """
    # one coordinate after the other in memory: what is done to each coordinate then runs along the whole path
    path, steps, notes = np.asfortranarray(trajectory.position), len(trajectory) - 1, []
    rate = float(
        f"{steps / trajectory.duration:.6g}"
    )  # a clock that began long ago is coarse: let it change nothing
    if not has_even_times(trajectory.t):
        # Akima's curve does not swing out beside a crooked sample, as a spline does
        path = _sampled(
            Akima1DInterpolator(trajectory.t - trajectory.t[0], path, method="makima"), path, steps
        )
        least_steps = max(least_steps, 4 * steps)
        notes.append(f"Times were uneven: resampled at {rate:.4g} samples a second.")
    if cutoff is not None:
        least_rate, least = (
            max(LEAST_RATE, 2.2 * cutoff),
            max(LEAST_SAMPLES, math.ceil(rate / cutoff)),
        )
        if rate < least_rate or len(path) < least:
            notes.append(
                f"Not smoothed: {len(path)} samples at {rate:.4g} a second; a filter of {cutoff:g} Hz needs at least "
                f"{least} samples at {least_rate:g} a second."
            )
        else:
            path = smooth(path, cutoff / rate)
    if steps < least_steps:
        finer = steps * math.ceil(least_steps / steps)
        path = _sampled(CubicSpline(np.linspace(0, 1, steps + 1), path), path, finer)
    return path, tuple(notes)


def sharpened(path: Array, spacing: float) -> Array:
    """`path` (T, D) with its bends drawn as much too sharp as touching kernels will round them.

    A box kernel averages the forcing over its cell and then holds the average: together a triangle as wide as
    two cells, which rounds a bend by h^2/12 y'' (h: the `spacing` of the kernels, in samples). The second
    difference over one spacing is h^2 y'', so a twelfth of it is taken off beforehand. The ends stay.
    """
    far = min(max(1, round(spacing)), len(path) - 1)
    around = extend_oddly(path, far)
    bend = around[2 * far :] - 2 * path + around[: -2 * far]
    return path - bend * ((spacing / far) ** 2 / 12)


def has_even_times(t: Array) -> bool:
    """Whether every sample is where an even clock would have taken it, to a hundredth of a step."""
    steps = len(t) - 1
    step = (t[-1] - t[0]) / steps
    return bool(np.abs(t - t[0] - step * np.arange(steps + 1)).max() <= EVEN * step)


def smooth(path: Array, cutoff: float) -> Array:
    """Return `path` (T, D) without what is faster than `cutoff` [cycles a sample], its ends kept."""
    smoothed = lowpass(path, cutoff, min(len(path) - 1, math.ceil(3 / cutoff)))
    first, last = path[0] - smoothed[0], path[-1] - smoothed[-1]
    along = np.arange(len(path)) / (len(path) - 1)
    smoothed = smoothed + np.multiply.outer(last - first, along).T
    smoothed += first
    # To the last bit.
    smoothed[0], smoothed[-1] = path[0], path[-1]
    return smoothed


def _sampled(curve: PPoly, path: Array, steps: int) -> Array:
    """A curve through `path` at `steps` + 1 even times; the ends to the last bit."""
    even = curve(np.linspace(curve.x[0], curve.x[-1], steps + 1))
    even[0], even[-1] = path[0], path[-1]
    return even
