"""The inputs of a study: strokes that know their letter and their writer."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass

from dmp_teach.errors import RecordingError, kind_of
from dmp_teach.formats import read_recording
from dmp_teach.ink import Recording, alphabets, recording_of
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Trajectory

PAPER_LETTERS = "abeDBmM"
"""The letters of the paper, from each of our alphabets where no recordings are given."""


@dataclass(frozen=True)
class Written:
    """A letter of a writer (a pseudonym, or a number), cut into its 2-D strokes [m]."""

    character: str
    writer: str
    strokes: tuple[Trajectory, ...]

    @property
    def name(self) -> str:
        """The name, such as "a w01"."""
        return f"{self.character} {self.writer}"

    @property
    def size(self) -> float:
        """The larger side of the letter's bounding box [m]."""
        return size_of(self.strokes)


@dataclass(frozen=True)
class Stroke:
    """One stroke of a letter, with a name such as "D w01 2" (its second stroke)."""

    name: str
    character: str
    path: Trajectory


Given = Recording | Trajectory | Written | str | os.PathLike[str]
RecordingsLike = Given | Iterable[Given | Iterable[Trajectory]] | None
"""Recordings, files of them or strokes; None takes our own alphabets."""


def own_recordings(letters: str = PAPER_LETTERS) -> tuple[Recording, ...]:
    """Return these letters of every alphabet of ours."""
    return tuple(recording_of(letter, alphabet) for letter in letters for alphabet in alphabets())


def list_recordings(
    recordings: RecordingsLike = None,
) -> tuple[Recording | Trajectory | Written | Iterable[Trajectory], ...]:
    """Return what was given as a tuple, files read; our own letters where nothing was."""
    if recordings is None:
        return own_recordings()
    if isinstance(recordings, Recording | Trajectory | Written | str | os.PathLike):
        recordings = (recordings,)
    if not isinstance(recordings, Iterable):
        raise RecordingError(
            f"recordings is {kind_of(recordings)}, but must be recordings, or their files."
        )
    read = tuple(
        read_recording(each) if isinstance(each, str | os.PathLike) else each for each in recordings
    )
    if not read:
        raise RecordingError(
            "recordings is empty; give at least one, or None for our own alphabets."
        )
    return read


def list_letters(recordings: RecordingsLike = None) -> tuple[Written, ...]:
    """Return every letter, cut into its strokes, of `Recording`s, files of them, or strokes.

    Strokes are a `Trajectory`, or a tuple of them for a letter; None takes our own alphabets.

    Raises:
        RecordingError: Something that no letter can be read from, or nothing at all.
    """
    given = list_recordings(recordings)
    return tuple(_letter(each, number) for number, each in enumerate(given, start=1))


def named_strokes(recordings: RecordingsLike = None) -> tuple[Stroke, ...]:
    """Return every stroke of every letter."""
    found = []
    for letter in list_letters(recordings):
        for number, path in enumerate(letter.strokes, start=1):
            name = letter.name if len(letter.strokes) == 1 else f"{letter.name} {number}"
            found.append(Stroke(name, letter.character, path))
    return tuple(found)


def _letter(given: object, number: int) -> Written:
    """Return one letter, whatever it was given as."""
    if isinstance(given, Written):
        return given
    if isinstance(given, Recording):
        return Written(given.character or "?", given.writer or str(number), given.strokes())
    if isinstance(given, Trajectory):
        given = (given,)
    strokes = tuple(given) if isinstance(given, Iterable) else ()
    if not strokes or not all(isinstance(stroke, Trajectory) for stroke in strokes):
        raise RecordingError(
            f"recordings[{number - 1}] is {kind_of(given)}, but must be a recording, its file, or "
            "strokes (Trajectory)."
        )
    return Written("?", str(number), strokes)
