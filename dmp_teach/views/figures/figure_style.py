"""How figures look: light paper, few lines, colours for every eye, and line styles that stay apart in grey."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

INK, QUIET, GRID, SHADE = "#1B2430", "#5B6470", "#E6E6E6", "#F1EFE6"
CHILD, ROBOT, OTHER = "#D55E00", "#0072B2", "#CC79A7"
"""The demonstration, DMP*, and what it is compared with."""

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8A7A00")
"""Okabe and Ito's colours (yellow darkened, to be seen on white)."""

MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*")
LINES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)), (0, (1, 1)), (0, (3, 1, 3, 3)))
DPI = 144


class PaperFigure(Figure):
    """A matplotlib figure that a notebook shows by itself, without any magic."""

    def _repr_png_(self) -> bytes:
        """The picture, for a notebook."""
        stream = BytesIO()
        self.savefig(stream, format="png", dpi=DPI)
        return stream.getvalue()


def sheet(
    rows: int, columns: int, width: float, height: float, **about: Any
) -> tuple[PaperFigure, np.ndarray]:
    """A figure with panels.

    Args:
        rows: Of panels.
        columns: Of panels.
        width: Of the whole figure [inch].
        height: Of the whole figure [inch].
        about: What `Figure.subplots` takes, such as `sharex=True`.

    Returns:
        The figure, and its panels, shape (rows, columns).
    """
    figure = PaperFigure(figsize=(width, height), layout="constrained", facecolor="white")
    return figure, figure.subplots(rows, columns, squeeze=False, **about)


def dressed(panel: Axes, x: str = "", y: str = "", title: str = "") -> Axes:
    """A panel with its labels, a light grid and no box."""
    panel.set_xlabel(x, color=INK, fontsize=10)
    panel.set_ylabel(y, color=INK, fontsize=10)
    panel.set_title(title, color=INK, fontsize=10.5, loc="left")
    panel.grid(True, color=GRID, linewidth=0.7)
    panel.set_axisbelow(True)
    panel.tick_params(colors=QUIET, labelsize=9, length=3)
    for side, spine in panel.spines.items():
        spine.set_visible(side in ("left", "bottom"))
        spine.set_color(QUIET)
    return panel


def paper(panel: Axes, title: str = "") -> Axes:
    """A panel that is a piece of paper: equal axes in mm, no numbers but a grid."""
    dressed(panel, title=title)
    panel.set_aspect("equal", adjustable="box")
    return panel


def explained(panel: Axes, **about: Any) -> None:
    """A legend without a box."""
    panel.legend(frameon=False, fontsize=9, labelcolor=INK, handlelength=2.8, **about)


def looks() -> Iterator[dict[str, Any]]:
    """Colour, line and marker, each different from the one before, for as many curves as are asked for."""
    for colour, line, marker in zip(cycle(COLOURS), cycle(LINES), cycle(MARKERS), strict=False):
        yield {
            "color": colour,
            "linestyle": line,
            "marker": marker,
            "markersize": 4.5,
            "linewidth": 1.6,
        }


def plain_log(axis: Any, ticks: list[float], words: dict[float, str] | None = None) -> None:
    """A logarithmic axis with these ticks only, in plain numbers or in these words."""
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_minor_locator(NullLocator())
    named = words or {}
    axis.set_major_formatter(
        FuncFormatter(lambda value, _: named.get(round(value, 6), f"{value:g}"))
    )


def decades(panel: Axes, values: np.ndarray, floor: float = 1e-3) -> None:
    """A logarithmic y axis in plain numbers; what is smaller than `floor` is under the panel's edge."""
    finite = np.maximum(values[np.isfinite(values)], floor)
    low, high = finite.min() / 1.4, finite.max() * 1.4
    parts = (1,) if high / low > 300 else (1, 2, 5)
    powers = np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    panel.set_yscale("log")
    plain_log(panel.yaxis, [part * 10.0**k for k in powers for part in parts])
    panel.set_ylim(low, high)


def same_view(panels: np.ndarray, points: np.ndarray) -> None:
    """The same piece of paper in all panels: all of `points` (T, 2), and a margin."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.06 * (high - low).max()
    for panel in panels:
        panel.set_xlim(low[0] - margin, high[0] + margin)
        panel.set_ylim(low[1] - margin, high[1] + margin)


def explained_below(figure: Figure, panel: Axes, columns: int = 6) -> None:
    """One legend for all panels, under them."""
    handles, labels = panel.get_legend_handles_labels()
    figure.legend(
        handles,
        labels,
        loc="outside lower center",
        ncols=columns,
        frameon=False,
        fontsize=9,
        labelcolor=INK,
    )
