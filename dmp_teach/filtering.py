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


@lru_cache(maxsize=256)
def _block_responses(recursion: tuple[float, ...]) -> tuple[Array, Array]:
    """Return how a block answers to each of its samples, and to each output just before it.

    Shapes (BLOCK, BLOCK) and (order, BLOCK).
    """
    order, response = len(recursion), [1.0]
    for _ in range(1, BLOCK):
        latest = response[: -order - 1 : -1]
        response.append(-sum(a * y for a, y in zip(recursion, latest, strict=False)))
    later = np.arange(BLOCK) - np.arange(BLOCK)[:, None]
    forced = np.triu(np.array(response)[later])
    pushed = np.zeros((order, BLOCK))
    for row in range(order):
        pushed[row, : row + 1] = np.negative(recursion[order - 1 - row :])
    return forced, pushed @ forced


def lowpass(values: Array, cutoff: float, padding: int, order: int = 2) -> Array:
    """Filter forwards and backwards with a Butterworth filter of even order, without a delay.

    A pair of poles each has a section of second order, whose coefficients come from the bilinear
    transform: with k = tan(pi cutoff), d = 2 sin(pi (n + 1/2) / order) for n = 0, 1 ... and
    q = 1 / (1 + d k + k^2),

        b = k^2 q [1, 2, 1],   a = [1, 2 (k^2 - 1) q, (1 - d k + k^2) q]

    Args:
        values: Samples, shape (T,) or (T, D).
        cutoff: Where the filter has fallen to half of the power [cycles a sample].
        padding: How many samples of the odd extension are filtered before and after.
        order: Of the filter in one direction.

    Returns:
        The filtered samples, of the same shape.
    """
    k = math.tan(math.pi * cutoff)
    x = extend_oddly(values, padding).T
    for _ in range(2):
        # The filter starts as if the first value had stood there for ever.
        first = x[..., :1]
        x = x - first
        for pair in range(order // 2):
            d = 2 * math.sin(math.pi * (pair + 0.5) / order)
            q = 1 / (1 + d * k + k * k)
            drive = x.copy()
            drive[..., 1:] += 2 * x[..., :-1]
            drive[..., 2:] += x[..., :-2]
            recursion = (2 * (k * k - 1) * q, (1 - d * k + k * k) * q)
            x = filter_recursively(recursion, k * k * q * drive)
        x = (first + x)[..., ::-1]
    return x[..., padding : x.shape[-1] - padding].T


def extend_oddly(values: Array, padding: int) -> Array:
    """Return `values` (T, ...) extended by `padding` samples on both sides, odd about the ends."""
    before = 2 * values[0] - values[padding:0:-1]
    after = 2 * values[-1] - values[-2 : -padding - 2 : -1]
    return np.concatenate([before, values, after])
