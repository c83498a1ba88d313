"""Where things in a drawing are: lengths and shares, views within views, and transforms.

Lengths of the page are in mm, cm, in, pt, pc, q or px (96 to the inch); a share is one of the view that it is in.
"""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Matrix

from dmp_teach.errors import RecordingError
from dmp_teach.formats.svg.style import Look, Props
from dmp_teach.trajectory import Array

METRES = {"": 0.0254 / 96, "px": 0.0254 / 96, "in": 0.0254, "cm": 0.01, "mm": 0.001, "q": 0.00025}
METRES |= {"pt": 0.0254 / 72, "pc": 0.0254 / 6}
NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
LENGTH = re.compile(rf"({NUMBER}) ?([a-zA-Z]*|%)")
ACTION = r"(?:matrix|translate[XY]?|scale[XY]?|rotate|skewX|skewY)"
TRANSFORM = re.compile(rf"(?:[\s,]*{ACTION}\s*\((?:[0-9eE+\-.,\s]|px|deg|grad|rad|turn)*\))*[\s,]*")
ASPECT = re.compile(r"(?:defer\s+)?x(Min|Mid|Max)Y(Min|Mid|Max)(?:\s+(meet|slice))?")
SHARES = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
SIDES = {"left": 0.0, "top": 0.0, "center": 0.5, "right": 1.0, "bottom": 1.0}
LONGEST = 1000  # characters in a transform


@dataclass(frozen=True)
class View:
    """How large a view is, in the user's units; None where nobody knows.

    Args:
        x: Its left edge.
        y: Its upper edge.
        wide: How wide it is.
        high: How high.
    """

    x: float = 0.0
    y: float = 0.0
    wide: float | None = None
    high: float | None = None

    def across(self, name: str) -> float | None:
        """What a share of it is a share of, for a place, a size or a radius of this name."""
        if name in ("x", "x1", "x2", "cx", "rx", "width"):
            return self.wide
        if name in ("y", "y1", "y2", "cy", "ry", "height"):
            return self.high
        known = self.wide is not None and self.high is not None
        return math.hypot(self.wide, self.high) / math.sqrt(2) if known else None


def root_view(svg: Element) -> tuple[Array, View]:
    """From the units of the outermost `svg` to the page [m], y down: a matrix (3, 3), and its view."""
    width, height = (_length(svg, name) for name in ("width", "height"))
    box = _box(svg)
    if box is None:
        size = [None if each is None else each / METRES["px"] for each in (width, height)]
        return np.diag([METRES["px"], METRES["px"], 1.0]), View(0.0, 0.0, *size)
    scale = [
        None if size is None else size / extent
        for size, extent in ((width, box.wide), (height, box.high))
    ]
    known = [each for each in scale if each is not None] or [METRES["px"]]
    across, down = _scales(svg, known) if len(known) == 2 else known * 2
    return np.diag([across, down, 1.0]) @ moved(-box.x, -box.y), box


def inner_view(svg: Element, outer: View) -> tuple[Array, View]:
    """From the units of an `svg` within a drawing to those around it: a matrix (3, 3), and its view."""
    place = moved(*(coordinate(svg, {}, name, outer) or 0.0 for name in ("x", "y")))
    sizes = {"width": outer.wide, "height": outer.high}
    for name in ("width", "height"):
        size = coordinate(svg, {}, name, outer)
        if size is not None and not size > 0:
            raise RecordingError(
                f"{name} is {svg.get(name)[:60]!r}, but must be more than 0; delete what is empty."
            )
        sizes[name] = sizes[name] if size is None else size
    box = _box(svg)
    if box is None:
        return place, View(0.0, 0.0, *sizes.values())
    extents = [box.wide, box.high]
    scale = [
        size / extent
        for size, extent in zip(sizes.values(), extents, strict=True)
        if size is not None
    ]
    across, down = _scales(svg, scale) if len(scale) == 2 else (scale or [1.0]) * 2
    align = ASPECT.fullmatch((svg.get("preserveAspectRatio") or "").strip())
    shares = [SHARES[align[k]] if align else 0.5 for k in (1, 2)]
    left = [
        0.0 if size is None else share * (size - extent * by)
        for size, extent, share, by in zip(
            sizes.values(), extents, shares, (across, down), strict=True
        )
    ]
    return place @ moved(*left) @ np.diag([across, down, 1.0]) @ moved(-box.x, -box.y), box


