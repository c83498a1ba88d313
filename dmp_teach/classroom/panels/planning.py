"""What the robot does when a panel asks it to write: named steps, a motion, and its physics."""

from __future__ import annotations

import warnings
from typing import Any

from dmp_teach.classroom.panels.background_job import Report
from dmp_teach.errors import ReachWarning
from dmp_teach.robot import Motion, Page, Run, simulate
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

# Any: arguments of `simulate`.
Physics = dict[str, Any]
"""What `simulate` is called with, where a motion is to meet gravity."""

_STEPS = {
    "wake": marked("Waking the robot"),
    "reach": marked("Can the arm reach the letter?"),
    "joints": marked("Planning every joint"),
}
_PHYSICS_STEP = {"physics": marked("Writing under gravity")}


def name_steps(physics: Physics | None) -> dict[str, str]:
    """Return the words of each step that is told, by its name, in order."""
    steps = _STEPS | ({} if physics is None else _PHYSICS_STEP)
    return {name: _(words) for name, words in steps.items()}


def plan_motion(
    strokes: tuple[Trajectory, ...],
    page: Page,
    size: float | None,
    physics: Physics | None,
    report: Report,
) -> Motion | Run:
    """Return the robot's motion, or what physics makes of it.

    The solver is built once, in the thread that uses it.
    """
    # PlaCo loads when a robot is wanted.
    from dmp_teach.robot import Fetch  # noqa: PLC0415

    report("wake", 0.5)
    # Warnings of this module's call are among the motion's notes, beside the robot.
    warnings.filterwarnings("ignore", category=ReachWarning, module=__name__)
    motion = Fetch().write(strokes, page, size=size, progress=report)
    return motion if physics is None else simulate(motion, **physics, progress=report)
