"""Find what differs between two writings, each in steps of what an eye begins to see."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dmp_teach.scoring.advice import advise
from dmp_teach.scoring.direction import find_other_way
from dmp_teach.scoring.fit import Fit
from dmp_teach.scoring.kinematics import Movement
from dmp_teach.scoring.matching import Matching
from dmp_teach.scoring.phrases import Position
from dmp_teach.scoring.resampling import size_of
from dmp_teach.scoring.wording import word_difference
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, path_length

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
    "reversed": 5.0,
    "round": 5.0,
    "order": 4.0,
    "pieces": 4.0,
}
"""How many steps are what is or is not: what another reader would stumble over counts most."""

# What is smaller than this, and lacks a stroke, is a dot of its model [parts of the size].
LARGEST_LONE_DOT = 0.1
# Another beginning of a loop counts from an eighth of it on.
LEAST_LOOP_SHIFT = 0.125
# A line across is straight: so much of its length leads from side to side.
LEAST_LEVEL_PART = 0.85


@dataclass(frozen=True)
class Fault:
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


def find_faults(
    matching: Matching,
    fit: Fit,
    written: Movement,
    model: Movement,
    strokes: Sequence[Trajectory],
    *,
    hand: str,
) -> tuple[Fault, ...]:
    """Find all faults, the largest first.

    Args:
        matching: Which strokes belong together.
        fit: Of the model to the writing.
        written: The writing in numbers.
        model: The model in numbers.
        strokes: The model's.
        hand: "left" draws level lines from either end.
    """
    of_whole = [*_orientation_faults(matching), *_fit_faults(fit)]
    # A dot has no size, width or lean.
    if matching.missing and written.size < LARGEST_LONE_DOT * model.size:
        of_whole = [replace(fault, steps=0.0) for fault in of_whole]
    found = [
        *of_whole,
        *_stroke_faults(matching, strokes),
        *_writing_faults(matching, written, strokes, hand),
        *_way_faults(matching, strokes),
        *_shape_faults(matching, fit, strokes),
        *_loop_faults(matching, fit, strokes),
        *_movement_faults(written, model),
    ]
    return tuple(sorted(found, key=lambda fault: -fault.steps))


# Any: what the wording of the fault takes.
def _fault(name: str, steps: float, **facts: Any) -> Fault:
    """Return a fault in words."""
    return Fault(name, steps, *word_difference(name, steps, facts), advise(name, facts))


def _orientation_faults(matching: Matching) -> Iterator[Fault]:
    """Yield mirrored or turned."""
    if matching.mirrored or matching.turn:
        name = "mirrored" if matching.mirrored else "turned"
        yield _fault(name, FAULT_STEPS[name], turn=matching.turn)


def _fit_faults(fit: Fit) -> Iterator[Fault]:
    """Yield turn, rise, lean, size and width."""
    for name, degrees in (("turn", fit.turn), ("rise", fit.rise), ("lean", fit.lean)):
        yield _fault(name, abs(degrees) / DIFFERENCE_STEPS[name], degrees=degrees)
    for name, ratio in (("size", fit.size), ("width", fit.width)):
        yield _fault(name, abs(math.log(ratio)) / DIFFERENCE_STEPS[name], ratio=ratio)


def _stroke_faults(matching: Matching, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield strokes that are missing, or too many."""
    if matching.missing:
        count = len(matching.missing)
        steps = FAULT_STEPS["missing"] + (count > 1)
        yield _fault("missing", steps, count=count, **_started(matching.missing[0], strokes))
    if matching.extra:
        yield _fault("extra", FAULT_STEPS["extra"], count=len(matching.extra))


def _writing_faults(
    matching: Matching, written: Movement, strokes: Sequence[Trajectory], hand: str
) -> Iterator[Fault]:
    """Yield strokes that are joined, split, divided or begun elsewhere, or in another order."""
    for pairs, name in ((matching.merged, "joined"), (matching.split, "split")):
        if pairs:
            yield _fault(name, FAULT_STEPS["pieces"], written=written.strokes, model=len(strokes))
    if matching.divided:
        yield _fault("divided", FAULT_STEPS["pieces"])
    backwards = [pair for pair in matching.pairs if pair.alignment.backwards]
    if hand == "left":
        backwards = [pair for pair in backwards if not _is_level(strokes[pair.others[0]])]
    if backwards:
        line, stroke = backwards[0].alignment, backwards[0].others[0]
        steps = FAULT_STEPS["reversed"] + 0.1 * len(backwards)
        way = {"is_round": line.goes_round, "left": _turns_left(line.others)}
        yield _fault("reversed", steps, **_started(stroke, strokes), **way)
    for pair in matching.pairs:
        away = min(pair.alignment.begins, 1 - pair.alignment.begins)
        if not pair.alignment.backwards and away > LEAST_LOOP_SHIFT:
            steps = 2 * FAULT_STEPS["reversed"] * away
            yield _fault("begins", steps, **_started(pair.others[0], strokes))
    for early, late in zip(matching.order, sorted(matching.order), strict=True):
        if early != late:
            yield _fault("order", FAULT_STEPS["order"], early=early, late=late)
            break


