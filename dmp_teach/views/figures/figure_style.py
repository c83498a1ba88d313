"""Style of the figures: light paper, few lines, and curves that stay apart in grey."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from io import BytesIO
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from dmp_teach.trajectory import Array
from dmp_teach.views.palette import GRID_COLOR, MUTED_COLOR, STROKE_COLORS, TEXT_COLOR

CURVE_MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*", "<")
CURVE_LINES = (
    "-",
    "--",
    "-.",
    ":",
    (0, (5, 1, 1, 1, 1, 1)),
    (0, (8, 2)),
    (0, (1, 1)),
    (0, (3, 1, 3, 3)),
)
REFUSED = "The original form cannot learn a coordinate that ends where it began."
RING_MARKER = {"marker": "o", "markersize": 9, "markerfacecolor": "none"}
FIGURE_DPI = 144

# Any: the values of matplotlib's keywords.
DrawStyle = dict[str, Any]


class PaperFigure(Figure):
    """A matplotlib figure that a notebook shows by itself, without any magic."""

    def _repr_png_(self) -> bytes:
        """Return the picture, for a notebook."""
        stream = BytesIO()
        self.savefig(stream, format="png", dpi=FIGURE_DPI)
        return stream.getvalue()


# Any: the values of matplotlib's keywords, here and below.
def new_figure(
    rows: int, columns: int, width: float, height: float, **options: Any
) -> tuple[PaperFigure, np.ndarray]:
    """Make a figure [inch] with panels, shape (rows, columns); options go to `subplots`."""
    figure = PaperFigure(figsize=(width, height), layout="constrained", facecolor="white")
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def style_axes(panel: Axes, x: str = "", y: str = "", title: str = "") -> Axes:
    """Give a panel its labels, a light grid and no box; return it."""
    panel.set_xlabel(x, color=TEXT_COLOR, fontsize=10)
    panel.set_ylabel(y, color=TEXT_COLOR, fontsize=10)
    panel.set_title(title, color=TEXT_COLOR, fontsize=10.5, loc="left")
    panel.grid(True, color=GRID_COLOR, linewidth=0.7)
    panel.set_axisbelow(True)
    panel.tick_params(colors=MUTED_COLOR, labelsize=9, length=3)
    for side, spine in panel.spines.items():
        spine.set_visible(side in ("left", "bottom"))
        spine.set_color(MUTED_COLOR)
    return panel


def style_paper(panel: Axes, title: str = "") -> Axes:
    """Make a panel a piece of paper, with equal axes and a grid; return it."""
    style_axes(panel, title=title).set_aspect("equal", adjustable="box")
    return panel


def plot_path(panel: Axes, path: Array, **look: Any) -> None:
    """Plot a path, shape (T, 2) [m], in millimetres."""
    panel.plot(*(1e3 * path).T, **look)


def label_millimetres(panels: np.ndarray, fontsize: float = 10) -> None:
    """Label axes in mm at the left and at the bottom only."""
    for panel in panels[:, 0]:
        panel.set_ylabel("y, up the page [mm]", fontsize=fontsize)
    for panel in panels[-1]:
        panel.set_xlabel("x, to the right [mm]", fontsize=fontsize)


def add_legend(panel: Axes, **options: Any) -> None:
    """Add a legend without a box."""
    panel.legend(frameon=False, fontsize=9, labelcolor=TEXT_COLOR, handlelength=2.8, **options)


def add_legend_below(figure: Figure, panel: Axes, columns: int = 6) -> None:
    """Add one legend for all panels below them."""
    figure.legend(
        *panel.get_legend_handles_labels(),
        loc="outside lower center",
        ncols=columns,
        frameon=False,
        fontsize=9,
        labelcolor=TEXT_COLOR,
    )


def cycle_looks() -> Iterator[DrawStyle]:
    """Yield colour, line and marker for any number of curves, each unlike the one before."""
    looks = zip(cycle(STROKE_COLORS), cycle(CURVE_LINES), cycle(CURVE_MARKERS), strict=False)
    for color, line, marker in looks:
        look: DrawStyle = {"color": color, "linestyle": line, "marker": marker}
        yield look | {"markersize": 4.5, "linewidth": 1.6}


def set_log_ticks(axis: Axis, ticks: list[float], names: dict[float, str] | None = None) -> None:
    """Give a logarithmic axis these ticks only, as plain numbers or by these names."""
    known = names or {}
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(
        FuncFormatter(lambda value, _: known.get(round(value, 6), f"{value:g}"))
    )


def set_log_y_axis(panel: Axes, values: Array, floor: float = 1e-3) -> None:
    """Make the y axis logarithmic, in plain numbers; smaller values than `floor` are cut off."""
    finite = np.maximum(values[np.isfinite(values)], floor)
    low = finite.min() / 1.4
    high = finite.max() * 1.4
    parts = (1,) if high / low > 300 else (1, 2, 5)
    powers = np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    panel.set_yscale("log")
    set_log_ticks(panel.yaxis, [part * 10.0**k for k in powers for part in parts])
    panel.set_ylim(low, high)


def set_same_view(panels: Iterable[Axes], points: Array) -> None:
    """Show the same piece of paper in all panels: all points, shape (T, 2), and a margin."""
    low = points.min(axis=0)
    high = points.max(axis=0)
    margin = 0.06 * (high - low).max()
    for panel in panels:
        panel.set_xlim(low[0] - margin, high[0] + margin)
        panel.set_ylim(low[1] - margin, high[1] + margin)
