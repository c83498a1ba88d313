"""One letter by many writers: real ones where a folder has them, else hands that we make."""

from __future__ import annotations

import os
from collections import defaultdict
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from dmp_teach.errors import TeachError
from dmp_teach.formats import read_recording
from dmp_teach.ink import alphabets
from dmp_teach.lessons.drawing import lesson_letter
from dmp_teach.trajectory import Array, Trajectory

FOLDER_VARIABLE = "DMP_TEACH_RECORDINGS"
MADE_WRITERS = 12
# Fewer cannot decide anything.
LEAST_WRITERS = 6
# How hands differ from our alphabets.
HAND_SLANTS, HAND_ASPECTS, HAND_SIZES, HAND_PACES = (
    (-0.25, 0.35),
    (0.8, 1.25),
    (0.6, 1.4),
    (0.7, 1.4),
)
# A hand strays from its letter by so much of its size, in waves so fast [Hz].
STRAY, STRAY_HERTZ = 0.015, (0.3, 2.0)


@dataclass(frozen=True, eq=False)
class Writers:
    """A letter of one stroke by several writers, each about the middle of the sheet.

    Args:
        character: The letter.
        strokes: One for each writer [m].
        are_real: Whether people wrote them.
    """

    character: str
    strokes: tuple[Trajectory, ...]
    are_real: bool


def find_writers(character: str) -> Writers:
    """Return the writers of a letter, or of another one that real writers wrote."""
    folder = os.environ.get(FOLDER_VARIABLE)
    return (folder and read_writers(folder)) or make_writers(character)


@lru_cache(maxsize=4)
def read_writers(folder: str) -> Writers | None:
    """Return the letter of one stroke that most writers of a folder wrote; None of too few."""
    found: dict[str, dict[str, Trajectory]] = defaultdict(dict)
    for path in sorted(Path(folder).glob("*.*")):
        try:
            recording = read_recording(path)
            strokes = recording.strokes()
        except TeachError:
            # What is no recording of ours may lie beside them.
            continue
        if len(strokes) == 1 and recording.character and strokes[0].dimensions == 2:
            name = recording.writer or path.stem
            found[recording.character].setdefault(name, _centred(strokes[0]))
    character, by_writer = max(found.items(), key=lambda each: len(each[1]), default=("", {}))
    if len(by_writer) < LEAST_WRITERS:
        return None
    return Writers(character, tuple(by_writer.values())[:MADE_WRITERS], are_real=True)


@lru_cache(maxsize=16)
def make_writers(character: str) -> Writers:
    """Return hands of our own making: each leans, stretches, hurries and strays in its own way."""
    random = np.random.default_rng([ord(each) for each in character])
    names = alphabets()
    hands = []
    for number in range(MADE_WRITERS):
        [stroke] = lesson_letter(character, names[number % len(names)]).strokes()
        hands.append(_centred(_written_by_another(stroke, random)))
    return Writers(character, tuple(hands), are_real=False)


def _written_by_another(stroke: Trajectory, random: np.random.Generator) -> Trajectory:
    """Return a stroke as another hand would have written it."""
    slant, aspect, size, pace = (
        random.uniform(*each) for each in (HAND_SLANTS, HAND_ASPECTS, HAND_SIZES, HAND_PACES)
    )
    t = (stroke.t - stroke.t[0])[:, None]
    waves = random.uniform(*STRAY_HERTZ, 3), random.uniform(0, 2 * np.pi, 3)
    stray = np.sin(2 * np.pi * waves[0] * t + waves[1]) @ random.normal(0, STRAY, (3, 2))
    position = stroke.position + np.ptp(stroke.position, axis=0).max() * stray
    return Trajectory(pace * t[:, 0], size * position @ np.array([[aspect, 0], [slant, 1]]))


def _centred(stroke: Trajectory) -> Trajectory:
    """Return a stroke with the middle of its box at 0."""
    middle: Array = (stroke.position.min(axis=0) + stroke.position.max(axis=0)) / 2
    return Trajectory(stroke.t, stroke.position - middle)
