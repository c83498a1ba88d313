"""Motion capture as a recording: fill its gaps, lay it on its page, cut it to its writing."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.page_plane import find_page, level_axes
from dmp_teach.formats.motive.refusals import FEWEST_FRAMES, Writing, check_take_size, check_writing
from dmp_teach.formats.motive.take import Take, read_take
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording
from dmp_teach.segmentation import Spans, find_strokes
from dmp_teach.trajectory import Array

HEADER = re.compile(
    rb"(?:^|[\r\n])[^,;\r\n]{0,8}frame[\"\t ]{0,8}[,;\t][\"\t ]{0,8}time", re.IGNORECASE
)
FILE_NAME = re.compile(r"(\S)_(w\d+)(?:[_ .-].*)?")
LIFT_AFTER_DOT = 0.15  # of the lift after a dot so much is kept, until it is a dot [s]


def has_motive_header(data: bytes) -> bool:
    """Tell whether a file has the row `Frame,Time`."""
    return HEADER.search(data[:100_000].replace(b"\0", b"")) is not None


def read_motive(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in a Motive CSV file; errors as `read_recording`."""
    level_axes(options.up, options.right)
    take = _cut_to_seen(read_take(data, name, options.marker))
    filled = _fill_gaps(take)
    check_take_size(take, filled)
    try:
        position = find_page(take.t, filled, options.up, options.right).of(filled)
        strokes, (start, end) = _cut_to_writing(take.t, position)
    except RecordingError as error:
        raise RecordingError(f"{take.name}, marker {take.marker!r}: {error}") from None
    check_writing(Writing(take, filled, strokes, options.up))
    ink = np.concatenate([position[a:b] for a, b in strokes])
    position = position - [*ink[:, :2].min(axis=0), np.median(ink[:, 2])]
    character, writer = _labels(take.name)
    return (Recording(take.t[start:end], position[start:end], character, writer),)


def _cut_to_seen(take: Take) -> Take:
    """Return the take from the first sample that the cameras saw to the last."""
    seen = np.flatnonzero(np.isfinite(take.position[:, 0]))
    if len(seen) < FEWEST_FRAMES:
        raise RecordingError(
            f"{take.name}: marker {take.marker!r} was seen in {len(seen)} frames, but a letter "
            f"needs {FEWEST_FRAMES}; record again. {take.choice}"
        )
    return take.part(int(seen[0]), int(seen[-1]) + 1)


def _fill_gaps(take: Take) -> Array:
    """Return positions (T, 3) with straight lines across the gaps."""
    seen = np.isfinite(take.position[:, 0])
    filled = [np.interp(take.t, take.t[seen], axis[seen]) for axis in take.position.T]
    return np.column_stack(filled)


def _cut_to_writing(t: Array, position: Array) -> tuple[Spans, tuple[int, int]]:
    """Return the strokes, and the first and last sample of a take that has only them.

    The same strokes must be found in the cut take, so it is cut until they are. It ends with its
    last stroke; of a dot, which only its two lifts tell from a rest, some of the lift is kept.
    """
    last, kept_lift = len(t), 0
    more_lift = max(1, round(LIFT_AFTER_DOT / float(np.median(np.diff(t)))))
    strokes = find_strokes(t, position)
    while True:
        start, end = strokes[0][0], min(last, strokes[-1][1] + kept_lift)
        found = find_strokes(t[start:end], position[start:end])
        again = tuple((a + start, b + start) for a, b in found)
        if again == strokes:
            return strokes, (start, end)
        if len(again) < len(strokes) and strokes[-1][1] + kept_lift < last:
            kept_lift += more_lift
        else:
            strokes, last = again, end


def _labels(name: str) -> tuple[str | None, str | None]:
    """Return letter and pseudonym from a file name such as `a_w01.csv`; others stay private."""
    # macOS takes the dots off an ä in a file's name.
    match = FILE_NAME.fullmatch(unicodedata.normalize("NFC", Path(name).stem))
    return (match[1], match[2]) if match else (None, None)


FORMAT = Format("Motive CSV", (".csv",), has_motive_header, read_motive)
