"""Drawings in SVG, read as the way of a pen that a hand follows.

Every `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and `ellipse` that draws a line is
read in the order of the file, and each part of a path that begins with a move is a stroke, but for
one that was drawn before. An open path of which the file says neither fill nor stroke is a line,
too. Areas of a colour are no way of a pen, but a small filled circle or ellipse beside lines is a
dot. Clones of shapes are followed; drawings within the drawing, clips and masks are refused, and
nothing is fetched. In SVG y points down; here it points up. A hand's samples (`hand_pace`) cut a
sharp bend of the drawing by up to 0.1 mm.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import partial
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Close, Path

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import (
    FlatLetter,
    FlatStroke,
    flat_recordings,
    label_from,
    lengths_in_mm,
    own_label,
    pseudonym_from,
)
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.formats.svg.frames import coordinate, page_matrix, transform_matrix, translation
from dmp_teach.formats.svg.look import Look, Styles
from dmp_teach.formats.svg.shapes import SHAPES, path_of_shape, path_strokes
from dmp_teach.formats.svg.writer import write_svg
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

# A path, its matrix (3, 3) to the page [m], y up, and whether it is the edge of a disc.
PlacedPath = tuple[Path, Array, bool]
GROUPS = {"svg", "g", "a", "switch"}
HREFS = ("href", "{http://www.w3.org/1999/xlink}href")
MOST_CLONES = 1000
DEEPEST_CLONE = 10  # clones of clones
MOST_SEGMENTS = 100_000
CURVE_POINTS = (8, 128)  # the fewest and the most on one curve
MOST_CURVE_POINTS = 60_000  # on all of them
LARGEST_DOT = 1 / 3  # of the lines
UPWARD = np.diag([1.0, -1.0, 1.0])
TITLE = re.compile(r"(?:(.*) )?by (\S+)")
UNLINK = "unlink clones, or convert them to paths."
DRAW_LINE = "Draw the middle of the letter with a line (a stroke, no fill), and save that."
NO_LINE = {
    "image": "holds a picture, and no line",
    "font": "is a font, and draws nothing",
    "text": "holds text of a font, whose letters are areas, and no line",
}


def read_svg(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the one letter of a drawing, written at a hand's pace.

    Raises:
        RecordingError: Nothing drawn, or a length, a transform, a style or a path that cannot be
            read, or that is not followed.
    """
    root = parse_xml(data, "svg", "a drawing")
    with np.errstate(all="ignore"):  # what is no number is refused below
        strokes = _Drawing(root).strokes()
    character, writer = _labels(root)
    origin = lengths_in_mm(root.get("data-origin"), 2)
    baseline = lengths_in_mm(root.get("data-baseline"), 1)
    letter = FlatLetter(
        [FlatStroke(xy) for xy in strokes],
        character,
        writer,
        None if origin is None else origin * [1, -1],
        None if baseline is None or origin is None else float(baseline[0]),
    )
    return flat_recordings([letter])


class _Drawing:
    """A drawing while its shapes are found."""

    def __init__(self, root: Element) -> None:
        self._styles, self._root = Styles(root), root
        self._named = {each.get("id"): each for each in root.iter()}
        self._clones = self._areas = 0

    def strokes(self) -> list[Array]:
        """Return the strokes, points (K, 2) each on the page [m], y up."""
        lines = list(self._lines(self._root, None, UPWARD @ page_matrix(self._root)))
        segments = sum(len(path) for path, _, _ in lines)
        if segments > MOST_SEGMENTS:
            raise RecordingError(
                f"draws {segments} segments, but a letter has at most {MOST_SEGMENTS}; simplify "
                "the drawing."
            )
        count = int(np.clip(MOST_CURVE_POINTS / max(segments, 1), *CURVE_POINTS))
        drawn: dict[bytes, tuple[Array, bool]] = {}
        for path, matrix, is_disc in lines:
            for points in path_strokes(path, matrix, count):
                drawn.setdefault(np.round(points, 6).tobytes(), (points, is_disc))
        ink = [points for points, is_disc in drawn.values() if not is_disc]
        if not ink:
            raise RecordingError(f"{self._why_no_line()}. {DRAW_LINE}")
        largest = LARGEST_DOT * np.ptp(np.concatenate(ink), axis=0).max()
        return [
            _middle(points) if is_disc else points
            for points, is_disc in drawn.values()
            if not is_disc or np.ptp(points, axis=0).max() < largest
        ]

    def _why_no_line(self) -> str:
        """Return what a drawing without a line has instead."""
        if self._areas:
            return "has only areas of a colour: the outline of a letter is not the way of a pen"
        tags = {local_tag(each) for each in self._root.iter()}
        return next((NO_LINE[tag] for tag in NO_LINE if tag in tags), "draws nothing")

    def _lines(
        self, element: Element, above: Look | None, matrix: Array, depth: int = 0
    ) -> Iterator[PlacedPath]:
        """Yield every line in an element, and every disc of a colour, which may be a dot.

        Args:
            element: Any.
            above: How what holds it looks; None for the root.
            matrix: From the units around it to the page, shape (3, 3).
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
            for child in element:
                yield from self._lines(child, look, matrix, depth)
        else:
            self._areas += look.is_area
            is_disc = look.is_area and kind in ("circle", "ellipse")
            may_be_line = look.is_line or look.is_unsaid
            path = path_of_shape(element) if may_be_line or is_disc else None
            if path is not None and (look.is_line or is_disc or _is_open(path)):
                yield path, matrix, is_disc

    def _clone(self, use: Element, look: Look, matrix: Array, depth: int) -> Iterator[PlacedPath]:
        """Yield the lines of a clone."""
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
        x, y = (coordinate(use, axis) or 0.0 for axis in "xy")
        yield from self._lines(target, look, matrix @ translation(x, y), depth)


def _is_open(path: Path) -> bool:
    """Tell whether no part of a path is closed."""
    return not any(isinstance(segment, Close) for segment in path)


def _middle(points: Array) -> Array:
    """Return the middle of points (K, 2) as the way of a pen that only taps, shape (2, 2)."""
    return np.tile((points.min(axis=0) + points.max(axis=0)) / 2, (2, 1))


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
