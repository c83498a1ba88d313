"""Strokes on paper and over time, beside the height that they are found from."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.classroom import Drawing
from dmp_teach.ink import Recording
from dmp_teach.lessons.drawing import sheet_box
from dmp_teach.lessons.unsteady_pen import UnsteadyPen
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

# So many looks of a stroke are in lesson.css.
STROKE_LOOKS = 3


def draw_path(recording: Recording) -> Drawing:
    """Draw the whole way of a pen on a sheet, without a word of where it is in the air."""
    path = recording.position[:, :2]
    caption = {"caption": _("On paper"), "note": _("the whole way of the pen")}
    title = _("The whole way of the pen, as it is seen from above.")
    return {**caption, "title": title, "box": sheet_box([path]), "demo": [path]}


def draw_strokes(recording: Recording, strokes: Sequence[Trajectory]) -> Drawing:
    """Draw strokes on a sheet, each in a colour and with its number, and the way between dotted."""
    path = recording.position[:, :2]
    lines: list[Drawing] = [{"points": path, "kind": "air"}]
    dots: list[Drawing] = []
    for n, stroke in enumerate(strokes):
        kind = f"stroke-{n % STROKE_LOOKS}"
        middle = stroke.position[len(stroke) // 2]
        lines.append({"points": stroke.position, "kind": kind})
        dots.append({"at": middle[None], "kind": kind, "label": str(n + 1)})
    caption = {"caption": _("On paper"), "note": _("dotted: in the air")}
    title = _("The strokes that are found, each with its number.")
    return {**caption, "title": title, "box": sheet_box([path]), "extras": lines, "dots": dots}


def draw_over_time(pen: UnsteadyPen, strokes: Sequence[Trajectory] | None) -> dict[str, Drawing]:
    """Draw the height and its rate, with a band where each stroke is; None hides them all."""
    t = pen.recording.t
    scenes = {
        "height": (_("How high the marker is [mm]"), pen.height, -2.0, 25.0),
        "rise": (_("How fast it rises, dz/dt [mm/s]"), pen.rise, -200.0, 200.0),
    }
    seconds = [[n, _("{n} s").format(n=n)] for n in range(int(t[-1]) + 1)]
    plots: dict[str, Drawing] = {}
    for name, (caption, values, low, high) in scenes.items():
        points = np.column_stack([t, 1000 * values])
        plots[name] = {
            "caption": caption,
            "note": _("after your bet"),
            "x": {"label": "", "low": 0.0, "high": float(t[-1]), "ticks": seconds},
            "y": {"label": "", "low": low, "high": high},
        }
        if strokes is not None:
            bands = [
                {
                    "from": float(each.t[0]),
                    "to": float(each.t[-1]),
                    "label": str(n) if name == "height" else "",
                }
                for n, each in enumerate(strokes, 1)
            ]
            lines = [{"points": points, "kind": "truth"}]
            plots[name] |= {"note": _("green: on the paper"), "lines": lines, "bands": bands}
    return plots
