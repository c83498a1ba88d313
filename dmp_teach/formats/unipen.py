"""Digital ink of the UNIPEN project (Guyon et al. 1994): text with a keyword or a point in a line.

Components, from `.PEN_DOWN` or `.PEN_UP` to the next, are counted from 0. A `.SEGMENT CHARACTER`
is a letter; its delineation, such as `0-2,4` or `0:3-1:10`, is of components, or of points in them.
A file without any is one letter. Y points up. Times are those of the column T [ms], or the points'
count and rate, or else a hand's.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import FlatLetter, FlatStroke, flat_recordings, label_from
from dmp_teach.formats.plain_text import decode_text
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

KEYWORD = re.compile(rb"(?:^|[\r\n])\.(?:VERSION|COORD|PEN_DOWN|SEGMENT)\b")
POINT = r"(\d{1,6})(?::(\d{1,6}))?"
DELINEATION = re.compile(rf"{POINT}(?:-{POINT})?")
MOST_UNIPEN_LINES = 200_000
LONGEST_UNIPEN_LINE = 1000  # [characters]
LetterParts = tuple[str | None, list[tuple[int, slice]]]
"""A letter, and of which components, and which points of them, it is."""


def has_unipen_keyword(data: bytes) -> bool:
    """Tell whether a file has one of UNIPEN's keywords."""
    return KEYWORD.search(data[:64_000].replace(b"\0", b"")) is not None


def read_unipen(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a UNIPEN file.

    Raises:
        RecordingError: No ink in it, a point or a segment that cannot be, or far too many lines.
    """
    lines = [line[:LONGEST_UNIPEN_LINE] for line in decode_text(data).splitlines()]
    if len(lines) > MOST_UNIPEN_LINES:
        raise RecordingError(f"has more than {MOST_UNIPEN_LINES} lines; cut it.")
    said = {line.split()[0]: line.split()[1:] for line in lines if line.startswith(".")}
    columns = [name.upper() for name in said.get(".COORD", ["X", "Y"])]
    if not {"X", "Y"} <= set(columns):
        raise RecordingError(f"has the columns {' '.join(columns)[:60]}, but must have X and Y.")
    components, broken, faults = _components(lines, len(columns))
    segments: list[LetterParts] = []
    total = 0
    for number, line in enumerate(lines, start=1):
        if line.startswith(".SEGMENT"):
            try:
                segments.append(_segment(line, number, len(components)))
                total += len(segments[-1][1])
            except RecordingError as error:
                faults.append(str(error))
        if total > MOST_UNIPEN_LINES:
            raise RecordingError(
                f"has more than {MOST_UNIPEN_LINES} components in its segments; cut it."
            )
    segments = [each for each in segments if each[1]]
    if not segments and not faults:
        segments = [(None, [(k, slice(None)) for k in range(len(components))])]
    letters = [
        FlatLetter(
            [
                _stroke(rows, columns, said)
                for k, points in parts
                if len(rows := components[k][points])
            ],
            label,
        )
        for label, parts in segments
        if broken.isdisjoint(k for k, _ in parts)
    ]
    return flat_recordings(letters, _metres(said, "X"), faults)


def _components(lines: Sequence[str], width: int) -> tuple[list[Array], set[int], list[str]]:
    """Return the points of all components, empty where the pen is up, and what is wrong in which.

    A row has the columns, and the points' count.
    """
    components: list[list[list[float]]] = []
    broken, faults = set(), []
    count, is_down = 0, False
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if words and words[0] in (".PEN_DOWN", ".PEN_UP"):
            components.append([])
            is_down = words[0] == ".PEN_DOWN"
        elif words and components and not words[0].startswith("."):
            row = [value for word in words if (value := finite_number(word)) is not None]
            if len(words) != width or len(row) != width:
                faults.append(
                    f"row {number} is {line[:40]!r}, but a point must have {width} numbers."
                )
                broken.add(len(components) - 1)
                continue
            components[-1] += [[*row, float(count)]] if is_down else []
            count += 1
    return [np.reshape(rows, (-1, width + 1)) for rows in components], broken, faults


def _segment(line: str, number: int, count: int) -> LetterParts:
    """Return a character, without parts for a segment of another level."""
    try:
        words = shlex.split(line)
    except ValueError:
        words = []
    if len(words) > 1 and words[1].upper() != "CHARACTER":
        return None, []
    parts: list[tuple[int, slice]] = []
    for text in words[2].split(",") if len(words) > 2 else ["nothing"]:
        match = DELINEATION.fullmatch(text)
        a, i, b, j = match.groups() if match else (None,) * 4
        first, last = (int(a), int(b or a)) if a else (0, count)
        if not first <= last < count:
            raise RecordingError(
                f"row {number} is {line[:40]!r}, but a segment must be of components, from 0 to "
                f"{count - 1}, or of points in them, such as 0:3-1:10."
            )
        whole = [[0, None] for _ in range(first, last + 1)]
        whole[0][0], whole[-1][1] = int(i or 0), int(j) + 1 if j else None
        parts += [(first + k, slice(*ends)) for k, ends in enumerate(whole)]
    return label_from(words[4] if len(words) > 4 else None), parts


def _stroke(values: Array, columns: Sequence[str], said: dict[str, list[str]]) -> FlatStroke:
    """Return points (K, C) as a stroke."""
    t, rate = None, _first_number(said, ".POINTS_PER_SECOND")
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
