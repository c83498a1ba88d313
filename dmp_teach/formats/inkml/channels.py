"""What the channels of an InkML file mean: where, when and how hard the pen pressed, in SI units.

The channels stand in a `traceFormat`, which a trace finds through its context and that one's ink
source; a context that says nothing of them inherits the one before it, and where the file says
nothing there are X and Y. A channel with a resolution (`channelProperty`, such as 1000 to 1/cm)
counts in steps of the device if it has whole numbers or the unit `dev`; else its own unit holds. Y
points down, as on every tablet, unless its orientation is -ve.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.etree.ElementTree import Element

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
MOST_CHANNELS = 64
MOST_PARTS = 64  # contexts and sources that refer to one another


@dataclass(frozen=True)
class Channel:
    """One channel of a trace format.

    Args:
        name: "X", "Y", "T", "F", "S" and others.
        is_regular: Whether every point has a value of it.
        scale: From its unit to metres or seconds; None where the file does not say.
        sign: -1 where it grows to the left or down the page, else 1.
        low: The least value that the device can tell, or None.
        high: The largest, or None.
    """

    name: str
    is_regular: bool = True
    scale: float | None = None
    sign: int = 1
    low: float | None = None
    high: float | None = None


@dataclass(frozen=True)
class TraceFormat:
    """What the values of a trace mean.

    Args:
        channels: In their order, by their names; X and Y are among them.
        rate: How often the device looked [1/s]; None where the file does not say.
    """

    channels: dict[str, Channel]
    rate: float | None = None

    def column(self, values: Array, name: str) -> Array | None:
        """Return the values (K,) of one channel from those of all, (K, C); None without it."""
        return values[:, list(self.channels).index(name)] if name in self.channels else None

    def on_page(self, values: Array) -> tuple[Array, bool]:
        """Return where points are on the page (K, 2), y up, and whether that is in metres."""
        x, y = self.channels["X"], self.channels["Y"]
        names = list(self.channels)
        points = values[:, [names.index("X"), names.index("Y")]]
        scales = [x.scale or y.scale or 1.0, y.scale or x.scale or 1.0]
        return points * scales * [x.sign, y.sign], x.scale is not None or y.scale is not None


class Contexts:
    """The formats that the traces of a file refer to."""

    def __init__(self, root: Element) -> None:
        self._named = {f"Default{kind[0].upper()}{kind[1:]}": Element(kind) for kind in PARTS}
        self._named["DefaultContext"].append(_x_and_y())
        self._named["DefaultTraceFormat"].extend(_x_and_y())
        for each in root.iter():
            self._named |= {key: each for key in (each.get(ID), each.get("id")) if key}
        contexts = [each for each in root.iter() if local_tag(each) == "context"]
        loose = [each for each in root if local_tag(each) in ("traceFormat", "inkSource")]
        self._usual = [*(contexts if len(contexts) == 1 else ()), *loose]
        self._read: dict[tuple[int, ...], TraceFormat] = {}

    def format_of(self, contexts: Sequence[Element | str]) -> TraceFormat:
        """Return the format that holds in contexts, or references to them, the nearest first."""
        nearest = [self.named(each) if isinstance(each, str) else each for each in contexts]
        chain = tuple({id(each): each for each in (*nearest, *self._usual)}.values())
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
        """Return what contexts, an ink source or a trace format say."""
        found: dict[str, Element] = {}
        for each in chain:
            for part in self._parts(each):
                found.setdefault(local_tag(part), part)
            if "traceFormat" in found:
                break
        _refuse_mapping(found.get("canvasTransform"), "its canvasTransform")
        source = found.get("inkSource")
        channels = _channels(found.get("traceFormat", _x_and_y()), source)
        return TraceFormat(channels, _rate(source))

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


def tells_channels(context: Element) -> bool:
    """Tell whether a context says what its traces mean; one that only has a brush does not."""
    said = any(local_tag(child) in PARTS for child in context)
    return said or any(context.get(f"{name}Ref") for name in PARTS)


def _x_and_y() -> Element:
    """Return the format that holds where a file says nothing."""
    form = Element("traceFormat")
    form.extend(Element("channel", {"name": name}) for name in "XY")
    return form


def _channels(form: Element, source: Element | None) -> dict[str, Channel]:
    """Return the channels of a trace format: the regular ones, then those that may be left out."""
    regular = [each for each in form if local_tag(each) == "channel"]
    others: list[Element] = []
    for each in form:
        regular += each if local_tag(each) == "regularChannels" else ()
        others += each if local_tag(each) == "intermittentChannels" else ()
    if len(regular) + len(others) > MOST_CHANNELS:
        raise RecordingError(
            f"has {len(regular) + len(others)} channels, but a pen has at most {MOST_CHANNELS}."
        )
    steps, area = _resolutions(source), _active_area(source)
    channels = [_channel(each, True, steps, area) for each in regular]
    channels += [_channel(each, False, steps, area) for each in others]
    found = {channel.name: channel for channel in channels}
    if len(found) < len(channels) or not {"X", "Y"} <= found.keys():
        raise RecordingError(
            f"has the channels {', '.join(each.name for each in channels) or 'none'}, but must "
            "have X and Y, each name once."
        )
    return found


def _channel(
    element: Element, is_regular: bool, steps: dict[str, float], area: dict[str, float]
) -> Channel:
    """Return one channel, its unit worked out."""
    name, unit = element.get("name") or "", (element.get("units") or "").strip().lower()
    low, high = finite_number(element.get("min")), finite_number(element.get("max"))
    scale = METRES.get(unit) if name in ("X", "Y") else SECONDS.get(unit) if name == "T" else None
    if name in steps and (scale is None or element.get("type") == "integer"):
        scale = steps[name]
    if scale is None and name in area and high is not None and high > (low or 0.0):
        scale = area[name] / (high - (low or 0.0))
    if name == "F" and unit == "%":
        low, high = 0.0, 100.0
    if name in ("X", "Y", "T", "F"):
        _refuse_mapping(element, f"channel {name!r}")
    sign = -1 if (element.get("orientation") == "-ve") != (name == "Y") else 1
    return Channel(name, is_regular, scale, sign, low, high)


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


def _active_area(source: Element | None) -> dict[str, float]:
    """Return how large the area is that the device looks at [m], by channel."""
    found: dict[str, float] = {}
    for each in source if source is not None else ():
        unit = METRES.get((each.get("units") or "").strip().lower())
        for name, side in (("X", "width"), ("Y", "height")):
            size = finite_number(each.get(side))
            if local_tag(each) == "activeArea" and unit and size and size > 0:
                found[name] = size * unit
    return found


def _rate(source: Element | None) -> float | None:
    """Return how often the device looked [1/s]; None where the file does not say."""
    for each in source if source is not None else ():
        value = finite_number(each.get("value"))
        if local_tag(each) == "sampleRate" and value is not None and 0.1 <= value <= 1e5:
            return value
    return None
