"""Numbers as a child reads them: one number, one sentence, and a thing of that size."""

import numpy as np

from dmp_teach.trajectory import Trajectory

_THINGS = (
    (0.1, "the thickness of a hair"),
    (1.0, "the width of a pen line"),
    (7.0, "the width of a pencil"),
    (14.0, "the width of a finger"),
    (100.0, "the width of a hand"),
)


def millimetres(metres: float) -> str:
    """A length as it is shown: "under 0.1", "7.8", "24"; never more figures than can be seen."""
    mm = 1000 * metres
    if mm < 0.05:
        return "under 0.1"
    return f"{mm:.1f}" if mm < 9.95 else f"{mm:.0f}"


def as_wide_as(metres: float) -> str:
    """The thing whose size is the nearest, on a scale of factors: "the width of a pencil"."""
    mm = 1000 * metres
    if mm < 0.05:
        return "less than a hair"
    return min(_THINGS, key=lambda thing: abs(np.log(thing[0] / mm)))[1]


def centimetres(metres: float) -> str:
    """A distance that somebody chose: "7.0 cm"."""
    return f"{100 * metres:.1f} cm"


def what_to_try(error: float, n_kernels: int, kernel_width: float) -> str:
    """The next thing to try, from what makes this letter differ."""
    if error < 0.0005:
        return "The line sits on the dots."
    if kernel_width < 0.99:
        return "Narrow bumps leave gaps between them: try width 1.0."
    if kernel_width > 1.5:
        return "Wide bumps mix with their neighbours: try narrower ones."
    return "Try more bumps." if n_kernels < 60 else "Try a width of 1.0."


def fit_message(error: float, n_kernels: int, kernel_width: float) -> dict[str, str]:
    """The sentence for a letter whose goals are where they were taught."""
    return {
        "number": millimetres(error),
        "unit": "mm",
        "text": "On average the line is off the dots by ",
        "strong": f"{as_wide_as(error)}.",
        "after": f" {what_to_try(error, n_kernels, kernel_width)}",
    }


def goal_message(moved: float, miss: float, error: float, stroke: int | None) -> dict[str, str]:
    """The sentence for a goal that was moved: how far the pen stops from it, and how good the letter was before.

    Args:
        moved: How far the goal is from where it was taught [m].
        miss: How far the pen stops from the moved goal [m].
        error: The fit with all goals as taught [m].
        stroke: Which stroke, or None where the letter has only one.
    """
    which = "goal" if stroke is None else f"goal of stroke {stroke + 1}"
    return {
        "number": millimetres(miss),
        "unit": "mm",
        "text": f"You moved the {which} by {centimetres(moved)}. ",
        "strong": f"The pen stops {millimetres(miss)} mm from the ring.",
        "after": f" Unmoved, the letter is {millimetres(error)} mm off.",
    }


def letter_title(name: str, error: float, gap: str) -> str:
    """The text alternative of the sheet: which letter, how far off, where the most."""
    return f"{name[0].upper()}{name[1:]}: the robot’s line is {millimetres(error)} mm from the dots on average, {gap}."


def largest_gap(demo: tuple[Trajectory, ...], robot: tuple[Trajectory, ...]) -> str:
    """Where the robot is furthest from the person: "most in stroke 2, near its middle"."""
    apart = [np.linalg.norm(p.position - q.position, axis=1) for p, q in zip(demo, robot, strict=True)]
    stroke = int(np.argmax([a.max() for a in apart]))
    part = np.argmax(apart[stroke]) / (len(apart[stroke]) - 1)
    place = "start" if part < 1 / 3 else "middle" if part < 2 / 3 else "end"
    return f"most near the {place} of stroke {stroke + 1}" if len(demo) > 1 else f"most near its {place}"
