"""Read recordings: what is in a file tells how it is read."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

from dmp_teach.errors import RecordingError
from dmp_teach.files import contents
from dmp_teach.formats.inkml.reader import read_inkml
from dmp_teach.formats.mat.parser import HDF5
from dmp_teach.formats.mat.reader import read_sets
from dmp_teach.formats.motive.reader import read_motive
from dmp_teach.formats.safe_xml import local, parsed
from dmp_teach.formats.svg.reader import read_svg
from dmp_teach.ink import Recording, recording_from_json

XML = {"ink": read_inkml, "svg": read_svg}
SHOWN = 60  # letters that an error names


def read_recording(
    path: str | os.PathLike[str],
    marker: str | None = None,
    up: str = "+y",
    right: str = "-x",
    *,
    number: int | None = None,
    character: str | None = None,
) -> Recording:
    """The letter that somebody wrote, from a file.

    Motion capture (Motive CSV), digital ink (InkML), the field's reference sets (Character Trajectories and LASA,
    `.mat`), drawings (SVG), and JSON of ours: what is in the file decides, not its name. The recording stands in the
    frame of its page: x to the right, y up the page, z out of it, the origin at the lower left corner of the ink (a
    file of ours says where it is). A CSV keeps its clock; it begins with the first stroke and ends with the last one,
    gaps are filled with straight lines, and nothing is smoothed. Flat ink begins at 0 s, keeps its strokes, and gets
    lifts between them.

    Args:
        path: The file. From a name such as `a_w01.csv` come the letter "a" and the writer "w01" of a CSV.
        marker: In a CSV, the name of the marker at the pen; None finds it.
        up: In a CSV, the direction out of the paper in the cameras' world, one of +x -x +y -y +z -z.
        right: In a CSV, the direction to the right on the page.
        number: Which letter of a file that holds several, from 0; with `character`, which one of those.
        character: Which letter of a file that holds several.

    Raises:
        RecordingError: What is wrong, in which file and where in it, and what would work; or a file that holds several
            letters, and which ones.
    """
    letters = read_recordings(path, marker, up, right)
    name = Path(path).name
    places = [
        k for k, each in enumerate(letters) if character is None or each.character == character
    ]
    if not places:
        raise RecordingError(f"{name} has no {character!r}; it holds {_held(letters)}.")
    most = len(places) - 1
    if number is None and most > 0:
        of, others = (
            (f" of {character!r}", "")
            if character is not None
            else ("", f" or character=...: {_held(letters)}")
        )
        raise RecordingError(
            f"{name} holds {most + 1} letters{of}; choose with number=0 to {most}{others}."
        )
    if number is not None and (type(number) is not int or not 0 <= number <= most):
        raise RecordingError(
            f"number is {number!r}, but {name} has the letters 0 to {most} to choose from."
        )
    return letters[places[number or 0]]


def read_recordings(
    path: str | os.PathLike[str], marker: str | None = None, up: str = "+y", right: str = "-x"
) -> tuple[Recording, ...]:
    """All letters of a file, in its order; arguments and errors as `read_recording`."""
    data, name = contents(path)
    kind = _kind(data, name)
    if kind == "csv":
        return (read_motive(data, name, marker, up, right),)
    if kind == "json":
        return (recording_from_json(data, name),)
    try:
        return read_sets(data, name) if kind == "mat" else _read_xml(data)
    except RecordingError as error:
        raise RecordingError(f"{name}: {error}") from None


def _kind(data: bytes, name: str) -> str:
    """What a file is: told from its beginning, and from its name where that says nothing."""
    if data.startswith((b"MATLAB", HDF5)) or data[512:520] == HDF5:
        return "mat"
    begin = data[:1000].removeprefix(b"\xef\xbb\xbf").lstrip()
    wide = data[:2] in (b"\xff\xfe", b"\xfe\xff") and data[2:6].strip(b"\0").startswith(b"<")
    if begin.startswith(b"<") or wide:
        return "xml"
    if begin.startswith((b"{", b"[")):
        return "json"
    suffix = Path(name).suffix.lower()
    return {".json": "json", ".mat": "mat", ".inkml": "xml", ".svg": "xml", ".xml": "xml"}.get(
        suffix, "csv"
    )


def _read_xml(data: bytes) -> tuple[Recording, ...]:
    """InkML or SVG, told by the root element."""
    root = parsed(data)
    if local(root) not in XML:
        raise RecordingError(
            f"is XML of the kind {local(root)[:40]!r}, but must be InkML (ink) or a drawing (svg)."
        )
    return XML[local(root)](root)


def _held(letters: tuple[Recording, ...]) -> str:
    """Which letters there are, and how many of each."""
    counts = Counter(each.character for each in letters)
    shown = [
        f"{'without a label' if name is None else repr(name)}{f' ({count})' if count > 1 else ''}"
        for name, count in counts.items()
    ]
    return ", ".join(shown[:SHOWN]) + (", ..." if len(shown) > SHOWN else "")
