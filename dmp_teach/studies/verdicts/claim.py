"""One claim of the paper and its verdict: computed, never written down."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from textwrap import fill
from typing import ClassVar

from dmp_teach.errors import SettingError
from dmp_teach.studies.inputs import RecordingsLike
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of

HOLDS, FAILS, DEPENDS = "HOLDS", "DOES NOT HOLD", "DEPENDS ON"


@dataclass(frozen=True)
class Claim:
    """One row.

    Args:
        name: Short, such as "narrow kernels".
        claim: What the paper says.
        verdict: "HOLDS", "DOES NOT HOLD" or "DEPENDS ON".
        figure: The numbers, as a sentence.
        depends_on: On what, or over what it holds or fails.
        call: The line that computes `figure` again, where `teach` is `dmp_teach` and `recordings`
            is what was given.
    """

    name: str
    claim: str
    verdict: str
    figure: str
    depends_on: str
    call: str

    def __str__(self) -> str:
        words = f"{self.verdict}: {self.claim}", self.figure, self.depends_on
        lines = [fill(each, 88, subsequent_indent="  ") for each in words]
        return "\n  ".join([*lines, self.call])


@dataclass(frozen=True, repr=False)
class Claims(Tabled):
    """All rows; `claims["narrow kernels"]` or `claims[0]` is one."""

    items: tuple[Claim, ...]

    COLUMN_WIDTHS: ClassVar[Mapping[str, int]] = {"claim": 34, "on what": 44, "figure": 58}
    STYLES: ClassVar[Mapping[str, str]] = {
        HOLDS: "font-weight:bold;color:#00664A",
        FAILS: "font-weight:bold;color:#A34700",
        DEPENDS: "font-weight:bold;color:#005A8F",
    }

    @property
    def columns(self) -> Columns:
        """A row for each claim."""
        return {
            "claim": [f"{each.name}: {each.claim}" for each in self.items],
            "verdict": [each.verdict for each in self.items],
            "on what": [each.depends_on for each in self.items],
            "figure": [each.figure for each in self.items],
        }

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.items)

    def __len__(self) -> int:
        return len(self.items)

    def __getitem__(self, key: int | str) -> Claim:
        """Return a row by its place or its name; a SettingError names those that there are."""
        if not isinstance(key, str):
            return self.items[key]
        for each in self.items:
            if each.name == key:
                return each
        raise SettingError(
            f"There is no claim {key!r}; there are: {', '.join(each.name for each in self.items)}."
        )

    def __repr__(self) -> str:
        return self.table()


Judgement = tuple[str | Mapping[str, bool], str, str]
"""A verdict, or the cases in which the claim holds; the figure; and on what it depends, besides."""


def claim(
    name: str, words: str
) -> Callable[[Callable[[Evidence], Judgement]], Callable[..., Claim]]:
    """Make a claim (name, what the paper says) of a function of verdict, figure and why."""

    def decorate(judge: Callable[[Evidence], Judgement]) -> Callable[..., Claim]:
        def judged(recordings: RecordingsLike | Evidence = None) -> Claim:
            evidence = evidence_of(recordings)
            verdict, figure, why = judge(evidence)
            if not isinstance(verdict, str):
                verdict, holds = verdict_over(verdict)
                why = holds + why
            call = f"teach.studies.{judge.__name__}({evidence.argument}).figure"
            return Claim(name, words, verdict, figure, why, call)

        judged.__name__, judged.__qualname__ = judge.__name__, judge.__qualname__
        judged.__doc__, judged.__module__ = judge.__doc__, judge.__module__
        return judged

    return decorate


def verdict_over(cases: Mapping[str, bool]) -> tuple[str, str]:
    """Return HOLDS, DOES NOT HOLD or DEPENDS ON over several cases, and on what it depends."""
    held = [name for name, holds in cases.items() if holds]
    failed = [name for name, holds in cases.items() if not holds]
    if not failed:
        return HOLDS, f"holds for: {'; '.join(held)}"
    if not held:
        return FAILS, f"fails for: {'; '.join(failed)}"
    return DEPENDS, f"holds for: {'; '.join(held)}. Not for: {'; '.join(failed)}"


def mm(metres: float) -> str:
    """Return a length for a sentence."""
    value = 1e3 * metres
    if value >= 995:
        return f"{metres:.0f} m" if metres >= 9.95 else f"{metres:.2g} m"
    return f"{value:.0f} mm" if value >= 9.95 else f"{value:.2g} mm"


def per_cent(part: float) -> str:
    """Return a part for a sentence."""
    value = 100 * part
    return f"{value:.0f} %" if value >= 9.5 or value == 0 else f"{value:.2g} %"


def as_times(factor: float) -> str:
    """Return a factor for a sentence."""
    return f"{factor:.0f} times" if factor >= 9.95 else f"{factor:.2g} times"
