"""Drawings in SVG: read as the way of a pen that a hand follows, and written for pen plotters.

Every `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and `ellipse` that is shown is read in the order of the
file, and each part of a path that begins with a move is a stroke. Lengths are those of the page: `width` and `height`
in mm, cm, in, pt, pc, q or px (96 to the inch), through `viewBox` and transforms. In SVG y points down; here it points
up. Nothing is fetched, no style sheet is followed, and clones (`use`) are refused.
"""

import math
import re
from collections.abc import Iterator
from contextlib import suppress
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Circle, Close, Ellipse, Line, Matrix, Move, Path, Rect

from dmp_teach.errors import RecordingError
from dmp_teach.ink.flat import check_size, flat_recording, label_of, millimetres, writer_of
from dmp_teach.ink.markup import local
from dmp_teach.ink.pace import in_time
from dmp_teach.ink.recording import Recording
from dmp_teach.trajectory import Array

NAMES = "http://www.w3.org/2000/svg"
METRES = {"": 0.0254 / 96, "px": 0.0254 / 96, "in": 0.0254, "cm": 0.01, "mm": 0.001, "q": 0.00025}
METRES |= {"pt": 0.0254 / 72, "pc": 0.0254 / 6}
PIXELS = np.diag([1 / METRES["px"], -1 / METRES["px"], 1.0])  # from the page [m], y up, to a user's units
NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
LENGTH = re.compile(rf"({NUMBER}) ?([a-zA-Z]*|%)")
WAY = re.compile(r"[MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*")
TRANSFORM = re.compile(r"(?:[\s,]*(?:matrix|translate|scale|rotate|skewX|skewY)\s*\([0-9eE+\-.,\s]*\))*[\s,]*")
GROUPS = {"svg", "g", "a", "switch"}
UNSEEN = {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "style", "script", "title", "desc"}
MOST = 100_000  # segments in a drawing
LONGEST = 1000  # characters in a transform
MOST_TEXT = 4_000_000  # characters that describe a path
POINTS = (8, 128)  # on one curve
MOST_POINTS = 60_000  # on all curves
BY = re.compile(r"(?:(.*) )?by (\S+)")


def read_svg(root: Element) -> tuple[Recording, ...]:
    """The one letter of a drawing, written at a hand's pace.

    Args:
        root: The file's root element.

    Raises:
        RecordingError: Nothing drawn, or a length, a transform or a path that cannot be read.
    """
    shapes = list(_shapes(root, None))
    curves = sum(len(path) for path, _ in shapes)
    if curves > MOST:
        raise RecordingError(f"draws {curves} segments, but a letter has at most {MOST}; simplify the drawing.")
    count = int(np.clip(MOST_POINTS / max(curves, 1), *POINTS))
    with np.errstate(all="ignore"):  # what is no number is refused below
        strokes = [points for path, matrix in shapes for points in _strokes(path, matrix, count)]
    if not strokes:
        raise RecordingError("draws nothing: there is no path in it. Convert text and objects to paths.")
    check_size(strokes)
    character, writer = _labels(root)
    origin, baseline = (
        millimetres(root.get(name), count) for name, count in (("data-origin", 2), ("data-baseline", 1))
    )
    if origin is not None:
        origin = origin * [1, -1]
    line = None if baseline is None or origin is None else float(baseline[0])
    return (flat_recording(in_time(strokes), None, origin, character=character, writer=writer, baseline=line),)


def _shapes(element: Element, matrix: Array | None) -> Iterator[tuple[Path, Array]]:
    """Every path that is shown, and the matrix (3, 3) that takes it to the page [m], y up; none for the root."""
    kind = local(element)
    style = element.get("style") or ""
    if kind in UNSEEN or element.get("display") == "none" or re.search(r"display\s*:\s*none", style):
        return
    if kind == "use":
        raise RecordingError("has a clone (use); unlink clones, or convert them to paths.")
    if kind == "svg":
        inside = matrix is not None
        place = _moved(_coordinate(element, "x"), _coordinate(element, "y")) @ PIXELS if inside else np.eye(3)
        matrix = (matrix if inside else np.eye(3)) @ place @ _view(element)
    matrix = matrix @ _transform(element.get("transform"))
    if kind in GROUPS:
        for child in element:
            yield from _shapes(child, matrix)
        return
    path = _path(element, kind)
    if path is not None:
        yield path, matrix


def _view(svg: Element) -> Array:
    """From the user's units in an `svg` element to metres, y up."""
    box = svg.get("viewBox")
    width, height = (_length(svg, name) for name in ("width", "height"))
    if box is None:
        return np.diag([METRES["px"], -METRES["px"], 1.0])
    numbers = box.replace(",", " ").split()
    good = len(numbers) == 4 and all(re.fullmatch(NUMBER, number) for number in numbers)
    x, y, wide, high = map(float, numbers) if good else (0.0, 0.0, 0.0, 0.0)
    if not (max(abs(x), abs(y)) < math.inf and 0 < wide < math.inf and 0 < high < math.inf):
        raise RecordingError(f"viewBox is {box[:60]!r}, but must be four numbers, the last two positive.")
    scale = [None if size is None else size / extent for size, extent in ((width, wide), (height, high))]
    known = [each for each in scale if each is not None] or [METRES["px"]]
    stretched = (svg.get("preserveAspectRatio") or "").strip().startswith("none") and len(known) == 2
    across, down = known if stretched else (min(known), min(known))
    return np.diag([across, -down, 1.0]) @ _moved(-x, -y)


