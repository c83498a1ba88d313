"""Write InkML: X and Y in millimetres, Y down the page, T in milliseconds."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import numpy as np

from dmp_teach.formats.flat_ink import check_flat
from dmp_teach.formats.safe_xml import xml_text
from dmp_teach.ink import Recording

HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<ink xmlns="http://www.w3.org/2003/InkML">
{notes}  <context xml:id="pen">
    <traceFormat>
{channels}    </traceFormat>
  </context>
"""


def write_inkml(recording: Recording) -> str:
    """Return a recording as InkML.

    Raises:
        RecordingError: As `check_flat`.
    """
    strokes = recording.strokes()
    check_flat([stroke.position for stroke in strokes], ".inkml")
    line = recording.baseline
    about = {
        "truth": recording.character,
        "writer": recording.writer,
        "origin": "0 0",
        "baseline": None if line is None else f"{1000 * line:.4f}",
    }
    notes = [
        f"  <annotation type={quoteattr(kind)}>{xml_text(text)}</annotation>\n"
        for kind, text in about.items()
        if text is not None
    ]
    channels = ['name="X" type="decimal" units="mm"', 'name="Y" type="decimal" units="mm"']
    channels += ['name="T" type="decimal" units="ms"']
    columns = ["{:.4f}", "{:.4f}", "{:.3f}"]
    if recording.pressure is not None:
        channels += ['name="F" type="decimal" min="0" max="1"']
        columns += ["{:.6f}"]
    form = " ".join(columns)
    traces = []
    for stroke in strokes:
        rows = [stroke.position * [1000, -1000], 1000 * (stroke.t - recording.t[0])[:, None]]
        if recording.pressure is not None:
            rows.append(recording.pressure[np.searchsorted(recording.t, stroke.t)][:, None])
        points = ", ".join(form.format(*row) for row in np.hstack(rows))
        traces.append(f'  <trace contextRef="#pen">{points}</trace>\n')
    head = HEAD.format(
        notes="".join(notes),
        channels="".join(f"      <channel {channel}/>\n" for channel in channels),
    )
    return "".join([head, *traces, "</ink>\n"])
