"""Words: letters beside each other on a line, joined or not, on one clock."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Self

import numpy as np

from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import LetterError
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.letters.letter import Letter, pause_before
from dmp_teach.letters.linking import linked
from dmp_teach.letters.meeting import body_and_marks, can_arrive, can_leave
from dmp_teach.letters.spacing import distance, linked_distance
from dmp_teach.trajectory import Array, Trajectory

TEMPO = 0.4  # between the two: isochrony is strong, but not perfect
FLYING = 0.5  # a pen in the air is on average no faster than this [m/s]
Strokes = tuple[Trajectory, ...]


class Text(tuple[Trajectory, ...]):
    """Strokes of a text, in the order of writing, where they stand on the page.

    `Fetch().write(text, page, at=text.middle)` writes them there; without `at` they come to the middle of the page.
    """

    __slots__ = ()

    @property
    def middle(self) -> Array:
        """The middle of the ink's bounding box, shape (2,) [m]."""
        points = np.concatenate([stroke.position for stroke in self])
        return (points.min(axis=0) + points.max(axis=0)) / 2

    @property
    def duration(self) -> float:
        """From the first sample to the last, lifts included [s]."""
        return float(self[-1].t[-1] - self[0].t[0])

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        return f"Text({len(self)} stroke{'s' * (len(self) > 1)}, {self.duration:.3f} s)"


def word(
    text: str,
    alphabet: str | None = None,
    *,
    joined: bool = False,
    letters: Mapping[str, Any] | None = None,
    x_height: float | None = None,
    tempo: float = TEMPO,
    settings: Settings | None = None,
) -> Text:
    """Write a word: every letter by its primitives, spaced by the white between them.

    People write larger letters faster, so that the time hardly grows with the size (isochrony: Viviani and McCollum,
    1983; Viviani and Schneider, 1991): a word takes

        duration = duration in the alphabet's size * (x_height / x_height of the alphabet)^tempo

    Args:
        text: Letters and digits, without a space.
        alphabet: One of `alphabets()`; None is the first.
        joined: Whether the pen stays on the paper from one small letter to the next where the one ends on its right;
            dots, crosses and accents then follow after the word, from left to right, as in school.
        letters: One's own, by character: `Letter`s or recordings. Each is made as tall as the alphabet's, and stands
            where that stands; those that are missing are the alphabet's.
        x_height: How tall a small letter without a stem is [m]; None: as in the alphabet.
        tempo: 0: the same time in every size; 1: the same speed in every size.
        settings: How the alphabet's letters are learned; `Settings.star()` unless given.

    Returns:
        The strokes, from time 0, the first ink at x = 0 and the writing line at y = 0 [s, m].

    Raises:
        LetterError: Nothing to write, a space, a character that is not there (names those that are), a size that is no
            length, or a tempo that is none.
    """
    hand = Hand.of(alphabet, letters, settings)
    if not isinstance(text, str) or not text or text.split() != [text]:
        raise LetterError(f"A word is letters without a space, but got {text!r}; teach.lines writes text with spaces.")
    return placed([hand.word(text, joined)], [(0.0, 0.0)], hand.scale(x_height), tempo)


