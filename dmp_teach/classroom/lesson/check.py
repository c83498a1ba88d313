"""Conditions of a challenge, and the verdict on an answer: plain values, without a browser."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from dmp_teach.errors import SettingError
from dmp_teach.texts import gettext as _
from dmp_teach.values import Value

# Any: a number for a slider, a word for a choice.
Answer = dict[str, Any]
"""What a pupil has set, by the names of `Lesson.settable`."""

Measured = float | Callable[[], float]
"""A number, or what returns it when it is asked."""


@dataclass(frozen=True, eq=False, repr=False)
class Condition(Value):
    """A number that must lie between two limits.

    Args:
        name: What it is, as the pupil reads it: "the e", "bumps".
        value: The number, or what returns it.
        low: The least that will do.
        high: The most that will do.
        unit: Of the number and its limits, "mm".
    """

    name: str
    value: Measured
    low: float = -math.inf
    high: float = math.inf
    unit: str = ""

    @property
    def number(self) -> float:
        """The number as it is now.

        Raises:
            SettingError: What should return it fails; names the condition.
        """
        value = self.value
        return evaluate(self.name, lambda: float(value())) if callable(value) else value

    @property
    def is_met(self) -> bool:
        """Whether the number lies between the limits; one that is not finite does not."""
        return math.isfinite(self.number) and self.low <= self.number <= self.high

    @property
    def shown(self) -> str:
        """The number with its unit, with so many digits that it does not hide the verdict."""
        value = self.number
        if not math.isfinite(value):
            return "–"
        is_count = not self.unit and value % 1 == 0
        digits = 0 if is_count or abs(value) >= 10 else 1
        # As the sentence below the pictures says it.
        digits += self.unit == "mm" and abs(value) < 0.995
        return f"{tell_number(value, self.high, digits, self.low)} {self.unit}".strip()

    @property
    def rule(self) -> str:
        """What is asked: "at most 1 mm"."""
        low, high = (f"{limit:g} {self.unit}".strip() for limit in (self.low, self.high))
        if self.low == self.high:
            return _("exactly {limit}").format(limit=low)
        if math.isinf(self.low):
            return _("at most {limit}").format(limit=high)
        if math.isinf(self.high):
            return _("at least {limit}").format(limit=low)
        return _("from {low} to {high}").format(low=f"{self.low:g}", high=high)

    @property
    def shortfall(self) -> str:
        """What is missing, in a sentence with the number."""
        name = self.name[:1].upper() + self.name[1:]
        words = _("{name}: {shown}. It must be {rule}.")
        return words.format(name=name, shown=self.shown, rule=self.rule)


@dataclass(frozen=True)
class Fact(Condition):
    """A condition that holds, 1, or does not, 0: there is no number to show."""

    @property
    def shown(self) -> str:
        """Whether it holds."""
        return _("yes") if self.is_met else _("no")

    @property
    def rule(self) -> str:
        """Nothing more: its name says it."""
        return ""

    @property
    def shortfall(self) -> str:
        """That it does not hold."""
        return f"{self.name[:1].upper()}{self.name[1:]}: {self.shown}."


def tell_number(
    value: float, high: float = math.inf, digits: int = 1, low: float = -math.inf
) -> str:
    """Return a number as it is shown, with more digits where it would else look like a limit."""
    for more in range(digits, digits + 6):
        # A sum with 0.0 has no minus before a zero.
        rounded = round(value, more) + 0.0
        if all((rounded > x, rounded < x) == (value > x, value < x) for x in (low, high)):
            break
    return f"{rounded:.{more}f}".replace("-", "−")


# Any: as what is called.
def evaluate(name: str, ask: Callable[[], Any]) -> Any:
    """Return what a function of a teacher's own returns.

    Raises:
        SettingError: It fails; names it, and what went wrong.
    """
    try:
        return ask()
    except Exception as error:
        words = _("“{name}” cannot be worked out. {kind}: {error}")
        said = words.format(name=name, kind=type(error).__name__, error=error)
        raise SettingError(said) from error


def at_most(name: str, value: Measured, limit: float, unit: str = "") -> Condition:
    """Return the condition that a number is at most a limit."""
    return Condition(name, value, high=limit, unit=unit)


def at_least(name: str, value: Measured, limit: float, unit: str = "") -> Condition:
    """Return the condition that a number is at least a limit."""
    return Condition(name, value, low=limit, unit=unit)


def between(name: str, value: Measured, low: float, high: float, unit: str = "") -> Condition:
    """Return the condition that a number lies between two limits."""
    return Condition(name, value, low, high, unit)


def exactly(name: str, value: Measured, wanted: float, unit: str = "") -> Condition:
    """Return the condition that a number is the wanted one."""
    return Condition(name, value, wanted, wanted, unit)


def holds(name: str, is_so: bool) -> Condition:
    """Return the condition that something is so."""
    return Fact(name, float(is_so), 1.0, 1.0)


@dataclass(frozen=True, eq=False, repr=False)
class Verdict(Value):
    """What a check says of one answer.

    Args:
        done: Whether the challenge is met.
        reason: Why, of this answer.
        hint: The next one; empty when done.
        conditions: Each with its number.
    """

    done: bool
    reason: str
    hint: str = ""
    conditions: tuple[Condition, ...] = ()

    def __str__(self) -> str:
        """Return the reason, and the hint on a line of its own."""
        return "\n".join(line for line in (self.reason, self.hint) if line)


def judge(
    conditions: Sequence[Condition],
    mistakes: Iterable[str],
    praise: Callable[[], str],
    hint: str,
) -> Verdict:
    """Return the verdict: the first mistake that was made, or else the first shortfall.

    Args:
        conditions: All must be met.
        mistakes: What is said of each that was made, the most telling first. An answer with a
            mistake is not done, whatever its numbers.
        praise: Returns what is said when all is well.
        hint: Given when it is not.
    """
    missing = (each.shortfall for each in conditions if not each.is_met)
    reason = next(chain(mistakes, missing), None)
    if reason is None:
        return Verdict(True, praise(), "", tuple(conditions))
    return Verdict(False, reason, hint, tuple(conditions))
