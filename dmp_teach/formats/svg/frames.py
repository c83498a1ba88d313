"""Where things in a drawing are: lengths in mm, cm, in, pt, pc, q or px, and transforms."""

from __future__ import annotations

import math
import re
from contextlib import suppress
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


def page_matrix(svg: Element) -> Array:
    """Return the matrix (3, 3) from a drawing's units to its page [m], y down."""
    width, height = _page_length(svg, "width"), _page_length(svg, "height")
    box = svg.get("viewBox")
    if box is None:
        return np.diag([PIXEL, PIXEL, 1.0])
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
    if not (svg.get("preserveAspectRatio") or "").strip().startswith("none"):
        across = down = min(across, down)
    return np.diag([across, down, 1.0]) @ translation(-x, -y)


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


def coordinate(element: Element, name: str) -> float | None:
    """Return an element's coordinate such as "cx", in the user's units; None where it has none."""
    text = element.get(name)
    if text is None or text.strip() == "auto":
        return None
    match = LENGTH.fullmatch(text.strip())
    if not match or match[2].lower() not in UNITS:
        raise RecordingError(f"{name} is {text[:60]!r}, but must be a number.")
    return float(match[1]) * UNITS[match[2].lower()] / PIXEL


def translation(x: float, y: float) -> Array:
    """Return a translation, shape (3, 3)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def transform_matrix(text: str) -> Array:
    """Return what a `transform` does, shape (3, 3)."""
    if text == "none":
        return np.eye(3)
    numbers = [math.nan] * 6
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
