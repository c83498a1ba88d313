"""Digital ink as tablets and forms save it: InkML, a recommendation of the W3C (20 September 2011).

Channels are taken as the file declares them (`channels`), points as it abbreviates them (`points`).
Each trace that was written with the pen down is a stroke, and points where the tip switch S is off
leave a gap. The innermost groups and views of traces with a label of their own (an annotation
`truth`, `label` or the like) are letters; a file without any is one letter. A view (`traceView`)
shows a trace, a group or another view once more; what stands in `definitions` is shown only so.
Times are those of channel T, or the device's sample rate, or else a hand's. A trace that continues
another one is one stroke with it. Mappings and parts of traces are refused.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import PIXELS, FlatLetter, FlatStroke, flat_recordings, labelled
from dmp_teach.formats.inkml.channels import Contexts, InkContext, TraceFormat, tells_channels
from dmp_teach.formats.inkml.points import MOST_POINTS, read_points
from dmp_teach.formats.inkml.writer import write_inkml
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.formats.safe_xml import DEEPEST_ELEMENT, has_root, local_tag, parse_xml
from dmp_teach.ink import Recording
from dmp_teach.segmentation import find_runs
from dmp_teach.trajectory import Array

LABELS = ("truth", "label", "character", "symbol", "transcription", "text")
GROUPS_OF_TRACES = ("traceGroup", "traceView")
MOST_SHOWN = 1_000_000  # traces and groups, again and again
Letters = list[tuple[Element, list[Element]]]
"""Groups, and the traces of each, each once."""


def read_inkml(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of an InkML file.

    Raises:
        RecordingError: No ink in it, a reference that leads nowhere, or a trace that cannot be.
    """
    root = parse_xml(data, "ink", "InkML")
    contexts = Contexts(root)
    groups, left_out = _labelled_groups(root, contexts)
    shown = {each for _, some in groups for each in some}
    strokes, faults, in_metres = _read_traces(root, contexts, shown)
    letters = [
        _letter(root, group, [stroke for trace in traces for stroke in strokes.get(trace, ())])
        for group, traces in groups
        if group is root or not faults.keys() & set(traces)
    ]
    left_out += faults.values()
    tops = [each for each in root if local_tag(each) in ("trace", "traceGroup")]
    others = {each for top in tops for each in top.iter() if _has_ink(each)} - shown
    if others:
        left_out.append(f"{len(others)} traces that are in no letter with a label.")
    return flat_recordings(letters, 1.0 if in_metres else None, left_out)


def _annotation(element: Element, *kinds: str) -> str | None:
    """Return what the first annotation of one of these types says; None where there is none."""
    for each in element:
        if local_tag(each) == "annotation" and (each.get("type") or "").lower() in kinds:
            return each.text or ""
    return None


def _labelled_groups(root: Element, contexts: Contexts) -> tuple[Letters, list[str]]:
    """Return the innermost groups with a label, or the root; and why others cannot be read."""
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
        children = [each for each in element if local_tag(each) in ("trace", *GROUPS_OF_TRACES)]
        reference = element.get("traceDataRef")
        if local_tag(element) == "traceView" and reference:
            if element.get("from") or element.get("to"):
                raise RecordingError(
                    "has a view of a part (from, to), which is not followed here; view the whole."
                )
            children = [contexts.named(reference)]
        for child in children:
            yield from shown(child, depth + 1)

    def letter(group: Element, inside: list[Element]) -> tuple[Element, list[Element]]:
        return group, list(dict.fromkeys(each for each in inside if local_tag(each) == "trace"))

    groups = [each for each in root.iter() if local_tag(each) in GROUPS_OF_TRACES]
    labelled_ones = {each for each in groups if _annotation(each, *LABELS)}
    letters, faults = [], []
    for group in (each for each in groups if each in labelled_ones):
        try:
            inside = list(shown(group))
            if labelled_ones.isdisjoint(inside[1:]):
                letters.append(letter(group, inside))
        except RecordingError as error:
            faults.append(f"{_annotation(group, *LABELS)!r:.40} {error}")
    return letters if letters or faults else [letter(root, list(shown(root)))], faults


