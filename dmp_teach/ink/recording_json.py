"""Read and write recordings as plain JSON: what a pad saves, and what our alphabets are made of.

The format is one object: what it is, its version, the letter, the writer's pseudonym, the writing
line [m], the strokes as pairs of samples (or null: found from the height), the pen's pressure, one
number from 0 to 1 for every sample (or null), and a row t [s], x, y, z [m] for each sample. It has
no place for a name, a date or a time of day.

A writer that is no pseudonym is neither written nor read. Version 2 begins its times at 0. Version
1 did not, and said nothing of what its pressure meant: it is read, without pressure.
"""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from dmp_teach.errors import RecordingError, kind_of
from dmp_teach.files import contents, is_number, is_pseudonym, loaded, must, write_whole
from dmp_teach.ink.recording import Recording

RECORDING_FORMAT = "dmp_teach recording"
RECORDING_VERSION = 2
RECORDING_VERSIONS = (1, RECORDING_VERSION)
# Larger numbers are no places [m].
FARTHEST_PLACE = 1e6
SAMPLE_UNITS = {"t": "s", "x": "m", "y": "m", "z": "m"}
RECORDING_FIELDS = (
    "format",
    "version",
    "character",
    "writer",
    "baseline",
    "units",
    "strokes",
    "pressure",
    "samples",
)


def read_json(path: str | os.PathLike[str]) -> Recording:
    """Read a recording from a file that `write_json` wrote, in this version or an older one.

    Raises:
        RecordingError: No such file, another format or version, or a field that cannot be.
    """
    data, name = contents(path)
    try:
        return recording_from_json(data)
    except RecordingError as error:
        raise RecordingError(f"{name}: {error}") from None


def recording_from_json(data: bytes) -> Recording:
    """Read a recording from the bytes of a file; errors as `read_json`, without its name."""
    return _read_recording(loaded(data, RECORDING_FORMAT, RECORDING_VERSIONS, RECORDING_FIELDS))


def write_json(recording: Recording, path: str | os.PathLike[str]) -> None:
    """Write a recording as plain JSON, with times that begin at 0.

    A file that was there stays until the new one is complete.

    Raises:
        RecordingError: Not a recording, or its writer is no pseudonym.
        PathError: The file cannot be written there.
    """
    write_whole(path, recording_to_json(recording).encode(), ".json")


def recording_to_json(recording: Recording) -> str:
    """Return a recording as JSON: a field a line, a sample a line, every digit kept.

    Raises:
        RecordingError: As `write_json`.
    """
    if not isinstance(recording, Recording):
        raise RecordingError(
            f"{kind_of(recording, first=True)} cannot be written as ink; give a Recording."
        )
    check_pseudonym(recording.writer)
    far = float(np.abs(recording.position).max())
    must(far <= FARTHEST_PLACE, "the farthest place", far, f"at most {FARTHEST_PLACE:.0f} m away")
    head = {
        "format": RECORDING_FORMAT,
        "version": RECORDING_VERSION,
        "character": recording.character,
        "writer": recording.writer,
        "baseline": recording.baseline,
        "units": SAMPLE_UNITS,
        "strokes": recording.given_strokes,
        "pressure": None if recording.pressure is None else recording.pressure.tolist(),
    }
    lines = [f"{json.dumps(name)}: {json.dumps(value)}" for name, value in head.items()]
    rows = zip((recording.t - recording.t[0]).tolist(), recording.position.tolist(), strict=True)
    samples = ",\n".join(json.dumps([t, *position]) for t, position in rows)
    return "{\n" + ",\n".join(lines) + ',\n"samples": [\n' + samples + "\n]\n}\n"


def check_pseudonym(writer: str | None, name: str = "writer") -> None:
    """Raise a RecordingError that says what a pseudonym is, unless the writer is one, or None."""
    fits = writer is None or (isinstance(writer, str) and is_pseudonym(writer))
    rule = "a pseudonym such as 'w01' or 'pupil-3', or null: no name, no date"
    must(fits, name, writer, rule)


# Any: JSON, in which every field is checked before it is used; so in the functions below.
def _read_recording(content: dict[str, Any]) -> Recording:
    """Return what the JSON says, every field checked."""
    character, writer, baseline, strokes, pressure = (
        content[name] for name in ("character", "writer", "baseline", "strokes", "pressure")
    )
    samples = _samples(content["samples"])
    is_whole = isinstance(pressure, list) and len(pressure) == len(samples)
    for name, fits, rule in (
        ("units", content["units"] == SAMPLE_UNITS, repr(SAMPLE_UNITS)),
        ("character", character is None or isinstance(character, str), "text or null"),
        ("writer", writer is None or isinstance(writer, str), "text or null"),
        ("baseline", baseline is None or is_number(baseline), "a number [m] or null"),
        (
            "strokes",
            strokes is None or _are_pairs(strokes),
            "pairs [start, end] of whole numbers or null",
        ),
        (
            "pressure",
            pressure is None or (is_whole and all(map(is_number, pressure))),
            "null or one number for every sample",
        ),
    ):
        must(fits, name, content[name], rule)
    if content["version"] > 1:
        begin = samples[0][0] if samples else 0
        must(begin == 0, "the first time", begin, "0: no clock is kept")
    return Recording(
        np.array([row[0] for row in samples], dtype=float),
        np.array([row[1:] for row in samples], dtype=float),
        character,
        writer if writer and is_pseudonym(writer) else None,
        baseline,
        None if strokes is None else tuple(map(tuple, strokes)),
        pressure if content["version"] > 1 else None,
    )


# Any: as above.
def _samples(rows: Any) -> list[list[float]]:
    """Return the rows t, x, y, z, all numbers."""
    must(isinstance(rows, list), "samples", rows, "rows [t, x, y, z]")
    for k, row in enumerate(rows):
        good = isinstance(row, list) and len(row) == len(SAMPLE_UNITS) and all(map(is_number, row))
        must(good, f"samples[{k}]", row, "four finite numbers [t, x, y, z]")
        near = max(map(abs, row[1:])) <= FARTHEST_PLACE
        must(near, f"samples[{k}]", row, f"at most {FARTHEST_PLACE:.0f} m away")
    return rows


# Any: as above.
def _are_pairs(strokes: Any) -> bool:
    """Return whether this is a list of pairs of whole numbers."""
    return isinstance(strokes, list) and all(
        isinstance(pair, list)
        and len(pair) == 2
        and all(type(edge) is int and abs(edge) < 2**62 for edge in pair)
        for pair in strokes
    )
