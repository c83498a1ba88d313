"""Words: letters beside each other on a line, connected or not, on one clock."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError
from dmp_teach.letters.pauses import pause_before
from dmp_teach.letters.text.handwriting import Hand, OwnLetters
from dmp_teach.letters.text.spacing import Strokes
from dmp_teach.trajectory import Array, Trajectory, all_points

# Between the same time (0) and the same speed (1) in every size: isochrony is not perfect.
DEFAULT_TEMPO = 0.4
# A word of eleven letters still fits on a sheet of A4 [m].
DEFAULT_X_HEIGHT = 0.014
# The mean speed of a pen in the air is at most this [m/s].
FASTEST_LIFT = 0.5


class Text(tuple[Trajectory, ...]):
    """Strokes of a text, in the order of writing, where they stand on the page.

    `Fetch().write(text, page, at=text.middle)` writes them there; without `at` they come to the
    middle.
    """

    __slots__ = ()

    @property
    def middle(self) -> Array:
        """The middle of the ink's bounding box, shape (2,) [m]."""
        points = all_points(self)
        return (points.min(axis=0) + points.max(axis=0)) / 2

    @property
    def duration(self) -> float:
        """From the first sample to the last, lifts included [s]."""
        return float(self[-1].t[-1] - self[0].t[0])

    def __repr__(self) -> str:
        return f"Text({len(self)} stroke{'s' * (len(self) > 1)}, {self.duration:.3f} s)"


@checked
def write_word(
    text: str,
    alphabet: str | None = None,
    *,
    joined: bool = False,
    letters: OwnLetters | None = None,
    x_height: float | None = DEFAULT_X_HEIGHT,
    tempo: float = DEFAULT_TEMPO,
    settings: Settings | None = None,
) -> Text:
    """Write a word: every letter by its primitives, spaced by the white between them.

    People write larger letters faster, so that the time hardly grows with the size (isochrony:
    Viviani and McCollum, 1983; Viviani and Schneider, 1991): a word takes

        duration = duration in the alphabet's size * (x_height / x_height of the alphabet)^tempo

    Args:
        text: Letters, digits and signs, without a space; the quotation marks, dashes and ellipsis
            of print are written as typed ones.
        alphabet: One of `alphabets()`; None is the first.
        joined: Whether the pen stays on the paper from one small letter to the next where the one
            ends on its right; dots, crosses and accents then follow after the word.
        letters: One's own, by character: `Letter`s or recordings. Each is made as tall as the
            alphabet's, and stands where that stands; those that are missing are the alphabet's.
        x_height: How tall a small letter without a stem is [m]; None: as in the alphabet.
        tempo: 0: the same time in every size; 1: the same speed in every size.
        settings: How the alphabet's letters are learned; `Settings.star()` unless given.

    Returns:
        The strokes, from time 0, the first ink at x = 0 and the writing line at y = 0 [s, m].

    Raises:
        LetterError: Nothing to write, a space, a character that is not there (names those that
            are), a wrong size, or a wrong tempo.
    """
    hand = Hand.of(alphabet, letters, settings)
    if not isinstance(text, str) or not text or text.split() != [text]:
        raise LetterError(
            f"A word is letters without a space, but got {text!r}; teach.write_lines writes text "
            "with spaces."
        )
    return place_words([hand.word(text, joined)], [(0.0, 0.0)], hand.scale(x_height), tempo)


def place_words(
    words: Sequence[Strokes], spots: Sequence[tuple[float, float]], scale: float, tempo: float
) -> Text:
    """Place words, in the size of the alphabet, on the sheet, one stroke after the other.

    Each begins at its spot [m], `scale` times as large; `tempo` is that of `write_word`.
    """
    if isinstance(tempo, bool) or not isinstance(tempo, int | float) or not 0 <= tempo <= 1:
        raise LetterError(
            f"tempo is {tempo!r}, but must be from 0 (the same time in every size) to 1 (the same "
            "speed)."
        )
    strokes: list[Trajectory] = []
    for own, spot in zip(words, spots, strict=True):
        for stroke in own:
            position, begin = stroke.position * scale + spot, 0.0
            if strokes:
                here, there = strokes[-1].position[-1], position[0]
                pause = pause_before(here / scale, there / scale) * scale**tempo
                flight = float(np.linalg.norm(there - here)) / FASTEST_LIFT
                begin = strokes[-1].t[-1] + max(pause, flight)
            strokes.append(Trajectory((stroke.t - stroke.t[0]) * scale**tempo + begin, position))
    return Text(strokes)
