"""Can the arm get to the ink: where not, what is missing and which page would do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from dmp_teach.robot.arm import Solver
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.posture import (
    POSTURES,
    STRAINED,
    TIP,
    Stance,
    examined,
    in_the_body,
    rim,
)
from dmp_teach.robot.reach.suggest import Area, Cure, cure_for, in_the_floor, whole
from dmp_teach.trajectory import Array


class Unreachable(Exception):  # noqa: N818 (it is caught inside the robot, never shown)
    """The arm cannot write this ink on this page.

    Args:
        problem: What is wrong, in a sentence.
        collides: Whether it is that the arm touches something, so that a plan can say when and how deep.
    """

    def __init__(self, problem: str, collides: bool = False) -> None:
        super().__init__(problem)
        self.problem, self.collides = problem, collides


def stance_for(solver: Solver, page: Page, ink: Array) -> Stance:
    """A stance from which the arm reaches all of the page, or else all of the ink on it.

    Args:
        solver: This thread's solver.
        page: The sheet.
        ink: Points of the ink on the page, shape (N, 2) [m].

    Raises:
        Unreachable: A part of the ink is out of reach; says which, and by how much.
    """
    area = ink.min(axis=0), ink.max(axis=0)
    mistake = in_the_body(page) or in_the_floor(page)
    everything = examined(solver, page, *whole(page))
    stance = examined(solver, page, *area) if everything.trouble else everything
    if mistake or stance.trouble:
        odd = f"The page {odd}. " if (odd := _astray(page)) else ""
        short = "" if mistake else _shortfall(solver, page, area)
        raise Unreachable(
            mistake or f"{odd}{short or stance.trouble}", stance.collides and not (mistake or short)
        )
    notes = ()
    if stance is not everything:
        notes += ("the arm reaches this ink, but not all of the page",)
    if stance.effort >= STRAINED:
        cure = cure_for(solver, page, area)
        if cure.moved == 0:  # it is only the rest of the page for which the arm must stand so
            stance = examined(solver, page, *area, quick=True)
        else:
            notes += (_stretched(cure),)
    if odd := _astray(page):
        notes += (f"the page {odd}; was it meant so?",)
    return replace(stance, notes=notes)


def misses(solver: Solver, page: Page, area: Area, among: str = "") -> dict[str, float]:
    """How far from each place around a part of a page the tip of an upright pen stays, at best [m].

    Args:
        solver: This thread's solver.
        page: The sheet.
        area: The part.
        among: "corner" for those only.
    """
    return {name: _miss(solver, page, place) for name, place in rim(*area).items() if among in name}


def _stretched(cure: Cure) -> str:
    """The warning before the arm is straight."""
    there = "" if np.isnan(cure.moved) else f"; {1000 * cure.moved:.0f} mm from here it is at ease"
    return f"the arm is nearly stretched out here, where its joints must hurry{there}. {cure}"


def _astray(page: Page) -> str:
    """What is odd about how a page lies; empty if nothing is."""
    x, y, _ = page.X_world_page[:3, 3]
    if page.normal[2] < -0.5:
        return "lies with its face to the floor"
    if page.normal[:2] @ (x, y) > 0.5 * np.hypot(x, y):
        return "shows the robot its back"
    return "is behind the robot" if x < -0.1 else ""


def _shortfall(solver: Solver, page: Page, area: Area) -> str:
    """Which place is furthest out, a corner rather than an edge, and by how many millimetres with an upright pen."""
    short = misses(solver, page, area)
    name = max(short, key=lambda name: short[name] + (0.005 if "corner" in name else 0.0))
    if max(short.values()) <= TIP:
        return ""
    return f"The ink's {name} is {max(1000 * short[name], 1):.0f} mm out of the arm's reach."


def _miss(solver: Solver, page: Page, place: Array) -> float:
    """How far from a place the tip of an upright pen stays, at best [m]."""
    target, found = page.to_world(place), []
    for posture in POSTURES:
        solver.stand(posture, page.normal, torso=True, upright=10.0)
        solver.approach(target, finer=(0.1, 0.02, 0.004, 0.001))
        found.append(float(np.linalg.norm(solver.pen()[:3, 3] - target)))
        if found[-1] <= TIP:
            break
    return min(found)
