"""How near a writing is to its model, in measures, in three rows for the pad, and in one sentence.

The score is ours. It tells what differs and is no medical or school test; nobody has shown that it makes handwriting
better.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.scoring.differences import UNSEEN, Fault, faults
from dmp_teach.scoring.distances import letter_distance, procrustes, warped
from dmp_teach.scoring.fit import fitted
from dmp_teach.scoring.kinematics import Movement, measured
from dmp_teach.scoring.linear_map import ratio
from dmp_teach.scoring.matching import Matching, matched, squared
from dmp_teach.scoring.resampling import size_of, spread, strokes_of
from dmp_teach.trajectory import Array, Trajectory

POINTS = 96  # over all the ink, for how far apart it is
WORDS = ("far", "nearer", "close", "the same")
SURELY = 2.0  # steps that a fault has which leaves no trace in the ink before anybody speaks of it
LEVELS = (
    6.0,
    3.0,
    1.0,
)  # steps of a fault (`faults.STEPS`) up to which a row is "nearer", "close", "the same"
ROWS = {
    "Shape": ("mirrored", "turned", "missing", "extra", "shape", "place", "piece", "open", "shaky"),
    "Size": ("size", "width"),
    "Lean": ("lean", "turn", "rise"),
}


@dataclass(frozen=True)
class Part:
    """One row of the pad.

    Args:
        name: "Shape", "Size" or "Lean".
        level: 0 to 3; the pad fills one circle more than that.
        word: "far", "nearer", "close" or "the same".
        reason: Why, in a few words; empty where it is the same.
    """

    name: str
    level: int
    word: str
    reason: str


@dataclass(frozen=True, eq=False)
class Score:
    """How near a writing is to its model.

    Args:
        sentence: The largest fault in plain words; of the movement only where the ink shows none.
        parts: Shape, size and lean, for the pad.
        faults: Everything that differs, the largest first, in steps of what an eye begins to see.
        matching: Which strokes belong together; its order, direction and number.
        distance: How far the two inks are apart on average (rms), moved to the same place [m].
        likeness: `letter_distance`, no unit.
        warped: Dynamic time warping distance of the strokes, of one size and place [parts of the letter's size].
        procrustes: Full Procrustes distance of the strokes, from 0 to 1.
        shape: How far the ink is from the nearest (rms) when size, width, lean and places fit [the same].
        place: How far the stroke that is farthest from its place is from it [parts of the letter's size].
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
    likeness: float
    warped: float
    procrustes: float
    shape: float
    place: float
    size: float
    width: float
    lean: float
    turn: float
    rise: float
    written: Movement
    model: Movement


def score(written: Any, model: Any) -> Score:
    """Compare a writing with its model.

    Strokes are matched by shape first: their order, direction and number are told, and count against nothing else.

    Args:
        written: A `Recording`, a `Letter` (what it writes) or strokes.
        model: The same: what it should look like.

    Raises:
        LetterError: One of them is nothing, something else, or all in one place.
    """
    mine, yours = strokes_of(written, "written"), strokes_of(model, "model")
    matching = matched(mine, yours)
    fit = fitted(matching, mine, yours)
    movements = measured(mine), measured(yours)
    found = faults(matching, fit, *movements, yours)
    points, others = map(
        np.concatenate, zip(*(pair.laid.lines for pair in matching.pairs), strict=True)
    )
    first = named(found)
    return Score(
        "It looks the same as the model." if first is None else first.sentence,
        tuple(_part(name, found) for name in ROWS),
        found,
        matching,
        _apart(mine, yours, matching),
        letter_distance(mine, yours, upright=False),
        _warped(matching, yours),
        procrustes(points, others),
        fit.shape,
        float(np.linalg.norm(fit.places, axis=1).max()),
        fit.size,
        fit.width,
        fit.lean,
        (90.0 * matching.turn + fit.turn + 180) % 360 - 180,
        fit.rise,
        *movements,
    )


def named(found: Sequence[Fault]) -> Fault | None:
    """The largest fault that is seen in the ink, or else one of the movement; None where there is none to see."""
    for seen, least in ((True, 1.0), (False, SURELY)):
        for fault in found:
            if (fault.name not in UNSEEN) is seen and fault.steps > least:
                return fault
    return None


def laid_middle(
    strokes: Sequence[Trajectory], matching: Matching, side: str
) -> tuple[Array, Array]:
    """Points over all ink (P, 2), and the middle (2,) of those that have a partner, by which letters are laid together.

    Args:
        strokes: Of one side.
        matching: Which strokes belong together.
        side: "strokes" for the writing, "others" for its model.
    """
    place, _, number, _ = spread(strokes, POINTS)
    both = np.isin(number, [k for pair in matching.pairs for k in getattr(pair, side)])
    return place, place[both].mean(axis=0)


def _part(name: str, found: Sequence[Fault]) -> Part:
    """The row of the largest of its faults."""
    worst = next(fault for fault in found if fault.name in ROWS[name])
    level = sum(worst.steps <= limit for limit in LEVELS)
    return Part(name, level, WORDS[level], "" if level == len(LEVELS) else worst.reason)


def _apart(mine: Sequence[Trajectory], yours: Sequence[Trajectory], matching: Matching) -> float:
    """Root mean square distance of every point of ink from the nearest of the other, both ways [m]."""
    sides = laid_middle(mine, matching, "strokes"), laid_middle(yours, matching, "others")
    far = squared(*(place - middle for place, middle in sides))
    return float(np.sqrt((far.min(axis=0).mean() + far.min(axis=1).mean()) / 2))


def _warped(matching: Matching, model: Sequence[Trajectory]) -> float:
    """Warping distance of the strokes that belong together, the letters of one size in one place."""
    mine, yours = (
        np.stack(lines) for lines in zip(*(pair.laid.lines for pair in matching.pairs), strict=True)
    )
    mine, yours = mine - mine.mean(axis=(0, 1)), yours - yours.mean(axis=(0, 1))
    mine /= ratio(mine, yours)
    apart = [warped(a, b) ** 2 for a, b in zip(mine, yours, strict=True)]
    return float(np.sqrt(np.mean(apart)) / size_of(model))