def _way_faults(matching: Matching, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield a part within a stroke that goes another way."""
    for number, pair in enumerate(matching.pairs):
        whole = len(pair.strokes) == len(pair.others) == 1 and not pair.alignment.backwards
        way = find_other_way(pair.alignment) if whole and not pair.is_dot else None
        if way is not None:
            yield _fault(
                "round",
                FAULT_STEPS["round"],
                **_named_stroke(matching, number, strokes),
                is_round=way.is_round,
                left=way.turning > 0,
                position=_position(way.point, strokes),
            )
            break


def _shape_faults(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield the shape, a piece at an end, and the place that is farthest off."""
    point, pair = fit.worst
    yield _fault(
        "shape",
        fit.shape / DIFFERENCE_STEPS["shape"],
        **_named_stroke(matching, pair, strokes),
        alone=len(matching.pairs) == 1,
        position=_position(point, strokes),
    )
    if fit.trim is not None:
        stroke = _named_stroke(matching, fit.trim.pair, strokes)
        end = strokes[stroke["stroke"]].position[0 if fit.trim.first else -1]
        yield _fault(
            "piece",
            fit.gap / DIFFERENCE_STEPS["piece"],
            **stroke,
            missing=fit.trim.missing,
            position=_position(end, strokes),
        )
    far = np.linalg.norm(fit.places, axis=1)
    pair = int(np.argmax(far))
    right, up = fit.places[pair].tolist()
    steps = float(far[pair]) / DIFFERENCE_STEPS["place"]
    yield _fault("place", steps, **_named_stroke(matching, pair, strokes), right=right, up=up)


def _loop_faults(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield rings that are not closed: two points in a row are farther apart at their ends."""
    size = size_of(strokes)
    for number, pair in enumerate(matching.pairs):
        if pair.alignment.loop:
            mine, yours = (
                np.linalg.norm(line - np.roll(line, 1, axis=0), axis=1)
                for line in pair.alignment.lines
            )
            gap = max(0.0, float(mine.max() / fit.size - yours.max()) / size)
            point = pair.alignment.others[int(np.argmax(mine))]
            yield _fault(
                "open",
                gap / DIFFERENCE_STEPS["open"],
                **_named_stroke(matching, number, strokes),
                position=_position(point, strokes),
            )


def _movement_faults(written: Movement, model: Movement) -> Iterator[Fault]:
    """Yield smoothness, of the line and of the movement, and tempo."""
    yield _fault("shaky", max(0.0, written.shake - model.shake) / DIFFERENCE_STEPS["shaky"])
    rougher = max(0.0, model.smoothness - written.smoothness)
    steps = rougher / DIFFERENCE_STEPS["smooth"]
    yield _fault("smooth", steps, written=written.peaks, model=model.peaks)
    ratio = written.pace / model.pace * model.size / written.size
    yield _fault("tempo", abs(math.log(ratio)) / DIFFERENCE_STEPS["tempo"], ratio=ratio)


def _named_stroke(matching: Matching, pair: int, strokes: Sequence[Trajectory]) -> dict[str, int]:
    """Return which of how many strokes of the model a pair is."""
    return {"stroke": matching.pairs[pair].others[0], "of": len(strokes)}


def _started(stroke: int, strokes: Sequence[Trajectory]) -> dict[str, Any]:
    """Return which of how many strokes of the model it is, and where that starts."""
    position = _position(strokes[stroke].position[0], strokes)
    return {"stroke": stroke, "of": len(strokes), "position": position}


def _is_level(stroke: Trajectory) -> bool:
    """Return whether a stroke is a line across, such as the bar of a t."""
    right, up = np.abs(stroke.position[-1] - stroke.position[0])
    return bool(right > 2 * up and right > LEAST_LEVEL_PART * path_length(stroke.position))


def _turns_left(line: Array) -> bool:
    """Return whether a line (P, 2) goes round against the clock."""
    x, y = (line - line.mean(axis=0)).T
    return bool((x[:-1] * y[1:] - y[:-1] * x[1:]).sum() > 0)


def _position(point: Array, strokes: Sequence[Trajectory]) -> Position:
    """Return where a point lies in the box of strokes; the middle of a side that is very short."""
    ink = np.concatenate([stroke.position for stroke in strokes])
    low, size = ink.min(axis=0), np.ptp(ink, axis=0)
    x, y = np.divide(point - low, size, out=np.full(2, 0.5), where=size > 0.25 * size.max())
    return float(x), float(y)
