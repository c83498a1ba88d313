"""The one question that a pupil asks back a turn; the answer is in the ink that it was shown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.scoring import place_in_words
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory, all_points


@dataclass(frozen=True)
class Question:
    """A question that is answered by yes or no.

    Args:
        text: The question.
        is_so: Whether yes is what was shown.
        doubt: What the pupil says to another answer.
    """

    text: str
    is_so: bool
    doubt: str

    def __str__(self) -> str:
        """Return the question."""
        return self.text


def ask(shown: Sequence[Trajectory], seed: int, turn: int) -> Question:
    """Return a question on what was shown: where to start, where to stop, how many strokes."""
    random = np.random.default_rng([seed, turn, 1])
    is_so, turn_of = bool(random.random() < 0.5), turn % 3
    if turn_of == 2:
        return _ask_number(len(shown), is_so)
    points = all_points(shown)
    low, high = points.min(axis=0), points.max(axis=0)
    end = shown[0].position[0] if turn_of == 0 else shown[-1].position[-1]
    x, y = (end - low) / np.maximum(high - low, 1e-9)
    there, opposite = place_in_words((x, y)), place_in_words((1 - x, 1 - y))
    is_so = is_so or there == opposite
    words = (_("Do I start {where}?"), _("You started {where}."))
    if turn_of == 1:
        words = (_("Do I stop {where}?"), _("You stopped {where}."))
    return _question(words, is_so, there, opposite)


def _ask_number(number: int, is_so: bool) -> Question:
    """Return a question on how many strokes there are."""
    one, two = _("once"), _("twice")
    told = {1: one, 2: two}.get(number, _("{n} times").format(n=number))
    other = two if number == 1 else one
    words = (_("Do I put the pen down {where}?"), _("You put the pen down {where}."))
    return _question(words, is_so, told, other)


def _question(words: tuple[str, str], is_so: bool, truth: str, other: str) -> Question:
    """Return a question on what is so, or on something else."""
    asked, told = words
    seen = told.format(where=truth)
    doubt = _("Hm. {seen} Now I am not sure, and shall look again.").format(seen=seen)
    return Question(asked.format(where=truth if is_so else other), is_so, doubt)
