"""A pupil as data: what it gets wrong, what it mixes up, how fast it learns, what it forgets."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Any, Self

import numpy as np

from dmp_teach.arguments import checked, is_whole
from dmp_teach.classroom.teaching.faults import SHAPE_FAULTS, WAY_FAULTS
from dmp_teach.errors import RecordingError
from dmp_teach.files import (
    ASSETS,
    checked_object,
    contents,
    is_number,
    loaded,
    must,
    write_whole,
)
from dmp_teach.scoring import Score
from dmp_teach.values import Value

PUPILS_FOLDER = ASSETS / "pupils"
FORMAT, PUPIL_VERSION = "dmp_teach pupil", 1
FIELDS = ("format", "version", "name", "faults", "mixes_up", "pace", "forgetting", "seed")
# Of every so many turns there is one after which something is forgotten; never after the first.
FORGETTING_CYCLE = 3


@dataclass(frozen=True, eq=False, repr=False)
class PupilTraits(Value):
    """What a robot is like as a pupil.

    Args:
        name: What it is called.
        faults: How much of each fault of the shape, by the names and in the units of
            `SHAPE_FAULTS`; of the way of writing 1.
        mixes_up: Pairs of letters such as "bd", each of which it writes for the other.
        pace: What share of a difference is gone after it was shown once, above 0, at most 1.
        forgetting: What share of what it has learned is gone when it forgets for the first time;
            each time after that half as much.
        seed: When it forgets, and what it asks, follows from it.

    Raises:
        RecordingError: An unknown fault, or a value out of its range; names it.
    """

    name: str
    faults: Mapping[str, float] = field(default_factory=dict, hash=False)
    mixes_up: tuple[str, ...] = ()
    pace: float = 0.5
    forgetting: float = 0.4
    seed: int = 0

    def __post_init__(self) -> None:
        """Check and lock."""
        must(isinstance(self.name, str) and 0 < len(self.name) <= 20, "name", self.name, "a word")
        must(isinstance(self.faults, Mapping), "faults", self.faults, "an object")
        for name, amount in self.faults.items():
            known = [*SHAPE_FAULTS, *WAY_FAULTS]
            must(name in known, "a fault", name, f"one of {', '.join(known)}")
            shape = SHAPE_FAULTS.get(name)
            low, high = (shape.low, shape.high) if shape else (1.0, 1.0)
            _must_be_within(name, amount, low, high)
        pairs = self.mixes_up
        is_list = isinstance(pairs, list | tuple) and all(map(_is_pair, pairs))
        must(is_list, "mixes_up", pairs, "a list of two letters each")
        _must_be_within("pace", self.pace, 0.05, 1.0)
        _must_be_within("forgetting", self.forgetting, 0.0, 1.0)
        must(type(self.seed) is int and 0 <= self.seed < 2**32, "seed", self.seed, "a whole number")
        object.__setattr__(self, "mixes_up", tuple(pairs))
        super().__post_init__()

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Self:
        """Load a pupil from a file of JSON, or one of ours by its name, such as "Mia".

        Raises:
            RecordingError: No such file or pupil, or a field that cannot be; names it.
        """
        if isinstance(path, str) and path in known_pupils():
            path = PUPILS_FOLDER / f"{path.lower()}.json"
        elif isinstance(path, str) and path.isalpha() and not Path(path).exists():
            names = ", ".join(known_pupils())
            raise RecordingError(f"There is no pupil {path!r:.40}: ours are {names}; or a file.")
        data, name = contents(path)
        try:
            return cls.of(loaded(data, FORMAT, (PUPIL_VERSION,), FIELDS))
        except RecordingError as error:
            raise RecordingError(f"{name}: {error}") from None

    # Any: JSON.
    @classmethod
    def of(cls, content: Mapping[str, Any]) -> Self:
        """Return the pupil of what a file holds; a RecordingError where it is none."""
        content = checked_object(content, FORMAT, (PUPIL_VERSION,), FIELDS)
        values = {name: content[name] for name in FIELDS[2:]}
        must(isinstance(values["mixes_up"], list), "mixes_up", values["mixes_up"], "a list")
        return cls(**values)

    def as_json(self) -> dict[str, Any]:
        """Return what a file holds."""
        values = {name: getattr(self, name) for name in FIELDS[2:]}
        values |= {"faults": dict(self.faults), "mixes_up": list(self.mixes_up)}
        return {"format": FORMAT, "version": PUPIL_VERSION, **values}

    def save(self, path: str | PathLike[str]) -> Path:
        """Save the pupil as JSON; a PathError where it cannot be written."""
        return write_whole(path, json.dumps(self.as_json(), indent=2).encode(), ".json")

    @classmethod
    @checked
    def like(cls, score: Score, name: str = "Echo") -> Self:
        """Return a pupil that gets wrong what is weakest in somebody's own score.

        It is the largest fault of the score that a pupil can have, as large as there; where there
        is none, a clear lean.
        """
        for fault in score.faults:
            if fault.steps > 1 and fault.name in WAY_FAULTS:
                return cls(name, {fault.name: 1.0})
            if fault.steps > 1 and fault.name in SHAPE_FAULTS:
                shape = SHAPE_FAULTS[fault.name]
                amount = float(getattr(score, fault.name, shape.usual))
                return cls(name, {fault.name: min(max(amount, shape.low), shape.high)})
        return cls(name, {"lean": SHAPE_FAULTS["lean"].usual})

    def writes_instead_of(self, letter: str) -> str | None:
        """Return the letter that it mixes up with this one; None where it does not."""
        for pair in self.mixes_up:
            if letter in pair:
                return pair.replace(letter, "", 1)
        return None

    def muddles_of(self, letter: str) -> tuple[str, ...]:
        """Return its faults of the way of writing, "mixed up" first."""
        mixed = ("mixed up",) if self.writes_instead_of(letter) else ()
        return (*mixed, *(name for name in WAY_FAULTS if name in self.faults))

    @checked
    def forgets_after(self, turn: int) -> bool:
        """Return whether it forgets something between this turn, from 1, and the next."""
        must(is_whole(turn) and turn > 0, "turn", turn, "a whole number from 1")
        cycle, place = divmod(turn - 1, FORGETTING_CYCLE)
        random = np.random.default_rng([self.seed, cycle])
        return place == int(random.integers(1, FORGETTING_CYCLE))


@cache
def known_pupils() -> tuple[str, ...]:
    """Return the names of the pupils that come with the package."""
    return tuple(sorted(path.stem.title() for path in PUPILS_FOLDER.glob("*.json")))


def _is_pair(pair: object) -> bool:
    """Return whether it is two letters."""
    return isinstance(pair, str) and len(pair) == 2 and pair[0] != pair[1]


def _must_be_within(name: str, value: object, low: float, high: float) -> None:
    """Raise a RecordingError unless a value is a number between two others."""
    is_good = is_number(value) and low <= value <= high  # type: ignore[operator]
    must(is_good, name, value, f"a number from {low:g} to {high:g}")
