"""Find what differs between two writings, each in steps of what an eye begins to see."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from dmp_teach.scoring.faults import (
    DIFFERENCE_STEPS,
    FAULT_STEPS,
    Fault,
    make_fault,
    name_start,
    name_stroke,
    position_in,
)
from dmp_teach.scoring.fit import Fit
from dmp_teach.scoring.kinematics import Movement
from dmp_teach.scoring.matching import Matching
from dmp_teach.scoring.resampling import size_of
from dmp_teach.scoring.strokes import find_pair_faults, make_place_fault
from dmp_teach.trajectory import Trajectory

# What is smaller than this, and lacks a stroke, is a dot of its model [parts of the size].
LARGEST_LONE_DOT = 0.1


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
        *_way_faults(matching, fit, strokes, hand),
        *_shape_faults(matching, fit, strokes),
        *_loop_faults(matching, fit, strokes),
        *_movement_faults(written, model),
    ]
    return tuple(sorted(found, key=lambda fault: -fault.steps))


def _orientation_faults(matching: Matching) -> Iterator[Fault]:
    """Yield mirrored or turned."""
    if matching.mirrored or matching.turn:
        name = "mirrored" if matching.mirrored else "turned"
        yield make_fault(name, FAULT_STEPS[name], turn=matching.turn)


def _fit_faults(fit: Fit) -> Iterator[Fault]:
    """Yield turn, rise, lean, size and width."""
    for name, degrees in (("turn", fit.turn), ("rise", fit.rise), ("lean", fit.lean)):
        yield make_fault(name, abs(degrees) / DIFFERENCE_STEPS[name], degrees=degrees)
    for name, ratio in (("size", fit.size), ("width", fit.width)):
        yield make_fault(name, abs(math.log(ratio)) / DIFFERENCE_STEPS[name], ratio=ratio)


def _stroke_faults(matching: Matching, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield strokes that are missing, or too many."""
    if matching.missing:
        count = len(matching.missing)
        steps = FAULT_STEPS["missing"] + (count > 1)
        yield make_fault("missing", steps, count=count, **name_start(matching.missing[0], strokes))
    if matching.extra:
        yield make_fault("extra", FAULT_STEPS["extra"], count=len(matching.extra))


def _way_faults(
    matching: Matching, fit: Fit, strokes: Sequence[Trajectory], hand: str
) -> Iterable[Fault]:
    """Return the largest fault of each name that a stroke has in itself."""
    awaited = [k for pair in matching.pairs for k in pair.others]
    worst: dict[str, Fault] = {}
    for pair, place in zip(matching.pairs, fit.places, strict=True):
        for fault in (
            *find_pair_faults(matching, pair, strokes, awaited, hand=hand),
            make_place_fault(pair, place, fit.size, strokes),
        ):
            if fault.name not in worst or fault.steps > worst[fault.name].steps:
                worst[fault.name] = fault
    return worst.values()


def _shape_faults(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield the shape, and a piece at an end."""
    point, pair = fit.worst
    yield make_fault(
        "shape",
        fit.shape / DIFFERENCE_STEPS["shape"],
        **name_stroke(matching.pairs[pair].others[0], strokes),
        alone=len(matching.pairs) == 1,
        position=position_in(point, strokes),
    )
    if fit.trim is not None:
        stroke = matching.pairs[fit.trim.pair].others[0]
        end = strokes[stroke].position[0 if fit.trim.first else -1]
        yield make_fault(
            "piece",
            fit.gap / DIFFERENCE_STEPS["piece"],
            **name_stroke(stroke, strokes),
            missing=fit.trim.missing,
            position=position_in(end, strokes),
        )


def _loop_faults(matching: Matching, fit: Fit, strokes: Sequence[Trajectory]) -> Iterator[Fault]:
    """Yield rings that are not closed: two points in a row are farther apart at their ends."""
    size = size_of(strokes)
    for pair in matching.pairs:
        if pair.alignment.loop:
            mine, yours = (
                np.linalg.norm(line - np.roll(line, 1, axis=0), axis=1)
                for line in pair.alignment.lines
            )
            gap = max(0.0, float(mine.max() / fit.size - yours.max()) / size)
            point = pair.alignment.others[int(np.argmax(mine))]
            yield make_fault(
                "open",
                gap / DIFFERENCE_STEPS["open"],
                **name_stroke(pair.others[0], strokes),
                position=position_in(point, strokes),
            )


def _movement_faults(written: Movement, model: Movement) -> Iterator[Fault]:
    """Yield smoothness, of the line and of the movement, and tempo."""
    yield make_fault("shaky", max(0.0, written.shake - model.shake) / DIFFERENCE_STEPS["shaky"])
    rougher = max(0.0, model.smoothness - written.smoothness)
    steps = rougher / DIFFERENCE_STEPS["smooth"]
    yield make_fault("smooth", steps, written=written.peaks, model=model.peaks)
    ratio = written.pace / model.pace * model.size / written.size
    yield make_fault("tempo", abs(math.log(ratio)) / DIFFERENCE_STEPS["tempo"], ratio=ratio)
