"""What several lessons draw: a letter on its sheet, bumps over time, errors and their words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from dmp_teach.classroom import Drawing
from dmp_teach.dmp import DMP
from dmp_teach.letters import Letter, rms_distance
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory

# So many points draw one bump.
BUMP_POINTS = 24


def millimetres(metres: float) -> str:
    """Return a length as it is shown: "0.37", "3.6", "24"."""
    mm = 1000 * metres
    return f"{mm:.2f}" if mm < 0.995 else f"{mm:.1f}" if mm < 9.95 else f"{mm:.0f}"


def error_of(letter: Letter) -> float:
    """Return how far the robot's letter is off the person's, on average [m]."""
    return rms_distance(letter.write(), letter.strokes)


def paths_of(strokes: Iterable[Trajectory]) -> list[Array]:
    """Return the points of strokes, each shape (N, 2) [m]."""
    return [stroke.position for stroke in strokes]


def draw_sheet(
    demonstration: Sequence[Trajectory], robot: Sequence[object], **more: object
) -> Drawing:
    """Return a sheet with a person's letter and the robot's lines over it."""
    title = _("The person’s letter, and the robot’s over it.")
    sheet: Drawing = {
        "box": sheet_box(paths_of(demonstration)),
        "title": title,
        "demo": paths_of(demonstration),
    }
    return sheet | {"robot": list(robot)} | more


def sheet_box(paths: Sequence[Array]) -> list[float]:
    """Return what a sheet shows around paths, each shape (N, 2): left, bottom, right, top [m]."""
    points = np.concatenate(paths)
    margin = 0.12 * np.ptp(points, axis=0).max()
    return [*(points.min(axis=0) - margin), *(points.max(axis=0) + margin)]


def bumps_over_time(primitive: DMP) -> list[Array]:
    """Return the outline of each bump over time, in order of time, each shape (P, 2) [s, 1].

    A bump is drawn only where it is awake.
    """
    kernels, duration = primitive.kernels, primitive.duration
    t = np.linspace(0, 1, max(1000, BUMP_POINTS * kernels.number))
    heights = kernels.heights(kernels.phase.at(1 - t))
    outlines = []
    for height in heights.T[::-1]:
        awake = np.flatnonzero(height > 0.004)
        if len(awake):
            span = np.unique(np.linspace(awake[0], awake[-1], BUMP_POINTS).astype(int))
            path = np.column_stack([t[span] * duration, height[span]])
            ends = np.array([[path[0, 0], 0.0], [path[-1, 0], 0.0]])
            outlines.append(np.vstack([ends[:1], path, ends[1:]]))
    return outlines


def error_axis() -> Drawing:
    """Return the axis of errors, with a thing of each size [mm]."""
    words = [
        (0.1, _("a hair")),
        (1.0, _("a pen line")),
        (10.0, _("a finger")),
        (100.0, _("a hand")),
    ]
    ticks = [[value, f"{value:g} mm {word}"] for value, word in words]
    return {"label": "", "low": 0.1, "high": 100.0, "log": True, "ticks": ticks}
