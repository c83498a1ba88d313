"""The family of errors: each says what is wrong, what must be, and what to do next.

Every one is a `TeachError` and also the built-in error that one would expect, so that
`except ValueError` works, too.
"""

import reprlib
from typing import Any

_short = reprlib.Repr()
_short.maxstring = _short.maxlong = _short.maxother = 60


def kind_of(value: object, first: bool = False) -> str:
    """Return the type of a value with its article: "an int", "a list"; None is "None".

    Args:
        value: Anything.
        first: Whether it begins a sentence: "An int".
    """
    name = type(value).__name__
    # Not "u": a ufunc, a union.
    an = name[0].lower() in "aeio" or name == "ndarray"
    return "None" if value is None else f"{'A' if first else 'a'}{'n' * an} {name}"


def shown(value: object) -> str:
    """Return the beginning of a value, for messages; its kind where it cannot be printed."""
    try:
        return " ".join(_short.repr(value).split())
    # Whole numbers of thousands of digits.
    except ValueError:
        return kind_of(value)


class TeachError(Exception):
    """The root of the family.

    Args:
        words: What is wrong, what must be, and what to do next.
        cure: A value that would work, if one is known: a `Page`, or the `size` of a letter [m].
    """

    # Any: a cure is of the type of the argument that it would replace.
    def __init__(self, *words: str, cure: Any = None):
        super().__init__(*words)
        self.cure = cure

    def _render_traceback_(self) -> "list[str]":
        """Return what IPython shows below a cell: the sentence, without a traceback."""
        return [f"{type(self).__name__}: {self}"]


class SettingError(TeachError, ValueError):
    """A setting is out of its range, or two settings do not go together."""


class SettingWarning(UserWarning):
    """Settings that work, but surely not as meant: kernels that leave gaps."""


class TrajectoryError(TeachError, ValueError):
    """Times or positions cannot be a movement: not finite, not increasing, too few."""


class RecordingError(TeachError, ValueError):
    """A recording cannot be read; names the file, the row and the column."""


class LetterError(TeachError, ValueError):
    """A letter has no such stroke, start or goal; names those that it has."""


class PageError(TeachError, ValueError):
    """The page, or the letter on it, does not fit."""


class ReachError(TeachError, ValueError):
    """The arm cannot get to all of the page; says by how much, and which page works."""


class ReachWarning(UserWarning):
    """The arm is nearly stretched out; says how far to move the page."""


class JointError(TeachError, KeyError):
    """No joint or frame of that name; names the nearest ones."""

    def __str__(self) -> str:
        """Return the sentence, which a KeyError would print in quotation marks."""
        return " ".join(map(str, self.args))


class MissingPartError(TeachError, ImportError):
    """A library that this platform does not have; says what still works and how to get it."""


class SetupError(TeachError, RuntimeError):
    """The computer lacks what the launcher needs; says what to type."""


class ViewError(TeachError, TypeError):
    """Something that cannot be shown; says what can."""


class PathError(TeachError, OSError):
    """A place that cannot be written; says why, and what was there before stays."""
