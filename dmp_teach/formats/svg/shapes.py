"""The shapes of a drawing as ways of a pen: each as a path, and each path as points of strokes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Circle, Close, Ellipse, Line, Move, Path, PathSegment, Rect

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import local_tag
from dmp_teach.formats.svg.frames import coordinate
from dmp_teach.trajectory import Array

PATH_SIGNS = re.compile(r"[MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*")
LONGEST_PATH = 4_000_000  # [characters]
SHAPES = ("path", "line", "polyline", "polygon", "circle", "ellipse", "rect")


def path_of_shape(element: Element, view: Array) -> Path | None:
    """Return one of `SHAPES` as a path; None for one that has no size.

    Args:
        element: The shape.
        view: How wide and high the view is that it is in, shape (2,).
    """
    kind = local_tag(element)
    if kind == "path":
        return _parsed_path(element.get("d") or "")
    if kind in ("polyline", "polygon"):
        end = "z" if kind == "polygon" else ""
        return _parsed_path("M" + (element.get("points") or "").strip() + end)

    def value(*names: str) -> tuple[float, ...]:
        return tuple(coordinate(element, name, view) or 0.0 for name in names)

    if kind == "line":
        return _parsed_path("M{} {} L{} {}".format(*value("x1", "y1", "x2", "y2")))
    if kind == "circle":
        return Path(Circle(*value("cx", "cy", "r"))) if value("r") > (0,) else None
    # A radius that is not said is like the other one.
    said = [coordinate(element, name, view) for name in ("rx", "ry")]
    rx, ry = (own if own is not None else other or 0.0 for own, other in (said, said[::-1]))
    if kind == "ellipse":
        return Path(Ellipse(*value("cx", "cy"), rx, ry)) if min(rx, ry) > 0 else None
    x, y, wide, high = value("x", "y", "width", "height")
    radii = (min(rx, wide / 2), min(ry, high / 2)) if min(rx, ry) > 0 else (0.0, 0.0)
    return Path(Rect(x, y, wide, high, *radii)) if min(wide, high) > 0 else None


def is_closed(path: Path) -> bool:
    """Tell whether a part of a path is closed."""
    return any(isinstance(segment, Close) for segment in path)


def _parsed_path(text: str) -> Path:
    """Return a path from its description."""
    if len(text) > LONGEST_PATH:
        raise RecordingError(
            f"has a path of {len(text)} characters, but a letter needs fewer than {LONGEST_PATH}."
        )
    try:
        if PATH_SIGNS.fullmatch(text) and (not text.strip() or text.strip()[0] in "Mm"):
            return Path(text)
        reason = "it must begin with M and have only the commands of a path"
    except (ValueError, ArithmeticError, TypeError, IndexError, AttributeError) as error:
        reason = str(error) or "a number is missing"
    raise RecordingError(
        f"the path {text[:40]!r} cannot be read: {reason}. Save the drawing again."
    )


def path_strokes(path: Path, matrix: Array, count: int) -> Iterator[Array]:
    """Yield the strokes of a path, points (K, 2) on the page [m].

    Args:
        path: In the units of its drawing.
        matrix: From there to the page, shape (3, 3).
        count: How many points a curve gets.
    """
    points: list[Array] = []
    for segment in [*path, Move((0, 0))]:
        if not isinstance(segment, Move):
            points.append(_segment_points(segment, count))
            continue
        if points:
            yield np.vstack(points) @ matrix[:2, :2].T + matrix[:2, 2]
        points = []


def _segment_points(segment: PathSegment, count: int) -> Array:
    """Return points along a segment, its ends among them, shape (K, 2)."""
    try:
        if isinstance(segment, Line | Close):
            ends = [segment.start, segment.end] if segment.end else []
        else:
            ends = [segment.point(share) for share in np.linspace(0, 1, count)]
        return np.array([(float(end.x), float(end.y)) for end in ends]).reshape(-1, 2)
    except (ValueError, ArithmeticError, TypeError):
        raise RecordingError(
            "draws a curve that cannot be followed: its numbers are too large. Mend the path."
        ) from None
