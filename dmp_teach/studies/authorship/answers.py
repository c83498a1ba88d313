"""Attributions of letters to writers: how many are right, how sure that is, and by chance."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.errors import SettingError
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array
from dmp_teach.values import Value

PERMUTATIONS = 999
# 95 % of a normal distribution lie within so many standard deviations.
NORMAL_95 = 1.959964


@dataclass(frozen=True, eq=False, repr=False)
class Answers(Value):
    """One question, asked of many letters.

    Args:
        question: In words.
        items: Who wrote each letter, and who was named; None where nothing could be drawn, which
            counts as wrong.
        chance: The rate of random guesses, 0 to 1.
        luck: How often permuted names are hit as often or more often, 0 to 1; 1 where nothing was
            asked.
    """

    question: str
    items: tuple[tuple[str, str | None], ...]
    chance: float
    luck: float

    @property
    def right(self) -> tuple[int, int]:
        """How many were named rightly, and of how many."""
        return sum(writer == named for writer, named in self.items), len(self.items)

    @property
    def writers(self) -> tuple[str, ...]:
        """Everybody who wrote or was named."""
        return tuple(sorted({name for item in self.items for name in item if name is not None}))

    @property
    def rate(self) -> float:
        """The rate of right names, every writer counting alike; NaN where nothing was asked."""
        rates = self._rates()
        return float(np.mean(rates)) if rates else float("nan")

    @property
    def interval(self) -> tuple[float, float]:
        """In which the rate lies for other writers, 95 % (Wilson 1927); NaN for nothing asked.

        Letters by one writer are right or wrong together, so each writer counts as one answer. For
        three writers it is wide even if all answers are right: three are few.
        """
        n, p, z = len(self._rates()), self.rate, NORMAL_95
        if not n:
            return float("nan"), float("nan")
        middle, half = p + z**2 / (2 * n), z * np.sqrt(p * (1 - p) / n + z**2 / (4 * n**2))
        low, high = (middle - half) / (1 + z**2 / n), (middle + half) / (1 + z**2 / n)
        return max(0.0, float(low)), min(1.0, float(high))

    @property
    def confusion(self) -> Array:
        """Who wrote (rows) and who was named (columns), as shares of each row, shape (W, W)."""
        row = {writer: number for number, writer in enumerate(self.writers)}
        counts = np.zeros((len(row), len(row)))
        for writer, named in self.items:
            if named is not None:
                counts[row[writer], row[named]] += 1
        written = np.array([sum(writer == each for each, _ in self.items) for writer in row])
        return counts / np.maximum(written, 1)[:, None]

    def __repr__(self) -> str:
        return "Answers({!r}, {} of {} right)".format(self.question, *self.right)

    def _rates(self) -> list[float]:
        """Return each writer's rate."""
        hits: dict[str, list[bool]] = {}
        for writer, named in self.items:
            hits.setdefault(writer, []).append(writer == named)
        return [float(np.mean(each)) for each in hits.values()]


@dataclass(frozen=True, repr=False)
class Attributions(Tabled):
    """Several questions; `found["DMP*, varied"]` is one.

    Args:
        items: The questions with their answers.
        borrowed: Whether nothing could be asked of what was given, so that our own alphabets were
            taken.
    """

    items: tuple[Answers, ...]
    borrowed: bool = False

    def __iter__(self) -> Iterator[Answers]:
        return iter(self.items)

    def __getitem__(self, question: str) -> Answers:
        """Return one question, or raise a SettingError that names those that were asked."""
        for each in self.items:
            if each.question == question:
                return each
        names = ", ".join(each.question for each in self.items)
        raise SettingError(f"{question!r} was not asked; asked was: {names}.")

    @property
    def columns(self) -> Columns:
        """A row for each question."""
        return {
            "question": [each.question for each in self.items],
            "right": [each.right[0] for each in self.items],
            "of": [each.right[1] for each in self.items],
            "rate [%]": [100 * each.rate for each in self.items],
            "from [%]": [100 * each.interval[0] for each in self.items],
            "to [%]": [100 * each.interval[1] for each in self.items],
            "a guess [%]": [100 * each.chance for each in self.items],
            "by luck": [each.luck for each in self.items],
        }


def permutation_luck(
    hits: Callable[[NDArray[np.int_]], int], strata: Sequence[int], seed: int = 0
) -> float:
    """Return how often permuted names are hit as often as the true ones, or more often.

    `hits(order)` is how many answers are right if letter k bears the name of letter order[k]; names
    are permuted among letters of the same stratum, shape (L,).
    """
    groups = np.asarray(strata, dtype=int)
    if not len(groups):
        return 1.0
    rng = np.random.default_rng(seed)
    places = [np.flatnonzero(groups == group) for group in np.unique(groups)]
    found, reached = hits(np.arange(len(groups))), 1
    for _ in range(PERMUTATIONS):
        order = np.empty(len(groups), dtype=int)
        for place in places:
            order[place] = rng.permutation(place)
        reached += hits(order) >= found
    return reached / (PERMUTATIONS + 1)


def takes_luck(answers: Sequence[tuple[int, str, str | None]]) -> float:
    """Return the same with the takes' names permuted; all that is made of one take stays together.

    An answer is the number of a take, who wrote it, and who was named.
    """
    whose = {take: writer for take, writer, _ in answers}
    names = sorted(set(whose.values()))
    row = {take: number for number, take in enumerate(whose)}
    counts = np.zeros((len(whose), len(names)), dtype=int)
    for take, _, name in answers:
        if name is not None:
            counts[row[take], names.index(name)] += 1
    code = np.array([names.index(writer) for writer in whose.values()], dtype=int)
    each = np.arange(len(code))
    return permutation_luck(lambda order: int(counts[each, code[order]].sum()), [0] * len(code))
