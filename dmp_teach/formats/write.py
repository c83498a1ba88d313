"""Write recordings in every format that can be written; whole or not at all.

None of them has a place for a name, a date or a time of day: times begin at 0, and a writer is a
pseudonym or absent.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from dmp_teach.errors import PathError, RecordingError, kind_of
from dmp_teach.files import write_whole
from dmp_teach.formats.flat_ink import check_size
from dmp_teach.formats.registry import known_formats
from dmp_teach.ink import Recording, add_lifts, check_pseudonym
from dmp_teach.trajectory import Trajectory


def write_recording(ink: Recording | Iterable[Trajectory], path: str | os.PathLike[str]) -> Path:
    """Write a recording, or strokes such as those of `Letter.write`, into a file.

    `.json` keeps all of it, to the last bit. `.inkml` keeps the strokes, their times (to 1 us) and
    pressure, and places to 0.1 um; what the pen did in the air is left out. `.svg` keeps the
    strokes' shape and order, to 1 um, a path for each, in millimetres and unfilled, as pen
    plotters want it; read again, at a hand's pace, its sharp bends are cut by up to 0.1 mm. A label
    keeps every sign that XML can hold.

    Args:
        ink: A recording, or 2-D strokes on one clock [m].
        path: Where to; the end of its name says the format.

    Returns:
        The path.

    Raises:
        RecordingError: Neither a recording nor strokes, its writer is no pseudonym, or ink of a
            size or in a place that no reader would take for a letter; nothing is written then.
        PathError: Another end of the name, a missing folder, or a place that cannot be written.
    """
    recording = ink if isinstance(ink, Recording) else _recording_from(ink)
    check_pseudonym(recording.writer)
    suffix = Path(path).suffix.lower() if isinstance(path, str | os.PathLike) else ""
    writers = {each.suffixes[0]: each.write for each in known_formats() if each.write}
    if suffix not in writers:
        raise PathError(
            f"The path is {path!r}, but its name must end with one of {', '.join(writers)}."
        )
    if suffix != ".json":
        try:
            check_size([stroke.position for stroke in recording.strokes()])
        except RecordingError as error:
            raise RecordingError(
                f"This cannot be written as {suffix}: {error} A .json file keeps any ink."
            ) from None
    return write_whole(path, writers[suffix](recording).encode(), suffix)


def _recording_from(ink: Iterable[Trajectory]) -> Recording:
    """Return strokes as a recording."""
    if isinstance(ink, Trajectory):
        ink = (ink,)
    strokes = tuple(ink) if isinstance(ink, Iterable) else ()
    if not strokes or not all(isinstance(stroke, Trajectory) for stroke in strokes):
        raise RecordingError(
            f"{kind_of(ink, first=True)} cannot be written as ink; give a Recording, or strokes "
            "(Trajectory)."
        )
    return add_lifts(strokes)
