"""How fast a class is read, cut into strokes, learned and scored, and whether a letter takes longer
in a larger class.

Every pupil writes all letters of one of our alphabets, deformed by lot: lean, width, size, pace and
a smooth bending of the page. The letters are files of ours in a folder, as a pad saves them; their
strokes are found from the height.
"""

import string
import tempfile
import tracemalloc
from collections.abc import Callable, Sequence
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

import dmp_teach as teach
from dmp_teach.ink.recording import Recording
from tests.benchmarks.measure import exponent
from tests.studies.pupils import bending

PUPILS = (1, 3, 10, 30)
CHARACTERS = string.ascii_letters + string.digits
ALPHABET = "round"


def classroom(pupils: Sequence[int] = PUPILS, characters: str = CHARACTERS) -> dict[str, Any]:
    """Seconds of every step by the number of pupils, their growth a letter, and memory."""
    models = {
        character: teach.recording_of(character, ALPHABET).strokes() for character in characters
    }
    with tempfile.TemporaryDirectory() as folder:
        files = [written(Path(folder), pupil, characters) for pupil in range(max(pupils))]
        taken(files[0], models)  # loads and warms up
        steps = _quickest(files, models, pupils)
        memory = _memory(lambda: taken(files[0], models)[1])
        takes = [teach.Letter.learn(teach.read_recording(own[0])) for own in files]
    whole = [sum(steps[count].values()) / count / len(characters) for count in pupils]
    return {
        "pupils": list(pupils),
        "letters": len(characters),
        "seconds": {name: [steps[count][name] for count in pupils] for name in steps[pupils[0]]},
        "seconds_a_letter": whole,
        "exponent_of_a_letter": exponent(list(pupils), whole) if len(pupils) > 1 else 0.0,
        "seconds_of_a_style": {
            n: _seconds(lambda n=n: teach.Style.of(takes[:n])) for n in pupils if n > 1
        },
        "bytes_of_a_pupil": memory,
    }


def written(folder: Path, pupil: int, characters: str) -> list[Path]:
    """The files of one pupil."""
    chance = np.random.default_rng(pupil)
    size, pace = np.exp(0.2 * chance.normal(size=2))
    shape = np.array([[size * np.exp(0.15 * chance.normal()), 0.15 * chance.normal()], [0, size]])
    bend = bending(chance, 0.002)
    files = []
    for character in characters:
        model = teach.recording_of(character, ALPHABET)
        flat = model.position[:, :2] @ shape.T
        place = np.column_stack([flat + bend(flat / 0.07), model.position[:, 2]])
        recording = Recording(model.t / pace, place, character, f"w{pupil:02}", 0.0)
        files.append(teach.write_recording(recording, folder / f"{pupil}_{ord(character)}.json"))
    return files


def taken(
    files: Sequence[Path], models: dict[str, Any]
) -> tuple[dict[str, float], dict[str, list]]:
    """Seconds of processor time for each step over all files, and what the steps gave."""
    kept: dict[str, list] = {}
    steps: dict[str, Callable[[int], Any]] = {
        "reading": lambda k: teach.read_recording(files[k]),
        "segmenting": lambda k: kept["reading"][k].strokes(),
        "learning": lambda k: teach.Letter.learn(kept["segmenting"][k]),
        "scoring": lambda k: teach.score(
            kept["segmenting"][k], models[kept["reading"][k].character]
        ),
    }
    seconds = {}
    for name, step in steps.items():
        began = process_time()
        kept[name] = [step(k) for k in range(len(files))]
        seconds[name] = process_time() - began
    return seconds, kept


def _quickest(
    files: list[list[Path]], models: dict[str, Any], pupils: Sequence[int]
) -> dict[int, dict[str, float]]:
    """The shorter of two tries of every step for each size of class: up through the sizes, then
    down.

    What else the computer does in the meantime slows all of them alike, not the larger classes
    only.
    """
    tries: dict[int, list[dict[str, float]]] = {}
    for count in [*pupils, *reversed(pupils)]:
        own = [file for pupil in files[:count] for file in pupil]
        tries.setdefault(count, []).append(taken(own, models)[0])
    return {
        count: {name: min(each[name] for each in both) for name in both[0]}
        for count, both in tries.items()
    }


def _memory(task: Callable[[], Any]) -> int:
    """What is kept of what a task gives [bytes]."""
    tracemalloc.start()
    kept = task()
    held = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    del kept
    return held


def _seconds(task: Callable[[], Any]) -> float:
    """Of processor time, the second time that it is done."""
    task()
    began = process_time()
    task()
    return process_time() - began


def lines(found: dict[str, Any]) -> list[str]:
    """The figures as a plain table."""
    heads = "".join(f"{name:>14}" for name in [*found["seconds"], "all", "a letter"])
    rows = [
        "",
        f"A class from its files, {found['letters']} letters by each pupil",
        f"{'pupils':>8}{heads}",
    ]
    for k, count in enumerate(found["pupils"]):
        each = [seconds[k] for seconds in found["seconds"].values()]
        cells = "".join(f"{value:12.2f} s" for value in [*each, sum(each)])
        rows.append(f"{count:8}{cells}{1e3 * found['seconds_a_letter'][k]:11.2f} ms")
    rows += [
        "",
        f"Time for a letter grows with pupils^{found['exponent_of_a_letter']:.2f}. "
        f"What is kept of a pupil: {found['bytes_of_a_pupil'] / 1e6:.1f} MB.",
    ]
    style = [
        f"{1e3 * seconds:.0f} ms for {count} pupils"
        for count, seconds in found["seconds_of_a_style"].items()
    ]
    return (
        [*rows, f"The style of one letter, learned letters given: {', '.join(style)}."]
        if style
        else rows
    )
