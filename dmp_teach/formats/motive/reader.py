"""Motion capture as a recording: fill its gaps, lay it on its page, cut it to its writing."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.doubts import find_doubts
from dmp_teach.formats.motive.page_plane import level_axes, on_page
from dmp_teach.formats.motive.table import has_motive_header
from dmp_teach.formats.motive.take import FEWEST_FRAMES, read_take
from dmp_teach.formats.registry import CaptureOptions, Format
from dmp_teach.ink import Recording
from dmp_teach.segmentation import Spans, find_runs, find_strokes
from dmp_teach.trajectory import Array

FILE_NAME = re.compile(r"(\S)_(w\d+)(?:[_ .-].*)?")
LIFT_AFTER_DOT = 0.15  # of the lift after a dot so much is kept, until it is a dot [s]


def read_motive(data: bytes, name: str, options: CaptureOptions) -> tuple[Recording, ...]:
    """Read the letter in a Motive CSV file; errors as `read_recording`."""
    out = level_axes(options.up, options.right)[:, 2]
    take = read_take(data, options.marker, out)
    try:
        position, strokes, (start, end) = written(take.t, take.position, options.up, options.right)
    except RecordingError as error:
        raise RecordingError(f"marker {take.pen.name!r}: {error}") from None
    samples = sum(b - a for a, b in strokes)
    if samples < FEWEST_FRAMES:
        raise RecordingError(
            f"marker {take.pen.name!r} writes in {samples} frames only, but a letter needs "
            f"{FEWEST_FRAMES}. Does up={options.up!r} point out of the paper? Otherwise record "
            "again."
        )
    character, writer = labels_in(name)
    notes, doubtful = find_doubts(take, position, strokes)
    recording = Recording(
        take.t[start:end],
        position[start:end],
        character,
        writer,
        notes=notes,
        marker=take.pen.name,
        doubtful=find_runs(doubtful[start:end]),
    )
    return (recording,)


def written(t: Array, points: Array, up: str, right: str) -> tuple[Array, Spans, tuple[int, int]]:
    """Find the writing of a pen that was followed in three dimensions.

    Args:
        t: Times, shape (T,) [s].
        points: The pen in the cameras' world, shape (T, 3) [m].
        up: The direction out of the paper.
        right: The direction to the right on the page.

    Returns:
        The pen on its page, shape (T, 3) [m], its strokes, and the samples (start, end) that
        hold them.

    Raises:
        RecordingError: As `on_page`.
    """
    position = on_page(t, points, up, right)
    strokes, part = _cut_to_writing(t, position)
    ink = np.concatenate([position[a:b] for a, b in strokes])
    return position - [*ink[:, :2].min(axis=0), np.median(ink[:, 2])], strokes, part


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


def labels_in(name: str) -> tuple[str | None, str | None]:
    """Return letter and pseudonym from a file name such as `a_w01.csv`; others stay private."""
    # macOS takes the dots off an ä in a file's name.
    match = FILE_NAME.fullmatch(unicodedata.normalize("NFC", Path(name).stem))
    return (match[1], match[2]) if match else (None, None)


FORMAT = Format("Motive CSV", (".csv",), has_motive_header, read_motive)
