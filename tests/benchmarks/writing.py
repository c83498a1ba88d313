"""How fast the robot is planned, simulated and shown: `python -m tests.benchmarks.writing`.

No test: what a computer does beside it decides too. It prints multiples of real time by processor time, medians of
several letters.
"""

import sys
from collections.abc import Callable
from time import process_time
from typing import Any

import numpy as np

import dmp_teach as teach
from dmp_teach.views.commands import run_commands
from dmp_teach.views.stage import Stage

LETTERS = (("a", "round"), ("g", "slanted"), ("R", "round"), ("8", "slanted"), ("k", "round"))


def took(task: Callable[[], Any]) -> tuple[Any, float]:
    """What a task gives, and its processor time [s]."""
    start = process_time()
    return task(), process_time() - start


def measure() -> dict[str, list[float]]:
    """Multiples of real time for each letter, after one that warms up; the view in seconds."""
    found = {"plan": [], "physics, ideal motors": [], "physics, real motors": [], "view ready after [s]": []}
    fetch, page = teach.Fetch(), teach.Page.table()
    for number, (character, alphabet) in enumerate((LETTERS[0], *LETTERS)):
        strokes = teach.Letter.learn(teach.recording_of(character, alphabet)).write()
        motion, planned = took(lambda strokes=strokes: fetch.write(strokes, page))
        run, ideal = took(lambda motion=motion: teach.simulate(motion))
        _, real = took(lambda motion=motion: teach.simulate(motion, motors="real"))
        stage = Stage(run.motion, run)
        _, shown = took(lambda stage=stage: (run_commands(stage), stage.facts()))
        if number:
            for row, figure in zip(found.values(), (planned, ideal, real), strict=False):
                row.append(motion.duration / figure)
            found["view ready after [s]"].append(shown)
    return found


if __name__ == "__main__":
    for name, figures in measure().items():
        sys.stdout.write(f"{name:24} {np.median(figures):8.2f}   ({min(figures):.2f} to {max(figures):.2f})\n")
