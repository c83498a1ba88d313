"""Simulate a motion under gravity, with a pen that presses on paper."""

from __future__ import annotations

import contextlib

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.errors import SettingError, kind_of, shown
from dmp_teach.progress import StepProgress, step_reporter
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.motion import BoolArray, Motion
from dmp_teach.robot.page import Page
from dmp_teach.robot.simulation.bullet import open_world
from dmp_teach.robot.simulation.motors import IdealMotors, RealMotors
from dmp_teach.robot.simulation.run import Run
from dmp_teach.robot.simulation.world import NIB_RADIUS, PENS, RIGID_PRESS, SLIDE_JOINT, World
from dmp_teach.robot.slices import Slices, run_through
from dmp_teach.trajectory import Array, Trajectory

_MOTORS = ("ideal", "real")

_INK_FORCE = 0.03
"""Ink falls where the nib presses with more than this [N]."""

LEAST_RATE = 200
"""A motion with fewer samples a second is too coarse to be simulated [Hz]."""

# The greatest errors of the page [m], [rad].
_FARTHEST = 0.1
_STEEPEST = 0.5
# Steps between two reports of progress.
_OFTEN = 24


@checked
def simulate(
    motion: Motion,
    motors: str = "ideal",
    seed: int = 0,
    *,
    page_height_error: float = 0.0,
    page_tilt: float = 0.0,
    pen: str = "sprung",
    progress: StepProgress | None = None,
) -> Run:
    """Simulate what happens when a motion meets gravity and paper.

    Args:
        motion: The plan, at least `LEAST_RATE` samples a second, evenly spaced.
        motors: "ideal" ones follow the plan; "real" ones have dry friction and limited efforts,
            encoders that are a little off, and a controller whose idea of the arm's masses is a
            little wrong.
        seed: Of what is a little off in real motors; the same seed gives the same run, bit for bit.
        page_height_error: How much higher the paper lies than planned, along its normal [m].
        page_tilt: How far the page is turned about its own x axis through its centre; positive
            raises its top [rad].
        pen: "sprung", pressed in by 4 mm; or "rigid", pressed into the paper by 0.5 mm, which is
            what it breaks of.
        progress: Called as `progress("physics", fraction)`. It may raise to stop: the error then
            carries what was written so far as its `.run`. None draws a bar after a second.

    Returns:
        The `Run`. An interrupted kernel gives what was written so far, with `.stopped` True.

    Raises:
        SettingError: Not a motion, or a setting out of its range.
        MissingPartError: pybullet is not installed.
    """
    run = simulate_in_slices(
        motion,
        motors,
        seed,
        page_height_error=page_height_error,
        page_tilt=page_tilt,
        pen=pen,
    )
    return run_through(run, step_reporter(progress, "physics"))


def simulate_in_slices(
    motion: Motion,
    motors: str = "ideal",
    seed: int = 0,
    *,
    page_height_error: float = 0.0,
    page_tilt: float = 0.0,
    pen: str = "sprung",
) -> Slices[Run]:
    """Simulate as `simulate` does, in slices, which yield what `progress` is told."""
    _check(motion)
    _check_known("motors", motors, _MOTORS)
    _check_known("pen", pen, tuple(PENS))
    _check_size("page_height_error", page_height_error, _FARTHEST, "m", "millimetres")
    _check_size("page_tilt", page_tilt, _STEEPEST, "rad", "degrees")
    _check_seed(seed)
    height = page_height_error + (RIGID_PRESS if pen == "rigid" else 0.0)
    page = _displace(motion.page, height, page_tilt)
    recorder = _Recorder(motion, pen)
    failure: BaseException | None = None
    with open_world() as (bullet, number):
        try:
            world = World(bullet, number, motion, page, pen)
            rng = np.random.default_rng(seed)
            moved = (
                IdealMotors(world, motion) if motors == "ideal" else RealMotors(world, motion, rng)
            )
            yield from recorder.record(world, moved)
        except (KeyboardInterrupt, Exception) as error:
            if recorder.rows < 2:
                raise
            failure = error
    run = recorder.run(page, pen, motors, stopped=failure is not None)
    if failure is not None and not isinstance(failure, KeyboardInterrupt):
        # Some errors take no more attributes.
        with contextlib.suppress(AttributeError):
            setattr(failure, "run", run)  # noqa: B010 (no type of error has it)
        raise failure
    return run


