"""Recursive filters: that of a spring, and the low-pass that demonstrations are smoothed with.

Written here since `scipy.signal` takes longer to import than everything else that a letter needs.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from dmp_teach.trajectory import Array

# Samples that are filtered by one product of matrices.
BLOCK = 64


def filter_recursively(recursion: tuple[float, ...], x: Array) -> Array:
    """Filter `x` along its last axis, from rest: y[k] = x[k] - a[1] y[k-1] - a[2] y[k-2] - ...

    Args:
        recursion: The coefficients a[1], a[2] ..., at most `BLOCK`.
        x: Samples, shape (..., T).

    Returns:
        The filtered samples, of the same shape.
    """
    forced, free = _block_responses(recursion)
    length, order = x.shape[-1], len(recursion)
    blocks = -(-length // BLOCK)
    filled = np.zeros((*x.shape[:-1], blocks * BLOCK))
    filled[..., :length] = x
    y = filled.reshape(-1, blocks, BLOCK) @ forced
    # Each block goes on with what the one before it has left.
    for block in range(1, blocks):
        y[:, block] += y[:, block - 1, -order:] @ free
    return y.reshape(filled.shape)[..., :length]


@lru_cache(maxsize=64)
def _block_responses(recursion: tuple[float, ...]) -> tuple[Array, Array]:
    """Return the responses (BLOCK, BLOCK) to a 1 at each sample, and to each earlier output."""
    order = len(recursion)
    # Of a run that begins `order` samples before the block, each column with a 1 at its own sample.
    y = np.eye(order + BLOCK)
    for k in range(order, order + BLOCK):
        y[k] -= np.dot(recursion, y[k - order : k][::-1])
    return y[order:, order:].T.copy(), y[order:, :order].T.copy()


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
    recursion = (2 * (k * k - 1) * q, (1 - math.sqrt(2) * k + k * k) * q)
    x = extend_oddly(values, padding).T
    for _ in range(2):
        # The filter starts as if the first value had stood there for ever.
        first = x[..., :1]
        x = x - first
        drive = x.copy()
        drive[..., 1:] += 2 * x[..., :-1]
        drive[..., 2:] += x[..., :-2]
        x = (first + filter_recursively(recursion, k * k * q * drive))[..., ::-1]
    return x[..., padding : x.shape[-1] - padding].T


def extend_oddly(values: Array, padding: int) -> Array:
    """Return `values` (T, ...) extended by `padding` samples on both sides, odd about the ends."""
    before = 2 * values[0] - values[padding:0:-1]
    after = 2 * values[-1] - values[-2 : -padding - 2 : -1]
    return np.concatenate([before, values, after])
