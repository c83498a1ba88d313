"""Places on a stroke, by name or by a number."""

from __future__ import annotations

import numpy as np

from dmp_teach.errors import LetterError
from dmp_teach.trajectory import Array, arc_lengths

STROKE_PLACES = ("start", "goal", "upper", "lower", "top", "bottom", "left", "right", "middle")
STROKE_ENDS = STROKE_PLACES[:4]


def point_at(path: Array, place: float | str) -> Array:
    """Return a point of a path (T, 2), shape (2,) [m]; `Piece.at` says which places there are."""
    if isinstance(place, str) and place in STROKE_PLACES[:-1]:
        return path[sample_at(path, place)].copy()
    part = 0.5 if place == "middle" else place
    if isinstance(part, str) or not is_number_within(part, 0, 1):
        raise LetterError(
            f"There is no place {place!r} on a stroke; give a part from 0 to 1, or "
            f"{join_choices(STROKE_PLACES)}."
        )
    arc = arc_lengths(path)
    return np.array([np.interp(part * arc[-1], arc, axis) for axis in path.T])


def sample_at(path: Array, place: str) -> int:
    """Return the sample of a path (T, 2) at one of its ends or outermost points."""
    goes_down = path[-1, 1] < path[0, 1]
    ends = {
        "start": 0,
        "goal": -1,
        "upper": 0 if goes_down else -1,
        "lower": -1 if goes_down else 0,
    }
    if place in ends:
        return ends[place]
    outermost = {"top": path[:, 1], "bottom": -path[:, 1], "left": -path[:, 0], "right": path[:, 0]}
    return int(np.argmax(outermost[place]))


def check_end(name: str) -> None:
    """Raise a LetterError for what is no end of a stroke."""
    if name not in STROKE_ENDS:
        ends = join_choices(STROKE_ENDS)
        raise LetterError(f"A stroke has no end {name!r}; it can be led by {ends}.")


def is_number_within(value: object, low: float, high: float) -> bool:
    """Return whether `value` is a number between two others."""
    return isinstance(value, int | float) and not isinstance(value, bool) and low <= value <= high


def join_choices(names: tuple[str, ...]) -> str:
    """Return names in quotation marks, with "or" before the last."""
    return ", ".join(f"{name!r}" for name in names[:-1]) + f" or {names[-1]!r}"
