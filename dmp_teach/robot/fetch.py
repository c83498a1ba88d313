"""The robot that a teacher asks to write."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import ReachError
from dmp_teach.robot.arm import JOINTS, Solver, solver_here
from dmp_teach.robot.model import Model
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.page import Page
from dmp_teach.robot.place import place
from dmp_teach.robot.plan import PenPlan, plan_pen
from dmp_teach.robot.reach import stance_for
from dmp_teach.robot.stance import TILT, TIP, Stance
from dmp_teach.trajectory import Array, Trajectory

FASTEST = 0.9
"""No joint goes faster than this part of its limit; a motion that would is slowed."""

Progress = Callable[[str, float], Any]


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
            ReachError: The arm cannot get to the ink; says where, by how much, and which page works.
        """
        report = progress or (lambda step, fraction: None)
        placed = place(strokes, page, at, size)
        solver = solver_here()
        report("reach", 0.0)
        stance = stance_for(solver, page, np.concatenate([stroke.position for stroke in placed]))
        report("reach", 1.0)
        plan, q, slowed = _joints_for(solver, stance, page, placed, report)
        tip = _checked_tip(solver.model, plan, q, page)
        return Motion(
            t=plan.t,
            q=q,
            joint_names=JOINTS,
            tip=tip,
            target=page.to_world(plan.position),
            pen_down=plan.pen_down,
            page=page,
            strokes=placed,
            notes=(*slowed, *stance.notes),
        )


def _joints_for(
    solver: Solver, stance: Stance, page: Page, placed: tuple[Trajectory, ...], report: Progress
) -> tuple[PenPlan, Array, tuple[str, ...]]:
    """The plan, slowed evenly until every joint can follow it, and the joints (T, J)."""

    def follow(plan: PenPlan, limited: bool) -> Array:
        return solver.follow(stance.q, page.normal, page.to_world(plan.position), limited, report)

    report("plan", 0.0)
    plan = first = plan_pen(placed)
    report("plan", 1.0)
    q = follow(plan, True)
    stretch, guilty = 1.0, []
    while (solver.speeds(q) > FASTEST).any():
        # With its limits on, PlaCo lags behind in silence. Without them the joints say how fast they would have to be.
        wanted = solver.speeds(follow(plan, False))
        guilty += [name for name, fraction in zip(JOINTS, wanted, strict=True) if fraction > FASTEST]
        stretch *= 1.01 * max(1.0, wanted.max() / FASTEST)
        plan = plan_pen(placed, stretch)
        q = follow(plan, True)
    if not guilty:
        return plan, q, ()
    names = ", ".join(dict.fromkeys(guilty))
    return plan, q, (f"slowed from {first.duration:.2f} s to {plan.duration:.2f} s: {names}",)


def _checked_tip(model: Model, plan: PenPlan, q: Array, page: Page) -> Array:
    """Where the nib is by the model's own kinematics (T, 3) [m]; an error where that is not on the plan."""
    X = model.frame("pen_tip", q, JOINTS)
    miss = np.linalg.norm(X[:, :3, 3] - page.to_world(plan.position), axis=1)
    tilt = np.arccos(np.clip(-X[:, :3, 2] @ page.normal, -1, 1))
    lost = (miss > TIP) | (tilt > TILT) | ~np.isfinite(miss)
    if lost.any():
        row = int(np.argmax(lost))
        x, y, _ = 1000 * plan.position[row]
        raise ReachError(
            f"The arm loses the pen's path after {plan.t[row]:.2f} s, {x:.0f} mm right and {y:.0f} mm up from the "
            f"page's centre: {1000 * miss[row]:.1f} mm beside it, {np.degrees(tilt[row]):.1f} degrees off the upright. "
            "Write smaller, or move the page."
        )
    return X[:, :3, 3]
