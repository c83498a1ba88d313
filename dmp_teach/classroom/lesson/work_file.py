"""The work of a pupil in one file, written by *Save* alone and removed by *Forget*."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from dmp_teach.errors import RecordingError
from dmp_teach.files import contents, loaded, must, parse_json, remove_leftovers, write_whole

# Any, here and below: what a lesson keeps, which checks it when it takes it up.
Work = dict[str, Any]
_KIND = "dmp_teach work"
_FIELDS = ("format", "version", "pupil", "lessons")


def read_work(folder: Path, pupil: str) -> Work:
    """Return the work of a pupil in every lesson, by the lesson's number; none without a file.

    Raises:
        RecordingError: The file is not one of ours, or says that it is another pupil's.
    """
    path = _path_of(folder, pupil)
    if not path.exists():
        return {}
    told, lessons = read_work_file(path)
    if told != pupil:
        raise RecordingError(f"{path.name} is not the work of {pupil}: move it, and save again.")
    return lessons


def read_work_file(path: Path) -> tuple[str, Work]:
    """Return whose work a file says that it is, and the work by the number of the lesson.

    Raises:
        RecordingError: The file is not one of ours.
    """
    data, name = contents(path)
    try:
        work = loaded(data, _KIND, (1,), _FIELDS)
        must(isinstance(work["pupil"], str), "pupil", work["pupil"], "a pseudonym")
        must(isinstance(work["lessons"], dict), "lessons", work["lessons"], "an object")
    except RecordingError as error:
        raise RecordingError(f"{name}: {error}") from None
    return work["pupil"], work["lessons"]


def save_work(folder: Path, pupil: str, lesson: str, work: Work) -> Path:
    """Write the work in one lesson beside that in the others, whole or not at all.

    Raises:
        RecordingError: There is a file of that name that is not ours.
        PathError: The folder cannot be written.
    """
    lessons = read_work(folder, pupil) | {lesson: work}
    content = dict(zip(_FIELDS, (_KIND, 1, pupil, lessons), strict=True))
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    return write_whole(_path_of(folder, pupil), text.encode(), ".json")


def forget_work(folder: Path, pupil: str, variant: str) -> list[str]:
    """Remove a pupil's file, and the copies that Jupyter made of it; return their names.

    A file that holds the work of another variant than `variant` ("" of who gave no pseudonym) is
    another pupil's.
    """
    gone = []
    for place in (folder, folder / ".ipynb_checkpoints"):
        for path in _files_in(place, pupil, variant):
            path.unlink()
            gone.append(path.name)
    remove_leftovers(folder)
    return gone


def _path_of(folder: Path, pupil: str) -> Path:
    return folder / f"work_{pupil}.json"


def _files_in(folder: Path, pupil: str, variant: str) -> Iterator[Path]:
    """Yield a pupil's files and Jupyter's copies of them, also where they are damaged."""
    for path in sorted(folder.glob(f"work_{pupil}*.json")):
        name = path.stem.removeprefix(f"work_{pupil}")
        if not re.fullmatch(r"(-Copy\d+)?(-checkpoint)?", name) or not path.is_file():
            continue
        try:
            content = parse_json(path.read_bytes())
        except ValueError:
            yield path
        else:
            if isinstance(content, dict) and content.get("format") == _KIND:
                works = content.get("lessons")
                works = works.values() if isinstance(works, dict) else ()
                told = {work.get("variant") for work in works if isinstance(work, dict)}
                if variant or told <= {""}:
                    yield path
