"""Drawings in SVG, read as the way of a pen that a hand follows.

Every `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and `ellipse` that is shown is read in
the order of the file, and each part of a path that begins with a move is a stroke; an area of a
colour that is as large as the page is its paper. Clones of shapes are followed; drawings within the
drawing, clips and masks are refused, and nothing is fetched. In SVG y points down; here it points
up. A hand's samples (`hand_pace`) cut a sharp bend of the drawing by up to 0.1 mm.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator
from functools import partial
from typing import NamedTuple
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Path

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import (
    check_size,
    flat_recording,
    label_from,
    lengths_in_mm,
    own_label,
    pseudonym_from,
)
from dmp_teach.formats.hand_pace import at_hand_pace
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.formats.svg.frames import View, coordinate, root_view, transform_matrix, translation
from dmp_teach.formats.svg.look import Look, Styles
from dmp_teach.formats.svg.shapes import SHAPES, covers_page, path_of_shape, path_strokes
from dmp_teach.formats.svg.writer import write_svg
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

GROUPS = {"svg", "g", "a", "switch"}
HREFS = ("href", "{http://www.w3.org/1999/xlink}href")
MOST_CLONES = 1000
DEEPEST_CLONE = 10  # clones of clones
MOST_SEGMENTS = 100_000
CURVE_POINTS = (8, 128)  # the fewest and the most on one curve
MOST_CURVE_POINTS = 60_000  # on all of them
UPWARD = np.diag([1.0, -1.0, 1.0])
TITLE = re.compile(r"(?:(.*) )?by (\S+)")
UNLINK = "unlink clones, or convert them to paths."


class Shape(NamedTuple):
    """A path, the matrix (3, 3) to the page [m], y up, and whether it may be paper."""

    path: Path
    matrix: Array
    is_area: bool


@name_file
def read_svg(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the one letter of a drawing, written at a hand's pace.

    Raises:
        RecordingError: Nothing drawn, or a length, a transform, a style or a path that cannot be
            read, or that is not followed.
    """
    root = parse_xml(data, "svg", "a drawing")
    with np.errstate(all="ignore"):  # what is no number is refused below
        strokes = _drawn_strokes(root)
    if not strokes:
        raise RecordingError(
            "draws nothing: there is no path in it. Convert text and objects to paths."
        )
    check_size(strokes)
    character, writer = _labels(root)
    origin = lengths_in_mm(root.get("data-origin"), 2)
    baseline = lengths_in_mm(root.get("data-baseline"), 1)
    letter = flat_recording(
        at_hand_pace(strokes),
        None,
        None if origin is None else origin * [1, -1],
        character=character,
        writer=writer,
        baseline=None if baseline is None or origin is None else float(baseline[0]),
    )
    return (letter,)


def _drawn_strokes(root: Element) -> list[Array]:
    """Return the strokes of a drawing, points (K, 2) each [m]."""
    matrix, view = root_view(root)
    matrix = UPWARD @ matrix
    shapes = list(_Drawing(root, view).shapes(root, None, matrix))
    segments = sum(len(shape.path) for shape in shapes)
    if segments > MOST_SEGMENTS:
        raise RecordingError(
            f"draws {segments} segments, but a letter has at most {MOST_SEGMENTS}; simplify the "
            "drawing."
        )
    count = int(np.clip(MOST_CURVE_POINTS / max(segments, 1), *CURVE_POINTS))
    page = _page_corners(matrix, view)
    strokes: list[Array] = []
    for shape in shapes:
        part = list(path_strokes(shape.path, shape.matrix, count))
        is_paper = shape.is_area and page is not None and covers_page(part, page)
        strokes += [] if is_paper else part
    return strokes


class _Drawing:
    """A drawing while its shapes are found."""

    def __init__(self, root: Element, view: View) -> None:
        self._styles, self._view = Styles(root), view
        self._named = {each.get("id"): each for each in root.iter()}
        self._root, self._clones = root, 0

    def shapes(
        self, element: Element, above: Look | None, matrix: Array, depth: int = 0
    ) -> Iterator[Shape]:
        """Yield every shape that is shown in an element.

        Args:
            element: Any.
            above: How what holds it looks; None for the root.
            matrix: From the units around it to the page [m], y up, shape (3, 3).
            depth: How many clones it is in.
        """
        kind = local_tag(element)
        if kind not in GROUPS and kind not in SHAPES and kind != "use":
            return
        look = self._styles.look(element, above)
        if look.is_gone:
            return
        look.check_followed()
        if kind == "svg" and element is not self._root:
            raise RecordingError(
                "has a drawing within the drawing (svg), which is not followed here; ungroup it."
            )
        matrix = matrix @ transform_matrix(look.own.get("transform", "none"))
        if kind == "use":
            yield from self._clone(element, look, matrix, depth + 1)
        elif kind in GROUPS:
            for child in _shown_part(element) if kind == "switch" else element:
                yield from self.shapes(child, look, matrix, depth)
        elif look.is_seen:
            path = path_of_shape(element, look.own, self._view)
            if path is not None:
                yield Shape(path, matrix, look.is_area)

    def _clone(self, use: Element, look: Look, matrix: Array, depth: int) -> Iterator[Shape]:
        """Yield the shapes of a clone."""
        name = next((text for href in HREFS if (text := use.get(href))), "")
        target = self._named.get(name.removeprefix("#")) if name.startswith("#") else None
        self._clones += 1
        if target is None or local_tag(target) in ("svg", "symbol"):
            raise RecordingError(f"has a clone (use) of {name[:40]!r}, not of a shape; {UNLINK}")
        if self._clones > MOST_CLONES or depth > DEEPEST_CLONE:
            raise RecordingError(
                f"has more than {MOST_CLONES} clones (use), or clones of clones of themselves; "
                f"{UNLINK}"
            )
        x, y = (coordinate(use, look.own, axis, self._view) or 0.0 for axis in "xy")
        yield from self.shapes(target, look, matrix @ translation(x, y), depth)


def _shown_part(switch: Element) -> Iterable[Element]:
    """Return the one part of a `switch` that is shown: one for no extension, rather no language."""
    parts = [each for each in switch if not (each.get("requiredExtensions") or "").strip()]
    return sorted(parts, key=lambda each: each.get("systemLanguage") is not None)[:1]


def _page_corners(matrix: Array, view: View) -> Array | None:
    """Return the page's lower left and upper right corner (2, 2) [m]; None if unknown."""
    if view.wide is None or view.high is None:
        return None
    corners = [(view.x, view.y, 1.0), (view.x + view.wide, view.y + view.high, 1.0)]
    placed = (np.array(corners) @ matrix.T)[:, :2]
    return np.array([placed.min(axis=0), placed.max(axis=0)])


def _labels(root: Element) -> tuple[str | None, str | None]:
    """Return letter and pseudonym: as we wrote them, or from a title of one sign or "a by w01"."""
    said = root.get("data-character"), root.get("data-writer")
    if said != (None, None):
        return own_label(said[0]), pseudonym_from(said[1])
    title = label_from(next((each.text for each in root if local_tag(each) == "title"), None))
    match = TITLE.fullmatch(title or "")
    if match and (writer := pseudonym_from(match[2])):
        return label_from(match[1]), writer
    label = unicodedata.normalize("NFC", title or "")
    return (label if len(label) == 1 else None), None


FORMAT = Format("SVG", (".svg",), partial(has_root, tag="svg"), read_svg, write_svg)
