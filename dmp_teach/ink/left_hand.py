"""Letters as left-handers are taught to write them: bars are pulled towards the body.

Pulling t f A E F H T J's bars from right to left is what schools teach left-handers (Collins Happy
Handwriting); all else is written as by the right hand.
"""

from __future__ import annotations

from dataclasses import replace
from unicodedata import normalize

import numpy as np

from dmp_teach.errors import LetterError
from dmp_teach.ink.pen_lifts import add_lifts
from dmp_teach.ink.recording import Recording
from dmp_teach.trajectory import Trajectory, path_length

LETTERS_WITH_BARS = "tfAEFHTJ"
# A line across is straight: so much of its length leads from side to side.
LEAST_LEVEL_PART = 0.85


def check_hand(hand: str) -> None:
    """Raise a LetterError unless it is the right or the left hand."""
    if hand not in ("right", "left"):
        raise LetterError(f"hand is {hand!r}, but must be 'right' or 'left'.")


def is_level(stroke: Trajectory) -> bool:
    """Return whether a stroke is a line across, such as the bar of a t."""
    right, up = np.abs(stroke.position[-1] - stroke.position[0])
    return bool(right > 2 * up and right > LEAST_LEVEL_PART * path_length(stroke.position))


def pull_bars(recording: Recording) -> Recording:
    """Return a letter with its bars from right to left, and lifts that lead there."""
    letter = normalize("NFD", recording.character or "")[:1]
    if not letter or letter not in LETTERS_WITH_BARS:
        return recording
    pulled = tuple(map(_pull, recording.strokes()))
    about = {name: getattr(recording, name) for name in ("character", "writer", "baseline")}
    return add_lifts(pulled, **about)


def _pull(stroke: Trajectory) -> Trajectory:
    """Return a bar from right to left, at the tempo that it has; any other stroke as it is."""
    if not is_level(stroke) or stroke.position[-1, 0] < stroke.position[0, 0]:
        return stroke
    t = stroke.t[0] + stroke.t[-1] - stroke.t[::-1]
    return replace(stroke, t=t, position=stroke.position[::-1])
