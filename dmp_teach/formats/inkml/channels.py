"""What the channels of an InkML file mean: where, when and how hard the pen pressed, in SI units.

The channels stand in a `traceFormat`, which a trace finds through the contexts that it refers to,
the last context before it, and at last the first format of the file; where the file says nothing
there are X and Y. A channel with a resolution (`channelProperty`, such as 1000 to 1/cm) counts in
steps of the device if it has whole numbers or the unit `dev`; else its own unit holds. Y points
down, as on every tablet, unless its orientation is -ve.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import finite_number, local_tag
from dmp_teach.formats.units import METRES, SECONDS
from dmp_teach.trajectory import Array

ID = "{http://www.w3.org/XML/1998/namespace}id"
PARTS = ("traceFormat", "inkSource", "canvasTransform", "context")
STEPS = re.compile(r"(?:1|dev|points?|counts?)/([a-zµ]{1,10})")
PEN_STEP = (0.0002, 1.0)  # from point to point, of all pens [s]
MOST_CHANNELS = 64
MOST_PARTS = 64  # contexts and sources that refer to one another
InkContext = tuple[Element | str, ...]
"""Contexts, or references to them, the nearest first."""


class TraceFormat:
    """What the values of a trace mean, as a `traceFormat` and an `inkSource` say."""

    def __init__(self, form: Element | None, source: Element | None) -> None:
        channels = [Element("channel", name=name) for name in "XY"]
        if form is not None:
            channels = [each for each in form.iter() if local_tag(each) == "channel"]
        names = [each.get("name") or "" for each in channels]
        few = len(names) <= MOST_CHANNELS and len(set(names)) == len(names)
        if not few or not {"X", "Y"} <= set(names):
            raise RecordingError(
                f"has the channels {', '.join(names[:MOST_CHANNELS]) or 'none'}, but must have X "
                f"and Y, each name once, and at most {MOST_CHANNELS}."
            )
        self.channels = dict(zip(names, channels, strict=True))
        self.rate = None  # how often the device looked [1/s]
        steps = {}
        for each in source.iter() if source is not None else ():
            value, unit = finite_number(each.get("value")) or 0.0, each.get("units") or ""
            match = STEPS.fullmatch(unit.strip().lower())
            known = (METRES | SECONDS).get(match[1]) if match else None
            if each.get("name") == "resolution" and known and value > 0:
                steps[each.get("channel")] = known / value
            if local_tag(each) == "sampleRate" and 0.1 <= value <= 1e5:
                self.rate = self.rate or value
        # Metres or seconds in a unit of a channel.
        self._scales = {}
        for name in {"X", "Y", "T", "F"} & {*names}:
            channel = self.channels[name]
            refuse_mapping(channel, f"channel {name!r}")
            unit = (channel.get("units") or "").strip().lower()
            self._scales[name] = (SECONDS if name == "T" else METRES).get(unit)
            if name in steps and (not self._scales[name] or channel.get("type") == "integer"):
                self._scales[name] = steps[name]

    def column(self, values: Array, name: str) -> Array | None:
        """Return the values (K,) of one channel from those of all, (K, C); None without any."""
        if name not in self.channels:
            return None
        found = values[:, list(self.channels).index(name)]
        return None if np.isnan(found).all() else found

    def times(self, values: Array, offset: str | None) -> Array | None:
        """Return when the pen was at points (K, C), shape (K,) [s]; None where nothing tells it.

        Raises:
            RecordingError: No unit, and milliseconds would be too slow for any pen.
        """
        begin, t = 0.001 * (finite_number(offset) or 0.0), self.column(values, "T")
        if t is not None and (len(t) == 1 or np.ptp(t[np.isfinite(t)]) > 0):
            return begin + t * (self._scales["T"] or _usual_time_unit(t))
        return None if self.rate is None else begin + np.arange(len(values)) / self.rate

    def on_page(self, values: Array) -> tuple[Array, bool]:
        """Return where points are on the page (K, 2), y up, and whether that is in metres."""
        x, y = self._scales["X"], self._scales["Y"]
        columns = [list(self.channels).index(name) for name in "XY"]
        turned = [self.channels[name].get("orientation") == "-ve" for name in "XY"]
        signs = [-1 if turned[0] else 1, 1 if turned[1] else -1]
        return values[:, columns] * [x or y or 1.0, y or x or 1.0] * signs, bool(x or y)

    def pressure(self, values: Array) -> Array | None:
        """Return the pressure (K,): 0 to 1 where the file says what the device can tell."""
        force = self.column(values, "F")
        if force is None:
            return None
        low, high = (finite_number(self.channels["F"].get(end)) for end in ("min", "max"))
        low = low or 0.0
        if high is not None and high > low:
            force = np.minimum((force - low) / (high - low), 1.0)
        return np.nan_to_num(np.maximum(force, 0.0), nan=0.0, posinf=1.0)


class Contexts:
    """The formats that the traces of a file refer to."""

    def __init__(self, root: Element) -> None:
        every = list(root.iter())
        self._named = {key: each for each in every for key in (each.get(ID), each.get("id")) if key}
        self._first = [each for each in every if local_tag(each) in PARTS[:2]]
        self._read: dict[InkContext, TraceFormat] = {}

    def format_of(self, contexts: InkContext) -> TraceFormat:
        """Return the format that holds in contexts."""
        if contexts not in self._read:
            found: dict[str, Element] = {}
            chain = [self.named(each) if isinstance(each, str) else each for each in contexts]
            parts = [part for context in chain for part in self._parts(context)]
            for part in [*parts, *self._first]:
                found.setdefault(local_tag(part), part)
            refuse_mapping(found.get("canvasTransform"), "its canvasTransform")
            self._read[contexts] = TraceFormat(found.get("traceFormat"), found.get("inkSource"))
        return self._read[contexts]

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

    def _parts(self, element: Element) -> Iterator[Element]:
        """Yield the element and all that it holds or refers to, the nearest first."""
        queue = [element]
        for each in queue:
            yield each
            queue += [child for child in each if local_tag(child) in PARTS]
            references = [each.get(f"{name}Ref") for name in PARTS]
            queue += [self.named(reference) for reference in references if reference]
            del queue[MOST_PARTS:]


def _usual_time_unit(t: Array) -> float:
    """Return the seconds in a unit of times (K,) without one: ms, or s where no pen is so fast."""
    step = float(np.nanmedian(np.diff(t))) if len(t) > 2 else 1.0
    if step * 0.001 > PEN_STEP[1]:
        raise RecordingError(
            f"has points {step:.4g} apart in channel T, which says no unit, and would be "
            "milliseconds; give it its unit, such as units='us'."
        )
    return 1.0 if 0 < step * 0.001 < PEN_STEP[0] else 0.001


def tells_channels(context: Element) -> bool:
    """Tell whether a context says what its traces mean; one that only has a brush does not."""
    said = any(local_tag(child) in PARTS for child in context)
    return said or any(context.get(f"{name}Ref") for name in PARTS)


def refuse_mapping(holder: Element | None, what: str) -> None:
    """Raise a RecordingError where a mapping would change something."""
    for mapping in holder if holder is not None else ():
        kind = (mapping.get("type") or "").strip().lower()
        if local_tag(mapping) == "mapping" and kind not in ("identity", "unknown"):
            raise RecordingError(
                f"has a mapping for {what}, which is not followed here; save the ink with its "
                "mapping applied."
            )
