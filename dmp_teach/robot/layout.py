"""Lay strokes out on a page, checked: whether they are ink, fit, and where they go."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers
from dmp_teach.errors import PageError, TrajectoryError, kind_of, shown
from dmp_teach.robot.page import Page, check_finite, check_page
from dmp_teach.trajectory import Array, Trajectory, all_points

PAGE_MARGIN = 0.005
"""What stays free of ink along every edge of the page [m]."""

# Ink larger than this was not measured in metres [m].
_HUGE = 2.0
# No hand moves this much further in one step than in the steps beside it [m], if that needs more
# than this [m/s^2].
_JUMP = 0.004
_JERKED = 50.0


def lay_out(
    strokes: Iterable[Trajectory] | Trajectory,
    page: Page,
    at: ArrayLike | None = None,
    size: float | None = None,
) -> tuple[Trajectory, ...]:
    """Lay 2-D strokes [s, m] out on a page, in its frame, their clock unchanged.

    The arguments are those of `Fetch.write`; a single Trajectory is one stroke.

    Raises:
        TrajectoryError: No strokes, something that is no stroke, three dimensions, or a jump.
        PageError: No page, ink that does not fit, or `at` or `size` that cannot be.
    """
    check_page(page)
    strokes = check_strokes(strokes)
    points = all_points(strokes)
    low, high = points.min(axis=0), points.max(axis=0)
    if (high - low).max() > _HUGE:
        raise PageError(
            "The ink is {:.0f} x {:.0f} m. Positions are in metres: if yours are in millimetres, "
            "divide them by 1000.".format(*(high - low))
        )
    for number, stroke in enumerate(strokes):
        _check_jump(number, stroke)
    scale = _scale(high - low, page, size)
    middle = _spot(at, (high - low) * scale, page)
    return tuple(Trajectory(s.t, (s.position - (low + high) / 2) * scale + middle) for s in strokes)


def check_strokes(strokes: Iterable[Trajectory] | Trajectory) -> tuple[Trajectory, ...]:
    """Return the strokes as a tuple, each of them a 2-D Trajectory; see `lay_out`."""
    try:
        strokes = (strokes,) if isinstance(strokes, Trajectory) else tuple(strokes)
    except TypeError:
        raise TrajectoryError(
            f"strokes is {kind_of(strokes)}, but must be a tuple of Trajectory, one for each "
            "stroke, as recording.strokes() and letter.write() give them."
        ) from None
    if not strokes:
        raise TrajectoryError(
            "There are no strokes to write; a letter needs at least one Trajectory."
        )
    for number, stroke in enumerate(strokes):
        if not isinstance(stroke, Trajectory):
            raise TrajectoryError(
                f"Stroke {number} is {kind_of(stroke)}, but must be a Trajectory(t, position)."
            )
        if stroke.dimensions != 2:
            raise TrajectoryError(
                f"Stroke {number} has {stroke.dimensions} dimensions, but ink has 2: "
                "Trajectory(stroke.t, stroke.position[:, :2]) keeps x and y."
            )
    return strokes


def _check_jump(number: int, stroke: Trajectory) -> None:
    """Raise where one step is much longer than both beside it: a lost marker, or two strokes."""
    step = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
    dt = np.diff(stroke.t)
    if len(step) < 2:
        return
    beside = np.maximum(np.append(step[1:], 0), np.append(0, step[:-1]))
    jumps = step - beside > np.maximum(_JUMP, _JERKED * dt**2)
    if jumps.any():
        row = int(np.argmax(jumps)) + 1
        raise TrajectoryError(
            f"Stroke {number} jumps by {1000 * step[row - 1]:.1f} mm in "
            f"{1000 * dt[row - 1]:.1f} ms at sample {row} (t = {stroke.t[row]:.3f} s), where no "
            "hand could; cut the stroke there, or fill the gap in the recording."
        )


def _scale(extent: Array, page: Page, size: float | None) -> float:
    """Return by how much the ink must grow, or raise a PageError that says what would fit."""
    room = page.size - 2 * PAGE_MARGIN
    if size is not None and extent[1] < 1e-9:
        raise PageError(
            "The ink has no height (a dot, or a level line), so size cannot set it; leave size out."
        )
    scale = 1.0
    if size is not None:
        scale = check_finite("size", size, "a height in metres, such as 0.1") / extent[1]
    if scale <= 0:
        raise PageError(f"size is {size} m, but the ink's height must be more than 0.")
    if (extent * scale > room + 1e-9).any():
        fits = (room / np.maximum(extent, 1e-12)).min()
        height = float(np.floor(1000 * fits * extent[1] + 1e-6) / 1000)
        cure = f"size={height:.3f}" if height else f"a stroke {1000 * room[0]:.0f} mm wide"
        raise PageError(
            f"The ink would be {_mm(extent * scale)} mm, but the page is {_mm(page.size)} mm "
            f"and has room for {_mm(room)} mm inside its margin. The largest that fits is {cure}.",
            cure=height or None,
        )
    return scale


def _spot(at: ArrayLike | None, extent: Array, page: Page) -> Array:
    """Return the middle of the ink (2,), or raise a PageError that says where it may be."""
    if at is None:
        return np.zeros(2)
    try:
        spot = as_numbers(at)
    except ValueError:
        spot = np.array(np.nan)
    if spot.shape != (2,) or not np.isfinite(spot).all():
        raise PageError(
            f"at is {shown(at)}, but must be two numbers: right and up from the page's centre [m]."
        )
    free = np.maximum(page.size / 2 - PAGE_MARGIN - extent / 2, 0)
    if (np.abs(spot) > free + 1e-9).any():
        # Rounded to the nearest tenth of a millimetre inwards, so that what is named works.
        x, y = np.floor(free * 1e4 + 1e-6) / 1e4
        raise PageError(
            f"With at=({spot[0]:g}, {spot[1]:g}) the ink of {_mm(extent)} mm would run over the "
            f"page's margin; x must be between {-x:g} and {x:g} m, y between {-y:g} and {y:g} m."
        )
    return spot


def _mm(size: Array) -> str:
    """Return a size (2,) in millimetres: '200 x 287'."""
    return " x ".join(f"{1000 * side:.0f}" for side in size)
