"""What the channels of an InkML file mean: where, when and how hard the pen pressed, in SI units.

The channels stand in a `traceFormat`, which a trace finds through the contexts that it refers to,
the last context before it, and at last the first format of the file; where the file says nothing
there are X and Y. A channel with a resolution (`channelProperty`, such as 1000 to 1/cm) counts in
steps of the device if it has whole numbers or the unit `dev`; else its own unit holds. Y points
down, as on every tablet, unless its orientation is -ve.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag
from dmp_teach.trajectory import Array

ID = "{http://www.w3.org/XML/1998/namespace}id"
METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "µm": 1e-6, "himetric": 1e-5}
METRES |= {"in": 0.0254, "pt": 0.0254 / 72, "pc": 0.0254 / 6}
METRES |= dict.fromkeys(("px", "pixel", "pixels"), 0.0254 / 96)
SECONDS = {"s": 1.0, "ms": 0.001, "us": 1e-6, "µs": 1e-6, "ns": 1e-9, "min": 60.0}
PARTS = ("traceFormat", "inkSource", "canvasTransform", "context")
STEPS = re.compile(r"(?:1|dev|points?|counts?)/([a-zµ]{1,10})")
SHORTEST_STEP = 0.0002  # no pen is looked at more often: such times are no milliseconds [s]
LONGEST_STEP = 1.0  # nor so seldom [s]
MOST_CHANNELS = 64
MOST_PARTS = 64  # contexts and sources that refer to one another


@dataclass(frozen=True)
class Channel:
    """One channel of a trace format.

    Args:
        column: Which of a point's values it is, from 0.
        scale: From its unit to metres or seconds; None where the file does not say.
        sign: -1 where it grows to the left or down the page, else 1.
        low: The least value that the device can tell, or None.
        high: The largest, or None.
    """

    column: int
    scale: float | None = None
    sign: int = 1
    low: float | None = None
    high: float | None = None


@dataclass(frozen=True)
class TraceFormat:
    """What the values of a trace mean.

    Args:
        channels: By their names: "X", "Y", "T", "F", "S" and others; X and Y are among them.
        rate: How often the device looked [1/s]; None where the file does not say.
    """

    channels: dict[str, Channel]
    rate: float | None = None

    def column(self, values: Array, name: str) -> Array | None:
        """Return the values (K,) of one channel from those of all, (K, C); None without any."""
        found = values[:, self.channels[name].column] if name in self.channels else values[:0, 0]
        return None if np.isnan(found).all() else found

    def times(self, values: Array, offset: str | None) -> Array | None:
        """Return when the pen was at points (K, C), shape (K,) [s]; None where nothing tells it.

        Raises:
            RecordingError: No unit, and milliseconds would be too slow for any pen.
        """
        begin, t = 0.001 * (finite_number(offset) or 0.0), self.column(values, "T")
        if t is not None and (len(t) == 1 or np.ptp(t[np.isfinite(t)]) > 0):
            return begin + t * (self.channels["T"].scale or _usual_time_unit(t))
        return None if self.rate is None else begin + np.arange(len(values)) / self.rate

    def on_page(self, values: Array) -> tuple[Array, bool]:
        """Return where points are on the page (K, 2), y up, and whether that is in metres."""
        x, y = self.channels["X"], self.channels["Y"]
        scales = [x.scale or y.scale or 1.0, y.scale or x.scale or 1.0]
        points = values[:, [x.column, y.column]] * scales * [x.sign, y.sign]
        return points, x.scale is not None or y.scale is not None


class Contexts:
    """The formats that the traces of a file refer to."""

    def __init__(self, root: Element) -> None:
        self._root = root
        self._named = {
            key: each for each in root.iter() for key in (each.get(ID), each.get("id")) if key
        }
        self._read: dict[tuple[int, ...], TraceFormat] = {}

    def format_of(self, contexts: Sequence[Element | str]) -> TraceFormat:
        """Return the format that holds in contexts, or references to them, the nearest first."""
        chain = [self.named(each) if isinstance(each, str) else each for each in contexts]
        key = tuple(map(id, chain))
        if key not in self._read:
            self._read[key] = self._format(chain)
        return self._read[key]

    def named(self, reference: str) -> Element:
        """Return the element that a reference such as "#ctx0" means.

        Raises:
            RecordingError: There is none, or it is in another file: nothing is fetched.
        """
        name = reference.removeprefix("#")
        if name not in self._named:
            raise RecordingError(
                f"refers to {reference[:60]!r}, which is not in it; nothing is fetched from "
                "elsewhere."
            )
        return self._named[name]

    def _format(self, chain: Sequence[Element]) -> TraceFormat:
        """Return what contexts say, and what they leave out from the first ones of the file."""
        found: dict[str, Element] = {}
        for context in chain:
            for part in self._parts(context):
                found.setdefault(local_tag(part), part)
        for part in self._root.iter():
            if local_tag(part) in ("traceFormat", "inkSource"):
                found.setdefault(local_tag(part), part)
        _refuse_mapping(found.get("canvasTransform"), "its canvasTransform")
        source = found.get("inkSource")
        return TraceFormat(_channels(found.get("traceFormat"), source), _rate(source))

    def _parts(self, element: Element) -> Iterator[Element]:
        """Yield the element and all that it holds or refers to, the nearest first."""
        queue, seen = [element], 0
        while queue and seen < MOST_PARTS:
            each = queue.pop(0)
            seen += 1
            yield each
            queue += [child for child in each if local_tag(child) in PARTS]
            references = [each.get(f"{name}Ref") for name in PARTS]
            queue += [self.named(reference) for reference in references if reference]


def _usual_time_unit(t: Array) -> float:
    """Return the seconds in a unit of times (K,) without one: ms, or s where no pen is so fast."""
    step = float(np.nanmedian(np.diff(t))) if len(t) > 2 else 1.0
    if step * 0.001 > LONGEST_STEP:
        raise RecordingError(
            f"has points {step:.4g} apart in channel T, which says no unit, and would be "
            "milliseconds; give it its unit, such as units='us'."
        )
    return 1.0 if 0 < step * 0.001 < SHORTEST_STEP else 0.001


def tells_channels(context: Element) -> bool:
    """Tell whether a context says what its traces mean; one that only has a brush does not."""
    said = any(local_tag(child) in PARTS for child in context)
    return said or any(context.get(f"{name}Ref") for name in PARTS)


def _channels(form: Element | None, source: Element | None) -> dict[str, Channel]:
    """Return the channels of a trace format: the regular ones, then those that may be left out."""
    if form is None:
        return {"X": Channel(0), "Y": Channel(1, sign=-1)}
    others = [each for part in form for each in part if local_tag(part) != "channel"]
    elements = [each for each in [*form, *others] if local_tag(each) == "channel"]
    names = [each.get("name") or "" for each in elements]
    if len(set(names)) < len(names) or not {"X", "Y"} <= set(names) or len(names) > MOST_CHANNELS:
        raise RecordingError(
            f"has the channels {', '.join(names[:MOST_CHANNELS]) or 'none'}, but must have X and "
            f"Y, each name once, and at most {MOST_CHANNELS}."
        )
    steps = _resolutions(source)
    return {name: _channel(elements[k], k, steps) for k, name in enumerate(names)}


def _channel(element: Element, column: int, steps: dict[str, float]) -> Channel:
    """Return one channel, its unit worked out."""
    name, unit = element.get("name") or "", (element.get("units") or "").strip().lower()
    scale = METRES.get(unit) if name in ("X", "Y") else SECONDS.get(unit) if name == "T" else None
    if name in steps and (scale is None or element.get("type") == "integer"):
        scale = steps[name]
    if name in ("X", "Y", "T", "F"):
        _refuse_mapping(element, f"channel {name!r}")
    sign = -1 if (element.get("orientation") == "-ve") != (name == "Y") else 1
    low, high = finite_number(element.get("min")), finite_number(element.get("max"))
    return Channel(column, scale, sign, low, high)


def _refuse_mapping(holder: Element | None, what: str) -> None:
    """Raise a RecordingError where a mapping would change something."""
    for mapping in holder if holder is not None else ():
        kind = (mapping.get("type") or "").strip().lower()
        if local_tag(mapping) == "mapping" and kind not in ("identity", "unknown"):
            raise RecordingError(
                f"has a mapping for {what}, which is not followed here; save the ink with its "
                "mapping applied."
            )


def _resolutions(source: Element | None) -> dict[str, float]:
    """Return the metres or seconds in one step of the device, by channel."""
    found: dict[str, float] = {}
    for each in source.iter() if source is not None else ():
        match = STEPS.fullmatch((each.get("units") or "").strip().lower())
        if local_tag(each) == "channelProperty" and each.get("name") == "resolution" and match:
            unit, value = (METRES | SECONDS).get(match[1]), finite_number(each.get("value"))
            if unit and value and value > 0:
                found[each.get("channel") or ""] = unit / value
    return found


def _rate(source: Element | None) -> float | None:
    """Return how often the device looked [1/s]; None where the file does not say."""
    for each in source if source is not None else ():
        value = finite_number(each.get("value"))
        if local_tag(each) == "sampleRate" and value is not None and 0.1 <= value <= 1e5:
            return value
    return None
