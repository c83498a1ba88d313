"""Write InkML: X and Y in millimetres, Y down the page, T in milliseconds."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from dmp_teach.formats.safe_xml import xml_text
from dmp_teach.ink import Recording

INK = """\
<?xml version="1.0" encoding="UTF-8"?>
<ink xmlns="http://www.w3.org/2003/InkML">
{notes}  <context xml:id="pen">
    <traceFormat>
{channels}    </traceFormat>
  </context>
{traces}</ink>
"""
CHANNELS = ['name="X" type="decimal" units="mm"', 'name="Y" type="decimal" units="mm"']
CHANNELS += ['name="T" type="decimal" units="ms"', 'name="F" type="decimal" min="0" max="1"']
VALUES = ["{:.4f}", "{:.4f}", "{:.3f}", "{:.6f}"]


def write_inkml(recording: Recording) -> str:
    """Return a recording as InkML."""
    line, pressure = recording.baseline, recording.pressure
    about = {
        "truth": recording.character,
        "writer": recording.writer,
        "origin": "0 0",
        "baseline": None if line is None else f"{1000 * line:.4f}",
    }
    count = 3 if pressure is None else 4
    form, traces = " ".join(VALUES[:count]), []
    for stroke in recording.strokes():
        rows = [stroke.position * [1000, -1000], 1000 * (stroke.t - recording.t[0])[:, None]]
        if pressure is not None:
            rows.append(pressure[np.searchsorted(recording.t, stroke.t)][:, None])
        points = ", ".join(form.format(*row) for row in np.hstack(rows))
        traces.append(f'  <trace contextRef="#pen">{points}</trace>\n')
    return INK.format(
        notes="".join(
            f"  <annotation type={quoteattr(kind)}>{xml_text(text)}</annotation>\n"
            for kind, text in about.items()
            if text is not None
        ),
        channels="".join(f"      <channel {each}/>\n" for each in CHANNELS[:count]),
        traces="".join(traces),
    )
