"""How hard the pen presses: the colour and width of ink, and what the browser's strip shows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from dmp_teach.robot import FORCE_BAND, Run
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.ribbon import find_pen_down_rows

FORCE_SHADES = ("#6FB1DA", "#4097CB", "#0072B2", "#00598F", "#0B4068", "#0D2840")
"""Colours of ink from too light to too hard: one blue, so that they differ in grey, too."""

SHADE_BOUNDS = (FORCE_BAND[0], 0.4, 0.7, 0.95, FORCE_BAND[1])
"""Forces between two shades [N]; the middle of good pressing has the robot's own blue."""

SHADE_WIDTHS = (0.0013, 0.0018, 0.0022, 0.0026, 0.0030, 0.0038)
"""Widths of ink at the middle force of each shade [m]."""

MAX_CURVE_ROWS = 700


def find_shade(force: Array) -> NDArray[np.int_]:
    """Return the number of the shade of each force (T,) [N]."""
    return np.searchsorted(SHADE_BOUNDS, force, side="right").astype(int)


def find_ink_width(force: Array) -> Array:
    """Return the width of ink at each force (T,) [N], without steps [m]."""
    middles = (0.1, *(np.array(SHADE_BOUNDS[1:]) + SHADE_BOUNDS[:-1]) / 2, 1.6)
    return np.interp(force, middles, SHADE_WIDTHS)


def shade_rgb(number: int) -> tuple[float, float, float]:
    """Return red, green and blue of a shade, 0 to 1."""
    code = FORCE_SHADES[number]
    red, green, blue = (int(code[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue


def select_curve_rows(force: Array) -> NDArray[np.int_]:
    """Return the rows of the curve: of each short interval those of its extreme forces.

    Thinned evenly a blow on the paper would be lost.
    """
    stride = -(-2 * len(force) // MAX_CURVE_ROWS)
    if stride <= 2:
        return np.arange(len(force))
    rows = {0, len(force) - 1}
    for start in range(0, len(force), stride):
        piece = force[start : start + stride]
        rows |= {start + int(piece.argmin()), start + int(piece.argmax())}
    return np.array(sorted(rows))


def find_pen_down(run: Run) -> list[tuple[float, float]]:
    """Return from when to when the pen was meant to be down [s]."""
    t = run.t - run.t[0]
    return [(float(t[start]), float(t[stop - 1])) for start, stop in find_pen_down_rows(run.motion)]


def describe_ink_error(run: Run) -> str:
    """Return a sentence that says how near the ink is to the plan."""
    if not run.writing.any():
        return _("There is no ink.")
    off = 1000 * run.shape_error
    if off < 0.05:
        return _("The ink is less than 0.1 mm off the plan.")
    return _("The ink is {mm:.1f} mm off the plan.").format(mm=off)


def describe_force(run: Run) -> dict[str, object]:
    """Return what the browser's strip shows.

    A point of the curve is a time [s], a force [N], and where the nib is [mm].
    """
    rows = select_curve_rows(run.force)
    timed = np.round([run.t[rows] - run.t[0], run.force[rows]], 3)
    placed = np.round(1000 * run.nib[rows, :2], 2)
    return {
        "curve": np.column_stack([*timed, placed]).tolist(),
        "down": [[round(time, 3) for time in pair] for pair in find_pen_down(run)],
        "band": list(FORCE_BAND),
        "inked": round(1 - float(run.missing.mean()), 3) if len(run.missing) else 0.0,
        "most": round(run.greatest_force, 1),
        "findings": list(run.findings),
        "verdict": describe_ink_error(run),
    }
