"""Numbers as a child reads them: one number, one sentence, and a thing of that size."""

from __future__ import annotations

import numpy as np

from dmp_teach.ink import PadStroke
from dmp_teach.scoring import LEVEL_WORDS, MOVEMENT_FAULTS, Score, leading_fault
from dmp_teach.trajectory import Trajectory

_THINGS = (
    (0.1, "the thickness of a hair"),
    (1.0, "the width of a pen line"),
    (7.0, "the width of a pencil"),
    (14.0, "the width of a finger"),
    (100.0, "the width of a hand"),
)

_APART = "Your letter and the robot’s own are this far apart on average. "
_ALIKE = "It looks the same as the robot’s. "
_WITHIN = (
    0.2,
    0.1,
    0.04,
)  # of the letter's size: a distance up to which a try is "nearer", "close", "the same"
_LITTLE = 0.0025  # two widths of a pen's line and a half [m]: so much further away is a little, however near it was


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
    thing, after = f"{as_wide_as(error)}.", f" {what_to_try(error, n_kernels, kernel_width)}"
    return _sentence(error, "On average the line is off the dots by ", thing, after)


def goal_message(moved: float, miss: float, error: float, stroke: int | None) -> dict[str, str]:
    """The sentence for a goal that was moved: how far the pen stops from it, and how good the letter was before.

    Args:
        moved: How far the goal is from where it was taught [m].
        miss: How far the pen stops from the moved goal [m].
        error: The fit with all goals as taught [m].
        stroke: Which stroke, or None where the letter has only one.
    """
    which = "goal" if stroke is None else f"goal of stroke {stroke + 1}"
    text, after = (
        f"You moved the {which} by {centimetres(moved)}. ",
        f" Unmoved, the letter is {millimetres(error)} mm off.",
    )
    return _sentence(miss, text, f"The pen stops {millimetres(miss)} mm from the ring.", after)


def letter_title(name: str, error: float, gap: str) -> str:
    """The text alternative of the sheet: which letter, how far off, where the most."""
    return f"{name[0].upper()}{name[1:]}: the robot’s line is {millimetres(error)} mm from the dots on average, {gap}."


def largest_gap(demo: tuple[Trajectory, ...], robot: tuple[Trajectory, ...]) -> str:
    """Where the robot is furthest from the person: "most in stroke 2, near its middle"."""
    apart = [
        np.linalg.norm(p.position - q.position, axis=1) for p, q in zip(demo, robot, strict=True)
    ]
    stroke = int(np.argmax([a.max() for a in apart]))
    part = np.argmax(apart[stroke]) / (len(apart[stroke]) - 1)
    place = "start" if part < 1 / 3 else "middle" if part < 2 / 3 else "end"
    return (
        f"most near the {place} of stroke {stroke + 1}"
        if len(demo) > 1
        else f"most near its {place}"
    )


def caught(number: int, stroke: PadStroke, outside: int = 0) -> str:
    """What the pad saw of a stroke: "Stroke 2: 1.2 s, 84 points."; `outside` of its points were beyond the sheet."""
    if outside > 0:
        return "Your pen left the sheet: write a little smaller."
    if stroke.is_dot:
        return f"Stroke {number}: a dot."
    if stroke.is_blurred:
        return f"Stroke {number}: too fast to see. Write a little slower."
    return f"Stroke {number}: {stroke.path.duration:.1f} s, {stroke.points} points."


def invitation(character: str) -> dict[str, str]:
    """The sentence of an empty sheet."""
    if not character:
        return _plain("Write any letter on your sheet. ", "The robot learns it as you write it.")
    return _plain(
        f"Write {a(character)} on your sheet. ", "Show it", " lets the robot write it first."
    )


def next_stroke(done: int, of: int, character: str) -> dict[str, str]:
    """The sentence between two strokes of a letter."""
    ending = f"Write the next one, or press That is all if your {character} has no more."
    return _plain(f"The robot’s {character} has {of} strokes, yours has {done} so far. ", ending)


def learned_message(error: float) -> dict[str, str]:
    """The sentence for ink that is compared with nothing: how well the robot has learned it."""
    after = " Choose a letter to compare yours with."
    return _sentence(
        error, "On average the robot’s line is off your dots by ", f"{as_wide_as(error)}.", after
    )


def dot_message(character: str) -> dict[str, str]:
    """The sentence for a sheet with nothing but dots, where a letter is wanted."""
    return _plain("That is only a dot. ", "Undo", f" takes it away; then write {a(character)}.")


def try_message(now: Score, before: Score | None, is_coarse: bool = False) -> dict[str, str]:
    """The sentence for a try: how far it is from the robot's letter, in what most of all, and whether it is nearer.

    Args:
        now: The try's score.
        before: That of the try before.
        is_coarse: Whether the pad caught too few points to tell how the pen was moved.
    """
    said = _named(now, is_coarse)
    if before is None:
        return _sentence(now.distance, _APART, said)
    return _sentence(now.distance, f"{_APART}{said} ", compared(now.distance, before.distance))


def _named(now: Score, is_coarse: bool) -> str:
    """The fault that the score names; one of the movement only where that is known."""
    fault = leading_fault(now.faults)
    unseen = fault is not None and fault.name in MOVEMENT_FAULTS
    if fault is None or (unseen and is_coarse):
        return _ALIKE.strip()
    first = f"{_ALIKE}{fault.sentence}" if unseen else fault.sentence
    return first.replace("the model's", "the robot’s").replace("the model", "the robot’s")


def compared(distance: float, before: float) -> str:
    """A distance beside that of the try before [m]; no try is called bad.

    "A little further away this time" is how the design puts every worse try; it is kept for those that are a little
    further away, by half at most or by the width of a pen's line or two, because the number stands beside it.
    """
    if millimetres(distance) == millimetres(before) or 0.95 * before <= distance <= 1.05 * before:
        return "As near as the try before."
    if distance < before:
        return "Nearer than the try before."
    return f"{'A little further' if distance <= max(1.5 * before, before + _LITTLE) else 'Further'} away this time."


def beside(score: Score, size: float) -> str:
    """A try in a word or two, for its picture: "far", "not far", "close" or "the same".

    It is the word of the row that differs the most, but no word says that a try is nearer than its number does: a
    letter of twice the size is far from the robot's, though nothing but its size differs.

    Args:
        score: The try's score.
        size: How large the robot's letter is [m].
    """
    by_distance = sum(score.distance <= part * size for part in _WITHIN)
    level = min(by_distance, *(part.level for part in score.parts))
    return LEVEL_WORDS[level].replace("nearer", "not far")


def a(character: str) -> str:
    """A letter with its article: "an a", "a b"; the name of the letter is what is heard."""
    return (
        f"an {character}"
        if character and character in "aefhilmnorsxAEFHILMNORSX8"
        else f"a {character}"
    )


def pad_title(character: str, strokes: int, sentence: str) -> str:
    """The text alternative of the child's sheet."""
    if not strokes:
        return "Your sheet is empty."
    count = f"{strokes} stroke{'s' * (strokes > 1)}"
    return f"Your {character or 'ink'}, {count}. {sentence}".strip()


def _plain(text: str, strong: str, after: str = "") -> dict[str, str]:
    """A sentence without a number."""
    return {"number": "", "unit": "", "text": text, "strong": strong, "after": after}


def _sentence(metres: float, text: str, strong: str, after: str = "") -> dict[str, str]:
    """A sentence with the one number."""
    return {
        "number": millimetres(metres),
        "unit": "mm",
        "text": text,
        "strong": strong,
        "after": after,
    }
