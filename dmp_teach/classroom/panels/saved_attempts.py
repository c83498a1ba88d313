"""What is kept of what somebody wrote: files under a pseudonym, made by *Save* alone; *Forget* removes them."""

from __future__ import annotations

from dataclasses import replace
from itertools import count
from pathlib import Path

from dmp_teach.classroom.panels.attempts import Tries
from dmp_teach.ink import Recording, write_json

LONGEST = 8  # signs of what was written that stand in a file's name; other signs, as "/", never do


class Kept:
    """The files that a pad has written, and which recording is in each."""

    def __init__(self) -> None:
        self._saved: dict[Path, Recording] = {}

    def save(self, tries: Tries, writer: str | None) -> Path:
        """Write the newest try as JSON to where the notebook runs, once, and give it its writer's pseudonym.

        Args:
            tries: What was written.
            writer: Whose it is; None takes the recording's own, or the first pseudonym that is free.

        Raises:
            RecordingError: Nothing is written yet.
            PathError: The folder cannot be written.
        """
        recording, folder = tries.newest.recording, Path.cwd()
        path = next((path for path, saved in self._saved.items() if saved is recording), None)
        if path is None:
            writer = writer or recording.writer or free_writer(folder)
            path = free_name(folder, recording, writer)
            write_json(replace(recording, writer=writer), path)
            self._saved[path] = tries.name_the_newest(writer).recording
        return path

    def forget(self) -> str:
        """Remove every file; gives their names, with commas."""
        names = ", ".join(path.name for path in self._saved)
        for path in self._saved:
            path.unlink(missing_ok=True)
        self._saved = {}
        return names


def free_writer(folder: Path) -> str:
    """The first pseudonym, "w01", "w02" ..., that no file in the folder carries."""
    taken = {part for file in folder.iterdir() for part in file.stem.split("_")}
    return next(name for name in (f"w{n:02d}" for n in count(1)) if name not in taken)


def free_name(folder: Path, recording: Recording, writer: str) -> Path:
    """A name that no file has: "a_w01.json", then "a_w01_2.json"; capitals are told apart also where names are not."""
    character = recording.character or ""
    stem = f"{character if character.isalnum() and len(character) <= LONGEST else 'ink'}_{writer}"
    names = (folder / f"{stem}{'' if n == 1 else f'_{n}'}.json" for n in count(1))
    return next(path for path in names if not path.exists())
