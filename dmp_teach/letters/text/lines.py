"""Text on a sheet: lines with margins, broken between words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError
from dmp_teach.letters.text.handwriting import Hand, plain
from dmp_teach.letters.text.spacing import Strokes, word_distance
from dmp_teach.letters.text.words import TEMPO, Text, placed
from dmp_teach.trajectory import Array

PITCH = 3.1  # from line to line, in x-heights: what hangs from a g and what stands up in an l do not meet
FINEST = 0.0001  # in which steps a size that fits is looked for [m]


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
    letters: Mapping[str, Any] | None = None,
    tempo: float = TEMPO,
    settings: Settings | None = None,
) -> Text:
    r"""Write text on a sheet: from the top left, broken between words, and where the text has a new line.

        text = teach.write_lines("a letter\nfor you", x_height=0.012)
        motion = teach.Fetch().write(text, teach.Page.table(), at=text.middle)

    Args:
        text: Words, spaces and new lines.
        width: Of the sheet [m].
        height: Of the sheet [m]; A4 unless said, as a `Page` is.
        x_height: How tall a small letter without a stem is [m].
        margin: What stays free of ink at every edge [m].
        pitch: From line to line, an x-height at least [m]; None: 3.1 x-heights.
        alphabet: As in `write_word`.
        joined: As in `write_word`.
        letters: As in `write_word`.
        tempo: As in `write_word`.
        settings: As in `write_word`.

    Returns:
        The strokes on one clock, in the frame of the sheet: the origin is its middle, x right, y up [s, m].

    Raises:
        LetterError: Nothing to write, a character that is not there, a length that is none, or text that does not fit;
            the `cure` of that error is an x_height that does.
    """
    if not isinstance(text, str) or not text.split():
        raise LetterError(f"There is nothing to write in {text!r}; give some words.")
    _check_lengths(width=width, height=height, margin=margin, pitch=1.0 if pitch is None else pitch)
    hand, text = Hand.of(alphabet, letters, settings), plain(text)
    hand.scale(x_height)
    if pitch is not None and pitch < x_height:
        raise LetterError(
            f"pitch is {pitch:g} m, but lines so near are written on each other: give at least the x_height, "
            f"{x_height:g} m, or leave it out for {PITCH:g} x-heights."
        )
    kept = {each: hand.word(each, joined) for each in dict.fromkeys(text.split())}
    sheet = _Sheet(
        hand.x_height, hand.lean, kept, text, (width - 2 * margin, height - 2 * margin), pitch
    )
    rows = sheet.rows(x_height)
    if rows is None:
        raise _too_much(sheet, x_height)
    first = height / 2 - margin - sheet.above * x_height
    words, spots = [], []
    for number, row in enumerate(rows):
        for place, each in row:
            words.append(kept[each])
            spots.append((margin - width / 2 + place, first - number * sheet.pitch(x_height)))
    return placed(words, spots, hand.scale(x_height), tempo)


def _check_lengths(**lengths: Any) -> None:
    """Raise for what is no length on a sheet."""
    for name, value in lengths.items():
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= 10:
            raise LetterError(f"{name} is {value!r}, but must be a length from 0 to 10 m.")


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
    steps: dict[tuple[str, str], float] = field(default_factory=dict)

    @cached_property
    def widths(self) -> dict[str, float]:
        """Of each word, in x-heights."""
        return {
            each: float(np.ptp(_points(own)[:, 0])) / self.unit for each, own in self.kept.items()
        }

    @cached_property
    def above(self) -> float:
        """How far the ink reaches over a line, in x-heights."""
        return max(float(_points(own)[:, 1].max()) for own in self.kept.values()) / self.unit

    @cached_property
    def below(self) -> float:
        """How far it hangs under it."""
        return (
            -min(0.0, *(float(_points(own)[:, 1].min()) for own in self.kept.values())) / self.unit
        )

    def pitch(self, x_height: float) -> float:
        """From line to line [m]."""
        return PITCH * x_height if self.given_pitch is None else self.given_pitch

    def fitting(self, x_height: float) -> int:
        """How many lines there is room for."""
        room = self.room[1] - (self.above + self.below) * x_height
        if room < -1e-9:
            return 0
        return 1 + int((room + 1e-9) // max(self.pitch(x_height), 1e-9))

    def _step(self, before: str, after: str) -> float:
        """How far the next word begins to the right of where this one began, in x-heights."""
        if (before, after) not in self.steps:
            step = word_distance(self.kept[before], self.kept[after], self.unit, self.lean)
            self.steps[before, after] = step / self.unit
        return self.steps[before, after]

    def rows(self, x_height: float) -> list[list[tuple[float, str]]] | None:
        """The words of each line, with their places from the left [m]; None where they do not fit."""
        if max(self.widths.values()) * x_height > self.room[0] + 1e-9:
            return None
        found: list[list[tuple[float, str]]] = []
        for paragraph in self.text.strip("\n").split("\n"):
            found.append([])
            for each in paragraph.split():
                place = 0.0
                if found[-1]:
                    before, last = found[-1][-1]
                    place = before + self._step(last, each) * x_height
                    if place + self.widths[each] * x_height > self.room[0] + 1e-9:
                        found.append([])
                        place = 0.0
                found[-1].append((place, each))
        return found if len(found) <= self.fitting(x_height) else None


def _points(strokes: Strokes) -> Array:
    return np.concatenate([stroke.position for stroke in strokes])


def _too_much(sheet: _Sheet, x_height: float) -> LetterError:
    """What does not fit, and which size would."""
    sizes: Sequence[float] = np.arange(1, int(x_height / FINEST) + 1) * FINEST
    low, high = 0, len(sizes)
    while low < high:  # the largest that fits; what fits in one size fits in every smaller one
        middle = (low + high) // 2
        low, high = (
            (middle + 1, high) if sheet.rows(float(sizes[middle])) is not None else (low, middle)
        )
    cure = round(float(sizes[low - 1]), 4) if low else None
    longest = max(sheet.widths, key=sheet.widths.__getitem__)
    if sheet.widths[longest] * x_height > sheet.room[0]:
        what = f"the word {longest!r} is {1000 * sheet.widths[longest] * x_height:.0f} mm wide, but a line has "
        what += f"{1000 * max(sheet.room[0], 0):.0f} mm"
    else:
        what = f"there is room for {sheet.fitting(x_height)} lines inside the margins, but the text needs more"
    help_ = (
        f"x_height={cure:g} fits"
        if cure
        else "nothing readable fits: write less, or take a larger sheet"
    )
    return LetterError(f"At an x_height of {x_height:g} m {what}; {help_}.", cure=cure)
