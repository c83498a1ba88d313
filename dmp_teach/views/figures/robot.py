"""Figures of the robot: where a page can lie, and how it writes."""

from __future__ import annotations

from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import imread

from dmp_teach.arguments import checked
from dmp_teach.errors import ViewError, kind_of
from dmp_teach.robot import (
    ROBOT_PARTS,
    TIP_TOLERANCE,
    Model,
    Motion,
    Page,
    ReachMap,
    Run,
    outline_from_above,
)
from dmp_teach.trajectory import Array
from dmp_teach.views.figures.figure_style import DrawStyle, add_legend_below, new_figure, style_axes
from dmp_teach.views.palette import MUTED_COLOR, SHADE_COLOR, STROKE_COLORS, TEXT_COLOR
from dmp_teach.views.scene.picture import render_png
from dmp_teach.views.scene.stage import Stage

# Each a form of its own, so that they stay apart in grey.
REACH_LOOKS: dict[str, DrawStyle] = {
    "reached": {"marker": "o", "markersize": 6.5, "color": STROKE_COLORS[0]},
    "reached, but a joint must hurry": {
        "marker": "s",
        "markersize": 6,
        "color": STROKE_COLORS[1],
        "markerfacecolor": "white",
        "markeredgewidth": 1.6,
    },
    "near enough, but robot or paper is in the way": {
        "marker": "x",
        "markersize": 5.5,
        "color": STROKE_COLORS[3],
        "markeredgewidth": 1.8,
    },
    "too far": {"marker": ".", "markersize": 2.5, "color": MUTED_COLOR},
}


@checked
def draw_reach(*maps: ReachMap) -> Figure:
    """Draw where a page can lie, a panel for each map.

    Maps that are seen from above show the robot, too.

    Args:
        maps: From `reach_around`, seen from above, and `reach_map`, page distance against pen
            angle.

    Raises:
        ViewError: No map, or something else.
    """
    if not maps or not all(isinstance(each, ReachMap) for each in maps):
        raise ViewError("draw_reach takes maps, as reach_map() and reach_around() give them.")
    figure, panels = new_figure(1, len(maps), 6.0 * len(maps), 5.9)
    for panel, each in zip(panels[0], maps, strict=True):
        (_plot_from_above if each.across_name == "y" else _plot_by_tilt)(panel, each)
    add_legend_below(figure, panels[0, 0], columns=2 if len(maps) == 1 else 4)
    return figure


@checked
def draw_writing(motion: Motion | Run, camera: str = "over the shoulder") -> Figure:
    """Draw the robot that writes, in six frames from left to right and then down (figure 1).

    Args:
        motion: What the robot does, or the run that shows what it did.
        camera: "whole robot", "over the shoulder" or "page from above".

    Raises:
        ViewError: Neither a motion nor a run.
        SettingError: Another camera.
        MissingPartError: pybullet, which draws the frames, is not installed.
    """
    if not isinstance(motion, Motion | Run):
        raise ViewError(f"motion is {kind_of(motion)}, but must be a Motion or a Run.")
    run = motion if isinstance(motion, Run) else None
    stage = Stage(motion.motion if isinstance(motion, Run) else motion, run)
    rows, columns = 2, 3
    figure, panels = new_figure(rows, columns, 4.0 * columns, 2.8 * rows)
    down = np.flatnonzero(motion.planned.pen_down if isinstance(motion, Run) else motion.pen_down)
    moments = motion.t[down[np.linspace(0, len(down) - 1, rows * columns).astype(int)]]
    for panel, moment in zip(panels.flat, moments, strict=True):
        picture = render_png(stage, float(moment - motion.t[0]), camera, 480, 320)
        panel.imshow(imread(BytesIO(picture)))
        panel.set_axis_off()
        panel.set_title(f"{moment - motion.t[0]:.1f} s", fontsize=10, color=TEXT_COLOR)
    return figure


def _plot_from_above(panel: Axes, reach: ReachMap) -> None:
    """Plot the robot from above, looking up the panel, and a mark at each page's centre."""
    right = "page's centre to the robot's right [m]"
    page = reach.pages[0][0]
    steep = page.normal[2]
    thing = "table" if steep > 0.9 else "board" if steep < 0.1 else "slanted desk"
    title = f"A {thing}, seen from above"
    style_axes(panel, right, "page's centre ahead of the robot [m]", title)
    panel.set_aspect("equal", adjustable="box")
    for links in ROBOT_PARTS:
        outline = outline_from_above(links)
        look: DrawStyle = {"facecolor": SHADE_COLOR, "edgecolor": MUTED_COLOR, "linewidth": 1.1}
        panel.fill(-outline[:, 1], outline[:, 0], **look)
    x, y = Model.load().frame("shoulder_pan_link", np.empty((1, 0)), ())[0, :2, 3]
    look = {"marker": "o", "markersize": 8, "markerfacecolor": "white", "zorder": 4}
    panel.plot(-y, x, color=TEXT_COLOR, **look)
    _name_place(panel, "where the arm begins", (-y, x), (0.36, -0.12))
    _plot_marks(panel, reach, *np.meshgrid(-reach.across, reach.x, indexing="ij"))
    usual = page.moved(getattr(Page, page.kind)().X_world_page[:3, 3] - page.X_world_page[:3, 3])
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) / 2
    outline = usual.to_world(corners * page.size)
    panel.plot(-outline[:, 1], outline[:, 0], color=TEXT_COLOR, linewidth=1.3, zorder=5)
    size = " x ".join(f"{1000 * side:.0f}" for side in page.size)
    name = f"a sheet of {size} mm\nwhere it usually lies"
    _name_place(panel, name, (-outline[:, 1].min(), outline[:, 0].max()), (0.36, 1.17))


def _plot_by_tilt(panel: Axes, reach: ReachMap) -> None:
    """Plot page distance against pen angle, and beside each row a line that leans as its pages."""
    degrees = np.degrees(reach.across)
    style_axes(
        panel,
        "page's centre ahead of the robot [m]",
        "pen's angle from the vertical = page's tilt [degrees]",
        "From a table (0) to a whiteboard (90), straight ahead",
    )
    _plot_marks(panel, reach, *np.meshgrid(reach.x, degrees))
    panel.set_yticks(degrees if len(degrees) <= 12 else np.arange(0, 91, 10))
    for lean in degrees:
        look: DrawStyle = {"marker": (2, 2, lean - 90), "markersize": 17, "markeredgewidth": 1.6}
        panel.plot(reach.x.max() + 0.08, lean, color=TEXT_COLOR, **look)


def _plot_marks(panel: Axes, reach: ReachMap, right: Array, up: Array) -> None:
    """Plot a mark for every page at (R, C) places of the panel."""
    near = ~reach.reached & (reach.residual <= TIP_TOLERANCE)
    at_ease = reach.at_ease
    kinds = (at_ease, reach.reached & ~at_ease, near, ~reach.reached & ~near)
    for (name, look), where in zip(REACH_LOOKS.items(), kinds, strict=True):
        panel.plot(right[where], up[where], linestyle="", label=name, zorder=3, **look)


def _name_place(
    panel: Axes, name: str, place: tuple[float, float], at: tuple[float, float]
) -> None:
    """Write a name beside a thing, with a thin line to it."""
    look: DrawStyle = {
        "arrowprops": {"arrowstyle": "-", "color": MUTED_COLOR, "linewidth": 0.8},
        "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1.5},
    }
    panel.annotate(name, place, at, color=TEXT_COLOR, fontsize=9, va="center", zorder=6, **look)
