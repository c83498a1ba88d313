"""What the robot does when a panel asks it to write: named steps, a motion, and its physics."""

from __future__ import annotations

from typing import Any

from dmp_teach.robot import Motion, Page, Run, Slices, simulate_in_slices
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

# Any: arguments of `simulate_in_slices`.
Physics = dict[str, Any]
"""What `simulate_in_slices` is called with, where a motion is to meet gravity."""

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
    strokes: tuple[Trajectory, ...], page: Page, size: float | None, physics: Physics | None
) -> Slices[Motion | Run]:
    """Return the robot's motion, or what physics makes of it, in slices.

    The solver is built once, in the thread that uses it.
    """
    # PlaCo loads when a robot is wanted.
    from dmp_teach.robot import Fetch  # noqa: PLC0415

    yield "wake", 0.5
    motion = yield from Fetch().write_in_slices(strokes, page, size=size)
    return motion if physics is None else (yield from simulate_in_slices(motion, **physics))
