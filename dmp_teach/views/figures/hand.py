"""A figure of the laws of hands: speed over curvature, and both exponents with their intervals."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import ViewError
from dmp_teach.studies import Exponent, HandLaws
from dmp_teach.texts import gettext as _
from dmp_teach.views.figures.figure_style import (
    DrawStyle,
    cycle_looks,
    new_figure,
    set_log_ticks,
    style_axes,
)
from dmp_teach.views.palette import MUTED_COLOR

# More dots of one hand would hide those of another.
MOST_DOTS = 400
SMALL_WORDS: DrawStyle = {
    "color": MUTED_COLOR,
    "fontsize": 9,
    "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1.5},
}


@checked
def draw_hand_laws(hands: Mapping[str, HandLaws]) -> Figure:
    """Draw the speed of hands over the curvature of their ink, and their exponents side by side.

    Args:
        hands: From `measure_hand`, each under its name, such as {"you": ..., "our alphabet": ...};
            the one of interest first.

    Raises:
        ViewError: There is no hand.
    """
    if not hands:
        raise ViewError("hands is empty, but must name at least one hand.")
    height = max(3.6, 1.6 + 0.32 * len(hands))
    figure, panels = new_figure(1, 3, 11.0, height, width_ratios=(1.5, 1, 1))
    bends, bending, growth = panels[0]
    for (name, hand), look in zip(hands.items(), cycle_looks(), strict=False):
        _plot_bends(bends, name, hand, look["color"], look["marker"])
    across, up = _("curvature [1/letter size]"), _("speed [letter sizes/s]")
    style_axes(bends, across, up, _("Bends are slow"))
    for axis in (bends.xaxis, bends.yaxis):
        low, high = axis.get_view_interval()
        powers = 10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
        set_log_ticks(axis, [part * power for power in powers for part in (1, 2, 5)])
    speeds = {name: hand.bending for name, hand in hands.items()}
    times = {name: hand.growth for name, hand in hands.items()}
    few = _("too few bends"), _("too few sizes")
    _plot_exponents(bending, speeds, 1 / 3, few[0])
    _plot_exponents(growth, times, 0.0, few[1])
    style_axes(
        bending, _("speed falls as curvature to the power of"), "", _("Two-thirds power law")
    )
    style_axes(growth, _("time grows as size to the power of"), "", _("Isochrony"))
    growth.set_yticklabels([])
    return figure


def _plot_bends(panel: Axes, name: str, hand: HandLaws, color: str, marker: str) -> None:
    """Plot the bends of a hand, and its law through their middle."""
    panel.set_xscale("log")
    panel.set_yscale("log")
    if np.isnan(hand.bending.value):
        return
    pieces = [(each.curvature * each.size, each.speed / each.size) for each in hand.bends]
    kept = [
        np.stack(piece)[:, each.is_used] for piece, each in zip(pieces, hand.bends, strict=True)
    ]
    curvature, speed = np.concatenate(kept, axis=1)
    shown = slice(None, None, -(-len(speed) // MOST_DOTS))
    dots: DrawStyle = {"color": color, "markersize": 3, "alpha": 0.35, "markeredgewidth": 0}
    panel.plot(curvature[shown], speed[shown], marker, **dots)
    ends = np.quantile(curvature, [0.01, 0.99])
    middle = np.exp(np.log(speed).mean() + hand.bending.value * np.log(curvature).mean())
    line: DrawStyle = {"color": color, "linewidth": 2.0, "marker": marker, "markersize": 6}
    panel.plot(ends, middle * ends**-hand.bending.value, label=name, **line)


def _plot_exponents(panel: Axes, found: Mapping[str, Exponent], law: float, unknown: str) -> None:
    """Plot exponents with their intervals, a row for each, and the law as a line across.

    Where there is none, the row says what is `unknown`.
    """
    panel.axvline(law, color=MUTED_COLOR, linestyle="--", linewidth=1.2)
    for row, (each, look) in enumerate(zip(found.values(), cycle_looks(), strict=False)):
        if np.isnan(each.value):
            place: DrawStyle = {"xycoords": ("axes fraction", "data"), "va": "center"}
            panel.annotate(unknown, (0.04, row), **place, **SMALL_WORDS)
        panel.plot([each.low, each.high], [row, row], color=look["color"], linewidth=2.4)
        panel.plot([each.value], [row], look["marker"], color=look["color"], markersize=7)
    panel.set_yticks(range(len(found)), list(found))
    panel.set_ylim(len(found) - 0.5, -0.5)
    at: DrawStyle = {"xycoords": ("data", "axes fraction"), "textcoords": "offset points"}
    panel.annotate(f"{law:.2g}", (law, 1.0), (4, -4), va="top", **at, **SMALL_WORDS)
