"""How the shapes of a drawing look, from attributes, `style` and plain style sheets.

A sheet may select by element, class, element and class, or id; a rule that selects otherwise is
refused where it says how something looks.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag

INHERITED = {"visibility", "stroke", "stroke-width", "stroke-opacity", "fill", "fill-opacity"}
NOT_FOLLOWED = {"clip-path", "mask", "transform-origin", "transform-box"}
SIZES = {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height"}
NOT_FOLLOWED_IN_STYLES = {*NOT_FOLLOWED, *SIZES, "translate", "rotate", "scale", "d"}
ATTRIBUTES = {"display", "opacity", "transform", *INHERITED, *NOT_FOLLOWED}
PROPERTIES = {*ATTRIBUTES, *NOT_FOLLOWED_IN_STYLES}
SELECTOR = re.compile(r"\*|[A-Za-z][\w-]*|#[\w-]+|(?:[A-Za-z][\w-]*)?\.[\w-]+")
NESTED = re.compile(r"\{[^{}]*\{")
COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
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
    def is_line(self) -> bool:
        """Whether a shape that looks so leaves a line on the page."""
        return self._paints("stroke", "none") and not _is_zero(self.inherited.get("stroke-width"))

    @property
    def is_area(self) -> bool:
        """Whether a shape that looks so is an area of a colour, with no line round it."""
        return self._paints("fill", "black") and not self.is_line

    @property
    def is_unsaid(self) -> bool:
        """Whether a shape that looks so is an area only because nothing says how it looks."""
        return self.is_area and not self.inherited.keys() & {"fill", "stroke"}

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
        said = self.inherited
        is_hidden = said.get("visibility") in ("hidden", "collapse")
        is_clear = said.get(paint, usual) in ("none", "transparent")
        return not (is_hidden or is_clear or _is_zero(said.get(f"{paint}-opacity")))


class Styles:
    """The style sheets of a drawing."""

    def __init__(self, root: Element) -> None:
        self._rules: dict[str, tuple[int, Properties]] = {}
        for sheet in root.iter():
            if local_tag(sheet) == "style":
                self._read(COMMENT.sub(" ", "".join(sheet.itertext())))

    def look(self, element: Element, above: Look | None) -> Look:
        """Return how an element looks in what holds it, None for the root."""
        said = {name: value for name in ATTRIBUTES if (value := element.get(name)) is not None}
        for rule in self._rules_of(element):
            said |= rule
        said |= _declarations(COMMENT.sub(" ", element.get("style") or ""))
        own = {name: value.strip() for name, value in said.items() if value.strip() != "inherit"}
        passed = {name: value.lower() for name, value in own.items() if name in INHERITED}
        return Look(own, passed if above is None else above.inherited | passed)

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

    def _rules_of(self, element: Element) -> list[Properties]:
        """Return the rules that mean an element, the weakest first."""
        tag, classes = local_tag(element), (element.get("class") or "").split()
        names = {"*", tag, f"#{element.get('id')}"}
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


def _is_zero(text: str | None) -> bool:
    """Tell whether a number, a share or a length is nothing."""
    number = finite_number(re.sub(r"(%|px)$", "", text.strip())) if text else None
    return number is not None and number <= 0
