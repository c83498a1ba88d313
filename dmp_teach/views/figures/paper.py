"""The paper's figures of kernels, errors and moved goals, drawn from the data of a study."""

from __future__ import annotations

from string import ascii_lowercase

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import check_whole, checked
from dmp_teach.dmp import KERNELS, Kernels
from dmp_teach.studies import Choice, ErrorCurves, GoalPaths
from dmp_teach.trajectory import Array
from dmp_teach.views.figures.figure_style import (
    REFUSED,
    DrawStyle,
    add_legend,
    cycle_looks,
    new_figure,
    set_log_ticks,
    set_log_y_axis,
    style_axes,
)
from dmp_teach.views.palette import (
    COMPARED_COLOR,
    MUTED_COLOR,
    PERSON_COLOR,
    ROBOT_COLOR,
    SHADE_COLOR,
    STROKE_COLORS,
    TEXT_COLOR,
)

# An infinite width ("no ends") stands here on an axis of widths that ends at 40.
INFINITE_WIDTH_PLACE = 80.0
WIDTH_TICKS = [0.2, 0.666667, 1, 2, 4, 10, 20, 40]
# Words and unit of both errors of a curve.
ERRORS = {
    "error": ("error, root mean square [mm]", 1e3),
    "euclidean": ("Euclidean error, sum of distances [m]", 1.0),
}
TRACE_LOOKS: dict[str, DrawStyle] = {
    "demonstration": {"color": PERSON_COLOR, "linestyle": (0, (5, 2)), "linewidth": 2.2},
    "DMP*": {"color": ROBOT_COLOR, "linestyle": "-", "linewidth": 1.8},
    "original": {"color": COMPARED_COLOR, "linestyle": "-.", "linewidth": 1.8},
}


@checked
def draw_kernel_types(number: int = 8) -> Figure:
    """Draw the paper's figure 2: the kinds of kernel over the phase.

    Args:
        number: N.
    """
    check_whole("number", number, 1, 300)
    kinds = [kind for kernel in KERNELS.values() for kind in kernel.kinds()]
    figure, panels = new_figure(1, len(kinds), 3.25 * len(kinds), 2.9, sharey=True)
    s = np.linspace(0, 1, 2001)
    for letter, panel, (title, width, kernel) in zip(
        ascii_lowercase, panels[0], kinds, strict=False
    ):
        heights = Kernels(number, width, kernel).heights(s)
        for height, look in zip(heights.T, cycle_looks(), strict=False):
            # One sample more on each side: the cut of a truncated kernel is seen.
            active = np.convolve(height > 0, [1, 1, 1], mode="same") > 0
            bump = np.where(active, height, np.nan)
            panel.plot(s, bump, color=look["color"], linestyle="-", linewidth=1.6)
            panel.fill_between(s, np.nan_to_num(bump), color=look["color"], alpha=0.12, linewidth=0)
        inactive = heights.max(axis=1) == 0
        panel.fill_between(s, 0, 1.08, where=inactive, color="#DDDDDD", linewidth=0, step="mid")
        style_axes(
            panel, "phase s", "height ψ(s)" if panel is panels[0][0] else "", f"({letter}) {title}"
        )
        panel.set_ylim(0, 1.08)
        panel.set_xlim(0, 1)
    return figure


@checked
def draw_error_over_width(curves: ErrorCurves, variant: str | None = None) -> Figure:
    """Draw the paper's figure 4: both errors against kernel width, a line for each letter.

    Args:
        curves: From `sweep_kernel_width`.
        variant: Which of `curves.variants`; the first unless given; "all" draws a line for each
            variant instead.
    """
    x = _place_widths(curves.x)
    figure, panels = _draw_errors(curves, variant, x, "kernel width [1/N]")
    ends = {INFINITE_WIDTH_PLACE: "no ends"} if np.isinf(curves.x).any() else {}
    for panel in panels:
        panel.axvspan(1, 4, color=SHADE_COLOR, linewidth=0, zorder=0)
        set_log_ticks(panel.xaxis, [*WIDTH_TICKS, *ends], {0.666667: "⅔", **ends})
        top = panel.get_xaxis_transform()
        look: DrawStyle = {"transform": top, "va": "top", "color": MUTED_COLOR}
        panel.text(2, 0.985, "1/N to 4/N", ha="center", **look)
    return figure


