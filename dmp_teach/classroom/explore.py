"""The start panel: a person's letter, the robot's copy, sliders, and the robot that writes what is seen."""

import warnings
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import anywidget
import numpy as np
import traitlets

from dmp_teach.classroom import words
from dmp_teach.classroom.writing import Job, StopPressed
from dmp_teach.dmp.settings import Settings, knob_of
from dmp_teach.errors import RecordingError, SettingWarning, TeachError
from dmp_teach.ink.alphabet import characters, recording_of
from dmp_teach.ink.reader import read_recording
from dmp_teach.ink.recording import Recording
from dmp_teach.letters.letter import Letter, rms_distance
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Trajectory
from dmp_teach.views.page_file import read_beside
from dmp_teach.views.scene import SceneView

_HERE = Path(__file__).parent
_STEPS = {"wake": "Waking the robot", "reach": "Can the arm reach the letter?", "joints": "Planning every joint"}
_IDLE: dict[str, Any] = {"state": "idle"}
_NEAR = "abemBDMPR"  # the letters of the paper's figures, and two that D becomes
_OWN = "own recording"
_MOST_KERNELS = 80


def bundle(*names: str) -> str:
    """Files beside this one, joined: a panel's scripts or its styles."""
    return "\n".join((_HERE / name).read_text(encoding="utf-8") for name in names)


def explore(recording: Recording | str | Path | None = None, page: Page | None = None) -> "Explore":
    """A live panel: change the letter with sliders and goals, then let the robot write it.

    Args:
        recording: A recording, or the path of one, to begin with; None begins with our own alphabet.
        page: Where the robot writes; None for a sheet of A4 on the table.

    Raises:
        RecordingError: The recording cannot be read.
    """
    return Explore(recording, page)


