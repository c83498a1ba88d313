"""Write recordings: as JSON of ours, as InkML for other programs, as SVG for pen plotters; whole or not at all.

None of them has a place for a name, a date or a time of day: times begin at 0, and a writer is a pseudonym or absent.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from dmp_teach.errors import PathError, RecordingError, kind_of
from dmp_teach.files import write_whole
from dmp_teach.formats.flat_ink import check_place, check_size
from dmp_teach.ink import Recording, add_lifts, check_pseudonym, recording_to_json
from dmp_teach.trajectory import Trajectory

MARGIN = 0.005  # round the ink of a drawing [m]
PEN = 0.5  # how wide its lines are [mm]
NO_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def write_recording(ink: Recording | Iterable[Trajectory], path: str | os.PathLike[str]) -> Path:
    """Write a recording, or strokes such as those of `Letter.write`, into a file.

    `.json` keeps all of it, to the last bit. `.inkml` keeps the strokes, their times (to 1 us) and pressure, and places
    to 0.1 um; what the pen did in the air is left out. `.svg` keeps the strokes' shape and order, to 1 um, a path for
    each, in millimetres and unfilled, as pen plotters want it; read again, at a hand's pace, its sharp bends are cut by
    up to 0.1 mm. A label keeps every sign that XML can hold.

    Args:
        ink: A recording, or 2-D strokes on one clock [m].
        path: Where to; the end of its name says the format.

    Returns:
        The path.

    Raises:
        RecordingError: Neither a recording nor strokes, its writer is no pseudonym, or ink of a size or in a place that
            no reader would take for a letter; nothing is written then.
        PathError: Another end of the name, a missing folder, or a place that cannot be written.
    """
    recording = ink if isinstance(ink, Recording) else _recording(ink)
    check_pseudonym(recording.writer)
    suffix = Path(path).suffix.lower() if isinstance(path, str | os.PathLike) else ""
    if suffix not in FORMATS:
        raise PathError(
            f"The path is {path!r}, but its name must end with one of {', '.join(FORMATS)}."
        )
    if suffix != ".json":
        _check_flat(recording, suffix)
    return write_whole(path, FORMATS[suffix](recording).encode(), suffix)


def _recording(ink: Iterable[Trajectory]) -> Recording:
    """Strokes as a recording."""
    strokes = (
        (ink,) if isinstance(ink, Trajectory) else tuple(ink) if isinstance(ink, Iterable) else ()
    )
    if not strokes or not all(isinstance(stroke, Trajectory) for stroke in strokes):
        raise RecordingError(
            f"{kind_of(ink, first=True)} cannot be written as ink; give a Recording, or strokes (Trajectory)."
        )
    return add_lifts(strokes)


def _check_flat(recording: Recording, suffix: str) -> None:
    """Raise where the file could not be read again."""
    ink = [stroke.position for stroke in recording.strokes()]
    try:
        check_size(ink)
        check_place(np.concatenate(ink).min(axis=0), (0.0, 0.0))
    except RecordingError as error:
        raise RecordingError(
            f"This cannot be written as {suffix}: {error} A .json file keeps any ink."
        ) from None


def _inkml(recording: Recording) -> str:
    """A recording as InkML: X and Y in millimetres, Y down the page, T in milliseconds."""
    strokes = recording.strokes()
    pressed = recording.pressure is not None
    about = {"truth": recording.character, "writer": recording.writer, "origin": "0 0"}
    about["baseline"] = None if recording.baseline is None else f"{1000 * recording.baseline:.4f}"
    notes = [
        f"  <annotation type={quoteattr(kind)}>{_plain(text)}</annotation>"
        for kind, text in about.items()
        if text is not None
    ]
    force = ['      <channel name="F" type="decimal" min="0" max="1"/>'] if pressed else []
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<ink xmlns="http://www.w3.org/2003/InkML">',
        *notes,
        '  <context xml:id="pen">',
        "    <traceFormat>",
        '      <channel name="X" type="decimal" units="mm"/>',
        '      <channel name="Y" type="decimal" units="mm"/>',
        '      <channel name="T" type="decimal" units="ms"/>',
        *force,
        "    </traceFormat>",
        "  </context>",
    ]
    for stroke in strokes:
        columns = [stroke.position * [1000, -1000], 1000 * (stroke.t - recording.t[0])[:, None]]
        if pressed:
            columns.append(recording.pressure[np.searchsorted(recording.t, stroke.t)][:, None])
        form = " ".join(["{:.4f}", "{:.4f}", "{:.3f}", "{:.6f}"][: 3 + pressed])
        points = ", ".join(form.format(*row) for row in np.hstack(columns))
        lines.append(f'  <trace contextRef="#pen">{points}</trace>')
    return "\n".join([*lines, "</ink>", ""])


def _svg(recording: Recording) -> str:
    """A recording as a drawing: the page is the ink and a margin, y down."""
    strokes = recording.strokes()
    ink = np.concatenate([stroke.position for stroke in strokes])
    left, top = ink[:, 0].min() - MARGIN, ink[:, 1].max() + MARGIN
    wide, high = 1000 * (np.ptp(ink, axis=0) + 2 * MARGIN)
    line = "" if recording.baseline is None else f' data-baseline="{1000 * recording.baseline:.4f}"'
    labels = {"data-character": recording.character, "data-writer": recording.writer}
    line += "".join(
        f" {name}={quoteattr(_held(text))}" for name, text in labels.items() if text is not None
    )
    about = [
        _plain(recording.character or ""),
        f"by {recording.writer}" if recording.writer else "",
    ]
    title = " ".join(part for part in about if part)
    paths = []
    for number, stroke in enumerate(strokes, start=1):
        points = (stroke.position - [left, top]) * [1000, -1000]
        way = " ".join(f"{x:.3f},{y:.3f}" for x, y in points)
        paths.append(f'    <path id="stroke-{number}" d="M {way}"/>')
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.3f}mm" height="{high:.3f}mm"',
            f'    viewBox="0 0 {wide:.3f} {high:.3f}" data-origin="{-1000 * left:.4f} {1000 * top:.4f}"{line}>',
            *([f"  <title>{title}</title>"] if title else []),
            f'  <g fill="none" stroke="black" stroke-width="{PEN}" stroke-linecap="round" stroke-linejoin="round">',
            *paths,
            "  </g>",
            "</svg>",
            "",
        ]
    )


def _plain(text: str) -> str:
    """Text as XML has it between its elements."""
    return escape(_held(text), {"\r": "&#13;"})


def _held(text: str) -> str:
    """Text with a question mark for what XML cannot hold: most signs for machines, and halves of signs."""
    return NO_XML.sub("?", text)


FORMATS = {".json": recording_to_json, ".inkml": _inkml, ".svg": _svg}
