"""The linear map that brings one line nearest to another, both about their middles, by least squares."""

from __future__ import annotations

import numpy as np

from dmp_teach.trajectory import Array

STIFF = 0.005  # how firmly ink that tells nothing of width or lean, as an l, is taken for unchanged


def linear_map(mine: Array, yours: Array, scale: float) -> Array:
    """The matrix (2, 2) that brings centred points `yours` (P, 2) nearest to `mine`."""
    if not yours.any():
        return scale * np.eye(2)
    return solved(yours.T @ yours, mine.T @ yours, np.asarray(scale))


def solved(spread: Array, together: Array, scale: Array) -> Array:
    """The same from the sums of yours x yours and of mine x yours over all points (..., 2, 2), for each scale (...)."""
    firm = (STIFF * np.trace(spread, axis1=-2, axis2=-1))[..., None, None] * np.eye(2)
    turned = np.swapaxes(together + scale[..., None, None] * firm, -1, -2)
    return np.swapaxes(np.linalg.solve(spread + firm, turned), -1, -2)


def centred(points: Array) -> Array:
    """Points (..., P, 2) about their mean."""
    return points - points.mean(axis=-2, keepdims=True)


def ratio(mine: Array, yours: Array) -> float:
    """How many times as large centred points (..., 2) are; 1 where one side is a dot."""
    both = float((mine**2).sum()), float((yours**2).sum())
    return float(np.sqrt(both[0] / both[1])) if min(both) > 0 else 1.0
