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
from dmp_teach.formats.flat_ink import check_size, flat_recording, label_from, usual_scale
from dmp_teach.formats.hand_pace import at_hand_pace
from dmp_teach.formats.inkml.timing import on_one_clock
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.formats.safe_xml import finite_number
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array, Trajectory

KEYWORD = re.compile(rb"(?:^|[\r\n])\.(?:VERSION|COORD|PEN_DOWN|SEGMENT)\b")
COMPONENTS = re.compile(r"(\d{1,6})(?:-(\d{1,6}))?")
LARGEST_UNIPEN = 16_000_000  # [bytes]
MOST_UNIPEN_LINES = 200_000
LONGEST_UNIPEN_LINE = 1000  # [characters]
# A component: whether the pen is down, and its rows: the columns, and the points' counts.
Component = tuple[bool, list[list[float]]]


def has_unipen_keyword(data: bytes) -> bool:
    """Tell whether a file has one of UNIPEN's keywords."""
    return KEYWORD.search(data[:64_000]) is not None


@name_file
def read_unipen(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of a UNIPEN file.

    Raises:
        RecordingError: No ink in it, a point or a segment that cannot be, or far too many lines.
    """
    if not has_unipen_keyword(data):
        raise RecordingError(
            "has none of UNIPEN's keywords, such as .PEN_DOWN, so it is no UNIPEN file, whatever "
            "its name says. Save or export the ink as InkML, SVG or CSV."
        )
    if len(data) > LARGEST_UNIPEN:
        raise RecordingError(
            f"has {len(data) / 1e6:.0f} MB, but UNIPEN has at most {LARGEST_UNIPEN / 1e6:.0f}; "
            "cut it."
        )
    lines = [line[:LONGEST_UNIPEN_LINE] for line in data.decode("utf-8", "replace").splitlines()]
    if len(lines) > MOST_UNIPEN_LINES:
        raise RecordingError(f"has more than {MOST_UNIPEN_LINES} lines; cut it.")
    said = {line.split()[0]: line.split()[1:] for line in lines if line.startswith(".")}
    columns = [name.upper() for name in said.get(".COORD", ["X", "Y"])]
    if not {"X", "Y"} <= set(columns):
        raise RecordingError(f"has the columns {' '.join(columns)[:60]}, but must have X and Y.")
    components, segments = _components(lines, len(columns))
    letters = [(label, [components[k] for k in places]) for label, places in segments]
    strokes = [_strokes(part, columns, said) for _, part in letters or [(None, components)]]
    if not all(strokes):
        raise RecordingError("has a letter without a pen that was down, so there is no ink in it.")
    scale = _metres(said) or usual_scale([[xy for _, xy in letter] for letter in strokes])
    labels = [label for label, _ in letters] or [None]
    return tuple(
        _letter(letter, scale, label) for letter, label in zip(strokes, labels, strict=True)
    )


def _components(
    lines: Sequence[str], width: int
) -> tuple[list[Component], list[tuple[str | None, list[int]]]]:
    """Return all components, and each character with the numbers of its components."""
    components: list[Component] = []
    segments = []
    count = 0
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if words and words[0] in (".PEN_DOWN", ".PEN_UP"):
            components.append((words[0] == ".PEN_DOWN", []))
        elif words and words[0] == ".SEGMENT":
            segments.append((number, line))
        elif words and components and not words[0].startswith("."):
            values = [finite_number(word) for word in words]
            row = [value for value in values if value is not None]
            if len(row) < len(values) or len(row) != width:
                raise RecordingError(
                    f"row {number} is {line[:40]!r}, but a point must have {width} numbers."
                )
            components[-1][1].append([*row, float(count)])
            count += 1
    letters: list[tuple[str | None, list[int]]] = []
    total = 0
    for number, line in segments:
        letter = _segment(line, number, len(components))
        if letter is None:
            continue
        letters.append(letter)
        total += len(letter[1])
        if total > MOST_UNIPEN_LINES:
            raise RecordingError(
                f"has more than {MOST_UNIPEN_LINES} components in its segments; cut it."
            )
    return components, letters


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


def _strokes(
    components: Sequence[Component], columns: Sequence[str], said: dict[str, list[str]]
) -> list[tuple[Array | None, Array]]:
    """Return the times or None, and the points (K, 2), of every component with the pen down."""
    rate = finite_number(next(iter(said.get(".POINTS_PER_SECOND", [])), None))
    places = [columns.index("X"), columns.index("Y")]
    strokes: list[tuple[Array | None, Array]] = []
    for is_down, rows in components:
        if not is_down or not rows:
            continue
        values, t = np.array(rows), None
        if "T" in columns:
            t = values[:, columns.index("T")] / 1000
        elif rate is not None and 1 <= rate <= 1e5:
            t = values[:, -1] / rate
        strokes.append((t, values[:, places]))
    return strokes


def _metres(said: dict[str, list[str]]) -> float | None:
    """Return the metres in a unit of X; None where the file does not say."""
    for keyword, metres in ((".X_POINTS_PER_MM", 0.001), (".X_POINTS_PER_INCH", 0.0254)):
        value = finite_number(next(iter(said.get(keyword, [])), None))
        if value is not None and value > 0:
            return metres / value
    return None


def _letter(
    strokes: Sequence[tuple[Array | None, Array]], scale: float, label: str | None
) -> Recording:
    """Return one letter from its strokes."""
    with np.errstate(all="ignore"):
        points = [xy * scale for _, xy in strokes]
    check_size(points)
    times = [t for t, _ in strokes if t is not None]
    if len(times) < len(strokes):
        laid = at_hand_pace(points)
    else:
        clocked = on_one_clock(list(zip(times, points, strict=True)))
        laid = [Trajectory(t, xy) for t, xy in clocked]
    return flat_recording(laid, character=label)


FORMAT = Format("UNIPEN", (".dat",), has_unipen_keyword, read_unipen)
