"""Sentences of the pad: what it caught of a stroke, what there is to say of a letter, what next."""

from __future__ import annotations

from dmp_teach.classroom.panels.messages import (
    Message,
    build_message,
    format_millimetres,
    name_comparable_width,
)
from dmp_teach.ink import PadStroke
from dmp_teach.scoring import LEVEL_WORDS, MOVEMENT_FAULTS, Fault, Score, leading_fault
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked, ngettext

_APART = marked("Your letter and the robot’s own are this far apart on average.")
# Shares of the letter's size: a distance up to which an attempt is "not far", "close", "the same".
_WORD_SHARES = (0.2, 0.1, 0.04)
# Two widths of a pen's line and a half [m]: so much further away is a little, however near it was.
_LITTLE_FURTHER = 0.0025


def describe_stroke(number: int, stroke: PadStroke | None, outside: int = 0) -> str:
    """Return what the pad saw of a stroke, some of whose points were beyond the sheet.

    None is one that the robot wrote in the place of a person's.
    """
    if stroke is None:
        return _("Stroke {n}: the robot wrote it for you.").format(n=number)
    if outside > 0:
        return _("Your pen left the sheet: write a little smaller.")
    if stroke.is_dot:
        return _("Stroke {n}: a dot.").format(n=number)
    if stroke.is_blurred:
        return _("Stroke {n}: too fast to see. Write a little slower.").format(n=number)
    said = _("Stroke {n}: {seconds:.1f} s, {points} points.")
    return said.format(n=number, seconds=stroke.path.duration, points=stroke.points)


def invite_to_write(character: str) -> Message:
    """Return the message of an empty sheet."""
    if not character:
        return build_message(
            _("Write any letter on your sheet. **The robot learns it as you write it.**")
        )
    text = _("Write {letter} on your sheet. **Show it** lets the robot write it first.")
    return build_message(text.format(letter=add_article(character)))


def ask_for_next_stroke(done: int, of: int, character: str) -> Message:
    """Return the message between two strokes of a letter."""
    text = ngettext(
        "The robot’s {letter} has {n} stroke, yours has {done} so far. "
        "**Write the next one, or press That is all if your {letter} has no more.**",
        "The robot’s {letter} has {n} strokes, yours has {done} so far. "
        "**Write the next one, or press That is all if your {letter} has no more.**",
        of,
    )
    return build_message(text.format(letter=character, n=of, done=done))


def ask_to_write_on(character: str) -> Message:
    """Return the message on ink that cannot be read as the letter, in whatever strokes."""
    text = _("This is not {letter} yet. **Write on, or press That is all.**")
    return build_message(text.format(letter=add_article(character)))


def describe_help(stroke: int) -> Message:
    """Return the message on a complete letter of which the robot wrote a stroke, from 0."""
    text = _("The robot wrote stroke {n} for you. **Start again, and write all of it yourself.**")
    return build_message(text.format(n=stroke + 1))


def describe_missed_stroke(fault: Fault) -> Message:
    """Return the message on a stroke that is to be written again."""
    return build_message(" ".join(_name_the_robots(fault)))


def _name_the_robots(fault: Fault) -> tuple[str, str]:
    """Return a fault beside the robot's letter, and what to do next, which is strong."""
    texts = fault.wording, f"**{fault.advice}**"
    wording, advice = (
        text.format(model=_("the robot’s"), models=_("the robot’s")) for text in texts
    )
    return wording, advice


def describe_learned_ink(error: float) -> Message:
    """Return the message for ink that is compared with nothing: how well it was learned."""
    text = _(
        "On average the robot’s line is off your dots by **{thing}.** "
        "Choose a letter to compare yours with."
    )
    return build_message(text.format(thing=name_comparable_width(error)), error)


def describe_dot(character: str) -> Message:
    """Return the message for a sheet with nothing but dots, where a letter is wanted."""
    text = _("That is only a dot. **Undo** takes it away; then write {letter}.")
    return build_message(text.format(letter=add_article(character)))


