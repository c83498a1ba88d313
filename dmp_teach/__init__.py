"""Teach a robot to write: letters from people's handwriting with dynamic movement primitives.

The names below are loaded when they are first used (PEP 562): importing the package loads nothing heavy.
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

_HOME = {
    "TeachError": "errors",
    "Trajectory": "trajectory",
    "Recording": "ink.recording",
    "read_recording": "ink.reader",
    "read_recordings": "ink.reader",
    "write_recording": "ink.writer",
    "recording_of": "ink.alphabet",
    "score": "ink.score",
    "letter_distance": "ink.distances",
    "Settings": "dmp.settings",
    "DMP": "dmp.primitive",
    "Rollout": "dmp.stepping",
    "joined": "dmp.joining",
    "Letter": "letters.letter",
    "Style": "letters.styles",
    "Shelf": "letters.shelf",
    "word": "letters.words",
    "lines": "letters.lines",
    "Page": "robot.page",
    "Motion": "robot.motion",
    "Fetch": "robot.fetch",
    "reach_map": "robot.reach_map",
    "reach_around": "robot.reach_map",
    "simulate": "robot.simulate",
    "Run": "robot.run",
    "claims": "studies.claims",
    "choose_kernels": "studies.choose",
    "error_against_width": "studies.curves",
    "error_against_number": "studies.curves",
    "goal_change_1d": "studies.goals",
    "goal_change_2d": "studies.goals",
    "ProgressBar": "studies.work",
    "write_rosbag": "robot.ros",
    "view": "views.scene",
    "explore": "classroom.explore",
    "pad": "classroom.pad",
}

__all__ = ["__version__", *_HOME]  # noqa: PLE0604 (the keys are strings)


def __getattr__(name: str) -> Any:
    """Load a public name from its room when it is first used."""
    if name == "studies":
        return import_module("dmp_teach.studies")
    if name not in _HOME:
        raise AttributeError(f"dmp_teach has no {name!r}; it has: {', '.join(sorted(_HOME))}.")
    value = getattr(import_module(f"dmp_teach.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list:
    """The public names, for the Tab key."""
    return sorted(__all__)
