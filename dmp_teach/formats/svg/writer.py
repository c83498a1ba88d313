"""Write SVG for pen plotters: a path for each stroke, unfilled, in millimetres."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from dmp_teach.formats.safe_xml import only_xml_signs, xml_text
from dmp_teach.ink import Recording
from dmp_teach.trajectory import all_points

MARGIN = 0.005  # round the ink [m]
DRAWING = """\
<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.3f}mm" height="{high:.3f}mm"
    viewBox="0 0 {wide:.3f} {high:.3f}" data-origin="{left:.4f} {top:.4f}"{about}>
{title}  <g fill="none" stroke="black" stroke-width="0.5" stroke-linecap="round" \
stroke-linejoin="round">
{paths}  </g>
</svg>
"""


def write_svg(recording: Recording) -> str:
    """Return a recording as a drawing: the page is the ink and a margin, y down."""
    ink = all_points(recording.strokes())
    left, top = ink[:, 0].min() - MARGIN, ink[:, 1].max() + MARGIN
    wide, high = 1000 * (np.ptp(ink, axis=0) + 2 * MARGIN)
    paths = []
    for number, stroke in enumerate(recording.strokes(), start=1):
        places = (stroke.position - [left, top]) * [1000, -1000]
        points = " ".join(f"{x:.3f},{y:.3f}" for x, y in places)
        paths.append(f'    <path id="stroke-{number}" d="M {points}"/>\n')
    line, character, writer = recording.baseline, recording.character, recording.writer
    said = {
        "baseline": None if line is None else f"{1000 * line:.4f}",
        "character": character,
        "writer": writer,
    }
    about = "".join(
        f" data-{name}={quoteattr(only_xml_signs(text))}"
        for name, text in said.items()
        if text is not None
    )
    title = " ".join(filter(None, [xml_text(character or ""), f"by {writer}" if writer else ""]))
    return DRAWING.format(
        wide=wide,
        high=high,
        left=-1000 * left,
        top=1000 * top,
        about=about,
        title=f"  <title>{title}</title>\n" if title else "",
        paths="".join(paths),
    )
