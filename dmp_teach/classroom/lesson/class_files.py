"""The files of a class in one folder, or in a folder for each pupil, read as data alone."""

from __future__ import annotations

import os
import re
import stat
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from dmp_teach.classroom.lesson.bets import KeptBet
from dmp_teach.classroom.lesson.progress import LESSON_STEPS, MOST_MISSES
from dmp_teach.classroom.lesson.work_file import forget_work, read_work_file
from dmp_teach.classroom.panels.saved_attempts import list_files
from dmp_teach.errors import RecordingError, TeachError
from dmp_teach.files import contents, is_pseudonym, must
from dmp_teach.ink import Recording, recording_from_json
from dmp_teach.texts import gettext as _

# A home of a hub has its lessons in home/lessons.
DEEPEST_FOLDER, MOST_PUPILS, MOST_FOLDERS, MOST_FILES = 3, 1_000, 50, 2_000
LARGEST_WORK = 2_000_000  # [bytes]
# "work_w01.json", also as a browser or Jupyter names a copy; "a_w01_2.json".
_WORK = re.compile(r"work_.*\.json")
_INK = re.compile(r"[^_]{1,8}_(?P<writer>[^_]+)(_\d{1,4})?\.json")


@dataclass(frozen=True)
class LessonRecord:
    """How far a pupil has come in a lesson, as the file says; `misses` are checks not passed."""

    step: str
    bet: KeptBet | None
    misses: int
    hints: int
    is_passed: bool


@dataclass(frozen=True)
class PupilRecord:
    """What a pupil has saved.

    Args:
        pseudonym: As the files say.
        name: As it is shown: the folder's where that is a pseudonym and this pupil's alone, with a
            number where another has the same.
        lessons: By their numbers.
        ink: The newest recording of each letter.
        attempts: How many were saved of each letter.
        files: What was read.
    """

    pseudonym: str
    name: str = ""
    lessons: dict[str, LessonRecord] = field(default_factory=dict)
    ink: dict[str, Recording] = field(default_factory=dict)
    attempts: Counter[str] = field(default_factory=Counter)
    files: list[Path] = field(default_factory=list)

    def forget(self) -> None:
        """Remove the pupil's files, and the copies that Jupyter made of them."""
        for folder in {path.parent for path in self.files}:
            forget_work(folder, self.pseudonym, self.pseudonym)
            self.files.extend(list_files(folder, self.pseudonym))
        for path in self.files:
            path.unlink(missing_ok=True)


def read_class(folder: Path) -> tuple[list[PupilRecord], list[str]]:
    """Return the pupils of a class in order, and a note on each file that cannot be used."""
    pupils: dict[tuple[str, str], PupilRecord] = {}
    notes: list[str] = []
    for path in _find_files(folder, notes):
        told = path.relative_to(folder)
        try:
            _read_file(path, told.parts[0] if len(told.parts) > 1 else "", pupils)
        except (TeachError, OSError, ValueError) as error:
            notes.append(f"{told}: {str(error).removeprefix(path.name + ': ')}")
    return _named(pupils, notes), notes


def _named(pupils: dict[tuple[str, str], PupilRecord], notes: list[str]) -> list[PupilRecord]:
    """Return the pupils in order, each with a name of its own."""
    in_place = Counter(place for place, _told in pupils)
    homes = defaultdict(list)
    for (place, told), pupil in sorted(pupils.items()):
        is_home = is_pseudonym(place) and in_place[place] == 1
        homes[place if is_home else told].append((place, pupil))
    for name, found in homes.items():
        if len(found) > 1:
            places = ", ".join(place or "." for place, _pupil in found)
            words = _("{name} is in more than one folder, in this order: {places}")
            notes.append(words.format(name=name, places=places))
    return [
        replace(pupil, name=f"{name} ({n})" if n > 1 else name)
        for name in sorted(homes, key=_order)
        for n, (_place, pupil) in enumerate(homes[name], 1)
    ]


