"""Decide whether the arm gets to the ink on a page, and say what is missing where it does not."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.posture import (
    START_POSTURES,
    TIP_TOLERANCE,
    describe_obstacle,
    find_posture,
    list_rim_places,
    measure_gap,
)
from dmp_teach.robot.reach.suggest import Area, suggest_page, whole_area
from dmp_teach.robot.slices import Slices
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

# By so much less may a place be out of reach that is still tried, where it is plain [m].
_ALIKE = 0.03


class Unreachable(Exception):  # noqa: N818 (it is caught inside the robot, never shown)
    """The arm cannot write this ink on this page; `collides` if it touches something on the way."""

    def __init__(self, problem: str, collides: bool = False) -> None:
        super().__init__(problem)
        self.problem = problem
        self.collides = collides


def check_reach(
    solver: Solver, page: Page, ink: Array
) -> Slices[tuple[Array, tuple[str, ...], str]]:
    """Find how the arm reaches all of a page, or else all ink (N, 2) [m], or raise Unreachable.

    Returns:
        Joint positions over the middle of the ink, shape (J,) [rad, m]; what the writer should
        know; and the warning among that, if the arm is nearly stretched out.
    """
    area = ink.min(axis=0), ink.max(axis=0)
    if obstacle := describe_obstacle(page):
        raise Unreachable(obstacle)
    notes = []
    warning = ""
    odd = _oddity(page)
    posture = yield from find_posture(solver, page, *whole_area(page))
    if posture.trouble:
        posture = yield from find_posture(solver, page, *area)
        notes.append(_("the arm reaches this ink, but not all of the page"))
    if posture.trouble:
        short = yield from _shortfall(solver, page, area)
        problem = f"{f'The page {odd}. ' if odd else ''}{short or posture.trouble}"
        raise Unreachable(problem, posture.collides and not short)
    if posture.strained:
        suggestion = yield from suggest_page(solver, page, area)
        if suggestion.moved == 0:
            # It is only the rest of the page for which the arm must stand so.
            posture = yield from find_posture(solver, page, *area)
        else:
            strained = _strained(suggestion.moved)
            warning = f"{strained} {suggestion}"
            # A note is read by who does not type, too.
            notes.append(strained)
    if odd:
        notes.append(f"the page {odd}; was it meant so?")
    return posture.q, tuple(notes), warning


def measure_misses(
    solver: Solver, page: Page, places: Mapping[str, Array]
) -> Slices[dict[str, float]]:
    """Return how far the tip of an upright pen stays from places on a page, at best [m]."""
    misses = {}
    for name, place in places.items():
        misses[name] = yield from _miss(solver, page, place)
    return misses


def _strained(moved: float) -> str:
    """Warn before the arm is straight."""
    if np.isnan(moved):
        return _("the arm is nearly stretched out here, where its joints must hurry.")
    words = _(
        "the arm is nearly stretched out here, where its joints must hurry; {mm:.0f} mm from here "
        "it is at ease."
    )
    return words.format(mm=1000 * moved)


def _oddity(page: Page) -> str:
    """Say what is odd about how a page lies; empty if nothing is."""
    x, y, _ = page.X_world_page[:3, 3]
    if page.normal[2] < -0.5:
        return "lies with its face to the floor"
    if page.normal[:2] @ (x, y) > 0.5 * np.hypot(x, y):
        return "shows the robot its back"
    return "is behind the robot" if x < -0.1 else ""


def _shortfall(solver: Solver, page: Page, area: Area) -> Slices[str]:
    """Say which place is furthest out, a corner rather than an edge, and by how much."""
    places = list_rim_places(*area)
    gaps = measure_gap(solver, page, places.values())
    if gaps.max() > 0:
        far = np.flatnonzero(gaps > gaps.max() - _ALIKE)
        places = {name: places[name] for name in np.array(list(places))[far]}
    short = yield from measure_misses(solver, page, places)
    name = max(short, key=lambda name: short[name] + (0.005 if "corner" in name else 0.0))
    if max(short.values()) <= TIP_TOLERANCE:
        return ""
    return f"The ink's {name} is {max(1000 * short[name], 1):.0f} mm out of the arm's reach."


def _miss(solver: Solver, page: Page, place: Array) -> Slices[float]:
    """Return how far from a place the tip of an upright pen stays, at best [m]."""
    target = page.to_world(place)
    least = np.inf
    for posture in START_POSTURES:
        yield "reach", 0.0
        solver.stand(posture, page.normal, torso=True, upright=10.0)
        solver.approach(target, finer=(0.1, 0.02, 0.004, 0.001))
        least = min(least, float(np.linalg.norm(solver.pen()[:3, 3] - target)))
        if least <= TIP_TOLERANCE:
            break
    return least
