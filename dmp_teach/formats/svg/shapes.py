"""The shapes of a drawing as ways of a pen: each as a path, and each path as points along its strokes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Circle, Close, Ellipse, Line, Move, Path, Rect

from dmp_teach.errors import RecordingError
from dmp_teach.formats.svg.frames import View, coordinate
from dmp_teach.formats.svg.style import Look
from dmp_teach.trajectory import Array

WAY = re.compile(r"[MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*")
MOST_TEXT = 4_000_000  # characters that describe a path
ROUND = ("x", "y", "cx", "cy", "r", "rx", "ry", "width", "height")


def path_of(element: Element, kind: str, look: Look, view: View) -> Path | None:
    """An element as a path; None for what is no line, or has no size."""
    if kind == "path":
        return _checked(element.get("d") or "")
    if kind in ("polyline", "polygon"):
        return _checked(
            "M" + (element.get("points") or "").strip() + ("z" if kind == "polygon" else "")
        )
    if kind == "line":
        ends = [coordinate(element, {}, name, view) or 0.0 for name in ("x1", "y1", "x2", "y2")]
        return _checked("M{} {} L{} {}".format(*ends))
    return _round(element, kind, look, view) if kind in ("circle", "ellipse", "rect") else None


def _round(element: Element, kind: str, look: Look, view: View) -> Path | None:
    """A rectangle, a circle or an ellipse as a path; None for one without a size."""
    said = {name: coordinate(element, look.own, name, view) for name in ROUND}
    value = {name: number or 0.0 for name, number in said.items()}
    rx = (
        value["rx"] if said["rx"] is not None else value["ry"]
    )  # one that is not said is like the other
    ry = value["ry"] if said["ry"] is not None else rx
    centre, corner, wide, high = (
        (value["cx"], value["cy"]),
        (value["x"], value["y"]),
        value["width"],
        value["height"],
    )
    if kind == "rect":
        turns = (min(rx, wide / 2), min(ry, high / 2)) if min(rx, ry) > 0 else (0.0, 0.0)
        return Path(Rect(*corner, wide, high, *turns)) if min(wide, high) > 0 else None
    if kind == "circle":
        return Path(Circle(*centre, value["r"])) if value["r"] > 0 else None
    return Path(Ellipse(*centre, rx, ry)) if min(rx, ry) > 0 else None


def _checked(text: str) -> Path:
    """A path from its description."""
    if len(text) > MOST_TEXT:
        raise RecordingError(
            f"has a path of {len(text)} characters, but a letter needs fewer than {MOST_TEXT}."
        )
    try:
        if WAY.fullmatch(text) and (not text.strip() or text.strip()[0] in "Mm"):
            return Path(text)
        reason = "it must begin with M and have only the commands of a path"
    except (ValueError, ArithmeticError, TypeError, IndexError, AttributeError) as error:
        reason = str(error) or "a number is missing"
    raise RecordingError(
        f"the path {text[:40]!r} cannot be read: {reason}. Save the drawing again."
    )


def strokes_of(path: Path, matrix: Array, count: int) -> Iterator[Array]:
    """The strokes of a path, points (K, 2) on the page [m]; `count` to a curve."""
    points: list[Array] = []
    for segment in [*path, Move((0, 0))]:
        if isinstance(segment, Move):
            if points:
                yield np.vstack(points) @ matrix[:2, :2].T + matrix[:2, 2]
            points = []
            continue
        end = (
            [(segment.start.x, segment.start.y), (segment.end.x, segment.end.y)]
            if segment.end
            else []
        )
        curved = not isinstance(segment, Line | Close)
        points.append(
            _along(segment, count) if curved else np.reshape(np.array(end, dtype=float), (-1, 2))
        )


def _along(curve: object, count: int) -> Array:
    """Points (count, 2) along a curve, its ends among them."""
    try:
        return np.array(
            [(point.x, point.y) for point in map(curve.point, np.linspace(0, 1, count))],
            dtype=float,
        )
    except (ValueError, ArithmeticError, TypeError):
        raise RecordingError(
            "draws a curve that cannot be followed: its numbers are too large. Mend the path."
        ) from None


def covers(points: Array, page: Array) -> bool:
    """Whether a way goes round a page: none of its points or of its pieces' middles lies on it, but it lies within.

    Args:
        points: Of a shape, shape (K, 2).
        page: The lower left and the upper right corner, shape (2, 2).
    """
    edge = 0.01 * np.ptp(page, axis=0)
    low, high = page[0] + edge, page[1] - edge
    middles = (points[1:] + points[:-1]) / 2
    on_it = any(((part > low) & (part < high)).all(axis=1).any() for part in (points, middles))
    return bool(
        not on_it and (points.min(axis=0) <= low).all() and (points.max(axis=0) >= high).all()
    )
