"""Suggest a reachable page near one that is out of reach, which can be typed in one line.

What may change, in this order: where the page lies; which way it faces; how steep it is; how large
it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.model.rotation import turn_about
from dmp_teach.robot.page import A4, Page
from dmp_teach.robot.reach.posture import STRAINED_EFFORT, find_posture
from dmp_teach.robot.slices import Slices
from dmp_teach.trajectory import Array

Area = tuple[Array, Array]
"""A part of a page, from its lower left corner (2,) to its upper right one (2,) [m]."""

_EASE = 0.8 * STRAINED_EFFORT
# Pages are moved by whole centimetres [m].
_STEP = 0.01
# Moves of a page that lies as well as can be [m].
_AHEAD = (0.05, -0.05)
_FLAT = Page.table().X_world_page[:3, 3]
_UPRIGHT = Page.board().X_world_page[:3, 3]


@dataclass(frozen=True, eq=False)
class Suggestion:
    """A page that the arm reaches with ease: for this ink, or else smaller ink in its middle.

    `moved` is how far it is from the page that was wanted, where it is turned alike; else NaN [m].
    """

    page: Page
    fits: bool
    moved: float = np.nan

    def __str__(self) -> str:
        if not self.fits:
            return f"Try smaller ink in the middle of {self.page!r}."
        return f"Try {self.page!r}."


def suggest_page(solver: Solver, page: Page, area: Area) -> Slices[Suggestion]:
    """Find the nearest page on which the arm reaches all, or else all of the ink, with ease."""
    for sheet in _sheets(page, area):
        for other in _turned(sheet):
            for part in (whole_area(other), area):
                best = _best_place(other, part)
                if (yield from _reached_with_ease(solver, best, part)):
                    found = yield from _nearest(solver, other, best, part)
                    R = found.X_world_page[:3, :3]
                    moved = _distance(found, page)
                    same = sheet is page and np.allclose(R, page.X_world_page[:3, :3], atol=1e-5)
                    return Suggestion(found, True, moved if same else np.nan)
    usual = getattr(Page, page.kind)
    middle = usual(width=page.width, height=page.height)
    spot = (np.array([-0.05, -0.05]), np.array([0.05, 0.05]))
    reached = yield from _reached_with_ease(solver, middle, spot)
    return Suggestion(middle if reached else usual(), False)


def list_other_pages(page: Page, area: Area) -> Iterator[Page]:
    """Yield other pages for the same ink, the likest first, each as easy to reach as can be."""
    best = [
        _best_place(other, part) for other in _turned(page) for part in (whole_area(other), area)
    ]
    yield from best
    for far in _AHEAD:
        yield best[0].moved((far, 0.0, 0.0))


def whole_area(page: Page) -> Area:
    """Return all of a page."""
    return -page.size / 2, page.size / 2


def _reached_with_ease(solver: Solver, page: Page, area: Area) -> Slices[bool]:
    """Whether the arm reaches a part of a page without stretching out."""
    return not (yield from find_posture(solver, page, *area, _EASE)).trouble


def _sheets(page: Page, area: Area) -> Iterator[Page]:
    """Yield the page, and if that is too large, an A4 sheet in its place, where the ink fits."""
    yield page
    if page.size.max() > max(A4) and (np.abs(area) <= np.array(A4) / 2 + 1e-9).all():
        yield Page(page.X_world_page, *A4)


def _turned(page: Page) -> Iterator[Page]:
    """Yield the page as it lies, face up, and then ever more as pages usually lie."""
    if page.normal[2] < -0.5:
        X = page.X_world_page.copy()
        X[:3, 1:3] *= -1
        page = Page(X, page.width, page.height)
    tilt, turn, yaw = page.angles
    ways = [
        (tilt, turn, yaw),
        (tilt, turn, 0.0),
        (tilt / 2, turn, 0.0),
        (0.0, turn, 0.0),
        (0.0, 0.0, 0.0),
    ]
    usual = getattr(Page, page.kind)
    centre = page.X_world_page[:3, 3]
    for tilt, turn, yaw in dict.fromkeys(ways):
        yield usual(*centre, page.width, page.height, tilt=tilt, turn=turn, yaw=yaw)


def _best_place(page: Page, area: Area) -> Page:
    """Return the page moved to where the middle of an area is as easy to reach as can be."""
    lean = np.arccos(np.clip(page.normal[2], 0, 1)) / (np.pi / 2)
    spot = turn_about(np.array([0.0, 0.0, 1.0]), page.angles[2]) @ (
        _FLAT + lean * (_UPRIGHT - _FLAT)
    )
    centre = page.X_world_page[:3, 3]
    shift = spot - page.to_world((area[0] + area[1]) / 2)
    return page.moved(np.round(centre + shift, 2) - centre)


def _nearest(solver: Solver, page: Page, best: Page, area: Area) -> Slices[Page]:
    """Return the least move to a page that works: along one axis of the world, or two, or three."""
    if (yield from _reached_with_ease(solver, page, area)):
        return page
    move = best.X_world_page[:3, 3] - page.X_world_page[:3, 3]
    for axes in (np.eye(3), 1 - np.eye(3), np.ones((1, 3))):
        found = []
        for part in move * axes:
            if (yield from _reached_with_ease(solver, page.moved(part), area)):
                found.append((yield from _shorten(solver, page, part, area)))
        if found:
            return min(found, key=lambda other: _distance(other, page))
    return best


def _shorten(solver: Solver, page: Page, move: Array, area: Area) -> Slices[Page]:
    """Return the page moved by only as much of a move as is needed, found by halving."""
    best = page.moved(move)
    works = 1.0
    fails = 0.0
    while (works - fails) * np.linalg.norm(move) > _STEP:
        part = (works + fails) / 2
        centre = page.X_world_page[:3, 3]
        tried = page.moved(np.where(move == 0, 0, np.round(centre + part * move, 2) - centre))
        if (yield from _reached_with_ease(solver, tried, area)):
            best = tried
            works = part
        else:
            fails = part
    return best


def _distance(one: Page, other: Page) -> float:
    """Return how far apart the centres of two pages are [m]."""
    return float(np.linalg.norm(one.X_world_page[:3, 3] - other.X_world_page[:3, 3]))
