"""Which ink of an InkML file belongs together: groups, views of traces and of groups, and parts of them.

A view (`traceView`) shows a trace, a group or another view once more, wholly or from one point to another: `from="2:5"`
is the fifth point of the second child, counted from 1. What stands in `definitions` is shown only where a view
shows it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import DEEPEST_ELEMENT, local_tag

LABELS = ("truth", "label", "character", "symbol", "transcription", "text")
HOLDERS = ("traceGroup", "traceView")
INK = ("trace", *HOLDERS)
MOST = 1_000_000  # traces that are shown, again and again
Piece = tuple[
    Element, int, int | None
]  # a trace, and which of its points, from 1, the last one (None: its own) too
Named = Callable[[str | None], Element | None]


def annotation(element: Element, kinds: tuple[str, ...]) -> str | None:
    """What an annotation of one of these types says, the first of them; None where there is none."""
    for each in element:
        if local_tag(each) == "annotation" and (each.get("type") or "").lower() in kinds:
            return each.text or ""
    return None


def letters_of(root: Element, named: Named) -> list[Element]:
    """What is a letter: the innermost groups and views with a label; the whole file where there is none."""
    labelled = [
        each for each in root.iter() if local_tag(each) in HOLDERS and annotation(each, LABELS)
    ]
    holders = _holders(root, {id(each) for each in labelled})
    inner = [
        each
        for each in labelled
        if not any(_leads(part, each, holders, named) for part in each.iter())
    ]
    return inner or [root]


def _holders(element: Element, labelled: set[int]) -> set[int]:
    """All elements that have a label or hold one that has."""
    found: set[int] = set()
    for child in element:
        found |= _holders(child, labelled)
    if found or id(element) in labelled:
        found.add(id(element))
    return found


def _leads(part: Element, letter: Element, holders: set[int], named: Named) -> bool:
    """Whether a part of a letter leads to another label."""
    if part is not letter and id(part) in holders:
        return True
    target = named(part.get("traceDataRef")) if local_tag(part) == "traceView" else None
    return target is not None and target is not letter and id(target) in holders


class Shown:
    """What elements show, trace by trace."""

    def __init__(self, named: Named):
        self._named, self._count = named, 0

    def pieces(self, element: Element) -> list[Piece]:
        """The parts of traces that a group, a view or a whole file shows, in order.

        Raises:
            RecordingError: A view of what is no ink, of a part that is not there, of itself, or far too many.
        """
        return list(self._pieces(element, (), (), 0))

    def _pieces(self, element: Element, first: tuple, last: tuple, depth: int) -> Iterator[Piece]:
        """What an element shows from one place in it to another."""
        self._count += 1
        if depth > DEEPEST_ELEMENT or self._count > MOST:
            raise RecordingError(
                f"has views of views that are more than {DEEPEST_ELEMENT} deep, or show more than {MOST} traces; view traces."
            )
        if local_tag(element) == "trace":
            if max(len(first), len(last)) > 1:
                raise RecordingError(
                    "has a view of a part of a point; 'from' and 'to' must end with a point."
                )
            yield element, first[0] if first else 1, last[0] if last else None
        elif element.get("traceDataRef"):
            yield from self._viewed(element, first, last, depth)
        else:
            yield from self._children(element, first, last, depth)

    def _viewed(self, view: Element, first: tuple, last: tuple, depth: int) -> Iterator[Piece]:
        """What a view shows of another element."""
        target = self._named(view.get("traceDataRef"))
        if local_tag(target) not in INK:
            raise RecordingError(
                f"has a view of {view.get('traceDataRef')[:60]!r}, which is no trace and no group."
            )
        begin, end = _path(view, "from"), _path(view, "to")
        if (begin or end) and (first or last):
            raise RecordingError(
                "has a view of a part of a view that shows a part; view the trace itself."
            )
        yield from self._pieces(target, begin or first, end or last, depth + 1)

    def _children(self, element: Element, first: tuple, last: tuple, depth: int) -> Iterator[Piece]:
        """What the children of a group show."""
        children = [child for child in element if local_tag(child) in INK]
        begin, end = first[0] if first else 1, last[0] if last else len(children)
        if (first or last) and not 1 <= begin <= end <= len(children):
            raise RecordingError(
                f"has a view of the traces {begin} to {end} in a group of {len(children)}; mend it."
            )
        for k, child in enumerate(children[begin - 1 : end], start=begin):
            yield from self._pieces(
                child, first[1:] if k == begin else (), last[1:] if k == end else (), depth + 1
            )


def _path(view: Element, name: str) -> tuple[int, ...]:
    """What `from` or `to` says; nothing where it is not said."""
    text = (view.get(name) or "").strip()
    words = text.split(":") if text else []
    if len(words) > DEEPEST_ELEMENT or not all(
        word.isascii() and word.isdigit() and len(word) < 10 for word in words
    ):
        raise RecordingError(
            f"has a view {name} {text[:40]!r}, which must be whole numbers with : between, from 1."
        )
    path = tuple(map(int, words))
    if 0 in path:
        raise RecordingError(f"has a view {name} {text[:40]!r}, but points are counted from 1.")
    return path
