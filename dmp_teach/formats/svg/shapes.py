"""The shapes of a drawing as ways of a pen: each as a path, and each path as points of strokes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Circle, Close, Ellipse, Line, Move, Path, PathSegment, Rect

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import local_tag
from dmp_teach.formats.svg.frames import View, coordinate
from dmp_teach.trajectory import Array

PATH_SIGNS = re.compile(r"[MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*")
LONGEST_PATH = 4_000_000  # [characters]
SHAPES = ("path", "line", "polyline", "polygon", "circle", "ellipse", "rect")
ROUND_NAMES = ("x", "y", "cx", "cy", "r", "rx", "ry", "width", "height")


def path_of_shape(element: Element, own: Mapping[str, str], view: View) -> Path | None:
    """Return an element as a path; None for one that has no size.

    Args:
        element: One of `SHAPES`.
        own: What its style says.
        view: What shares are shares of.
    """
    kind = local_tag(element)
    if kind == "path":
        return _parsed_path(element.get("d") or "")
    if kind in ("polyline", "polygon"):
        end = "z" if kind == "polygon" else ""
        return _parsed_path("M" + (element.get("points") or "").strip() + end)
    if kind == "line":
        ends = [coordinate(element, {}, name, view) or 0.0 for name in ("x1", "y1", "x2", "y2")]
        return _parsed_path("M{} {} L{} {}".format(*ends))
    said = {name: coordinate(element, own, name, view) for name in ROUND_NAMES}
    return _round_path(kind, said)


def _round_path(kind: str, said: Mapping[str, float | None]) -> Path | None:
    """Return a rectangle, a circle or an ellipse as a path; None for one without a size."""
    value = {name: number or 0.0 for name, number in said.items()}
    # A radius that is not said is like the other one.
    rx = value["rx"] if said["rx"] is not None else value["ry"]
    ry = value["ry"] if said["ry"] is not None else rx
    if kind == "rect":
        wide, high = value["width"], value["height"]
        radii = (min(rx, wide / 2), min(ry, high / 2)) if min(rx, ry) > 0 else (0.0, 0.0)
        corner = value["x"], value["y"]
        return Path(Rect(*corner, wide, high, *radii)) if min(wide, high) > 0 else None
    centre = value["cx"], value["cy"]
    if kind == "circle":
        return Path(Circle(*centre, value["r"])) if value["r"] > 0 else None
    return Path(Ellipse(*centre, rx, ry)) if min(rx, ry) > 0 else None


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


def covers_page(strokes: Sequence[Array], page: Array) -> bool:
    """Tell whether a shape goes round a page: none of its points or middles lies on the page.

    Args:
        strokes: Of the shape, points (K, 2) each.
        page: The lower left and the upper right corner, shape (2, 2).
    """
    if not strokes:
        return False
    points = np.concatenate(strokes)
    edge = 0.01 * np.ptp(page, axis=0)
    low, high = page[0] + edge, page[1] - edge
    for part in (points, (points[1:] + points[:-1]) / 2):
        if ((part > low) & (part < high)).all(axis=1).any():
            return False
    return bool((points.min(axis=0) <= low).all() and (points.max(axis=0) >= high).all())
