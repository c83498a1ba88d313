"""The letters that a text is written with, each on the writing line, connected to words."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Self
from unicodedata import normalize

from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError, kind_of
from dmp_teach.ink import SIGNS, alphabets, characters, recording_of, signs
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.text.connection_points import can_arrive, can_leave, split_marks
from dmp_teach.letters.text.connections import link_strokes
from dmp_teach.letters.text.spacing import Strokes, connected_spacing, letter_spacing, sign_spacing
from dmp_teach.scoring import LetterLike
from dmp_teach.trajectory import Trajectory, all_points

OwnLetters = Mapping[str, LetterLike]
PRINTED, TYPED = "\u2018\u2019\u201a\u201c\u201d\u201e\u2013\u2014\u2212", "'''\"\"\"---"
TYPED_FOR_PRINTED = str.maketrans({**dict(zip(PRINTED, TYPED, strict=True)), "\u2026": "..."})


def plain_text(text: str) -> str:
    """Return a text with composed accents, and typed quotation marks, dashes and ellipses."""
    return normalize("NFC", text).translate(TYPED_FOR_PRINTED)


@dataclass(frozen=True)
class Hand:
    """The letters of who writes, standing on the line y = 0.

    Args:
        glyph: Return the strokes of a character [m].
        x_height: Of those letters [m].
        lean: Of their stems, x gained for each y.
    """

    glyph: Callable[[str], Strokes]
    x_height: float
    lean: float

    @classmethod
    def of(
        cls, alphabet: str | None, letters: OwnLetters | None, settings: Settings | None
    ) -> Self:
        """Return the hand of an alphabet, with one's own letters in place of some."""
        if letters is not None and not isinstance(letters, Mapping):
            raise LetterError(f"letters is {kind_of(letters)}, but must be {{'a': letter}}.")
        name, known = alphabet or alphabets()[0], characters(alphabet) + signs(alphabet)
        own: OwnLetters = letters or {}
        kept: dict[str, Strokes] = {}

        def glyph(character: str) -> Strokes:
            if character not in kept:
                kept[character] = _glyph(character, name, known, own, settings)
            return kept[character]

        top = float(all_points(_model("x", name, settings))[:, 1].max())
        stem = recording_of("I", name).strokes()[0].position
        across, up = stem[0] - stem[-1]
        return cls(glyph, top, float(across / up))

    def scale(self, x_height: float | None) -> float:
        """Return how much larger than the alphabet's the letters are to be."""
        if x_height is None:
            return 1.0
        is_number = isinstance(x_height, int | float) and not isinstance(x_height, bool)
        if not is_number or not 1e-4 <= x_height <= 1:
            raise LetterError(
                f"x_height is {x_height!r}, but must be a height from 0.0001 to 1 m, such as 0.01."
            )
        return float(x_height) / self.x_height

    def word(self, text: str, joined: bool) -> Strokes:
        """Return the strokes of a word in the size of the alphabet, from x = 0 on.

        Each stroke is on the clock of its letter.
        """
        if not isinstance(joined, bool):
            raise LetterError(f"joined is {joined!r}, but must be True or False.")
        text = plain_text(text)
        glyphs = [self.glyph(character) for character in text]
        bodies = [split_marks(*pair)[0] for pair in zip(text, glyphs, strict=True)]
        links = [
            joined and can_leave(*one, self.x_height) and can_arrive(*other, self.x_height)
            for one, other in pairwise(zip(text, bodies, strict=True))
        ]
        rights = self._places(text, glyphs, bodies, links)
        moved = [
            tuple(_moved(stroke, (right, 0.0)) for stroke in glyph)
            for glyph, right in zip(glyphs, rights, strict=True)
        ]
        strokes = self._connected(text, moved, links) if joined else [s for g in moved for s in g]
        return tuple(_moved(stroke, (-_left(strokes), 0.0)) for stroke in strokes)

    def _places(
        self, text: str, glyphs: Sequence[Strokes], bodies: Sequence[Strokes], links: Sequence[bool]
    ) -> list[float]:
        """Return how far to the right each letter stands."""
        rights = [0.0]
        for k, link in enumerate(links):
            left, right = glyphs[k], glyphs[k + 1]
            if text[k] in SIGNS or text[k + 1] in SIGNS:
                step = sign_spacing(left, right, self.x_height, self.lean)
            elif link:
                step = connected_spacing((left, right), bodies[k : k + 2], self.x_height)
            else:
                step = letter_spacing(left, right, self.x_height)
            place = rights[k] + step
            # A letter after a sign also keeps clear of the letter before that.
            before = [j for j in range(k) if text[j] not in SIGNS]
            if text[k] in SIGNS and before:
                clear = letter_spacing(glyphs[before[-1]], right, self.x_height)
                place = max(place, rights[before[-1]] + clear)
            rights.append(place)
        return rights

    def _connected(
        self, text: str, glyphs: Sequence[Strokes], links: Sequence[bool]
    ) -> list[Trajectory]:
        """Return the letters connected where they link; marks follow at signs and at the end."""
        strokes: list[Trajectory] = []
        marks: list[Strokes] = []
        for character, glyph, link in zip(text, glyphs, [False, *links], strict=True):
            body, late = split_marks(character, glyph)
            if character in SIGNS:
                strokes += _from_the_left(marks)
                marks = []
            if link:
                strokes[-1] = link_strokes(strokes[-1], body[0], self.x_height)
            strokes += body[1:] if link else body
            marks += [late] if late else []
        return strokes + _from_the_left(marks)


