"""The formats that ink comes in: each is a module or folder here that makes its `FORMAT`."""

from __future__ import annotations

import pkgutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path

from dmp_teach.ink import Recording


@dataclass(frozen=True)
class CaptureOptions:
    """What a user knows of a motion capture, as in `read_recording`; other formats need none of it.

    Args:
        marker: The name of the marker at the pen; None finds it.
        up: The direction out of the paper in the cameras' world.
        right: The direction to the right on the page.
    """

    marker: str | None = None
    up: str = "+y"
    right: str = "-x"


Reader = Callable[[bytes, str, CaptureOptions], Sequence[Recording]]


@dataclass(frozen=True)
class Format:
    """A file format of ink.

    Args:
        name: What people call it.
        suffixes: The ends of its files' names; the first is the one that is written.
        sniff: Tells from a file's bytes whether it is in this format.
        read: Returns the letters of a file from its bytes and its name; raises a RecordingError,
            before which `read_recordings` puts the file's name.
        write: Returns a recording as text; None where the format is only read.
    """

    name: str
    suffixes: tuple[str, ...]
    sniff: Callable[[bytes], bool]
    read: Reader
    write: Callable[[Recording], str] | None = None

    def __str__(self) -> str:
        return f"{self.name} ({', '.join(self.suffixes)})"


@cache
def known_formats() -> tuple[Format, ...]:
    """Return every format of this room, in the order of their modules."""
    here = Path(__file__).parent
    names = sorted(module.name for module in pkgutil.iter_modules([str(here)]))
    modules = [import_module(f"{__package__}.{name}") for name in names]
    return tuple(module.FORMAT for module in modules if hasattr(module, "FORMAT"))
