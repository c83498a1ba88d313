"""The figure of the whole chain: from a hand to the joints of the robot."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.ink import Recording
from dmp_teach.letters import Letter
from dmp_teach.robot import Motion
from dmp_teach.views.figures.figure_style import (
    CURVE_LINES,
    DrawStyle,
    add_legend,
    new_figure,
    plot_path,
    style_axes,
    style_paper,
)
from dmp_teach.views.palette import MUTED_COLOR, PERSON_COLOR, ROBOT_COLOR, STROKE_COLORS


@checked
def draw_pipeline(recording: Recording, letter: Letter, motion: Motion) -> Figure:
    """Draw the paper's figure 3 as our pipeline: capture, strokes, DMP*, letter and joints.

    Args:
        recording: What a hand wrote.
        letter: What was learned of it.
        motion: How the robot writes that.
    """
    figure, (panels,) = new_figure(1, 5, 16.0, 3.6)
    _plot_capture(panels[0], recording)
    for number, stroke in enumerate(letter.strokes):
        look: DrawStyle = {"color": PERSON_COLOR, "linestyle": CURVE_LINES[number % 4]}
        plot_path(panels[1], stroke.position, **look, linewidth=2)
    count = len(letter.strokes)
    style_paper(panels[1], f"2  {count} stroke{'s' * (count > 1)}")
    _plot_weights(panels[2], letter)
    for stroke in letter.write():
        plot_path(panels[3], stroke.position, color=ROBOT_COLOR, linewidth=2)
    style_paper(panels[3], "4  the letter written")
    for panel in (panels[1], panels[3]):
        panel.set_xlabel("x, to the right [mm]")
        panel.set_ylabel("y, up the page [mm]")
    _plot_joints(panels[4], motion)
    for panel in panels[:-1]:
        panel.set_title("→", loc="right", color=MUTED_COLOR, fontsize=14)
    return figure


def _plot_capture(panel: Axes, recording: Recording) -> None:
    """Plot the coordinates of the pen over time."""
    t = recording.t - recording.t[0]
    for name, values, color, line in zip(
        "xyz", recording.position.T, STROKE_COLORS, CURVE_LINES, strict=False
    ):
        panel.plot(t, 1e3 * values, color=color, linestyle=line, label=name)
    style_axes(panel, "time [s]", "pen [mm]", "1  a hand is captured")
    add_legend(panel, loc="best")


def _plot_weights(panel: Axes, letter: Letter) -> None:
    """Plot the weights of the first stroke, by the middle of their kernels in time."""
    primitive = letter.primitives[0]
    t = primitive.duration * (
        1 - (np.arange(len(primitive.weights)) + 0.5) / len(primitive.weights)
    )
    for name, weights, color, marker in zip(
        "xy", 1e3 * primitive.weights.T, STROKE_COLORS, "os", strict=False
    ):
        look: DrawStyle = {"color": color, "marker": marker, "markersize": 4, "linewidth": 0.8}
        panel.plot(t, weights, **look, label=name)
    style_axes(panel, "kernel's time [s]", "weight [mm]", f"3  DMP* learns {len(t)} kernels")
    add_legend(panel, loc="best")


def _plot_joints(panel: Axes, motion: Motion) -> None:
    """Plot how far each joint turns from where it begins."""
    turned = np.degrees(motion.q - motion.q[0])
    for number, values in enumerate(turned[:, 1:].T):
        color, line = STROKE_COLORS[number % len(STROKE_COLORS)], CURVE_LINES[number % 4]
        panel.plot(motion.t - motion.t[0], values, color=color, linestyle=line, linewidth=1.3)
    style_axes(panel, "time [s]", "joint's turn [degrees]", "5  the robot's joints write it")
