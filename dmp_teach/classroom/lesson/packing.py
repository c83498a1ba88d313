"""A lesson and its pictures as the browser reads them."""

from __future__ import annotations

from typing import Any

import numpy as np

from dmp_teach.classroom.lesson.content import Affine, LessonContent, Pick


# Any, here and below: JSON for the browser.
def describe_lesson(lesson: LessonContent) -> dict[str, Any]:
    """Return what of a lesson does not change, for the browser."""
    return {
        "key": lesson.key,
        "pupil": lesson.pupil or "",
        "question": lesson.question,
        "knobs": {name: knob.described() for name, knob in lesson.knobs.items()},
        "bet": lesson.bet.described(),
        "tasks": [task.text for task in lesson.tasks],
        "by_robot": [task.by_robot for task in lesson.tasks],
        "challenge": lesson.challenge,
    }


# Any: whatever a picture holds.
def pack(value: Any) -> Any:
    """Return a picture with its points as float64 bytes, for the browser."""
    if isinstance(value, np.ndarray):
        return np.ascontiguousarray(value, dtype="<f8").tobytes()
    if isinstance(value, Affine):
        return {"base": pack(value.base), "terms": pack(value.terms)}
    if isinstance(value, Pick):
        return {"pick": value.knob, "pictures": pack(list(value.pictures))}
    if isinstance(value, dict):
        return {name: pack(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [pack(each) for each in value]
    return value.item() if isinstance(value, np.generic) else value
