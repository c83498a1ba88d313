"""Convert what a caller gives as a letter into its strokes."""

from __future__ import annotations

from collections.abc import Iterable
from io import IOBase
from typing import Any, Protocol, cast, runtime_checkable

import numpy as np

from dmp_teach.errors import LetterError, kind_of
from dmp_teach.trajectory import Trajectory, path_length


@runtime_checkable
class HasStrokes(Protocol):
    """Something whose strokes can be found, such as a `Recording`."""

    def strokes(self) -> Iterable[Trajectory]:
        """Return the strokes, in the order of writing."""


@runtime_checkable
class Writes(Protocol):
    """Something that writes strokes, such as a `Letter`."""

    def write(self) -> Iterable[Trajectory]:
        """Return the strokes, in the order of writing."""


FARTHEST_POINT = 1e9  # farther from 0, and squares of squares overflow [m]

LetterLike = HasStrokes | Writes | Trajectory | Iterable[Trajectory]
"""A `Recording`, a `Letter` (what it writes) or strokes."""


# Any: whatever a caller gave in place of strokes; `to_strokes` checks it.
def list_strokes(letter: Any) -> tuple[Any, ...]:
    """Return the strokes of a recording, of what a letter writes, or what was given, unchecked."""
    if isinstance(letter, Trajectory):
        return (letter,)
    if callable(getattr(letter, "write", None)) and not isinstance(letter, IOBase):
        return tuple(letter.write())
    given = letter.strokes() if callable(getattr(letter, "strokes", None)) else letter
    return tuple(given) if isinstance(given, Iterable) else (given,)


def to_strokes(letter: LetterLike, name: str = "letter") -> tuple[Trajectory, ...]:
    """Return the strokes of a recording, a letter or a sequence of strokes, in writing order.

    Raises:
        LetterError: Something else, nothing, strokes that are not flat or too far away, or a
            letter without length.
    """
    strokes = list_strokes(letter)
    wrong = [each for each in strokes if not isinstance(each, Trajectory)]
    if wrong or not strokes:
        what = kind_of(wrong[0]) if wrong else "nothing"
        raise LetterError(
            f"{name} must be a Recording, a Letter or its strokes (Trajectory), but is {what}."
        )
    for k, stroke in enumerate(strokes):
        if stroke.dimensions != 2:
            raise LetterError(
                f"Stroke {k} of {name} has {stroke.dimensions} dimensions, but ink has 2, "
                "right and up; leave out the height, or give the recording."
            )
        if (reach := float(np.abs(stroke.position).max())) > FARTHEST_POINT:
            raise LetterError(
                f"Stroke {k} of {name} reaches to {reach:.3g}, but positions are in metres."
            )
    if not max(path_length(stroke.position) for stroke in strokes) > 0:
        raise LetterError(
            f"{name} is a dot: the pen never moves. A letter has at least one stroke with a length."
        )
    return cast(tuple[Trajectory, ...], strokes)
