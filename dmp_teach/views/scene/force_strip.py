"""The strip under a run's picture: how hard the pen pressed, up to a moment, as pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import BAND, Run
from dmp_teach.views.scene import pressing

INK, QUIET, PAPER, TRACK = "#1B2430", "#5B6470", "#FFFDF7", "#B9BEC4"
ROBOT, GOOD, EDGE = "#0072B2", "#DDEFE6", "#2F9C7A"

TOP = 1.6
"""The strip ends at this force, so that its scale is always the same [N]."""


def force_strip(run: Run, time: float, width: int, height: int) -> NDArray[np.uint8]:
    """Draw the strip.

    Args:
        run: What happened.
        time: The moment at which the picture was taken [s].
        width: Of the strip [pixels].
        height: Of the strip [pixels].

    Returns:
        Red, green and blue, shape (height, width, 3).
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415 (only this picture needs it)
    from matplotlib.figure import Figure  # noqa: PLC0415

    dpi = 100 * width / 900
    figure = Figure(figsize=(width / dpi, height / dpi), dpi=dpi, facecolor=PAPER)
    canvas = FigureCanvasAgg(figure)
    panel = figure.add_axes((0.085, 0.13, 0.885, 0.66), facecolor=PAPER)
    _band(panel, run)
    _curve(panel, run, time)
    _words(figure, run, time)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3]
    return np.ascontiguousarray(pixels[:height, :width])


def _band(panel, run: Run) -> None:
    """Good pressing, and where nothing presses."""
    panel.set_xlim(0, max(run.duration, 1e-6))
    panel.set_ylim(-0.42, TOP)
    panel.axhspan(*BAND, color=GOOD, linewidth=0)
    for force in BAND:
        panel.axhline(force, color=EDGE, linewidth=1, dashes=(5, 3))
    panel.axhline(0, color=TRACK, linewidth=1)
    panel.text(
        0.995,
        BAND[1] - 0.06,
        "good pressing",
        transform=panel.get_yaxis_transform(),
        ha="right",
        va="top",
    )
    panel.texts[-1].set(color=QUIET, fontsize=9)
    panel.set_yticks([*BAND, -0.25], [*(f"{force} N" for force in BAND), "pen down"])
    panel.set_xticks([])
    panel.tick_params(length=0, labelcolor=QUIET, labelsize=9, pad=6)
    for spine in panel.spines.values():
        spine.set_visible(False)


def _curve(panel, run: Run, time: float) -> None:
    """The force until now in the robot's blue, the rest in grey, and the moment itself."""
    rows = pressing.curve(run.force)
    t, force = run.t[rows] - run.t[0], run.force[rows]
    shown = np.minimum(force, TOP)
    panel.plot(t, shown, color=TRACK, linewidth=1.4)
    now = float(np.interp(time, t, force))
    past = t <= time
    panel.plot(
        np.append(t[past], time), np.append(shown[past], min(now, TOP)), color=ROBOT, linewidth=2.2
    )
    for start, end in pressing.down(run):
        for first, last, color in ((start, end, TRACK), (start, min(end, time), INK)):
            if last > first:
                panel.plot(
                    [first, last], [-0.25, -0.25], color=color, linewidth=6, solid_capstyle="round"
                )
    panel.axvline(time, color=INK, linewidth=1.4)
    panel.plot(
        [time],
        [min(now, TOP)],
        "o",
        color=ROBOT,
        markersize=8,
        markeredgecolor=PAPER,
        clip_on=False,
    )


def _words(figure, run: Run, time: float) -> None:
    """What it is, when, and how hard."""
    t = run.t - run.t[0]
    now = float(np.interp(time, t, run.force))
    figure.text(
        0.012,
        0.95,
        "How hard the pen presses",
        color=INK,
        fontsize=10.5,
        fontweight="bold",
        va="top",
    )
    most = f", at most {run.greatest_force:.1f} N" if run.greatest_force > TOP else ""
    figure.text(0.30, 0.95, f"now {now:.1f} N{most}", color=ROBOT, fontsize=10.5, va="top")
    figure.text(
        0.97,
        0.95,
        f"{time:.1f} s of {run.duration:.1f} s",
        color=QUIET,
        fontsize=10,
        va="top",
        ha="right",
    )
