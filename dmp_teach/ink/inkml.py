"""Digital ink as tablets and forms save it: InkML, a recommendation of the W3C (20 September 2011).

Channels are taken as the file declares them (`inkml_channels`), points as it abbreviates them (`inkml_points`). Each
trace that was written with the pen down is a stroke, a trace that continues another one is part of it, and points where
the tip switch S is off leave a gap. Groups of traces with a label of their own (an annotation `truth`, `label` or the
like) are letters of their own; a file without such groups is one letter. Times are those of channel T, or the device's
sample rate (`inkml_times`), or else a hand's (`pace`).
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink.flat import check_size, flat_recording, label_of, millimetres, own_label, usual_scale, writer_of
from dmp_teach.ink.inkml_channels import Channel, Contexts, Format
from dmp_teach.ink.inkml_points import MOST, points_of
from dmp_teach.ink.inkml_times import one_clock, times_of
from dmp_teach.ink.markup import local
from dmp_teach.ink.motion import runs
from dmp_teach.ink.pace import in_time
from dmp_teach.ink.recording import Recording
from dmp_teach.trajectory import Array, Trajectory

LABELS = ("truth", "label", "character", "symbol", "transcription", "text")


@dataclass
class _Stroke:
    """A stroke on its way: times or None, points, pressure or None, and whether the unit of the points is known."""

    t: Array | None
    xy: Array
    force: Array | None
    known: bool


@dataclass
class _Ink:
    """What is read of a file: the strokes of each trace, and the trace that a continued one is part of."""

    contexts: Contexts
    points: int = 0
    strokes: dict[Element, list[_Stroke]] = field(default_factory=dict)
    part_of: dict[Element, Element] = field(default_factory=dict)


def read_inkml(root: Element) -> tuple[Recording, ...]:
    """The letters of an InkML file.

    Args:
        root: The file's root element.

    Raises:
        RecordingError: No ink in it, a reference that leads nowhere, or a trace that cannot be.
    """
    ink = _Ink(Contexts(root))
    current: Element | str | None = None
    for element in root:
        current = element if local(element) == "context" else current
        for trace, context in _traces(element, current):
            _read(ink, trace, context)
    letters = [(group, strokes) for group in _groups(root) if (strokes := _strokes(ink, group))]
    if not letters:
        raise RecordingError("has no trace of a pen that was down, so there is no ink in it.")
    every = [stroke for _, strokes in letters for stroke in strokes]
    scale = 1.0
    if not all(stroke.known for stroke in every):
        scale = usual_scale([[stroke.xy for stroke in strokes] for _, strokes in letters])
    press = max([1.0, *(float(stroke.force.max()) for stroke in every if stroke.force is not None)])
    return tuple(_letter(root, group, strokes, scale, press) for group, strokes in letters)


def _traces(element: Element, context: Element | str | None) -> Iterator[tuple[Element, Element | str | None]]:
    """Every trace under an element, and the context, or the reference to one, that holds for it."""
    here = element.get("contextRef") or context
    if local(element) == "trace":
        yield element, here
    elif local(element) == "traceGroup":
        for child in element:
            yield from _traces(child, here)


def _read(ink: _Ink, trace: Element, context: Element | str | None) -> None:
    """Read one trace into the ink; a trace that continues another one becomes part of it."""
    text, number = "".join(trace.itertext()), len(ink.strokes) + len(ink.part_of)
    if trace.get("type", "penDown") != "penDown" or not text.strip():
        return
    try:
        form = ink.contexts.of(ink.contexts.named(context) if isinstance(context, str) else context)
        values = points_of(text, form, MOST - ink.points)
        strokes = _down(values, form, trace)
    except RecordingError as error:
        raise RecordingError(f"trace {number} {error}") from None
    ink.points += len(values)
    prior = ink.contexts.named(trace.get("priorRef")) if trace.get("continuation") in ("middle", "end") else None
    prior = ink.part_of.get(prior, prior)
    if prior in ink.strokes and ink.strokes[prior] and strokes:
        ink.part_of[trace] = prior
        ink.strokes[prior][-1:] = [_joined(ink.strokes[prior][-1], strokes[0]), *strokes[1:]]
    else:
        ink.strokes[trace] = strokes


def _joined(a: _Stroke, b: _Stroke) -> _Stroke:
    """One stroke of two parts."""
    t = None if a.t is None or b.t is None else np.concatenate([a.t, b.t])
    force = None if a.force is None or b.force is None else np.concatenate([a.force, b.force])
    return _Stroke(t, np.vstack([a.xy, b.xy]), force, a.known and b.known)


def _down(values: Array, form: Format, trace: Element) -> list[_Stroke]:
    """The strokes of one trace: its points whose place is known, cut where the tip is off the paper."""
    column = {channel.name: values[:, k] for k, channel in enumerate(form.channels)}
    x, y = form.find("X"), form.find("Y")
    across, down = x.scale or y.scale or 1.0, y.scale or x.scale or 1.0
    with np.errstate(all="ignore"):
        xy = np.column_stack([column["X"] * across * x.sign, column["Y"] * down * y.sign])
        t = times_of(column.get("T"), form, trace.get("timeOffset"), trace.get("duration"), len(xy))
    force = _pressure(column["F"], form.find("F")) if "F" in column else None
    seen = np.isfinite(xy).all(axis=1) & (True if t is None else np.isfinite(t))
    parts = runs(column["S"] != 0) if "S" in column else [(0, len(xy))]
    kept = [np.flatnonzero(seen[a:b]) + a for a, b in parts]
    known = x.scale is not None or y.scale is not None
    return [
        _Stroke(None if t is None else t[k], xy[k], None if force is None else force[k], known) for k in kept if len(k)
    ]


def _pressure(values: Array, channel: Channel) -> Array:
    """The pressure (K,): 0 to 1 where the file says how much the device can tell, else as it stands."""
    low = channel.low or 0.0
    with np.errstate(all="ignore"):
        if channel.high is not None and channel.high > low:
            values = np.minimum((values - low) / (channel.high - low), 1.0)
        return np.nan_to_num(np.maximum(values, 0.0), nan=0.0, posinf=1.0)


def _groups(root: Element) -> list[Element]:
    """The groups that are letters: the innermost ones with a label; the whole file where there is none."""
    labelled = [each for each in root.iter() if local(each) == "traceGroup" and _annotation(each, LABELS)]
    outer = {id(each) for each in labelled if any(_annotation(g, LABELS) for g in _inside(each))}
    return [each for each in labelled if id(each) not in outer] or [root]


def _inside(group: Element) -> Iterator[Element]:
    """The groups in a group."""
    return (each for each in group.iter() if local(each) == "traceGroup" and each is not group)


def _strokes(ink: _Ink, group: Element) -> list[_Stroke]:
    """The strokes of a group, those that it views by reference among them, each once."""
    found: dict[Element, list[_Stroke]] = {}
    for each in group.iter():
        views = local(each) == "traceView" and group is not None and local(group) == "traceGroup"
        trace = ink.contexts.named(each.get("traceDataRef")) if views else each
        trace = ink.part_of.get(trace, trace)
        found[trace] = ink.strokes.get(trace, [])
    return [stroke for strokes in found.values() for stroke in strokes]


def _letter(root: Element, group: Element, strokes: list[_Stroke], scale: float, press: float) -> Recording:
    """One letter from its strokes."""
    with np.errstate(all="ignore"):
        points = [stroke.xy * scale for stroke in strokes]
    check_size(points)
    forced = all(stroke.force is not None for stroke in strokes)
    rows = [
        np.column_stack([xy, *([s.force / press] if forced else [])]) for xy, s in zip(points, strokes, strict=True)
    ]
    if any(stroke.t is None for stroke in strokes):
        laid = [(stroke.t, stroke.position) for stroke in in_time(rows)]
    else:
        laid = one_clock([(stroke.t, row) for stroke, row in zip(strokes, rows, strict=True)])
    origin, baseline = (
        millimetres(_annotation(root, (name,)), count) for name, count in (("origin", 2), ("baseline", 1))
    )
    label = _annotation(group, LABELS)
    return flat_recording(
        [Trajectory(t, row[:, :2]) for t, row in laid],
        [row[:, 2] for _, row in laid] if forced else None,
        origin,
        character=label_of(label) if origin is None else own_label(label),
        writer=writer_of(_annotation(group, ("writer",)) or _annotation(root, ("writer",))),
        baseline=None if baseline is None or origin is None else float(baseline[0]),
    )


def _annotation(element: Element, kinds: tuple[str, ...]) -> str | None:
    """What an annotation of one of these types says, the first of them; None where there is none."""
    for each in element:
        if local(each) == "annotation" and (each.get("type") or "").lower() in kinds:
            return each.text or ""
    return None
