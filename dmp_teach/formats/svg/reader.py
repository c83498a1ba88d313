"""Drawings in SVG, read as the way of a pen that a hand follows.

Every `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and `ellipse` that draws a line which
one sees (`seen`) is read in the order of the file, and each part of a path that begins with a move
is a stroke, but for one that was drawn before or goes on where the one before it ends (`pieces`).
An open path of which the file says neither fill nor stroke is a line, too. Areas of a colour are no
way of a pen, but a small compact one beside lines is a dot. Clones and drawings within the drawing
are followed; masks are refused, and nothing is fetched. In SVG y points down; here it points up. A
hand's samples (`hand_pace`) cut a sharp bend of the drawing by up to 0.1 mm.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Close

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import (
    PIXELS,
    FlatLetter,
    FlatStroke,
    check_size,
    flat_recordings,
    label_from,
    labelled,
    pseudonym_from,
)
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.formats.svg.drawing import Shape, ShapeFinder
from dmp_teach.formats.svg.frames import has_unit
from dmp_teach.formats.svg.pieces import area_of, is_outline, joined, unrepeated
from dmp_teach.formats.svg.seen import WHY_UNSEEN, Outline, Painted, is_seen, look_at
from dmp_teach.formats.svg.shapes import path_strokes
from dmp_teach.formats.svg.writer import write_svg
from dmp_teach.ink import Recording
from dmp_teach.trajectory import Array, path_length

MOST_SEGMENTS = 100_000
MOST_LINES = 5000  # of strokes
CURVE_POINTS = (8, 128)  # the fewest and the most on one curve
MOST_CURVE_POINTS = 60_000  # on all of them
LARGEST_DOT = 1 / 3  # of the lines
ROUNDNESS = 0.6  # how round a dot is at least: 1 is a circle, pi / 4 a square
TITLE = re.compile(r"(?:(.*) )?by (\S+)")
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
    is_ours = root.get("data-origin") is not None
    with np.errstate(all="ignore"):  # what is no number is refused below
        strokes, notes = _strokes(root, is_ours)
    letter = FlatLetter([FlatStroke(xy) for xy in strokes], notes=tuple(notes))
    said = root.get("data-origin"), root.get("data-baseline")
    letter = labelled(letter, *_labels(root), *said)
    if letter.origin is not None:  # it stands in the file with y up
        letter = replace(letter, origin=letter.origin * [1, -1])
    return flat_recordings([letter])


def _strokes(root: Element, is_ours: bool) -> tuple[list[Array], list[str]]:
    """Return the strokes of a drawing, points (K, 2) each on the page [m], and what is doubtful."""
    finder = ShapeFinder(root)
    shapes = list(finder.shapes())
    segments = sum(len(shape.path) for shape in shapes)
    if segments > MOST_SEGMENTS:
        raise RecordingError(
            f"draws {segments} segments, but a letter has at most {MOST_SEGMENTS}; simplify the "
            "drawing."
        )
    count = int(np.clip(MOST_CURVE_POINTS / max(segments, 1), *CURVE_POINTS))
    painted = [each for shape in shapes for each in _painted(shape, count, finder.paper)]
    lines = [each for each in painted if each.area is None]
    if not lines:
        raise RecordingError(f"{_why_no_line(root, bool(painted))}. {DRAW_LINE}")
    ways = [way for each in lines for way in each.ways]
    if len(ways) > MOST_LINES:
        raise RecordingError(f"draws {len(ways)} lines, but a letter has at most {MOST_LINES}.")
    check_size(ways)
    strokes, notes = _seen(painted, finder.paper)
    notes += [f"Its {each} is no line, and left out." for each in sorted(finder.others)]
    if is_ours:
        return strokes, notes
    strokes, bends = joined(unrepeated(strokes))
    if bends:
        times = f"{bends} time{'s' * (bends > 1)}"
        notes.append(f"A line begins where the one before ends, {times}: the pen is lifted there.")
    if any(is_outline(each) for each in [*(line.ways for line in lines), ways]):
        notes.append(f"A line runs round a narrow area, as the outline of a letter. {DRAW_LINE}")
    if not has_unit(root):
        notes.append(PIXELS)
    return strokes, notes


def _painted(shape: Shape, count: int, paper: Array) -> Iterator[Painted]:
    """Yield the area and the line of a shape on a page of a colour (4,).

    A curve gets `count` points.
    """
    look, place = shape.look, shape.place
    closed = any(isinstance(segment, Close) for segment in shape.path)
    fill, stroke = look.fill, look.stroke
    if not look.said.keys() & {"fill", "stroke"} and not closed:
        fill, stroke = None, fill
    elif stroke is not None and fill is not None:
        if "fill" not in look.said:
            fill = None
        elif is_seen(fill, paper) and (closed or np.array_equal(fill, stroke)):
            stroke = None  # the edge of an area
    parts = [] if fill is stroke is None else path_strokes(shape.path, place.matrix, count)
    if fill is not None and parts:
        area = Outline(parts, look.said.get("fill-rule") == "evenodd")
        yield Painted(_dots(area), fill, place.clips, area=area)
    if stroke is not None and parts:
        width = look.width * float(np.sqrt(abs(np.linalg.det(place.matrix[:2, :2]))))
        yield Painted(parts, stroke, place.clips, width)


def _dots(area: Outline) -> list[Array]:
    """Return the middles of an area's round parts, each as the way of a pen that only taps."""
    dots = []
    for part in area.parts:
        middle = np.tile((part.min(axis=0) + part.max(axis=0)) / 2, (2, 1))
        is_round = 4 * np.pi * abs(area_of(part)) > ROUNDNESS * path_length(part) ** 2
        if is_round and area.holds(middle, 0.0).any():
            dots.append(middle)
    return dots


