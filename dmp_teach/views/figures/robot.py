"""Figures of the robot from its data: where a page can lie."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.spatial import ConvexHull

from dmp_teach.errors import ViewError
from dmp_teach.robot import TIP, Model, Page, ReachMap, solids_of
from dmp_teach.trajectory import Array
from dmp_teach.views.figures.figure_style import (
    COLOURS,
    INK,
    QUIET,
    SHADE,
    dressed,
    explained_below,
    sheet,
)

_BLUE, _VERMILION, _PINK = COLOURS[0], COLOURS[1], COLOURS[3]
_LOOKS = {  # each a form of its own, so that they stay apart in grey
    "reached": {"marker": "o", "markersize": 6.5, "color": _BLUE},
    "reached, but a joint must hurry": {
        "marker": "s",
        "markersize": 6,
        "color": _VERMILION,
        "markerfacecolor": "white",
        "markeredgewidth": 1.6,
    },
    "near enough, but robot or paper is in the way": {
        "marker": "x",
        "markersize": 5.5,
        "color": _PINK,
        "markeredgewidth": 1.8,
    },
    "too far": {"marker": ".", "markersize": 2.5, "color": QUIET},
}
_PARTS = (
    ("base_link",),
    ("torso_fixed_link", "torso_lift_link"),
    ("head_pan_link", "head_tilt_link"),
)


def reach_drawn(*maps: ReachMap) -> Figure:
    """Where a page can lie: a panel for each map, the robot from above in those that are seen from above.

    Args:
        maps: From `reach_around`, seen from above, and `reach_map`, page distance against pen angle.

    Raises:
        ViewError: No map, or something else.
    """
    if not maps or not all(isinstance(each, ReachMap) for each in maps):
        raise ViewError("reach_drawn takes maps, as reach_map() and reach_around() give them.")
    figure, panels = sheet(1, len(maps), 6.0 * len(maps), 5.9)
    for panel, each in zip(panels[0], maps, strict=True):
        (_from_above if each.across_name == "y" else _by_tilt)(panel, each)
    explained_below(figure, panels[0, 0], columns=2 if len(maps) == 1 else 4)
    return figure


def _from_above(panel: Axes, each: ReachMap) -> None:
    """The robot from above, looking up the panel; a mark where a page's centre may be."""
    page = each.pages[0][0]
    dressed(
        panel,
        "page's centre to the robot's right [m]",
        "page's centre ahead of the robot [m]",
        "Seen from above",
    )
    panel.set_aspect("equal", adjustable="box")
    for links in _PARTS:
        outline = _outline(links)
        panel.fill(-outline[:, 1], outline[:, 0], facecolor=SHADE, edgecolor=QUIET, linewidth=1.1)
    shoulder = Model.load().frame("shoulder_pan_link", np.empty((1, 0)), ())[0, :2, 3]
    panel.plot(
        -shoulder[1],
        shoulder[0],
        marker="o",
        markersize=8,
        color=INK,
        markerfacecolor="white",
        zorder=4,
    )
    _named(panel, "where the arm begins", (-shoulder[1], shoulder[0]), (0.36, -0.12))
    _marks(panel, each, *np.meshgrid(-each.across, each.x, indexing="ij"))
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) / 2
    usual = page.moved(getattr(Page, page.kind)().X_world_page[:3, 3] - page.X_world_page[:3, 3])
    outline = usual.to_world(corners * page.size)
    panel.plot(-outline[:, 1], outline[:, 0], color=INK, linewidth=1.3, zorder=5)
    size = " x ".join(f"{1000 * side:.0f}" for side in page.size)
    _named(
        panel,
        f"a sheet of {size} mm\nwhere it usually lies",
        (-outline[:, 1].min(), outline[:, 0].max()),
        (0.36, 1.17),
    )


def _by_tilt(panel: Axes, each: ReachMap) -> None:
    """Page distance against pen angle; beside each row a line that leans as its pages do, seen from the side."""
    degrees = np.degrees(each.across)
    angle = "pen's angle from the vertical = page's tilt [degrees]"
    dressed(
        panel,
        "page's centre ahead of the robot [m]",
        angle,
        "From a table (0) to a whiteboard (90), straight ahead",
    )
    _marks(panel, each, *np.meshgrid(each.x, degrees))
    panel.set_yticks(degrees if len(degrees) <= 12 else np.arange(0, 91, 10))
    for lean in degrees:
        panel.plot(
            each.x.max() + 0.08,
            lean,
            marker=(2, 2, lean - 90),
            markersize=17,
            markeredgewidth=1.6,
            color=INK,
        )


def _marks(panel: Axes, each: ReachMap, right: Array, up: Array) -> None:
    """A mark for every page at (R, C) places of the panel."""
    near = ~each.reached & (each.residual <= TIP)
    kinds = (each.at_ease, each.reached & ~each.at_ease, near, ~each.reached & ~near)
    for (name, look), where in zip(_LOOKS.items(), kinds, strict=True):
        panel.plot(right[where], up[where], linestyle="", label=name, zorder=3, **look)


def _named(panel: Axes, words: str, place: tuple[float, float], at: tuple[float, float]) -> None:
    """A word beside a thing, and a thin line to it."""
    line = {"arrowstyle": "-", "color": QUIET, "linewidth": 0.8}
    white = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    panel.annotate(
        words, place, at, color=INK, fontsize=9, va="center", arrowprops=line, bbox=white, zorder=6
    )


def _outline(links: tuple[str, ...]) -> Array:
    """What some links of the robot look like from above: the hull of their solids, shape (n, 2) [m]."""
    poses = Model.load().link_poses(np.empty((1, 0)), ())
    points = np.concatenate(
        [
            s.surface() @ poses[s.link][0, :3, :3].T + poses[s.link][0, :3, 3]
            for s in solids_of()
            if s.link in links
        ]
    )[:, :2]
    return points[ConvexHull(points).vertices]
