"""Can the arm get to the ink: where not, what is missing and which page would do."""

from dataclasses import replace

import numpy as np

from dmp_teach.errors import ReachError
from dmp_teach.robot.arm import Solver
from dmp_teach.robot.page import Page
from dmp_teach.robot.stance import POSTURES, STRAINED, TIP, Stance, examined, in_the_body, rim
from dmp_teach.trajectory import Array


def stance_for(solver: Solver, page: Page, ink: Array) -> Stance:
    """A stance from which the arm reaches all of the page, or else all of the ink on it.

    Args:
        solver: This thread's solver.
        page: The sheet.
        ink: Points of the ink on the page, shape (N, 2) [m].

    Raises:
        ReachError: A part of the ink is out of reach; says which, by how much, and which page works.
    """
    low, high = ink.min(axis=0), ink.max(axis=0)
    whole = examined(solver, page, *_all(page))
    stance = examined(solver, page, low, high) if whole.trouble else whole
    if stance.trouble or in_the_body(page):
        short = in_the_body(page) or _shortfall(solver, page, low, high) or stance.trouble
        cure = _cure(solver, page, low, high)
        raise ReachError(f"{short} {_advice(cure)}", cure=cure[0] if cure[1] else None)
    notes = ()
    if stance is not whole:
        notes += ("the arm reaches this ink, but not all of the page",)
    if stance.effort >= STRAINED:
        advice = _advice(_cure(solver, page, low, high))
        notes += (f"the arm is nearly stretched out here, where its joints must hurry. {advice}",)
    return replace(stance, notes=notes)


def _all(page: Page) -> tuple[Array, Array]:
    """The whole page: from its lower left corner to its upper right one."""
    return -page.size / 2, page.size / 2


def _shortfall(solver: Solver, page: Page, low: Array, high: Array) -> str:
    """Which place is furthest out, and by how many millimetres with an upright pen."""
    short = {name: _miss(solver, page, place) for name, place in rim(low, high).items()}
    name = max(short, key=short.__getitem__)
    if short[name] <= TIP:
        return ""
    return f"The ink's {name} is {max(1000 * short[name], 1):.0f} mm out of the arm's reach."


def _miss(solver: Solver, page: Page, place: Array) -> float:
    """How far from a place the tip of an upright pen stays, at best [m]."""
    target, misses = page.to_world(place), []
    for posture in POSTURES:
        solver.stand(posture, page.normal, torso=True, upright=10.0)
        solver.approach(target, finer=(0.1, 0.02, 0.004, 0.001))
        misses.append(float(np.linalg.norm(solver.pen()[:3, 3] - target)))
        if misses[-1] <= TIP:
            break
    return min(misses)


def _cure(solver: Solver, page: Page, low: Array, high: Array) -> tuple[Page, bool]:
    """The nearest page that works with ease, and whether it does so for ink of this size."""
    kind = page.kind or ("table" if page.normal[2] > 0.7 else "board")
    good = getattr(Page, kind)(width=page.width, height=page.height)
    for area in (_all(page), (low, high)):
        if _with_ease(solver, good, area):
            return _nearest(solver, page if page.kind else good, good, area), True
    return good, False


def _advice(cure: tuple[Page, bool]) -> str:
    """The cure as one would type it."""
    page, fits = cure
    return f"Try {page!r}." if fits else f"Try smaller ink in the middle of {page!r}."


def _with_ease(solver: Solver, page: Page, area: tuple[Array, Array]) -> bool:
    """Whether the arm reaches a part of a page without stretching out."""
    stance = examined(solver, page, *area)
    return not stance.trouble and stance.effort < STRAINED


def _nearest(solver: Solver, page: Page, good: Page, area: tuple[Array, Array]) -> Page:
    """The least move to a page that works: along one axis of the world if that will do, or else two, or three."""
    whole = good.X_world_page[:3, 3] - page.X_world_page[:3, 3]
    for axes in (np.eye(3), 1 - np.eye(3), np.ones((1, 3))):
        found = [
            _shortened(solver, page, move, area) for move in whole * axes if _with_ease(solver, page.moved(move), area)
        ]
        if found:
            return min(found, key=lambda other: np.linalg.norm(other.X_world_page[:3, 3] - page.X_world_page[:3, 3]))
    return good


def _shortened(solver: Solver, page: Page, move: Array, area: tuple[Array, Array]) -> Page:
    """The page moved by only as much of a move as is needed, in whole centimetres: found by halving."""
    best, works, fails = page.moved(move), 1.0, 0.0
    while (works - fails) * np.linalg.norm(move) > 0.01:
        part = (works + fails) / 2
        centre = page.X_world_page[:3, 3]
        tried = page.moved(np.where(move == 0, 0, np.round(centre + part * move, 2) - centre))
        if _with_ease(solver, tried, area):
            best, works = tried, part
        else:
            fails = part
    return best
