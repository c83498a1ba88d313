"""Write SVG for pen plotters: a path for each stroke, unfilled, in millimetres."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from dmp_teach.formats.flat_ink import check_flat
from dmp_teach.formats.safe_xml import only_xml_signs, xml_text
from dmp_teach.ink import Recording

MARGIN = 0.005  # round the ink [m]
LINE_WIDTH = 0.5  # [mm]
LINE = f'fill="none" stroke="black" stroke-width="{LINE_WIDTH}"'
ROUND = 'stroke-linecap="round" stroke-linejoin="round"'
DRAWING = """\
<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.3f}mm" height="{high:.3f}mm"
    viewBox="0 0 {wide:.3f} {high:.3f}" data-origin="{left:.4f} {top:.4f}"{about}>
{title}  <g {look}>
{paths}  </g>
</svg>
"""


def write_svg(recording: Recording) -> str:
    """Return a recording as a drawing: the page is the ink and a margin, y down.

    Raises:
        RecordingError: As `check_flat`.
    """
    strokes = [stroke.position for stroke in recording.strokes()]
    check_flat(strokes, ".svg")
    ink = np.concatenate(strokes)
    left, top = ink[:, 0].min() - MARGIN, ink[:, 1].max() + MARGIN
    wide, high = 1000 * (np.ptp(ink, axis=0) + 2 * MARGIN)
    paths = []
    for number, stroke in enumerate(strokes, start=1):
        points = " ".join(f"{x:.3f},{y:.3f}" for x, y in (stroke - [left, top]) * [1000, -1000])
        paths.append(f'    <path id="stroke-{number}" d="M {points}"/>\n')
    return DRAWING.format(
        wide=wide,
        high=high,
        left=-1000 * left,
        top=1000 * top,
        about=_attributes(recording),
        title=_title(recording),
        look=f"{LINE} {ROUND}",
        paths="".join(paths),
    )


def _attributes(recording: Recording) -> str:
    """Return what the root says of the letter, for us to read again."""
    line = recording.baseline
    labels = {
        "baseline": None if line is None else f"{1000 * line:.4f}",
        "character": recording.character,
        "writer": recording.writer,
    }
    return "".join(
        f" data-{name}={quoteattr(only_xml_signs(text))}"
        for name, text in labels.items()
        if text is not None
    )


def _title(recording: Recording) -> str:
    """Return the title that other programs show; nothing for a letter without a name."""
    writer = f"by {recording.writer}" if recording.writer else ""
    title = " ".join(part for part in (xml_text(recording.character or ""), writer) if part)
    return f"  <title>{title}</title>\n" if title else ""
