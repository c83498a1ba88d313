"""What every way to learn a movement has in common: demonstrations in, a line to any goal out."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import check_whole, checked
from dmp_teach.dmp import check_point
from dmp_teach.errors import MissingPartError, TrajectoryError, kind_of
from dmp_teach.trajectory import Array, Trajectory, resample_in_time
from dmp_teach.values import Value

CUTS = 120
"""In so many equal parts of its duration a demonstration is learned."""


@dataclass(frozen=True, eq=False, repr=False)
class Aligned(Value):
    """Demonstrations of one movement, at equal parts of their durations.

    Args:
        paths: Seen from the mean start, in sizes, shape (n, CUTS + 1, D).
        start: The mean start, shape (D,) [m].
        size: The larger side of the mean path's bounding box [m].
        duration: The mean [s].
    """

    paths: Array
    start: Array
    size: float
    duration: float

    @property
    def mean(self) -> Array:
        """The mean path, shape (CUTS + 1, D) [sizes]."""
        return self.paths.mean(axis=0)

    def derivative(self, order: int) -> Array:
        """Return how paths change in a tenth of the movement, shape (n, CUTS + 1, D) [sizes]."""
        check_whole("order", order, 0, 3)
        values = self.paths
        for _ in range(order):
            values = np.gradient(values, 10 / CUTS, axis=1)
        return values


class Way(Value, ABC):
    """A way to learn a movement: `learn` it from demonstrations, `write` it to a goal."""

    name: ClassVar[str]
    library: ClassVar[str] = "numpy"

    @classmethod
    def can_learn(cls) -> bool:
        """Return whether the library that learns is installed."""
        return find_spec(cls.library) is not None

    @classmethod
    @abstractmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Learn a movement from one demonstration or several of it.

        Raises:
            TrajectoryError: No demonstrations, or of different dimensions.
            MissingPartError: The library that learns is not installed.
        """

    @abstractmethod
    def write(self, goal: ArrayLike | None = None) -> Trajectory:
        """Write the movement.

        Args:
            goal: Where it is to end, shape (D,) [m]; where it was learned to end, if not given.

        Raises:
            TrajectoryError: A goal of another dimension, or not finite.
        """

    @property
    @abstractmethod
    def duration(self) -> float:
        """How long it takes, as it was shown [s]."""

    @property
    @abstractmethod
    def numbers_stored(self) -> int:
        """How many numbers were learned and are kept."""


class GaussianWay(Way):
    """A Gaussian over whole paths: it writes the likeliest, or of those to a goal the likeliest.

    A path that is told its end follows it by `end_gain`: how the rest varies with the end.
    """

    aligned: Aligned

    @property
    def duration(self) -> float:
        """The mean of the demonstrations' [s]."""
        return self.aligned.duration

    @property
    @abstractmethod
    def mean_path(self) -> Array:
        """The likeliest path, shape (CUTS + 1, D) [sizes]."""

    @property
    @abstractmethod
    def end_gain(self) -> Array:
        """How each point moves with the end, shape (CUTS + 1, D, D), 0 where nothing moves it."""

    def write(self, goal: ArrayLike | None = None) -> Trajectory:
        """Write the likeliest path, or the likeliest of those that end at a goal."""
        at, path = self.aligned, self.mean_path
        if goal is not None:
            wanted = (check_point("goal", goal, len(at.start)) - at.start) / at.size
            path = path + self.end_gain @ (wanted - path[-1])
        return Trajectory(
            np.linspace(0, at.duration, len(path)),
            at.start + at.size * path,
        )


def align_takes(demonstrations: Iterable[Trajectory]) -> Aligned:
    """Return demonstrations at equal parts of their durations.

    Raises:
        TrajectoryError: None, something that is no trajectory, or different dimensions.
    """
    given = list_demonstrations(demonstrations)
    paths = np.array([even_path(each) for each in given])
    start = paths[:, 0].mean(axis=0)
    size = max(float(np.ptp(paths.mean(axis=0), axis=0).max()), 1e-6)
    duration = float(np.mean([each.duration for each in given]))
    return Aligned((paths - start) / size, start, size, duration)


def list_demonstrations(demonstrations: Iterable[Trajectory]) -> tuple[Trajectory, ...]:
    """Return demonstrations, checked.

    Raises:
        TrajectoryError: As `align_takes`.
    """
    # Any: what somebody gave.
    given: tuple[Any, ...] = (demonstrations,)
    if isinstance(demonstrations, Iterable) and not isinstance(demonstrations, Trajectory):
        given = tuple(demonstrations)
    odd = [each for each in given if not isinstance(each, Trajectory)]
    if odd or not given:
        got = kind_of(odd[0]) if odd else "nothing"
        raise TrajectoryError(f"Demonstrations are trajectories of one stroke, but got {got}.")
    if len({each.dimensions for each in given}) > 1:
        raise TrajectoryError("All demonstrations must have as many dimensions.")
    return given


@checked
def even_path(movement: Trajectory, steps: int = CUTS) -> Array:
    """Return where a pen is at equal parts of its duration, shape (steps + 1, D) [m]."""
    return resample_in_time(movement, steps + 1).position


def import_library(module: str, package: str) -> ModuleType:
    """Import a library that only some ways need.

    Raises:
        MissingPartError: It is not installed; says how to get it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        raise MissingPartError(
            f"This way to learn needs {package}, which is not here ({error}). The others work "
            f"without it; python3 -m pip install {package} brings it."
        ) from None


def one_thread() -> AbstractContextManager[object]:
    """Let libraries that learn take one thread: on small matrices more cost what they give."""
    return import_library("threadpoolctl", "scikit-learn").threadpool_limits(1)
