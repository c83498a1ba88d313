"""A primitive as JSON: its fields, and the path of its rollout, whose last bits would differ."""

from __future__ import annotations

import math
from dataclasses import asdict, fields
from typing import Any, TypeVar

import numpy as np

from dmp_teach.dmp.checks import check_duration
from dmp_teach.dmp.settings import Settings
from dmp_teach.files import array_from_json, must
from dmp_teach.trajectory import Trajectory

# JSON has no infinity.
INFINITE = "inf"
# A clock that has run for longer than this may be one of the world, since midnight or 1970 [s].
LONGEST_CLOCK = 3600.0

# Any: a DMP, whose module imports this one; here and below.
_Primitive = TypeVar("_Primitive", bound=Any)


def clock_to_forget(begin: float) -> float:
    """Return what to take from times, so that a clock of more than an hour begins at 0 [s]."""
    return begin if abs(begin) > LONGEST_CLOCK else 0.0


# Any: what JSON holds, here and below.
def primitive_to_json(primitive: Any, begin: float) -> dict[str, Any]:
    """Return a primitive with `begin` taken from its times [s]."""
    values = {each.name: getattr(primitive, each.name) for each in fields(primitive)}
    settings = asdict(primitive.settings)
    values["settings"] = {k: INFINITE if v == math.inf else v for k, v in settings.items()}
    values |= {"times": primitive.times - begin, "path": primitive.nominal_path}
    return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in values.items()}


def primitive_from_json(kind: type[_Primitive], values: dict[str, Any]) -> _Primitive:
    """Return the primitive, a `DMP`, of what `primitive_to_json` gave; any error says it is none.

    Args:
        kind: `DMP`.
        values: Any.
    """
    given: dict[str, Any] = values["settings"]
    given = {k: math.inf if v == INFINITE else v for k, v in given.items()}
    settings = Settings(**given)
    size, kernels = len(values["start"]), given["n_kernels"]
    shapes: dict[str, tuple[int, ...]] = dict.fromkeys(["weights", "biases"], (kernels, size))
    shapes |= dict.fromkeys(["start", "goal", "start_velocity"], (size,))
    shapes |= {"times": (len(values["times"]),), "path": (values["steps"] + 1, size)}
    arrays = {
        name: array_from_json(name, values[name], shape)
        for name, shape in shapes.items()
        if name != "biases" or values[name] is not None
    }
    path, notes = arrays.pop("path"), tuple(values["notes"])
    must(all(isinstance(note, str) for note in notes), "notes", notes, "texts")
    own = {name: value for name, value in values.items() if name != "path"}
    own["duration"] = check_duration("duration", values["duration"])
    primitive = kind(**{**own, **arrays, "settings": settings, "notes": notes})
    # Refused: times that do not increase.
    Trajectory(primitive.times, primitive.times)
    return primitive.with_path(path)
