"""A lesson and its pictures as the browser reads them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from dmp_teach.classroom.lesson.bets import ChosenBet, LessonState
from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.classroom.lesson.content import Affine, LessonContent, Pick, Picture
from dmp_teach.classroom.lesson.progress import HINTS_AFTER_MISSES, LessonProgress, begin_progress
from dmp_teach.texts import gettext as _


# Any, here and below: JSON for the browser.
def describe_lesson(lesson: LessonContent) -> dict[str, Any]:
    """Return what of a lesson does not change, for the browser."""
    return {
        "key": lesson.key,
        "pupil": lesson.pupil or "",
        "question": lesson.question,
        "knobs": {name: knob.described() for name, knob in lesson.knobs.items()},
        "bet": lesson.bet.described(),
        "tasks": list(map(lesson.tell, lesson.tasks)),
        "by_robot": [i in lesson.by_robot for i in range(len(lesson.tasks))],
        "challenge": lesson.challenge,
        "draws_tried": lesson.draws_tried,
    }


def describe_card(
    lesson: LessonContent, progress: LessonProgress, answer: Answer
) -> dict[str, Any]:
    """Return the words of the step that a pupil has come to."""
    conditions = lesson.conditions(answer) if progress["step"] == "challenge" else ()
    hints = list(lesson.hints[: progress["hints"]])
    offered = progress["misses"] >= HINTS_AFTER_MISSES and len(hints) < len(lesson.hints)
    return {
        "bet": lesson.tell_bet(progress["bet"]) if progress["revealed"] else "",
        "rows": [[each.name, each.shown, each.rule, each.is_met] for each in conditions],
        "hints": hints,
        "offersHint": offered and not progress["passed"],
    }


# Any: whatever a picture holds.
def pack(value: Any) -> Any:
    """Return a picture with its points as float64 bytes, for the browser."""
    if isinstance(value, np.ndarray):
        return np.ascontiguousarray(value, dtype="<f8").tobytes()
    if isinstance(value, Affine):
        return {"base": pack(value.base), "terms": pack(value.terms)}
    if isinstance(value, Picture):
        value = {"sheet": value.sheet, "plots": value.plots, "highs": value.highs}
    if isinstance(value, Pick):
        return {"pick": value.knob, "pictures": pack(list(value.pictures))}
    if isinstance(value, dict):
        return {name: pack(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [pack(each) for each in value]
    return value.item() if isinstance(value, np.generic) else value


def describe_page(lesson: LessonContent) -> dict[str, Any]:
    """Return a lesson that nobody has begun, each step with what is seen of it at the start."""
    start, bet = dict(lesson.start), lesson.bet
    if isinstance(bet, ChosenBet):
        bets: dict[str, Any] = {name: name for name in bet.options}
        told = {name: lesson.tell_bet(name) for name in bets}
    else:
        bets = {"drawn": bet.checked(np.asarray(bet.handles).tolist())}
        told = {"drawn": _("Your bet is the dashed line. Look how far the truth is from it.")}
    any_bet = next(iter(bets.values()))
    states = {
        "bet": LessonState(start),
        "try": LessonState(start, "try", any_bet, is_revealed=True),
        **{f"truth {name}": LessonState(start, "bet", bets[name], True) for name in bets},
    }
    seen = {name: _describe_step(lesson, state) for name, state in states.items()}
    return {
        "spec": describe_lesson(lesson) | {"pupil": ""},
        "progress": begin_progress(),
        "card": describe_card(lesson, begin_progress(), start),
        **seen["bet"],
        **{"values": start, "start": start, "seen": seen, "told": told},
        **{"status": "", "still": ""},
    }


def _describe_step(lesson: LessonContent, state: LessonState) -> dict[str, Any]:
    """Return what is seen of a step, without the thresholds that a kernel would draw anew."""
    picture, knobs = lesson.draw(state), lesson.knobs

    # Any: whatever a plot holds.
    def keep(plot: dict[str, Any]) -> dict[str, Any]:
        thresholds = plot.get("thresholds", [])
        return plot | {"thresholds": [t for t in thresholds if knobs[t["name"]].is_drawn_here]}

    plots = {name: keep(plot) for name, plot in picture.plots.items()}
    return {"picture": pack(replace(picture, plots=plots)), "message": picture.says}
