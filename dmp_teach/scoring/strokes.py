"""Judge one stroke, given what was written before: which it is, and how it was written.

It is the judge at the pen's lift, when only part of a letter is there, and of every stroke of a
whole letter, when its row "way of writing" is made.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked
from dmp_teach.errors import LetterError, shown
from dmp_teach.ink import check_hand, is_level
from dmp_teach.scoring.arguments import LetterLike, to_strokes
from dmp_teach.scoring.direction import find_other_way
from dmp_teach.scoring.faults import (
    DIFFERENCE_STEPS,
    FAULT_STEPS,
    Fault,
    make_fault,
    name_start,
    name_stroke,
    position_in,
)
from dmp_teach.scoring.fit import fit_model
from dmp_teach.scoring.matching import Matching, Pair
from dmp_teach.scoring.resampling import POINTS_TO_FIT, resample, size_of
from dmp_teach.scoring.so_far import match_so_far
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

REASONS = {
    "reversed": "start",
    "begins": "start",
    "round": "direction",
    "order": "order",
    "place": "place",
    "size": "size",
    "joined": "lift",
    "split": "lift",
    "divided": "lift",
    "unlike": "unlike",
}
"""What each fault of a stroke is a matter of."""

MATTERS = ("start", "direction", "order", "place", "size")
"""What a teacher may be strict about."""
# Where none of these counts a letter may be written in any way: how many strokes it takes, too.
WAY_MATTERS = {"start", "direction", "order"}
# On a sheet of unknown size.
USUAL_MATTERS = MATTERS[:4]

# Another beginning of a loop counts from an eighth of it on.
LEAST_LOOP_SHIFT = 0.125
# At the lift a stroke is in a wrong place, or of another size, from so many steps on: the
# rest of the letter, which would show how large and where it is meant, is not yet written.
LEAST_STEPS = {"place": 2.8, "size": 4.0}
# A stroke that is farther from the model's is another [parts of the letter's size].
FARTHEST_SHAPE = 0.09
# Letters are wider or higher by so much though nothing of them is misplaced.
PART_OF_ANOTHER_WIDTH = 0.15


@dataclass(frozen=True, eq=False, repr=False)
class StrokeVerdict(Value):
    """What is to be said of a stroke when the pen is lifted.

    Args:
        stroke: Which stroke of the model it is, from 0; None where it is none of them.
        due: Which stroke of the model was to be written, from 0.
        fault: The largest fault; None of a good one.
    """

    stroke: int | None
    due: int
    fault: Fault | None

    @property
    def good(self) -> bool:
        """Whether nothing is to be said against it."""
        return self.fault is None

    @property
    def reason(self) -> str:
        """One of `MATTERS`, "lift" (joined, or in pieces), "unlike" (no stroke of it) or ""."""
        return "" if self.fault is None else REASONS[self.fault.name]

    @property
    def sentence(self) -> str:
        """What is to be said, in plain words."""
        return _("Well written.") if self.fault is None else self.fault.sentence

    def __str__(self) -> str:
        """Return one line."""
        if self.fault is None:
            return self.sentence
        return f"{self.sentence} {self.fault.advice}".format(model=_("the model"))


def check_strict(strict: object) -> None:
    """Raise a LetterError unless these are some of `MATTERS`."""
    given = strict if isinstance(strict, Collection) and not isinstance(strict, str) else (None,)
    if not all(isinstance(each, str) and each in MATTERS for each in given):
        raise LetterError(f"strict is {shown(strict)}, but must be some of {MATTERS}.")


def list_reasons(strict: Collection[str]) -> set[str]:
    """Return the reasons that count: what is strict, and of a way of writing also its strokes."""
    return {*strict, *({"lift", "unlike"} if WAY_MATTERS & set(strict) else ())}


@checked
def judge_stroke(
    written: LetterLike,
    model: LetterLike,
    hand: str = "right",
    strict: Collection[str] = USUAL_MATTERS,
) -> StrokeVerdict:
    """Judge the last of the strokes written so far, on the sheet on which the model stands.

    Args:
        written: A `Recording`, or strokes: those before, and last the one to be judged.
        model: What the letter should look like when it is complete.
        hand: As in `score`.
        strict: What is judged, of "start", "direction", "order", "place" and "size".

    Raises:
        LetterError: As `score`, or another word in `strict`.
    """
    check_hand(hand)
    check_strict(strict)
    mine, yours = to_strokes(written, "written"), to_strokes(model, "model")
    matching = match_so_far(mine, yours)
    number = len(mine) - 1
    stray = sum(k < number for k in matching.extra)
    awaited = set(range(len(yours))) - set(matching.missing[:stray])
    before = {k for pair in matching.pairs for k in pair.others if min(pair.strokes) < number}
    due = min(awaited - before, default=len(yours) - 1)
    at = next((k for k, pair in enumerate(matching.pairs) if number in pair.strokes), None)
    fit = fit_model(
        matching, resample(mine, POINTS_TO_FIT), resample(yours, POINTS_TO_FIT), size_of(yours)
    )
    reasons = list_reasons(strict)
    if at is None or (fit.shape > FARTHEST_SHAPE and fit.worst[1] == at):
        unlike = make_fault("unlike", 1.0, **name_start(due, yours))
        return StrokeVerdict(None, due, unlike if "unlike" in reasons else None)
    place, explained = _place_beside(fit.places, at, matching, yours)
    steps = abs(float(np.log(fit.size))) / DIFFERENCE_STEPS["size"]
    found = [
        *find_pair_faults(matching, matching.pairs[at], yours, awaited, hand=hand),
        make_place_fault(matching.pairs[at], place, fit.size, yours, explained),
        make_fault("size", steps, ratio=fit.size),
    ]
    seen = [
        fault
        for fault in found
        if REASONS[fault.name] in reasons and fault.steps >= LEAST_STEPS.get(fault.name, 1.0)
    ]
    worst = max(seen, key=lambda fault: fault.steps, default=None)
    return StrokeVerdict(matching.pairs[at].others[0], due, worst)


def _place_beside(
    places: Array, at: int, matching: Matching, strokes: Sequence[Trajectory]
) -> tuple[Array, Array]:
    """Return how far a pair is from its place beside the others [parts of the size].

    And how much of that another width or height of the letter would explain; both of shape (2,).
    """
    others = np.delete(places, at, axis=0)
    if not len(others):
        return np.zeros(2), np.zeros(2)
    middles = np.array([pair.alignment.others.mean(axis=0) for pair in matching.pairs])
    beside = middles[at] - np.delete(middles, at, axis=0).mean(axis=0)
    explained = PART_OF_ANOTHER_WIDTH * np.abs(beside) / size_of(strokes)
    return places[at] - others.mean(axis=0), explained


def make_place_fault(
    pair: Pair,
    place: Array,
    size: float,
    strokes: Sequence[Trajectory],
    explained: ArrayLike = 0.0,
) -> Fault:
    """Return how far a stroke is from its place, as a fault.

    Args:
        pair: The stroke.
        place: How far it is off to the right and up, shape (2,) [parts of the letter's size].
        size: How many times as large as the model the letter is.
        strokes: The model's.
        explained: How much of that is no fault, shape (2,) [parts of the letter's size].
    """
    steps = float(np.hypot(*np.maximum(np.abs(place) - explained, 0.0)) / DIFFERENCE_STEPS["place"])
    right, up = (float(part) * size * size_of(strokes) for part in place)
    return make_fault("place", steps, **name_stroke(pair.others[0], strokes), right=right, up=up)


def find_pair_faults(
    matching: Matching,
    pair: Pair,
    strokes: Sequence[Trajectory],
    awaited: Collection[int],
    *,
    hand: str,
) -> Iterator[Fault]:
    """Yield the faults of one stroke, or of the strokes that do the work of one.

    Args:
        matching: Which strokes belong together.
        pair: The one that is judged.
        strokes: The model's.
        awaited: Which of the model's strokes are, or will be, written.
        hand: "left" draws level lines from either end.
    """
    stroke, line = pair.others[0], pair.alignment
    if len(pair.strokes) > 1 or len(pair.others) > 1:
        name = {-1: "joined", 0: "divided", 1: "split"}[
            int(np.sign(len(pair.strokes) - len(pair.others)))
        ]
        counts = {"written": matching.written, "model": len(strokes)}
        yield make_fault(name, FAULT_STEPS["pieces"], **counts)
    elif line.backwards and not (hand == "left" and is_level(strokes[stroke])):
        way = {"is_round": line.goes_round, "left": _turns_left(line.others)}
        yield make_fault("reversed", FAULT_STEPS["reversed"], **name_start(stroke, strokes), **way)
    elif not line.backwards:
        away = min(line.begins, 1 - line.begins)
        if away > LEAST_LOOP_SHIFT:
            steps = 2 * FAULT_STEPS["reversed"] * away
            yield make_fault("begins", steps, **name_start(stroke, strokes))
        other = None if pair.is_dot else find_other_way(line)
        if other is not None:
            yield make_fault(
                "round",
                FAULT_STEPS["round"],
                **name_stroke(stroke, strokes),
                is_round=other.is_round,
                left=other.turning > 0,
                position=position_in(other.point, strokes),
            )
    due = min(set(awaited) - matching.written_before(pair))
    if due < stroke:
        yield make_fault("order", FAULT_STEPS["order"], early=stroke, late=due)


def _turns_left(line: Array) -> bool:
    """Return whether a line (P, 2) goes round against the clock."""
    x, y = (line - line.mean(axis=0)).T
    return bool((x[:-1] * y[1:] - y[:-1] * x[1:]).sum() > 0)
