"""Forecast how far off a pupil will be, turn by turn, when our own letter is shown."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from dmp_teach.classroom.teaching.memory import PupilMemory
from dmp_teach.classroom.teaching.pupil import RobotPupil, differs_in_way
from dmp_teach.classroom.teaching.traits import PupilTraits

# Between so many shares of what is to be learned the distance is taken to be straight.
LEARNED_SHARES = np.array([0.0, 0.3, 0.6, 0.85, 1.0])


@dataclass(frozen=True)
class _Stage:
    """A pupil with some faults of the way left: how far off it is at each of the shares."""

    far: tuple[float, ...]
    differs: tuple[bool, ...]


def forecast(traits: PupilTraits, letter: str, turns: int) -> list[tuple[PupilMemory, float]]:
    """Return the memory and the distance [m] of a pupil as it comes to each turn, and after all.

    Its questions stay without an answer. This takes a millisecond where the pupil's faults and the
    letter were asked for before.

    Args:
        traits: Of the pupil.
        letter: What it is taught.
        turns: How often it is shown.
    """
    memory = PupilMemory(traits, traits.muddles_of(letter))
    # What is measured depends on the faults alone.
    faults = tuple(traits.faults.items()), traits.mixes_up
    found = [(memory, _far(faults, letter, memory))]
    for _turn in range(turns):
        stage = _measure(*faults, letter, memory.muddles)
        nearest = int(np.argmin(np.abs(LEARNED_SHARES - memory.learned)))
        memory = memory.learn(stage.differs[nearest]).forget()
        found.append((memory, _far(faults, letter, memory)))
    return found


def _far(
    faults: tuple[tuple[tuple[str, float], ...], tuple[str, ...]], letter: str, memory: PupilMemory
) -> float:
    """Return how far off a pupil is with this memory [m]."""
    return float(
        np.interp(memory.learned, LEARNED_SHARES, _measure(*faults, letter, memory.muddles).far)
    )


@lru_cache(maxsize=256)
def _measure(
    faults: tuple[tuple[str, float], ...],
    mixes_up: tuple[str, ...],
    letter: str,
    muddles: tuple[str, ...],
) -> _Stage:
    """Return what a pupil with these faults writes at each of the shares."""
    pupil = RobotPupil.load(PupilTraits("Test", dict(faults), mixes_up), letter)
    memories = [replace(pupil.memory, muddles=muddles, learned=float(s)) for s in LEARNED_SHARES]
    scores = [pupil.practised(memory).score() for memory in memories]
    return _Stage(
        tuple(each.distance for each in scores), tuple(differs_in_way(each) for each in scores)
    )
