"""Our own alphabets: a recording a letter, `assets/alphabets/<alphabet>/<kind>_<letter>.json`."""

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
    """The letters of an alphabet: small ones, capitals, then digits.

    Args:
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No alphabet of that name; names those that there are.
    """
    stems = [file.stem for file in (FOLDER / _known(alphabet)).glob("*.json")]
    parts = [(kind, letter) for kind, _, letter in (stem.partition("_") for stem in stems)]
    found = sorted((KINDS.index(kind), letter) for kind, letter in parts if kind in KINDS and len(letter) == 1)
    return tuple(letter for _, letter in found)


def recording_of(character: str, alphabet: str | None = None) -> Recording:
    """A letter of one of our alphabets, as it was written.

    Args:
        character: One of `characters(alphabet)`.
        alphabet: One of `alphabets()`; None is the first.

    Raises:
        RecordingError: No such alphabet, or no such letter in it; names those that there are.
    """
    name = _known(alphabet)
    known = characters(name)
    if not isinstance(character, str) or character not in known:
        raise RecordingError(f"The alphabet {name!r} has no {character!r}; it has: {' '.join(known)}.")
    return read_json(FOLDER / name / file_name(character))


def file_name(character: str) -> str:
    """Where a letter stands in its alphabet; "a" and "A" differ even where file names ignore capitals.

    Raises:
        RecordingError: Not a letter or digit.
    """
    if isinstance(character, str) and len(character) == 1 and character.isalnum():
        kind = "digit" if character.isdigit() else "capital" if character.isupper() else "small"
        return f"{kind}_{character}.json"
    raise RecordingError(f"character is {character!r}, but must be one letter or digit, such as 'a'.")


def _known(alphabet: str | None) -> str:
    """The name of an alphabet that exists."""
    names = alphabets()
    if alphabet is None:
        return names[0]
    if not isinstance(alphabet, str) or alphabet not in names:
        raise RecordingError(f"There is no alphabet {alphabet!r}; there are: {', '.join(names)}.")
    return alphabet
