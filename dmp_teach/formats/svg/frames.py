"""Where things in a drawing are: lengths, shares of the page, and transforms.

Lengths are in mm, cm, in, pt, pc, q or px (96 to the inch); a share is one of the drawing's view.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Matrix

from dmp_teach.errors import RecordingError
from dmp_teach.trajectory import Array

UNITS = {"": 0.0254 / 96, "px": 0.0254 / 96, "in": 0.0254, "cm": 0.01, "mm": 0.001, "q": 0.00025}
UNITS |= {"pt": 0.0254 / 72, "pc": 0.0254 / 6}
PIXEL = UNITS["px"]
NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
LENGTH = re.compile(rf"({NUMBER}) ?([a-zA-Z]*|%)")
ACTION = r"(?:matrix|translate[XY]?|scale[XY]?|rotate|skewX|skewY)"
TRANSFORM = re.compile(rf"(?:[\s,]*{ACTION}\s*\((?:[0-9eE+\-.,\s]|px|deg|grad|rad|turn)*\))*[\s,]*")
LONGEST_TRANSFORM = 1000  # [characters]


@dataclass(frozen=True)
class View:
    """How large the view of a drawing is, in the user's units; None where the file says nothing.

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

    def whole(self, name: str) -> float | None:
        """Return what a share is a share of, for a place, a size or a radius of this name."""
        if name in ("x", "x1", "x2", "cx", "rx", "width"):
            return self.wide
        if name in ("y", "y1", "y2", "cy", "ry", "height"):
            return self.high
        if self.wide is None or self.high is None:
            return None
        return math.hypot(self.wide, self.high) / math.sqrt(2)


def root_view(svg: Element) -> tuple[Array, View]:
    """Return the matrix (3, 3) from a drawing's units to its page [m], y down, and its view."""
    width, height = _page_length(svg, "width"), _page_length(svg, "height")
    box = svg.get("viewBox")
    if box is None:
        sizes = [None if each is None else each / PIXEL for each in (width, height)]
        return np.diag([PIXEL, PIXEL, 1.0]), View(0.0, 0.0, *sizes)
    numbers = box.replace(",", " ").split()
    good = len(numbers) == 4 and all(re.fullmatch(NUMBER, number) for number in numbers)
    x, y, wide, high = map(float, numbers) if good else (0.0, 0.0, 0.0, 0.0)
    if not (max(abs(x), abs(y)) < math.inf and 0 < wide < math.inf and 0 < high < math.inf):
        raise RecordingError(
            f"viewBox is {box[:60]!r}, but must be four numbers, the last two positive."
        )
    across = None if width is None else width / wide
    down = None if height is None else height / high
    if across is None or down is None:
        across = down = across or down or PIXEL
    aspect = (svg.get("preserveAspectRatio") or "").strip()
    if not aspect.startswith("none"):
        across = down = max(across, down) if aspect.endswith("slice") else min(across, down)
    scale = np.diag([across, down, 1.0])
    return scale @ translation(-x, -y), View(x, y, wide, high)


def _page_length(svg: Element, name: str) -> float | None:
    """Return a length of the page [m]; None where it is not said, or a share of the window."""
    text = svg.get(name)
    match = LENGTH.fullmatch((text or "").strip())
    unit = match[2].lower() if match else ""
    if text is None or text.strip() == "auto" or unit in ("%", "em", "ex"):
        return None
    if not match or unit not in UNITS or not 0 < float(match[1]) < math.inf:
        raise RecordingError(
            f"{name} is {text[:60]!r}, but must be a length such as '210mm', in "
            f"{', '.join(UNITS)[2:]}."
        )
    return float(match[1]) * UNITS[unit]


def coordinate(element: Element, own: Mapping[str, str], name: str, view: View) -> float | None:
    """Return a coordinate, in the user's units; None where it is not said.

    Args:
        element: Whose.
        own: What its style says.
        name: Which, such as "cx".
        view: What shares are shares of.
    """
    text = own.get(name, element.get(name))
    if text is None or text.strip() == "auto":
        return None
    match, whole = LENGTH.fullmatch(text.strip()), view.whole(name)
    if not match or match[2].lower() not in (*UNITS, "%"):
        raise RecordingError(f"{name} is {text[:60]!r}, but must be a number.")
    if match[2] != "%":
        return float(match[1]) * UNITS[match[2].lower()] / PIXEL
    if whole is None:
        raise RecordingError(
            f"{name} is {text[:60]!r}, a share of a drawing that says neither its viewBox nor its "
            "size; add one."
        )
    return float(match[1]) / 100 * whole


def translation(x: float, y: float) -> Array:
    """Return a translation, shape (3, 3)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def transform_matrix(text: str) -> Array:
    """Return what a `transform` does, shape (3, 3)."""
    numbers = [math.nan] * 6
    if text == "none":
        return np.eye(3)
    if len(text) < LONGEST_TRANSFORM and TRANSFORM.fullmatch(text):
        with suppress(ValueError, ArithmeticError, TypeError, IndexError):
            said = Matrix(text)
            numbers = [float(getattr(said, name)) for name in "abcdef"]
    if not np.isfinite(numbers).all():
        raise RecordingError(
            f"transform is {text[:60]!r}, which cannot be read; apply it in your drawing program."
        )
    a, b, c, d, e, f = numbers
    return np.array([[a, c, e], [b, d, f], [0.0, 0.0, 1.0]])
