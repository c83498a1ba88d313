"""Where each rule cuts a recording into strokes: its height, its rate and its path, the rules beside each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording
from dmp_teach.segmentation import RULES
from dmp_teach.trajectory import Trajectory
from dmp_teach.views.figures.figure_style import (
    COLOURS,
    GRID,
    INK,
    QUIET,
    dressed,
    paper,
    same_view,
    sheet,
)

NAMES = {
    "foot": "local foot",
    "printed": "as printed",
    "authors": "as the authors meant it",
    "hand": "given, or cut by hand",
}


def strokes_by_rule(recording: Recording, theta: float = 0.10, sigma: float = 0.006) -> Figure:
    """One recording and its strokes by every rule: height and dz/dt over time, and the ink that each rule leaves.

    Strokes that were given or cut by hand have a row of their own, under those of the rules.

    Args:
        recording: With a height.
        theta: How fast the pen must rise to leave the paper [m/s].
        sigma: How high, as each rule takes it [m].
    """
    found = _found(recording, theta, sigma)
    figure, panels = sheet(len(found), 2, 10.0, 2.05 * len(found) + 0.6, width_ratios=[3.4, 1])
    z = 1e3 * recording.position[:, 2]
    for row, (rule, strokes) in zip(panels, found.items(), strict=True):
        _over_time(row[0], recording, strokes, theta)
        if rule in ("printed", "authors"):
            for side in (-1, 1):
                row[0].axhline(
                    z.mean() + side * 1e3 * sigma, color=QUIET, linewidth=0.9, linestyle=(0, (4, 3))
                )
        row[0].set_title(
            f"{NAMES[rule]}: {_counted(len(strokes))}", color=INK, fontsize=10.5, loc="left"
        )
        _on_paper(row[1], recording, strokes)
    for row in panels[:-1]:
        row[0].tick_params(labelbottom=False)
    same_view(panels[:, 1], 1e3 * recording.position[:, :2])
    panels[-1, 0].set_xlabel("time [s]", color=INK, fontsize=10)
    panels[-1, 1].set_xlabel("x [mm]", color=INK, fontsize=10)
    figure.supxlabel(
        "dark: height, with mu_z ± sigma where the rule takes it (dashed); grey: dz/dt, dotted where it is theta; "
        "coloured: strokes",
        color=QUIET,
        fontsize=9,
    )
    return figure


def _found(recording: Recording, theta: float, sigma: float) -> dict[str, Sequence[Trajectory]]:
    """The strokes by each rule, none where it finds none; and those by hand, if there are."""
    plain = recording.with_strokes(None)
    found: dict[str, Sequence[Trajectory]] = {}
    for rule in RULES:
        try:
            found[rule] = plain.strokes(theta, sigma, rule)
        except RecordingError:
            found[rule] = ()
    return found if recording.given_strokes is None else {**found, "hand": recording.strokes()}


def _over_time(
    panel: Axes, recording: Recording, strokes: Sequence[Trajectory], theta: float
) -> None:
    """Height [mm] at the left, its rate [m/s] at the right, strokes as bands."""
    t, z = recording.t, recording.position[:, 2]
    rate = np.gradient(z, t)
    dressed(panel, y="height [mm]")
    for number, stroke in enumerate(strokes):
        colour = COLOURS[number % len(COLOURS)]
        panel.axvspan(stroke.t[0], stroke.t[-1], color=colour, alpha=0.16, linewidth=0)
        for edge in (stroke.t[0], stroke.t[-1]):
            panel.axvline(edge, color=colour, linewidth=1.2)
    other = panel.twinx()
    other.plot(t, rate, color=QUIET, linewidth=0.7, alpha=0.8)
    other.axhline(theta, color=QUIET, linewidth=0.9, linestyle=":")
    high = max(1.3 * theta, float(np.abs(rate).max()))
    other.set_ylim(-high, high)
    other.set_ylabel("dz/dt [m/s]", color=QUIET, fontsize=9)
    other.tick_params(colors=QUIET, labelsize=8, length=3)
    for spine in other.spines.values():
        spine.set_visible(False)
    panel.plot(t, 1e3 * z, color=INK, linewidth=1.5)
    panel.set_xlim(t[0], t[-1])
    panel.set_zorder(other.get_zorder() + 1)
    panel.patch.set_visible(False)


def _on_paper(panel: Axes, recording: Recording, strokes: Sequence[Trajectory]) -> None:
    """The whole way of the pen in grey, and the strokes on it, each from its ring on."""
    paper(panel)
    panel.plot(*(1e3 * recording.position[:, :2]).T, color=GRID, linewidth=1.4, zorder=1)
    for number, stroke in enumerate(strokes):
        colour, path = COLOURS[number % len(COLOURS)], 1e3 * stroke.position
        panel.plot(*path.T, color=colour, linewidth=2.0)
        panel.plot(
            *path[0],
            marker="o",
            markersize=6,
            markerfacecolor="white",
            color=colour,
            markeredgewidth=1.6,
        )


def _counted(strokes: int) -> str:
    """How many strokes, in words."""
    return "no stroke" if not strokes else "1 stroke" if strokes == 1 else f"{strokes} strokes"