class Explore(anywidget.AnyWidget):
    """The panel. Its knobs are traits: `n_kernels`, `kernel_width` [1/N], `stroke`, `goal_x` and `goal_y` [m]."""

    _esm = bundle("controls.js", "paper.js", "explore.js")
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
    robot = traitlets.Bytes().tag(sync=True)
    sheet = traitlets.List().tag(sync=True)
    message = traitlets.Dict().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    work = traitlets.Dict(_IDLE).tag(sync=True)
    older = traitlets.Bool(False).tag(sync=True)
    drawing = traitlets.Int(0).tag(sync=True)
    asked = traitlets.Int(0).tag(sync=True)
    answered = traitlets.Int(0).tag(sync=True)
    scene = anywidget.WidgetTrait().tag(sync=True)

    def __init__(self, recording: Recording | str | Path | None = None, page: Page | None = None):
        knobs = {name: _knob(name) for name in ("n_kernels", "kernel_width")}
        self._demo: tuple[Trajectory, ...] = ()
        super().__init__(scene=SceneView(compact=True, camera="whole robot"), knobs=knobs)
        self.page = Page.table() if page is None else page
        self.motion = None
        self._job: Job | None = None
        self._size: float | None = None
        self._own: Recording | None = None
        self.choices = [[name, name, f"the letter {name}"] for name in characters()]
        self.on_msg(self._hear)
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
        self.choices = [*(c for c in self.choices if c[0] != _OWN), [_OWN, f"{label}*", f"your own {label}"]]
        self.near = [*_NEAR, _OWN]
        if self.letter == _OWN:
            self._choose()
        else:
            self.letter = _OWN

    def write(self) -> None:
        """Let the robot write exactly what is seen."""
        if self.work["state"] == "working":
            return
        self._progress("wake", 0.0)
        strokes, size = self._written, self._size
        self._asked_for = self.robot
        self._job = Job(lambda report: _plan(strokes, self.page, size, report), self._progress, self._end)

    def _hear(self, _: Any, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """A button was pressed or a file was chosen."""
        kind = message.get("kind")
        if kind == "write":
            self.write()
        elif kind == "stop" and self._job:
            self._job.stop()
        elif kind == "cure":
            self._cure()
        elif kind == "close":
            self.work = _IDLE
        elif kind == "file":
            self._open_bytes(message["name"], bytes(buffers[0]))
        elif kind == "too large":
            self._cannot(
                f"{message['name']} has {message['size'] / 1e6:.0f} MB. A recording of one letter has less than 8."
            )

    def _open_bytes(self, name: str, content: bytes) -> None:
        """Read a file that came from the browser; it is kept nowhere."""
        with TemporaryDirectory() as folder:
            path = Path(folder) / (Path(name.replace("\\", "/")).name or "recording.csv")
            try:
                path.write_bytes(content)
                self.load(path)
            except (TeachError, OSError) as error:
                self._cannot(str(error))

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
            self.demo = _bytes(self._demo)
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
        now = (self.letter, self.n_kernels, self.kernel_width, self.stroke, str(self.goal_shifts), self.asked)
        if len(self.goal_shifts) != len(self._demo) or now == self._drawn:
            return
        self._drawn = now
        settings = Settings.star(n_kernels=self.n_kernels, kernel_width=self.kernel_width)
        with warnings.catch_warnings(action="ignore", category=SettingWarning):  # the sentence tells of gaps
            letter = Letter.learn(self._demo, settings)
        taught = letter.write()
        shifts = {i: shift for i, shift in enumerate(self.goal_shifts) if np.any(shift)}
        self._written = letter.write(goal_shifts=shifts) if shifts else taught
        with self.hold_sync():
            self.robot = _bytes(self._written)
            self.goal_x, self.goal_y = self.goal_shifts[self.stroke]
            self._describe(taught, shifts)
            self.older = self.motion is not None and self.robot != self._on_the_table
            self.work = self.work if self.work["state"] == "working" else _IDLE  # what could not be done was before
            self.answered = self.asked
            self.drawing += 1

    @traitlets.observe("goal_x", "goal_y")
    def _move_goal(self, change: Any) -> None:
        """A slider of somebody's own moves the goal of the chosen stroke."""
        shift = [self.goal_x, self.goal_y]
        if self.goal_shifts and shift != list(self.goal_shifts[self.stroke]):
            self.goal_shifts = [shift if i == self.stroke else s for i, s in enumerate(self.goal_shifts)]

    def _describe(self, taught: tuple[Trajectory, ...], shifts: dict[int, list[float]]) -> None:
        """The number, the sentence and the text alternative."""
        error = rms_distance(self._demo, taught)
        if shifts:
            stroke = self.stroke if self.stroke in shifts else max(shifts)
            goal = self._demo[stroke].position[-1] + shifts[stroke]
            miss = float(np.linalg.norm(self._written[stroke].position[-1] - goal))
            only = None if len(self._demo) == 1 else stroke
            self.message = words.goal_message(float(np.linalg.norm(shifts[stroke])), miss, error, only)
        else:
            self.message = words.fit_message(error, self.n_kernels, self.kernel_width)
        name = next(name for key, _, name in self.choices if key == self.letter)
        self.title = words.letter_title(name, error, words.largest_gap(self._demo, taught))

    # What the robot does -------------------------------------------------------------------------

    def _progress(self, step: str, fraction: float) -> None:
        """Which step the robot is at, and how much of it is done; a bar never runs backwards."""
        at, part = (list(_STEPS).index(step), round(fraction, 2)) if step in _STEPS else (len(_STEPS) - 1, 0.0)
        before = (self.work["at"], self.work["fraction"]) if self.work["state"] == "working" else (0, 0.0)
        at, part = max(before, (at, part))
        self.work = {"state": "working", "steps": list(_STEPS.values()), "at": at, "fraction": part}

    def _end(self, result: Any) -> None:
        """Show the motion, or say what cannot be done and what would work."""
        if isinstance(result, StopPressed):
            self.work = _IDLE
        elif isinstance(result, Exception):
            self._cannot(str(result) or type(result).__name__, getattr(result, "cure", None))
        else:
            if self.motion is None:  # until now there was nothing to read on the page
                self.scene.camera = "over the shoulder"
            self.motion = result
            self.scene.show(result)
            self._on_the_table = self._asked_for
            self.older = self.robot != self._on_the_table
            self.work = _IDLE

    def _cannot(self, sentence: str, cure: Page | float | None = None) -> None:
        """What, by how much, and one button that cures it; the last good picture stays."""
        strong, dot, text = sentence.partition(". ")
        self._remedy = cure
        label = "Move the page there" if isinstance(cure, Page) else cure and f"Write it {100 * cure:.1f} cm high"
        self.work = {"state": "cannot", "strong": strong + dot.strip(), "text": text, "cure": label}

    def _cure(self) -> None:
        """Write again, on the page or in the size that works."""
        if isinstance(self._remedy, Page):
            self.page = self._remedy
        else:
            self._size = self._remedy
        self.work = _IDLE
        self.write()


def _plan(strokes: tuple[Trajectory, ...], page: Page, size: float | None, report: Any) -> Any:
    """The robot's motion; its solver is built once, in the thread that uses it."""
    from dmp_teach.robot.fetch import Fetch  # noqa: PLC0415 (PlaCo loads when a robot is wanted)

    report("wake", 0.5)
    return Fetch().write(strokes, page, size=size, progress=report)


def _knob(name: str) -> dict[str, Any]:
    """A knob as the panel's sliders need it."""
    knob = knob_of(name)
    label = knob.label[0].upper() + knob.label[1:]
    return {"low": knob.low, "high": knob.high, "label": label, "term": knob.term}


def _bytes(strokes: tuple[Trajectory, ...]) -> bytes:
    """All points as float32 x, y, x, y ... [m], one stroke after the other."""
    return np.concatenate([stroke.position for stroke in strokes]).astype("<f4").tobytes()


def _sheet(strokes: tuple[Trajectory, ...]) -> list[float]:
    """What the sheet shows, [left, bottom, right, top] [m]: the letter and a margin to drag goals to."""
    points = np.concatenate([stroke.position for stroke in strokes])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = max(0.015, 0.14 * float((high - low).max()))
    return [float(v) for v in (*(low - margin), *(high + margin))]
