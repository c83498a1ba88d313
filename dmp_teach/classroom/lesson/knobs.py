"""What a pupil can set in a lesson: sliders and choices, each with its range and its words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from numbers import Real
from typing import Self

from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.dmp import knob_of
from dmp_teach.errors import SettingError, shown
from dmp_teach.texts import gettext as _


@dataclass(frozen=True)
class Slider:
    """A number.

    Args:
        label: The plain name.
        term: The real word.
        low: Where it ends.
        high: Where it ends.
        step: Between two values; of a logarithmic slider the browser's own.
        unit: "mm", or nothing.
        digits: How many are shown behind the point, 0 of whole numbers; None: two figures.
        is_log: Equal ways are equal factors.
        is_drawn_here: What it changes is drawn in the browser; the kernel hears of it on release.
        icons: The drawings at its ends, "narrow", "one", "many".
        is_view: It changes what is looked at, and is no part of the answer.
        is_for_try: It is seen while one tries things out, and not in the challenge.
    """

    label: str
    term: str
    low: float
    high: float
    step: float = 1.0
    unit: str = ""
    digits: int | None = 0
    is_log: bool = False
    is_drawn_here: bool = False
    icons: tuple[str, ...] = ()
    is_view: bool = False
    is_for_try: bool = False

    @classmethod
    def of(cls, setting: str, low: float, high: float, **more: object) -> Self:
        """Return a slider for a field of `Settings`, with its names."""
        knob = knob_of(setting)
        label = _(knob.label)
        more = {"digits": None} | more if more.get("is_log") else more
        return cls(label[:1].upper() + label[1:], _(knob.term), low, high, **more)  # type: ignore[arg-type]

    @property
    def allowed(self) -> tuple[float, float]:
        """The lowest and the highest value."""
        return self.low, self.high

    def checked(self, name: str, value: object) -> float:
        """Return the value as a number on the slider.

        Raises:
            SettingError: It is no number, or lies beyond an end.
        """
        is_number = isinstance(value, Real) and not isinstance(value, bool)
        if not is_number or not self.low <= value <= self.high:  # type: ignore[operator]
            raise SettingError(
                _("{name} is {value}, but must be a number from {low:g} to {high:g}.").format(
                    name=name, value=shown(value), low=self.low, high=self.high
                )
            )
        if self.digits == 0 and value != int(value):  # type: ignore[call-overload]
            raise SettingError(
                _("{name} is {value}, but must be a whole number.").format(
                    name=name, value=shown(value)
                )
            )
        # As it came: an int that came back as a float would be sent to the browser again.
        return value  # type: ignore[return-value]

    def described(self) -> dict[str, object]:
        """Return it as the browser reads it."""
        return {"kind": "slider", **asdict(self)}


@dataclass(frozen=True)
class OneOf:
    """One of several.

    Args:
        label: What is chosen.
        options: The value of each, and its words.
        is_drawn_here: What it changes is drawn in the browser.
        is_view: It changes what is looked at, and is no part of the answer.
        note: What it is about, in a line.
    """

    label: str
    options: Mapping[str, str]
    is_drawn_here: bool = False
    is_view: bool = False
    note: str = ""

    @property
    def allowed(self) -> tuple[str, ...]:
        """The values."""
        return tuple(self.options)

    def checked(self, name: str, value: object) -> str:
        """Return the value.

        Raises:
            SettingError: It is none of the options.
        """
        if not isinstance(value, str) or value not in self.options:
            raise SettingError(
                _("{name} is {value}, but must be one of: {options}.").format(
                    name=name, value=shown(value), options=", ".join(self.options)
                )
            )
        return value

    def described(self) -> dict[str, object]:
        """Return it as the browser reads it."""
        return {"kind": "choice", **asdict(self), "options": list(self.options.items())}


Knobs = Mapping[str, Slider | OneOf]


def check_answer(knobs: Knobs, answer: object) -> Answer:
    """Return an answer with one good value for every knob.

    Raises:
        SettingError: It is no dictionary, or a value is missing, unknown or out of its range.
    """
    if not isinstance(answer, Mapping):
        raise SettingError(
            _("The answer is {answer}, but must be a dictionary with: {names}.").format(
                answer=shown(answer), names=", ".join(knobs)
            )
        )
    if odd := [name for name in (*knobs, *answer) if (name in knobs) != (name in answer)]:
        raise SettingError(
            _("The answer must have exactly: {names}. Look at {odd}.").format(
                names=", ".join(knobs), odd=shown(odd[0])
            )
        )
    return {name: knob.checked(name, answer[name]) for name, knob in knobs.items()}
