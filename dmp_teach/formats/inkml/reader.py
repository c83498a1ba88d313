"""Digital ink as tablets and forms save it: InkML, a recommendation of the W3C (20 September 2011).

Channels are taken as the file declares them (`inkml_channels`), points as it abbreviates them (`inkml_points`). Each
trace that was written with the pen down is a stroke, a trace that continues another one is part of it, and points where
the tip switch S is off leave a gap. Groups and views of traces (`inkml_views`) with a label of their own (an annotation
`truth`, `label` or the like) are letters of their own; a file without any is one letter. Times are those of channel T,
or the device's sample rate (`inkml_times`), or else a hand's (`pace`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
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
from dmp_teach.formats.hand_pace import in_time
from dmp_teach.formats.inkml.channels import Channel, Contexts, TraceFormat, speaks
from dmp_teach.formats.inkml.points import MOST, points_of
from dmp_teach.formats.inkml.timing import one_clock, times_of
from dmp_teach.formats.inkml.views import LABELS, Piece, Shown, annotation, letters_of
from dmp_teach.formats.inkml.writer import write_inkml
from dmp_teach.formats.registry import CaptureOptions, Format, name_file
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.ink import Recording
from dmp_teach.segmentation import find_runs
from dmp_teach.trajectory import Array, Trajectory

Context = tuple[Element | str, ...]
MOST_CONTEXTS = 16  # that a trace inherits from


@dataclass
class _Stroke:
    """A stroke on its way: times or None, points, pressure or None, whether the unit is known, and points' numbers."""

    t: Array | None
    xy: Array
    force: Array | None
    known: bool
    number: np.ndarray

    def part(self, kept: np.ndarray) -> _Stroke:
        """Some of its points."""
        t, force = (None if each is None else each[kept] for each in (self.t, self.force))
        return _Stroke(t, self.xy[kept], force, self.known, self.number[kept])


@dataclass
class _Ink:
    """What is read of a file: strokes and number of points of each trace, and which a continued one is part of."""

    contexts: Contexts
    points: int = 0
    strokes: dict[Element, list[_Stroke]] = field(default_factory=dict)
    lengths: dict[Element, int] = field(default_factory=dict)
    part_of: dict[Element, Element] = field(default_factory=dict)
    continued: set[Element] = field(default_factory=set)


