"""What can be turned: a default, a range and two names for each setting, each written once."""

from __future__ import annotations

import math
from collections.abc import Collection, Hashable
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

from dmp_teach.errors import SettingError, shown


# Any: the values of settings are numbers, words, yes or no, or None.
@dataclass(frozen=True)
class Knob:
    """What a child or teacher can turn: its default, its range and its names.

    `low` and `high` are where a slider ends, `limit` (or else `high`) is where a number is refused;
    `whole` numbers only, `endless` takes infinity too, `optional` takes None too; `options` are the
    words of a setting that is not a number, or the registry in which they are found. `term` is the
    real word, `label` the plain one.
    """

    name: str
    default: Any
    label: str
    term: str
    low: float = -math.inf
    high: float = math.inf
    limit: float | None = None
    whole: bool = False
    endless: bool = False
    optional: bool = False
    options: Collection[Any] = ()

    @property
    def choices(self) -> tuple[Any, ...]:
        """The options as they are now."""
        return tuple(self.options)

    def checked(self, value: Any) -> Any:
        """Return `value` as the type that it should have.

        Raises:
            SettingError: It is out of range, or no such choice.
        """
        if self.options:
            if isinstance(value, Hashable) and value in self.options:
                # 1 and np.True_ are found as True.
                return next(each for each in self.options if each == value)
            names = ", ".join(map(repr, self.options))
            raise SettingError(f"{self.name} is {shown(value)}, but it must be one of: {names}.")
        if (value is None and self.optional) or (
            self.endless and _is_number(value) and value == math.inf
        ):
            return value
        limit = self.high if self.limit is None else self.limit
        good = _is_number(value) and self.low <= value <= limit
        if not good or (self.whole and value != int(value)):
            number = "a whole number between" if self.whole else "between"
            rule = f"{number} {self.low:g} and {limit:g}"
            raise SettingError(f"{self.name} is {shown(value)}, but it must be {rule}.")
        return int(value) if self.whole else float(value)


def _is_number(value: Any) -> bool:
    """Return whether it is a number that a float holds, and not NaN."""
    try:
        is_real = isinstance(value, Real) and not isinstance(value, bool)
        return is_real and not math.isnan(value)
    except OverflowError:
        return False


def knob(default: Any, label: str, term: str, **about: Any) -> Any:
    """Declare a field of `Settings` that carries its own range and names."""
    return field(default=default, metadata={"label": label, "term": term, **about})
