"""The strip under a run's picture: how hard the pen pressed, up to a moment, as pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import FORCE_BAND, Run
from dmp_teach.texts import gettext as _
from dmp_teach.views.palette import MUTED_COLOR, ROBOT_COLOR, TEXT_COLOR
from dmp_teach.views.scene.pen_force import find_pen_down, select_curve_rows

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STRIP_COLOR = "#FFFDF7"
FUTURE_COLOR = "#B9BEC4"
GOOD_FORCE_COLOR = "#DDEFE6"
GOOD_FORCE_EDGE_COLOR = "#2F9C7A"

STRIP_TOP = 1.6
"""The strip ends at this force, so that its scale is always the same [N]."""

_PEN_DOWN_HEIGHT = -0.25


def draw_force_strip(run: Run, time: float, width: int, height: int) -> NDArray[np.uint8]:
    """Draw the strip of a run at a time [s]: red, green and blue, shape (height, width, 3)."""
    # Only this picture needs matplotlib.
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    dpi = 100 * width / 900
    figure = Figure(figsize=(width / dpi, height / dpi), dpi=dpi, facecolor=STRIP_COLOR)
    canvas = FigureCanvasAgg(figure)
    panel = figure.add_axes((0.085, 0.13, 0.885, 0.66), facecolor=STRIP_COLOR)
    _draw_background(panel, run)
    _plot_force(panel, run, time)
    _write_numbers(figure, run, time)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3]
    return np.ascontiguousarray(pixels[:height, :width])


def _draw_background(panel: Axes, run: Run) -> None:
    """Draw the band of good pressing, and the line where nothing presses."""
    panel.set_xlim(0, max(run.duration, 1e-6))
    panel.set_ylim(-0.42, STRIP_TOP)
    panel.axhspan(*FORCE_BAND, color=GOOD_FORCE_COLOR, linewidth=0)
    for force in FORCE_BAND:
        panel.axhline(force, color=GOOD_FORCE_EDGE_COLOR, linewidth=1, dashes=(5, 3))
    panel.axhline(0, color=FUTURE_COLOR, linewidth=1)
    panel.text(
        0.995,
        FORCE_BAND[1] - 0.06,
        _("good pressing"),
        transform=panel.get_yaxis_transform(),
        ha="right",
        va="top",
        color=MUTED_COLOR,
        fontsize=9,
    )
    names = [*(f"{force} N" for force in FORCE_BAND), _("pen down")]
    panel.set_yticks([*FORCE_BAND, _PEN_DOWN_HEIGHT], names)
    panel.set_xticks([])
    panel.tick_params(length=0, labelcolor=MUTED_COLOR, labelsize=9, pad=6)
    for spine in panel.spines.values():
        spine.set_visible(False)


def _plot_force(panel: Axes, run: Run, time: float) -> None:
    """Plot the force until now in the robot's blue, the rest in grey, and the moment itself."""
    rows = select_curve_rows(run.force)
    t = run.t[rows] - run.t[0]
    force = np.minimum(run.force[rows], STRIP_TOP)
    panel.plot(t, force, color=FUTURE_COLOR, linewidth=1.4)
    now = min(float(np.interp(time, t, run.force[rows])), STRIP_TOP)
    past = t <= time
    until_now = (np.append(t[past], time), np.append(force[past], now))
    panel.plot(*until_now, color=ROBOT_COLOR, linewidth=2.2)
    for start, end in find_pen_down(run):
        for last, color in ((end, FUTURE_COLOR), (min(end, time), TEXT_COLOR)):
            if last > start:
                heights = [_PEN_DOWN_HEIGHT, _PEN_DOWN_HEIGHT]
                panel.plot([start, last], heights, color=color, linewidth=6, solid_capstyle="round")
    panel.axvline(time, color=TEXT_COLOR, linewidth=1.4)
    panel.plot(
        [time],
        [now],
        "o",
        color=ROBOT_COLOR,
        markersize=8,
        markeredgecolor=STRIP_COLOR,
        clip_on=False,
    )


def _write_numbers(figure: Figure, run: Run, time: float) -> None:
    """Write what the strip is, when, and how hard."""
    now = float(np.interp(time, run.t - run.t[0], run.force))
    said = _("now {now:.1f} N")
    if run.greatest_force > STRIP_TOP:
        said = _("now {now:.1f} N, at most {most:.1f} N")
    said = said.format(now=now, most=run.greatest_force)
    title = figure.text(0.012, 0.95, _("How hard the pen presses"), color=TEXT_COLOR, fontsize=10.5)
    title.set(fontweight="bold", va="top")
    figure.text(0.30, 0.95, said, color=ROBOT_COLOR, fontsize=10.5, va="top")
    clock_words = _("{now} s of {end} s").format(now=f"{time:.1f}", end=f"{run.duration:.1f}")
    clock = figure.text(0.97, 0.95, clock_words, color=MUTED_COLOR)
    clock.set(fontsize=10, va="top", ha="right")
