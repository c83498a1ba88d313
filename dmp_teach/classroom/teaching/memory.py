"""What a pupil has learned and forgotten: numbers alone, without a letter."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.values import Value

# A forgetting this large brings back a fault of the way of writing.
LEAST_RELAPSE = 0.3
# A smaller one is none.
LEAST_LAPSE = 0.02
# Of what would be forgotten, so much is after a right answer.
FIRM_SHARE = 2 / 3


@dataclass(frozen=True, eq=False, repr=False)
class PupilMemory(Value):
    """How far a pupil has come with one letter.

    Args:
        traits: Of the pupil.
        muddles: The faults of the way of writing that it still makes, the next to go first.
        cured: Those that it makes no more, the newest last.
        learned: What share of the shape it has learned.
        turn: How often it was shown the letter.
        lapses: How often it has forgotten something.
        is_firm: Whether its question was answered as it was shown: it then forgets a third less.
        lost: What share was gone when it forgot after this turn; 0 if it has not.
    """

    traits: PupilTraits
    muddles: tuple[str, ...] = ()
    cured: tuple[str, ...] = ()
    learned: float = 0.0
    turn: int = 0
    lapses: int = 0
    is_firm: bool = False
    lost: float = 0.0

    def learn(self, is_seen: bool) -> Self:
        """Return the memory after it was shown the letter.

        Args:
            is_seen: Whether the demonstration differs in the way of writing from what it wrote: a
                fault of the way goes only then, one a turn.
        """
        learned = self.learned + self.traits.pace * (1 - self.learned)
        gone = self.muddles[:1] if is_seen else ()
        return replace(
            self,
            muddles=self.muddles[len(gone) :],
            cured=(*self.cured, *gone),
            learned=learned,
            turn=self.turn + 1,
            is_firm=False,
            lost=0.0,
        )

    def answer(self, is_right: bool) -> Self:
        """Return the memory after an answer to its question."""
        return replace(self, is_firm=is_right)

    def forget(self) -> Self:
        """Return the memory before the next turn: the same, or less."""
        lost = self.traits.forgetting * 0.5**self.lapses * (FIRM_SHARE if self.is_firm else 1)
        is_due = self.turn > 0 and not self.lost and self.traits.forgets_after(self.turn)
        if not is_due or lost < LEAST_LAPSE:
            return self
        back = self.cured[-1:] if lost >= LEAST_RELAPSE else ()
        return replace(
            self,
            muddles=(*back, *self.muddles),
            cured=self.cured[: len(self.cured) - len(back)],
            learned=self.learned * (1 - lost),
            lapses=self.lapses + 1,
            lost=lost,
        )
