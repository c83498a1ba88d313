"""How fast the robot's writing is planned, simulated and shown: multiples of real time, beside
pink.

All tasks take turns on the same letters. Planning is everything that `Fetch().write` does: on a new
page, where the arm must first find how to stand, and on a page on which it has written before. The
joints alone are what pink does, too: it gets our pen's path, our start posture and a robot with
only the seven joints that write.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

import dmp_teach as teach
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.motion import Motion
from dmp_teach.robot.slices import run_through
from dmp_teach.robot.solvers import get_solver
from dmp_teach.trajectory import Array
from dmp_teach.views.scene.commands import record_stage
from dmp_teach.views.scene.stage import Stage
from tests.benchmarks.measure import in_turns

LETTERS = (("a", "round"), ("g", "slanted"), ("R", "round"), ("8", "slanted"), ("k", "round"))
AT_LEAST = {
    "planning, new page": 100,
    "planning, same page again": 100,
    "physics, ideal motors": 10,
    "physics, real motors": 10,
}
"""The multiples of real time that are to be reached."""

SOON = 2.0  # the view is to be ready so long after the motion [s]
_VIEW = "view ready after [s]"


def writing(turns: int) -> tuple[list[dict[str, Any]], list[str]]:
    """A row for every task, over all letters and turns, and the names of what is not installed."""
    pink, missing = _pink()
    figures: dict[str, list[Array]] = {}
    errors: dict[str, list[float]] = {}
    for character, alphabet in LETTERS:
        strokes = teach.Letter.learn(teach.recording_of(character, alphabet)).write()
        motion, tasks = _tasks(strokes, pink)
        for name, times in in_turns(tasks, turns).items():
            figures.setdefault(name, []).append(
                times.seconds if name == _VIEW else motion.duration / times.seconds
            )
        for name in ("joints alone", *pink):
            errors.setdefault(name, []).append(tip_error(motion, tasks[name]()))
    return [
        _row(name, np.concatenate(found), errors.get(name)) for name, found in figures.items()
    ], missing


def _tasks(strokes: Any, pink: dict[str, Callable]) -> tuple[Motion, dict[str, Callable[[], Any]]]:
    """A letter's motion, and what is measured with it."""
    fetch, page, solver = teach.Fetch(), teach.Page.table(), get_solver()
    motion = fetch.write(strokes, page)
    run = teach.simulate(motion)

    def shown() -> Any:
        stage = Stage(run.motion, run)
        return record_stage(stage), stage.facts()

    def anew() -> Motion:
        solver.verdicts.clear()
        return fetch.write(strokes, page)

    return motion, {
        "planning, new page": anew,
        "planning, same page again": lambda: fetch.write(strokes, page),
        "joints alone": lambda: run_through(solver.follow(motion.q[0], page.normal, motion.target)),
        **{name: arm(motion).follow for name, arm in pink.items()},
        "physics, ideal motors": lambda: teach.simulate(motion),
        "physics, real motors": lambda: teach.simulate(motion, motors="real"),
        _VIEW: shown,
    }


def _pink() -> tuple[dict[str, Callable], list[str]]:
    """Pink as documented, and as lean as it gets, where it is installed."""
    try:
        from tests.benchmarks.pink_arm import PinkArm  # noqa: PLC0415 (only where it is installed)
    except ImportError:
        return {}, ["pin-pink"]
    return {
        "joints alone, pink": PinkArm,
        "joints alone, pink, leanest": lambda motion: PinkArm(motion, lean=True),
    }, []


def tip_error(motion: Motion, q: Array) -> float:
    """Root mean square distance of the nib from its path, by the model's own kinematics [mm]."""
    tip = Model.load().frame("pen_tip", q, motion.joint_names)[:, :3, 3]
    return 1e3 * float(np.sqrt(((tip - motion.target) ** 2).sum(axis=1).mean()))


def _row(name: str, figures: Array, errors: list[float] | None) -> dict[str, Any]:
    """Median and quartiles over letters and turns, the worst error, and the aims."""
    low, median, high = np.percentile(figures, [25, 50, 75])
    row = {"name": name, "median": median, "lower_quartile": low, "upper_quartile": high}
    return row | {"tip_error_mm": max(errors) if errors else None, "bound": AT_LEAST.get(name)}


def lines(rows: list[dict[str, Any]]) -> list[str]:
    """The rows as a plain table."""
    if not rows:
        return []
    found = [
        "",
        "Writing with the robot, multiples of real time at 240 Hz, "
        "and the tip's error (rms, the worst letter)",
    ]
    for row in rows:
        spread = "{median:9.2f} [{lower_quartile:.2f}, {upper_quartile:.2f}]".format_map(row)
        bound = f" of {row['bound']}" if row["bound"] else ""
        error = "" if row["tip_error_mm"] is None else f"{row['tip_error_mm']:10.4f} mm"
        found.append(f"{row['name']:30}{spread + bound:36}{error}".rstrip())
    return [
        *found,
        f"The joints alone are what pink does, too. The view is to be ready within {SOON:.0f} s.",
    ]
