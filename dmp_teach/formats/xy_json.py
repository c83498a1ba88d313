"""JSON of other programs: lists of points, of named numbers, or of strokes of either.

Read are `{"x": [...], "y": [...], "t": [...]}`, `[{"x": 1, "y": 2}, ...]`, `[[t, x, y], ...]`, and
lists of such strokes, wherever they lie in the file: the first that is found counts.
"""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Iterator
from dataclasses import replace
from typing import TypeGuard

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.columns import read_columns
from dmp_teach.formats.dmp_teach_json import begins_like_json
from dmp_teach.formats.flat_ink import label_from
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.strangers import describe_stranger
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

LABEL_KEYS = ("character", "letter", "label", "word", "truth")
MOST_LETTERS = 10_000  # in a file with one object a line
MOST_VALUES = 20_000  # lists and objects that are looked at
TableStroke = tuple[tuple[str, ...] | None, Array]
"""The names of columns, or None, and a row for each sample."""


def is_other_json(data: bytes) -> bool:
    """Tell whether a file is JSON, and of no other kind that has a name."""
    return begins_like_json(data) and describe_stranger(data) is None


def read_other_json(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in a JSON file; errors as `read_columns`."""
    text = data.decode("utf-8-sig", errors="replace")
    try:
        try:
            contents = [json.loads(text)]
        except ValueError:
            # One object a line, a letter each.
            lines = [line for line in text.splitlines() if line.strip()]
            contents = [json.loads(line) for line in lines[:MOST_LETTERS]]
    except (ValueError, RecursionError) as error:
        raise RecordingError(f"is no whole JSON: {str(error)[:100]}; save it again.") from None
    return tuple(letter for each in contents for letter in _letters(each, name, options))


def _letters(content: object, name: str, options: CaptureOptions) -> Iterator[Recording]:
    """Yield the letter in a value of JSON, labelled where it says which one it is."""
    strokes = _first_strokes(content)
    if not strokes:
        raise RecordingError(
            "is JSON in which no list of points is found; write them as "
            '{"t": [...], "x": [...], "y": [...]}, or as [[t, x, y], ...].'
        )
    names = strokes[0][0]
    alike = [table for each, table in strokes if each == names]
    width = alike[0].shape[1]
    gap = np.full((1, width), np.nan)
    rows = [part for table in alike if table.shape[1] == width for part in (table, gap)]
    said = content if isinstance(content, dict) else {}
    labels = (said[key] for key in LABEL_KEYS if isinstance(said.get(key), str))
    for letter in read_columns(np.concatenate(rows), names, name, options, on_screen=True):
        yield replace(letter, character=label_from(next(labels, None)) or letter.character)


def _first_strokes(content: object) -> list[TableStroke]:
    """Return the strokes in the first value that holds any, breadth first."""
    queue, looked = deque([content]), 0
    while queue and looked < MOST_VALUES:
        value = queue.popleft()
        looked += 1
        one = _stroke(value)
        if one is not None:
            return [one]
        children = list(value.values()) if isinstance(value, dict) else value
        if not isinstance(children, list):
            continue
        many = [_stroke(each) or _stroke_in(each) for each in children]
        found = [each for each in many if each is not None]
        if found and isinstance(value, list):
            return found
        queue += [each for each in children if isinstance(each, list | dict)]
    return []


def _stroke_in(value: object) -> TableStroke | None:
    """Return the stroke that is one of an object's values, as in {"points": [...]}."""
    values = value.values() if isinstance(value, dict) else ()
    return next((stroke for each in values if (stroke := _stroke(each)) is not None), None)


def _stroke(value: object) -> TableStroke | None:
    """Return a value as a stroke; None where it is none."""
    if isinstance(value, dict):
        rows = {name: each for name, each in value.items() if _is_row(each)}
        if len(rows) < 2 or len({len(each) for each in rows.values()}) > 1:
            return None
        return tuple(rows), np.array(list(map(_row, rows.values()))).T
    if not isinstance(value, list) or not value:
        return None
    names = None
    if all(isinstance(each, dict) for each in value):
        names = tuple(name for name, each in value[0].items() if _is_number(each))
        value = [[each.get(name) for name in names] for each in value]
    widths = {len(each) if _is_row(each) else 0 for each in value}
    if len(widths) != 1 or min(widths) < 2:
        return None
    table = np.array(list(map(_row, value)))
    lies = names is None and len(table) < min(table.shape[1], 5)
    return names, table.T if lies else table


def _is_number(value: object) -> TypeGuard[float]:
    """Tell whether a value is a number, or says yes or no."""
    return isinstance(value, int | float) and abs(value) < 1e100


def _is_row(values: object) -> TypeGuard[list[float | None]]:
    """Tell whether a value is a list of numbers, some of which may be missing."""
    if not isinstance(values, list) or not values:
        return False
    return all(each is None or _is_number(each) for each in values)


def _row(values: list[float | None]) -> list[float]:
    """Return numbers, with NaN for nothing."""
    return [np.nan if each is None else float(each) for each in values]


FORMAT = Format("other JSON", (".json",), is_other_json, read_other_json)
