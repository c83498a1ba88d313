"""Plan how the Fetch writes strokes on a page."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked, warn_caller
from dmp_teach.errors import ReachError, ReachWarning
from dmp_teach.progress import StepProgress, step_reporter
from dmp_teach.robot.arm import JOINTS, Solver
from dmp_teach.robot.clearance import describe_collision, describe_thin_margin, find_nearest
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.motor_limits import find_strain
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import PenPlan
from dmp_teach.robot.reach.check import Unreachable, check_reach
from dmp_teach.robot.reach.posture import PEN_TILT_TOLERANCE, TIP_TOLERANCE, find_posture
from dmp_teach.robot.reach.suggest import list_other_pages, suggest_page
from dmp_teach.robot.slices import Slices, creep, run_through
from dmp_teach.robot.smoothing import connect_smoothly
from dmp_teach.robot.solvers import borrow_solver, get_solver
from dmp_teach.robot.time_scaling import TimeScaling
from dmp_teach.trajectory import Array, Trajectory, all_points

# The clock is slowed so often at most; mostly twice is enough.
_ROUNDS = 12
# Solutions for each sample at most; one does, unless that leaves the tip this far off [m].
_SOLVES = 3
_LAG = 3e-5
# Nearer than this to something, a posture may have been refused for it [m].
_FORESEEN = 0.03

PlacedStrokes = tuple[Trajectory, ...]


class Fetch:
    """The robot, ready to write.

    PlaCo solves its arm, or a solver of ours in NumPy where there is no PlaCo, or where the
    environment has `DMP_TEACH_SOLVER=NumPy`.
    """

    joint_names = JOINTS

    def __init__(self) -> None:
        self.model = Model.load()

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other)

    def __hash__(self) -> int:
        return hash(type(self))

    def __repr__(self) -> str:
        return f"Fetch({len(self.joint_names)} joints)"

    @checked
    def write(
        self,
        strokes: Sequence[Trajectory],
        page: Page,
        at: ArrayLike | None = None,
        size: float | None = None,
        progress: StepProgress | None = None,
    ) -> Motion:
        """Plan how the pen in the gripper writes strokes on a page.

        Where the arm is nearly stretched out a `ReachWarning`, and a note, say how far to move the
        page.

        Args:
            strokes: 2-D strokes on one clock, x right and y up [s, m].
            page: Where the sheet is.
            at: Where the middle of the ink's bounding box goes on the page, shape (2,); None: its
                centre [m].
            size: Height of the ink; None: as it was written [m].
            progress: Called as `progress(step, fraction)` with the steps "reach", "plan" and
                "joints" and how much of each is done, 0 to 1. It may raise to stop the planning.
                None draws a bar after a second.

        Returns:
            The motion, `MOTION_RATE` samples a second. The same input gives the same motion, bit
            for bit.

        Raises:
            TrajectoryError: PlacedStrokes that no hand could write.
            PageError: Ink that does not fit on the page.
            ReachError: The arm cannot get to the ink, or would touch the robot or what the page
                lies on; says where, by how much, and which page works.
        """
        placed = lay_out(strokes, page, at, size)
        report = step_reporter(progress, "planning")
        motion, warning = run_through(_write(get_solver(), page, placed), report)
        if warning:
            warn_caller(warning, ReachWarning)
        return motion

    def write_in_slices(
        self, strokes: Sequence[Trajectory], page: Page, size: float | None = None
    ) -> Slices[Motion]:
        """Plan as `write` does, in slices, which yield what `progress` is told; without warnings.

        `Motion.notes` have what they say.
        """
        placed = lay_out(strokes, page, None, size)
        with borrow_solver() as solver:
            motion, _ = yield from _write(solver, page, placed)
        return motion


def _write(solver: Solver, page: Page, strokes: PlacedStrokes) -> Slices[tuple[Motion, str]]:
    """Return what `_plan` returns, or raise a ReachError that says what would work."""
    try:
        return (yield from _plan(solver, page, strokes))
    except Unreachable as error:
        raise (yield from _refusal(solver, page, strokes, error)) from None


def _plan(solver: Solver, page: Page, strokes: PlacedStrokes) -> Slices[tuple[Motion, str]]:
    """Return the motion, and a warning where the arm is nearly stretched; or raise Unreachable."""
    yield "reach", 0.0
    start, known, warning = yield from creep(check_reach(solver, page, all_points(strokes)))
    yield "reach", 1.0
    plan, q, X_world_tip, slowed = yield from _follow(solver, start, page, strokes)
    _check_tip(X_world_tip, plan, page)
    first, closest = find_nearest(q, JOINTS, page)
    if first is not None:
        raise Unreachable(describe_collision(first))
    near = () if closest is None else (describe_thin_margin(closest),)
    motion = Motion(
        t=plan.t,
        q=q,
        joint_names=JOINTS,
        tip=X_world_tip[:, :3, 3],
        target=page.to_world(plan.position),
        pen_down=plan.pen_down,
        page=page,
        strokes=strokes,
        notes=(*slowed, *near, *known),
        solver=solver.name,
    )
    return motion, warning


def _refusal(
    solver: Solver, page: Page, strokes: PlacedStrokes, error: Unreachable
) -> Slices[ReachError]:
    """Return what is wrong, and the first page on which the same ink has been planned."""
    ink = all_points(strokes)
    area = ink.min(axis=0), ink.max(axis=0)
    problem = error.problem
    if error.collides:
        problem = (yield from _foreseen_collision(solver, page, strokes)) or problem
    suggestion = yield from creep(suggest_page(solver, page, area))
    suggested = [suggestion.page] if suggestion.fits else []
    strained = []
    for other in [*suggested, *list_other_pages(page, area)]:
        if repr(other) == repr(page):
            continue
        with suppress(Unreachable):
            typed = other.rounded()
            _, warning = yield from _plan(solver, typed, strokes)
            if not warning:
                return ReachError(f"{problem} Try {typed!r}.", cure=typed)
            strained.append(typed)
    if strained:
        return ReachError(f"{problem} Try {strained[0]!r}.", cure=strained[0])
    cure = "Write smaller, or move the page." if suggestion.fits else str(suggestion)
    return ReachError(f"{problem} {cure}")


def _follow(
    solver: Solver, start: Array, page: Page, strokes: PlacedStrokes
) -> Slices[tuple[PenPlan, Array, Array, tuple[str, ...]]]:
    """Return the plan, slowed where a joint could not follow, joints (T, J), tip (T, 4, 4), notes.

    The solver knows no speed limits here: with them it would lag in silence, as it does where the
    arm is nearly straight. There it is given more solutions a sample.
    """
    yield "plan", 0.0
    path = connect_smoothly(strokes)
    scaling = TimeScaling(path, JOINTS)
    yield "plan", 1.0
    solves = 1
    for _ in range(_ROUNDS):
        plan = path.plan(scaling.samples)
        target = page.to_world(plan.position)
        q = yield from solver.follow(start, page.normal, target, solves)
        strain = find_strain(solver, q)
        if scaling.slow_down(strain):
            continue
        X_world_tip = solver.model.frame("pen_tip", q, JOINTS)
        lag = np.linalg.norm(X_world_tip[:, :3, 3] - target, axis=1).max()
        if lag < _LAG or solves == _SOLVES:
            return plan, q, X_world_tip, scaling.notes
        solves += 1
    hurried = JOINTS[int(strain.max(axis=0).argmax())]
    raise Unreachable(
        f"However slowly the pen goes, {hurried} would have to hurry: here the arm must change its "
        "posture."
    )


def _check_tip(X_world_tip: Array, plan: PenPlan, page: Page) -> None:
    """Raise where the nib, by the model's own kinematics (T, 4, 4), is not on the plan."""
    miss = np.linalg.norm(X_world_tip[:, :3, 3] - page.to_world(plan.position), axis=1)
    tilt = np.arccos(np.clip(-X_world_tip[:, :3, 2] @ page.normal, -1, 1))
    lost = (miss > TIP_TOLERANCE) | (tilt > PEN_TILT_TOLERANCE) | ~np.isfinite(miss)
    if lost.any():
        row = int(np.argmax(lost))
        x, y, _ = 1000 * plan.position[row]
        raise Unreachable(
            f"The arm loses the pen's path after {plan.t[row]:.2f} s, {x:.0f} mm right and "
            f"{y:.0f} mm up from the page's centre: {1000 * miss[row]:.1f} mm beside it, "
            f"{np.degrees(tilt[row]):.1f} degrees off the upright."
        )


def _foreseen_collision(solver: Solver, page: Page, strokes: PlacedStrokes) -> Slices[str]:
    """Say when the arm comes against something, and how deep; empty where no plan shows it."""
    ink = all_points(strokes)
    posture = yield from find_posture(solver, page, ink.min(axis=0), ink.max(axis=0))
    plan = connect_smoothly(strokes).plan()
    q = yield from solver.follow(posture.q, page.normal, page.to_world(plan.position))
    first, closest = find_nearest(q, JOINTS, page, _FORESEEN)
    near = first or closest
    return "" if near is None else describe_collision(near)
