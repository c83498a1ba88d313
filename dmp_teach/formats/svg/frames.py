"""Where things in a drawing are: lengths in mm, cm, in, pt, pc, q or px, views and transforms."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Matrix

from dmp_teach.errors import RecordingError
from dmp_teach.formats.units import METRES, PIXEL
from dmp_teach.trajectory import Array

UNITS = {"in", "cm", "mm", "q", "pt", "pc"}  # that all programs agree about
USUAL_VIEW = 1000.0  # how large a view is that nothing says [px]
NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
LENGTH = re.compile(rf"({NUMBER}) ?([a-zA-Z]*|%)")
ACTION = r"(?:matrix|translate[XY]?|scale[XY]?|rotate|skewX|skewY)"
TRANSFORM = re.compile(rf"(?:[\s,]*{ACTION}\s*\((?:[0-9eE+\-.,\s]|px|deg|grad|rad|turn)*\))*[\s,]*")
LONGEST_TRANSFORM = 1000  # [characters]


def length(text: str | None, whole: float) -> float | None:
    """Return a length in the user's units, of which % is a share of `whole`; None for no length."""
    match = LENGTH.fullmatch((text or "").strip())
    unit = match[2].lower() or "px" if match else ""
    if match is None or unit not in (*UNITS, "px", "%"):
        return None
    return float(match[1]) * (whole / 100 if unit == "%" else METRES[unit] / PIXEL)


def coordinate(element: Element, name: str, view: Array) -> float | None:
    """Return an element's coordinate such as "cx" in a `view` (2,); None where it has none."""
    text = element.get(name)
    if text is None or text.strip() == "auto":
        return None
    wide, high = view
    whole = high if "y" in name or name == "height" else wide
    value = length(text, math.hypot(wide, high) / math.sqrt(2) if name == "r" else whole)
    if value is None:
        raise RecordingError(f"{name} is {text[:60]!r}, but must be a number.")
    return value


def page_view(svg: Element) -> tuple[Array, Array, Array | None]:
    """Return where a drawing is on its page.

    Returns:
        The matrix (3, 3) from its units to the page [m], y down; how wide and high the view is in
        its units, shape (2,); and how wide and high the page is [m], None where nothing says it.
    """
    said = [_page_length(svg, "width"), _page_length(svg, "height")]
    box = view_box(svg)
    if box is None:
        view = np.array([USUAL_VIEW if each is None else each / PIXEL for each in said])
        return np.diag([PIXEL, PIXEL, 1.0]), view, None if None in said else PIXEL * view
    both = list(zip(said, box[2:], strict=True))
    scale = next((each / whole for each, whole in both if each is not None), PIXEL)
    page = np.array([scale * whole if each is None else each for each, whole in both])
    return fitted(svg, box, page), box[2:], page


def view_box(element: Element) -> Array | None:
    """Return left, top, width and height of an element's view, shape (4,); None where not said."""
    box = element.get("viewBox")
    if box is None:
        return None
    numbers = np.full(4, np.nan)
    with suppress(ValueError):
        numbers[:] = [float(word) for word in box.replace(",", " ").split()]
    if not np.isfinite(numbers).all() or not (numbers[2:] > 0).all():
        raise RecordingError(
            f"viewBox is {box[:60]!r}, but must be four numbers, the last two positive."
        )
    return numbers


def fitted(element: Element, box: Array, size: Array) -> Array:
    """Return the matrix (3, 3) that fits the view `box` of an element into its size (2,)."""
    align, *how = (element.get("preserveAspectRatio") or "").split() or ["xMidYMid"]
    scale = size / box[2:]
    if align != "none":
        scale = np.full(2, scale.max() if "slice" in how else scale.min())
    ends = {"Min": 0.0, "Max": 1.0}
    free = (size - scale * box[2:]) * [ends.get(align[1:4], 0.5), ends.get(align[5:8], 0.5)]
    return translation(*free) @ np.diag([*scale, 1.0]) @ translation(-box[0], -box[1])


def _page_length(svg: Element, name: str) -> float | None:
    """Return a length of the page [m]; None where it is not said, or a share of the window."""
    text = svg.get(name, "auto").strip()
    if text == "auto" or text.endswith(("%", "em", "ex")):
        return None
    value = length(text, math.nan) or 0.0
    if not 0 < value < math.inf:
        raise RecordingError(
            f"{name} is {text[:60]!r}, but must be a length such as '210mm', in px, "
            f"{', '.join(sorted(UNITS))}."
        )
    return value * PIXEL


def has_unit(svg: Element) -> bool:
    """Tell whether a drawing says how large it is in a unit that all programs agree about."""
    sizes = [(svg.get(name) or "").strip() for name in ("width", "height")]
    return any(size.endswith(tuple(UNITS)) for size in sizes)


def translation(x: float, y: float) -> Array:
    """Return a translation, shape (3, 3)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


def transform_matrix(text: str | None) -> Array:
    """Return what a `transform` does, shape (3, 3)."""
    if text is None or text == "none":
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
