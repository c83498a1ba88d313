"""Our own alphabets: a recording for each letter or sign, in `assets/alphabets/<alphabet>`."""

from __future__ import annotations

import re
from unicodedata import name, normalize

from dmp_teach.arguments import checked
from dmp_teach.errors import RecordingError
from dmp_teach.files import ASSETS
from dmp_teach.ink.left_hand import check_hand, pull_bars
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.recording_json import read_json

ALPHABETS_FOLDER = ASSETS / "alphabets"
DEFAULT_ALPHABET = "round"
# A school's own letters, by their character, under the name of their script.
_SCRIPTS: dict[str, dict[str, Recording]] = {}
SIGNS = ".,;:!?'\"-()¿¡«»+=/"


def alphabets() -> tuple[str, ...]:
    """Return the names of the alphabets: the school's script, if there is one, then ours.

    Raises:
        RecordingError: There is none: the assets are missing.
    """
    names = [folder.name for folder in ALPHABETS_FOLDER.glob("*") if any(folder.glob("*.json"))]
    if not names:
        raise RecordingError(
            f"There is no alphabet in {ALPHABETS_FOLDER}; make ours with "
            "`python3 assets/make_alphabets.py`."
        )
    return (*_SCRIPTS, *sorted(names, key=lambda name: (name != DEFAULT_ALPHABET, name)))


def install_script(name: str, letters: dict[str, Recording]) -> None:
    """Let a school's letters stand before ours, which go on for those that it lacks; {} ends it."""
    _SCRIPTS.clear()
    if letters:
        _SCRIPTS[name if name not in alphabets() else f"{name} script"] = letters


def characters(alphabet: str | None = None) -> tuple[str, ...]:
    """Return the letters of an alphabet: small ones, capitals, digits, then those with accents.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    letters = [letter for letter in _letters(alphabet) if letter not in SIGNS]

    def order(letter: str) -> tuple[bool, bool, bool, str]:
        return not letter.isascii(), letter.isdigit(), letter.isupper(), letter

    return tuple(sorted(letters, key=order))


def signs(alphabet: str | None = None) -> tuple[str, ...]:
    """Return the signs of an alphabet, from the full stop to the slash.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    letters = _letters(alphabet)
    return tuple(sign for sign in SIGNS if sign in letters)


@checked
def recording_of(character: str, alphabet: str | None = None, hand: str = "right") -> Recording:
    """Return a letter of one of our alphabets, as it was written.

    Args:
        character: One of `characters(alphabet)` or `signs(alphabet)`; an accent may also be a sign
            of its own ("a" and U+0308 for "ä").
        alphabet: One of `alphabets()`; None is the first.
        hand: "left" for bars from right to left, as left-handers are taught to pull those of
            t, f, A, E, F, H and T.

    Raises:
        RecordingError: No such alphabet, or no such letter in it; names those that there are.
        LetterError: No such hand.
    """
    check_hand(hand)
    folder = _check_alphabet(alphabet)
    known = characters(folder) + signs(folder)
    if not isinstance(character, str) or normalize("NFC", character) not in known:
        raise RecordingError(
            f"The alphabet {folder!r} has no {character!r}; it has: {' '.join(known)}."
        )
    recording = _SCRIPTS.get(folder, {}).get(normalize("NFC", character))
    if recording is None:
        name = DEFAULT_ALPHABET if folder in _SCRIPTS else folder
        recording = read_json(ALPHABETS_FOLDER / name / file_name(character))
    return pull_bars(recording) if hand == "left" else recording


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


def _letters(alphabet: str | None) -> set[str]:
    """Return the letters and signs of which an alphabet has a file."""
    name = _check_alphabet(alphabet)
    if name in _SCRIPTS:
        return _letters(DEFAULT_ALPHABET) | set(_SCRIPTS[name])
    files = {file.name for file in (ALPHABETS_FOLDER / name).glob("*.json")}
    codes = [re.fullmatch(r"[a-z]+_(?:u([0-9a-f]{4,5})|(\w))\.json", file) for file in files]
    letters = {chr(int(code[1], 16)) if code[1] else code[2] for code in codes if code}
    known = {letter for letter in letters if letter.isalnum()} | set(SIGNS)
    return {letter for letter in known if file_name(letter) in files}


def _check_alphabet(alphabet: str | None) -> str:
    """Return the name of an alphabet that exists."""
    names = alphabets()
    if alphabet is None:
        return names[0]
    if not isinstance(alphabet, str) or alphabet not in names:
        raise RecordingError(f"There is no alphabet {alphabet!r}; there are: {', '.join(names)}.")
    return alphabet
