"""The work of a pupil in one file, written by *Save* alone and removed by *Forget*."""

from __future__ import annotations

import json
from collections.abc import Iterator
from itertools import count
from pathlib import Path
from typing import Any

from dmp_teach.errors import RecordingError
from dmp_teach.files import contents, loaded, write_whole

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
    data, name = contents(path)
    try:
        work = loaded(data, _KIND, (1,), _FIELDS)
    except RecordingError as error:
        raise RecordingError(f"{name}: {error}") from None
    if work["pupil"] != pupil or not isinstance(work["lessons"], dict):
        raise RecordingError(f"{name} is not the work of {pupil}: move it, and save again.")
    return work["lessons"]


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


def forget_work(folder: Path, pupil: str) -> list[str]:
    """Remove a pupil's file, and the copies that Jupyter made of it; return their names."""
    gone = []
    for place in (folder, folder / ".ipynb_checkpoints"):
        for path in _files_in(place, pupil):
            path.unlink()
            gone.append(path.name)
    return gone


def find_free_pupil(folder: Path) -> str:
    """Return the first pseudonym, "w01", "w02" ..., that no work carries."""
    return next(w for w in (f"w{n:02d}" for n in count(1)) if not _path_of(folder, w).exists())


def _path_of(folder: Path, pupil: str) -> Path:
    return folder / f"work_{pupil}.json"


def _files_in(folder: Path, pupil: str) -> Iterator[Path]:
    """Yield the files of a pupil that are ours by what is in them."""
    for path in (_path_of(folder, pupil), folder / f"work_{pupil}-checkpoint.json"):
        try:
            if path.exists() and json.loads(path.read_bytes()).get("pupil") == pupil:
                yield path
        except (OSError, ValueError, AttributeError):
            continue
