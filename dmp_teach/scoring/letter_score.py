"""Score how near a writing is to its model: in measures, in four rows for the pad, in a sentence.

The score is ours. It says what differs and is no medical or school test; it has not been shown to
make handwriting better.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.ink import check_hand
from dmp_teach.scoring.arguments import LetterLike, to_strokes
from dmp_teach.scoring.differences import find_faults
from dmp_teach.scoring.faults import MOVEMENT_FAULTS, Fault
from dmp_teach.scoring.fit import fit_model
from dmp_teach.scoring.kinematics import Movement, measure_movement
from dmp_teach.scoring.matching import Matching, match_strokes
from dmp_teach.scoring.overlay import lay_on, rms_apart
from dmp_teach.scoring.resampling import POINTS_TO_FIT, Resampled, resample, size_of
from dmp_teach.scoring.strokes import MATTERS, REASONS, check_strict, list_reasons
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array
from dmp_teach.values import Value

LEVEL_WORDS = (marked("far"), marked("not far"), marked("close"), marked("the same"))
# Steps of a fault up to which a row is "not far", "close" and "the same".
LEVEL_STEPS = (6.0, 3.0, 1.0)
# Steps of a fault that leaves no trace in the ink from which on it is named.
LEAST_MOVEMENT_STEPS = 2.0
_FAULTS = {
    marked("Shape"): "mirrored turned missing extra shape place piece open shaky",
    marked("Size"): "size width",
    marked("Lean"): "lean turn rise",
    marked("Way of writing"): "reversed round begins order joined split divided",
}
FAULTS_BY_ROW = {row: faults.split() for row, faults in _FAULTS.items()}


@dataclass(frozen=True, eq=False, repr=False)
class Part(Value):
    """One row of the pad.

    Args:
        name: "Shape", "Size", "Lean" or "Way of writing": from where, which way, in which order.
        level: 0 to 3; the pad fills one circle more than that.
        word: "far", "not far", "close" or "the same".
        reason: Why, in a few words; empty where it is the same.
    """

    name: str
    level: int
    word: str
    reason: str


@dataclass(frozen=True, eq=False, repr=False)
class Score(Value):
    """How near a writing is to its model.

    Args:
        sentence: The largest fault in plain words; of the movement only where the ink shows none.
        parts: Shape, size, lean and way of writing, for the pad.
        faults: Everything that differs, the largest first, in steps of what an eye begins to see.
        matching: Which strokes belong together; its order, direction and number.
        distance: How far the two inks are apart on average (rms), moved to the same place [m].
        shift: What moves the writing to the place of the model, shape (2,) [m].
        shape: How far the ink is from the nearest (rms) when size, width, lean and places fit
            [parts of the letter's size].
        place: How far the stroke that is farthest from its place is from it [the same].
        size: How many times as large as the model.
        width: How many times as wide, for its height.
        lean: How far it leans more to the right than the model [degrees].
        turn: How far it is turned to the left [degrees].
        rise: How far its lines rise more to the right [degrees].
        written: The movement of the writing: strokes, duration, pace, smoothness, peaks, slant.
        model: The movement of the model.
    """

    sentence: str
    parts: tuple[Part, ...]
    faults: tuple[Fault, ...]
    matching: Matching
    distance: float
    shift: Array
    shape: float
    place: float
    size: float
    width: float
    lean: float
    turn: float
    rise: float
    written: Movement
    model: Movement

    def __repr__(self) -> str:
        """Return one line: the sentence, the rows and the distance."""
        rows = ", ".join(f"{part.name.lower()} {part.word}" for part in self.parts)
        return f"Score({self.sentence!r}, {rows}, {1000 * self.distance:.1f} mm apart)"


@checked
def score(
    written: LetterLike,
    model: LetterLike,
    hand: str = "right",
    strict: Collection[str] = MATTERS,
) -> Score:
    """Compare a writing with its model.

    Strokes are matched by shape first: their order, direction and number are faults of their own
    and change no other measure.

    Args:
        written: A `Recording`, a `Letter` (what it writes) or strokes.
        model: The same: what it should look like.
        hand: "left" of somebody who pulls level lines, as the bar of a t, from right to left.
        strict: What counts as a fault, of "start", "direction", "order", "place" and "size".

    Raises:
        LetterError: One of them is nothing, something else, or all in one place; or no such hand,
            or another word in `strict`.
    """
    check_hand(hand)
    check_strict(strict)
    mine, yours = to_strokes(written, "written"), to_strokes(model, "model")
    matching = match_strokes(mine, yours)
    ink, model_ink = resample(mine, POINTS_TO_FIT), resample(yours, POINTS_TO_FIT)
    fit = fit_model(matching, ink, model_ink, size_of(yours))
    movement, model_movement = measure_movement(mine), measure_movement(yours)
    found = find_faults(matching, fit, movement, model_movement, yours, hand=hand)
    reasons = {None, *list_reasons(strict)}
    faults = tuple(fault for fault in found if REASONS.get(fault.name) in reasons)
    leading = leading_fault(faults)
    distance, shift = _lay_together(matching, ink, model_ink)
    return Score(
        sentence=_("It looks the same as the model.") if leading is None else leading.sentence,
        parts=tuple(_part(name, faults) for name in FAULTS_BY_ROW),
        faults=faults,
        matching=matching,
        distance=distance,
        shift=shift,
        shape=fit.shape,
        place=float(np.linalg.norm(fit.places, axis=1).max()),
        size=fit.size,
        width=fit.width,
        lean=fit.lean,
        turn=(90.0 * matching.turn + fit.turn + 180) % 360 - 180,
        rise=fit.rise,
        written=movement,
        model=model_movement,
    )


def leading_fault(faults: Sequence[Fault]) -> Fault | None:
    """Return the largest fault seen in the ink, or else one of the movement; None without any."""
    for is_seen, least in ((True, 1.0), (False, LEAST_MOVEMENT_STEPS)):
        for fault in faults:
            if (fault.name not in MOVEMENT_FAULTS) is is_seen and fault.steps > least:
                return fault
    return None


def _lay_together(matching: Matching, ink: Resampled, model_ink: Resampled) -> tuple[float, Array]:
    """Return the rms distance of two inks laid together by their paired strokes, and the shift."""
    paired = ink.only(ink.is_of([k for pair in matching.pairs for k in pair.strokes]))
    others = [k for pair in matching.pairs for k in pair.others]
    shift = lay_on(paired, model_ink.only(model_ink.is_of(others)))
    return rms_apart(replace(ink, points=ink.points + shift), model_ink), shift


def _part(name: str, faults: Sequence[Fault]) -> Part:
    """Return the row of the largest of its faults."""
    worst = next((fault for fault in faults if fault.name in FAULTS_BY_ROW[name]), None)
    level = sum(worst is None or worst.steps <= limit for limit in LEVEL_STEPS)
    reason = "" if worst is None or level == len(LEVEL_STEPS) else worst.reason
    return Part(name, level, LEVEL_WORDS[level], reason)
