"""Digital ink of the UNIPEN project (Guyon et al. 1994): text with a keyword or a point in a line.

Components, from `.PEN_DOWN` or `.PEN_UP` to the next, are counted from 0; a `.SEGMENT CHARACTER`
with a delineation such as `0-2,4` is a letter, and a file without any is one letter. Y points up.
Times are those of the column T [ms], or the points' count and rate, or else a hand's.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import FlatLetter, FlatStroke, flat_recordings, label_from
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.ink import Recording

KEYWORD = re.compile(rb"(?:^|[\r\n])\.(?:VERSION|COORD|PEN_DOWN|SEGMENT)\b")
COMPONENTS = re.compile(r"(\d{1,6})(?:-(\d{1,6}))?")
MOST_UNIPEN_LINES = 200_000
LONGEST_UNIPEN_LINE = 1000  # [characters]
# A component: whether the pen is down, and its rows: the columns, and the points' counts.
Component = tuple[bool, list[list[float]]]


def has_unipen_keyword(data: bytes) -> bool:
    """Tell whether a file has one of UNIPEN's keywords."""
    return KEYWORD.search(data[:64_000]) is not None


def read_unipen(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a UNIPEN file.

    Raises:
        RecordingError: No ink in it, a point or a segment that cannot be, or far too many lines.
    """
    lines = [line[:LONGEST_UNIPEN_LINE] for line in data.decode("utf-8", "replace").splitlines()]
    if len(lines) > MOST_UNIPEN_LINES:
        raise RecordingError(f"has more than {MOST_UNIPEN_LINES} lines; cut it.")
    said = {line.split()[0]: line.split()[1:] for line in lines if line.startswith(".")}
    columns = [name.upper() for name in said.get(".COORD", ["X", "Y"])]
    if not {"X", "Y"} <= set(columns):
        raise RecordingError(f"has the columns {' '.join(columns)[:60]}, but must have X and Y.")
    components, segments, faults = _components(lines, len(columns))
    if not segments and not faults:
        segments = [(None, range(len(components)))]
    strokes = [_stroke(part, columns, said) for part in components]
    letters = [
        FlatLetter([stroke for k in places if (stroke := strokes[k])], label)
        for label, places in segments
    ]
    return flat_recordings(letters, _metres(said, "X"), faults)


def _components(
    lines: Sequence[str], width: int
) -> tuple[list[Component], list[tuple[str | None, Sequence[int]]], list[str]]:
    """Return all components, each character with the numbers of its components, and faults."""
    components: list[Component] = []
    segments, faults = [], []
    broken: set[int] = set()
    count = 0
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if words and words[0] in (".PEN_DOWN", ".PEN_UP"):
            components.append((words[0] == ".PEN_DOWN", []))
        elif words and words[0] == ".SEGMENT":
            segments.append((number, line))
        elif words and components and not words[0].startswith("."):
            row = [value for word in words if (value := finite_number(word)) is not None]
            if len(words) != width or len(row) != width:
                faults.append(
                    f"row {number} is {line[:40]!r}, but a point must have {width} numbers."
                )
                broken.add(len(components) - 1)
                continue
            components[-1][1].append([*row, float(count)])
            count += 1
    letters: list[tuple[str | None, Sequence[int]]] = []
    total = 0
    for number, line in segments:
        try:
            letter = _segment(line, number, len(components))
        except RecordingError as error:
            faults.append(str(error))
            continue
        if letter is not None:
            total += len(letter[1])
            letters += [letter] if broken.isdisjoint(letter[1]) else []
        if total > MOST_UNIPEN_LINES:
            raise RecordingError(
                f"has more than {MOST_UNIPEN_LINES} components in its segments; cut it."
            )
    return components, letters, faults


def _segment(line: str, number: int, count: int) -> tuple[str | None, list[int]] | None:
    """Return a character's label and components; None for a segment of another level."""
    try:
        words = shlex.split(line)
    except ValueError:
        words = []
    if len(words) > 1 and words[1].upper() != "CHARACTER":
        return None
    places: list[int] = []
    for part in words[2].split(",") if len(words) > 2 else ["nothing"]:
        match = COMPONENTS.fullmatch(part)
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (0, count)
        if not first <= last < count:
            raise RecordingError(
                f"row {number} is {line[:40]!r}, but a segment must be of whole components, from "
                f"0 to {count - 1}."
            )
        places += range(first, last + 1)
    return label_from(words[4] if len(words) > 4 else None), places


def _stroke(
    component: Component, columns: Sequence[str], said: dict[str, list[str]]
) -> FlatStroke | None:
    """Return a component as a stroke; None where the pen is up."""
    is_down, rows = component
    if not is_down or not rows:
        return None
    values, t = np.array(rows), None
    rate = _first_number(said, ".POINTS_PER_SECOND")
    if "T" in columns:
        t = values[:, columns.index("T")] / 1000
    elif rate is not None and 1 <= rate <= 1e5:
        t = values[:, -1] / rate
    force = np.maximum(values[:, columns.index("P")], 0.0) if "P" in columns else None
    xy = values[:, [columns.index("X"), columns.index("Y")]]
    wide, high = _metres(said, "X"), _metres(said, "Y")
    return FlatStroke(xy * [1.0, high / wide] if wide and high else xy, t, force)


def _metres(said: dict[str, list[str]], axis: str) -> float | None:
    """Return the metres in a unit of X or Y; None where the file does not say."""
    for unit, metres in (("MM", 0.001), ("INCH", 0.0254)):
        value = _first_number(said, f".{axis}_POINTS_PER_{unit}")
        if value is not None and value > 0:
            return metres / value
    return None


def _first_number(said: dict[str, list[str]], keyword: str) -> float | None:
    """Return the first number behind a keyword."""
    return finite_number(next(iter(said.get(keyword, [])), None))


FORMAT = Format("UNIPEN", (".dat",), has_unipen_keyword, read_unipen)
