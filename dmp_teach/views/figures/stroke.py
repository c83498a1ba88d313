"""Strokes by each rule of segmentation: height, its rate and the ink that each rule leaves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.segmentation import RULES
from dmp_teach.trajectory import Trajectory
from dmp_teach.views.figures.figure_style import (
    new_figure,
    plot_path,
    set_same_view,
    style_axes,
    style_paper,
)
from dmp_teach.views.palette import GRID_COLOR, MUTED_COLOR, STROKE_COLORS, TEXT_COLOR

RULE_NAMES = {
    "foot": "local foot",
    "printed": "as printed",
    "meant": "as the authors meant it",
    "authors": "as their program does it",
    "hand": "given, or cut by hand",
}


@checked
def draw_strokes_by_rule(recording: Recording, theta: float = 0.10, sigma: float = 0.006) -> Figure:
    """Draw one recording and its strokes by every rule: height and dz/dt over time, and ink.

    Strokes that were given or cut by hand have a row of their own, under those of the rules.

    Args:
        recording: With a height.
        theta: How fast the pen must rise to leave the paper [m/s].
        sigma: How high, as each rule takes it [m].
    """
    found = _segment_by_rules(recording, theta, sigma)
    shape = (len(found), 2, 10.0, 2.05 * len(found) + 0.6)
    figure, panels = new_figure(*shape, width_ratios=[3.4, 1])
    z = 1e3 * recording.position[:, 2]
    for (left, right), (rule, strokes) in zip(panels, found.items(), strict=True):
        _plot_over_time(left, recording, strokes, theta)
        if rule not in ("foot", "hand"):
            middle = 0.0 if rule == "authors" else z.mean()
            for side in (-1, 1):
                look = {"color": MUTED_COLOR, "linewidth": 0.9, "linestyle": (0, (4, 3))}
                left.axhline(middle + side * 1e3 * sigma, **look)
        title = f"{RULE_NAMES[rule]}: {len(strokes) or 'no'} stroke{'s' * (len(strokes) > 1)}"
        left.set_title(title, color=TEXT_COLOR, fontsize=10.5, loc="left")
        _plot_on_paper(right, recording, strokes)
    for panel in panels[:-1, 0]:
        panel.tick_params(labelbottom=False)
    set_same_view(panels[:, 1], 1e3 * recording.position[:, :2])
    panels[-1, 0].set_xlabel("time [s]", color=TEXT_COLOR, fontsize=10)
    panels[-1, 1].set_xlabel("x [mm]", color=TEXT_COLOR, fontsize=10)
    figure.supxlabel(
        "dark: height, with mu_z ± sigma where the rule takes it (dashed); "
        "grey: dz/dt, dotted where it is theta; coloured: strokes",
        color=MUTED_COLOR,
        fontsize=9,
    )
    return figure


def _segment_by_rules(
    recording: Recording, theta: float, sigma: float
) -> dict[str, Sequence[Trajectory]]:
    """Return the strokes by each rule, none where it finds none; and those by hand."""
    plain = recording.with_strokes(None)
    found: dict[str, Sequence[Trajectory]] = {}
    for rule in RULES:
        try:
            found[rule] = plain.strokes(theta, sigma, rule)
        except RecordingError:
            found[rule] = ()
    if recording.given_strokes is not None:
        found["hand"] = recording.strokes()
    return found


def _plot_over_time(
    panel: Axes, recording: Recording, strokes: Sequence[Trajectory], theta: float
) -> None:
    """Plot height [mm] at the left, its rate [m/s] at the right, and strokes as bands."""
    t = recording.t
    z = recording.position[:, 2]
    rate = np.gradient(z, t)
    style_axes(panel, y="height [mm]")
    for number, stroke in enumerate(strokes):
        color = STROKE_COLORS[number % len(STROKE_COLORS)]
        panel.axvspan(stroke.t[0], stroke.t[-1], color=color, alpha=0.16, linewidth=0)
        for edge in (stroke.t[0], stroke.t[-1]):
            panel.axvline(edge, color=color, linewidth=1.2)
    other = panel.twinx()
    other.plot(t, rate, color=MUTED_COLOR, linewidth=0.7, alpha=0.8)
    other.axhline(theta, color=MUTED_COLOR, linewidth=0.9, linestyle=":")
    high = max(1.3 * theta, float(np.abs(rate).max()))
    other.set_ylim(-high, high)
    other.set_ylabel("dz/dt [m/s]", color=MUTED_COLOR, fontsize=9)
    other.tick_params(colors=MUTED_COLOR, labelsize=8, length=3)
    for spine in other.spines.values():
        spine.set_visible(False)
    panel.plot(t, 1e3 * z, color=TEXT_COLOR, linewidth=1.5)
    panel.set_xlim(t[0], t[-1])
    panel.set_zorder(other.get_zorder() + 1)
    panel.patch.set_visible(False)


def _plot_on_paper(panel: Axes, recording: Recording, strokes: Sequence[Trajectory]) -> None:
    """Plot the whole path of the pen in grey, and the strokes on it, each from its ring on."""
    style_paper(panel)
    plot_path(panel, recording.position[:, :2], color=GRID_COLOR, linewidth=1.4, zorder=1)
    ring = {"marker": "o", "markersize": 6, "markerfacecolor": "white", "markeredgewidth": 1.6}
    for number, stroke in enumerate(strokes):
        color = STROKE_COLORS[number % len(STROKE_COLORS)]
        plot_path(panel, stroke.position, color=color, linewidth=2.0)
        plot_path(panel, stroke.position[:1], color=color, **ring)
