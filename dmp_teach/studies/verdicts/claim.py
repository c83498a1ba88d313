"""One claim of the paper and its verdict: computed, never written down."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from textwrap import fill
from typing import ClassVar

from dmp_teach.errors import SettingError
from dmp_teach.studies.inputs import RecordingsLike
from dmp_teach.studies.readings import Reading
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of
from dmp_teach.values import Value

HOLDS, FAILS, DEPENDS = "HOLDS", "DOES NOT HOLD", "DEPENDS ON"
# Fewer of them are no proof: five coins fall the same way once in 32.
NO_PROOF_BELOW = 5


@dataclass(frozen=True, eq=False, repr=False)
class Claim(Value):
    """One row.

    Args:
        name: Short, such as "narrow kernels".
        claim: What the paper says.
        verdict: "HOLDS", "DOES NOT HOLD" or "DEPENDS ON".
        figure: The numbers, as a sentence.
        depends_on: On what, or over what it holds or fails.
        call: The line that computes `figure` again, where `teach` is `dmp_teach` and `recordings`
            and `labels` are what was given.
        n: Of how many, such as "19 strokes of 14 letters".
        warning: What is wrong with them: too few, or letters that were not recorded; or "".
        by_reading: The verdict by each reading of the paper; empty where the claim is not about
            DMP*.
    """

    name: str
    claim: str
    verdict: str
    figure: str
    depends_on: str
    call: str
    n: str = ""
    warning: str = ""
    by_reading: Mapping[str, str] = field(default_factory=dict)

    def __str__(self) -> str:
        words = f"{self.verdict} (n = {self.n}): {self.claim}", self.figure, self.depends_on
        warning = (f"Warning: {self.warning}.",) if self.warning else ()
        lines = [fill(each, 88, subsequent_indent="  ") for each in words + warning]
        return "\n  ".join([*lines, self.call])


@dataclass(frozen=True, repr=False)
class Claims(Tabled):
    """All rows; `claims["narrow kernels"]` or `claims[0]` is one."""

    items: tuple[Claim, ...]

    COLUMN_WIDTHS: ClassVar[Mapping[str, int]] = {
        **{"claim": 32, "n": 11, "on what": 40, "figure": 58}
    }
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
            "n": [each.n for each in self.items],
            "on what": [
                each.depends_on + f". WARNING: {each.warning}." * bool(each.warning)
                for each in self.items
            ],
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


@dataclass(frozen=True)
class Found:
    """What a claim is judged by, as a whole or by one reading.

    Args:
        holds: Whether it holds; or a verdict; or whether it holds in several cases, by their names.
        figure: The numbers, as words.
        n: Of how many.
        of: Of what, such as "strokes of 5 letters".
        why: On what it depends, besides.
        warning: What was missing, and what was taken instead.
    """

    holds: bool | str | Mapping[str, bool]
    figure: str
    n: int
    of: str
    why: str = ""
    warning: str = ""

    @property
    def verdict(self) -> tuple[str, str]:
        """The verdict, and on what it depends."""
        if isinstance(self.holds, Mapping):
            verdict, why = verdict_over(self.holds)
            return verdict, why + self.why
        if isinstance(self.holds, bool):
            return HOLDS if self.holds else FAILS, self.why
        return self.holds, self.why


def claim(name: str, words: str) -> Callable[[Callable[[Evidence], Found]], Callable[..., Claim]]:
    """Make a claim (name, what the paper says) of a function of the evidence."""

    def decorate(judge: Callable[[Evidence], Found]) -> Callable[..., Claim]:
        def row(evidence: Evidence, call: str) -> Claim:
            found = judge(evidence)
            verdict, why = found.verdict
            n, warning = _sample(found)
            return Claim(name, words, verdict, f"{found.figure}.", why, call, n, warning)

        return _judged(judge, row)

    return decorate


def claim_by_reading(
    name: str, words: str, figure: str
) -> Callable[[Callable[[Evidence, Reading], Found]], Callable[..., Claim]]:
    """Make a claim about DMP* of a function of the evidence and one reading of the paper.

    `figure` says what the numbers of all readings are.
    """

    def decorate(judge: Callable[[Evidence, Reading], Found]) -> Callable[..., Claim]:
        def row(evidence: Evidence, call: str) -> Claim:
            found = {each.name: judge(evidence, each) for each in evidence.readings}
            verdicts = {reading: each.verdict for reading, each in found.items()}
            by_reading = {reading: verdict for reading, (verdict, _) in verdicts.items()}
            alike = set(by_reading.values())
            words_of = [
                f"{reading}: {verdict.lower()}" + f" ({on})" * (verdict == DEPENDS)
                for reading, (verdict, on) in verdicts.items()
            ]
            n, warning = _sample(next(iter(found.values())))
            numbers = "; ".join(f"{reading} {each.figure}" for reading, each in found.items())
            verdict, on_what = alike.pop() if len(alike) == 1 else DEPENDS, "; ".join(words_of)
            numbers = f"{figure}: {numbers}."
            return Claim(name, words, verdict, numbers, on_what, call, n, warning, by_reading)

        return _judged(judge, row)

    return decorate


def _judged(
    judge: Callable[..., Found], row: Callable[[Evidence, str], Claim]
) -> Callable[..., Claim]:
    """Return the claim as a function of recordings, with the name and words of its judge."""

    def judged(recordings: RecordingsLike | Evidence = None, *, labels: str | None = None) -> Claim:
        evidence = evidence_of(recordings, labels=labels)
        return row(evidence, f"teach.studies.{judge.__name__}({evidence.argument}).figure")

    judged.__name__, judged.__qualname__ = judge.__name__, judge.__qualname__
    judged.__doc__, judged.__module__ = judge.__doc__, judge.__module__
    return judged


def _sample(found: Found) -> tuple[str, str]:
    """Return of how many, and what is wrong with them."""
    kind, *rest = found.of.split(" of ")
    n = " of ".join([f"{found.n} {kind if found.n != 1 else kind.removesuffix('s')}", *rest])
    few = f"{n} {'are' if found.n != 1 else 'is'} no proof" if found.n < NO_PROOF_BELOW else ""
    return n, "; ".join(filter(None, (found.warning, few)))


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
