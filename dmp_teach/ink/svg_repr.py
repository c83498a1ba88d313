"""A small picture of ink, for a notebook: a person's in dots, the robot's as a line, as in the panels."""

from __future__ import annotations

from collections.abc import Iterable
from xml.sax.saxutils import escape

import numpy as np

from dmp_teach.trajectory import Array, Trajectory

MARK = "dmp-teach-ink"
"""The class of every picture: by it a notebook that is saved by our launcher's server leaves them out."""

CHILD, ROBOT, INK = "#d55e00", "#0072b2", "#1b2430"
PAPER, EDGE, RULE = "#fffdf7", "#dcd6c4", "#dcd3b6"
_SCALE = 2000  # [px/m]: a letter of 7 cm is as high as six lines of text ...
_TALLEST, _WIDEST = 170, 900  # ... a taller one or a line of text is drawn smaller ...
_SMALLEST = 40  # ... and a small one larger [px]
_MARGIN = 24  # around it [px]
_MOST = 400  # points of a stroke
_DOTTED = f'stroke="{CHILD}" stroke-width="3.6" stroke-dasharray="0.01 8"'
_SOLID = f'stroke="{ROBOT}" stroke-width="3"'


def svg_of(
    strokes: Iterable[Trajectory], title: str, dotted: bool, baseline: float | None = None
) -> str | None:
    """Ink as an SVG on a small sheet, with a circle where each stroke begins; None where there is no ink on a page.

    Args:
        strokes: In the order in which they are written; of more than 2 dimensions the first two are drawn [m].
        title: The picture in words.
        dotted: True for what a person wrote, False for what the robot writes.
        baseline: The y of the line that the letter stands on [m], or None.
    """
    paths = [stroke.position[:, :2] for stroke in strokes]
    if not paths or any(path.shape[1] < 2 for path in paths):
        return None
    points = np.concatenate(paths)
    low, high = points.min(axis=0), points.max(axis=0)
    wide, tall = high - low
    largest = max(wide, tall, 0.01)
    scale = min(
        _TALLEST / max(tall, 0.01), _WIDEST / max(wide, 0.01), max(_SCALE, _SMALLEST / largest)
    )
    origin = np.array([low[0], high[1]])
    drawn = [(path - origin) * (scale, -scale) + _MARGIN for path in paths]
    size = np.ceil(np.array([wide, tall]) * scale + 2 * _MARGIN).astype(int)
    line = "" if baseline is None else _line(_MARGIN + scale * (high[1] - baseline), *size)
    look = _DOTTED if dotted else _SOLID
    ink = "".join(f'<path d="{_way(path)}" {look}/>' for path in drawn)
    starts = "".join(
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5"/>' for x, y in (path[0] for path in drawn)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="{MARK}" role="img" width="{size[0]}" height="{size[1]}">'
        f"<title>{escape(title)}</title>"
        f'<rect x="0.5" y="0.5" width="{size[0] - 1}" height="{size[1] - 1}" rx="6" fill="{PAPER}" stroke="{EDGE}"/>'
        f'{line}<g fill="none" stroke-linecap="round" stroke-linejoin="round">{ink}</g>'
        f'<g fill="{PAPER}" stroke="{INK}" stroke-width="2.5">{starts}</g></svg>'
    )


def _line(y: float, wide: int, tall: int) -> str:
    """The line that letters stand on, where it is on the sheet."""
    if not 4 < y < tall - 4:
        return ""
    return f'<path d="M12 {y:.1f}H{wide - 12}" stroke="{RULE}" stroke-width="2.5"/>'


def _way(path: Array) -> str:
    """The points of a stroke (T, 2) [px] as SVG has them; not all of them where there are very many."""
    kept = path[np.unique(np.linspace(0, len(path) - 1, min(len(path), _MOST)).round().astype(int))]
    if np.ptp(kept, axis=0).max() < 0.05:
        return f"M{kept[0, 0]:.1f} {kept[0, 1]:.1f}h0.01"
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in kept)
