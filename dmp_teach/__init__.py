"""Teach a robot to write: letters from people's handwriting with dynamic movement primitives.

Names are loaded when they are first used (PEP 562): importing the package loads nothing heavy.
`__init__.pyi` lists the same names for editors and type checkers.
"""

import warnings
from importlib import import_module

__version__ = "0.1.0"

_NAMES = {
    "errors": "TeachError SettingError SettingWarning TrajectoryError RecordingError LetterError "
    "PageError ReachError ReachWarning JointError MissingPartError SetupError ViewError PathError",
    "progress": "progress_bar",
    "texts": "set_language",
    "trajectory": "Trajectory",
    "ink": "Recording recording_of",
    "formats": "read_recording read_recordings write_recording use_script",
    "scoring": "score Score judge_stroke StrokeVerdict letter_distance",
    "dmp": "Settings DMP Stepper chain",
    "letters": "Letter Style Shelf Piece make_letter write_word write_lines",
    "robot": "Page Motion Fetch reach_map reach_around known_reach simulate Run",
    "ros": "write_rosbag",
    "studies": "claims choose_kernels sweep_kernel_width sweep_kernel_number change_goals_1d "
    "change_goals_2d",
    "views": "figure view read_stamp write_stamp",
    "classroom": "explore pad Lesson Verdict challenge at_most at_least between exactly sliders "
    "RobotPupil PupilTraits TeachingSession",
    "lessons": "lesson check class_overview",
}
_HOME = {name: room for room, names in _NAMES.items() for name in names.split()}
_HOME.update(errors="errors", figures="views.figures", studies="studies")  # modules of their own

# Old name: new name. The old one stays for one version.
_RENAMED = {
    "Rollout": "Stepper",
    "joined": "chain",
    "ProgressBar": "progress_bar",
    "error_against_number": "sweep_kernel_number",
    "error_against_width": "sweep_kernel_width",
    "goal_change_1d": "change_goals_1d",
    "goal_change_2d": "change_goals_2d",
    "lines": "write_lines",
    "word": "write_word",
}

__all__ = ["__version__", *_HOME]  # noqa: PLE0604 (the keys are strings)


def __getattr__(name):
    """Load a public name from its room when it is first used."""
    if name in _RENAMED:
        new = _RENAMED[name]
        warnings.warn(
            f"dmp_teach.{name} is now called dmp_teach.{new}.",
            DeprecationWarning,
            stacklevel=2,
        )
        return globals()[new] if new in globals() else __getattr__(new)
    if name in _NAMES:
        return import_module("dmp_teach." + name)
    if name not in _HOME:
        raise AttributeError(
            "dmp_teach has no {!r}; it has: {}.".format(name, ", ".join(sorted(_HOME)))
        )
    room = import_module("dmp_teach." + _HOME[name])
    value = room if _HOME[name].split(".")[-1] == name else getattr(room, name)
    globals()[name] = value
    return value


def __dir__():
    """Return the public names, for the Tab key."""
    return sorted(__all__)