def _from_the_left(marks: Sequence[Strokes]) -> list[Trajectory]:
    """Return the dots, crosses and accents of letters, letter by letter."""
    return [stroke for mark in sorted(marks, key=_left) for stroke in mark]


def _left(strokes: Iterable[Trajectory]) -> float:
    return float(all_points(strokes)[:, 0].min())


def _glyph(
    character: str,
    alphabet: str,
    known: tuple[str, ...],
    own: OwnLetters,
    settings: Settings | None,
) -> Strokes:
    """Return a character on the line y = 0 in the size of the alphabet."""
    if character not in known:
        if character not in own:
            raise LetterError(
                f"The alphabet {alphabet!r} has no {character!r}; it has: {' '.join(known)}."
            )
        raise LetterError(
            f"There is a letter for {character!r}, but nobody knows how tall it is: the alphabet "
            f"{alphabet!r} has none."
        )
    model = _model(character, alphabet, settings)
    if character not in own:
        return model
    given = own[character]
    try:
        letter = given if isinstance(given, Letter) else Letter.learn(given, settings)
    except LetterError as error:
        raise LetterError(f"letters[{character!r}] cannot be written. {error}") from None
    return _as_tall(letter, model)


def _model(character: str, alphabet: str, settings: Settings | None) -> Strokes:
    """Return an alphabet's character, written by its primitives, on the line y = 0."""
    recording = recording_of(character, alphabet)
    down = (0.0, -(recording.baseline or 0.0))
    return tuple(_moved(stroke, down) for stroke in Letter.learn(recording, settings).write())


def _as_tall(letter: Letter, model: Iterable[Trajectory]) -> Strokes:
    """Return one's own letter from x = 0 on, as tall as the model and standing where it stands."""
    strokes = letter.write()
    left = _left(strokes)
    (low, high), (ground, top) = (
        (y.min(), y.max()) for y in (all_points(each)[:, 1] for each in (strokes, model))
    )
    scale = (top - ground) / max(high - low, 1e-9)
    return tuple(Trajectory(s.t, (s.position - (left, low)) * scale + (0, ground)) for s in strokes)


def _moved(stroke: Trajectory, by: tuple[float, float]) -> Trajectory:
    return Trajectory(stroke.t, stroke.position + by)