def _find_files(folder: Path, notes: list[str]) -> Iterator[Path]:
    """Yield what may be a pupil's file; never behind a link, nor in a hidden folder."""

    def note(error: OSError) -> None:
        notes.append(f"{Path(error.filename).name}: {error.strerror}")

    for place, folders, names in os.walk(folder, onerror=note):
        here = Path(place)
        is_deep = len(here.relative_to(folder).parts) >= DEEPEST_FOLDER
        # Nobody takes the place of the others.
        most = 0 if is_deep else MOST_PUPILS if here == folder else MOST_FOLDERS
        folders[:] = sorted(name for name in folders if name[0] != ".")[:most]
        found = [name for name in names if _is_ours(name)]
        if len(found) > MOST_FILES:
            words = _("{name}: more than {most} files; the rest is not read.")
            notes.append(words.format(name=here.name, most=MOST_FILES))
        yield from (here / name for name in sorted(found, key=_by_length)[:MOST_FILES])


def _is_ours(name: str) -> bool:
    """Return whether a file is named as ours are."""
    ink = _INK.fullmatch(name)
    return bool(_WORK.fullmatch(name) or (ink and is_pseudonym(ink["writer"])))


def _by_length(name: str) -> tuple[int, str]:
    """Return what sorts names: "a_w01.json", "a_w01_2.json", "a_w01_10.json"; copies last."""
    return len(name), name


def _read_file(path: Path, place: str, pupils: dict[tuple[str, str], PupilRecord]) -> None:
    """Add a file to its pupil; errors where it is none of ours."""

    def pupil_of(pseudonym: str) -> PupilRecord:
        pupil = pupils.setdefault((place, pseudonym), PupilRecord(pseudonym))
        pupil.files.append(path)
        return pupil

    about = path.lstat()
    if not stat.S_ISREG(about.st_mode) or about.st_size > LARGEST_WORK:
        words = _("no ordinary file, or larger than {most} MB.")
        raise RecordingError(words.format(most=LARGEST_WORK // 1_000_000))
    if _WORK.fullmatch(path.name):
        pseudonym, lessons = read_work_file(path)
        must(is_pseudonym(pseudonym), "pupil", pseudonym, "a pseudonym, such as 'w01'")
        pupil = pupil_of(pseudonym)
        if pupil.lessons:
            words = _("one more file of {name}; the first counts.")
            raise RecordingError(words.format(name=pseudonym))
        bad = []
        for key, work in lessons.items():
            try:
                pupil.lessons[key] = _read_lesson(work)
            except (KeyError, TypeError, RecordingError) as error:
                bad.append(f"{key}: {error}")
        if bad:
            raise RecordingError("; ".join(bad[:3]))
    else:
        data, _name = contents(path)
        recording = recording_from_json(data)
        letter, writer = recording.character, recording.writer
        must(bool(writer and letter), "character or writer", letter, "told")
        pupil = pupil_of(str(writer))
        pupil.ink[str(letter)] = recording
        pupil.attempts[str(letter)] += 1


# Any: JSON, which is checked field by field.
def _read_lesson(work: Any) -> LessonRecord:
    """Return what a file says of a lesson; any error where a field is not as it must be."""
    told = work["progress"]
    must(told["step"] in LESSON_STEPS, "step", told["step"], "a step of a lesson")
    for name in ("misses", "hints"):
        is_count = type(told[name]) is int and 0 <= told[name] <= MOST_MISSES
        must(is_count, name, told[name], "a whole number")
    passed = isinstance(told["passed"], dict)
    return LessonRecord(told["step"], told["bet"], told["misses"], told["hints"], passed)


def _order(name: str) -> tuple[str, int]:
    """Return what sorts pseudonyms: w2 before w10."""
    letters = name.rstrip("0123456789")
    return letters, int(name[len(letters) :])
