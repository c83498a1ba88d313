"""The inputs of a study: strokes that know their letter and their writer."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from dmp_teach.arguments import warn_caller
from dmp_teach.errors import RecordingError, kind_of
from dmp_teach.files import pseudonyms
from dmp_teach.formats import is_ink, read_recording
from dmp_teach.ink import Recording, alphabets, recording_of
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Trajectory
from dmp_teach.values import Value

PAPER_LETTERS = "abeDBmM"
"""The letters of the paper, from each of our alphabets where no recordings are given."""


@dataclass(frozen=True, eq=False, repr=False)
class Written(Value):
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
"""Recordings, files or folders of them, or strokes; None takes our own alphabets."""


def own_recordings(letters: str = PAPER_LETTERS) -> tuple[Recording, ...]:
    """Return these letters of every alphabet of ours."""
    return tuple(recording_of(letter, alphabet) for letter in letters for alphabet in alphabets())


def list_recordings(
    recordings: RecordingsLike = None, labels: str | None = None
) -> tuple[Recording | Trajectory | Written | Iterable[Trajectory], ...]:
    """Return what was given as a tuple, files read; our own letters where nothing was.

    Args:
        recordings: As in `claims`.
        labels: A pattern (regular expression) for names of files without their ending, with a group
            `character`, a group `writer`, or both, for what the files do not say. Writers that are
            no pseudonyms become "writer-1" and so on.
    """
    if recordings is None:
        return own_recordings()
    if isinstance(recordings, Recording | Trajectory | Written | str | os.PathLike):
        recordings = (recordings,)
    if not isinstance(recordings, Iterable):
        raise RecordingError(
            f"recordings is {kind_of(recordings)}, but must be recordings, or their files."
        )
    pattern = None if labels is None else _pattern(labels)
    read = tuple(
        read
        for each in recordings
        for read in (_files(each, pattern) if isinstance(each, str | os.PathLike) else (each,))
    )
    if not read:
        raise RecordingError(
            "recordings is empty; give at least one, or None for our own alphabets."
        )
    if pattern is None:
        return read
    whose = pseudonyms(each.writer for each in read if isinstance(each, Recording))
    return tuple(
        replace(each, writer=whose[each.writer]) if isinstance(each, Recording) else each
        for each in read
    )


def _pattern(labels: str) -> re.Pattern[str]:
    """Return the pattern, or raise a RecordingError."""
    try:
        pattern = re.compile(labels)
    except (re.error, TypeError) as error:
        raise RecordingError(f"labels is {labels!r}, which is no pattern: {error}.") from None
    if not pattern.groupindex or not set(pattern.groupindex) <= {"character", "writer"}:
        raise RecordingError(
            f"labels is {labels!r}, but must have a group character or writer, such as "
            r"'(?P<character>\w)_(?P<writer>\w+)'."
        )
    return pattern


def _files(path: str | os.PathLike[str], labels: re.Pattern[str] | None) -> Iterable[Recording]:
    """Yield the letter of a file, or those of all files in a folder that are labelled.

    Without labels, what is no ink in a folder, such as a README, is left out with a warning.
    """
    folder = Path(path)
    files = [folder]
    if folder.is_dir():
        # Systems hide files of their own beside others.
        files = sorted(f for f in folder.iterdir() if f.is_file() and not f.name.startswith("."))
        files = files if labels else _without_strangers(files)
    matches = [(each, labels.search(each.stem) if labels else None) for each in files]
    # A file that is not there is refused by its reader.
    kept = [(each, found) for each, found in matches if found or not labels or not each.exists()]
    if not kept:
        names = ", ".join(each.name for each in files[:3])
        why = f"labels is {labels.pattern!r}, which {names} does not match" if labels else ""
        raise RecordingError(f"{why if files else f'The folder {folder.name} has no files'}.")
    for each, found in kept:
        said = found.groupdict() if found else {}
        yield read_recording(each, character=said.get("character"), writer=said.get("writer"))


def _without_strangers(files: list[Path]) -> list[Path]:
    """Return the files of ink, with a warning that names the others; all where none is ink."""
    ink = [each for each in files if is_ink(each)]
    others = ", ".join(each.name for each in files if each not in ink)
    if ink and others:
        warn_caller(f"Left out, as there is no ink in them: {others}.")
    return ink or files


def list_letters(recordings: RecordingsLike = None) -> tuple[Written, ...]:
    """Return every letter, cut into its strokes, of `Recording`s, files of them, or strokes.

    Strokes are a `Trajectory`, or a tuple of them for a letter; None takes our own alphabets.

    Raises:
        RecordingError: Something that no letter can be read from, or nothing at all.
    """
    given = list_recordings(recordings)
    return tuple(_letter(each, number) for number, each in enumerate(given, start=1))


def list_letters_on_page(recordings: RecordingsLike = None) -> tuple[Written, ...]:
    """Return every letter, as `list_letters`.

    Raises:
        RecordingError: As `list_letters`; a stroke that is not 2-D.
    """
    letters = list_letters(recordings)
    for letter in letters:
        for stroke in letter.strokes:
            if stroke.dimensions != 2:
                raise RecordingError(
                    f"{letter.name} has a {stroke.dimensions}-D stroke, but the paper is about ink "
                    "on a page: give strokes of x and y."
                )
    return letters


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
