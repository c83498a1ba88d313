"""The start panel: a person's letter, the robot's copy, sliders, and the robot that writes what is seen."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import traitlets

from dmp_teach.classroom.panels import messages as words
from dmp_teach.classroom.panels.robot_panel import RobotPanel, bundle, bytes_of, letter_choices
from dmp_teach.dmp import Settings, knob_of
from dmp_teach.errors import RecordingError, SettingWarning
from dmp_teach.files import bundle as bundled
from dmp_teach.formats import read_recording
from dmp_teach.ink import Recording, recording_of
from dmp_teach.letters import Letter, rms_distance
from dmp_teach.robot import Page
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import SceneView, read_beside

_NEAR = "abemBDMPR"  # the letters of the paper's figures, and two that D becomes
_OWN = "own recording"
_MOST_KERNELS = 80


def explore(recording: Recording | str | Path | None = None, page: Page | None = None) -> Explore:
    """A live panel: change the letter with sliders and goals, then let the robot write it.

    Args:
        recording: A recording, or the path of one, to begin with; None begins with our own alphabet.
        page: Where the robot writes; None for a sheet of A4 on the table.

    Raises:
        RecordingError: The recording cannot be read.
    """
    return Explore(recording, page)


class Explore(RobotPanel):
    """The panel. Its knobs are traits: `n_kernels`, `kernel_width` [1/N], `stroke`, `goal_x` and `goal_y` [m]."""

    _esm = bundled(Path(__file__).with_name("explore.js"))
    _css = read_beside("tokens.css") + bundle("panel.css", "paper.css")

    choices = traitlets.List().tag(sync=True)
    near = traitlets.List(list(_NEAR)).tag(sync=True)
    letter = traitlets.Unicode().tag(sync=True)
    knobs = traitlets.Dict().tag(sync=True)
    n_kernels = traitlets.Int(12).tag(sync=True)
    most_kernels = traitlets.Int(_MOST_KERNELS).tag(sync=True)
    kernel_width = traitlets.Float(2.0).tag(sync=True)
    stroke = traitlets.Int(0).tag(sync=True)
    goal_shifts = traitlets.List().tag(sync=True)
    goal_x = traitlets.Float(0.0).tag(sync=True)
    goal_y = traitlets.Float(0.0).tag(sync=True)
    counts = traitlets.List().tag(sync=True)
    demo = traitlets.Bytes().tag(sync=True)
    sheet = traitlets.List().tag(sync=True)
    message = traitlets.Dict().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    drawing = traitlets.Int(0).tag(sync=True)
    asked = traitlets.Int(0).tag(sync=True)
    answered = traitlets.Int(0).tag(sync=True)

    def __init__(self, recording: Recording | str | Path | None = None, page: Page | None = None):
        knobs = {name: _knob(name) for name in ("n_kernels", "kernel_width")}
        self._demo: tuple[Trajectory, ...] = ()
        super().__init__(page, scene=SceneView(compact=True, camera="whole robot"), knobs=knobs)
        self._own: Recording | None = None
        self.choices = letter_choices()
        if recording is None:
            self.letter = "a"
        else:
            self.load(recording)

    # What the person does ------------------------------------------------------------------------

    def load(self, recording: Recording | str | Path) -> None:
        """Show a recording of one's own, beside the letters of the alphabet."""
        own = recording if isinstance(recording, Recording) else read_recording(recording)
        if not own.strokes():
            raise RecordingError("There is no stroke in this recording: the pen never wrote.")
        self._own = own
        label = own.character or "?"
        self.choices = [
            *(c for c in self.choices if c[0] != _OWN),
            [_OWN, f"{label}*", f"your own {label}", ""],
        ]
        self.near = [*_NEAR, _OWN]
        if self.letter == _OWN:
            self._choose()
        else:
            self.letter = _OWN

    # What is seen --------------------------------------------------------------------------------

    @traitlets.observe("letter")
    def _choose(self, change: Any = None) -> None:
        """Another letter: its strokes, its sheet, and goals where they were taught."""
        recording = self._own if self.letter == _OWN else recording_of(self.letter)
        self._demo, self._drawn = recording.strokes(), None
        with self.hold_sync(), self.hold_trait_notifications():
            self.most_kernels = min(_MOST_KERNELS, *(len(stroke) - 1 for stroke in self._demo))
            self.n_kernels = min(self.n_kernels, self.most_kernels)
            self.counts = [len(stroke) for stroke in self._demo]
            self.demo = bytes_of(self._demo)
            self.sheet = _sheet(self._demo)
            self.stroke = len(self._demo) - 1
            self.goal_shifts = [[0.0, 0.0] for _ in self._demo]
            self._size = None
        self._redraw()

    @traitlets.observe("n_kernels", "kernel_width", "goal_shifts", "stroke", "letter", "asked")
    def _redraw(self, change: Any = None) -> None:
        """Learn and write again, and say how far off it is."""
        if not self._demo:
            return
        now = (
            self.letter,
            self.n_kernels,
            self.kernel_width,
            self.stroke,
            str(self.goal_shifts),
            self.asked,
        )
        if len(self.goal_shifts) != len(self._demo) or now == self._drawn:
            return
        self._drawn = now
        settings = Settings.star(n_kernels=self.n_kernels, kernel_width=self.kernel_width)
        with warnings.catch_warnings(
            action="ignore", category=SettingWarning
        ):  # the sentence tells of gaps
            letter = Letter.learn(self._demo, settings)
        taught = letter.write()
        shifts = {i: shift for i, shift in enumerate(self.goal_shifts) if np.any(shift)}
        self._written = letter.write(goal_shifts=shifts) if shifts else taught
        with self.hold_sync():
            self.robot = bytes_of(self._written)
            self.goal_x, self.goal_y = self.goal_shifts[self.stroke]
            self._describe(taught, shifts)
            self._mark_older()
            self.answered = self.asked
            self.drawing += 1

    @traitlets.observe("goal_x", "goal_y")
    def _move_goal(self, change: Any) -> None:
        """A slider of somebody's own moves the goal of the chosen stroke."""
        shift = [self.goal_x, self.goal_y]
        if self.goal_shifts and shift != list(self.goal_shifts[self.stroke]):
            self.goal_shifts = [
                shift if i == self.stroke else s for i, s in enumerate(self.goal_shifts)
            ]

    def _describe(self, taught: tuple[Trajectory, ...], shifts: dict[int, list[float]]) -> None:
        """The number, the sentence and the text alternative."""
        error = rms_distance(self._demo, taught)
        if shifts:
            stroke = self.stroke if self.stroke in shifts else max(shifts)
            goal = self._demo[stroke].position[-1] + shifts[stroke]
            miss = float(np.linalg.norm(self._written[stroke].position[-1] - goal))
            only = None if len(self._demo) == 1 else stroke
            self.message = words.goal_message(
                float(np.linalg.norm(shifts[stroke])), miss, error, only
            )
        else:
            self.message = words.fit_message(error, self.n_kernels, self.kernel_width)
        name = next(name for key, _, name, _ in self.choices if key == self.letter)
        self.title = words.letter_title(name, error, words.largest_gap(self._demo, taught))


def _knob(name: str) -> dict[str, Any]:
    """A knob as the panel's sliders need it."""
    knob = knob_of(name)
    label = knob.label[0].upper() + knob.label[1:]
    return {"low": knob.low, "high": knob.high, "label": label, "term": knob.term}


def _sheet(strokes: tuple[Trajectory, ...]) -> list[float]:
    """What the sheet shows, [left, bottom, right, top] [m]: the letter and a margin to drag goals to."""
    points = np.concatenate([stroke.position for stroke in strokes])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = max(0.015, 0.14 * float((high - low).max()))
    return [float(v) for v in (*(low - margin), *(high + margin))]
