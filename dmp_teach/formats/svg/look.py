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
NOT_FOLLOWED |= {"transform-origin", "transform-box"}
SIZES = {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height"}
NOT_FOLLOWED_IN_STYLES = {*NOT_FOLLOWED, *SIZES, "translate", "rotate", "scale", "d"}
ATTRIBUTES = {"display", "opacity", "transform", "clip-path", "overflow", *INHERITED, *NOT_FOLLOWED}
PROPERTIES = {*ATTRIBUTES, *NOT_FOLLOWED_IN_STYLES, "background", "background-color"}
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
        own: Its own properties.
        inherited: Those that it hands down to what is in it.
        opacity: The share of it that is seen, with all that it is in.
    """

    own: Properties
    inherited: Properties
    opacity: float

    @property
    def is_gone(self) -> bool:
        """Whether neither it nor anything in it is shown."""
        return self.own.get("display") == "none" or self.opacity <= 0

    def says(self, *names: str) -> bool:
        """Tell whether anything says one of these properties of it."""
        return bool(self.inherited.keys() & {*names})

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
        said = length(self.inherited.get("stroke-width"), 100.0)
        return 1.0 if said is None else said

    def check_followed(self) -> None:
        """Raise a RecordingError where a style moves or cuts it in a way that is not followed."""
        for name in sorted(self.own.keys() & NOT_FOLLOWED_IN_STYLES):
            if self.own[name] not in ("none", "auto", "100%"):
                raise RecordingError(
                    f"has the style {name}, which is not followed here; apply it in your "
                    "drawing program."
                )

    def _paint(self, name: str, usual: str) -> Array | None:
        """Return the colour of a stroke or a fill; None where nobody sees it."""
        said = self.inherited
        text = said.get(name, usual)
        text = said.get("color", "black") if text == "currentcolor" else text
        if text == "none" or said.get("visibility") in ("hidden", "collapse"):
            return None
        paint = colour(text)
        paint[3] *= self.opacity * share(said.get(f"{name}-opacity"))
        return paint if paint[3] > 0 else None


class Styles:
    """The style sheets of a drawing."""

    def __init__(self, root: Element) -> None:
        self._rules: dict[str, tuple[int, Properties]] = {}
        for sheet in root.iter():
            if local_tag(sheet) == "style" and sheet.get("media", "all") in ("", "all", "screen"):
                self._read(COMMENT.sub(" ", "".join(sheet.itertext())))

    def look(self, element: Element, above: Look | None) -> Look:
        """Return how an element looks in what holds it, None for the root."""
        said = {name: value for name in ATTRIBUTES if (value := element.get(name)) is not None}
        for rule in self._rules_of(element, above is None):
            said |= rule
        said |= _declarations(COMMENT.sub(" ", element.get("style") or ""))
        own = {name: value.strip() for name, value in said.items() if value.strip() != "inherit"}
        passed = {name: value.lower() for name, value in own.items() if name in INHERITED}
        opacity = share(own.get("opacity"))
        if above is None:
            return Look(own, passed, opacity)
        return Look(own, above.inherited | passed, above.opacity * opacity)

    def _read(self, text: str) -> None:
        """Read a sheet without comments: of several rules for one selector the later one holds."""
        if NESTED.search(text):
            raise RecordingError(
                f"has style rules inside others, which are not followed here; {STYLE_CURE}"
            )
        for block in text.split("}"):
            before, _, inside = block.partition("{")
            declared = _declarations(inside)
            for selector in map(
                str.strip, before.rpartition(";")[2].split(",") if declared else ()
            ):
                if not SELECTOR.fullmatch(selector):
                    raise RecordingError(
                        f"has the style rule {selector[:40]!r}, which is not followed here; "
                        f"{STYLE_CURE}"
                    )
                _, old = self._rules.get(selector, (0, {}))
                self._rules[selector] = (len(self._rules), old | declared)

    def _rules_of(self, element: Element, is_root: bool) -> list[Properties]:
        """Return the rules that mean an element, the weakest first."""
        tag, classes = local_tag(element), (element.get("class") or "").split()
        names = {"*", tag, f"#{element.get('id')}", ":root" if is_root else tag}
        names |= {f"{before}.{name}" for name in classes for before in ("", tag)}

        def strength(name: str) -> tuple[bool, bool, bool, int]:
            return name[0] == "#", "." in name, name[0] not in ".*", self._rules[name][0]

        return [self._rules[name][1] for name in sorted(names & self._rules.keys(), key=strength)]


def _declarations(text: str) -> Properties:
    """Return what a `style` says of the properties that matter here."""
    said: Properties = {}
    for declaration in text.split(";"):
        name, colon, value = declaration.partition(":")
        if colon and name.strip().lower() in PROPERTIES:
            said[name.strip().lower()] = value.strip()
            if "!" in value:
                raise RecordingError(
                    f"has the style {declaration.strip()[:40]!r}, which is not followed here; "
                    f"{STYLE_CURE}"
                )
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
