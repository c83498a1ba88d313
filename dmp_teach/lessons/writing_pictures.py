"""How hard a pen presses, and how busy the joints are, as curves."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from dmp_teach.classroom import Drawing
from dmp_teach.lessons.pen_pressing import RIGID, SPRING, busiest_joint, force_of, weight_on
from dmp_teach.lessons.writing_setup import MOST_BUSY, WritingSetup
from dmp_teach.robot import FORCE_BAND
from dmp_teach.texts import gettext as _

DEEPEST, FASTEST = 14, 60
# What the axes show [N], [%].
_MOST_FORCE, _MOST_PERCENT = 3.0, 200.0


def draw_force(setup: WritingSetup) -> Drawing:
    """Draw with how much each pen presses, and where that is neither too little nor too much."""
    press = np.linspace(0, DEEPEST, 561)
    lines: list[Drawing] = []
    for pen, label in (("rigid", _("rigid")), ("sprung", _("spring"))):
        points = np.array([[mm, force_of(pen, mm, setup.where)] for mm in press])
        kind = "robot" if pen == setup.pen else "quiet"
        shown = points[points[:, 1] <= _MOST_FORCE]
        lines.append({"points": shown, "kind": kind, "label": label})
    more, weight = (RIGID, 0.0) if setup.pen == "rigid" else (SPRING, weight_on(setup.where))
    low, high = ((limit - weight) / more for limit in FORCE_BAND)
    x = {"label": "", "low": 0.0, "high": DEEPEST, "ticks": _ticks(range(0, 15, 2), "mm")}
    dot: Drawing = {"at": [setup.press, setup.force], "kind": "robot"}
    return {
        "caption": _("How hard the pen presses"),
        "note": _("{n} N at rest; an apple weighs 1 N").format(n=setup.facts["n"]),
        "x": x,
        "y": {"label": "", "low": 0.0, "high": _MOST_FORCE, "ticks": _ticks(range(4), "N")},
        "lines": lines,
        "bands": [{"from": low, "to": high, "label": _("good") if setup.pen == "sprung" else ""}],
        "dots": [dot] if setup.force <= _MOST_FORCE else [],
    }


def draw_joints(setup: WritingSetup) -> Drawing:
    """Draw how busy the busiest joint is at every speed of the pen."""
    dot: Drawing = {"at": [setup.speed, setup.percent], "kind": "robot"}
    most = np.array([[0.0, MOST_BUSY], [FASTEST, MOST_BUSY]])
    lines: list[Drawing] = [{"points": most, "kind": "quiet", "label": f"{MOST_BUSY:g} %"}]
    if setup.is_reached:
        speeds = np.linspace(0, FASTEST, 61)
        points = np.column_stack([speeds, busiest_joint(setup.effort, 1.0) * speeds])
        lines.append({"points": points[points[:, 1] <= _MOST_PERCENT], "kind": "robot"})
    return {
        "caption": _("How busy the busiest joint is"),
        "note": "" if setup.is_reached else _("this page is not in reach"),
        "x": {"label": "", "low": 0.0, "high": FASTEST, "ticks": _ticks(range(0, 61, 20), "cm/s")},
        "y": {"label": "", "low": 0.0, "high": _MOST_PERCENT, "ticks": _ticks((0, 100, 200), "%")},
        "lines": lines,
        "dots": [dot] if setup.percent <= _MOST_PERCENT else [],
    }


def _ticks(values: Iterable[int], unit: str) -> list[list[object]]:
    """Return a tick with its unit at each value."""
    return [[value, f"{value} {unit}"] for value in values]