def describe_attempt(now: Score, before: Score | None, is_coarse: bool = False) -> Message:
    """Return the message for an attempt: how far it is, in what most, and what to do next.

    Where the pad caught coarse points, nothing is said of how the pen was moved.
    """
    fault = leading_fault(now.faults)
    is_seen = fault is not None and fault.name not in MOVEMENT_FAULTS
    said = "" if is_seen else f" **{_('Well written: it looks the same as the robot’s.')}**"
    if fault is not None and (is_seen or not is_coarse):
        words, advice = _name_the_robots(fault)
        said += f" {words} " + (advice if is_seen else advice.strip("*"))
    if before is not None and is_seen:
        said += f" {compare_attempts(now.distance, before.distance)}"
    return build_message(f"{_(_APART)} {said.strip()}", now.distance)


def describe_other_letter(other: str, wanted: str, distance: float) -> Message:
    """Return the message for a writing that looks like another letter, or like none ("")."""
    wanted = add_article(wanted)
    if not other:
        text = _("No letter can be read yet. **Press Show it, and watch how {letter} is written.**")
        return build_message(text.format(letter=wanted))
    text = _("This looks like {other}. **Press Show it, and watch how {letter} is written.**")
    return build_message(text.format(other=add_article(other), letter=wanted), distance)


def compare_attempts(distance: float, before: float) -> str:
    """Return how a distance is beside that of the attempt before [m]; none is called bad.

    "A little further away" is by half at most, or by the width of a pen's line or two, because
    the number stands beside it.
    """
    looks_equal = format_millimetres(distance) == format_millimetres(before)
    if looks_equal or 0.95 * before <= distance <= 1.05 * before:
        return _("As near as the try before.")
    if distance < before:
        return _("Nearer than the try before.")
    is_little = distance <= max(1.5 * before, before + _LITTLE_FURTHER)
    return _("A little further away this time.") if is_little else _("Further away this time.")


def rate_attempt(score: Score, size: float) -> str:
    """Return an attempt in a word or two: "far", "not far", "close" or "the same".

    It is the word of the row that differs the most, but no word says that an attempt is nearer
    than its number does: a letter of twice the size is far from the robot's, though nothing but
    its size [m] differs.
    """
    by_distance = sum(score.distance <= part * size for part in _WORD_SHARES)
    level = min(by_distance, *(part.level for part in score.parts))
    return _(LEVEL_WORDS[level])


def add_article(character: str) -> str:
    """Return a letter with its article as its name is heard: "an a", "a b"; "" is any."""
    if not character:
        return _("a letter")
    is_vowel = character in "aefhilmnorsxAEFHILMNORSX8"
    text = _("an {letter}") if is_vowel else _("a {letter}")
    return text.format(letter=character)


def describe_sheet(character: str, strokes: int, sentence: str) -> str:
    """Return the text alternative of the pad's sheet."""
    if not strokes:
        return _("Your sheet is empty.")
    text = ngettext("Your {letter}, {n} stroke.", "Your {letter}, {n} strokes.", strokes)
    return f"{text.format(letter=character or _('ink'), n=strokes)} {sentence}".strip()


def describe_undone(number: int, is_empty: bool, stays: bool) -> str:
    """Return which stroke is gone, and whether the attempt that was brought back stays."""
    said = _("The sheet is empty.") if is_empty else _("Stroke {n} is gone.").format(n=number)
    return f"{said} {_('The try before stays.')}" if stays else said


def describe_saved(name: str, was_saved: bool) -> str:
    """Return what *Save* has done; nothing where the newest try was saved before."""
    if was_saved:
        return _("Nothing new to save: your newest try is in {name}.").format(name=name)
    said = _("Saved as {name}, beside this notebook. Other tries are not kept.")
    return said.format(name=name)


def describe_forgotten(removed: list[str], left: list[str]) -> str:
    """Return what *Forget* has done: files that are gone, and pads' files of other pupils."""
    if removed:
        said = _("Everything is forgotten, and {files} removed.").format(files=", ".join(removed))
    else:
        said = _("Everything is forgotten.")
    if left:
        others = _("Of other pupils there are still: {files}.").format(files=", ".join(left))
        said = f"{said} {others}"
    return said
