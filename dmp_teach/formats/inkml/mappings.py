"""Mappings of InkML: from what a device counts to what a channel means, and from a trace to the canvas that it is on.

Affine ones are followed, and those that change nothing; others are refused by name.
"""

from __future__ import annotations

from collections.abc import Callable
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag
from dmp_teach.trajectory import Array

Named = Callable[[str | None], Element | None]


def canvas_matrix(transform: Element | None, named: Named) -> Array | None:
    """What a `canvasTransform` does to X and Y, a matrix (2, 3); None where that is nothing."""
    return (
        None if transform is None else _affine(transform, ("X", "Y"), "its canvasTransform", named)
    )


def channel_line(channel: Element, named: Named) -> tuple[float, float]:
    """What the mapping of a channel does: the factor, and what is added."""
    name = channel.get("name") or ""
    line = _affine(channel, (name,), f"channel {name[:20]!r}", named)
    return (1.0, 0.0) if line is None else (float(line[0, 0]), float(line[0, 1]))


def _affine(holder: Element, sources: tuple[str, ...], what: str, named: Named) -> Array | None:
    """The matrix of the first mapping in an element, as many rows as sources and a column more."""
    mapping = next((each for each in holder if local_tag(each) == "mapping"), None)
    if mapping is not None and mapping.get("mappingRef"):
        mapping = named(mapping.get("mappingRef"))
    if mapping is None:
        return None
    inner = next((each for each in mapping if local_tag(each) == "affine"), None)
    kind = (mapping.get("type") or ("unknown" if inner is None else "affine")).strip().lower()
    if kind in ("identity", "unknown"):
        return None
    bound = [
        each.get("source") for each in mapping if local_tag(each) == "bind" and each.get("source")
    ]
    if kind != "affine" or bound not in ([], list(sources)):
        kind = kind if kind != "affine" else f"affine of {', '.join(bound)}"
        raise RecordingError(
            f"has a mapping of the kind {kind[:40]!r} for {what}, but only affine ones of {' and '.join(sources)} are "
            "followed; save the ink with its mapping applied."
        )
    return _matrix("".join((mapping if inner is None else inner).itertext()), len(sources), what)


def _matrix(text: str, rows: int, what: str) -> Array:
    """A matrix from its rows, with commas between them; a missing last column is 0."""
    found = [
        [finite_number(word) for word in row.split()]
        for row in text.strip().strip(",").split(",")[: rows + 1]
    ]
    widths = {len(row) for row in found}
    if (
        len(found) != rows
        or widths not in ({rows}, {rows + 1})
        or any(None in row for row in found)
    ):
        raise RecordingError(
            f"has the affine mapping {' '.join(text.split())[:40]!r} for {what}, but it must have {rows} x {rows + 1} "
            "numbers, with commas between its rows."
        )
    matrix = np.array(found, dtype=float)
    return matrix if matrix.shape[1] == rows + 1 else np.column_stack([matrix, np.zeros(rows)])
