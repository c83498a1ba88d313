"""DMP* as a way to learn: one demonstration, however many are shown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar, Self

from numpy.typing import ArrayLike

from dmp_teach.dmp import DMP
from dmp_teach.studies.other_ways.way import Way, list_demonstrations
from dmp_teach.trajectory import Trajectory


@dataclass(frozen=True, eq=False, repr=False)
class StarWay(Way):
    """DMP* (Algorithm 2 of the paper): it learns the first demonstration, and no other.

    Averaging several before would help it as it helps the others; the paper does not.
    """

    primitive: DMP
    name: ClassVar[str] = "DMP*"

    @classmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Learn the first of the demonstrations."""
        return cls(DMP.imitate(list_demonstrations(demonstrations)[0]))

    def write(self, goal: ArrayLike | None = None) -> Trajectory:
        """Let the spring follow the goal, and the weights push."""
        return self.primitive.rollout(goal=goal)

    @property
    def duration(self) -> float:
        """The first demonstration's [s]."""
        return self.primitive.duration

    @property
    def numbers_stored(self) -> int:
        """Weights, start, goal, start velocity and duration."""
        learned = self.primitive
        return learned.weights.size + 3 * len(learned.goal) + 1
