"""Who wrote this? Answers to such questions: how many are right, how sure that is, and what a guess would give."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import SettingError
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array

SHUFFLES = 999
Z = 1.959964  # 95 % of a normal distribution lie within so many deviations


@dataclass(frozen=True)
class Answers:
    """One question, asked of many letters.

    Args:
        question: What was asked, in words.
        items: Who wrote each letter, and who was named; None where nothing could be drawn, which counts as wrong.
        chance: The rate of somebody who guesses, 0 to 1.
        luck: How often names that were shuffled are hit as often or more often, 0 to 1; 1 where nothing was asked.
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
        """The part that was named rightly, every writer counting alike; NaN where nothing was asked."""
        own = self._own()
        return float(np.mean(own)) if own else float("nan")

    @property
    def interval(self) -> tuple[float, float]:
        """In which the rate lies for other writers, 95 % (Wilson 1927); NaN where nothing was asked.

        Letters by one writer are right or wrong together, so each writer counts as one answer, however many letters
        there are by him. For three writers it is wide even if all answers are right: three are few.
        """
        n, p = len(self._own()), self.rate
        if not n:
            return float("nan"), float("nan")
        middle, half = p + Z**2 / (2 * n), Z * np.sqrt(p * (1 - p) / n + Z**2 / (4 * n**2))
        return max(0.0, float((middle - half) / (1 + Z**2 / n))), min(
            1.0, float((middle + half) / (1 + Z**2 / n))
        )

    @property
    def confusion(self) -> Array:
        """Who wrote (rows) and who was named (columns), in parts of each writer's letters, shape (W, W)."""
        row = {writer: number for number, writer in enumerate(self.writers)}
        counts = np.zeros((len(row), len(row)))
        for writer, named in self.items:
            if named is not None:
                counts[row[writer], row[named]] += 1
        asked = np.array([sum(writer == each for each, _ in self.items) for writer in row])
        return counts / np.maximum(asked, 1)[:, None]

    def _own(self) -> list[float]:
        """Each writer's rate."""
        hits: dict[str, list[bool]] = {}
        for writer, named in self.items:
            hits.setdefault(writer, []).append(writer == named)
        return [float(np.mean(each)) for each in hits.values()]


@dataclass(frozen=True)
class Attributions(Tabled):
    """Several questions; `found["DMP*, varied"]` is one.

    Args:
        items: The questions with their answers.
        borrowed: Whether nothing could be asked of what was given, so that our own alphabets were taken.
    """

    items: tuple[Answers, ...]
    borrowed: bool = False

    def __iter__(self) -> Iterator[Answers]:
        return iter(self.items)

    def __getitem__(self, question: str) -> Answers:
        """One question.

        Raises:
            SettingError: It was not asked; names those that were.
        """
        for each in self.items:
            if each.question == question:
                return each
        raise SettingError(
            f"{question!r} was not asked; asked was: {', '.join(each.question for each in self.items)}."
        )

    def rows(self) -> Rows:
        """One for each question."""
        return tuple(
            {
                "question": each.question,
                "right": each.right[0],
                "of": each.right[1],
                "rate [%]": 100 * each.rate,
                "from [%]": 100 * each.interval[0],
                "to [%]": 100 * each.interval[1],
                "a guess [%]": 100 * each.chance,
                "by luck": each.luck,
            }
            for each in self.items
        )


def luck_of(hits: Callable[[np.ndarray], int], strata: Sequence[int], seed: int = 0) -> float:
    """How often shuffled names are hit as often as the true ones, or more often (a permutation test).

    Args:
        hits: How many answers are right if letter k bears the name of letter order[k], where order has shape (L,).
        strata: Names are shuffled among letters with the same number here, shape (L,).
        seed: Of the shuffles.
    """
    groups = np.asarray(strata, dtype=int)
    if not len(groups):
        return 1.0
    rng = np.random.default_rng(seed)
    places = [np.flatnonzero(groups == group) for group in np.unique(groups)]
    found, reached = hits(np.arange(len(groups))), 1
    for _ in range(SHUFFLES):
        order = np.empty(len(groups), dtype=int)
        for place in places:
            order[place] = rng.permutation(place)
        reached += hits(order) >= found
    return reached / (SHUFFLES + 1)


def luck_of_takes(asked: Sequence[tuple[int, str, str | None]]) -> float:
    """How often it is as good with the takes' names shuffled; all that was made of one take keeps together."""
    whose = {take: writer for take, writer, _ in asked}
    names = sorted(set(whose.values()))
    row = {take: number for number, take in enumerate(whose)}
    counts = np.zeros((len(whose), len(names)), dtype=int)
    for take, _, name in asked:
        if name is not None:
            counts[row[take], names.index(name)] += 1
    code = np.array([names.index(writer) for writer in whose.values()])
    return luck_of(
        lambda order: int(counts[np.arange(len(code)), code[order]].sum()), np.zeros(len(code))
    )