@checked
def draw_error_over_number(curves: ErrorCurves, variant: str | None = None) -> Figure:
    """Draw the paper's figure 6: both errors against the number of kernels, a line for each letter.

    Args:
        curves: From `sweep_kernel_number`.
        variant: Which of `curves.variants`; the first unless given; "all" draws a line for each
            variant instead.
    """
    figure, panels = _draw_errors(curves, variant, curves.x, "kernels per sample, N / Num")
    ticks = (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
    low = curves.x[0] * 0.9
    high = curves.x[-1] * 1.1
    for panel in panels:
        panel.axvline(0.1, color=TEXT_COLOR, linewidth=1, linestyle=(0, (2, 2)))
        top = panel.get_xaxis_transform()
        look: DrawStyle = {"transform": top, "va": "top", "color": TEXT_COLOR}
        panel.text(0.104, 0.985, "N = Num/10", fontsize=9, **look)
        set_log_ticks(panel.xaxis, [tick for tick in ticks if low <= tick <= high])
    return figure


@checked
def draw_goal_change_over_time(traces: GoalPaths) -> Figure:
    """Draw the paper's figure 7: position and velocity of one coordinate whose goal moved.

    Args:
        traces: From `trace_goal_change`.
    """
    figure, panels = new_figure(2, 1, 6.4, 5.6, sharex=True)
    position, velocity = panels[:, 0]
    for panel, values in ((position, traces.paths), (velocity, traces.velocities)):
        for name in values:
            panel.plot(traces.t, 1e3 * values[name], label=name, **TRACE_LOOKS[name])
    goal = 1e3 * (traces.paths["demonstration"][-1] + traces.shift)
    ring = {"marker": "o", "markerfacecolor": "white", "linestyle": ""}
    position.plot(traces.t[-1], goal, color=TEXT_COLOR, label="new goal", **ring)
    shift = f"{1e3 * traces.shift[0]:+.0f} mm".replace("-", "−")
    title = f"{traces.stroke}: the goal moves by {shift}".strip(": ")
    title += "" if "original" in traces.paths else f"\n{REFUSED}"
    style_axes(position, "", "position [mm]", title)
    style_axes(velocity, "time [s]", "velocity [mm/s]")
    add_legend(position, loc="best", ncols=2)
    return figure


@checked
def draw_kernel_choice(choice: Choice) -> Figure:
    """Draw the curve of a validation, with the choice and both rules of thumb.

    Args:
        choice: From `choose_kernels` or `choose_width`.
    """
    figure, ((panel,),) = new_figure(1, 1, 6.8, 4.2)
    x = _place_widths(choice.candidates)
    shown = {"linestyle": "--", "linewidth": 1.4, "label": "samples that were shown"}
    panel.plot(x, 1e3 * choice.taught, color=MUTED_COLOR, **shown)
    held_out = {"marker": "o", "markersize": 4.5, "label": "samples that were not shown"}
    panel.plot(x, 1e3 * choice.error, color=ROBOT_COLOR, **held_out)
    chosen = choice.candidates == choice.chosen
    ring = {"marker": "o", "markersize": 13, "markerfacecolor": "none", "markeredgewidth": 2}
    ring |= {"linestyle": "", "label": f"chosen: {choice.chosen:g}"}
    panel.plot(x[chosen], 1e3 * choice.error[chosen], color=TEXT_COLOR, **ring)
    label = "kernel width [1/N]"
    if choice.name == "n_kernels":
        label = "number of kernels N"
        _plot_rules_of_thumb(panel, choice)
    style_axes(panel, label, "error, root mean square [mm]")
    panel.set_xscale("log")
    ticks = [t for t in (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500) if x[0] <= t <= x[-1]]
    ends = {INFINITE_WIDTH_PLACE: "no ends"} if np.isinf(choice.candidates).any() else {}
    set_log_ticks(panel.xaxis, [*ticks, *ends], ends)
    set_log_y_axis(panel, 1e3 * np.concatenate([choice.error, choice.taught]))
    add_legend(panel, loc="best")
    return figure


def _draw_errors(
    curves: ErrorCurves, variant: str | None, x: Array, name: str
) -> tuple[Figure, list[Axes]]:
    """Draw both errors over x (K,), a line for each letter or variant; return figure and panels."""
    figure, (panels,) = new_figure(1, 2, 11.0, 4.4)
    shown = "medians" if variant == "all" else (variant or curves.variants[0])
    titles = f"{shown}, over {len(curves.strokes)} strokes", "as the paper sums it up"
    for panel, (error, (words, unit)), title in zip(panels, ERRORS.items(), titles, strict=True):
        lines = _find_medians(curves, variant, error)
        for (label, values), look in zip(lines.items(), cycle_looks(), strict=False):
            panel.plot(x, unit * values, label=label, **look)
        style_axes(panel, name, words, title)
        panel.set_xscale("log")
        set_log_y_axis(panel, unit * np.concatenate(list(lines.values())))
    add_legend(panels[-1], loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure, list(panels)


def _find_medians(curves: ErrorCurves, variant: str | None, error_name: str) -> dict[str, Array]:
    """Return the median of each letter's strokes in one variant, or of all strokes in each."""
    if variant == "all":
        medians = np.median(getattr(curves, error_name), axis=1)
        return dict(zip(curves.variants, medians, strict=True))
    error = curves.of(variant or curves.variants[0], error_name)
    letters = np.array(curves.characters)
    names = dict.fromkeys(curves.characters)
    return {f"‘{name}’": np.median(error[letters == name], axis=0) for name in names}


def _plot_rules_of_thumb(panel: Axes, choice: Choice) -> None:
    """Plot the numbers of kernels that the two rules of thumb give."""
    tenth: DrawStyle = {"linestyle": ":", "label": f"Num/10: {choice.tenth}"}
    panel.axvline(choice.tenth, color=STROKE_COLORS[1], **tenth)
    twelve: DrawStyle = {"linestyle": "-.", "label": f"12 a second: {choice.twelve_a_second}"}
    panel.axvline(choice.twelve_a_second, color=STROKE_COLORS[2], **twelve)


def _place_widths(widths: Array) -> Array:
    """Return where widths stand on an axis; infinite ones have a place of their own."""
    return np.where(np.isinf(widths), INFINITE_WIDTH_PLACE, widths)
