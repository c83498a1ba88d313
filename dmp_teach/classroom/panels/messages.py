"""Sentences of the panels: one number, one sentence, and a thing of that size."""

from __future__ import annotations

import numpy as np

from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

_THINGS_IN_MM = (
    (0.1, marked("the thickness of a hair")),
    (0.2, marked("the thickness of two hairs")),
    (0.5, marked("half the width of a pen line")),
    (1.0, marked("the width of a pen line")),
    (2.0, marked("the width of two pen lines")),
    (3.5, marked("half the width of a pencil")),
    (7.0, marked("the width of a pencil")),
    (14.0, marked("the width of a finger")),
    (28.0, marked("the width of two fingers")),
    (42.0, marked("the width of three fingers")),
    (56.0, marked("the width of four fingers")),
    (100.0, marked("the width of a hand")),
    (200.0, marked("the width of two hands")),
)

Message = dict[str, str]
"""A number, its unit, and a sentence in three parts, the middle one strong."""


def says(
    number: str = "", unit: str = "", text: str = "", strong: str = "", after: str = ""
) -> Message:
    """Return a message."""
    return {"number": number, "unit": unit, "text": text, "strong": strong, "after": after}


def format_millimetres(metres: float) -> str:
    """Return a length as a sentence has it: "under 0.1", "7.8", "24"."""
    number = show_millimetres(metres)
    return _("under {n}").format(n=number[2:]) if number.startswith("< ") else number


def show_millimetres(metres: float) -> str:
    """Return a length as it is shown: "< 0.1", "7.8", "24"."""
    mm = 1000 * metres
    if mm < 0.05:
        return "< 0.1"
    return f"{mm:.1f}" if mm < 9.95 else f"{mm:.0f}"


def name_comparable_width(metres: float) -> str:
    """Return the thing of the nearest size, on a scale of factors: "the width of a pencil"."""
    mm = 1000 * metres
    if mm < 0.05:
        return _("less than a hair")
    return _(min(_THINGS_IN_MM, key=lambda thing: abs(np.log(thing[0] / mm)))[1])


def format_centimetres(metres: float) -> str:
    """Return a distance that was chosen: "7.0 cm"."""
    return _("{n} cm").format(n=f"{100 * metres:.1f}")


def suggest_change(error: float, n_kernels: int, kernel_width: float) -> str:
    """Return the next thing to try, by what makes this letter differ."""
    if error < 0.0005:
        return _("The line sits on the dots.")
    if kernel_width < 0.99:
        return _("Narrow bumps leave gaps between them: try width 1.0.")
    if kernel_width > 1.5:
        return _("Wide bumps mix with their neighbours: try narrower ones.")
    return _("Try more bumps.") if n_kernels < 60 else _("Try a width of 1.0.")


def describe_fit(error: float, n_kernels: int, kernel_width: float) -> Message:
    """Return the message for a letter whose goals are as demonstrated."""
    text = _("On average the line is off the dots by **{thing}.** {cure}").format(
        thing=name_comparable_width(error), cure=suggest_change(error, n_kernels, kernel_width)
    )
    return build_message(text, error)


def describe_moved_goal(moved: float, miss: float, error: float, stroke: int | None) -> Message:
    """Return the message for a goal that was moved [m], and from which the pen stops at a miss [m].

    The error is that of the unmoved letter [m]; a letter with one stroke does not name it.
    """
    text = _("You moved the goal by {cm}.")
    if stroke is not None:
        text = _("You moved the goal of stroke {n} by {cm}.")
    stop = _("**The pen stops {miss} mm from the ring.** Unmoved, the letter is {error} mm off.")
    said = f"{text} {stop}".format(
        n=None if stroke is None else stroke + 1,
        cm=format_centimetres(moved),
        miss=format_millimetres(miss),
        error=format_millimetres(error),
    )
    return build_message(said, miss)


def describe_letter(name: str, error: float, gap: str) -> str:
    """Return the text alternative of the sheet: which letter, how far off, where the most."""
    said = _("{letter}: the robot’s line is {mm} mm from the dots on average, {gap}.")
    letter = f"{name[0].upper()}{name[1:]}"
    return said.format(letter=letter, mm=format_millimetres(error), gap=gap)


def describe_largest_gap(demo: tuple[Trajectory, ...], robot: tuple[Trajectory, ...]) -> str:
    """Return where the robot is furthest from the person: "most near the end of stroke 2"."""
    apart = [
        np.linalg.norm(p.position - q.position, axis=1) for p, q in zip(demo, robot, strict=True)
    ]
    stroke = int(np.argmax([a.max() for a in apart]))
    part = np.argmax(apart[stroke]) / (len(apart[stroke]) - 1)
    alone, one = [
        (_("most near its start"), _("most near the start of stroke {n}")),
        (_("most near its middle"), _("most near the middle of stroke {n}")),
        (_("most near its end"), _("most near the end of stroke {n}")),
    ][0 if part < 1 / 3 else 1 if part < 2 / 3 else 2]
    return alone if len(demo) == 1 else one.format(n=stroke + 1)


def build_message(sentence: str, distance: float | None = None) -> Message:
    """Return a message with a distance [m] as its one number, or without a number.

    What is strong of the sentence stands between two pairs of stars.
    """
    number, unit = ("", "") if distance is None else (show_millimetres(distance), _("mm"))
    text, strong, after, *_rest = (*sentence.split("**", 2), "", "")
    return {"number": number, "unit": unit, "text": text, "strong": strong, "after": after}
