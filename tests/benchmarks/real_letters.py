"""Are writers told apart, and is their style kept, on letters of many real people?

    python -m tests.benchmarks.real_letters FOLDER [--provider aga]

FOLDER is the UNIPEN collection train_r01_v07 (Guyon, Schomaker, Plamondon, Liberman, Janet 1994,
UNIPEN project of on-line data exchange and recognizer benchmarks;
https://doi.org/10.5281/zenodo.1195803), with its folders `data` and `include`. It is not ours to
give on. A provider's files hold one writer each, who wrote every letter several times; writers are
numbered, for some files are called by their names.
"""

import argparse
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from dmp_teach.studies.authorship.answers import Attributions
from dmp_teach.studies.authorship.made import attribute_made_letters
from dmp_teach.studies.authorship.real import classify_writers
from dmp_teach.studies.inputs import Written
from dmp_teach.trajectory import Trajectory

INCH = 0.0254  # [m]
KINDS = ("1a", "1b", "1c")  # digits, capitals and small letters that stand alone
SEGMENT = re.compile(r'\.SEGMENT CHARACTER (\d+)(?:-(\d+))? (\S+) "(.)"')
LIFT = 0.3  # between two strokes; the files do not say how long it took [s]


def letters(folder: Path, provider: str) -> list[Written]:
    """Every labelled letter of a provider's writers, but those that the labels call bad."""
    names = sorted(
        {file.name for kind in KINDS for file in (folder / "data" / kind / provider).glob("*.dat")}
    )
    found = []
    for number, name in enumerate(names):
        lines = components(folder / "include" / provider / "data" / name)
        for kind in KINDS:
            labels = folder / "data" / kind / provider / name
            if labels.exists():
                found += list(_labelled(labels, lines, f"u{number:02}"))
    return found


def components(file: Path) -> list[Trajectory | None]:
    """Strokes between pen down and pen up [m], each from 0 s on; None for a single point."""
    points: list[list[list[float]]] = []
    scale, rate, down = np.array([1000.0, 1000.0]), 100.0, False
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines():
        words = line.split()
        if line.startswith("."):
            down = words[0] == ".PEN_DOWN"
            points += [[]] if down else []
            if words[0] in (".X_POINTS_PER_INCH", ".Y_POINTS_PER_INCH"):
                scale[int(words[0][1] == "Y")] = float(words[1])
            if words[0] == ".POINTS_PER_SECOND":
                rate = float(words[1])
        elif down and len(words) >= 2:
            points[-1].append([float(word) for word in words[:2]])
    drawn = [np.array(each) / scale * INCH for each in points]
    return [
        Trajectory(np.arange(len(each)) / rate, each) if len(each) > 1 else None for each in drawn
    ]


def _labelled(file: Path, lines: list[Trajectory | None], writer: str) -> Iterator[Written]:
    """The letters that a file of labels names."""
    for label in file.read_text(encoding="utf-8", errors="replace").splitlines():
        match = SEGMENT.match(label)
        if match and match[3] != "BAD":
            first, last = int(match[1]), int(match[2] or match[1])
            strokes, begin = [], 0.0
            for stroke in filter(None, lines[first : last + 1]):
                strokes.append(Trajectory(stroke.t + begin, stroke.position))
                begin = strokes[-1].t[-1] + LIFT
            if any(np.ptp(stroke.position, axis=0).max() > 0 for stroke in strokes):
                yield Written(match[4], writer, tuple(strokes))


def asked(found: list[Written]) -> dict[str, Attributions]:
    """All that the studies ask, by words for them."""
    bowls = [each for each in found if each.character in "DB"]
    return {
        "Real letters, told apart": classify_writers(found),
        "Bowls that were led, beside bowls": attribute_made_letters(bowls, 4),
    }


def main(arguments: list[str] | None = None) -> None:
    """Read, ask, print."""
    options = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.real_letters", description=__doc__.split("\n")[0]
    )
    options.add_argument("folder", type=Path, help="UNIPEN train_r01_v07")
    options.add_argument("--provider", default="aga", help="whose files (default aga: 14 writers)")
    given = options.parse_args(arguments)
    found = letters(given.folder, given.provider)
    if not found:
        options.error(
            f"{given.folder} holds no letters by {given.provider!r}; is it UNIPEN train_r01_v07?"
        )
    print(f"{len(found)} letters by {len({each.writer for each in found})} writers")
    for words, answers in asked(found).items():
        print(f"\n{words}\n{answers}")


if __name__ == "__main__":
    main()
