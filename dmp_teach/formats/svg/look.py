"""How the shapes of a drawing look, from attributes, `style` and plain style sheets.

A sheet may select by element, class, element and class, or id. A rule that selects otherwise is
refused where it would hide or move something, and else left out.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag

INHERITED = {"visibility", "stroke", "stroke-width", "stroke-opacity", "fill", "fill-opacity"}
SIZES = {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height"}
NOT_FOLLOWED = {"clip-path", "mask", "transform-origin", "transform-box"}
NOT_FOLLOWED_IN_STYLES = {*NOT_FOLLOWED, "translate", "rotate", "scale", "d"}
ATTRIBUTES = {"display", "opacity", "transform", *INHERITED, *NOT_FOLLOWED}
PROPERTIES = {*ATTRIBUTES, *SIZES, *NOT_FOLLOWED_IN_STYLES}
SELECTOR = re.compile(r"\*|[A-Za-z][\w-]*|#[\w-]+|(?:[A-Za-z][\w-]*)?\.[\w-]+")
USER_ACTION = re.compile(r":(?:hover|active|focus|visited|target)\b")
BRACE = re.compile(r"[{}]")
NESTED = re.compile(r"\{[^{}]*\{")
COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
LONGEST_ATTRIBUTE = 4000  # of a style or of classes
STYLE_CURE = "give its elements these styles themselves, or delete what is hidden."
Properties = dict[str, str]


@dataclass(frozen=True)
class Look:
    """How an element looks, as far as it decides whether there is ink.

    Args:
        own: Its own properties.
        inherited: Those that it hands down to what is in it.
    """

    own: Properties
    inherited: Properties

    @property
    def is_gone(self) -> bool:
        """Whether neither it nor anything in it is shown."""
        return self.own.get("display") == "none" or _is_zero(self.own.get("opacity"))

    @property
    def is_seen(self) -> bool:
        """Whether a shape that looks so leaves anything on the page."""
        if self.inherited.get("visibility") in ("hidden", "collapse"):
            return False
        return self._paints("stroke", "none") or self._paints("fill", "black")

    @property
    def is_area(self) -> bool:
        """Whether a shape that looks so is an area of a colour, with no line round it."""
        return self._paints("fill", "none") and not self._paints("stroke", "none")

    def check_followed(self) -> None:
        """Raise a RecordingError where a style moves or cuts it in a way that is not followed."""
        for name in sorted(self.own.keys() & NOT_FOLLOWED_IN_STYLES):
            if self.own[name] != "none":
                raise RecordingError(
                    f"has the style {name}, which is not followed here; apply it in your "
                    "drawing program."
                )

    def _paints(self, paint: str, usual: str) -> bool:
        """Whether a stroke or a fill leaves anything."""
        if self.inherited.get(paint, usual) in ("none", "transparent"):
            return False
        if paint == "stroke" and _is_zero(self.inherited.get("stroke-width")):
            return False
        return not _is_zero(self.inherited.get(f"{paint}-opacity"))


class Styles:
    """The style sheets of a drawing."""

    def __init__(self, root: Element) -> None:
        self._rules: dict[str, tuple[int, Properties]] = {}
        for sheet in root.iter():
            kind = (sheet.get("type") or "text/css").strip().lower()
            if local_tag(sheet) == "style" and kind == "text/css":
                self._read(COMMENT.sub(" ", "".join(sheet.itertext())))

    def look(self, element: Element, above: Look | None) -> Look:
        """Return how an element looks in what holds it, None for the root."""
        said = {name: value for name in ATTRIBUTES if (value := element.get(name)) is not None}
        for rule in self._rules_of(element):
            said |= rule
        said |= _declarations(_short(element, "style"))
        own = {name: value.strip() for name, value in said.items() if value.strip() != "inherit"}
        passed = {name: value.lower() for name, value in own.items() if name in INHERITED}
        return Look(own, passed if above is None else above.inherited | passed)

    def _read(self, text: str) -> None:
        """Read a sheet without comments."""
        if NESTED.search(text) and _hides(_declarations(BRACE.sub(";", text))):
            raise RecordingError(
                f"has style rules inside others, which are not followed here; {STYLE_CURE}"
            )
        for block in text.replace("<!--", " ").replace("-->", " ").split("}"):
            before, _, inside = block.partition("{")
            declared = _declarations(inside)
            for selector in before.rpartition(";")[2].split(",") if declared else ():
                self._add(selector.strip(), declared)

    def _add(self, selector: str, declared: Properties) -> None:
        """Add a rule for one selector to what the sheets said of it before."""
        if SELECTOR.fullmatch(selector):
            before = self._rules.get(selector, (0, {}))[1]
            self._rules[selector] = (len(self._rules), before | declared)
        elif _hides(declared) and not (USER_ACTION.search(selector) or selector.startswith("@")):
            raise RecordingError(
                f"has the style rule {selector[:40]!r}, which is not followed here; {STYLE_CURE}"
            )

    def _rules_of(self, element: Element) -> list[Properties]:
        """Return the rules that mean an element, the weakest first."""
        tag = local_tag(element)
        classes = [f".{name}" for name in _short(element, "class").split()]
        levels = [["*"], [tag], classes, [f"{tag}{name}" for name in classes]]
        levels += [[f"#{element.get('id')}"]]
        found: list[Properties] = []
        for level in levels:
            rules = sorted(
                (self._rules[name] for name in set(level) & self._rules.keys()),
                key=lambda rule: rule[0],
            )
            found += [declared for _, declared in rules]
        return found


def _short(element: Element, name: str) -> str:
    """Return an attribute that is not too long."""
    text = element.get(name) or ""
    if len(text) > LONGEST_ATTRIBUTE:
        raise RecordingError(
            f"has a {name} of {len(text)} characters, but a shape needs at most "
            f"{LONGEST_ATTRIBUTE}; save the drawing again."
        )
    return text


def _declarations(text: str) -> Properties:
    """Return what a `style` says of the properties that matter here."""
    said: Properties = {}
    for declaration in COMMENT.sub(" ", text).split(";"):
        name, colon, value = declaration.partition(":")
        if colon and name.strip().lower() in PROPERTIES:
            said[name.strip().lower()] = value.strip()
            if "!" in value:
                raise RecordingError(
                    f"has the style {declaration.strip()[:40]!r}, which is not followed here; "
                    f"{STYLE_CURE}"
                )
    return said


def _hides(declared: Properties) -> bool:
    """Tell whether properties take something from the page, or move it."""
    if declared.keys() & {*NOT_FOLLOWED_IN_STYLES, "transform"}:
        return True
    values = {declared.get(name) for name in ("display", "stroke", "fill")}
    return (
        "none" in values
        or declared.get("visibility") in ("hidden", "collapse")
        or _is_zero(declared.get("opacity"))
    )


def _is_zero(text: str | None) -> bool:
    """Tell whether a number, a share or a length is nothing."""
    number = finite_number(re.sub(r"(%|px)$", "", text.strip())) if text else None
    return number is not None and number <= 0
