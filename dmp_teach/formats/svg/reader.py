"""Drawings in SVG: read as the way of a pen that a hand follows, and written for pen plotters.

Every `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and `ellipse` that is shown is read in the order of the
file, and each part of a path that begins with a move is a stroke; an area of a colour that is as large as the page is
its paper. Lengths are those of the page, through views (`svg_frames`) and styles (`svg_style`). In SVG y points down;
here it points up. A hand's samples (`pace`) cut a sharp bend of the drawing by up to 0.1 mm. Nothing is fetched, and
clones (`use`) are refused.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import partial
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
from dmp_teach.formats.hand_pace import in_time
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.formats.svg.frames import View, inner_view, root_view, transform
from dmp_teach.formats.svg.shapes import covers, path_of, strokes_of
from dmp_teach.formats.svg.style import Look, Styles
from dmp_teach.formats.svg.writer import write_svg
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array

NAMES = "http://www.w3.org/2000/svg"
GROUPS = {"svg", "g", "a", "switch"}
UNSEEN = {
    "defs",
    "symbol",
    "clipPath",
    "mask",
    "pattern",
    "marker",
    "metadata",
    "style",
    "script",
    "title",
    "desc",
}
MOST = 100_000  # segments in a drawing
POINTS = (8, 128)  # on one curve
MOST_POINTS = 60_000  # on all curves
UP = np.diag([1.0, -1.0, 1.0])
BY = re.compile(r"(?:(.*) )?by (\S+)")
Shape = tuple[
    Path, Array, bool
]  # a path, the matrix (3, 3) to the page [m], y up, and whether it may be paper


@name_file
def read_svg(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the one letter of a drawing, written at a hand's pace.

    Raises:
        RecordingError: Nothing drawn, or a length, a transform, a style or a path that cannot be
            read.
    """
    root = parse_xml(data, "svg", "a drawing")
    with np.errstate(all="ignore"):  # what is no number is refused below
        strokes = _drawn(root)
    if not strokes:
        raise RecordingError(
            "draws nothing: there is no path in it. Convert text and objects to paths."
        )
    check_size(strokes)
    character, writer = _labels(root)
    origin, baseline = (
        lengths_in_mm(root.get(name), count)
        for name, count in (("data-origin", 2), ("data-baseline", 1))
    )
    if origin is not None:
        origin = origin * [1, -1]
    line = None if baseline is None or origin is None else float(baseline[0])
    return (
        flat_recording(
            in_time(strokes), None, origin, character=character, writer=writer, baseline=line
        ),
    )


def _drawn(root: Element) -> list[Array]:
    """The strokes of a drawing, points (K, 2) each [m]."""
    matrix, view = root_view(root)
    shapes = list(_shapes(root, Styles(root), None, UP, view))
    curves = sum(len(path) for path, _, _ in shapes)
    if curves > MOST:
        raise RecordingError(
            f"draws {curves} segments, but a letter has at most {MOST}; simplify the drawing."
        )
    count = int(np.clip(MOST_POINTS / max(curves, 1), *POINTS))
    page = _page(UP @ matrix, view)
    drawn = [(list(strokes_of(path, matrix, count)), flat) for path, matrix, flat in shapes]
    return [
        points for part, flat in drawn if not (flat and _is_paper(part, page)) for points in part
    ]


def _shapes(
    element: Element, styles: Styles, above: Look | None, matrix: Array, view: View
) -> Iterator[Shape]:
    """Every path that is shown; `matrix` takes the units around the element to the page [m], y up."""
    kind = local_tag(element)
    if kind in UNSEEN:
        return
    look = styles.look(element, above)
    if look.is_gone:
        return
    if kind == "use":
        raise RecordingError("has a clone (use); unlink clones, or convert them to paths.")
    if above is None:
        matrix = matrix @ root_view(element)[0]
    matrix = matrix @ transform(look, view)
    if kind == "svg" and above is not None:
        inner, view = inner_view(element, view)
        matrix = matrix @ inner
    if kind in GROUPS:
        for child in _chosen(element) if kind == "switch" else element:
            yield from _shapes(child, styles, look, matrix, view)
    elif look.is_seen and (path := path_of(element, kind, look, view)) is not None:
        yield path, matrix, look.is_paper


def _chosen(switch: Element) -> list[Element]:
    """The one part of a `switch` that is shown: the first that asks for no extension, and rather for no language."""
    parts = [
        each
        for each in switch
        if local_tag(each) and not (each.get("requiredExtensions") or "").strip()
    ]
    return sorted(parts, key=lambda each: each.get("systemLanguage") is not None)[:1]


def _page(matrix: Array, view: View) -> Array | None:
    """The lower left and upper right corner of the page, shape (2, 2) [m]; None where nobody knows."""
    if view.wide is None or view.high is None:
        return None
    corners = (
        np.array([(view.x, view.y, 1.0), (view.x + view.wide, view.y + view.high, 1.0)]) @ matrix.T
    )
    return np.array([corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)])


def _is_paper(strokes: list[Array], page: Array | None) -> bool:
    """Whether an area of a colour is as large as the page."""
    return page is not None and bool(strokes) and covers(np.concatenate(strokes), page)


def _labels(root: Element) -> tuple[str | None, str | None]:
    """Letter and pseudonym: as we wrote them, or from a title such as "a by w01"; any longer title stays out."""
    said = root.get("data-character"), root.get("data-writer")
    if said != (None, None):
        return own_label(said[0]), pseudonym_from(said[1])
    title = next((child.text for child in root if local_tag(child) == "title"), None)
    match = BY.fullmatch(label_from(title) or "")
    if match and (writer := pseudonym_from(match[2])):
        return label_from(match[1]), writer
    label = unicodedata.normalize("NFC", label_from(title) or "")
    return (label if len(label) == 1 else None), None


FORMAT = Format("SVG", (".svg",), partial(has_root, tag="svg"), read_svg, write_svg)
