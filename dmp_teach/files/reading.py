"""Open files in one place: ordinary ones only, none larger than a letter could need."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from dmp_teach.errors import RecordingError

LARGEST_FILE = 64_000_000  # a bigger file is no recording of a letter [bytes]


def contents(path: str | os.PathLike[str]) -> tuple[bytes, str]:
    """Return what a file holds, and its name without the folder, for messages.

    Args:
        path: The file; `~` is the user's own folder.

    Raises:
        RecordingError: Not a path, no such file, a folder, a pipe or a device, empty, or larger
            than `LARGEST_FILE`.
    """
    named = os.fspath(path) if isinstance(path, str | os.PathLike) else None
    if not isinstance(named, str) or not named:
        raise RecordingError(
            f"path is {path!r}, but must be the name of a file, such as 'a_w01.csv'."
        )
    path = Path(os.path.expanduser(path))
    name = path.name or str(path)
    try:
        about = path.stat()
        if stat.S_ISDIR(about.st_mode):
            raise RecordingError(f"{name} is a folder; give the name of a file in it.")
        if not stat.S_ISREG(about.st_mode):
            raise RecordingError(
                f"{name} is a pipe or a device, but must be an ordinary file; save the ink in one."
            )
        if about.st_size > LARGEST_FILE:
            most = LARGEST_FILE / 1e6
            raise RecordingError(
                f"{name} has {about.st_size / 1e6:.0f} MB, but ink has at most {most:.0f}; cut it."
            )
        with path.open("rb") as file:
            data = file.read(LARGEST_FILE)
    except OSError as error:
        raise RecordingError(
            f"{name} cannot be read: {error.strerror or error}. Check the path."
        ) from None
    except RecordingError:
        raise
    except ValueError as error:
        raise RecordingError(f"{name!r} cannot be the name of a file: {error}.") from None
    if not data.strip():
        raise RecordingError(f"{name} is empty; save or export it again.")
    return data, name