class _Recorder:
    """What was measured at every step; an interruption leaves all steps before it."""

    def __init__(self, motion: Motion, pen: str) -> None:
        self.motion = motion
        self.model = Model.load(PENS[pen])
        self.names = (*motion.joint_names, *([SLIDE_JOINT] if pen == "sprung" else []))
        self.limits = np.array([self.model.joint(name).effort for name in motion.joint_names])
        length, joints = motion.q.shape
        self.q = np.zeros((length, len(self.names)))
        self.q[0, :joints] = motion.q[0]
        self.effort = np.zeros((length, joints))
        self.force = np.zeros(length)
        self.rows = 1

    def record(self, world: World, motors: IdealMotors | RealMotors) -> Slices[None]:
        """Let the whole motion happen, in slices."""
        last = len(self.motion.t) - 1
        q, v = self.motion.q[0].tolist(), [0.0] * len(world.arm)
        for row in range(1, last + 1):
            if row % _OFTEN == 1:
                yield "physics", (row - 1) / last
            commanded = motors.push(row, q, v)
            q, v, effort, force = world.step()
            self.q[row] = q
            self.force[row] = force
            self.effort[row] = effort if commanded is None else commanded
            self.rows = row + 1
        yield "physics", 1.0

    def run(self, page: Page, pen: str, motors: str, stopped: bool) -> Run:
        """Return the run, as far as it went."""
        plan = self.motion
        rows = slice(self.rows)
        X = self.model.frame("pen_tip", self.q[rows], self.names)
        # The place of the ball nearest to the paper.
        nib = page.to_page(X[:, :3, 3] - NIB_RADIUS * X[:, :3, 2]) - (0.0, 0.0, NIB_RADIUS)
        contact = self.force[rows] > _INK_FORCE
        happened = Motion(
            t=plan.t[rows],
            q=self.q[rows],
            joint_names=self.names,
            tip=X[:, :3, 3],
            target=plan.target[rows],
            pen_down=plan.pen_down[rows],
            page=page,
            strokes=plan.strokes,
            notes=plan.notes,
        )
        return Run(
            motion=happened,
            planned=plan,
            ink=_strokes(plan.t[rows], nib, contact),
            nib=nib,
            force=self.force[rows],
            contact=contact,
            effort=self.effort[rows],
            limits=self.limits,
            pen=pen,
            motors=motors,
            stopped=stopped,
        )


def _strokes(t: Array, nib: Array, contact: BoolArray) -> tuple[Trajectory, ...]:
    """Return a stroke for each stay on the paper; a touch of a single step begins where it did."""
    edges = np.flatnonzero(
        np.diff(np.concatenate([[False], contact, [False]]).astype(int))
    ).reshape(-1, 2)
    pieces = ((min(start, stop - 2), stop) for start, stop in edges)
    return tuple(Trajectory(t[start:stop], nib[start:stop, :2]) for start, stop in pieces)


def _displace(page: Page, height: float, tilt: float) -> Page:
    """Return a page that lies higher [m] and is turned about its own x axis [rad]."""
    if height == 0 and tilt == 0:
        return page
    c, s = np.cos(tilt), np.sin(tilt)
    X = page.X_world_page.copy()
    X[:3, 3] += height * page.normal
    X[:3, :3] = X[:3, :3] @ np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    return Page(X, page.width, page.height)


def _check(motion: Motion) -> None:
    """Raise for what is no motion, or too coarse a one."""
    if not isinstance(motion, Motion):
        kind = kind_of(motion)
        raise SettingError(
            f"motion is {kind}, but must be a Motion; Fetch().write(strokes, page) gives one."
        )
    steps = np.diff(motion.t)
    if len(steps) < 1 or not np.allclose(steps, steps[0], rtol=1e-3) or steps[0] * LEAST_RATE > 1:
        raise SettingError(
            f"The motion must have at least {LEAST_RATE} samples a second, evenly spaced; "
            "Fetch().write(strokes, page) gives 240."
        )


def _check_seed(seed: int) -> None:
    """Raise for what cannot start a random generator."""
    if not isinstance(seed, int | np.integer) or isinstance(seed, bool) or seed < 0:
        raise SettingError(f"seed is {shown(seed)}, but must be a whole number, 0 or more.")


def _check_known(name: str, value: str, known: tuple[str, ...]) -> None:
    """Raise for a word that is not among those known."""
    if value not in known:
        raise SettingError(
            f"{name} is {shown(value)}, but must be one of: {', '.join(map(repr, known))}."
        )


def _check_size(name: str, value: float, most: float, unit: str, hint: str) -> None:
    """Raise for what is no number, or so large that it must have been meant in another unit."""
    number = float(value) if isinstance(value, int | float | np.number) else np.nan
    if not abs(number) <= most:
        raise SettingError(
            f"{name} is {shown(value)} {unit}, but must be between {-most} and {most} {unit}; "
            f"was it in {hint}?"
        )
