"""Draw ink as a small picture for a notebook: a person's in dots, the robot's as a line."""

from __future__ import annotations

import os
from collections.abc import Iterable
from html import escape

import numpy as np

from dmp_teach.ink.marks import INK_CLASS, PICTURES_STAY_OUT
from dmp_teach.trajectory import Array, Trajectory

# Colours of the panels, see `tokens.css`.
PERSON_INK = "#d55e00"
ROBOT_INK = "#0072b2"
START_COLOR = "#1b2430"
SHEET_COLOR = "#fffdf7"
SHEET_EDGE_COLOR = "#dcd6c4"
BASELINE_COLOR = "#dcd3b6"
DOUBT_COLOR = "#ffd54d"
# A letter of 7 cm is as high as six lines of text [px/m] ...
_SCALE = 2000
# ... a taller one or a line of text is drawn smaller, and a small one larger [px].
_TALLEST = 170
_WIDEST = 900
_SMALLEST = 40
_SHEET_MARGIN = 24
_MOST_POINTS = 400
_DOTTED = f'stroke="{PERSON_INK}" stroke-width="3.6" stroke-dasharray="0.01 8"'
_MARKED = f'stroke="{DOUBT_COLOR}" stroke-width="16"'
_SOLID = f'stroke="{ROBOT_INK}" stroke-width="3"'


def draw_svg(
    strokes: Iterable[Trajectory],
    title: str,
    dotted: bool,
    baseline: float | None = None,
    doubtful: Iterable[Array] = (),
) -> str | None:
    """Draw ink as an SVG on a small sheet, with a circle where each stroke begins.

    Args:
        strokes: In writing order; of more than 2 dimensions the first two are drawn [m].
        title: The picture in words.
        dotted: True for what a person wrote, False for what the robot writes.
        baseline: The y of the line that the letter stands on [m], or None.
        doubtful: Points (K, 2) each, over which a marker pen goes [m].

    Returns:
        The text of the picture; None where there is no ink on a page, and where a notebook that is
        saved would keep it.
    """
    paths = [stroke.position[:, :2] for stroke in strokes]
    if PICTURES_STAY_OUT not in os.environ or not paths or any(path.shape[1] < 2 for path in paths):
        return None
    points = np.concatenate(paths)
    low, high = points.min(axis=0), points.max(axis=0)
    wide, tall = high - low
    largest = max(wide, tall, 0.01)
    scale = min(
        _TALLEST / max(tall, 0.01), _WIDEST / max(wide, 0.01), max(_SCALE, _SMALLEST / largest)
    )
    origin = np.array([low[0], high[1]])
    drawn, marked = (
        [(path - origin) * (scale, -scale) + _SHEET_MARGIN for path in some]
        for some in (paths, doubtful)
    )
    size = np.ceil(np.array([wide, tall]) * scale + 2 * _SHEET_MARGIN).astype(int)
    line = "" if baseline is None else _line(_SHEET_MARGIN + scale * (high[1] - baseline), *size)
    look = _DOTTED if dotted else _SOLID
    ink = "".join(f'<path d="{_path_data(path)}" {look}/>' for path in drawn)
    doubts = "".join(f'<path d="{_path_data(path)}" {_MARKED}/>' for path in marked)
    starts = "".join(
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5"/>' for x, y in (path[0] for path in drawn)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="{INK_CLASS}" role="img" '
        f'width="{size[0]}" height="{size[1]}">'
        f"<title>{escape(title)}</title>"
        f'<rect x="0.5" y="0.5" width="{size[0] - 1}" height="{size[1] - 1}" rx="6" '
        f'fill="{SHEET_COLOR}" stroke="{SHEET_EDGE_COLOR}"/>'
        f'{line}<g fill="none" stroke-linecap="round" stroke-linejoin="round">{doubts}{ink}</g>'
        f'<g fill="{SHEET_COLOR}" stroke="{START_COLOR}" stroke-width="2.5">{starts}</g></svg>'
    )


def _line(y: float, wide: int, tall: int) -> str:
    """Return the line that letters stand on, where it is on the sheet."""
    if not 4 < y < tall - 4:
        return ""
    return f'<path d="M12 {y:.1f}H{wide - 12}" stroke="{BASELINE_COLOR}" stroke-width="2.5"/>'


def _path_data(path: Array) -> str:
    """Return the points of a stroke (T, 2) [px] as SVG has them, at most 400 of them."""
    count = min(len(path), _MOST_POINTS)
    kept = path[np.unique(np.linspace(0, len(path) - 1, count).round().astype(int))]
    if np.ptp(kept, axis=0).max() < 0.05:
        return f"M{kept[0, 0]:.1f} {kept[0, 1]:.1f}h0.01"
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in kept)
