"""Differences between two writings, in words and in steps of what an eye begins to see."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.scoring.advice import advise
from dmp_teach.scoring.phrases import Position
from dmp_teach.scoring.wording import word_difference
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, all_points
from dmp_teach.values import Value

DIFFERENCE_STEPS = {
    # Parts of the letter's size: the line of a pen, in a letter as large as a hand.
    "shape": 0.0125,
    # A finger's breadth there; a smaller gap reads as touching.
    "place": 0.05,
    "piece": 0.05,
    "open": 0.05,
    # Waves as high as the line of a pen is wide, see `kinematics.shake`.
    "shaky": 0.0025,
    # A seventh: letters in one word differ by as much.
    "size": math.log(1.15),
    "width": math.log(1.15),
    # Degrees: less than one minute on the face of a clock, and one minute.
    "lean": 5.0,
    "turn": 6.0,
    # Lines are seen to be level less sharply, for they are short and round.
    "rise": 10.0,
    # In the logarithm: 4.5 times the jerk; the same hand, slower by half, loses as much.
    "smooth": 1.5,
    # People write one letter three times as fast as another day's, and it looks the same.
    "tempo": math.log(3.0),
}
"""How much of each is one step. Below one step two letters are taken for the same."""

MOVEMENT_FAULTS = ("smooth", "tempo")
"""Faults of the movement that leave no trace in the ink."""

FAULT_STEPS = {
    "mirrored": 14.0,
    "turned": 14.0,
    "missing": 12.0,
    "extra": 12.0,
    "reversed": 5.1,
    "round": 5.0,
    "order": 4.0,
    "pieces": 4.0,
}
"""How many steps are what is or is not: what another reader would stumble over counts most."""


@dataclass(frozen=True, eq=False, repr=False)
class Fault(Value):
    """One way in which a writing differs from its model.

    Args:
        name: What it is, such as "lean".
        steps: How many steps of what an eye begins to see; see `DIFFERENCE_STEPS`.
        wording: A sentence in plain words, in which the model is `{model}` and what it has
            `{models}`.
        reason: The same in a few words, to stand beside a row.
        advice: What to do next, in one sentence; the model as in the wording.
    """

    name: str
    steps: float
    wording: str
    reason: str
    advice: str

    @property
    def sentence(self) -> str:
        """The wording, of a model that is called so."""
        return self.wording.format(model=_("the model"), models=_("the model's"))


# Any: what the wording of the fault takes.
def make_fault(name: str, steps: float, **facts: Any) -> Fault:
    """Return a fault in words."""
    return Fault(name, steps, *word_difference(name, steps, facts), advise(name, facts))


def name_stroke(stroke: int, strokes: Sequence[Trajectory]) -> dict[str, int]:
    """Return which of how many strokes of the model it is, for a wording."""
    return {"stroke": stroke, "of": len(strokes)}


# Any: as above.
def name_start(stroke: int, strokes: Sequence[Trajectory]) -> dict[str, Any]:
    """Return the same, and where that stroke starts."""
    position = position_in(strokes[stroke].position[0], strokes)
    return name_stroke(stroke, strokes) | {"position": position}


def position_in(point: Array, strokes: Sequence[Trajectory]) -> Position:
    """Return where a point lies in the box of strokes; the middle of a side that is very short."""
    ink = all_points(strokes)
    low, size = ink.min(axis=0), np.ptp(ink, axis=0)
    x, y = np.divide(point - low, size, out=np.full(2, 0.5), where=size > 0.25 * size.max())
    return float(x), float(y)
