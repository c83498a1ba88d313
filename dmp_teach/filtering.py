"""The low-pass filter that demonstrations and recordings are smoothed with."""

from __future__ import annotations

import math

import numpy as np
from scipy.signal import lfilter

from dmp_teach.trajectory import Array


def lowpass(values: Array, cutoff: float, padding: int) -> Array:
    """Filter forwards and backwards with a second-order Butterworth filter, without a delay.

    The coefficients come from the bilinear transform: with k = tan(pi cutoff) and
    q = 1 / (1 + sqrt(2) k + k^2),

        b = k^2 q [1, 2, 1],   a = [1, 2 (k^2 - 1) q, (1 - sqrt(2) k + k^2) q]

    Args:
        values: Samples, shape (T,) or (T, D).
        cutoff: Where the filter has fallen to half of the power [cycles a sample].
        padding: How many samples of the odd extension are filtered before and after.

    Returns:
        The filtered samples, of the same shape.
    """
    k = math.tan(math.pi * cutoff)
    q = 1 / (1 + math.sqrt(2) * k + k * k)
    b = np.array([k * k * q, 2 * k * k * q, k * k * q])
    a = np.array([1.0, 2 * (k * k - 1) * q, (1 - math.sqrt(2) * k + k * k) * q])
    # The filter starts as if the first value had stood there for ever.
    settled = np.array([1 - b[0], b[2] - a[2]])
    x = extend_oddly(values, padding).T
    for _ in range(2):
        x, _ = lfilter(b, a, x, zi=x[..., :1] * settled)
        x = x[..., ::-1]
    return x[..., padding : x.shape[-1] - padding].T


def extend_oddly(values: Array, padding: int) -> Array:
    """Return `values` (T, ...) extended by `padding` samples on both sides, odd about the ends."""
    before = 2 * values[0] - values[padding:0:-1]
    after = 2 * values[-1] - values[-2 : -padding - 2 : -1]
    return np.concatenate([before, values, after])
