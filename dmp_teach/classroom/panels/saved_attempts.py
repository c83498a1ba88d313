"""Files of attempts under a pseudonym, made by *Save* alone and removed by *Forget*."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import count
from pathlib import Path

from dmp_teach.classroom.panels.attempts import Attempts
from dmp_teach.errors import TeachError
from dmp_teach.files import remove_leftovers
from dmp_teach.ink import Recording, recording_from_json, write_json

# Longer text, and other signs than letters, as "/", never stand in a file's name.
MAX_CHARACTER_LENGTH = 8
_FILE_NAME = re.compile(r"[^_]+_(?P<writer>.+?)(_\d+)?(-checkpoint)?")


class SavedAttempts:
    """The files that a pupil's pad has written, and which recording is in each."""

    def __init__(self, saved: dict[Path, Recording]) -> None:
        """Go on with the files that are known."""
        self._saved = saved

    def save(self, attempts: Attempts, writer: str | None) -> Path:
        """Write the newest attempt as JSON to where the notebook runs, once, under a pseudonym.

        Without a writer it takes the recording's own, or the first pseudonym that is free.
        """
        recording = attempts.newest.recording
        folder = Path.cwd()
        path = self.find(recording)
        if path is None:
            writer = writer or recording.writer or find_free_pseudonym(folder)
            path = find_free_path(folder, recording, writer)
            write_json(replace(recording, writer=writer), path)
            self._saved[path] = attempts.name_the_newest(writer).recording
        return path

    def find(self, recording: Recording) -> Path | None:
        """Return the file of a recording; None where it was not saved."""
        return next((path for path, saved in self._saved.items() if saved is recording), None)

    def forget(self, writer: str | None) -> list[str]:
        """Remove every file, also of the writer's earlier pads in this folder; return the names."""
        gone = {*self._saved, *(list_files(Path.cwd(), writer) if writer else ())}
        for path in gone:
            path.unlink(missing_ok=True)
        remove_leftovers(Path.cwd())
        self._saved.clear()
        return sorted(path.name for path in gone)


def list_files(folder: Path, writer: str | None = None) -> list[Path]:
    """Return the files of pads in a folder, of one writer or of all.

    They are known by their name and by what is in them, so that nobody else's file is meant; a
    copy that Jupyter has made of one is one, too.
    """
    found = []
    for place in (folder, folder / ".ipynb_checkpoints"):
        for path in sorted(place.glob("*_*.json")):
            name = _FILE_NAME.fullmatch(path.stem)
            if name and path.is_file() and writer in (None, name["writer"]):
                try:
                    written_by = recording_from_json(path.read_bytes()).writer
                except (TeachError, OSError):
                    continue
                if written_by == name["writer"]:
                    found.append(path)
    return found


def find_free_pseudonym(folder: Path) -> str:
    """Return the first pseudonym, "w01", "w02" ..., that no file in the folder carries."""
    taken = {part for file in folder.iterdir() for part in file.stem.split("_")}
    return next(name for name in (f"w{n:02d}" for n in count(1)) if name not in taken)


def find_free_path(folder: Path, recording: Recording, writer: str) -> Path:
    """Return a path that no file has: "a_w01.json", then "a_w01_2.json"."""
    character = recording.character or ""
    if not character.isalnum() or len(character) > MAX_CHARACTER_LENGTH:
        character = "ink"
    names = (f"{character}_{writer}{'' if n == 1 else f'_{n}'}.json" for n in count(1))
    return next(folder / name for name in names if not (folder / name).exists())
