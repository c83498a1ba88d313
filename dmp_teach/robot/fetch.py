"""The robot that a teacher asks to write."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import ReachError, ReachWarning
from dmp_teach.robot.arm import JOINTS, Solver, solver_here
from dmp_teach.robot.layout import place
from dmp_teach.robot.model.proximity import LEAST, Near, nearest
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import PenPlan, way_over
from dmp_teach.robot.reach.check import Unreachable, stance_for
from dmp_teach.robot.reach.posture import STRAINED, TILT, TIP, Stance, examined
from dmp_teach.robot.reach.suggest import cure_for, elsewhere
from dmp_teach.robot.time_scaling import Clock
from dmp_teach.robot.torque import too_heavy
from dmp_teach.trajectory import Array, Trajectory

_ROUNDS = 12  # the clock is slowed so often; mostly twice is enough
_SOLVES = (
    3  # at most so many solutions a sample; one does, unless that leaves the tip so far off [m]:
)
_NEAR = 3e-5

_FORESEEN = 0.03  # nearer than this to something, a stance may have been refused for it [m]

Progress = Callable[[str, float], Any]


def _silent(step: str, fraction: float) -> None:
    """Tell nobody."""


class Fetch:
    """The robot, ready to write.

    Raises:
        MissingPartError: PlaCo is not on this platform.
    """

    def __init__(self) -> None:
        self.model = solver_here().model

    joint_names = JOINTS

    def write(
        self,
        strokes: Sequence[Trajectory],
        page: Page,
        at: ArrayLike | None = None,
        size: float | None = None,
        progress: Progress | None = None,
    ) -> Motion:
        """Plan how the pen in the gripper writes strokes on a page.

        Args:
            strokes: 2-D strokes on one clock, x right and y up [s, m].
            page: Where the sheet is.
            at: Where the middle of the ink's bounding box goes on the page, shape (2,); None: its centre [m].
            size: Height of the ink; None: as it was written [m].
            progress: Called as `progress(step, fraction)` with the steps "reach", "plan" and "joints" and how much
                of each is done, 0 to 1. It may raise to stop the planning.

        Returns:
            The motion, `RATE` samples a second. The same input gives the same motion, bit for bit.

        Raises:
            TrajectoryError: Strokes that no hand could write.
            PageError: Ink that does not fit on the page.
            ReachError: The arm cannot get to the ink, or would touch the robot or what the page lies on; says where,
                by how much, and which page works.

        Where the arm is nearly stretched out a `ReachWarning`, and a note, say how far to move the page.
        """
        placed, solver = place(strokes, page, at, size), solver_here()
        try:
            motion, strained = _written(solver, page, placed, progress or _silent)
        except Unreachable as error:
            raise _refusal(solver, page, placed, error) from None
        if strained:
            warnings.warn(strained, ReachWarning, stacklevel=2)
        return motion


def _written(
    solver: Solver, page: Page, placed: tuple[Trajectory, ...], report: Progress = _silent
) -> tuple[Motion, str]:
    """The motion, and a warning where the arm is nearly stretched out; `Unreachable` says only what is wrong."""
    report("reach", 0.0)
    stance = stance_for(solver, page, _ink(placed))
    report("reach", 1.0)
    motion = _planned(solver, stance, page, placed, report)
    strained = stance.effort >= STRAINED
    return motion, next((note for note in stance.notes if strained and "stretched" in note), "")


def _refusal(
    solver: Solver, page: Page, placed: tuple[Trajectory, ...], error: Unreachable
) -> ReachError:
    """What is wrong, and the first page on which the same ink has been planned."""
    problem = _in_time(solver, page, placed) or error.problem if error.collides else error.problem
    ink = _ink(placed)
    area = ink.min(axis=0), ink.max(axis=0)
    cure = cure_for(solver, page, area)
    suggested = [cure.page] if cure.fits and repr(cure.page) != repr(page) else []
    for other in [*suggested, *elsewhere(page, area)]:
        with suppress(Unreachable):
            _written(solver, other, placed)
            return ReachError(f"{problem} Try {other!r}.", cure=other)
    return ReachError(f"{problem} {'Write smaller, or move the page.' if cure.fits else cure}")


def _planned(
    solver: Solver,
    stance: Stance,
    page: Page,
    placed: tuple[Trajectory, ...],
    report: Progress = _silent,
) -> Motion:
    """The motion from a stance; `Unreachable` says what is wrong with it."""
    plan, q, poses, slowed = _joints_for(solver, stance, page, placed, report)
    _check_tip(poses["pen_tip"], plan, page)
    close = _checked_clear(poses, page)
    motion = Motion(
        t=plan.t,
        q=q,
        joint_names=JOINTS,
        tip=poses["pen_tip"][:, :3, 3],
        target=page.to_world(plan.position),
        pen_down=plan.pen_down,
        page=page,
        strokes=placed,
    )
    return replace(motion, notes=(*slowed, *too_heavy(motion, solver.model), *close, *stance.notes))


def _joints_for(
    solver: Solver, stance: Stance, page: Page, placed: tuple[Trajectory, ...], report: Progress
) -> tuple[PenPlan, Array, dict[str, Array], tuple[str, ...]]:
    """The plan, slowed where a joint could not follow it, the joints (T, J), where the links are, and notes.

    PlaCo knows no speed limits here: with them it would lag behind in silence. Where the arm is nearly straight it lags
    a little even so, and is given more solutions a sample.
    """
    report("plan", 0.0)
    way = way_over(placed)
    clock = Clock(way, JOINTS)
    report("plan", 1.0)
    solves = 1
    for _ in range(_ROUNDS):
        plan = way.plan(clock.samples)
        path = page.to_world(plan.position)
        q = solver.follow(stance.q, page.normal, path, report, solves)
        if clock.slowed(solver.speeds(q)):
            continue
        poses = solver.model.link_poses(q, JOINTS)
        if (
            np.linalg.norm(poses["pen_tip"][:, :3, 3] - path, axis=1).max() < _NEAR
            or solves == _SOLVES
        ):
            return plan, q, poses, clock.notes
        solves += 1
    raise Unreachable(
        f"However slowly the pen goes, {JOINTS[int(solver.speeds(q).max(axis=0).argmax())]} would have to hurry: here "
        "the arm must change its posture."
    )


def _check_tip(X_world_tip: Array, plan: PenPlan, page: Page) -> None:
    """Raise where the nib, by the model's own kinematics (T, 4, 4), is not on the plan."""
    miss = np.linalg.norm(X_world_tip[:, :3, 3] - page.to_world(plan.position), axis=1)
    tilt = np.arccos(np.clip(-X_world_tip[:, :3, 2] @ page.normal, -1, 1))
    lost = (miss > TIP) | (tilt > TILT) | ~np.isfinite(miss)
    if lost.any():
        row = int(np.argmax(lost))
        x, y, _ = 1000 * plan.position[row]
        raise Unreachable(
            f"The arm loses the pen's path after {plan.t[row]:.2f} s, {x:.0f} mm right and {y:.0f} mm up from the "
            f"page's centre: {1000 * miss[row]:.1f} mm beside it, {np.degrees(tilt[row]):.1f} degrees off the upright."
        )


