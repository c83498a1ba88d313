"""Our own alphabets, and recordings as plain JSON: `assets/alphabets/<alphabet>/<kind>_<letter>.json`.

The format, version 1, is one object: what it is, the letter, the writer's pseudonym, the writing line [m], the
strokes as pairs of samples (or null: found from the height), the pen's pressure (or null), and a row t [s], x, y,
z [m] a sample. It has no place for a name, a date or a time of day.
"""

import json
import math
import os
import secrets
from pathlib import Path
from typing import Any

from dmp_teach.errors import RecordingError
from dmp_teach.ink.recording import Recording
from dmp_teach.paths import ASSETS

FOLDER = ASSETS / "alphabets"
DEFAULT = "round"
KINDS = ("small", "capital", "digit")
FORMAT = "dmp_teach recording"
VERSION = 1
UNITS = {"t": "s", "x": "m", "y": "m", "z": "m"}
FIELDS = ("format", "version", "character", "writer", "baseline", "units", "strokes", "pressure", "samples")


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


def read_json(path: str | os.PathLike[str]) -> Recording:
    """A recording from a file that `write_json` wrote; pressure is checked, and left in the file.

    Raises:
        RecordingError: No such file, another format or version, or a field that cannot be; says which.
    """
    path = _path(path)
    try:
        content = json.loads(path.read_text(encoding="utf-8"), parse_constant=_no_constant)
    except OSError as error:
        raise RecordingError(f"{path} cannot be read: {error.strerror or error}.") from None
    except (ValueError, RecursionError) as error:
        raise RecordingError(f"{path.name} is not plain JSON: {error}.") from None
    try:
        return _recording(content)
    except RecordingError as error:
        raise RecordingError(f"{path.name}: {error}") from None


def write_json(recording: Recording, path: str | os.PathLike[str]) -> None:
    """Write a recording as plain JSON, whole or not at all: a file that was there stays until the new one is complete.

    Raises:
        RecordingError: Not a recording, or the file cannot be written there.
    """
    if not isinstance(recording, Recording):
        raise RecordingError(f"write_json got a {type(recording).__name__}, but writes a Recording.")
    path, text = _path(path), _text(recording)
    part = path.with_name(f".{path.name}.{secrets.token_hex(4)}.part")
    try:
        with part.open("x", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    except OSError as error:
        reason = error.strerror or error
        raise RecordingError(f"{path} cannot be written: {reason}. What was there is unchanged.") from None
    finally:
        part.unlink(missing_ok=True)


def _known(alphabet: str | None) -> str:
    """The name of an alphabet that exists."""
    names = alphabets()
    if alphabet is None:
        return names[0]
    if not isinstance(alphabet, str) or alphabet not in names:
        raise RecordingError(f"There is no alphabet {alphabet!r}; there are: {', '.join(names)}.")
    return alphabet


def _path(path: str | os.PathLike[str]) -> Path:
    """A path, or a sentence that says that it is none."""
    if not isinstance(path, str | os.PathLike):
        raise RecordingError(f"path is {path!r}, but must be the name of a file, such as 'a.json'.")
    return Path(path)


def _no_constant(word: str) -> None:
    """Refuse NaN and Infinity, which JSON does not have."""
    raise ValueError(f"{word} is not a number")


def _text(recording: Recording) -> str:
    """A recording as JSON: a field a line, a sample a line, every digit kept."""
    head = {
        "format": FORMAT,
        "version": VERSION,
        "character": recording.character,
        "writer": recording.writer,
        "baseline": recording.baseline,
        "units": UNITS,
        "strokes": recording.given_strokes,
        "pressure": None,
    }
    lines = [f"{json.dumps(name)}: {json.dumps(value, ensure_ascii=False)}" for name, value in head.items()]
    rows = zip(recording.t.tolist(), recording.position.tolist(), strict=True)
    samples = ",\n".join(json.dumps([t, *position]) for t, position in rows)
    return "{\n" + ",\n".join(lines) + ',\n"samples": [\n' + samples + "\n]\n}\n"


def _recording(content: Any) -> Recording:
    """What the JSON says, every field checked."""
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise RecordingError(f"this is not one of our recordings: 'format' must be {FORMAT!r}.")
    version = content.get("version")
    if type(version) is not int or version != VERSION:
        raise RecordingError(f"version is {version!r}, but this program reads version {VERSION}; update dmp_teach.")
    odd = [name for name in (*FIELDS, *content) if (name in FIELDS) != (name in content)]
    if odd:
        raise RecordingError(f"has fields too many or too few: {', '.join(odd)}; there must be: {', '.join(FIELDS)}.")
    if content["units"] != UNITS:
        raise RecordingError(f"units is {content['units']!r}, but must be {UNITS!r}.")
    for name in ("character", "writer"):
        _must(content[name] is None or isinstance(content[name], str), name, content[name], "text or null")
    baseline, strokes = content["baseline"], content["strokes"]
    _must(baseline is None or _is_number(baseline), "baseline", baseline, "a number [m] or null")
    _must(strokes is None or _are_pairs(strokes), "strokes", strokes, "pairs [start, end] of whole numbers or null")
    samples = _samples(content["samples"])
    pressure = content["pressure"]
    fits = isinstance(pressure, list) and len(pressure) == len(samples) and all(map(_is_number, pressure))
    _must(pressure is None or fits, "pressure", pressure, "null or one number for every sample")
    return Recording(
        [row[0] for row in samples],
        [row[1:] for row in samples],
        content["character"],
        content["writer"],
        baseline,
        None if strokes is None else tuple(map(tuple, strokes)),
    )


def _samples(rows: Any) -> list[list[float]]:
    """The rows t, x, y, z, all numbers."""
    _must(isinstance(rows, list), "samples", rows, "rows [t, x, y, z]")
    for k, row in enumerate(rows):
        good = isinstance(row, list) and len(row) == len(UNITS) and all(map(_is_number, row))
        _must(good, f"samples[{k}]", row, "four finite numbers [t, x, y, z]")
    return rows


def _must(holds: bool, name: str, value: Any, rule: str) -> None:
    """Raise a RecordingError that shows the beginning of the value, unless the rule holds."""
    if not holds:
        shown = repr(value)
        raise RecordingError(f"{name} is {shown[:60] + '...' if len(shown) > 60 else shown}, but must be {rule}.")


def _is_number(value: Any) -> bool:
    """A finite number; True and False are none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) < 1e300 and math.isfinite(value)


def _are_pairs(strokes: Any) -> bool:
    """A list of pairs of whole numbers."""
    return isinstance(strokes, list) and all(
        isinstance(pair, list) and len(pair) == 2 and all(type(edge) is int and abs(edge) < 2**62 for edge in pair)
        for pair in strokes
    )
