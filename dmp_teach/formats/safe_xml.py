"""XML from strangers: no entities, nothing from elsewhere, no more elements and no deeper than ink needs."""

from __future__ import annotations

import math
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from defusedxml.common import DefusedXmlException, EntitiesForbidden
from defusedxml.ElementTree import DefusedXMLParser

from dmp_teach.errors import RecordingError

LARGEST = 16_000_000  # [bytes]
MOST = 100_000  # elements
DEEPEST = 60  # elements inside one another
CHUNK = 65_536  # [bytes]


class _Counted(TreeBuilder):
    """A tree that stops growing."""

    def __init__(self):
        super().__init__()
        self.count = self.depth = 0

    def start(self, tag: str, attrs: dict) -> Element:
        """Count on the way in."""
        self.count, self.depth = self.count + 1, self.depth + 1
        if self.count > MOST or self.depth > DEEPEST:
            raise RecordingError(
                f"has more than {MOST} elements, or more than {DEEPEST} inside one another; cut it."
            )
        return super().start(tag, attrs)

    def end(self, tag: str) -> Element:
        """And on the way out."""
        self.depth -= 1
        return super().end(tag)


def parsed(data: bytes) -> Element:
    """The root element of a file.

    Raises:
        RecordingError: Not well-formed XML, larger or deeper than ink needs, or with entities of its own.
    """
    if len(data) > LARGEST:
        raise RecordingError(
            f"has {len(data) / 1e6:.0f} MB, but ink in XML has at most {LARGEST / 1e6:.0f}; cut it."
        )
    parser = DefusedXMLParser(target=_Counted())
    try:
        for k in range(0, len(data), CHUNK):
            parser.feed(data[k : k + CHUNK])
        return parser.close()
    except RecordingError:
        raise
    except EntitiesForbidden as error:
        raise RecordingError(
            f"defines the entity {error.name!r}, which ink never needs; save it without."
        ) from None
    except (ParseError, DefusedXmlException, ValueError, LookupError) as error:
        raise RecordingError(f"is not well-formed XML: {error}. Save or export it again.") from None


def local(element: Element) -> str:
    """An element's name without its namespace; nothing for what is no element."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def number_of(text: str | None) -> float | None:
    """The number that an attribute says; None where it says none."""
    try:
        value = float((text or "").replace("_", "x"))
    except ValueError:
        return None
    return value if math.isfinite(value) and abs(value) < 1e100 else None