def _checked_clear(poses: Mapping[str, Array], page: Page) -> tuple[str, ...]:
    """A note where the arm comes near to the robot or to what the page lies on; an error where it comes too near."""
    first, closest = nearest(poses, page)
    if first is not None:
        raise Unreachable(_told(first))
    return () if closest is None else (closest.note,)


def _ink(placed: tuple[Trajectory, ...]) -> Array:
    """All points of the strokes on the page, shape (N, 2) [m]."""
    return np.concatenate([stroke.position for stroke in placed])


def _in_time(solver: Solver, page: Page, placed: tuple[Trajectory, ...]) -> str:
    """When the arm comes against something, and how deep; empty where the plan does not show it."""
    ink = _ink(placed)
    stance = examined(solver, page, ink.min(axis=0), ink.max(axis=0))
    plan = way_over(placed).plan()
    q = solver.follow(stance.q, page.normal, page.to_world(plan.position), _silent)
    first, closest = nearest(solver.model.link_poses(q, JOINTS), page, _FORESEEN)
    near = first or closest
    return "" if near is None else _told(near)


def _told(near: Near) -> str:
    """What comes too near to what, and when."""
    if near.other == "page":
        return str(near)
    touching = (
        "The arm would touch the robot:"
        if near.distance < LEAST
        else "The arm would come too near to the robot:"
    )
    return f"{touching} a{str(near)[1:]}"
