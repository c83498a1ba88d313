"""How the shapes of a drawing look, from attributes, `style` and plain style sheets.

A sheet may select by element, class, element and class, or id; a rule that selects otherwise is
refused where it says how something looks.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Color

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag
from dmp_teach.formats.svg.frames import length
from dmp_teach.trajectory import Array

INHERITED = {"visibility", "color", "stroke", "stroke-width", "stroke-opacity"}
INHERITED |= {"fill", "fill-opacity", "fill-rule", "clip-rule"}
NOT_FOLLOWED = {"mask", "mask-image", "-webkit-mask", "-webkit-mask-image"}
NOT_FOLLOWED |= {"transform-origin", "transform-box", "translate", "rotate", "scale"}
PROPERTIES = {"display", "opacity", "transform", "clip-path", "overflow", *INHERITED, *NOT_FOLLOWED}
PROPERTIES |= {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height", "d"}
PROPERTIES |= {"background", "background-color"}
SELECTOR = re.compile(r"\*|:root|[A-Za-z][\w-]*|#[\w-]+|(?:[A-Za-z][\w-]*)?\.[\w-]+")
NESTED = re.compile(r"\{[^{}]*\{")
LIGHT_OF_TWO = re.compile(r"light-dark\(\s*([^(),]+(?:\([^()]*\))?)\s*,.*", re.DOTALL)
COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
STYLE_CURE = "give its elements these styles themselves, or delete what is hidden."
Properties = dict[str, str]


@dataclass(frozen=True)
class Look:
    """How an element looks, as far as it decides whether there is ink.

    Args:
        said: What it and all that it is in say, of properties that are handed down.
        opacity: The share of it that is seen, with all that it is in; 0 where it is not shown.
    """

    said: Properties
    opacity: float

    def within(self, element: Element) -> Look:
        """Return how an element looks in what looks so."""
        own = {name: text.strip().lower() for name, text in element.items() if name in INHERITED}
        is_gone = element.get("display") == "none"
        return Look(
            self.said | own, 0.0 if is_gone else self.opacity * share(element.get("opacity"))
        )

    @property
    def fill(self) -> Array | None:
        """Red, green, blue and opacity of its area, shape (4,); None for no area."""
        return self._paint("fill", "black")

    @property
    def stroke(self) -> Array | None:
        """Red, green, blue and opacity of its line, shape (4,); None for no line."""
        return self._paint("stroke", "none") if self.width > 0 else None

    @property
    def width(self) -> float:
        """How wide its line is, in the user's units."""
        said = length(self.said.get("stroke-width"), 100.0)
        return 1.0 if said is None else said

    def _paint(self, name: str, usual: str) -> Array | None:
        """Return the colour of a stroke or a fill; None where nobody sees it."""
        text = self.said.get(name, usual)
        text = self.said.get("color", "black") if text == "currentcolor" else text
        if text == "none" or self.said.get("visibility") in ("hidden", "collapse"):
            return None
        paint = colour(text)
        paint[3] *= self.opacity * share(self.said.get(f"{name}-opacity"))
        return paint if paint[3] > 0 else None


def apply_styles(root: Element) -> None:
    """Write what styles say of each element of a drawing into its attributes."""
    rules: dict[str, tuple[int, Properties]] = {}
    for sheet in root.iter():
        if local_tag(sheet) == "style" and sheet.get("media", "all") in ("", "all", "screen"):
            _read_sheet(COMMENT.sub(" ", "".join(sheet.itertext())), rules)

    def strength(name: str) -> tuple[bool, bool, bool, int]:
        return name[0] == "#", "." in name, name[0] not in ".*", rules[name][0]

    for element in root.iter():
        tag, classes = local_tag(element), (element.get("class") or "").split()
        names = {"*", tag, f"#{element.get('id')}", ":root" if element is root else tag}
        names |= {f"{before}.{name}" for name in classes for before in ("", tag)}
        said = {name: text for name, text in element.items() if name in PROPERTIES}
        for name in sorted(names & rules.keys(), key=strength):
            said |= rules[name][1]
        said |= _declarations(COMMENT.sub(" ", element.get("style") or ""))
        said |= {name[1:]: text for name, text in said.items() if name[0] == "!"}
        for name, text in said.items():
            element.set(name, text.strip())
            if text.strip() == "inherit":
                del element.attrib[name]


def check_followed(element: Element) -> None:
    """Raise a RecordingError where an element is moved or cut in a way that is not followed."""
    for name in sorted(NOT_FOLLOWED & {*element.keys()}):
        if element.get(name) not in ("none", "auto", "100%"):
            raise RecordingError(
                f"has the style {name}, which is not followed here; apply it in your drawing "
                "program."
            )


def _read_sheet(text: str, rules: dict[str, tuple[int, Properties]]) -> None:
    """Add the rules of a sheet without comments, by selector; of two for one the later holds."""
    if NESTED.search(text):
        raise RecordingError(
            f"has style rules inside others, which are not followed here; {STYLE_CURE}"
        )
    for block in text.split("}"):
        before, _, inside = block.partition("{")
        declared = _declarations(inside)
        for selector in before.rpartition(";")[2].split(",") if declared else ():
            name = selector.strip()
            if not SELECTOR.fullmatch(name):
                raise RecordingError(
                    f"has the style rule {name[:40]!r}, which is not followed here; {STYLE_CURE}"
                )
            rules[name] = (len(rules), rules.get(name, (0, {}))[1] | declared)


def _declarations(text: str) -> Properties:
    """Return what a `style` says of the properties that matter here; `!x` for an important x."""
    said: Properties = {}
    for declaration in text.split(";"):
        name, colon, value = declaration.partition(":")
        if colon and name.strip().lower() in PROPERTIES:
            value, mark, _ = value.partition("!")
            said[mark + name.strip().lower()] = value.strip()
    return said


def colour(text: str) -> Array:
    """Return red, green, blue and opacity, shape (4,): grey for a pattern, black if unknown."""
    text = LIGHT_OF_TWO.sub(r"\1", text)
    name, *values = re.split(r"[\s,/()]+", text.strip(") "))
    if name == "url":
        return np.full(4, 0.5)
    if name == "var":
        raise RecordingError(
            f"has the colour {text[:40]!r}, which is not followed here; {STYLE_CURE}"
        )
    if len(values) == 4 and values[3].endswith("%"):
        values[3] = str(share(values[3]))
    try:
        known = Color(f"{name}({','.join(values)})" if values else text)
        return np.array([known.red, known.green, known.blue, known.alpha]) / 255
    except (ValueError, TypeError, IndexError, ArithmeticError, AttributeError):
        return np.array([0.0, 0.0, 0.0, 1.0])


def share(text: str | None) -> float:
    """Return a number from 0 to 1, or a share of 100; 1 where there is none."""
    number = finite_number((text or "").removesuffix("%"))
    whole = 100 if (text or "").endswith("%") else 1
    return 1.0 if number is None else min(max(number / whole, 0.0), 1.0)
