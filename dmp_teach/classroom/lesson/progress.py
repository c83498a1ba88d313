"""How far a pupil has come in a lesson: made afresh, or taken up from a file or a browser."""

from __future__ import annotations

from typing import Any

from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.classroom.lesson.content import LessonContent
from dmp_teach.classroom.lesson.knobs import check_answer
from dmp_teach.errors import SettingError, shown
from dmp_teach.ink import check_pseudonym

LESSON_STEPS = ("bet", "try", "challenge")
MOST_MISSES = 10_000
HINTS_AFTER_MISSES = 2
# Any, here and below: JSON, which is checked field by field.
LessonProgress = dict[str, Any]


def begin_progress() -> LessonProgress:
    """Return the progress of who has just opened a lesson.

    `passed` is the answer that met the challenge, `saved_as` the pseudonym that *Save* has chosen.
    """
    fresh: LessonProgress = {"step": "bet", "bet": None, "revealed": False, "done": [], "hints": 0}
    return fresh | {"misses": 0, "verdict": None, "passed": None, "saved_as": None}


def add_done(
    lesson: LessonContent, progress: LessonProgress, values: Answer, by_robot: bool
) -> list[int]:
    """Return the tasks that are done, with those that values do; or that the robot has written."""
    done = enumerate(lesson.done(values) if progress["step"] == "try" else ())
    new = (i for i, is_so in done if is_so and (i in lesson.by_robot) == by_robot)
    return sorted({*progress["done"], *new})


def take_up(lesson: LessonContent, work: object) -> tuple[LessonProgress, dict[str, Any]]:
    """Return the progress and the values of work that was left.

    Raises:
        SettingError: It does not fit the lesson, or belongs to another pupil's variant.
    """
    try:
        return _read(lesson, work)
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as error:
        raise SettingError(f"This is no work of lesson {lesson.key}: {shown(error)}") from None


def _read(lesson: LessonContent, work: Any) -> tuple[LessonProgress, dict[str, Any]]:
    """Return what `take_up` does; any error where a field is not as it must be."""
    _must(work["variant"] == (lesson.pupil or ""), "variant")
    told = work["progress"]
    progress = begin_progress()
    _must(told["step"] in LESSON_STEPS, "step")
    progress["step"] = told["step"]
    if told["bet"] is not None:
        progress["bet"] = lesson.bet.checked(told["bet"])
        progress["revealed"] = told["revealed"] is True
    progress["done"] = sorted({_count(each, len(lesson.tasks) - 1) for each in told["done"]})
    progress["hints"] = _count(told["hints"], len(lesson.hints))
    progress["misses"] = _count(told["misses"], MOST_MISSES)
    values = check_answer(lesson.knobs, work["values"])
    # Who says that it is passed shows with what.
    verdict = lesson.check(told["passed"])
    if verdict.done:
        progress["passed"] = told["passed"]
        if all(values[name] == value for name, value in told["passed"].items()):
            progress["verdict"] = {"done": True, "reason": verdict.reason}
    # A file of who gave no name is known by what is in it.
    if told["saved_as"] is not None and not lesson.pupil:
        check_pseudonym(told["saved_as"])
        progress["saved_as"] = told["saved_as"]
    return progress, values


def _count(value: object, most: int) -> int:
    """Return a whole number from 0 to the most."""
    _must(type(value) is int and 0 <= value <= most, f"{shown(value)}")
    return int(value)  # type: ignore[call-overload]


def _must(holds: bool, name: str) -> None:
    """Raise a ValueError that names a field, unless it is as it must be."""
    if not holds:
        raise ValueError(name)
