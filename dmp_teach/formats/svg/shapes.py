"""The shapes of a drawing as ways of a pen: each as a path, and each path as points of strokes."""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Circle, Ellipse, Linear, Move, Path, Rect, SimpleLine

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import local_tag
from dmp_teach.formats.svg.frames import coordinate
from dmp_teach.trajectory import Array

PATH_SIGNS = re.compile(r"\s*(?:[Mm][MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*)?")
LONGEST_PATH = 4_000_000  # [characters]
# What makes each, its coordinates, and those without which it is nothing.
SIZED_SHAPES = {
    "line": (SimpleLine, ("x1", "y1", "x2", "y2"), ()),
    "circle": (Circle, ("cx", "cy", "r"), ("r",)),
    "ellipse": (Ellipse, ("cx", "cy", "rx", "ry"), ("rx", "ry")),
    "rect": (Rect, ("x", "y", "width", "height", "rx", "ry"), ("width", "height")),
}
SHAPES = {"path", "polyline", "polygon", *SIZED_SHAPES}


def path_of_shape(element: Element, view: Array) -> Path | None:
    """Return one of `SHAPES` in a `view` (2,) as a path; None for one that has no size."""
    kind = local_tag(element)
    if kind not in SIZED_SHAPES:
        points = element.get("points") or ""
        ends = {"polyline": f"M{points}", "polygon": f"M{points}z"}
        return _parsed_path(ends.get(kind, element.get("d") or ""))
    make, names, sizes = SIZED_SHAPES[kind]
    values = {name: coordinate(element, name, view) for name in names}
    said = {name: value for name, value in values.items() if value is not None}
    if kind == "ellipse":  # a radius that is not said is like the other one
        said = {"rx": said.get("ry", 0.0), "ry": said.get("rx", 0.0)} | said
    return Path(make(said)) if all(said.get(name, 0.0) > 0 for name in sizes) else None


def _parsed_path(text: str) -> Path:
    """Return a path from its description."""
    if len(text) > LONGEST_PATH:
        raise RecordingError(
            f"has a path of {len(text)} characters, but a letter needs fewer than {LONGEST_PATH}."
        )
    reason = "it must begin with M and have only the commands of a path"
    try:
        if PATH_SIGNS.fullmatch(text):
            return Path(text)
    except (ValueError, ArithmeticError, TypeError, IndexError, AttributeError) as error:
        reason = str(error) or "a number is missing"
    raise RecordingError(
        f"the path {text[:40]!r} cannot be read: {reason}. Save the drawing again."
    )


def path_strokes(path: Path, matrix: Array, count: int) -> list[Array]:
    """Return the strokes of a path, points (K, 2) on the page [m].

    Args:
        path: In the units of its drawing.
        matrix: From there to the page, shape (3, 3).
        count: How many points a curve gets.
    """
    strokes: list[list[Array]] = []
    for segment in path:
        if isinstance(segment, Move) or not strokes:
            strokes.append([])
        if isinstance(segment, Move) or segment.end is None:
            continue
        shares = np.linspace(0, 1, 2 if isinstance(segment, Linear) else count)
        try:
            strokes[-1].append(np.asarray(segment.npoint(shares), float))
        except (ValueError, ArithmeticError, TypeError):
            raise RecordingError(
                "draws a curve that cannot be followed: its numbers are too large. Mend the path."
            ) from None
    return [np.vstack(each) @ matrix[:2, :2].T + matrix[:2, 2] for each in strokes if each]