def _box(svg: Element) -> View | None:
    """What `viewBox` says."""
    box = svg.get("viewBox")
    if box is None:
        return None
    numbers = box.replace(",", " ").split()
    good = len(numbers) == 4 and all(re.fullmatch(NUMBER, number) for number in numbers)
    x, y, wide, high = map(float, numbers) if good else (0.0, 0.0, 0.0, 0.0)
    if not (max(abs(x), abs(y)) < math.inf and 0 < wide < math.inf and 0 < high < math.inf):
        raise RecordingError(
            f"viewBox is {box[:60]!r}, but must be four numbers, the last two positive."
        )
    return View(x, y, wide, high)


def _scales(svg: Element, scale: list[float]) -> tuple[float, float]:
    """How much a view is enlarged across and down to fit, to fill (slice), or to be stretched (none)."""
    said = (svg.get("preserveAspectRatio") or "").strip()
    if said.startswith("none"):
        return scale[0], scale[1]
    match = ASPECT.fullmatch(said)
    one = max(scale) if match and match[3] == "slice" else min(scale)
    return one, one


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


def coordinate(element: Element, own: Props, name: str, view: View) -> float | None:
    """A coordinate, in the user's units; None where it is not said.

    Args:
        element: Whose.
        own: What its style says.
        name: Which, such as "cx".
        view: The view that it is in, for shares.
    """
    text = own.get(name, element.get(name))
    if text is None or text.strip() == "auto":
        return None
    return _units(text, name, view.across(name))


def _units(text: str, name: str, whole: float | None) -> float:
    """A length in the user's units, or a share of a whole."""
    match = LENGTH.fullmatch(text.strip())
    if match and match[2] == "%":
        if whole is None:
            raise RecordingError(
                f"{name} is {text[:60]!r}, a share of a drawing that says neither its viewBox nor its size; add one."
            )
        return float(match[1]) / 100 * whole
    if not match or match[2].lower() not in METRES:
        raise RecordingError(f"{name} is {text[:60]!r}, but must be a number.")
    return float(match[1]) * METRES[match[2].lower()] / METRES["px"]


def moved(x: float, y: float) -> Array:
    """A translation (3, 3)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def transform(look: Look, view: View) -> Array:
    """How an element is moved and turned (3, 3), in the units around it."""
    for name in ("translate", "rotate", "scale", "d"):
        if look.own.get(name, "none") != "none":
            raise RecordingError(
                f"has the style {name}, which is not followed here; apply it in your drawing program."
            )
    said = look.own.get("transform", "none")
    if said == "none":
        return np.eye(3)
    matrix, origin = _matrix(said), look.own.get("transform-origin")
    box = look.own.get("transform-box", "view-box")
    if box != "view-box":
        raise RecordingError(
            f"has transform-box {box[:40]!r}, which is not followed here; apply its transform."
        )
    if origin is None:
        return matrix
    x, y = _origin(origin, view)
    return moved(x, y) @ matrix @ moved(-x, -y)


def _origin(text: str, view: View) -> tuple[float, float]:
    """The point that a transform turns about."""
    words = text.lower().split()[:2]
    if (words and words[0] in ("top", "bottom")) or (
        len(words) == 2 and words[1] in ("left", "right")
    ):
        words.reverse()
    found = []
    for word, name in zip([*words, "center", "center"], "xy", strict=False):
        share = f"{100 * SIDES[word]}%" if word in SIDES else word
        found.append(_units(share, "transform-origin", view.across(name)))
    return found[0], found[1]


def _matrix(text: str) -> Array:
    """What a `transform` says (3, 3)."""
    numbers = [math.nan] * 6
    if len(text) < LONGEST and TRANSFORM.fullmatch(text):
        with suppress(ValueError, ArithmeticError, TypeError, IndexError):
            said = Matrix(text)
            numbers = [float(getattr(said, name)) for name in "abcdef"]
    if not np.isfinite(numbers).all():
        raise RecordingError(
            f"transform is {text[:60]!r}, which cannot be read; apply it in your drawing program."
        )
    a, b, c, d, e, f = numbers
    return np.array([[a, c, e], [b, d, f], [0.0, 0.0, 1.0]])