@dataclass(frozen=True)
class Hand:
    """Who writes: the letters, standing on the line y = 0, and how tall they are.

    Args:
        glyph: The strokes of a character [m].
        x_height: Of those letters [m].
    """

    glyph: Callable[[str], Strokes]
    x_height: float

    @classmethod
    def of(cls, alphabet: str | None, letters: Mapping[str, Any] | None, settings: Settings | None) -> Self:
        """An alphabet's, with one's own letters in place of some."""
        if letters is not None and not isinstance(letters, Mapping):
            raise LetterError(f"letters is a {type(letters).__name__}, but must be {{'a': letter}}.")
        name, known = alphabet or alphabets()[0], characters(alphabet)
        own, kept = dict(letters or {}), {}

        def glyph(character: str) -> Strokes:
            if character not in kept:
                kept[character] = _glyph(character, name, known, own, settings)
            return kept[character]

        top = max(float(stroke.position[:, 1].max()) for stroke in _model("x", name, settings))
        return cls(glyph, top)

    def scale(self, x_height: float | None) -> float:
        """How much larger than the alphabet's the letters are to be."""
        if x_height is None:
            return 1.0
        if isinstance(x_height, bool) or not isinstance(x_height, int | float) or not 1e-4 <= x_height <= 1:
            raise LetterError(f"x_height is {x_height!r}, but must be a height from 0.0001 to 1 m, such as 0.01.")
        return float(x_height) / self.x_height

    def word(self, text: str, joined: bool) -> Strokes:
        """The strokes of one word in the size of the alphabet, from x = 0 on, each on the clock of its letter."""
        glyphs = [self.glyph(character) for character in text]
        bodies = [body_and_marks(character, glyph)[0] for character, glyph in zip(text, glyphs, strict=True)]
        links = [joined and self._links(*pair) for pair in pairwise(zip(text, bodies, strict=True))]
        steps = [
            linked_distance(glyphs[k : k + 2], bodies[k : k + 2], self.x_height)
            if link
            else distance(*glyphs[k : k + 2], self.x_height)
            for k, link in enumerate(links)
        ]
        moved = [
            tuple(_moved(stroke, (right, 0.0)) for stroke in glyph)
            for glyph, right in zip(glyphs, np.cumsum([0.0, *steps]), strict=True)
        ]
        strokes = self._joined(text, moved, links) if joined else [stroke for glyph in moved for stroke in glyph]
        left = min(float(stroke.position[:, 0].min()) for stroke in strokes)
        return tuple(_moved(stroke, (-left, 0.0)) for stroke in strokes)

    def _links(self, one: tuple[str, Strokes], other: tuple[str, Strokes]) -> bool:
        """Whether the pen goes from a letter (its character and body) to the next one on the paper."""
        return can_leave(*one, self.x_height) and can_arrive(*other, self.x_height)

    def _joined(self, text: str, glyphs: Sequence[Strokes], links: Sequence[bool]) -> list[Trajectory]:
        """Letters in place, joined where they link, then the marks from left to right."""
        strokes: list[Trajectory] = []
        marks: list[Trajectory] = []
        for character, glyph, link in zip(text, glyphs, [False, *links], strict=True):
            body, late = body_and_marks(character, glyph)
            marks += late
            if link:
                strokes[-1] = linked(strokes[-1], body[0], self.x_height)
            strokes += body[1:] if link else body
        return strokes + sorted(marks, key=lambda mark: float(mark.position[:, 0].min()))


def placed(words: Sequence[Strokes], spots: Sequence[tuple[float, float]], scale: float, tempo: float) -> Text:
    """Words in their places (the left end of each on its line [m]), one stroke after the other from 0 s on.

    Args:
        words: Each from x = 0 on, in the size of the alphabet.
        spots: A place for each.
        scale: How much larger than that they are to be.
        tempo: As in `word`.
    """
    if isinstance(tempo, bool) or not isinstance(tempo, int | float) or not 0 <= tempo <= 1:
        raise LetterError(
            f"tempo is {tempo!r}, but must be from 0 (the same time in every size) to 1 (the same speed)."
        )
    strokes: list[Trajectory] = []
    for own, spot in zip(words, spots, strict=True):
        for stroke in own:
            position, begin = stroke.position * scale + spot, 0.0
            if strokes:
                here, there = strokes[-1].position[-1], position[0]
                pause = pause_before(here / scale, there / scale) * scale**tempo
                begin = strokes[-1].t[-1] + max(pause, float(np.linalg.norm(there - here)) / FLYING)
            strokes.append(Trajectory((stroke.t - stroke.t[0]) * scale**tempo + begin, position))
    return Text(strokes)


def _glyph(character: str, alphabet: str, known: tuple[str, ...], own: Mapping[str, Any], settings: Any) -> Strokes:
    """A character on the line y = 0 in the size of the alphabet."""
    if character not in known:
        if character not in own:
            raise LetterError(f"The alphabet {alphabet!r} has no {character!r}; it has: {' '.join(known)}.")
        raise LetterError(
            f"There is a letter for {character!r}, but nobody knows how tall it is: the alphabet {alphabet!r} has none."
        )
    model = _model(character, alphabet, settings)
    return _as_tall(own[character], model, settings) if character in own else model


def _model(character: str, alphabet: str, settings: Settings | None) -> Strokes:
    """An alphabet's character, written by its primitives, on the line y = 0."""
    recording = recording_of(character, alphabet)
    down = (0.0, -(recording.baseline or 0.0))
    return tuple(_moved(stroke, down) for stroke in Letter.learn(recording, settings).write())


def _as_tall(given: Any, model: Iterable[Trajectory], settings: Settings | None) -> Strokes:
    """One's own letter from x = 0 on, as tall as the model and standing where it stands."""
    strokes = (given if isinstance(given, Letter) else Letter.learn(given, settings)).write()
    left = min(float(stroke.position[:, 0].min()) for stroke in strokes)
    low, high = _extent(strokes)
    ground, top = _extent(model)
    scale = (top - ground) / max(high - low, 1e-9)
    return tuple(Trajectory(s.t, (s.position - (left, low)) * scale + (0, ground)) for s in strokes)


def _extent(strokes: Iterable[Trajectory]) -> tuple[float, float]:
    y = np.concatenate([stroke.position[:, 1] for stroke in strokes])
    return float(y.min()), float(y.max())


def _moved(stroke: Trajectory, by: tuple[float, float]) -> Trajectory:
    return Trajectory(stroke.t, stroke.position + np.array(by))
