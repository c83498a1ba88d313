"""A learned letter as plain JSON: strokes, settings and weights; no code and no names of people.

The format, version 1, is one object with the strokes as rows t [s], x, y [m]; for each stroke its
primitive (weights, biases, start, goal and so on, and the path of its rollout, so that it draws the
same to the last bit); goals that strokes are led to; what the letter was made of; and a check sum:
a file that was edited or damaged is refused.
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

LETTER_FORMAT = "dmp_teach letter"
LETTER_VERSION = 1
LETTER_UNITS = {"t": "s", "x": "m", "y": "m"}
LETTER_FIELDS = tuple(
    ["format", "version", "units", "strokes", "primitives", "led_to", "made_of", "check"]
)
PRIMITIVE_FIELDS = tuple(
    [
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
    ]
)
# A clock that has run for longer than this may be one of the world, since midnight or 1970 [s].
LONGEST_CLOCK = 3600.0
# JSON has no infinity.
INFINITE = "inf"


def letter_to_json(letter: Any) -> str:
    """Return a `Letter` as JSON; a clock that has run for more than an hour begins at 0.

    Raises:
        LetterError: A stroke that is not 2-D.
    """
    if any(stroke.dimensions != 2 for stroke in letter.strokes):
        raise LetterError("A letter that is saved has strokes in 2-D: right and up [m].")
    begin = letter.strokes[0].t[0]
    begin = begin if abs(begin) > LONGEST_CLOCK else 0.0
    content = {
        "format": LETTER_FORMAT,
        "version": LETTER_VERSION,
        "units": LETTER_UNITS,
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
    """Read a saved letter: the arguments of `Letter`.

    Raises:
        LetterError: No such file, another format or version, a file that was changed, or a field
            that is wrong.
    """
    name = ""
    try:
        data, name = contents(path)
        return _parts(loaded(data, LETTER_FORMAT, (LETTER_VERSION,), LETTER_FIELDS))
    except TeachError as error:
        raise LetterError(f"{name}: {error}" if name else str(error)) from None


def check_sum(content: dict[str, Any]) -> str:
    """Return a number that changes with every character of the content, "check" left out."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def _primitive_to_json(primitive: DMP, begin: float) -> dict[str, Any]:
    """Return a primitive as what JSON can hold."""
    fields = {name: getattr(primitive, name) for name in PRIMITIVE_FIELDS}
    fields = {
        name: value.tolist() if isinstance(value, np.ndarray) else value
        for name, value in fields.items()
    }
    settings = asdict(primitive.settings)
    fields["settings"] = {k: INFINITE if v == math.inf else v for k, v in settings.items()}
    fields["times"] = (primitive.times - begin).tolist()
    return fields | {"path": primitive.nominal_path.tolist()}


def _parts(content: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of a letter, every field checked."""
    given = content.pop("check")
    unchanged = "that of the content: it was changed after it was saved; save again"
    must(given == check_sum(content), "check", given, unchanged)
    must(content["units"] == LETTER_UNITS, "units", content["units"], repr(LETTER_UNITS))
    names = ("strokes", "primitives", "led_to", "made_of")
    strokes, primitives, led, made = (content[name] for name in names)
    are_lists = isinstance(strokes, list) and isinstance(primitives, list)
    paired = are_lists and 0 < len(strokes) == len(primitives)
    must(paired, "strokes", strokes, "a list, with a primitive for each")
    numbers = {str(k): k for k in range(len(strokes))}
    goals = isinstance(led, dict) and set(led) <= set(numbers)
    must(goals, "led_to", led, "a goal by the number of a stroke")
    named = isinstance(made, list) and all(isinstance(name, str) for name in made)
    must(named, "made_of", made, "a list of names")
    rows = [_numbers(f"strokes[{k}]", stroke, (None, 3)) for k, stroke in enumerate(strokes)]
    return {
        "strokes": tuple(Trajectory(row[:, 0], row[:, 1:]) for row in rows),
        "primitives": tuple(
            _primitive(f"primitives[{k}]", each) for k, each in enumerate(primitives)
        ),
        "led_to": {numbers[k]: _numbers(f"led_to[{k}]", goal, (2,)) for k, goal in led.items()},
        "made_of": tuple(made),
    }


def _primitive(name: str, fields: Any) -> DMP:
    """Return one primitive, every field checked."""
    complete = isinstance(fields, dict) and set(fields) == {*PRIMITIVE_FIELDS, "path"}
    must(complete, name, fields, f"an object with {', '.join(PRIMITIVE_FIELDS)}, path")
    settings = _settings(f"{name}.settings", fields["settings"])
    kernels, steps, notes = settings.n_kernels, fields["steps"], fields["notes"]
    resolved = kernels is not None and settings.alpha is not None
    wanted = "complete: n_kernels and alpha are numbers"
    must(resolved, f"{name}.settings", fields["settings"], wanted)
    whole = type(steps) is int and 0 < steps < 10**7
    must(whole, f"{name}.steps", steps, "a whole number of steps")
    sentences = isinstance(notes, list) and all(isinstance(note, str) for note in notes)
    must(sentences, f"{name}.notes", notes, "sentences")
    duration = fields["duration"]
    lasts = is_number(duration) and duration > 0
    must(lasts, f"{name}.duration", duration, "a time longer than 0 s")

    def numbers(field: str, *shape: int | None) -> Array:
        return _numbers(f"{name}.{field}", fields[field], shape)

    times, path = numbers("times", None), numbers("path", steps + 1, 2)
    # A trajectory refuses times that do not increase.
    Trajectory(times, times)
    primitive = DMP(
        weights=numbers("weights", kernels, 2),
        biases=None if fields["biases"] is None else numbers("biases", kernels, 2),
        start=numbers("start", 2),
        goal=numbers("goal", 2),
        duration=duration,
        settings=settings,
        start_velocity=numbers("start_velocity", 2),
        times=times,
        steps=steps,
        notes=tuple(notes),
    )
    # Drawn again, the last bits of the path may differ.
    return primitive.with_path(path)


def _settings(name: str, fields: Any) -> Settings:
    """Return the settings, each within its range."""
    known = {each.name for each in knobs()}
    complete = isinstance(fields, dict) and set(fields) == known
    must(complete, name, fields, f"an object with {', '.join(sorted(known))}")
    # Any: `Settings` checks the type of each.
    values: dict[str, Any] = {k: math.inf if v == INFINITE else v for k, v in fields.items()}
    return Settings(**values)


def _numbers(name: str, rows: Any, shape: tuple[int | None, ...]) -> Array:
    """Return finite numbers of that shape, None being any length."""
    must(isinstance(rows, list), name, rows, "a list of numbers")
    nested = len(shape) == 2 and all(isinstance(row, list) for row in rows)
    good = all(is_number(value) for value in (chain.from_iterable(rows) if nested else rows))
    try:
        array = np.array(rows, dtype=float) if good else np.empty(())
    except ValueError:
        # Rows of different lengths.
        array = np.empty(())
    fits = array.ndim == len(shape) and all(
        want in (None, size) for want, size in zip(shape, array.shape, strict=True)
    )
    wanted = " x ".join("any" if want is None else str(want) for want in shape)
    must(fits, name, rows, f"finite numbers, {wanted}")
    return array