def _read_traces(
    root: Element, contexts: Contexts, shown: set[Element]
) -> tuple[dict[Element, list[FlatStroke]], dict[Element, str], bool]:
    """Return the strokes of the traces that are shown, why others have none, and if in metres."""
    strokes: dict[Element, list[FlatStroke]] = {}
    faults: dict[Element, str] = {}
    texts: dict[Element, str] = {}
    points, in_metres = 0, True
    for trace, context in _traces_with_contexts(root):
        if trace not in shown or not _has_ink(trace):
            continue
        texts[trace] = text = "".join(trace.itertext())
        try:
            if trace.get("continuation") in ("middle", "end"):
                prior = contexts.named(trace.get("priorRef", ""))
                texts[trace] = text = f"{texts[prior]}, {text}" if prior in strokes else text
                strokes.pop(prior, None)
            form = contexts.format_of(context)
            needed = max(list(form.channels).index(name) for name in "XY") + 1
            # Of some programs a point has more values than its format has channels.
            width = max(len(form.channels), len(text.partition(",")[0].split()) * ("," in text))
            values = read_points(text, width, needed, MOST_POINTS - points)
            if width > len(form.channels):
                faults[root] = "values of points for which there is no channel."
            with np.errstate(all="ignore"):
                strokes[trace], known = _pen_down(values, form, trace)
        except RecordingError as error:
            faults[trace] = f"trace {len(strokes) + len(faults)} {error}"
            continue
        points += len(values)
        in_metres &= known
    return strokes, faults, in_metres


def _has_ink(element: Element) -> bool:
    """Tell whether an element is a trace of a pen that was down."""
    is_down = element.get("type", "penDown") == "penDown"
    return local_tag(element) == "trace" and is_down and bool("".join(element.itertext()).strip())


def _traces_with_contexts(root: Element) -> Iterator[tuple[Element, InkContext]]:
    """Yield every trace of a file, and the contexts that hold for it."""
    current: InkContext = ()
    for element in root:
        if local_tag(element) == "context" and tells_channels(element):
            current = (element,)
        yield from _traces_in(element, current)
    for definitions in root:
        for element in definitions if local_tag(definitions) == "definitions" else ():
            yield from _traces_in(element, ())


def _traces_in(element: Element, context: InkContext) -> Iterator[tuple[Element, InkContext]]:
    """Yield every trace in a trace or a group, and the contexts that hold for it."""
    reference = element.get("contextRef")
    here = (reference, *context) if reference else context
    if local_tag(element) == "trace":
        yield element, here
    elif local_tag(element) == "traceGroup":
        for child in element:
            yield from _traces_in(child, here)


def _pen_down(values: Array, form: TraceFormat, trace: Element) -> tuple[list[FlatStroke], bool]:
    """Return the strokes of one trace, cut where the tip is off, and whether they are in metres."""
    xy, in_metres = form.on_page(values)
    t, force = form.times(values, trace.get("timeOffset")), form.pressure(values)
    rows = xy if t is None else np.column_stack([xy, t])
    known, tip = np.flatnonzero(np.isfinite(rows).all(axis=1)), form.column(values, "S")
    strokes = []
    for a, b in [(0, len(xy))] if tip is None else find_runs(tip != 0):
        kept = known[(known >= a) & (known < b)]
        if len(kept):
            times, forces = (None if each is None else each[kept] for each in (t, force))
            strokes.append(FlatStroke(xy[kept], times, forces))
    return strokes, in_metres


def _letter(root: Element, group: Element, strokes: list[FlatStroke]) -> FlatLetter:
    """Return one letter, with what the file says of it."""
    units = {each.get("units") for each in root.iter() if local_tag(each) == "channel"}
    return labelled(
        FlatLetter(strokes, notes=(PIXELS,) if units & {"px", "pixel", "pixels"} else ()),
        _annotation(group, *LABELS),
        _annotation(group, "writer") or _annotation(root, "writer"),
        _annotation(root, "origin"),
        _annotation(root, "baseline"),
    )


FORMAT = Format("InkML", (".inkml",), partial(has_root, tag="ink"), read_inkml, write_inkml)
