"""Fit the linear map that brings one centred line nearest to another, by least squares."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.trajectory import Array

# How firmly ink without a width or lean of its own, such as an l, is taken for unchanged.
MAP_RIDGE = 0.005


def fit_linear_map(mine: Array, yours: Array, scale: float) -> Array:
    """Return the matrix (2, 2) that brings centred points `yours` (P, 2) nearest to `mine`."""
    if not yours.any():
        return scale * np.eye(2)
    return solve_linear_map(yours.T @ yours, mine.T @ yours, scale)


def solve_linear_map(yours_yours: Array, mine_yours: Array, scale: ArrayLike) -> Array:
    """Return the same from the sums of products over all points (..., 2, 2), for each scale."""
    ridge = (MAP_RIDGE * np.trace(yours_yours, axis1=-2, axis2=-1))[..., None, None] * np.eye(2)
    target = np.swapaxes(mine_yours + np.asarray(scale)[..., None, None] * ridge, -1, -2)
    return np.swapaxes(np.linalg.solve(yours_yours + ridge, target), -1, -2)


def centre(points: Array) -> Array:
    """Return points (..., P, 2) minus their mean."""
    return points - points.mean(axis=-2, keepdims=True)


def size_ratio(mine: Array, yours: Array) -> float:
    """Return how many times as large centred points (..., 2) are; 1 where one side is a dot."""
    squares = float((mine**2).sum()), float((yours**2).sum())
    return float(np.sqrt(squares[0] / squares[1])) if min(squares) > 0 else 1.0
