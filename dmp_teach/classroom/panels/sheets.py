"""The sheet that letters are written on: its size, its lines, and where a letter lies on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from unicodedata import normalize

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.ink import Recording, recording_of
from dmp_teach.trajectory import Array, Trajectory, all_points

SHEET_OF_ANY_LETTER = [-0.02, -0.06, 0.14, 0.15]
"""Left, bottom, right and top where no letter is chosen [m]; every sheet has these four."""


def check_character(character: object) -> str:
    """Return a letter as our alphabets name it, an accent not being a sign of its own.

    "" is any letter.

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


def find_writing_lines() -> list[float]:
    """Return the heights that letters stand on, and that small ones reach [m]."""
    return [0.0, float(all_points(recording_of("x").strokes())[:, 1].max())]


def fit_pad_sheet(strokes: Sequence[Trajectory]) -> list[float]:
    """Return a sheet for writing: a letter, the lines, and room for larger ones [m]."""
    if not strokes:
        return list(SHEET_OF_ANY_LETTER)
    lines = [[0.0, y] for y in find_writing_lines()]
    return _add_margin(np.vstack([all_points(strokes), lines]), 0.02, 0.3)


def fit_goal_sheet(strokes: Sequence[Trajectory]) -> list[float]:
    """Return a sheet for moving goals: a letter, and a margin to drag goals to [m]."""
    return _add_margin(all_points(strokes), 0.015, 0.14)


def place_on_sheet(recording: Recording, sheet: list[float]) -> Recording:
    """Return a recording moved to the middle of a sheet and onto its line, y = 0.

    Without a baseline it stands on its lowest point.
    """
    points = all_points(recording.strokes())
    low = points.min(axis=0)
    high = points.max(axis=0)
    line = low[1] if recording.baseline is None else recording.baseline
    shift = [(sheet[0] + sheet[2] - low[0] - high[0]) / 2, -line, 0.0]
    return replace(recording, position=recording.position + shift, baseline=0.0)


def extend_sheet(sheet: list[float], strokes: Sequence[Trajectory]) -> list[float]:
    """Return the sheet, larger where ink would lie beyond its edge."""
    return _add_margin(np.vstack([all_points(strokes), [sheet[:2], sheet[2:]]]), 0.0, 0.0)


def _add_margin(points: Array, least: float, share: float) -> list[float]:
    """Return the box of points with a margin: a share of its size, or at least so much [m]."""
    low = points.min(axis=0)
    high = points.max(axis=0)
    margin = max(least, share * float((high - low).max()))
    return [float(v) for v in (*(low - margin), *(high + margin))]
