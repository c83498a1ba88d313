"""What the channels of an InkML file mean: where the pen was, when, and how hard it pressed, in SI units.

The channels stand in a `traceFormat`, which a trace finds through its context and that one's ink source; a context that
says nothing of them inherits the one before it, and where nobody says anything there are X and Y. A channel with a
resolution (`channelProperty`, such as 1000 to 1/cm) counts in steps of the device if it has whole numbers or the unit
`dev`; else its own unit holds. Y points down, as on every tablet, unless its orientation is -ve.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.formats.inkml.mappings import Named, canvas_matrix, channel_line
from dmp_teach.formats.safe_xml import finite_number, local_tag
from dmp_teach.trajectory import Array

ID = "{http://www.w3.org/XML/1998/namespace}id"
METRES = {
    "m": 1.0,
    "dm": 0.1,
    "cm": 0.01,
    "mm": 0.001,
    "um": 1e-6,
    "µm": 1e-6,
    "himetric": 1e-5,
    "in": 0.0254,
}
METRES |= {
    "pt": 0.0254 / 72,
    "pc": 0.0254 / 6,
    "px": 0.0254 / 96,
    "pixel": 0.0254 / 96,
    "pixels": 0.0254 / 96,
}
SECONDS = {"s": 1.0, "ms": 0.001, "us": 1e-6, "µs": 1e-6, "ns": 1e-9, "min": 60.0}
PARTS = ("traceFormat", "inkSource", "canvasTransform", "context")
DEFAULTS = (*PARTS, "canvas")
MOST = 64  # channels in a format, and contexts that refer to one another


@dataclass(frozen=True)
class Channel:
    """One channel of a format.

    Args:
        name: "X", "Y", "T", "F", "S" and others.
        regular: Whether every point has a value of it.
        scale: What a value is multiplied with to come to metres or seconds; None where the file does not say.
        sign: -1 where it grows to the left or down the page, else 1.
        low: The least value that the device can tell, or None.
        high: The largest, or None.
        line: A factor and what is added, which the value goes through first (`inkml_mappings`).
    """

    name: str
    regular: bool
    scale: float | None
    sign: int
    low: float | None
    high: float | None
    line: tuple[float, float] = (1.0, 0.0)


@dataclass(frozen=True)
class TraceFormat:
    """What the values of a trace mean.

    Args:
        channels: In their order.
        rate: How often the device looked [1/s]; None where the file does not say.
        canvas: From X and Y to the canvas that they are drawn on, shape (2, 3); None where it is as they are.
        page: The two channels whose units and directions hold on that canvas; none: those of the trace.
    """

    channels: tuple[Channel, ...]
    rate: float | None = None
    canvas: Array | None = None
    page: tuple[Channel, Channel] | None = None

    def find(self, name: str) -> Channel | None:
        """The channel of that name."""
        return next((channel for channel in self.channels if channel.name == name), None)

    def on_page(self, values: Array) -> tuple[Array, bool]:
        """Where points (K, 2), X and Y, are on the page, y up; and whether that is in metres."""
        if self.canvas is not None:
            values = values @ self.canvas[:, :2].T + self.canvas[:, 2]
        x, y = self.page or (self.find("X"), self.find("Y"))
        scale = [x.scale or y.scale or 1.0, y.scale or x.scale or 1.0]
        return values * scale * [x.sign, y.sign], x.scale is not None or y.scale is not None


class Contexts:
    """The formats that the traces of a file refer to."""

    def __init__(self, root: Element):
        self._named = {f"Default{kind[0].upper()}{kind[1:]}": Element(kind) for kind in DEFAULTS}
        self._named["DefaultContext"].append(_x_and_y())
        self._named["DefaultTraceFormat"].extend(_x_and_y())
        self._named |= {
            key: each for each in root.iter() for key in (each.get(ID), each.get("id")) if key
        }
        contexts = [each for each in root.iter() if local_tag(each) == "context"]
        loose = [each for each in root if local_tag(each) in ("traceFormat", "inkSource")]
        self._usual = [*(contexts if len(contexts) == 1 else ()), *loose]
        self._read: dict[tuple[int, ...], TraceFormat] = {}

    def of(self, contexts: Sequence[Element]) -> TraceFormat:
        """The format that holds in a context; what it does not say is said by the next one, or by the file."""
        chain = tuple({id(each): each for each in (*contexts, *self._usual)}.values())
        key = tuple(map(id, chain))
        if key not in self._read:
            self._read[key] = self._format(chain)
        return self._read[key]

    def named(self, reference: str | None) -> Element | None:
        """The element that a reference such as "#ctx0" means.

        Raises:
            RecordingError: There is none, or it is in another file: nothing is fetched.
        """
        if not reference:
            return None
        name = reference.removeprefix("#")
        if name not in self._named:
            raise RecordingError(
                f"refers to {reference[:60]!r}, which is not in it; nothing is fetched from elsewhere."
            )
        return self._named[name]

    def _format(self, chain: Sequence[Element]) -> TraceFormat:
        """What contexts, an ink source or a trace format say."""
        parts: list[Element] = []
        for each in chain:
            parts += self._parts(each)
            if any(local_tag(part) == "traceFormat" for part in parts):
                break
        found = {local_tag(each): each for each in reversed(parts)}
        source = found.get("inkSource")
        channels = tuple(_channels(found.get("traceFormat", _x_and_y()), source, self.named))
        canvas = canvas_matrix(found.get("canvasTransform"), self.named)
        if canvas is None:
            return TraceFormat(channels, _rate(source))
        return TraceFormat(channels, _rate(source), canvas, self._page(parts))

    def _page(self, parts: Sequence[Element]) -> tuple[Channel, Channel] | None:
        """The channels X and Y of the canvas that the nearest context names; None where it says nothing of them."""
        for part in parts:
            canvas = next((each for each in part if local_tag(each) == "canvas"), None)
            canvas = self.named(part.get("canvasRef")) if canvas is None else canvas
            form = None if canvas is None else self.named(canvas.get("traceFormatRef"))
            for each in canvas if canvas is not None else ():
                form = each if local_tag(each) == "traceFormat" else form
            if form is not None:
                channels = {channel.name: channel for channel in _channels(form, None, self.named)}
                return channels["X"], channels["Y"]
        return None

    def _parts(self, element: Element) -> Iterator[Element]:
        """The element and all that it holds or refers to, the nearest first."""
        queue, seen = [element], 0
        while queue and seen < MOST:
            each = queue.pop(0)
            seen += 1
            yield each
            queue += [child for child in each if local_tag(child) in PARTS]
            for name in ("traceFormatRef", "inkSourceRef", "canvasTransformRef", "contextRef"):
                if (other := self.named(each.get(name))) is not None:
                    queue.append(other)


def speaks(context: Element) -> bool:
    """Whether a context says anything of what its traces mean; one that only has a brush does not."""
    said = any(local_tag(child) in PARTS for child in context)
    return said or any(context.get(f"{name}Ref") for name in PARTS)


def _x_and_y() -> Element:
    """The format that holds where a file says nothing."""
    form = Element("traceFormat")
    form.extend(Element("channel", {"name": name}) for name in "XY")
    return form


def _channels(form: Element, source: Element | None, named: Named) -> list[Channel]:
    """The channels of a trace format: the regular ones, then those that may be left out."""
    regular = [each for each in form if local_tag(each) == "channel"]
    holder = [
        each for each in form if local_tag(each) in ("intermittentChannels", "regularChannels")
    ]
    regular += [each for part in holder if local_tag(part) == "regularChannels" for each in part]
    others = [each for part in holder if local_tag(part) == "intermittentChannels" for each in part]
    if len(regular) + len(others) > MOST:
        raise RecordingError(
            f"has {len(regular) + len(others)} channels, but a pen has at most {MOST}."
        )
    steps, area = _resolutions(source), _area(source)
    channels = [_channel(each, True, steps, area, named) for each in regular]
    channels += [_channel(each, False, steps, area, named) for each in others]
    names = [channel.name for channel in channels]
    if len(set(names)) < len(names) or not {"X", "Y"} <= set(names):
        raise RecordingError(
            f"has the channels {', '.join(names) or 'none'}, but must have X and Y, each name once."
        )
    return channels


def _channel(
    element: Element, regular: bool, steps: dict[str, float], area: dict[str, float], named: Named
) -> Channel:
    """One channel, its unit worked out."""
    name, unit = element.get("name") or "", (element.get("units") or "").strip().lower()
    low, high = finite_number(element.get("min")), finite_number(element.get("max"))
    scale = METRES.get(unit) if name in ("X", "Y") else SECONDS.get(unit) if name == "T" else None
    if name in steps and (scale is None or element.get("type") == "integer"):
        scale = steps[name]
    if scale is None and name in area and high is not None and high > (low or 0.0):
        scale = area[name] / (high - (low or 0.0))
    sign = -1 if (element.get("orientation") == "-ve") != (name == "Y") else 1
    if scale is None and unit == "%" and name == "F":
        low, high = 0.0, 100.0
    line = channel_line(element, named) if name in ("X", "Y", "T", "F") else (1.0, 0.0)
    return Channel(name, regular, scale, sign, low, high, line)


def _resolutions(source: Element | None) -> dict[str, float]:
    """Metres or seconds in one step of the device, by channel."""
    found = {}
    for each in source.iter() if source is not None else ():
        match = re.fullmatch(
            r"(?:1|dev|points?|counts?)/([a-zµ]{1,10})", (each.get("units") or "").strip().lower()
        )
        if local_tag(each) == "channelProperty" and each.get("name") == "resolution" and match:
            unit = (METRES | SECONDS).get(match[1])
            value = finite_number(each.get("value"))
            if unit and value and value > 0:
                found[each.get("channel") or ""] = unit / value
    return found


def _area(source: Element | None) -> dict[str, float]:
    """How large the device's active area is [m]."""
    areas = (
        [each for each in source if local_tag(each) == "activeArea"] if source is not None else []
    )
    unit = METRES.get((areas[0].get("units") or "").strip().lower()) if areas else None
    sizes = (
        {"X": finite_number(areas[0].get("width")), "Y": finite_number(areas[0].get("height"))}
        if unit
        else {}
    )
    return {name: size * unit for name, size in sizes.items() if size and size > 0}


def _rate(source: Element | None) -> float | None:
    """How often the device looked [1/s]."""
    rates = (
        [each for each in source if local_tag(each) == "sampleRate"] if source is not None else []
    )
    value = finite_number(rates[0].get("value")) if rates else None
    return value if value is not None and 0.1 <= value <= 1e5 else None
