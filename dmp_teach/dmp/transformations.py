"""Transformations: how the forcing term enters the equation, and how a path follows its goal.

Here z = y - y0 is the path from its start, and o = g - y0 the goal offset. Time is counted in
movements, so that a duration changes nothing; K and D are those of the spring.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np

from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.trajectory import Array

# Of the size of the movement: start and goal are the same point.
_SAME_POINT = 1e-9


class Transformation(NamedChoice):
    """How the forcing term enters the equation, and how a path follows its goal.

    This one has the input of DMP* (Pastor 2009; the paper's equation 11):

        z'' = K o - K o s + K f - K z - D z'

    Attributes:
        weights_fit_any_goal: Whether weights mean the same for every goal offset, so that those
            of letters can be added and drawn by another such transformation.
        is_translation: Whether a moved goal only adds to the path: gain times its change.
    """

    setting = "transform"
    weights_fit_any_goal: ClassVar[bool] = True
    is_translation: ClassVar[bool] = False

    def input(self, f: Array, offset: Array, K: float, s: Array) -> Array:
        """Return the input u (M, D) of the spring for a forcing term f (M, D)."""
        return K * (_attraction(offset, s) + f)

    def needed_forcing(self, u: Array, offset: Array, K: float, s: Array, divide: bool) -> Array:
        """Return the f (M, D) that gives the input u (M, D): `input`, solved for f.

        With `divide` it is divided by what multiplies it in the equation.
        """
        if divide:
            return u / K - _attraction(offset, s)
        return u - K * _attraction(offset, s)

    @abstractmethod
    def retarget(self, values: Array, offset: Array, new: Array, gain: Array | float) -> Array:
        """Return a path, an input or a velocity of one goal offset as that of a new one.

        Args:
            values: Shape (..., D).
            offset: The demonstrated goal offset, shape (D,).
            new: The new one.
            gain: How the values of DMP* grow with each coordinate of the offset, shape (..., 1).
        """

    # What is refused differs: most need no look at the movement.
    def check_demonstration(self, path: Array) -> None:
        """Raise a SettingError where a movement (T, D) cannot be learned."""

    def check_goal(self, offset: Array, new: Array, path: Array) -> None:
        """Raise a TeachError where a `path` (T, D) cannot be led to a new goal offset."""


TRANSFORMATIONS: Registry[type[Transformation]] = Registry()


@TRANSFORMATIONS.add
class Star(Transformation):
    """DMP*: a moved goal adds to the path, the same for every letter."""

    name = "star"
    is_translation = True

    def retarget(self, values: Array, offset: Array, new: Array, gain: Array | float) -> Array:
        """Return values + gain (new - offset)."""
        return values + gain * (new - offset)


@TRANSFORMATIONS.add
class Original(Transformation):
    """Ijspeert 2002, the paper's equations 1 and 8: each coordinate grows with its goal offset.

    z'' = K o + o f - K z - D z'
    """

    name = "original"
    weights_fit_any_goal = False

    def input(self, f: Array, offset: Array, K: float, s: Array) -> Array:
        """Return o (K + f)."""
        return offset * (K + f)

    def needed_forcing(self, u: Array, offset: Array, K: float, s: Array, divide: bool) -> Array:
        """Return u / o - K."""
        return u / offset - K if divide else u - K * offset

    def retarget(self, values: Array, offset: Array, new: Array, gain: Array | float) -> Array:
        """Return the values times new / offset: mirrored where the goal crosses the start."""
        return values * (new / offset)

    def check_demonstration(self, path: Array) -> None:
        """Raise a SettingError that names a coordinate which ends where it began."""
        offset, size = path[-1] - path[0], float(np.ptp(path))
        for axis in np.flatnonzero(np.abs(offset) <= _SAME_POINT * size):
            raise SettingError(
                "The original form cannot learn a movement that ends where it began: start and "
                f"goal are equal in coordinate {axis} ({'xyz'[axis] if axis < 3 else axis}). "
                "Settings.star() can."
            )


@TRANSFORMATIONS.add
class Similarity(Transformation):
    """As DMP*, with all of it turned and scaled to another goal offset (Ginesi 2019, DMP++)."""

    name = "similarity"

    def retarget(self, values: Array, offset: Array, new: Array, gain: Array | float) -> Array:
        """Return the values turned and scaled by `similarity_matrix`."""
        return values @ similarity_matrix(offset, new).T

    def check_demonstration(self, path: Array) -> None:
        """Raise a SettingError where a stroke is closed."""
        _refuse_closed(path[-1] - path[0], float(np.ptp(path)))

    def check_goal(self, offset: Array, new: Array, path: Array) -> None:
        """Raise for a closed stroke, and for one that is to end where it begins."""
        _refuse_closed(offset, float(np.ptp(path)))
        if np.linalg.norm(new) <= _SAME_POINT * np.linalg.norm(offset):
            raise TrajectoryError(
                "The goal is the start, but transform 'similarity' would shrink the whole letter "
                "to that point: ask for another goal, or learn it as DMP*, transform='star'."
            )


def similarity_matrix(offset: Array, new: Array) -> Array:
    """Return the matrix (D, D) that carries `offset` (D,) onto `new` (D,) by turning and scaling.

        R = I + X + X^2 / (1 + a.b),   X = b a' - a b'      (Rodrigues, in any number of dimensions)

    with unit vectors a (offset) and b (new) is the smallest rotation. In one dimension there is
    none: it is the signed quotient, so that the letter turns over when its goal crosses its start,
    as in the original form. An offset turned right round has no smallest rotation: it is turned in
    the plane of the first two coordinates, where the page is.
    """
    a, b = offset / np.linalg.norm(offset), new / np.linalg.norm(new)
    scale = np.linalg.norm(new) / np.linalg.norm(offset)
    if len(a) == 1:
        return np.array([[scale * a[0] * b[0]]])
    X = np.outer(b, a) - np.outer(a, b)
    if 1 + a @ b > 1e-9:
        return scale * (np.eye(len(a)) + X + X @ X / (1 + a @ b))
    beside = np.zeros(len(a))
    beside[:2] = (-a[1], a[0]) if np.hypot(a[0], a[1]) > 1e-6 else (1.0, 0.0)
    beside -= a * (a @ beside)
    beside /= np.linalg.norm(beside)
    return scale * (np.eye(len(a)) - 2 * np.outer(a, a) - 2 * np.outer(beside, beside))


def _attraction(offset: Array, s: Array) -> Array:
    """Return o (1 - s), shape (M, D), each coordinate in one piece of memory."""
    return np.multiply.outer(offset, 1 - s[:, 0]).T


def _refuse_closed(offset: Array, size: float) -> None:
    if np.linalg.norm(offset) <= _SAME_POINT * size:
        raise SettingError(
            "transform is 'similarity', but this stroke is closed: its goal is its start, and no "
            "turn or scale carries one point elsewhere. DMP* can learn it: transform='star'."
        )
