"""Checks of the arguments of a primitive's methods: a value that works, or a sentence."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, TrajectoryError, shown
from dmp_teach.trajectory import Array

MOST_ROLLOUT_STEPS = 2_000_000


def as_settings(
    given: object, usual: Callable[[], Settings] = Settings.star, name: str = "settings"
) -> Settings:
    """Return the settings that were given, the usual ones for None, or raise a SettingError."""
    if given is None:
        return usual()
    if not isinstance(given, Settings):
        raise SettingError(
            f"{name} is {shown(given)}, but must be Settings, such as Settings.star()."
        )
    return given


def named_settings(given: object, usual: Mapping[str, Settings]) -> dict[str, Settings]:
    """Return settings by their names, the usual ones for None, or raise a SettingError."""
    if given is None:
        return dict(usual)
    if not isinstance(given, Mapping) or not given:
        raise SettingError(
            f"settings is {shown(given)}, but must be Settings by their names, such as "
            "{'DMP*': Settings.star()}."
        )
    return {name: as_settings(each, name=f"settings[{name!r}]") for name, each in given.items()}


def check_point(name: str, value: ArrayLike, dimensions: int) -> Array:
    """Return `value` as a point, shape (dimensions,) [m], or raise a TrajectoryError."""
    try:
        given = as_numbers(value)
    except ValueError:
        raise TrajectoryError(
            f"{name} is {shown(value)}, but it must be {dimensions} numbers [m]."
        ) from None
    if given.shape != (dimensions,):
        raise TrajectoryError(
            f"{name} has shape {given.shape}, but this movement has {dimensions} dimensions: "
            f"give {dimensions} numbers [m]."
        )
    # Five times faster than NumPy's, for two numbers.
    if not all(map(math.isfinite, given.tolist())):
        raise TrajectoryError(f"{name} is {given}, but it must be finite [m].")
    return given


def check_duration(name: str, value: float) -> float:
    """Return `value` as a length of time [s], or raise a TrajectoryError."""
    try:
        given = float(value)
    except (TypeError, ValueError):
        given = math.nan
    if not (math.isfinite(given) and given > 0):
        raise TrajectoryError(f"{name} is {shown(value)}, but it must be a time longer than 0 s.")
    return given


def count_steps(duration: float, dt: float) -> int:
    """Return how many steps of about `dt` a movement has, or raise a TrajectoryError."""
    if dt > duration * (1 + 1e-9):
        raise TrajectoryError(
            f"dt is {dt:g} s, but the movement lasts only {duration:g} s; dt must be shorter."
        )
    if duration / dt > MOST_ROLLOUT_STEPS:
        least = duration / MOST_ROLLOUT_STEPS
        raise TrajectoryError(
            f"dt is {dt:g} s, but must be at least {least:.3g} s for {duration:g} s."
        )
    return max(1, round(duration / dt))
