"""How hard the pen presses, to be seen: the colour and width of ink, and the strip under the picture."""

from __future__ import annotations

import numpy as np

from dmp_teach.robot import BAND, Run
from dmp_teach.trajectory import Array

SHADES = ("#6FB1DA", "#4097CB", "#0072B2", "#00598F", "#0B4068", "#0D2840")
"""Of ink, from hardly pressed to pressed too hard: one blue from light to dark, for every eye, and in grey."""

BOUNDS = (BAND[0], 0.4, 0.7, 0.95, BAND[1])
"""Between two shades [N]; the middle of good pressing has the robot's own blue."""

WIDTHS = (0.0013, 0.0018, 0.0022, 0.0026, 0.0030, 0.0038)
"""Of ink of each shade [m]."""

MOST_POINTS = 700
"""Of the curve in the strip."""


def shade(force: Array) -> Array:
    """The number of the shade for each force (T,) [N]."""
    return np.searchsorted(BOUNDS, force, side="right")


def width(force: Array) -> Array:
    """The width of ink for each force (T,) [N], without steps [m]."""
    middles = (0.1, *(np.array(BOUNDS[1:]) + BOUNDS[:-1]) / 2, 1.6)
    return np.interp(force, middles, WIDTHS)


def rgb(number: int) -> tuple[float, float, float]:
    """Red, green and blue of a shade, 0 to 1."""
    code = SHADES[number][1:]
    return tuple(int(code[k : k + 2], 16) / 255 for k in (0, 2, 4))


def curve(force: Array) -> Array:
    """Rows of the samples that make the curve: of each short while those of the least and of the greatest force.

    Thinned evenly a blow on the paper would be lost.
    """
    stride = -(-2 * len(force) // MOST_POINTS)
    if stride <= 2:
        return np.arange(len(force))
    rows = {0, len(force) - 1}
    for start in range(0, len(force), stride):
        piece = force[start : start + stride]
        rows |= {start + int(piece.argmin()), start + int(piece.argmax())}
    return np.array(sorted(rows))


def down(run: Run) -> list[tuple[float, float]]:
    """From when to when the pen was meant to be down [s]."""
    edges = np.flatnonzero(
        np.diff(np.concatenate([[False], run.motion.pen_down, [False]]).astype(int))
    )
    t = run.t - run.t[0]
    return [(float(t[start]), float(t[stop - 1])) for start, stop in edges.reshape(-1, 2)]


def verdict(run: Run) -> str:
    """How near the ink is to the plan, in a sentence."""
    if not run.writing.any():
        return "There is no ink."
    off = 1000 * run.shape_error
    distance = "less than 0.1" if off < 0.05 else f"{off:.1f}"
    return f"The ink is {distance} mm off the plan."


def strip(run: Run) -> dict[str, object]:
    """All of this for the browser; a point of the curve is a time [s], a force [N], and where the nib is [mm]."""
    rows = curve(run.force)
    columns = run.t[rows] - run.t[0], run.force[rows], *(1000 * run.nib[rows, :2].T)
    return {
        "curve": np.column_stack(
            [np.round(column, 3 - (n > 1)) for n, column in enumerate(columns)]
        ).tolist(),
        "down": [[round(time, 3) for time in pair] for pair in down(run)],
        "band": list(BAND),
        "inked": round(1 - float(run.missing.mean()), 3) if len(run.missing) else 0.0,
        "most": round(run.greatest_force, 1),
        "findings": list(run.findings),
        "verdict": verdict(run),
    }
