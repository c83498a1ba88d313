"""Where a page can lie: what the arm reaches, tried place by place with the solver that plans the writing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.errors import PageError
from dmp_teach.robot.arm import solver_here
from dmp_teach.robot.page import A4, Page
from dmp_teach.robot.reach.check import misses
from dmp_teach.robot.reach.posture import STRAINED, examined, in_the_body
from dmp_teach.robot.reach.suggest import in_the_floor, whole
from dmp_teach.trajectory import Array, locked

DISTANCES = locked(np.round(np.arange(0.30, 1.301, 0.05), 2))
"""Of a page's centre, ahead of the robot [m]."""

TILTS = locked(np.radians(np.arange(0, 91, 10)))
"""Of a page: from a table, 0, to a whiteboard, a right angle [rad]."""

SIDES = locked(np.round(np.arange(-1.0, 1.01, 0.1), 2))
"""Of a page's centre, to the robot's left [m]."""

_FAR = 0.01  # a corner that is so far out needs no more trying [m]

Progress = Callable[[int, int], Any]


@dataclass(frozen=True, eq=False)
class ReachMap:
    """Which pages can be written on, corner to corner, on a grid of pages.

    Args:
        x: Distances of the page's centre ahead of the robot, shape (C,) [m].
        across: What else was varied, shape (R,).
        across_name: Its name, a word of `Page.table`: "tilt" [rad] or "y" [m].
        pages: The pages, R rows of C.
        effort: The greatest speed of a joint as a part of its limit where a hand's speed asks most of it, shape (R, C);
            inf where the page is not reached.
        residual: How far the page's worst corner stays from the tip of an upright pen, at best, shape (R, C) [m].
            Where that is nothing and the page is not reached, the arm is in its own way.
    """

    x: Array
    across: Array
    across_name: str
    pages: tuple[tuple[Page, ...], ...]
    effort: Array
    residual: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("x", "across", "effort", "residual"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    @property
    def reached(self) -> Array:
        """Where the arm writes on all of the page, shape (R, C)."""
        return np.isfinite(self.effort)

    @property
    def at_ease(self) -> Array:
        """Where the arm is not stretched out either, shape (R, C)."""
        return self.reached & (self.effort < STRAINED)

    def __repr__(self) -> str:
        """How many of how many."""
        rows, columns = self.reached.shape
        return f"ReachMap({rows} {self.across_name} by {columns} x, {self.reached.sum()} of {self.reached.size} reached)"


def reach_map(
    x: Sequence[float] | None = None,
    tilt: Sequence[float] | None = None,
    *,
    width: float = A4[0],
    height: float = A4[1],
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ReachMap:
    """Page distance against pen angle: from a table to a whiteboard, straight ahead of the robot.

    The page's height over the floor goes with its tilt, from that of `Page.table()` to that of `Page.board()`; it
    hardly matters. 210 pages on the default grid, 5 cm by 10 degrees, 25 to 40 ms each.

    Args:
        x: Distances of the page's centre, shape (C,); 0.3 to 1.3 by 0.05 unless given [m].
        tilt: Of the page; the pen stands upright on it, shape (R,); 0 to a right angle by 10 degrees unless given
            [rad].
        width: Of the page [m].
        height: Of the page [m].
        executor: Any `concurrent.futures.Executor` of processes; a piece of work is one page.
        progress: Called as `progress(done, total)` after every page. It may raise to stop.

    Raises:
        PageError: Values that are no numbers, or a page that cannot be.
        MissingPartError: PlaCo is not on this platform.
    """
    x, tilt = _axis("x", x, DISTANCES), _axis("tilt", tilt, TILTS)
    low, high = (page.X_world_page[2, 3] for page in (Page.table(), Page.board()))
    heights = low + (high - low) * np.clip(tilt / (np.pi / 2), 0, 1)
    rows = [
        [Page.table(far, 0.0, z, width, height, tilt=lean) for far in x]
        for lean, z in zip(tilt, heights, strict=True)
    ]
    return ReachMap(x, tilt, "tilt", tuple(map(tuple, rows)), *_tried_all(rows, executor, progress))


def reach_around(
    page: Page | None = None,
    x: Sequence[float] | None = None,
    y: Sequence[float] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ReachMap:
    """Seen from above: where the centre of a page can be that lies as this one does, at its height.

    441 pages on the default grid, 5 cm by 10 cm, 25 to 40 ms each.

    Args:
        page: `Page.table()` unless given.
        x: Ahead of the robot, shape (C,); 0.3 to 1.3 by 0.05 unless given [m].
        y: To its left, shape (R,); -1 to 1 by 0.1 unless given [m].
        executor: Any `concurrent.futures.Executor` of processes; a piece of work is one page.
        progress: Called as `progress(done, total)` after every page. It may raise to stop.

    Raises:
        PageError: Values that are no numbers, or no page.
        MissingPartError: PlaCo is not on this platform.
    """
    page = Page.table() if page is None else page
    if not isinstance(page, Page):
        raise PageError(
            f"page is {page!r}, but must be a Page, such as Page.table() or Page.board()."
        )
    x, y = _axis("x", x, DISTANCES), _axis("y", y, SIDES)
    start = page.X_world_page[:3, 3]
    rows = [[page.moved((far - start[0], side - start[1], 0.0)) for far in x] for side in y]
    return ReachMap(x, y, "y", tuple(map(tuple, rows)), *_tried_all(rows, executor, progress))


def _tried_all(
    pages: Sequence[Sequence[Page]], executor: Executor | None, progress: Progress | None
) -> list[Array]:
    """Efforts and residuals of rows of pages, each (R, C): tried here, or elsewhere."""
    pieces = [page for row in pages for page in row]
    report = progress or (lambda done, total: None)
    answers: Iterable = (
        map(_tried, pieces) if executor is None else executor.map(_tried, pieces, chunksize=8)
    )
    report(0, len(pieces))
    found = []
    for answer in answers:
        found.append(answer)
        report(len(found), len(pieces))
    return list(np.reshape(found, (len(pages), -1, 2)).transpose(2, 0, 1))


def _tried(page: Page) -> tuple[float, float]:
    """Effort (inf: cannot be written on) and residual [m] of a page."""
    solver = solver_here()
    residual = max(misses(solver, page, whole(page), "corner").values())
    if residual > _FAR or in_the_body(page) or in_the_floor(page):
        return np.inf, residual
    return examined(solver, page, *whole(page)).effort, residual


def _axis(name: str, values: Any, usual: Array) -> Array:
    """The values along one side of the map, rising; the usual ones where there are none."""
    try:
        axis = np.array(usual if values is None else values, dtype=float)
    except (TypeError, ValueError):
        axis = np.array(np.nan)
    if axis.ndim != 1 or not len(axis) or not np.isfinite(axis).all() or (np.diff(axis) <= 0).any():
        raise PageError(
            f"{name} is {values!r}, but must be rising numbers, such as [0.5, 0.7, 0.9]."
        )
    return axis