def _seen(painted: list[Painted], paper: Array) -> tuple[list[Array], list[str]]:
    """Return the strokes that one sees, points (K, 2) each, and what was left out."""
    seen, unseen, areas = look_at(painted, paper)
    ink = [way for way, each in seen if each.area is None]
    if not ink:
        reasons = " and ".join(WHY_UNSEEN[why] for why in unseen)
        raise RecordingError(f"draws only lines that one does not see: they are {reasons}.")
    largest = LARGEST_DOT * np.ptp(np.concatenate(ink), axis=0).max()
    kept = [(way, each.area) for way, each in seen if not each.area or each.area.size < largest]
    areas -= len({id(area) for _, area in kept if area})
    notes = [f"Left out, for one does not see it: what is {WHY_UNSEEN[why]}." for why in unseen]
    if areas > 0:
        notes.append(f"Left out, as no line: {areas} area{'s' * (areas > 1)} of a colour.")
    colours = len({each.colour.tobytes() for _, each in seen if each.area is None})
    if colours > 1:
        notes.append(f"Its lines of {colours} colours are one letter: delete those that are none.")
    return [way for way, _ in kept], notes


def _why_no_line(root: Element, has_areas: bool) -> str:
    """Return what a drawing without a line has instead."""
    tags = {local_tag(each) for each in root.iter()}
    if has_areas and "image" not in tags:
        return "has only areas of a colour: the outline of a letter is not the way of a pen"
    return next((NO_LINE[tag] for tag in NO_LINE if tag in tags), "draws nothing")


def _labels(root: Element) -> tuple[str | None, str | None]:
    """Return letter and writer: as we wrote them, or from a title of one sign or "a by w01"."""
    said = root.get("data-character"), root.get("data-writer")
    if said != (None, None):
        return said
    title = label_from(next((each.text for each in root if local_tag(each) == "title"), None))
    match = TITLE.fullmatch(title or "")
    if match and pseudonym_from(match[2]):
        return match[1], match[2]
    label = unicodedata.normalize("NFC", title or "")
    return (label if len(label) == 1 else None), None


FORMAT = Format("SVG", (".svg",), partial(has_root, tag="svg"), read_svg, write_svg)
