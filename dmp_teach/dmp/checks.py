"""What was asked of a primitive, checked: every answer is a value that works, or a sentence."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.trajectory import Array, Trajectory

MOST_SAMPLES = 2_000_000
NO_WAY = 1e-9  # of the size of the movement: start and goal are the same point


def as_settings(
    given: Any, usual: Callable[[], Settings] = Settings.star, name: str = "settings"
) -> Settings:
    """The settings that were given, the usual ones where that is None, or a sentence."""
    if given is None:
        return usual()
    if not isinstance(given, Settings):
        raise SettingError(f"{name} is {given!r}, but must be Settings, such as Settings.star().")
    return given


def named_settings(given: Any, usual: Mapping[str, Settings]) -> dict[str, Settings]:
    """Settings by their names, the usual ones where none were given; or a sentence."""
    if given is None:
        return dict(usual)
    if not isinstance(given, Mapping) or not given:
        raise SettingError(
            f"settings is {given!r}, but must be Settings by their names, such as {{'DMP*': Settings.star()}}."
        )
    return {name: as_settings(each, name=f"settings[{name!r}]") for name, each in given.items()}


def check_point(name: str, value: ArrayLike, dimensions: int) -> Array:
    """`value` as a point (D,) of a movement of so many `dimensions` [m], or a sentence."""
    try:
        given = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TrajectoryError(
            f"{name} is {value!r}, but it must be {dimensions} numbers [m]."
        ) from None
    if given.shape != (dimensions,):
        raise TrajectoryError(
            f"{name} has shape {given.shape}, but this movement has {dimensions} dimensions: "
            f"give {dimensions} numbers [m]."
        )
    if not all(
        map(math.isfinite, given.tolist())
    ):  # five times faster than NumPy's, for two numbers
        raise TrajectoryError(f"{name} is {given}, but it must be finite [m].")
    return given


def seconds(name: str, value: float) -> float:
    """`value` as a length of time, or a sentence."""
    try:
        given = float(value)
    except (TypeError, ValueError):
        given = math.nan
    if not (math.isfinite(given) and given > 0):
        raise TrajectoryError(f"{name} is {value!r}, but it must be a time longer than 0 s.")
    return given


def samples(duration: float, dt: float) -> int:
    """How many steps of about `dt` a movement has."""
    if dt > duration * (1 + 1e-9):
        raise TrajectoryError(
            f"dt is {dt:g} s, but the movement lasts only {duration:g} s; dt must be shorter."
        )
    if duration / dt > MOST_SAMPLES:
        least = duration / MOST_SAMPLES
        raise TrajectoryError(
            f"dt is {dt:g} s, but must be at least {least:.3g} s for {duration:g} s."
        )
    return max(1, round(duration / dt))


def refuse_no_way(trajectory: Trajectory, settings: Settings) -> None:
    """Raise a SettingError where a transformation needs a way from start to goal and there is none.

    The original form divides by g - y0, coordinate by coordinate; a similarity needs a direction and a size.
    """
    if settings.transform == "star":
        return
    way, size = trajectory.position[-1] - trajectory.position[0], float(np.ptp(trajectory.position))
    if settings.transform == "original":
        for axis in np.flatnonzero(np.abs(way) <= NO_WAY * size):
            raise SettingError(
                f"The original form cannot learn a movement that ends where it began: start and goal are equal in "
                f"coordinate {axis} ({'xyz'[axis] if axis < 3 else axis}). Settings.star() can."
            )
    if settings.transform == "similarity":
        _refuse_closed(way, size)


def refuse_no_similarity(way: Array, taught: Array, shown: Array) -> None:
    """Raise where no turn and scale carries the `taught` way (D,) of a path `shown` (T, D) onto `way` (D,).

    Raises:
        SettingError: The path was closed (a primitive learned with another transformation may be).
        TrajectoryError: It is asked to end where it begins.
    """
    _refuse_closed(taught, float(np.ptp(shown)))
    if np.linalg.norm(way) <= NO_WAY * np.linalg.norm(taught):
        raise TrajectoryError(
            "The goal is the start, but transform 'similarity' would shrink the whole letter to that point: ask for "
            "another goal, or learn it as DMP*, transform='star'."
        )


def _refuse_closed(way: Array, size: float) -> None:
    if np.linalg.norm(way) <= NO_WAY * size:
        raise SettingError(
            "transform is 'similarity', but this stroke is closed: its goal is its start, and no turn or scale carries "
            "one point elsewhere. DMP* can learn it: transform='star'."
        )
