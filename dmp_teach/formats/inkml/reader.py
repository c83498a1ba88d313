"""Digital ink as tablets and forms save it: InkML, a recommendation of the W3C (20 September 2011).

Channels are taken as the file declares them (`channels`), points as it abbreviates them (`points`).
Each trace that was written with the pen down is a stroke, and points where the tip switch S is off
leave a gap. Groups and views of traces (`groups`) with a label of their own (an annotation `truth`,
`label` or the like) are letters of their own; a file without any is one letter. Times are those of
channel T, or the device's sample rate (`timing`), or else a hand's (`hand_pace`). Mappings, parts
of traces and traces that continue others are refused.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import (
    check_size,
    flat_recording,
    label_from,
    lengths_in_mm,
    own_label,
    pseudonym_from,
    usual_scale,
)
from dmp_teach.formats.hand_pace import at_hand_pace
from dmp_teach.formats.inkml.channels import Channel, Contexts, TraceFormat, tells_channels
from dmp_teach.formats.inkml.groups import LABELS, annotation, labelled_letters
from dmp_teach.formats.inkml.points import MOST_POINTS, read_points
from dmp_teach.formats.inkml.timing import on_one_clock, trace_times
from dmp_teach.formats.inkml.writer import write_inkml
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.ink import Recording
from dmp_teach.segmentation import find_runs
from dmp_teach.trajectory import Array, Trajectory

InkContext = tuple[Element | str, ...]
MOST_CONTEXTS = 16  # that a trace inherits from


@dataclass
class _TraceStroke:
    """A stroke: its times or None, points, pressure or None, and whether its unit is known."""

    t: Array | None
    xy: Array
    force: Array | None
    in_metres: bool


@name_file
def read_inkml(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of an InkML file.

    Raises:
        RecordingError: No ink in it, a reference that leads nowhere, or a trace that cannot be.
    """
    root = parse_xml(data, "ink", "InkML")
    contexts = Contexts(root)
    groups = labelled_letters(root, contexts.named)
    shown = {trace for _, traces in groups for trace in traces}
    strokes = _read_traces(root, contexts, shown)
    letters = []
    for group, traces in groups:
        written = [stroke for trace in traces for stroke in strokes.get(trace, ())]
        letters += [(group, written)] if written else []
    if not letters:
        raise RecordingError("has no trace of a pen that was down, so there is no ink in it.")
    every = [stroke for _, written in letters for stroke in written]
    scale = 1.0
    if not all(stroke.in_metres for stroke in every):
        scale = usual_scale([[stroke.xy for stroke in written] for _, written in letters])
    hardest = max([1.0, *(float(each.force.max()) for each in every if each.force is not None)])
    return tuple(_letter(root, group, written, scale, hardest) for group, written in letters)


def _read_traces(
    root: Element, contexts: Contexts, shown: set[Element]
) -> dict[Element, list[_TraceStroke]]:
    """Return the strokes of every trace of a file, of those in its definitions that are shown."""
    strokes: dict[Element, list[_TraceStroke]] = {}
    points = 0
    for trace, context in _traces_with_contexts(root, shown):
        text = "".join(trace.itertext())
        if trace.get("type", "penDown") != "penDown" or not text.strip():
            continue
        try:
            if trace.get("continuation") in ("middle", "end"):
                raise RecordingError(
                    "continues another one (continuation), which is not followed here; join them."
                )
            form = contexts.format_of(context)
            values = read_points(text, form, MOST_POINTS - points)
            found = _pen_down(values, form, trace)
        except RecordingError as error:
            raise RecordingError(f"trace {len(strokes)} {error}") from None
        points += len(values)
        strokes[trace] = found
    return strokes


def _traces_with_contexts(
    root: Element, shown: set[Element]
) -> Iterator[tuple[Element, InkContext]]:
    """Yield traces in the order of the file, and the contexts that hold for each, nearest first."""
    current: list[Element] = []
    for element in root:
        if local_tag(element) == "context":
            before = [each for each in current if tells_channels(each)]
            current = [element, *before][:MOST_CONTEXTS]
        yield from _traces_in(element, tuple(current))
    for definitions in root:
        if local_tag(definitions) == "definitions":
            for element in definitions:
                found = _traces_in(element, ())
                yield from ((trace, context) for trace, context in found if trace in shown)


def _traces_in(element: Element, context: InkContext) -> Iterator[tuple[Element, InkContext]]:
    """Yield every trace in a trace or a group, and its contexts, or references to them."""
    reference = element.get("contextRef")
    here = (reference, *context) if reference else context
    if local_tag(element) == "trace":
        yield element, here
    elif local_tag(element) == "traceGroup":
        for child in element:
            yield from _traces_in(child, here)


def _pen_down(values: Array, form: TraceFormat, trace: Element) -> list[_TraceStroke]:
    """Return the strokes of one trace: its known points, cut where the tip is off the paper."""
    with np.errstate(all="ignore"):
        xy, in_metres = form.on_page(values)
        offset, duration = trace.get("timeOffset"), trace.get("duration")
        t = trace_times(form.column(values, "T"), form, offset, duration, len(xy))
    pressed, tip = form.column(values, "F"), form.column(values, "S")
    force = None if pressed is None else _pressure(pressed, form.channels["F"])
    rows = xy if t is None else np.column_stack([xy, t])
    known = np.flatnonzero(np.isfinite(rows).all(axis=1))
    strokes = []
    for a, b in [(0, len(xy))] if tip is None else find_runs(tip != 0):
        kept = known[(known >= a) & (known < b)]
        if len(kept):
            times, forces = (None if each is None else each[kept] for each in (t, force))
            strokes.append(_TraceStroke(times, xy[kept], forces, in_metres))
    return strokes


def _pressure(values: Array, channel: Channel) -> Array:
    """Return the pressure (K,): 0 to 1 where the file says what the device can tell."""
    low = channel.low or 0.0
    with np.errstate(all="ignore"):
        if channel.high is not None and channel.high > low:
            values = np.minimum((values - low) / (channel.high - low), 1.0)
        return np.nan_to_num(np.maximum(values, 0.0), nan=0.0, posinf=1.0)


def _letter(
    root: Element, group: Element, strokes: list[_TraceStroke], scale: float, hardest: float
) -> Recording:
    """Return one letter from its strokes."""
    with np.errstate(all="ignore"):
        rows = [stroke.xy * scale for stroke in strokes]
    check_size(rows)
    forces = [stroke.force / hardest for stroke in strokes if stroke.force is not None]
    is_forced = len(forces) == len(strokes)
    if is_forced:
        rows = [np.column_stack(each) for each in zip(rows, forces, strict=True)]
    times = [stroke.t for stroke in strokes if stroke.t is not None]
    if len(times) < len(strokes):
        laid = [(stroke.t, stroke.position) for stroke in at_hand_pace(rows)]
    else:
        laid = on_one_clock(list(zip(times, rows, strict=True)))
    origin = lengths_in_mm(annotation(root, ("origin",)), 2)
    baseline = lengths_in_mm(annotation(root, ("baseline",)), 1)
    label = annotation(group, LABELS)
    writer = annotation(group, ("writer",)) or annotation(root, ("writer",))
    return flat_recording(
        [Trajectory(t, row[:, :2]) for t, row in laid],
        [row[:, 2] for _, row in laid] if is_forced else None,
        origin,
        character=label_from(label) if origin is None else own_label(label),
        writer=pseudonym_from(writer),
        baseline=None if baseline is None or origin is None else float(baseline[0]),
    )


FORMAT = Format("InkML", (".inkml",), partial(has_root, tag="ink"), read_inkml, write_inkml)
