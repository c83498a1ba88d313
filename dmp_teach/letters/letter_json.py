"""A learned letter as plain JSON: strokes, settings and weights; no code and no names of people.

The format, version 1, is one object with the strokes as rows t [s], x, y [m], or as many numbers
as they have; for each stroke its primitive (the fields of `DMP`, and the path of its rollout, so
that it draws the same to the last bit); goals that strokes are led to; what the letter was made of;
and a check sum: a file that was edited or damaged is refused.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from dataclasses import asdict, fields
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings
from dmp_teach.errors import LetterError, TeachError, shown
from dmp_teach.files import contents, loaded
from dmp_teach.trajectory import Trajectory

LETTER_FORMAT = "dmp_teach letter"
LETTER_VERSION = 1
LETTER_FIELDS = tuple(
    ["format", "version", "units", "strokes", "primitives", "led_to", "made_of", "check"]
)
# A clock that has run for longer than this may be one of the world, since midnight or 1970 [s].
LONGEST_CLOCK = 3600.0
# JSON has no infinity.
INFINITE = "inf"


# Any: a Letter, whose module imports this one; and what JSON may hold.
def letter_to_json(letter: Any) -> str:
    """Return a `Letter` as JSON; a clock of more than an hour begins at 0."""
    begin = letter.strokes[0].t[0]
    begin = begin if abs(begin) > LONGEST_CLOCK else 0.0
    content = {
        "format": LETTER_FORMAT,
        "version": LETTER_VERSION,
        "units": _units(letter.strokes[0].dimensions),
        "strokes": [
            np.column_stack([stroke.t - begin, stroke.position]).tolist()
            for stroke in letter.strokes
        ],
        "primitives": [_primitive_to_json(each, begin) for each in letter.primitives],
        "led_to": {str(number): goal.tolist() for number, goal in letter.led_to.items()},
        "made_of": list(letter.made_of),
    }
    lines = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in content.items()]
    return "{\n" + ",\n".join([*lines, f'"check": "{check_sum(content)}"']) + "\n}\n"


def letter_parts(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a saved letter: the arguments of `Letter`; a LetterError says what is wrong with it."""
    name = ""
    try:
        data, name = contents(path)
        content = loaded(data, LETTER_FORMAT, (LETTER_VERSION,), LETTER_FIELDS)
        if content.pop("check") != check_sum(content):
            raise LetterError("it was changed after it was saved, or damaged; save again.")
        strokes = [np.array(rows, dtype=float) for rows in content["strokes"]]
        if any(content["units"] != _units(rows.shape[1] - 1) for rows in strokes):
            raise LetterError(
                f"its units are {shown(content['units'])}, but must be those of its rows."
            )
        if not 0 < len(strokes) == len(content["primitives"]):
            raise LetterError("it must have strokes, and a primitive for each.")
        return {
            "strokes": tuple(Trajectory(row[:, 0], row[:, 1:]) for row in strokes),
            "primitives": tuple(map(_primitive_from_json, content["primitives"])),
            "led_to": {int(n): np.array(goal, float) for n, goal in content["led_to"].items()},
            "made_of": tuple(content["made_of"]),
        }
    except TeachError as error:
        raise LetterError(f"{name}: {error}" if name else str(error)) from None
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise LetterError(f"{name}: this is no letter as Letter.save writes it: {error}.") from None


def check_sum(content: dict[str, Any]) -> str:
    """Return a number that changes with every character of the content, "check" left out."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _units(dimensions: int) -> dict[str, str]:
    """Return the unit of each number in a row."""
    axes = "xyz" if dimensions <= 3 else [f"x{n}" for n in range(1, dimensions + 1)]
    return {"t": "s"} | dict.fromkeys(axes[:dimensions], "m")


def _primitive_to_json(primitive: DMP, begin: float) -> dict[str, Any]:
    values = {each.name: getattr(primitive, each.name) for each in fields(DMP)}
    settings = asdict(primitive.settings)
    values["settings"] = {k: INFINITE if v == math.inf else v for k, v in settings.items()}
    values |= {"times": primitive.times - begin, "path": primitive.nominal_path}
    return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in values.items()}


def _primitive_from_json(values: dict[str, Any]) -> DMP:
    given = values["settings"].items()
    settings: dict[str, Any] = {k: math.inf if v == INFINITE else v for k, v in given}
    values["settings"] = Settings(**settings)
    values["notes"] = tuple(values["notes"])
    path = np.array(values.pop("path"), dtype=float)
    primitive = DMP(**values)
    # Refused: times that do not increase, and numbers that are not finite.
    Trajectory(primitive.times, primitive.times)
    Trajectory(np.linspace(0, 1, primitive.steps + 1), path)
    # Drawn again, the last bits of the path may differ.
    return primitive.with_path(path)