def _length(element: Element, name: str) -> float | None:
    """A length of the page [m]; None where it is not said, or a share of the window."""
    text = element.get(name)
    match = LENGTH.fullmatch((text or "").strip())
    if text is None or text.strip() == "auto" or (match and match[2].lower() in ("%", "em", "ex")):
        return None
    if not match or match[2].lower() not in METRES or not 0 < float(match[1]) < math.inf:
        raise RecordingError(
            f"{name} is {text[:60]!r}, but must be a length such as '210mm', in {', '.join(METRES)[2:]}."
        )
    return float(match[1]) * METRES[match[2].lower()]


def _moved(x: float, y: float) -> Array:
    """A translation (3, 3)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def _transform(text: str | None) -> Array:
    """What a `transform` says (3, 3)."""
    if text is None:
        return np.eye(3)
    numbers = [math.nan] * 6
    if len(text) < LONGEST and TRANSFORM.fullmatch(text):
        with suppress(ValueError, ArithmeticError, TypeError, IndexError):
            said = Matrix(text)
            numbers = [float(getattr(said, name)) for name in "abcdef"]
    if not np.isfinite(numbers).all():
        raise RecordingError(f"transform is {text[:60]!r}, which cannot be read; apply it in your drawing program.")
    a, b, c, d, e, f = numbers
    return np.array([[a, c, e], [b, d, f], [0.0, 0.0, 1.0]])


def _path(element: Element, kind: str) -> Path | None:
    """An element as a path; None for what is no line."""
    if kind == "path":
        return _checked(element.get("d") or "")
    if kind in ("polyline", "polygon"):
        return _checked("M" + (element.get("points") or "").strip() + ("z" if kind == "polygon" else ""))
    if kind == "line":
        return _checked("M{} {} L{} {}".format(*(_coordinate(element, name) for name in ("x1", "y1", "x2", "y2"))))
    values = {name: _coordinate(element, name) for name in ("x", "y", "cx", "cy", "r", "rx", "ry", "width", "height")}
    if kind == "circle":
        return Path(Circle(*(values[name] for name in ("cx", "cy", "r"))))
    if kind == "ellipse":
        return Path(Ellipse(*(values[name] for name in ("cx", "cy", "rx", "ry"))))
    return Path(Rect(*(values[name] for name in ("x", "y", "width", "height")))) if kind == "rect" else None


def _coordinate(element: Element, name: str) -> float:
    """A coordinate in the user's units; 0 where it is not said."""
    match = LENGTH.fullmatch((element.get(name) or "0").strip())
    if not match or match[2].lower() not in METRES:
        raise RecordingError(f"{name} is {element.get(name)[:60]!r}, but must be a number.")
    return float(match[1]) * METRES[match[2].lower()] / METRES["px"]


def _checked(text: str) -> Path:
    """A path from its description."""
    if len(text) > MOST_TEXT:
        raise RecordingError(f"has a path of {len(text)} characters, but a letter needs fewer than {MOST_TEXT}.")
    try:
        if WAY.fullmatch(text) and (not text.strip() or text.strip()[0] in "Mm"):
            return Path(text)
        reason = "it must begin with M and have only the commands of a path"
    except (ValueError, ArithmeticError, TypeError, IndexError, AttributeError) as error:
        reason = str(error) or "a number is missing"
    raise RecordingError(f"the path {text[:40]!r} cannot be read: {reason}. Save the drawing again.")


def _strokes(path: Path, matrix: Array, count: int) -> Iterator[Array]:
    """The strokes of a path, points (K, 2) on the page [m]; `count` to a curve."""
    points: list[Array] = []
    for segment in [*path, Move((0, 0))]:
        if isinstance(segment, Move):
            if points:
                yield np.vstack(points) @ matrix[:2, :2].T + matrix[:2, 2]
            points = []
            continue
        end = [(segment.start.x, segment.start.y), (segment.end.x, segment.end.y)] if segment.end else []
        curved = not isinstance(segment, Line | Close)
        points.append(_along(segment, count) if curved else np.reshape(np.array(end, dtype=float), (-1, 2)))


def _along(curve: object, count: int) -> Array:
    """Points (count, 2) along a curve, its ends among them."""
    try:
        return np.array([(point.x, point.y) for point in map(curve.point, np.linspace(0, 1, count))], dtype=float)
    except (ValueError, ArithmeticError, TypeError):
        raise RecordingError(
            "draws a curve that cannot be followed: its numbers are too large. Mend the path."
        ) from None


def _labels(root: Element) -> tuple[str | None, str | None]:
    """Letter and pseudonym from a title such as "a by w01"; any other title stays out unless it is one sign."""
    title = next((child.text for child in root if local(child) == "title"), None)
    match = BY.fullmatch(label_of(title) or "")
    if match and (writer := writer_of(match[2])):
        return label_of(match[1]), writer
    label = label_of(title)
    return (label if label and len(label) == 1 else None), None
