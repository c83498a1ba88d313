"""Strokes on paper and over time, beside the height that they are found from."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.classroom import Drawing
from dmp_teach.ink import Recording
from dmp_teach.lessons.drawing import axis, line, mark, plot, sheet_box
from dmp_teach.lessons.unsteady_pen import UnsteadyPen
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

# So many looks of a stroke are in lesson.css.
STROKE_LOOKS = 3


def draw_path(recording: Recording) -> Drawing:
    """Draw the whole way of a pen on a sheet, without a word of where it is in the air."""
    path = recording.position[:, :2]
    title = _("The whole way of the pen, as it is seen from above.")
    sheet = {"caption": _("On paper"), "note": _("the whole way of the pen"), "title": title}
    return {**sheet, "box": sheet_box([path]), "demo": [path]}


def draw_strokes(recording: Recording, strokes: Sequence[Trajectory]) -> Drawing:
    """Draw strokes on a sheet, each in a colour and with its number, and the way between dotted."""
    path = recording.position[:, :2]
    lines, dots = [line(path, "air")], []
    for n, stroke in enumerate(strokes):
        kind = f"stroke-{n % STROKE_LOOKS}"
        lines.append(line(stroke.position, kind))
        dots.append(mark(stroke.position[len(stroke) // 2][None], kind, str(n + 1)))
    title = _("The strokes that are found, each with its number.")
    sheet = {"caption": _("On paper"), "note": _("dotted: in the air"), "title": title}
    return {**sheet, "box": sheet_box([path]), "extras": lines, "dots": dots}


def draw_over_time(pen: UnsteadyPen, strokes: Sequence[Trajectory] | None) -> dict[str, Drawing]:
    """Draw the height and its rate, with a band where each stroke is; None hides them all."""
    t = pen.recording.t
    seconds = [[n, _("{n} s").format(n=n)] for n in range(int(t[-1]) + 1)]
    x, after = axis(0, t[-1], ticks=seconds), _("after your bet")
    height, rise = axis(-2, 25), axis(-200, 200)
    plots = {
        "height": plot(_("How high the marker is [mm]"), x, height, after),
        "rise": plot(_("How fast it rises, dz/dt [mm/s]"), x, rise, after),
    }
    for name, values in (("height", pen.height), ("rise", pen.rise)) if strokes is not None else ():
        spans = [(*map(float, each.t[[0, -1]]), str(n)) for n, each in enumerate(strokes or (), 1)]
        plots[name] |= {
            "note": _("green: on the paper"),
            "lines": [line(np.column_stack([t, 1000 * values]), "truth")],
            "bands": [
                {"from": begin, "to": end, "label": n if name == "height" else ""}
                for begin, end, n in spans
            ],
        }
    return plots
