"""XML from strangers: no entities, nothing from elsewhere, no more elements than ink needs."""

from __future__ import annotations

import io
import math
import re
from xml.etree.ElementTree import Element, ParseError
from xml.sax.saxutils import escape

from defusedxml.common import DefusedXmlException, EntitiesForbidden
from defusedxml.ElementTree import iterparse

from dmp_teach.errors import RecordingError

MOST_ELEMENTS = 100_000
DEEPEST_ELEMENT = 60  # elements inside one another
BEGINNING = 65_536  # of a file, in which its root is [bytes]
FIRST_TAG = re.compile(rb"<(?:[\w.-]+:)?([A-Za-z][\w.-]*)")
NOT_IN_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def parse_xml(data: bytes, root_tag: str, what: str) -> Element:
    """Return the root element of a file.

    Args:
        data: The file.
        root_tag: The name that its root must have.
        what: Names such files in a sentence.

    Raises:
        RecordingError: Not well-formed XML, larger or deeper than ink needs, with entities of its
            own, or with another root.
    """
    count = depth = 0
    parts = iterparse(io.BytesIO(data), ("start", "end"))
    try:
        for event, _ in parts:
            depth += 1 if event == "start" else -1
            count += event == "start"
            if count > MOST_ELEMENTS or depth > DEEPEST_ELEMENT:
                raise RecordingError(
                    f"has more than {MOST_ELEMENTS} elements, or more than {DEEPEST_ELEMENT} "
                    "inside one another; cut it."
                )
    except RecordingError:
        raise
    except EntitiesForbidden as error:
        raise RecordingError(
            f"defines the entity {error.name!r}, which ink never needs; save it without."
        ) from None
    except (ParseError, DefusedXmlException, ValueError, LookupError) as error:
        raise RecordingError(f"is not well-formed XML: {error}. Save or export it again.") from None
    root: Element = parts.root
    if local_tag(root) != root_tag:
        raise RecordingError(
            f"is XML of the kind {local_tag(root)[:40]!r}, but must be {what} ({root_tag})."
        )
    return root


def has_root(data: bytes, tag: str) -> bool:
    """Tell from the beginning of a file whether it is XML with a root of this name."""
    begin = data[:BEGINNING].replace(b"\0", b"").lstrip(b"\xef\xbb\xbf\xff\xfe \t\r\n")
    plain = b"".join(part.partition(b"<!--")[0] for part in begin.split(b"-->"))
    first = FIRST_TAG.search(plain)
    return begin.startswith(b"<") and first is not None and first[1] == tag.encode()


def local_tag(element: Element) -> str:
    """Return an element's name without its namespace; nothing for what is no element."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def finite_number(text: str | None) -> float | None:
    """Return the number in a text; None where there is none, or a far too large one."""
    try:
        value = float((text or "").replace("_", "x"))
    except ValueError:
        return None
    return value if math.isfinite(value) and abs(value) < 1e100 else None


def only_xml_signs(text: str) -> str:
    """Return text with a question mark for what XML cannot hold: signs for machines, half signs."""
    return NOT_IN_XML.sub("?", text)


def xml_text(text: str) -> str:
    """Return text as XML has it between its elements."""
    return escape(only_xml_signs(text), {"\r": "&#13;"})
