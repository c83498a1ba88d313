"""Text on a sheet: lines with margins, broken between words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError, shown
from dmp_teach.letters.text.handwriting import Hand, OwnLetters, plain_text
from dmp_teach.letters.text.spacing import Strokes, word_spacing
from dmp_teach.letters.text.words import DEFAULT_TEMPO, Text, place_words
from dmp_teach.trajectory import all_points

# From line to line, in x-heights: the tail of a g does not meet the stem of an l.
DEFAULT_PITCH = 3.1
# A size that fits is searched for in steps of this [m].
X_HEIGHT_STEP = 0.0001


@checked
def write_lines(
    text: str,
    *,
    width: float = 0.210,
    height: float = 0.297,
    x_height: float = 0.008,
    margin: float = 0.020,
    pitch: float | None = None,
    alphabet: str | None = None,
    joined: bool = False,
    letters: OwnLetters | None = None,
    tempo: float = DEFAULT_TEMPO,
    settings: Settings | None = None,
) -> Text:
    r"""Write text on a sheet: from the top left, broken between words and at new lines.

        text = teach.write_lines("a letter\nfor you", x_height=0.012)
        motion = teach.Fetch().write(text, teach.Page.table(), at=text.middle)

    Args:
        text: Words, spaces and new lines.
        width: Of the sheet [m].
        height: Of the sheet [m].
        x_height: How tall a small letter without a stem is [m].
        margin: What stays free of ink at every edge [m].
        pitch: From line to line, an x-height at least [m]; None: 3.1 x-heights.
        alphabet: As in `write_word`.
        joined: As in `write_word`.
        letters: As in `write_word`.
        tempo: As in `write_word`.
        settings: As in `write_word`.

    Returns:
        The strokes on one clock, in the frame of the sheet: origin at its middle, x right, y up
        [s, m].

    Raises:
        LetterError: Nothing to write, a character that is not there, a wrong length, or text that
            does not fit; the `cure` of that error is an x_height that does.
    """
    if not isinstance(text, str) or not text.split():
        raise LetterError(f"There is nothing to write in {shown(text)}; give some words.")
    _check_lengths(width=width, height=height, margin=margin, pitch=1.0 if pitch is None else pitch)
    hand, text = Hand.of(alphabet, letters, settings), plain_text(text)
    hand.scale(x_height)
    if pitch is not None and pitch < x_height:
        raise LetterError(
            f"pitch is {pitch:g} m, but lines so near are written on each other: give at least the "
            f"x_height, {x_height:g} m, or leave it out for {DEFAULT_PITCH:g} x-heights."
        )
    kept = {each: hand.word(each, joined) for each in dict.fromkeys(text.split())}
    room = (width - 2 * margin, height - 2 * margin)
    sheet = _Sheet(hand.x_height, hand.lean, kept, text, room, pitch)
    rows = sheet.rows(x_height)
    if rows is None:
        raise _does_not_fit(sheet, x_height)
    first = height / 2 - margin - sheet.above * x_height
    words, spots = [], []
    for number, row in enumerate(rows):
        for place, each in row:
            words.append(kept[each])
            spots.append((margin - width / 2 + place, first - number * sheet.pitch(x_height)))
    return place_words(words, spots, hand.scale(x_height), tempo)


def _check_lengths(**lengths: object) -> None:
    """Raise a LetterError for what is no length on a sheet."""
    for name, value in lengths.items():
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= 10:
            raise LetterError(f"{name} is {shown(value)}, but must be a length from 0 to 10 m.")


@dataclass(frozen=True)
class _Sheet:
    """Words that are put into rows, in any size.

    Args:
        unit: The x-height that the words were written with [m].
        lean: Of the hand, x gained for each y.
        kept: The strokes of each word, from x = 0 on [m].
        text: In what order they come.
        room: Width and height inside the margins [m].
        given_pitch: From line to line [m], or None.
    """

    unit: float
    lean: float
    kept: Mapping[str, Strokes]
    text: str
    room: tuple[float, float]
    given_pitch: float | None

    @cached_property
    def widths(self) -> dict[str, float]:
        """Of each word, in x-heights."""
        return {w: float(np.ptp(all_points(own)[:, 0])) / self.unit for w, own in self.kept.items()}

    @cached_property
    def above(self) -> float:
        """How far the ink reaches over a line, in x-heights."""
        return max(float(all_points(own)[:, 1].max()) for own in self.kept.values()) / self.unit

    @cached_property
    def below(self) -> float:
        """How far it hangs under it, in x-heights."""
        lowest = min(float(all_points(own)[:, 1].min()) for own in self.kept.values())
        return -min(0.0, lowest) / self.unit

    def pitch(self, x_height: float) -> float:
        """Return the distance from line to line [m]."""
        return DEFAULT_PITCH * x_height if self.given_pitch is None else self.given_pitch

    def line_count(self, x_height: float) -> int:
        """Return how many lines there is room for."""
        room = self.room[1] - (self.above + self.below) * x_height
        if room < -1e-9:
            return 0
        return 1 + int((room + 1e-9) // max(self.pitch(x_height), 1e-9))

    def rows(self, x_height: float) -> list[list[tuple[float, str]]] | None:
        """Return the words of each line with their places [m], or None where they do not fit."""
        if max(self.widths.values()) * x_height > self.room[0] + 1e-9:
            return None
        found: list[list[tuple[float, str]]] = []
        for paragraph in self.text.strip("\n").split("\n"):
            found.append([])
            for each in paragraph.split():
                place = 0.0
                if found[-1]:
                    before, last = found[-1][-1]
                    step = word_spacing(self.kept[last], self.kept[each], self.unit, self.lean)
                    place = before + step / self.unit * x_height
                    if place + self.widths[each] * x_height > self.room[0] + 1e-9:
                        found.append([])
                        place = 0.0
                found[-1].append((place, each))
        return found if len(found) <= self.line_count(x_height) else None


def _does_not_fit(sheet: _Sheet, x_height: float) -> LetterError:
    """Return an error that says what does not fit, and which size would."""
    # What fits in one size fits in every smaller one.
    low, high = 0, int(x_height / X_HEIGHT_STEP)
    while low < high:
        middle = (low + high) // 2
        if sheet.rows((middle + 1) * X_HEIGHT_STEP) is not None:
            low = middle + 1
        else:
            high = middle
    cure = round(low * X_HEIGHT_STEP, 4) if low else None
    longest = max(sheet.widths, key=sheet.widths.__getitem__)
    width = sheet.widths[longest] * x_height
    if width > sheet.room[0]:
        what = (
            f"the word {shown(longest)} is {1000 * width:.0f} mm wide, but a line has "
            f"{1000 * max(sheet.room[0], 0):.0f} mm"
        )
    else:
        what = (
            f"there is room for {sheet.line_count(x_height)} lines inside the margins, but the "
            "text needs more"
        )
    helped = "nothing readable fits: write less, or take a larger sheet"
    if cure:
        helped = f"x_height={cure:g} fits"
    return LetterError(f"At an x_height of {x_height:g} m {what}; {helped}.", cure=cure)
