"""What the channels of an InkML file mean: where the pen was, when, and how hard it pressed, in SI units.

The channels stand in a `traceFormat`, which a trace finds through its context and that one's ink source. A channel with
a resolution (`channelProperty`, such as 1000 to 1/cm) counts in steps of the device if it has whole numbers or the unit
`dev`; else its own unit holds. Y points down, as on every tablet, unless its orientation is -ve.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from dmp_teach.errors import RecordingError
from dmp_teach.ink.markup import local, number_of

ID = "{http://www.w3.org/XML/1998/namespace}id"
METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "µm": 1e-6, "himetric": 1e-5, "in": 0.0254}
METRES |= {"pt": 0.0254 / 72, "pc": 0.0254 / 6, "px": 0.0254 / 96, "pixel": 0.0254 / 96, "pixels": 0.0254 / 96}
SECONDS = {"s": 1.0, "ms": 0.001, "us": 1e-6, "µs": 1e-6, "ns": 1e-9, "min": 60.0}
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
    """

    name: str
    regular: bool
    scale: float | None
    sign: int
    low: float | None
    high: float | None


@dataclass(frozen=True)
class Format:
    """The channels of a trace in their order, and how often the device looked [1/s] (None: not said)."""

    channels: tuple[Channel, ...]
    rate: float | None = None

    def find(self, name: str) -> Channel | None:
        """The channel of that name."""
        return next((channel for channel in self.channels if channel.name == name), None)


class Contexts:
    """The formats that the traces of a file refer to."""

    def __init__(self, root: Element):
        self._named = {key: each for each in root.iter() for key in (each.get(ID), each.get("id")) if key}
        contexts = [each for each in root.iter() if local(each) == "context"]
        loose = [each for each in root if local(each) in ("traceFormat", "inkSource")]
        self._usual = contexts if len(contexts) == 1 else loose[:1]
        self._read: dict[int, Format] = {}

    def of(self, context: Element | None) -> Format:
        """The format that holds in a context; None is what holds where a trace names none."""
        start = context if context is not None else next(iter(self._usual), None)
        if start is None:
            return Format((Channel("X", True, None, 1, None, None), Channel("Y", True, None, -1, None, None)))
        if id(start) not in self._read:
            self._read[id(start)] = self._format(start)
        return self._read[id(start)]

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

    def _format(self, start: Element) -> Format:
        """What a context, an ink source or a trace format says."""
        found = {local(each): each for each in reversed(list(self._parts(start)))}
        if "traceFormat" not in found:
            plain = '<traceFormat><channel name="X"/><channel name="Y"/></traceFormat>'
            raise RecordingError(f"has a context without a trace format; it needs one such as {plain}.")
        source = found.get("inkSource")
        return Format(tuple(_channels(found["traceFormat"], source)), _rate(source))

    def _parts(self, element: Element) -> Iterator[Element]:
        """The element and all that it holds or refers to, the nearest first."""
        queue, seen = [element], 0
        while queue and seen < MOST:
            each = queue.pop(0)
            seen += 1
            yield each
            queue += [child for child in each if local(child) in ("traceFormat", "inkSource", "context")]
            for name in ("traceFormatRef", "inkSourceRef", "contextRef"):
                if (other := self.named(each.get(name))) is not None:
                    queue.append(other)


def _channels(form: Element, source: Element | None) -> list[Channel]:
    """The channels of a trace format: the regular ones, then those that may be left out."""
    regular = [each for each in form if local(each) == "channel"]
    holder = [each for each in form if local(each) in ("intermittentChannels", "regularChannels")]
    regular += [each for part in holder if local(part) == "regularChannels" for each in part]
    others = [each for part in holder if local(part) == "intermittentChannels" for each in part]
    if len(regular) + len(others) > MOST:
        raise RecordingError(f"has {len(regular) + len(others)} channels, but a pen has at most {MOST}.")
    steps, area = _resolutions(source), _area(source)
    channels = [_channel(each, True, steps, area) for each in regular]
    channels += [_channel(each, False, steps, area) for each in others]
    names = [channel.name for channel in channels]
    if len(set(names)) < len(names) or not {"X", "Y"} <= set(names):
        raise RecordingError(f"has the channels {', '.join(names) or 'none'}, but must have X and Y, each name once.")
    return channels


def _channel(element: Element, regular: bool, steps: dict[str, float], area: dict[str, float]) -> Channel:
    """One channel, its unit worked out."""
    name, unit = element.get("name") or "", (element.get("units") or "").strip().lower()
    low, high = number_of(element.get("min")), number_of(element.get("max"))
    scale = METRES.get(unit) if name in ("X", "Y") else SECONDS.get(unit) if name == "T" else None
    if name in steps and (scale is None or element.get("type") == "integer"):
        scale = steps[name]
    if scale is None and name in area and high is not None and high > (low or 0.0):
        scale = area[name] / (high - (low or 0.0))
    sign = -1 if (element.get("orientation") == "-ve") != (name == "Y") else 1
    if scale is None and unit == "%" and name == "F":
        low, high = 0.0, 100.0
    return Channel(name, regular, scale, sign, low, high)


def _resolutions(source: Element | None) -> dict[str, float]:
    """Metres or seconds in one step of the device, by channel."""
    found = {}
    for each in source.iter() if source is not None else ():
        match = re.fullmatch(r"(?:1|dev|points?|counts?)/([a-zµ]{1,10})", (each.get("units") or "").strip().lower())
        if local(each) == "channelProperty" and each.get("name") == "resolution" and match:
            unit = (METRES | SECONDS).get(match[1])
            value = number_of(each.get("value"))
            if unit and value and value > 0:
                found[each.get("channel") or ""] = unit / value
    return found


def _area(source: Element | None) -> dict[str, float]:
    """How large the device's active area is [m]."""
    areas = [each for each in source if local(each) == "activeArea"] if source is not None else []
    unit = METRES.get((areas[0].get("units") or "").strip().lower()) if areas else None
    sizes = {"X": number_of(areas[0].get("width")), "Y": number_of(areas[0].get("height"))} if unit else {}
    return {name: size * unit for name, size in sizes.items() if size and size > 0}


def _rate(source: Element | None) -> float | None:
    """How often the device looked [1/s]."""
    rates = [each for each in source if local(each) == "sampleRate"] if source is not None else []
    value = number_of(rates[0].get("value")) if rates else None
    return value if value is not None and 0.1 <= value <= 1e5 else None
