"""Rotations and products of many vectors at once, quicker than in the libraries."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.trajectory import Array


def turn_about(axis: Array, angle: ArrayLike) -> Array:
    """Return the rotation matrices about a unit vector (3,) [rad], shape (..., 3, 3).

    By the formula of Rodrigues: 1 + sin(angle) K + (1 - cos(angle)) K^2.
    """
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.asarray(angle)[..., None, None]
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * (K @ K)


def rotate(R: Array, v: Array) -> Array:
    """Return vectors (N, 3) turned, each by its matrix (N, 3, 3)."""
    return np.einsum("nij,nj->ni", R, v)


def inner(a: Array, b: Array) -> Array:
    """Return the products of vectors (..., 3), shape (...)."""
    return np.einsum("...i,...i->...", a, b)


def cross(a: Array, b: Array) -> Array:
    """Return the vector products of vectors (N, 3), shape (N, 3)."""
    product = np.empty(a.shape)
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        product[:, x] = a[:, y] * b[:, z] - a[:, z] * b[:, y]
    return product
