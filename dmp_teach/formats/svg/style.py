"""What a drawing says of how its shapes look: attributes, `style`, and style sheets as drawing programs write them.

Sheets may select by element, class and id. A rule that selects otherwise is refused where it would hide or move
something, and else left out, for nothing but that is asked for here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag

PLACES = {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height"}
PAINTS = {"stroke", "stroke-width", "stroke-opacity", "fill", "fill-opacity"}
HANDED_DOWN = {"visibility", *PAINTS}
MOVING = {"transform", "transform-origin", "transform-box", "translate", "rotate", "scale", "d"}
ATTRIBUTES = {"display", "opacity", "transform", "transform-origin", *HANDED_DOWN}
ASKED = {*ATTRIBUTES, *PLACES, *MOVING}
SELECTOR = re.compile(r"(\*|[A-Za-z][\w-]*)?((?:[.#][\w-]+)*)")
UNSEEN_YET = re.compile(r":(?:hover|active|focus|visited|target)\b")  # what nobody does to ink
MEDIA = re.compile(r"@media\s+(?:all|screen)\s*", re.IGNORECASE)
MOST_RULES = 20_000
MOST_WORK = 2_000_000  # rules that are looked at, for all shapes together
Props = dict[str, str]


@dataclass(frozen=True)
class Look:
    """How an element looks, as far as it decides whether there is ink.

    Args:
        own: Its own properties.
        handed: Those that it hands down to what is in it.
    """

    own: Props
    handed: Props

    @property
    def is_gone(self) -> bool:
        """Whether neither it nor anything in it is shown."""
        return self.own.get("display") == "none" or _is_zero(self.own.get("opacity"))

    @property
    def is_seen(self) -> bool:
        """Whether a shape that looks so leaves anything on the page; a stroke that nobody speaks of is drawn."""
        if self.handed.get("visibility") in ("hidden", "collapse"):
            return False
        return not (self._is_off("stroke") and self._is_off("fill")) or "stroke" not in self.handed

    @property
    def is_paper(self) -> bool:
        """Whether a shape that looks so is an area of a colour, with no line round it."""
        lined = "stroke" in self.handed and not self._is_off("stroke")
        return "fill" in self.handed and not self._is_off("fill") and not lined

    def _is_off(self, paint: str) -> bool:
        """Whether a stroke or a fill leaves nothing."""
        if self.handed.get(paint) in ("none", "transparent") or _is_zero(
            self.handed.get(f"{paint}-opacity")
        ):
            return True
        return paint == "stroke" and _is_zero(self.handed.get("stroke-width"))


@dataclass(frozen=True)
class _Rule:
    """A rule of a style sheet: when it counts, and what it says."""

    weight: tuple[int, int, int]
    names: frozenset[str]  # the classes (.a), ids (#a) and the element that an element must have
    normal: Props
    important: Props


class Styles:
    """The style sheets of a drawing."""

    def __init__(self, root: Element):
        self._rules: dict[str, list[_Rule]] = {}
        self._work = 0
        for sheet in root.iter():
            if (
                local_tag(sheet) == "style"
                and (sheet.get("type") or "text/css").strip().lower() == "text/css"
            ):
                for selectors, declared in _blocks("".join(sheet.itertext())):
                    self._add(selectors, declared)

    def _add(self, selectors: str, declared: str) -> None:
        """A rule, one for each of its selectors."""
        normal, important = _declarations(declared)
        if not (normal or important):
            return
        self._work += selectors.count(",") + 1
        if self._work > MOST_RULES:
            raise RecordingError(
                f"has more than {MOST_RULES} style rules; give its elements their styles themselves."
            )
        for selector in map(str.strip, selectors.split(",")):
            match = SELECTOR.fullmatch(selector)
            if match and selector:
                tag = "" if match[1] in (None, "*") else match[1]
                names = re.findall(r"[.#][\w-]+", match[2])
                weight = (
                    sum(n[0] == "#" for n in names),
                    sum(n[0] == "." for n in names),
                    bool(tag),
                )
                rule = _Rule(
                    weight, frozenset([*names, *([tag] if tag else [])]), normal, important
                )
                self._rules.setdefault(max(names, default=tag), []).append(rule)
            elif not UNSEEN_YET.search(selector) and _hides(normal | important):
                raise RecordingError(
                    f"has the style rule {selector[:40]!r}, which is not followed here; give its elements these "
                    "styles themselves, or delete what is hidden."
                )

    def look(self, element: Element, above: Look | None) -> Look:
        """How an element looks in what holds it, None for the root."""
        said = {
            name: text.strip() for name in ATTRIBUTES if (text := element.get(name)) is not None
        }
        normal, important = _declarations(element.get("style") or "")
        found = self._found(element)
        for rule in found:
            said |= rule.normal
        said |= normal
        for rule in found:
            said |= rule.important
        said = {name: text for name, text in (said | important).items() if text != "inherit"}
        own = {name: text if name in MOVING else text.lower() for name, text in said.items()}
        below = {name: text for name, text in own.items() if name in HANDED_DOWN}
        return Look(own, below if above is None else above.handed | below)

    def _found(self, element: Element) -> list[_Rule]:
        """The rules that mean an element, the weakest first."""
        if not self._rules:
            return []
        names = {f".{name}" for name in (element.get("class") or "").split()} | {local_tag(element)}
        if element.get("id"):
            names.add(f"#{element.get('id')}")
        asked = [rule for name in ("", *names) for rule in self._rules.get(name, ())]
        self._work += len(names) + len(asked)
        if self._work > MOST_WORK:
            raise RecordingError(
                f"has style sheets that take more than {MOST_WORK} steps; give its elements their styles themselves."
            )
        return sorted((rule for rule in asked if rule.names <= names), key=lambda rule: rule.weight)


def _blocks(text: str) -> Iterator[tuple[str, str]]:
    """The rules of a style sheet: what stands before each brace, and in it."""
    text = _without_comments(text.replace("<!--", " ").replace("-->", " "))
    before, skipped = "", 0
    for piece in re.split(r"(\{[^{}]*\}|[{}])", text):
        if piece == "{":
            skipped += bool(skipped) or not MEDIA.fullmatch(before.strip())
            before = ""
        elif piece == "}":
            skipped, before = max(skipped - 1, 0), ""
        elif not piece.startswith("{"):
            before = piece.rpartition(";")[2]
        else:
            if not skipped and not before.strip().startswith("@"):
                yield before.strip(), piece[1:-1]
            before = ""


def _declarations(text: str) -> tuple[Props, Props]:
    """What a `style` says of what is asked for here, and the part of it that is important."""
    normal: Props = {}
    important: Props = {}
    for declaration in _without_comments(text).split(";"):
        name, colon, value = declaration.partition(":")
        name, value = name.strip().lower(), value.strip()
        if colon and name in ASKED:
            plain, mark, _ = value.partition("!")
            (important if mark else normal)[name] = plain.strip()
    return normal, important


def _without_comments(text: str) -> str:
    """A style without what stands between /* and */."""
    kept, place = [], 0
    while (start := text.find("/*", place)) >= 0:
        kept.append(text[place:start])
        end = text.find("*/", start + 2)
        place = len(text) if end < 0 else end + 2
    return " ".join([*kept, text[place:]])


def _hides(props: Props) -> bool:
    """Whether properties take something from the page, or move it."""
    if set(props) & MOVING or props.get("display") == "none" or _is_zero(props.get("opacity")):
        return True
    return props.get("visibility") in ("hidden", "collapse") or "none" in (
        props.get("stroke"),
        props.get("fill"),
    )


def _is_zero(text: str | None) -> bool:
    """Whether a number, a share or a length is nothing."""
    number = finite_number(re.sub(r"(%|px)$", "", text.strip())) if text else None
    return number is not None and number <= 0
