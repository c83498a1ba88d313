"""Which traces of an InkML file are a letter: groups and views with a label, through references.

A view (`traceView`) shows a trace, a group or another view once more. What stands in `definitions`
is shown only where a view shows it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import DEEPEST_ELEMENT, local_tag

LABELS = ("truth", "label", "character", "symbol", "transcription", "text")
GROUPS_OF_TRACES = ("traceGroup", "traceView")
MOST_SHOWN = 1_000_000  # traces and groups, again and again


def annotation(element: Element, kinds: tuple[str, ...]) -> str | None:
    """Return what the first annotation of one of these types says; None where there is none."""
    for each in element:
        if local_tag(each) == "annotation" and (each.get("type") or "").lower() in kinds:
            return each.text or ""
    return None


def labelled_letters(
    root: Element, named: Callable[[str], Element]
) -> tuple[list[tuple[Element, list[Element]]], list[str]]:
    """Return the innermost groups and views with a label, and the traces of each, each once.

    Beside them is told why others have none.

    Args:
        root: Of the file; it is the one letter where nothing has a label.
        named: Returns the element that a reference means.

    Raises:
        RecordingError: A view of what is no ink, of a part, of itself, or far too many.
    """
    count = 0

    def shown(element: Element, depth: int = 0) -> Iterator[Element]:
        """Yield an element and all groups, views and traces that it shows."""
        nonlocal count
        count += 1
        if depth > DEEPEST_ELEMENT or count > MOST_SHOWN:
            raise RecordingError(
                f"has views of views that are more than {DEEPEST_ELEMENT} deep, or show more than "
                f"{MOST_SHOWN} traces; view traces."
            )
        yield element
        reference = element.get("traceDataRef")
        if local_tag(element) == "traceView" and reference:
            if element.get("from") or element.get("to"):
                raise RecordingError(
                    "has a view of a part (from, to), which is not followed here; view the whole."
                )
            yield from shown(named(reference), depth + 1)
        else:
            for child in element:
                if local_tag(child) in ("trace", *GROUPS_OF_TRACES):
                    yield from shown(child, depth + 1)

    groups = [each for each in root.iter() if local_tag(each) in GROUPS_OF_TRACES]
    labelled = {id(each) for each in groups if annotation(each, LABELS)}
    letters, faults = [], []
    for group in groups:
        try:
            inside = list(shown(group)) if id(group) in labelled else []
        except RecordingError as error:
            faults.append(f"{annotation(group, LABELS)!r:.40} {error}")
            continue
        if inside and not any(id(each) in labelled for each in inside[1:]):
            letters.append((group, _traces(inside)))
    if letters or faults:
        return letters, faults
    return [(root, _traces(shown(root)))], []


def _traces(elements: Iterable[Element]) -> list[Element]:
    """Return the traces among elements, each once."""
    return list(dict.fromkeys(each for each in elements if local_tag(each) == "trace"))
