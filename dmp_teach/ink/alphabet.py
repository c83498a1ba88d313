"""Our own alphabets: a recording for each letter or sign, in `assets/alphabets/<alphabet>`."""

from __future__ import annotations

import re
from unicodedata import name, normalize

from dmp_teach.errors import RecordingError
from dmp_teach.files import ASSETS
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.recording_json import read_json

ALPHABETS_FOLDER = ASSETS / "alphabets"
DEFAULT_ALPHABET = "round"
CHARACTER_KINDS = ("small", "capital", "digit")
SIGNS = ".,;:!?'\"-()¿¡«»+=/"


def alphabets() -> tuple[str, ...]:
    """Return the names of our alphabets, the default one first.

    Raises:
        RecordingError: There is none: the assets are missing.
    """
    names = [folder.name for folder in ALPHABETS_FOLDER.glob("*") if any(folder.glob("*.json"))]
    if not names:
        raise RecordingError(
            f"There is no alphabet in {ALPHABETS_FOLDER}; make ours with "
            "`python3 assets/make_alphabets.py`."
        )
    return tuple(sorted(names, key=lambda name: (name != DEFAULT_ALPHABET, name)))


def characters(alphabet: str | None = None) -> tuple[str, ...]:
    """Return the letters of an alphabet: small ones, capitals, digits, then those with accents.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    found = [(kind, letter) for kind, letter in _files(alphabet) if kind in CHARACTER_KINDS]
    return tuple(
        letter
        for _, letter in sorted(
            found, key=lambda f: (not f[1].isascii(), CHARACTER_KINDS.index(f[0]), f[1])
        )
    )


def signs(alphabet: str | None = None) -> tuple[str, ...]:
    """Return the signs of an alphabet, from the full stop to the slash.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    found = {sign for kind, sign in _files(alphabet) if kind == "sign"}
    return tuple(sign for sign in SIGNS if sign in found)


def recording_of(character: str, alphabet: str | None = None) -> Recording:
    """Return a letter of one of our alphabets, as it was written.

    Args:
        character: One of `characters(alphabet)` or `signs(alphabet)`; an accent may also be a sign
            of its own ("a" and U+0308 for "ä").
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No such alphabet, or no such letter in it; names those that there are.
    """
    folder = _check_alphabet(alphabet)
    known = characters(folder) + signs(folder)
    if not isinstance(character, str) or normalize("NFC", character) not in known:
        raise RecordingError(
            f"The alphabet {folder!r} has no {character!r}; it has: {' '.join(known)}."
        )
    return read_json(ALPHABETS_FOLDER / folder / file_name(character))


def file_name(character: str) -> str:
    """Return the file of a letter: `small_a.json`, `capital_A.json` or `small_u00e4.json` ("ä").

    Signs go by their names in Unicode: `sign_full_stop.json`. All in plain ASCII, and different
    even where file names ignore capitals.

    Raises:
        RecordingError: Not a letter, a digit or one of our signs.
    """
    letter = normalize("NFC", character) if isinstance(character, str) else ""
    if len(letter) == 1 and letter in SIGNS:
        return f"sign_{name(letter).lower().replace(' ', '_')}.json"
    if len(letter) != 1 or not letter.isalnum():
        raise RecordingError(
            f"character is {character!r}, but must be one letter or digit, such as 'a', or of "
            f"{SIGNS}"
        )
    kind = "digit" if letter.isdigit() else "capital" if letter.isupper() else "small"
    return f"{kind}_{letter if letter.isascii() else f'u{ord(letter):04x}'}.json"


def _files(alphabet: str | None) -> list[tuple[str, str]]:
    """Return the kind and the letter of every file of an alphabet that has them."""
    found = (
        _read_name(file.name)
        for file in (ALPHABETS_FOLDER / _check_alphabet(alphabet)).glob("*.json")
    )
    return [(kind, letter) for kind, letter in found if kind]


def _read_name(file: str) -> tuple[str, str]:
    """Return the kind and letter of a file's name, both empty where `file_name` gives none such."""
    kind, _, letter = file.removesuffix(".json").partition("_")
    if kind == "sign":
        letter = next((sign for sign in SIGNS if file_name(sign) == file), "")
    elif re.fullmatch("u[0-9a-f]{4,5}", letter):
        letter = chr(int(letter[1:], 16))
    if len(letter) == 1 and (letter.isalnum() or letter in SIGNS) and file_name(letter) == file:
        return kind, letter
    return "", ""


def _check_alphabet(alphabet: str | None) -> str:
    """Return the name of an alphabet that exists."""
    names = alphabets()
    if alphabet is None:
        return names[0]
    if not isinstance(alphabet, str) or alphabet not in names:
        raise RecordingError(f"There is no alphabet {alphabet!r}; there are: {', '.join(names)}.")
    return alphabet
