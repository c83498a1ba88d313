"""Where a page can lie: pages tried place by place with the solver that plans the writing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.errors import PageError
from dmp_teach.progress import Progress, reporter
from dmp_teach.robot.motion import BoolArray
from dmp_teach.robot.page import A4, Page, check_page
from dmp_teach.robot.reach.check import measure_misses
from dmp_teach.robot.reach.posture import STRAINED_EFFORT, find_posture, list_rim_places
from dmp_teach.robot.reach.suggest import whole_area
from dmp_teach.robot.slices import run_through
from dmp_teach.robot.solvers import get_solver
from dmp_teach.trajectory import Array
from dmp_teach.values import Value, locked

# Of a page's centre, ahead of the robot and to its left [m], and of its tilt from a table, 0, to a
# whiteboard, a right angle [rad].
_DISTANCES = locked(np.round(np.arange(0.30, 1.301, 0.05), 2))
_SIDES = locked(np.round(np.arange(-1.0, 1.01, 0.1), 2))
_TILTS = locked(np.radians(np.arange(0, 91, 10)))
# A corner that is so far out needs no more trying [m].
_FAR = 0.01

PageGrid = tuple[tuple[Page, ...], ...]


@dataclass(frozen=True, eq=False, repr=False)
class ReachMap(Value):
    """Which pages can be written on, corner to corner, on a grid of pages.

    Args:
        x: Distances of the page's centre ahead of the robot, shape (C,) [m].
        across: What else was varied, shape (R,).
        across_name: Its name, a word of `Page.table`: "tilt" [rad] or "y" [m].
        pages: The pages, R rows of C.
        effort: The greatest speed of a joint as a part of its limit where a hand's speed asks most
            of it, shape (R, C); inf where the page is not reached.
        residual: How far the page's worst corner stays from the tip of an upright pen, at best,
            shape (R, C) [m]. Where that is nothing and the page is not reached, the arm is in its
            own way.
    """

    x: Array
    across: Array
    across_name: str
    pages: PageGrid
    effort: Array
    residual: Array

    @property
    def reached(self) -> BoolArray:
        """Where the arm writes on all of the page, shape (R, C)."""
        return np.isfinite(self.effort)

    @property
    def at_ease(self) -> BoolArray:
        """Where the arm is not stretched out either, shape (R, C)."""
        return self.effort < STRAINED_EFFORT

    def __repr__(self) -> str:
        rows, columns = self.reached.shape
        grid = f"{rows} {self.across_name} by {columns} x"
        return f"ReachMap({grid}, {self.reached.sum()} of {self.reached.size} reached)"


@checked
def reach_map(
    x: Sequence[float] | None = None,
    tilt: Sequence[float] | None = None,
    *,
    width: float = A4[0],
    height: float = A4[1],
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ReachMap:
    """Map page distance against pen angle, from a table to a whiteboard, straight ahead.

    The page's height over the floor goes with its tilt, from that of `Page.table()` to that of
    `Page.board()`; it hardly matters. 210 pages on the default grid, 5 cm by 10 degrees, 25 to
    40 ms each.

    Args:
        x: Distances of the page's centre, shape (C,); 0.3 to 1.3 by 0.05 unless given [m].
        tilt: Of the page; the pen stands upright on it, shape (R,); 0 to a right angle by 10
            degrees unless given [rad].
        width: Of the page [m].
        height: Of the page [m].
        executor: Any `concurrent.futures.Executor` of processes; a piece of work is one page.
        progress: Called as `progress(done, total)` after every page. It may raise to stop. None
            draws a bar after a second.

    Raises:
        PageError: Values that are no numbers, or a page that cannot be.
    """
    distances = _axis("x", x, _DISTANCES)
    tilts = _axis("tilt", tilt, _TILTS)
    low, high = (page.X_world_page[2, 3] for page in (Page.table(), Page.board()))
    heights = low + (high - low) * np.clip(tilts / (np.pi / 2), 0, 1)
    rows = tuple(
        tuple(Page.table(far, 0.0, z, width, height, tilt=lean) for far in distances)
        for lean, z in zip(tilts, heights, strict=True)
    )
    return ReachMap(distances, tilts, "tilt", rows, *_try_pages(rows, executor, progress))


@checked
def reach_around(
    page: Page | None = None,
    x: Sequence[float] | None = None,
    y: Sequence[float] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ReachMap:
    """Map, seen from above, where the centre of a page can be that lies as this one does.

    441 pages on the default grid, 5 cm by 10 cm, 25 to 40 ms each.

    Args:
        page: `Page.table()` unless given; all pages lie at its height.
        x: Ahead of the robot, shape (C,); 0.3 to 1.3 by 0.05 unless given [m].
        y: To its left, shape (R,); -1 to 1 by 0.1 unless given [m].
        executor: Any `concurrent.futures.Executor` of processes; a piece of work is one page.
        progress: Called as `progress(done, total)` after every page. It may raise to stop. None
            draws a bar after a second.

    Raises:
        PageError: Values that are no numbers, or no page.
    """
    page = Page.table() if page is None else page
    check_page(page)
    distances = _axis("x", x, _DISTANCES)
    sides = _axis("y", y, _SIDES)
    ahead, left, _ = page.X_world_page[:3, 3]
    rows = tuple(
        tuple(page.moved((far - ahead, side - left, 0.0)) for far in distances) for side in sides
    )
    return ReachMap(distances, sides, "y", rows, *_try_pages(rows, executor, progress))


def _try_pages(
    rows: PageGrid, executor: Executor | None, progress: Progress | None
) -> tuple[Array, Array]:
    """Return efforts and residuals of rows of pages, each (R, C): tried here, or elsewhere."""
    pages = [page for row in rows for page in row]
    report = reporter(progress, "pages")
    answers: Iterable[tuple[float, float]] = (
        map(_try_page, pages) if executor is None else executor.map(_try_page, pages, chunksize=8)
    )
    report(0, len(pages))
    found = []
    for answer in answers:
        found.append(answer)
        report(len(found), len(pages))
    effort, residual = np.reshape(found, (len(rows), -1, 2)).transpose(2, 0, 1)
    return effort, residual


def _try_page(page: Page) -> tuple[float, float]:
    """Return effort (inf: cannot be written on) and residual [m] of a page."""
    solver = get_solver()
    places = list_rim_places(*whole_area(page))
    corners = {name: place for name, place in places.items() if "corner" in name}
    residual = max(run_through(measure_misses(solver, page, corners)).values())
    if residual > _FAR:
        return np.inf, residual
    return run_through(find_posture(solver, page, *whole_area(page))).effort, residual


def _axis(name: str, values: Sequence[float] | None, usual: Array) -> Array:
    """Return the values along one side of the map, rising; the usual ones where there are none."""
    try:
        axis = np.array(usual if values is None else values, dtype=float)
    except (TypeError, ValueError):
        axis = np.array(np.nan)
    if axis.ndim != 1 or not len(axis) or not np.isfinite(axis).all() or (np.diff(axis) <= 0).any():
        raise PageError(
            f"{name} is {values!r}, but must be rising numbers, such as [0.5, 0.7, 0.9]."
        )
    return axis
