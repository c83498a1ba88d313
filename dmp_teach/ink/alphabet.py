"""Our own alphabets: a recording a letter, `assets/alphabets/<alphabet>/<kind>_<letter>.json`."""

import re
from unicodedata import normalize

from dmp_teach.errors import RecordingError
from dmp_teach.ink.our_json import read_json
from dmp_teach.ink.recording import Recording
from dmp_teach.paths import ASSETS

FOLDER = ASSETS / "alphabets"
DEFAULT = "round"
KINDS = ("small", "capital", "digit")


def alphabets() -> tuple[str, ...]:
    """The names of our alphabets, the default one first.

    Raises:
        RecordingError: There is none: the assets are missing.
    """
    names = [folder.name for folder in FOLDER.glob("*") if any(folder.glob("*.json"))]
    if not names:
        raise RecordingError(f"There is no alphabet in {FOLDER}; make ours with `python3 assets/make_alphabets.py`.")
    return tuple(sorted(names, key=lambda name: (name != DEFAULT, name)))


def characters(alphabet: str | None = None) -> tuple[str, ...]:
    """The letters of an alphabet: small ones, capitals, digits, then letters with accents in the same order.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    names = [file.name for file in (FOLDER / _known(alphabet)).glob("*.json")]
    found = sorted((not letter.isascii(), KINDS.index(kind), letter) for kind, letter in map(_read_name, names) if kind)
    return tuple(letter for _, _, letter in found)


def recording_of(character: str, alphabet: str | None = None) -> Recording:
    """A letter of one of our alphabets, as it was written.

    Args:
        character: One of `characters(alphabet)`; an accent may also be a sign of its own ("a" and U+0308 for "ä").
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No such alphabet, or no such letter in it; names those that there are.
    """
    name = _known(alphabet)
    known = characters(name)
    if not isinstance(character, str) or normalize("NFC", character) not in known:
        raise RecordingError(f"The alphabet {name!r} has no {character!r}; it has: {' '.join(known)}.")
    return read_json(FOLDER / name / file_name(character))


def file_name(character: str) -> str:
    """Where a letter stands in its alphabet: `small_a.json`, `capital_A.json`, `small_u00e4.json` ("ä", by its number).

    In plain ASCII, and different even where file names ignore capitals.

    Raises:
        RecordingError: Not a letter or digit.
    """
    letter = normalize("NFC", character) if isinstance(character, str) else ""
    if len(letter) != 1 or not letter.isalnum():
        raise RecordingError(f"character is {character!r}, but must be one letter or digit, such as 'a'.")
    kind = "digit" if letter.isdigit() else "capital" if letter.isupper() else "small"
    return f"{kind}_{letter if letter.isascii() else f'u{ord(letter):04x}'}.json"


def _read_name(name: str) -> tuple[str, str]:
    """The kind and the letter of a file's name, both empty where `file_name` gives no such name."""
    kind, _, letter = name.removesuffix(".json").partition("_")
    if re.fullmatch("u[0-9a-f]{4,5}", letter):
        letter = chr(int(letter[1:], 16))
    if len(letter) == 1 and letter.isalnum() and file_name(letter) == name:
        return kind, letter
    return "", ""


def _known(alphabet: str | None) -> str:
    """The name of an alphabet that exists."""
    names = alphabets()
    if alphabet is None:
        return names[0]
    if not isinstance(alphabet, str) or alphabet not in names:
        raise RecordingError(f"There is no alphabet {alphabet!r}; there are: {', '.join(names)}.")
    return alphabet
