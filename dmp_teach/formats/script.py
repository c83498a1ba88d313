"""Take a school's own script: letters that a teacher drew on the pad, or gives as drawings."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from unicodedata import normalize
from xml.etree.ElementTree import Element, tostring

import numpy as np

from dmp_teach.arguments import warn_caller
from dmp_teach.errors import RecordingError
from dmp_teach.files import contents
from dmp_teach.formats.read import read_recordings
from dmp_teach.formats.registry import CaptureOptions, known_formats
from dmp_teach.formats.safe_xml import has_root, local_tag, parse_xml
from dmp_teach.formats.svg.reader import read_svg
from dmp_teach.formats.svg.shapes import SHAPES
from dmp_teach.ink import (
    DEFAULT_ALPHABET,
    SIGNS,
    Recording,
    characters,
    install_script,
    recording_of,
)
from dmp_teach.trajectory import Array, all_points

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
FARTHEST_INK = 0.5  # how far from its corner the ink of a letter may be, made as high as ours [m]


def use_script(path: str | os.PathLike[str] | None) -> tuple[str, ...]:
    """Let every lesson, pad and score use a school's own letters from now on.

    They are made as high as ours by one factor for all. A letter that has a writing line stands on
    it, any other as ours stands. Letters that the school does not give stay ours.

    Args:
        path: A folder of recordings, one letter each, that say which letter they are or are named
            after it ("a.svg", "a_w01.json", of which the last counts); or one file with many
            letters, such as an SVG with a group for each, named after its letter. None for ours.

    Returns:
        The letters that were found.

    Raises:
        RecordingError: A letter that cannot be read, or is far larger than the others, or no
            letter at all; the letters that were in use stay.
    """
    if path is None:
        install_script("", {})
        _forget_other_letters()
        return ()
    found = {letter: each for each in _read_letters(path) if (letter := _letter_in(each.character))}
    if not found:
        raise RecordingError(
            f"There is no letter in {Path(path).name}: name files or groups after their "
            "letters, such as 'a.svg'."
        )
    install_script(Path(path).stem, _placed(found))
    _forget_other_letters()
    return tuple(sorted(found))


def _letter_in(name: str | None) -> str | None:
    """Return the one letter, digit or sign that a name is; None for any other."""
    letter = normalize("NFC", name or "")
    return letter if len(letter) == 1 and (letter.isalnum() or letter in SIGNS) else None


def _read_letters(path: str | os.PathLike[str]) -> Iterator[Recording]:
    """Yield the letters of a folder or a file, each of which says which it is."""
    if not isinstance(path, str | os.PathLike) or not os.path.isdir(path):
        data, name = contents(path)
        is_drawing = has_root(data, tag="svg")
        yield from (_groups(data, name) if is_drawing else read_recordings(path))
        return
    suffixes = {suffix for each in known_formats() for suffix in each.suffixes}
    for file in sorted(Path(path).iterdir(), key=lambda file: (len(file.name), file.name)):
        if file.suffix.lower() in suffixes and not file.name.startswith("."):
            named = _letter_in(file.stem.split("_")[0])
            try:
                letters = read_recordings(file)
            except RecordingError as error:
                if named:
                    raise
                warn_caller(f"Left out, as no letter: {error}", calls=2)
                continue
            for each in letters:
                yield replace(each, character=each.character or named)


def _groups(data: bytes, name: str) -> Iterator[Recording]:
    """Yield the letters of a drawing: its groups that are named after one."""
    letter = ""
    try:
        root = parse_xml(data, "svg", "a drawing")
        for letter in _letters_alone(root, root):
            (recording,) = read_svg(tostring(root), name, CaptureOptions())
            yield replace(recording, character=letter)
    except RecordingError as error:
        raise RecordingError(f"{letter} in {name}: {error}".removeprefix(" in ")) from None


def _letters_alone(root: Element, within: Element) -> Iterator[str]:
    """Yield the letters of a drawing, or of a layer of it; of the groups it then has only one."""
    whole = within[:]
    around = [each for each in whole if local_tag(each) not in {"g", "use", *SHAPES}]
    for group in whole:
        if local_tag(group) == "g":
            within[:] = [*around, group]
            title = next((each.text for each in group if local_tag(each) == "title"), None)
            names = (title, group.get(LABEL), group.get("id"))
            letter = next((each for each in map(_letter_in, names) if each), None)
            if letter:
                yield letter
            else:
                yield from _letters_alone(root, group)
    within[:] = whole


def _placed(letters: dict[str, Recording]) -> dict[str, Recording]:
    """Return letters as high as ours, on the writing line y = 0."""
    known = letters.keys() & set(characters(DEFAULT_ALPHABET))
    boxes = {letter: _box(recording) for letter, recording in letters.items()}
    ours = {letter: _box(recording_of(letter, DEFAULT_ALPHABET)) for letter in known}
    heights = [[float(np.ptp(box[:, 1])) for box in (ours[each], boxes[each])] for each in ours]
    factor = float(np.median([our / its for our, its in heights if its > 0] or [1.0]))
    placed = {}
    for letter, recording in letters.items():
        low = factor * boxes[letter][0]
        stands = ours[letter][0] if letter in ours else np.zeros(2)
        line = low[1] - stands[1] if recording.baseline is None else factor * recording.baseline
        shift = np.array([stands[0] - low[0], -line, 0.0])
        position = recording.position * [factor, factor, 1.0] + shift
        if not np.abs(position).max() <= FARTHEST_INK:
            raise RecordingError(
                f"{letter!r} would be {np.ptp(position, axis=0).max():.3g} m large, or as far from "
                f"its line, where the others are as high as ours; at most {FARTHEST_INK} m: draw "
                "all letters as high and wide as they are beside one another."
            )
        placed[letter] = replace(recording, position=position, baseline=0.0)
    return placed


def _box(recording: Recording) -> Array:
    """Return the lowest and the highest corner of the ink, shape (2, 2) [m]."""
    ink = all_points(recording.strokes())
    return np.stack([ink.min(axis=0), ink.max(axis=0)])


def _forget_other_letters() -> None:
    """Clear what was computed of other letters, wherever it is kept."""
    for name, module in list(sys.modules.items()):
        if name.startswith("dmp_teach."):
            for value in list(vars(module).values()):
                clear = getattr(value, "cache_clear", None)
                if clear is not None and getattr(value, "__module__", "") == name:
                    clear()
