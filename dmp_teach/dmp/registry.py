"""Choices that a setting finds by name: kernels, phases, transformations, fits, integrators."""

from __future__ import annotations

from abc import ABC
from dataclasses import dataclass, fields
from functools import cache
from typing import Any, ClassVar, Self, TypeVar


@dataclass(frozen=True)
class NamedChoice(ABC):
    """One choice for a setting. The fields of a subclass are settings of its own.

    A field is found among the settings as `<setting>_<field>`: the `decay` of a phase is
    `phase_decay`.

    Attributes:
        setting: The setting that it is a choice for, such as "phase".
        name: What that setting says to choose it.
    """

    setting: ClassVar[str]
    name: ClassVar[str]

    # Any: `Settings` imports every choice, so that no choice can import `Settings`.
    @classmethod
    def of(cls, settings: Any) -> Self:
        """Return the choice as these settings describe it."""
        return cls(*[getattr(settings, name) for name in _own_settings(cls)])


@cache
def _own_settings(choice: type[NamedChoice]) -> tuple[str, ...]:
    """Return the settings that the fields of a choice are."""
    return tuple(f"{choice.setting}_{each.name}" for each in fields(choice))


C = TypeVar("C", bound=type[NamedChoice])


class Registry(dict[str, C]):
    """The choices for one setting by their names, in the order in which they were added."""

    def add(self, choice: C) -> C:
        """Add a choice; a decorator of its class."""
        self[choice.name] = choice
        return choice
