"""How hard a pen presses, and how busy the joints are, as curves."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from dmp_teach.classroom import Drawing
from dmp_teach.lessons.drawing import axis, line, mark, plot
from dmp_teach.lessons.writing_setup import (
    MOST_BUSY,
    RIGID,
    SPRING,
    WritingSetup,
    busiest_joint,
    force_of,
    weight_on,
)
from dmp_teach.robot import FORCE_BAND
from dmp_teach.texts import gettext as _

DEEPEST, FASTEST = 14, 60
# What the axes show [N], [%].
_MOST_FORCE, _MOST_PERCENT = 3.0, 200.0


def draw_force(setup: WritingSetup) -> Drawing:
    """Draw with how much each pen presses, and where that is neither too little nor too much."""
    press, is_rigid = np.linspace(0, DEEPEST, 561), setup.pen == "rigid"
    lines = []
    for pen, label in (("rigid", _("rigid")), ("sprung", _("spring"))):
        points = np.array([[mm, force_of(pen, mm, setup.where)] for mm in press])
        shown = points[points[:, 1] <= _MOST_FORCE]
        lines.append(line(shown, "robot" if pen == setup.pen else "quiet", label))
    more, weight = (RIGID, 0.0) if is_rigid else (SPRING, weight_on(setup.where))
    low, high = ((limit - weight) / more for limit in FORCE_BAND)
    now = [mark([setup.press, setup.force], "robot")]
    return plot(
        _("How hard the pen presses"),
        axis(0, DEEPEST, ticks=_ticks(range(0, 15, 2), "mm")),
        axis(0, _MOST_FORCE, ticks=_ticks(range(4), "N")),
        _("{n} N at rest; an apple weighs 1 N").format(n=setup.facts["n"]),
        lines=lines,
        bands=[{"from": low, "to": high, "label": "" if is_rigid else _("good")}],
        dots=now[: setup.force <= _MOST_FORCE],
    )


def draw_joints(setup: WritingSetup) -> Drawing:
    """Draw how busy the busiest joint is at every speed of the pen."""
    most = np.array([[0.0, MOST_BUSY], [FASTEST, MOST_BUSY]])
    lines = [line(most, "quiet", f"{MOST_BUSY:g} %")]
    if setup.is_reached:
        speeds = np.linspace(0, FASTEST, 61)
        points = np.column_stack([speeds, busiest_joint(setup.effort, 1.0) * speeds])
        lines.append(line(points[points[:, 1] <= _MOST_PERCENT], "robot"))
    now = [mark([setup.speed, setup.percent], "robot")]
    return plot(
        _("How busy the busiest joint is"),
        axis(0, FASTEST, ticks=_ticks(range(0, 61, 20), "cm/s")),
        axis(0, _MOST_PERCENT, ticks=_ticks((0, 100, 200), "%")),
        "" if setup.is_reached else _("this page is not in reach"),
        lines=lines,
        dots=now[: setup.percent <= _MOST_PERCENT],
    )


def _ticks(values: Iterable[int], unit: str) -> list[list[object]]:
    return [[value, f"{value} {unit}"] for value in values]
