"""The sheet that letters are written on: how large it is, where its lines are, and where a letter is laid on it."""

from __future__ import annotations

from dataclasses import replace
from unicodedata import normalize

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording, recording_of
from dmp_teach.trajectory import Array, Trajectory

_FREE = (-0.02, -0.06, 0.14, 0.15)  # where nobody has chosen a letter [m]


def one_letter(character: str) -> str:
    """A letter as our alphabets name it, an accent not being a sign of its own; "" is any letter.

    Raises:
        RecordingError: More than one letter, or no letter at all.
    """
    if not isinstance(character, str):
        raise RecordingError(
            f"character is {character!r}, but must be one letter, such as 'a', or None for any."
        )
    letter = normalize("NFC", character)
    if len(letter) > 1:
        raise RecordingError(
            f"A pad takes one letter; for words use teach.write_word({letter[:20]!r})."
        )
    return letter


def writing_lines() -> list[float]:
    """The lines [m]: what letters stand on, and how high small ones are."""
    return [0.0, float(_points(recording_of("x").strokes())[:, 1].max())]


def sheet_of(strokes: tuple[Trajectory, ...]) -> list[float]:
    """What the sheet shows, [left, bottom, right, top] [m]: a letter, the lines, and room for larger ones."""
    if not strokes:
        return list(_FREE)
    points = np.vstack([_points(strokes), [[0.0, y] for y in writing_lines()]])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = max(0.02, 0.3 * float((high - low).max()))
    return [float(v) for v in (*(low - margin), *(high + margin))]


def laid_on(recording: Recording, sheet: list[float]) -> Recording:
    """A recording from elsewhere, moved to the middle of a sheet and onto its line, y = 0.

    Args:
        recording: Its ink may be anywhere; where nobody knows its line it stands on its lowest point.
        sheet: Left, bottom, right, top [m].
    """
    points = _points(recording.strokes())
    low, high = points.min(axis=0), points.max(axis=0)
    line = low[1] if recording.baseline is None else recording.baseline
    shift = [(sheet[0] + sheet[2] - low[0] - high[0]) / 2, -line, 0.0]
    return replace(recording, position=recording.position + shift, baseline=0.0)


def around(sheet: list[float], strokes: tuple[Trajectory, ...]) -> list[float]:
    """The sheet, larger where ink would lie beyond its edge."""
    points = np.vstack([_points(strokes), [sheet[:2], sheet[2:]]])
    return [float(v) for v in (*points.min(axis=0), *points.max(axis=0))]


def _points(strokes: tuple[Trajectory, ...]) -> Array:
    """All their points, shape (P, 2) [m]."""
    return np.concatenate([stroke.position for stroke in strokes])
