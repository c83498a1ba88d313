"""A learned letter as plain JSON: its strokes, its settings and its weights; nothing that could be run, nobody's name.

The format, version 1, is one object with the strokes as rows t [s], x, y [m], for each stroke its primitive (weights,
biases, start, goal and so on, and the path that it was seen to draw, so that it draws the same to the last bit), goals
that strokes are led to, what the letter was made of, and a check sum: a file that was edited or damaged is refused.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from dataclasses import asdict
from itertools import chain
from typing import Any

import numpy as np

from dmp_teach.dmp import DMP, Settings, knobs
from dmp_teach.errors import LetterError, TeachError
from dmp_teach.files import contents, is_number, loaded, must
from dmp_teach.trajectory import Array, Trajectory

FORMAT = "dmp_teach letter"
VERSION = 1
UNITS = {"t": "s", "x": "m", "y": "m"}
FIELDS = ("format", "version", "units", "strokes", "primitives", "led_to", "made_of", "check")
PRIMITIVE = (
    "settings",
    "weights",
    "biases",
    "start",
    "goal",
    "duration",
    "start_velocity",
    "times",
    "steps",
    "notes",
)
HOUR = 3600.0  # a clock that has run for longer than this may be one of the world: since midnight, or since 1970 [s]
ENDLESS = "inf"  # JSON has no infinity


def to_json(letter: Any) -> str:
    """A `Letter` as JSON; its clock is kept, unless it has run for more than an hour: then it begins at 0.

    Raises:
        LetterError: A stroke that is not 2-D.
    """
    if any(stroke.dimensions != 2 for stroke in letter.strokes):
        raise LetterError("A letter that is saved has strokes in 2-D: right and up [m].")
    begin = letter.strokes[0].t[0]
    begin = begin if abs(begin) > HOUR else 0.0
    content = {
        "format": FORMAT,
        "version": VERSION,
        "units": UNITS,
        "strokes": [
            np.column_stack([stroke.t - begin, stroke.position]).tolist()
            for stroke in letter.strokes
        ],
        "primitives": [_said(primitive, begin) for primitive in letter.primitives],
        "led_to": {str(number): goal.tolist() for number, goal in letter.led_to.items()},
        "made_of": list(letter.made_of),
    }
    lines = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in content.items()]
    return "{\n" + ",\n".join([*lines, f'"check": "{_check_sum(content)}"']) + "\n}\n"


def parts_of(path: str | os.PathLike[str]) -> dict[str, Any]:
    """What a saved letter is made of: the arguments of `Letter`.

    Raises:
        LetterError: No such file, another format or version, a file that was changed, or a field that cannot be.
    """
    name = ""
    try:
        data, name = contents(path)
        return _parts(loaded(data, FORMAT, (VERSION,), FIELDS))
    except LetterError as error:
        raise LetterError(f"{name}: {error}") from None
    except TeachError as error:
        raise LetterError(f"{name}: {error}" if name else str(error)) from None


def _said(primitive: DMP, begin: float) -> dict[str, Any]:
    """A primitive as what JSON can hold."""
    said = {name: getattr(primitive, name) for name in PRIMITIVE}
    said = {
        name: value.tolist() if isinstance(value, np.ndarray) else value
        for name, value in said.items()
    }
    settings = asdict(primitive.settings)
    said["settings"] = {
        name: ENDLESS if value == math.inf else value for name, value in settings.items()
    }
    said["times"] = (primitive.times - begin).tolist()
    return said | {"path": primitive.shown.tolist()}


def _check_sum(content: dict[str, Any]) -> str:
    """A number that changes with every sign of the content."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _parts(content: dict[str, Any]) -> dict[str, Any]:
    """The arguments of a letter, every field checked."""
    said = content.pop("check")
    must(
        said == _check_sum(content),
        "check",
        said,
        "that of the content: it was changed after it was saved; save again",
    )
    must(content["units"] == UNITS, "units", content["units"], repr(UNITS))
    strokes, primitives, led, made = (
        content[name] for name in ("strokes", "primitives", "led_to", "made_of")
    )
    lists = (
        isinstance(strokes, list)
        and isinstance(primitives, list)
        and 0 < len(strokes) == len(primitives)
    )
    must(lists, "strokes", strokes, "a list, with a primitive for each")
    numbers = {str(k): k for k in range(len(strokes))}
    must(
        isinstance(led, dict) and set(led) <= set(numbers),
        "led_to",
        led,
        "a goal by the number of a stroke",
    )
    must(
        isinstance(made, list) and all(isinstance(name, str) for name in made),
        "made_of",
        made,
        "a list of names",
    )
    rows = [_numbers(f"strokes[{k}]", stroke, (None, 3)) for k, stroke in enumerate(strokes)]
    return {
        "strokes": tuple(Trajectory(row[:, 0], row[:, 1:]) for row in rows),
        "primitives": tuple(
            _primitive(f"primitives[{k}]", each) for k, each in enumerate(primitives)
        ),
        "led_to": {
            numbers[key]: _numbers(f"led_to[{key}]", goal, (2,)) for key, goal in led.items()
        },
        "made_of": tuple(made),
    }


