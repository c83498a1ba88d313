"""The readings of the paper that a claim is judged by."""

from __future__ import annotations

from dataclasses import dataclass

from dmp_teach.dmp import Settings
from dmp_teach.values import Value


@dataclass(frozen=True, eq=False, repr=False)
class Reading(Value):
    """One way to read the paper.

    Args:
        name: Short, such as "mended".
        star: DMP* by this reading.
        original: The original form, which DMP* is compared with.
    """

    name: str
    star: Settings
    original: Settings

    def __repr__(self) -> str:
        return f"Reading({self.name!r})"


READINGS = (
    Reading("ours", Settings.star(), Settings.original()),
    Reading(
        "mended",
        Settings.as_fixed(),
        Settings.as_fixed(transform="original", start_velocity="kept"),
    ),
    Reading(
        "the program",
        Settings.as_coded(),
        Settings.as_coded(transform="original", kernel_width=1.0, kernel_spread=0.02),
    ),
    Reading(
        "as printed",
        Settings.as_printed(),
        Settings.as_printed(transform="original", start_velocity="kept"),
    ),
)
"""Ours, the text with its contradictions mended, the authors' program, and the text to the letter.

Ours is compared with the form of Ijspeert 2002; a reading of the paper with its own kernels, spring
and phase in the original form, which keeps the demonstrated start velocity whatever the goal is.
"""