@name_file
def read_inkml(data: bytes, _name: str, _: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letters of an InkML file.

    Raises:
        RecordingError: No ink in it, a reference that leads nowhere, or a trace that cannot be.
    """
    root = parse_xml(data, "ink", "InkML")
    ink = _Ink(Contexts(root))
    shown = Shown(ink.contexts.named)
    for trace, context in _shown_traces(root, {id(trace) for trace, *_ in shown.pieces(root)}):
        _read(ink, trace, context)
    groups = letters_of(root, ink.contexts.named)
    letters = [
        (group, strokes) for group in groups if (strokes := _strokes(ink, shown.pieces(group)))
    ]
    if not letters:
        raise RecordingError("has no trace of a pen that was down, so there is no ink in it.")
    every = [stroke for _, strokes in letters for stroke in strokes]
    scale = 1.0
    if not all(stroke.known for stroke in every):
        scale = usual_scale([[stroke.xy for stroke in strokes] for _, strokes in letters])
    press = max([1.0, *(float(stroke.force.max()) for stroke in every if stroke.force is not None)])
    return tuple(_letter(root, group, strokes, scale, press) for group, strokes in letters)


def _shown_traces(root: Element, shown: set[int]) -> Iterator[tuple[Element, Context]]:
    """Every trace that is shown, in the order of the file, and the contexts that hold for it, the nearest first."""
    current: Context = ()
    for element in root:
        if local_tag(element) == "context":
            current = (element, *filter(speaks, current))[:MOST_CONTEXTS]
        yield from _traces(element, current)
    for element in root:
        if local_tag(element) == "definitions":
            for child in element:
                yield from (
                    (trace, context) for trace, context in _traces(child, ()) if id(trace) in shown
                )


def _traces(element: Element, context: Context) -> Iterator[tuple[Element, Context]]:
    """Every trace under an element, and the contexts, or references to them, that hold for it."""
    here = (element.get("contextRef"), *context) if element.get("contextRef") else context
    if local_tag(element) == "trace":
        yield element, here
    elif local_tag(element) == "traceGroup":
        for child in element:
            yield from _traces(child, here)


def _read(ink: _Ink, trace: Element, context: Context) -> None:
    """Read one trace into the ink; a trace that continues another one becomes part of it."""
    text, number = "".join(trace.itertext()), len(ink.strokes) + len(ink.part_of)
    if trace.get("type", "penDown") != "penDown" or not text.strip():
        return
    try:
        form = ink.contexts.of(
            [ink.contexts.named(each) if isinstance(each, str) else each for each in context]
        )
        values = points_of(text, form, MOST - ink.points)
        strokes = _down(values, form, trace)
    except RecordingError as error:
        raise RecordingError(f"trace {number} {error}") from None
    ink.points += len(values)
    ink.lengths[trace] = len(values)
    prior = (
        ink.contexts.named(trace.get("priorRef"))
        if trace.get("continuation") in ("middle", "end")
        else None
    )
    prior = ink.part_of.get(prior, prior)
    if prior in ink.strokes and ink.strokes[prior] and strokes:
        ink.part_of[trace] = prior
        ink.continued |= {trace, prior}
        ink.strokes[prior][-1:] = [_joined(ink.strokes[prior][-1], strokes[0]), *strokes[1:]]
    else:
        ink.strokes[trace] = strokes


def _joined(a: _Stroke, b: _Stroke) -> _Stroke:
    """One stroke of two parts."""
    t = None if a.t is None or b.t is None else np.concatenate([a.t, b.t])
    force = None if a.force is None or b.force is None else np.concatenate([a.force, b.force])
    return _Stroke(
        t, np.vstack([a.xy, b.xy]), force, a.known and b.known, np.concatenate([a.number, b.number])
    )


def _down(values: Array, form: TraceFormat, trace: Element) -> list[_Stroke]:
    """The strokes of one trace: its points whose place is known, cut where the tip is off the paper."""
    with np.errstate(all="ignore"):
        column = {c.name: values[:, k] * c.line[0] + c.line[1] for k, c in enumerate(form.channels)}
        xy, known = form.on_page(np.column_stack([column["X"], column["Y"]]))
        t = times_of(column.get("T"), form, trace.get("timeOffset"), trace.get("duration"), len(xy))
    force = _pressure(column["F"], form.find("F")) if "F" in column else None
    seen = np.isfinite(xy).all(axis=1) & (True if t is None else np.isfinite(t))
    parts = find_runs(column["S"] != 0) if "S" in column else [(0, len(xy))]
    whole = _Stroke(t, xy, force, known, np.arange(1, len(xy) + 1))
    kept = [np.flatnonzero(seen[a:b]) + a for a, b in parts]
    return [whole.part(k) for k in kept if len(k)]


def _pressure(values: Array, channel: Channel) -> Array:
    """The pressure (K,): 0 to 1 where the file says how much the device can tell, else as it stands."""
    low = channel.low or 0.0
    with np.errstate(all="ignore"):
        if channel.high is not None and channel.high > low:
            values = np.minimum((values - low) / (channel.high - low), 1.0)
        return np.nan_to_num(np.maximum(values, 0.0), nan=0.0, posinf=1.0)


def _strokes(ink: _Ink, pieces: list[Piece]) -> list[_Stroke]:
    """The strokes of a letter, each once: what is shown wholly is not shown in part, too."""
    whole = {
        ink.part_of.get(trace, trace) for trace, first, last in pieces if (first, last) == (1, None)
    }
    found: dict[tuple, list[_Stroke]] = {}
    for trace, first, last in pieces:
        source = ink.part_of.get(trace, trace)
        if source in whole:
            found[source, 1, None] = ink.strokes.get(source, [])
        elif trace in ink.lengths:
            found[source, first, last] = _part(ink, trace, first, last)
    return [stroke for strokes in found.values() for stroke in strokes]


def _part(ink: _Ink, trace: Element, first: int, last: int | None) -> list[_Stroke]:
    """Some points of a trace."""
    length = ink.lengths[trace]
    last = length if last is None else last
    if trace in ink.continued:
        raise RecordingError(
            "has a view of a part of a trace that is continued by another one; view the whole of it."
        )
    if not 1 <= first <= last <= length:
        raise RecordingError(
            f"has a view of the points {first} to {last} of a trace of {length}; mend it."
        )
    kept = [
        (stroke, (stroke.number >= first) & (stroke.number <= last))
        for stroke in ink.strokes[trace]
    ]
    return [stroke.part(inside) for stroke, inside in kept if inside.any()]


def _letter(
    root: Element, group: Element, strokes: list[_Stroke], scale: float, press: float
) -> Recording:
    """One letter from its strokes."""
    with np.errstate(all="ignore"):
        points = [stroke.xy * scale for stroke in strokes]
    check_size(points)
    forced = all(stroke.force is not None for stroke in strokes)
    rows = [
        np.column_stack([xy, *([s.force / press] if forced else [])])
        for xy, s in zip(points, strokes, strict=True)
    ]
    if any(stroke.t is None for stroke in strokes):
        laid = [(stroke.t, stroke.position) for stroke in in_time(rows)]
    else:
        laid = one_clock([(stroke.t, row) for stroke, row in zip(strokes, rows, strict=True)])
    origin, baseline = (
        lengths_in_mm(annotation(root, (name,)), count)
        for name, count in (("origin", 2), ("baseline", 1))
    )
    label = annotation(group, LABELS)
    return flat_recording(
        [Trajectory(t, row[:, :2]) for t, row in laid],
        [row[:, 2] for _, row in laid] if forced else None,
        origin,
        character=label_from(label) if origin is None else own_label(label),
        writer=pseudonym_from(annotation(group, ("writer",)) or annotation(root, ("writer",))),
        baseline=None if baseline is None or origin is None else float(baseline[0]),
    )


FORMAT = Format("InkML", (".inkml",), partial(has_root, tag="ink"), read_inkml, write_inkml)
