"""The paper's figures, drawn from the data of a study."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.dmp import Kernels
from dmp_teach.studies import Choice, ErrorCurves, Traces
from dmp_teach.trajectory import Array
from dmp_teach.views.figures.figure_style import (
    CHILD,
    COLOURS,
    INK,
    OTHER,
    QUIET,
    ROBOT,
    SHADE,
    decades,
    dressed,
    explained,
    looks,
    plain_log,
    sheet,
)

FULL = 80.0  # where "no ends" stands on an axis of widths that ends at 40
WIDTH_TICKS = {
    0.2: "0.2",
    round(2 / 3, 6): "⅔",
    1.0: "1",
    2.0: "2",
    4.0: "4",
    10.0: "10",
    20.0: "20",
    40.0: "40",
}
KINDS = (
    ("(a) full Gaussian", np.inf, 0.65),
    ("(b) truncated, touching: width 1/N", 1.0, 0.5),
    ("(c) truncated, with gaps: width 2/3N", 2 / 3, 0.5),
    ("(d) truncated, overlapping: width 2/N", 2.0, 0.65),
)


def kernel_types(number: int = 8) -> Figure:
    """The paper's figure 2: four kinds of kernel over the phase.

    Args:
        number: N.
    """
    figure, panels = sheet(1, 4, 13, 2.9, sharey=True)
    s = np.linspace(0, 1, 2001)
    for panel, (title, width, sigma) in zip(panels[0], KINDS, strict=True):
        heights = Kernels(number, width, sigma).heights(s)
        for k, look in zip(range(number), looks(), strict=False):
            awake = (
                np.convolve(heights[:, k] > 0, [1, 1, 1], mode="same") > 0
            )  # and one sample more: the cut is seen
            bump = np.where(awake, heights[:, k], np.nan)
            panel.plot(s, bump, color=look["color"], linestyle="-", linewidth=1.6)
            panel.fill_between(s, np.nan_to_num(bump), color=look["color"], alpha=0.12, linewidth=0)
        asleep = heights.max(axis=1) == 0
        panel.fill_between(s, 0, 1.08, where=asleep, color="#DDDDDD", linewidth=0, step="mid")
        dressed(panel, "phase s", "height ψ(s)" if panel is panels[0][0] else "", title)
        panel.set_ylim(0, 1.08)
        panel.set_xlim(0, 1)
    return figure


def error_over_width(curves: ErrorCurves, variant: str | None = None) -> Figure:
    """The paper's figure 3: error against kernel width, a line for each letter.

    Args:
        curves: From `error_against_width`.
        variant: Which of `curves.variants`; the first unless given; "all" draws a line for each variant instead.
    """
    x = np.where(np.isinf(curves.x), FULL, curves.x)
    figure, panel = _errors(curves, variant, x, "kernel width [1/N]")
    panel.axvspan(1, 4, color=SHADE, linewidth=0, zorder=0)
    words = WIDTH_TICKS | ({FULL: "no ends"} if np.isinf(curves.x).any() else {})
    plain_log(panel.xaxis, list(words), words)
    panel.text(
        2,
        0.985,
        "1/N to 4/N",
        transform=panel.get_xaxis_transform(),
        ha="center",
        va="top",
        color=QUIET,
    )
    return figure


def error_over_number(curves: ErrorCurves, variant: str | None = None) -> Figure:
    """The paper's figure 5: error against the number of kernels, a line for each letter.

    Args:
        curves: From `error_against_number`.
        variant: Which of `curves.variants`; the first unless given; "all" draws a line for each variant instead.
    """
    figure, panel = _errors(curves, variant, curves.x, "kernels per sample, N / Num")
    panel.axvline(0.1, color=INK, linewidth=1, linestyle=(0, (2, 2)))
    panel.text(
        0.104,
        0.985,
        "N = Num/10",
        transform=panel.get_xaxis_transform(),
        va="top",
        color=INK,
        fontsize=9,
    )
    ticks = [
        t
        for t in (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
        if curves.x[0] * 0.9 <= t <= curves.x[-1] * 1.1
    ]
    plain_log(panel.xaxis, ticks)
    return figure


def _errors(curves: ErrorCurves, variant: str | None, x: Array, name: str) -> tuple[Figure, Axes]:
    """A figure with the error over x (K,), whose name it is, a line for each letter or variant; and its panel."""
    figure, panels = sheet(1, 1, 7.2, 4.6)
    panel = panels[0][0]
    lines = _lines(curves, variant)
    for (label, error), look in zip(lines.items(), looks(), strict=False):
        panel.plot(x, 1e3 * error, label=label, **look)
    dressed(panel, name, "error, root mean square [mm]", _title(curves, variant))
    panel.set_xscale("log")
    decades(panel, 1e3 * np.concatenate(list(lines.values())))
    explained(panel, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure, panel


def goal_change_over_time(traces: Traces) -> Figure:
    """The paper's figure 6: position and velocity of one coordinate whose goal moved.

    Args:
        traces: From `goal_traces`.
    """
    figure, panels = sheet(2, 1, 6.4, 5.6, sharex=True)
    parts = ((traces.position, "position [mm]"), (traces.velocity, "velocity [mm/s]"))
    styles = {
        "demonstration": (CHILD, (0, (5, 2)), 2.2),
        "DMP*": (ROBOT, "-", 1.8),
        "original": (OTHER, "-.", 1.8),
    }
    for panel, (values, label) in zip(panels[:, 0], parts, strict=True):
        for name, (colour, line, wide) in styles.items():
            panel.plot(
                traces.t,
                1e3 * values[name],
                color=colour,
                linestyle=line,
                linewidth=wide,
                label=name,
            )
        dressed(panel, "", label)
    goal = 1e3 * (traces.position["demonstration"][-1] + traces.shift)
    panels[0, 0].plot(
        traces.t[-1],
        goal,
        marker="o",
        markerfacecolor="white",
        color=INK,
        linestyle="",
        label="new goal",
    )
    shift = f"{1e3 * traces.shift:+.0f} mm".replace("-", "−")
    dressed(
        panels[0, 0], "", "position [mm]", f"{traces.stroke}: the goal moves by {shift}".strip(": ")
    )
    panels[1, 0].set_xlabel("time [s]", color=INK)
    explained(panels[0, 0], loc="best", ncols=2)
    return figure


def kernel_choice(choice: Choice) -> Figure:
    """The curve of a validation, with the choice and both rules of thumb.

    Args:
        choice: From `choose_kernels` or `choose_width`.
    """
    figure, panels = sheet(1, 1, 6.8, 4.2)
    panel = panels[0][0]
    x = np.where(np.isinf(choice.candidates), FULL, choice.candidates)
    panel.plot(
        x,
        1e3 * choice.taught,
        color=QUIET,
        linestyle="--",
        linewidth=1.4,
        label="samples that were shown",
    )
    panel.plot(
        x,
        1e3 * choice.error,
        color=ROBOT,
        marker="o",
        markersize=4.5,
        label="samples that were not shown",
    )
    chosen = int(np.argmax(choice.candidates == choice.chosen))
    about = {"markersize": 13, "markerfacecolor": "none", "markeredgewidth": 2, "linestyle": ""}
    panel.plot(
        x[chosen],
        1e3 * choice.error[chosen],
        marker="o",
        color=INK,
        label=f"chosen: {choice.chosen:g}",
        **about,
    )
    if choice.name == "n_kernels":
        panel.axvline(
            choice.tenth, color=COLOURS[1], linestyle=":", label=f"Num/10: {choice.tenth}"
        )
        panel.axvline(
            choice.twelve_a_second,
            color=COLOURS[2],
            linestyle="-.",
            label=f"12 a second: {choice.twelve_a_second}",
        )
    label = "number of kernels N" if choice.name == "n_kernels" else "kernel width [1/N]"
    dressed(panel, label, "error, root mean square [mm]")
    panel.set_xscale("log")
    ticks = [t for t in (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500) if x[0] <= t <= x[-1]]
    ends = {FULL: "no ends"} if np.isinf(choice.candidates).any() else {}
    plain_log(panel.xaxis, [*ticks, *ends], ends)
    decades(panel, 1e3 * np.concatenate([choice.error, choice.taught]))
    explained(panel, loc="best")
    return figure


def _lines(curves: ErrorCurves, variant: str | None) -> dict[str, Array]:
    """What is drawn: the median of each letter's strokes in one variant, or of all strokes in each."""
    if variant == "all":
        return dict(zip(curves.variants, curves.median, strict=True))
    error, letters = curves.of(variant or curves.variants[0]), np.array(curves.characters)
    return {
        f"‘{name}’": np.median(error[letters == name], axis=0)
        for name in dict.fromkeys(curves.characters)
    }


def _title(curves: ErrorCurves, variant: str | None) -> str:
    """Which variant, and of how many strokes."""
    name = "medians" if variant == "all" else (variant or curves.variants[0])
    return f"{name}, over {len(curves.strokes)} strokes"
