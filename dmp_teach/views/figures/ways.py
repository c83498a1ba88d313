"""A figure of ways to learn: the same takes and the same goals, in every way."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import ViewError, kind_of, shown
from dmp_teach.studies import WaysTried, WayTried
from dmp_teach.views.figures.figure_style import (
    RING_MARKER,
    DrawStyle,
    add_legend_below,
    label_millimetres,
    new_figure,
    plot_path,
    set_same_view,
    style_paper,
)
from dmp_teach.views.palette import COMPARED_COLOR, PERSON_COLOR, ROBOT_COLOR, TEXT_COLOR

MOVED_LOOK: DrawStyle = {"color": COMPARED_COLOR, "linestyle": (0, (5, 1.5)), "linewidth": 1.8}
# Lines that go farther than this around the takes are cut [m].
MOST_BEYOND = 0.12


@checked
def draw_ways_to_learn(tried: WaysTried, numbers: Sequence[int] | None = None) -> Figure:
    """Draw the letter of every way, to its own goal and to the one that moved.

    Args:
        tried: From `compare_ways_to_learn`.
        numbers: Of demonstrations, a row for each; the fewest and five, or the most, unless given.

    Raises:
        ViewError: Something else, no number, or one that was not tried.
    """
    if not isinstance(tried, WaysTried):
        raise ViewError(f"tried is {kind_of(tried)}, but must be from compare_ways_to_learn().")
    known = sorted({len(each.takes) for each in tried.items})
    default = dict.fromkeys([known[0], 5 if 5 in known else known[-1]])
    rows = list(default) if numbers is None else numbers
    if not isinstance(rows, Sequence) or not rows or any(each not in known for each in rows):
        raise ViewError(f"numbers is {shown(rows)}, but {', '.join(map(str, known))} were tried.")
    names = list(dict.fromkeys(each.way.name for each in tried.items))
    size = (2.75 * len(names), 2.3 * len(rows) + 0.6)
    figure, panels = new_figure(len(rows), len(names), *size, sharex=True, sharey=True)
    for each in tried.items:
        if len(each.takes) in rows:
            _plot_way(panels[rows.index(len(each.takes)), names.index(each.way.name)], each)
    drawn = [take.position for each in tried.items for take in each.takes]
    seen = np.concatenate([*drawn, *(each.goal[None] for each in tried.items)])
    low, high = seen.min(axis=0) - MOST_BEYOND / 3, seen.max(axis=0) + MOST_BEYOND / 3
    set_same_view(panels.flat, 1e3 * np.array([low, high]))
    add_legend_below(figure, panels[0, 0])
    label_millimetres(panels)
    return figure


def _plot_way(panel: Axes, tried: WayTried) -> None:
    """Plot takes, the letter to its own goal, and the one to the goal that moved."""
    for number, take in enumerate(tried.takes):
        look: DrawStyle = {"color": PERSON_COLOR, "linestyle": ":", "linewidth": 1.2}
        plot_path(panel, take.position, label="" if number else "as it was shown", **look)
    plot_path(panel, tried.letter.position, color=ROBOT_COLOR, linewidth=2.0, label="as learned")
    plot_path(panel, tried.moved.position, label="to a goal that moved", **MOVED_LOOK)
    ring = RING_MARKER | {"color": TEXT_COLOR, "linestyle": "", "label": "new goal"}
    plot_path(panel, tried.goal[None], **ring)
    count = len(tried.takes)
    off = f"{1e3 * tried.error:.1f} mm off, misses by {1e3 * tried.miss:.0f}"
    style_paper(panel, f"{tried.way.name}, {count} shown\n{off}")
