"""The value that flows through the house: where a pen is, and when."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.errors import TrajectoryError
from dmp_teach.values import Value, as_array, locked

Array = NDArray[np.float64]


def arc_lengths(path: Array) -> Array:
    """Return how far along a path (T, D) each of its points is, shape (T,) [m]."""
    step = np.diff(path, axis=0)
    return np.concatenate([[0.0], np.cumsum(np.sqrt(np.einsum("td,td->t", step, step)))])


def interpolate_points(at: Array, known: Array | NDArray[np.int_] | range, points: Array) -> Array:
    """Return points (T, D), known at increasing times or ways (T,), at others (K,): shape (K, D).

    Beyond the ends the first and the last stay.
    """
    return np.column_stack([np.interp(at, known, axis) for axis in points.T])


def rms(apart: Array) -> float:
    """Return the root mean square length of the rows of `apart` (T, D)."""
    return float(np.sqrt((apart**2).sum(axis=1).mean()))


def path_length(path: Array) -> float:
    """Return how long a path (T, D) is, from point to point [m]."""
    return float(arc_lengths(path)[-1])


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory(Value):
    """A movement, sampled at increasing times.

    A stroke keeps the clock of its recording, so that the lift between two strokes has a duration.

    Args:
        t: Times, strictly increasing, shape (T,), T at least 2 [s].
        position: Positions, shape (T, D); shape (T,) is taken for one dimension [m].

    Raises:
        TrajectoryError: Shapes that do not match, fewer than 2 samples, a value that is not
            finite, or a time that does not come after the one before.
    """

    t: Array
    position: Array

    def __post_init__(self) -> None:
        """Copy, check and lock both arrays."""
        t, position = as_array("t", self.t), as_array("position", self.position)
        if position.ndim == 1:
            position = position[:, None]
        _check(t, position)
        object.__setattr__(self, "t", locked(t))
        object.__setattr__(self, "position", locked(position))

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @property
    def dimensions(self) -> int:
        """How many numbers a position has: D."""
        return self.position.shape[1]

    def __len__(self) -> int:
        """Return how many samples there are: T."""
        return len(self.t)

    def __repr__(self) -> str:
        """Return one line, without the numbers."""
        return f"Trajectory({len(self)} samples, {self.dimensions}-D, {self.duration:.3f} s)"


def all_points(strokes: Iterable[Trajectory]) -> Array:
    """Return the points of strokes, one after the other, shape (T, D) [m]."""
    return np.concatenate([stroke.position for stroke in strokes])


def resample_in_time(movement: Trajectory, samples: int) -> Trajectory:
    """Return a movement at so many samples, evenly spaced over its duration."""
    t = np.linspace(movement.t[0], movement.t[-1], samples)
    return Trajectory(t, interpolate_points(t, movement.t, movement.position))


def from_rollout(t: Array, position: Array) -> Trajectory:
    """Wrap a `position` (T, D) that was just computed, at the locked times of another trajectory.

    It is locked where it lies, and one sum of squares tells that its numbers are finite: copies and
    full checks take longer than a primitive takes to draw it.
    """
    flat = position.ravel(order="K")
    if not math.isfinite(flat.dot(flat)):
        return Trajectory(t, position)
    position.setflags(write=False)
    drawn = object.__new__(Trajectory)
    drawn.__dict__.update(t=t, position=position)
    return drawn


def _check(t: Array, position: Array) -> None:
    """Raise a TrajectoryError that names the first sample that breaks a rule."""
    if t.ndim != 1 or position.ndim != 2 or len(t) != len(position) or position.shape[1] < 1:
        raise TrajectoryError(
            f"t has shape {t.shape} and position {position.shape}, but they must be (T,) and "
            "(T, D): one row of positions for every time."
        )
    if len(t) < 2:
        raise TrajectoryError(f"A trajectory needs at least 2 samples, but has {len(t)}.")
    # No NaN comes after anything, and what lies between two finite times is finite: one pass over
    # t is enough.
    if (t[1:] > t[:-1]).all() and math.isfinite(t[-1] - t[0]) and np.isfinite(position).all():
        return
    for name, bad in (("t", ~np.isfinite(t)), ("position", ~np.isfinite(position).all(axis=1))):
        if bad.any():
            row = int(np.argmax(bad))
            value = t[row] if name == "t" else position[row]
            raise TrajectoryError(
                f"{name}[{row}] is {value}, but must be finite; fill or cut the gap first."
            )
    stuck = np.diff(t) <= 0
    if stuck.any():
        row = int(np.argmax(stuck)) + 1
        raise TrajectoryError(
            f"t[{row}] is {t[row]} s and does not come after t[{row - 1}] = {t[row - 1]} s; times "
            "must increase."
        )
