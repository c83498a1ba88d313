"""The page that one asks for when the arm cannot get to one's own: near to it, typed in one line, and tried.

What may change, in this order: where the page lies; which way it faces; how steep it is; how large it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.page import A4, Page
from dmp_teach.robot.reach.posture import STRAINED, examined, in_the_body
from dmp_teach.trajectory import Array

Area = tuple[Array, Array]
"""A part of a page, from its lower left corner (2,) to its upper right one (2,) [m]."""

_EASE = 0.8 * STRAINED
_STEP = 0.01  # pages are moved by whole centimetres [m]
_BESIDE = (0.05, -0.05)  # moves of a page that lies as well as can be [m]
_FLAT, _UPRIGHT = Page.table().X_world_page[:3, 3], Page.board().X_world_page[:3, 3]


@dataclass(frozen=True, eq=False)
class Cure:
    """A page that works.

    Args:
        page: To be typed.
        fits: Whether for this ink, too; if not, then for smaller ink in its middle.
        moved: How far from the page that was asked for, where it is turned as that was; else NaN [m].
    """

    page: Page
    fits: bool
    moved: float = np.nan

    def __str__(self) -> str:
        """What to do."""
        if not self.fits:
            return f"Try smaller ink in the middle of {self.page!r}."
        return f"Try {self.page!r}."


def cure_for(solver: Solver, page: Page, area: Area) -> Cure:
    """The nearest page on which the arm reaches all of it, or else all of the ink, with ease.

    Args:
        solver: This thread's solver.
        page: The one that was asked for.
        area: Where its ink is.
    """
    for sheet in _sheets(page, area):
        for other in _faces(sheet):
            for part in (whole(other), area):
                good = _at_best(other, part)
                if with_ease(solver, good, part):
                    found = _nearest(solver, other, good, part)
                    same = np.allclose(
                        found.X_world_page[:3, :3], page.X_world_page[:3, :3], atol=1e-5
                    )
                    moved = np.linalg.norm(found.X_world_page[:3, 3] - page.X_world_page[:3, 3])
                    return Cure(found, True, float(moved) if same and sheet is page else np.nan)
    middle = getattr(Page, page.kind)(width=page.width, height=page.height)
    spot = (np.array([-0.05, -0.05]), np.array([0.05, 0.05]))
    return Cure(middle if with_ease(solver, middle, spot) else getattr(Page, page.kind)(), False)


def elsewhere(page: Page, area: Area) -> Iterator[Page]:
    """Other pages for the same ink, the likest first: all of each, or else the ink, is as easy to reach as can be.

    Args:
        page: The one that was asked for.
        area: Where its ink is.
    """
    best = [_at_best(other, part) for other in _faces(page) for part in (whole(other), area)]
    for good in (*best, *(best[0].moved((far, 0.0, 0.0)) for far in _BESIDE)):
        if repr(good) != repr(page):
            yield good


def whole(page: Page) -> Area:
    """All of a page."""
    return -page.size / 2, page.size / 2


def with_ease(solver: Solver, page: Page, area: Area) -> bool:
    """Whether the arm reaches a part of a page without stretching out."""
    if in_the_body(page) or in_the_floor(page):
        return False
    stance = examined(solver, page, *area, quick=True)
    return not stance.trouble and stance.effort < _EASE


def in_the_floor(page: Page) -> str:
    """Whether a part of the page lies under the floor."""
    x, y = page.size / 2
    deep = -page.to_world([(x, y), (x, -y), (-x, y), (-x, -y)])[:, 2].min()
    return f"The page would go {1000 * deep:.0f} mm into the floor." if deep > 0.0005 else ""


def _sheets(page: Page, area: Area) -> Iterator[Page]:
    """The page itself, and if that is too large, an A4 sheet in its place, where the ink fits on it."""
    yield page
    if page.size.max() > max(A4) and (np.abs(area) <= np.array(A4) / 2 + 1e-9).all():
        yield Page(page.X_world_page, *A4)


def _faces(page: Page) -> Iterator[Page]:
    """The page as it lies, the other way up if it faces the floor, and then ever more as pages usually lie."""
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
    for tilt, turn, yaw in dict.fromkeys(ways):
        x, y, z = page.X_world_page[:3, 3]
        yield getattr(Page, page.kind)(
            x, y, z, page.width, page.height, tilt=tilt, turn=turn, yaw=yaw
        )


def _at_best(page: Page, area: Area) -> Page:
    """The page where the middle of an area is as easy to reach as can be, for one that leans so."""
    lean = np.arccos(np.clip(page.normal[2], 0, 1)) / (np.pi / 2)
    spot = Rotation.from_euler("Z", page.angles[2]).apply(_FLAT + lean * (_UPRIGHT - _FLAT))
    shift = spot - page.to_world((area[0] + area[1]) / 2)
    return page.moved(np.round(page.X_world_page[:3, 3] + shift, 2) - page.X_world_page[:3, 3])


def _nearest(solver: Solver, page: Page, good: Page, area: Area) -> Page:
    """The least move to a page that works: along one axis of the world if that will do, or else two, or three."""
    if with_ease(solver, page, area):
        return page
    move = good.X_world_page[:3, 3] - page.X_world_page[:3, 3]
    for axes in (np.eye(3), 1 - np.eye(3), np.ones((1, 3))):
        ways = [part for part in move * axes if with_ease(solver, page.moved(part), area)]
        if ways:
            found = [_shortened(solver, page, way, area) for way in ways]
            return min(
                found,
                key=lambda other: np.linalg.norm(
                    other.X_world_page[:3, 3] - page.X_world_page[:3, 3]
                ),
            )
    return good


def _shortened(solver: Solver, page: Page, move: Array, area: Area) -> Page:
    """The page moved by only as much of a move as is needed: found by halving."""
    best, works, fails = page.moved(move), 1.0, 0.0
    while (works - fails) * np.linalg.norm(move) > _STEP:
        part = (works + fails) / 2
        centre = page.X_world_page[:3, 3]
        tried = page.moved(np.where(move == 0, 0, np.round(centre + part * move, 2) - centre))
        if with_ease(solver, tried, area):
            best, works = tried, part
        else:
            fails = part
    return best
