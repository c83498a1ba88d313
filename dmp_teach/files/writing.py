"""Where the files that come with the project are, and files written whole or not at all."""

from __future__ import annotations

import os
import secrets
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from errno import EACCES, EDQUOT, EFBIG, ENOSPC
from pathlib import Path

from dmp_teach.errors import PathError

_PACKAGE = Path(__file__).resolve().parent.parent
ASSETS = next(
    place
    for place in (_PACKAGE.parent / "assets", _PACKAGE / "assets")
    if (place / "alphabets").is_dir()
)
"""Beside the package in a clone, inside it in an installed copy."""
# Of a file that is being written: how its name begins, and how old it may be [s].
_PARTIAL, _LONGEST_WRITE = ".dmp_teach_", 60


def check_path(path: str | os.PathLike, suffix: str) -> Path:
    """Return where a file is to be written, `~` spelled out; for refusals before the work.

    Args:
        path: Where to; its folder must exist.
        suffix: How the name must end, ".html".

    Raises:
        PathError: The name ends otherwise, or the folder is missing.
    """
    if not isinstance(path, str | os.PathLike) or not isinstance(os.fspath(path), str):
        raise PathError(
            f"The path is {path!r}, but must be the name of a file, such as {'a' + suffix!r}."
        )
    path = Path(os.path.expanduser(path))
    if path.suffix.lower() != suffix:
        raise PathError(
            f"The path is {str(path)!r}, but its name must end with {suffix}: try "
            f"{path.stem + suffix!r}."
        )
    if not path.parent.is_dir():
        raise PathError(
            f"There is no folder {str(path.parent)!r} for {path.name!r}; make it first."
        )
    return path


def write_whole(path: str | os.PathLike, data: bytes, suffix: str) -> Path:
    """Write `data` beside `path` and put it in place in one step; who may read it stays the same.

    Args:
        path: As `check_path`.
        data: What.
        suffix: As `check_path`.

    Returns:
        The path.

    Raises:
        PathError: As `check_path`, or the place cannot be written, as a file that is read-only.
    """
    path = check_path(path, suffix)
    partial = None
    with told_as_path_error(path):
        try:
            # A link stays one: what it points to is written.
            place = Path(os.path.realpath(path))
            mode = place.stat().st_mode & 0o777 if place.exists() else 0o666
            if not mode & 0o222:
                raise PermissionError(EACCES, "it is read-only")
            remove_leftovers(place.parent)
            partial = place.with_name(f"{_PARTIAL}{secrets.token_hex(8)}{suffix}")
            # Nobody may read it before it is in place who may not read it then.
            with open(partial, "xb", opener=lambda name, flags: os.open(name, flags, mode)) as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            if place.exists():
                partial.chmod(mode)
            partial.replace(place)
        finally:
            # After an interruption, too.
            if partial is not None:
                partial.unlink(missing_ok=True)
    return path


@contextmanager
def told_as_path_error(path: Path) -> Iterator[None]:
    """Raise a PathError that names the file and the cure where the disk refuses something."""
    try:
        yield
    # A ValueError is a name that no file can have.
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        is_full = getattr(error, "errno", None) in (ENOSPC, EDQUOT, EFBIG)
        room = "make room on the disk, or " if is_full else ""
        raise PathError(
            f"{str(path)!r} cannot be written: {why}. What was there is unchanged; {room}save in "
            "another folder."
        ) from None


def remove_leftovers(folder: Path) -> None:
    """Remove what programs that were killed while they wrote have left in a folder.

    What is younger than `_LONGEST_WRITE` may still be written; the clock may have been set back.
    """
    for path in folder.glob(f"{_PARTIAL}*"):
        with suppress(OSError):
            if abs(time.time() - path.lstat().st_mtime) > _LONGEST_WRITE:
                path.unlink()
