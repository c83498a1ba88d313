"""A shelf of strokes: letters taken apart, each stroke under its name."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Self

from dmp_teach.arguments import checked
from dmp_teach.dmp import Settings, as_settings
from dmp_teach.errors import LetterError, kind_of
from dmp_teach.files import Saved
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.letter_json import piece_from_json, pieces_to_json
from dmp_teach.scoring import LetterLike


@dataclass(frozen=True)
class Shelf(Saved):
    """Strokes of letters, to make new letters from.

        shelf = Shelf.of(recording_of(character) for character in "Dlon")
        shelf["D"]            both strokes of the D
        shelf["D.2"]          its second stroke
        shelf["n.1"].cut()    the stem and the hump of an n
        shelf["n.1b"]         its second part, the hump

    Args:
        pieces: The strokes, letter by letter in the order of writing.
    """

    pieces: tuple[Piece, ...]

    file_kind = "shelf"

    @classmethod
    def of(
        cls,
        letters: Iterable[LetterLike] | Mapping[str, LetterLike],
        settings: Settings | None = None,
    ) -> Self:
        """Take letters apart into strokes.

        Args:
            letters: Recordings, which know their character and writer; or letters by character:
                `{"D": letter}`. A second one by the same writer replaces the first.
            settings: How strokes are learned; `Settings.star()` unless given.

        Raises:
            LetterError: Nothing, or a recording that does not know its character.
            SettingError: Settings that are none.
        """
        # Wrong settings are refused even where every letter has been learned already.
        as_settings(settings)
        found: dict[tuple[str, str | None], tuple[Piece, ...]] = {}
        for character, given, writer in _named(letters):
            letter = given if isinstance(given, Letter) else Letter.learn(given, settings)
            found[character, writer] = tuple(
                Piece(primitive, stroke, character, str(number), writer)
                for number, (primitive, stroke) in enumerate(
                    zip(letter.primitives, letter.strokes, strict=True), start=1
                )
            )
        if not found:
            raise LetterError(
                "A shelf is made of letters, but got none: Shelf.of([recording_of('D')])."
            )
        return cls(tuple(piece for pieces in found.values() for piece in pieces))

    @property
    def letters(self) -> tuple[str, ...]:
        """The characters that there are strokes of."""
        return tuple(dict.fromkeys(piece.character for piece in self.pieces))

    @property
    def writers(self) -> tuple[str | None, ...]:
        """The pseudonyms of the writers."""
        return tuple(dict.fromkeys(piece.writer for piece in self.pieces))

    @checked
    def by(self, writer: str | None) -> Self:
        """Return the strokes of one writer.

        Raises:
            LetterError: None of that writer; names those that there are.
        """
        own = tuple(piece for piece in self.pieces if piece.writer == writer)
        if not own:
            raise LetterError(
                f"There is no stroke by {writer!r} on this shelf; it has strokes by "
                f"{self._whose()}."
            )
        return type(self)(own)

    # Any: a piece for a stroke's name, a tuple of pieces for a letter's.
    def __getitem__(self, name: str) -> Any:
        """Return one stroke, "D.2", a part of one, "n.1b", or all strokes of a letter, "D".

        Raises:
            LetterError: Not on the shelf, or by several writers.
        """
        character, number = (
            (name[0], name[2:]) if isinstance(name, str) and name[1:2] == "." else (name, "")
        )
        own = [piece for piece in self.pieces if piece.character == character]
        if len({piece.writer for piece in own}) > 1:
            raise LetterError(
                f"{character!r} was written by {self._whose()}; ask shelf.by(writer)[{name!r}]."
            )
        if own and not number and name == character:
            return tuple(own)
        for piece in own:
            if piece.number == number:
                return piece
            if number[:-1] == piece.number:
                found = [part for part in piece.cut() if part.number == number]
                if found:
                    return found[0]
        raise LetterError(self._what_else(str(name)))

    def __contains__(self, name: object) -> bool:
        return name in self.letters or any(piece.name == name for piece in self.pieces)

    def __iter__(self) -> Iterator[Piece]:
        return iter(self.pieces)

    def __len__(self) -> int:
        return len(self.pieces)

    def __repr__(self) -> str:
        names = dict.fromkeys(piece.name for piece in self.pieces)
        return f"Shelf({', '.join(names)}; by {self._whose()})"

    # Any: what JSON holds.
    def _to_json(self) -> dict[str, Any]:
        return {"pieces": pieces_to_json(self.pieces)}

    @classmethod
    def _from_json(cls, content: dict[str, Any]) -> Self:
        return cls(tuple(map(piece_from_json, content["pieces"])))

    def _whose(self) -> str:
        return ", ".join("nobody known" if writer is None else writer for writer in self.writers)

    def _what_else(self, name: str) -> str:
        """Return a sentence with the nearest names."""
        names = list(dict.fromkeys(piece.name for piece in self.pieces))
        near = [each for each in names if each[0] == name[:1]] or get_close_matches(
            name, names, 6, 0.3
        )
        if not near:
            near = [each for each in names if each[0].lower() == name[:1].lower()]
        said = f"The nearest are {', '.join(near)}." if near else f"It has {', '.join(names)}."
        return f"There is no {name!r} on this shelf. {said}"


def _named(
    letters: Iterable[LetterLike] | Mapping[str, LetterLike],
) -> Iterator[tuple[str, LetterLike, str | None]]:
    """Yield character, letter or recording, and writer."""
    if isinstance(letters, Mapping):
        for name, letter in letters.items():
            yield name, letter, getattr(letter, "writer", None)
        return
    if not isinstance(letters, Iterable) or isinstance(letters, str):
        raise LetterError(
            f"A shelf is made of recordings, or of {{'D': letter}}, but got {kind_of(letters)}."
        )
    for letter in letters:
        character = getattr(letter, "character", None)
        if not isinstance(character, str) or len(character) != 1:
            raise LetterError(
                f"There is {kind_of(letter)} that does not say which character it is; "
                "give it by name: Shelf.of({'D': letter})."
            )
        yield character, letter, getattr(letter, "writer", None)
