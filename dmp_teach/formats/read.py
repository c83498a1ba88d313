"""Read recordings: what is in a file tells how it is read."""

from __future__ import annotations

import os
from collections import Counter
from dataclasses import replace
from pathlib import Path

from dmp_teach.errors import RecordingError, TrajectoryError
from dmp_teach.files import contents
from dmp_teach.formats.registry import CaptureOptions, Format, known_formats
from dmp_teach.formats.strangers import describe_stranger, describe_text
from dmp_teach.ink import Recording

LETTERS_IN_A_SENTENCE = 60


def read_recording(
    path: str | os.PathLike[str],
    marker: str | None = None,
    up: str = "+y",
    right: str = "-x",
    *,
    number: int | None = None,
    which: str | None = None,
    character: str | None = None,
    writer: str | None = None,
) -> Recording:
    """Read one letter from a file.

    Motion capture (Motive CSV), digital ink (InkML, UNIPEN), the field's reference sets (Character
    Trajectories and LASA, `.mat`), drawings (SVG), JSON of ours, and tables of t, x, y, and z or
    pressure (text, NumPy): what is in the file decides, not its name. The recording stands in
    the frame of its page: x to the right, y up the page, z out of it, the origin at the lower left
    corner of the ink (a file of ours says where it is). A CSV keeps its clock; it begins with the
    first stroke and ends with the last one, gaps are filled with straight lines, and nothing is
    smoothed. Flat ink begins at 0 s, keeps its strokes, and gets lifts between them. What is
    doubtful, or was guessed, is in the recording's `notes`.

    Args:
        path: The file. From a name such as `a_w01.csv` come the letter "a" and the writer "w01" of
            a CSV.
        marker: In a CSV, the name of the marker at the pen; None finds it.
        up: In a CSV, the direction out of the paper in the cameras' world, one of +x -x +y -y +z
            -z.
        right: In a CSV, the direction to the right on the page.
        number: Which letter of a file that holds several, from 0; with `which`, which one of those.
        which: Which letter of a file that holds several, such as "a".
        character: The letter that was meant, where the file does not say it.
        writer: A pseudonym of the writer, where the file does not say it.

    Raises:
        RecordingError: What is wrong, in which file and where in it, and what would work; a file
            that holds several letters, and which ones; or a label that is not the file's own.
    """
    letters = read_recordings(path, marker, up, right)
    name = Path(path).name
    matching = [each for each in letters if which is None or each.character == which]
    if not matching:
        raise RecordingError(f"{name} has no {which!r}; it holds {_listed(letters)}.")
    last = len(matching) - 1
    if number is None and last > 0:
        of = "" if which is None else f" of {which!r}"
        others = f" or which=...: {_listed(letters)}" if which is None else ""
        raise RecordingError(
            f"{name} holds {last + 1} letters{of}; choose with number=0 to {last}{others}."
        )
    if number is not None and (type(number) is not int or not 0 <= number <= last):
        raise RecordingError(
            f"number is {number!r}, but {name} has the letters 0 to {last} to choose from."
        )
    return _labelled(matching[number or 0], name, character=character, writer=writer)


def read_recordings(
    path: str | os.PathLike[str], marker: str | None = None, up: str = "+y", right: str = "-x"
) -> tuple[Recording, ...]:
    """Read all letters of a file, in its order; arguments and errors as `read_recording`."""
    data, name = contents(path)
    kind = _format_of(data, name)
    try:
        return tuple(kind.read(data, name, CaptureOptions(marker, up, right)))
    except (RecordingError, TrajectoryError) as error:
        raise RecordingError(f"{name}: {error}") from None


def is_ink(path: str | os.PathLike[str]) -> bool:
    """Tell whether a file is of a format that is read, whatever its name; errors as above."""
    data, _ = contents(path)
    return any(each.sniff(data) for each in known_formats())


def _labelled(recording: Recording, name: str, **labels: str | None) -> Recording:
    """Return a recording with labels that its file does not have."""
    for label, given in labels.items():
        own = getattr(recording, label)
        if given is None or given == own:
            continue
        if not isinstance(given, str) or not given:
            raise RecordingError(f"{label} is {given!r}, but must be text.")
        # What a name alone says gives way.
        if own is not None and own not in Path(name).stem.split("_"):
            choose = f" To choose a letter of several, say which={given!r}."
            raise RecordingError(
                f"{label} is {given!r}, but {name} says {own!r}: a label is for what a file does "
                f"not say.{choose if label == 'character' else ''}"
            )
    return replace(
        recording,
        character=labels["character"] or recording.character,
        writer=labels["writer"] or recording.writer,
    )


def _format_of(data: bytes, name: str) -> Format:
    """Tell a file's format from what is in it."""
    for each in known_formats():
        if each.sniff(data):
            return each
    kinds = ", ".join(map(str, known_formats()))
    what, cure = describe_stranger(data) or (
        describe_text(data),
        "write the pen's places as a table with the columns t, x, y, or record it on the pad",
    )
    raise RecordingError(f"{name} looks like {what}, but ink is read from {kinds}: {cure}.")


def _listed(letters: tuple[Recording, ...]) -> str:
    """Return which letters there are, and how many of each, for a sentence."""
    counts = Counter(each.character for each in letters)
    shown = [
        f"{'without a label' if name is None else repr(name)}{f' ({count})' if count > 1 else ''}"
        for name, count in counts.items()
    ]
    more = ", ..." if len(shown) > LETTERS_IN_A_SENTENCE else ""
    return ", ".join(shown[:LETTERS_IN_A_SENTENCE]) + more