def _primitive(name: str, said: Any) -> DMP:
    """One primitive."""
    good = isinstance(said, dict) and set(said) == {*PRIMITIVE, "path"}
    must(good, name, said, f"an object with {', '.join(PRIMITIVE)}, path")
    settings = _settings(f"{name}.settings", said["settings"])
    kernels, steps, notes = settings.n_kernels, said["steps"], said["notes"]
    resolved = settings.n_kernels is not None and settings.alpha is not None
    must(
        resolved, f"{name}.settings", said["settings"], "complete: n_kernels and alpha are numbers"
    )
    must(
        type(steps) is int and 0 < steps < 10**7, f"{name}.steps", steps, "a whole number of steps"
    )
    must(
        isinstance(notes, list) and all(isinstance(note, str) for note in notes),
        f"{name}.notes",
        notes,
        "sentences",
    )
    duration = said["duration"]
    must(
        is_number(duration) and duration > 0, f"{name}.duration", duration, "a time longer than 0 s"
    )
    shapes = {
        "weights": (kernels, 2),
        "start": (2,),
        "goal": (2,),
        "start_velocity": (2,),
        "path": (steps + 1, 2),
    }
    values = {each: _numbers(f"{name}.{each}", said[each], shape) for each, shape in shapes.items()}
    biases = (
        None if said["biases"] is None else _numbers(f"{name}.biases", said["biases"], (kernels, 2))
    )
    times = _numbers(f"{name}.times", said["times"], (None,))
    Trajectory(times, times)  # they must increase
    path = values.pop("path")
    made = {
        "biases": biases,
        "duration": duration,
        "settings": settings,
        "times": times,
        "steps": steps,
    }
    return DMP(notes=tuple(notes), **made, **values).showing(
        path
    )  # drawn again, its last bits may differ


def _settings(name: str, said: Any) -> Settings:
    """The settings, each within its range."""
    known = {each.name for each in knobs()}
    must(
        isinstance(said, dict) and set(said) == known,
        name,
        said,
        f"an object with {', '.join(sorted(known))}",
    )
    return Settings(
        **{each: math.inf if value == ENDLESS else value for each, value in said.items()}
    )


def _numbers(name: str, rows: Any, shape: tuple[int | None, ...]) -> Array:
    """Finite numbers of that shape, None being any length."""
    must(isinstance(rows, list), name, rows, "a list of numbers")
    nested = len(shape) == 2 and all(isinstance(row, list) for row in rows)
    good = all(is_number(value) for value in (chain.from_iterable(rows) if nested else rows))
    try:
        array = np.array(rows, dtype=float) if good else np.empty(())
    except ValueError:  # rows of different lengths
        array = np.empty(())
    fits = array.ndim == len(shape) and all(
        want in (None, size) for want, size in zip(shape, array.shape, strict=True)
    )
    wanted = " x ".join("any" if want is None else str(want) for want in shape)
    must(fits, name, rows, f"finite numbers, {wanted}")
    return array
