"""Bets: what a pupil predicts before the truth is laid over it. None is called wrong."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.errors import SettingError, shown
from dmp_teach.trajectory import Array

# Any: which of the two, the kind of bet knows.
KeptBet = Any
FARTHEST = 1e6
"""The name of an option, or the places of handles."""


@dataclass(frozen=True)
class DrawnBet:
    """Handles on a picture, which the pupil moves or draws a line for.

    Args:
        question: What to predict.
        part: "sheet", or the name of a plot.
        handles: Where they begin, shape (N, 2).
        label: What each is called, for who does not see it; or one text for all, which may name
            the number {n} and the place {x} of a handle.
        axis: "y" where a handle moves up and down only, else "xy".
        step: Of an arrow key; on a logarithmic axis the factor is 10**step.
        unit: Of the heights of handles; empty on the sheet.
        low: How far down a handle can be; above 0 on a logarithmic axis.
        high: How far up.
    """

    question: str
    part: str
    handles: Array
    label: str | Sequence[str]
    axis: str = "y"
    step: float = 0.001
    unit: str = ""
    low: float = -1000.0
    high: float = 1000.0

    @property
    def labels(self) -> list[str]:
        """What each handle is called."""
        if not isinstance(self.label, str):
            return list(self.label)
        return [self.label.format(n=n, x=x) for n, (x, _y) in enumerate(self.handles, start=1)]

    def checked(self, bet: object) -> KeptBet:
        """Return a bet with a place for each handle.

        Raises:
            SettingError: Other places than handles, or one that is no place.
        """
        is_list = isinstance(bet, list) and len(bet) == len(self.handles)
        if not is_list or not all(_is_place(each) for each in bet):  # type: ignore[attr-defined]
            raise SettingError(f"A bet here has {len(self.handles)} places, but got {shown(bet)}.")
        places = np.array(bet, dtype=float)
        if self.axis == "y":
            places[:, 0] = self.handles[:, 0]
        places[:, 1] = np.clip(places[:, 1], self.low, self.high)
        return [[float(x), float(y)] for x, y in places]

    def described(self) -> dict[str, object]:
        """Return it as the browser reads it."""
        places = [[float(x), float(y)] for x, y in self.handles]
        how = {"axis": self.axis, "step": self.step, "unit": self.unit}
        where = {"part": self.part, "handles": places, "labels": self.labels}
        return {"question": self.question, **where, **how}


@dataclass(frozen=True)
class ChosenBet:
    """One of several answers.

    Args:
        question: What to predict.
        options: The name of each answer, and its words.
        notes: The name of an answer, and a line below its words.
    """

    question: str
    options: Mapping[str, str] = field(default_factory=dict)
    notes: Mapping[str, str] = field(default_factory=dict)

    def checked(self, bet: object) -> KeptBet:
        """Return a bet that is one of the options.

        Raises:
            SettingError: It is none of them.
        """
        if not isinstance(bet, str) or bet not in self.options:
            names = ", ".join(self.options)
            raise SettingError(f"The bet is {shown(bet)}, but must be one of: {names}.")
        return bet

    def described(self) -> dict[str, object]:
        """Return it as the browser reads it."""
        options = [[name, said, self.notes.get(name, "")] for name, said in self.options.items()]
        return {"question": self.question, "options": options}


Bet = DrawnBet | ChosenBet


def _is_place(value: object) -> bool:
    """Return whether a value is two numbers that a hand can reach."""
    if not isinstance(value, list) or len(value) != 2:
        return False
    return all(type(each) in (int, float) and abs(each) < FARTHEST for each in value)


@dataclass(frozen=True)
class LessonState:
    """What a lesson draws.

    Args:
        values: What is set, one for each knob.
        step: "bet", "try" or "challenge".
        bet: The pupil's, once there is one.
        is_revealed: Whether the truth may be seen.
        tried: The values that were set before, the oldest first.
    """

    values: Answer
    step: str = "bet"
    bet: KeptBet | None = None
    is_revealed: bool = False
    tried: tuple[Answer, ...] = ()

    @property
    def is_hidden(self) -> bool:
        """Whether the truth must not be seen yet."""
        return self.step == "bet" and not self.is_revealed
