"""What every panel with a robot shares: its job and its progress, *Stop*, cures, older letters, files of one's own."""

from __future__ import annotations

import warnings
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import anywidget
import numpy as np
import traitlets

from dmp_teach.classroom.panels.background_job import Job, StopPressed
from dmp_teach.classroom.panels.resting import RESTING
from dmp_teach.errors import ReachWarning, TeachError
from dmp_teach.formats import known_formats
from dmp_teach.ink import Recording, characters
from dmp_teach.robot import Motion, Page
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import SceneView

_HERE = Path(__file__).parent
_STEPS = {
    "wake": "Waking the robot",
    "reach": "Can the arm reach the letter?",
    "joints": "Planning every joint",
}
_IDLE: dict[str, Any] = {"state": "idle"}


def bundle(*names: str) -> str:
    """Files beside this one, joined: a panel's scripts or its styles."""
    return "\n".join((_HERE / name).read_text(encoding="utf-8") for name in names)


def bytes_of(strokes: tuple[Trajectory, ...]) -> bytes:
    """All points as float32 x, y, x, y ... [m], one stroke after the other."""
    return (
        np.concatenate([np.empty((0, 2)), *(stroke.position for stroke in strokes)])
        .astype("<f4")
        .tobytes()
    )


def letter_choices() -> list[list[str]]:
    """The letters that we have, as a panel's list shows them: value, label, name and group."""

    def of(letter: str) -> tuple[str, str]:
        if letter.isdigit():
            return "digit", "Digits"
        if not letter.isascii():
            return "letter", "With accents"
        return "letter", "Small letters" if letter.islower() else "Capitals"

    return [
        [letter, letter, f"the {what} {letter}", group]
        for letter in characters()
        for what, group in [of(letter)]
    ]


class RobotPanel(anywidget.AnyWidget):
    """A panel whose letter a robot can write. It sets `_written`, `robot` and, where asked for, `_size`."""

    robot = traitlets.Bytes().tag(sync=True)
    work = traitlets.Dict(_IDLE).tag(sync=True)
    older = traitlets.Bool(False).tag(sync=True)
    scene = anywidget.WidgetTrait().tag(sync=True)
    files = traitlets.Dict(read_only=True).tag(sync=True)
    own_id = traitlets.Unicode().tag(
        sync=True
    )  # by it the panel keeps itself out of saved notebooks ...
    resting = traitlets.Unicode(RESTING).tag(sync=True)  # ... and is kept as this

    def __init__(self, page: Page | None = None, **traits: Any):
        self.page = Page.table() if page is None else page
        self.motion: Motion | None = None
        self._job: Job | None = None
        self._written: tuple[Trajectory, ...] = ()
        self._size: float | None = None
        self._on_the_table = b""
        super().__init__(**traits)
        self.own_id = self.model_id
        self.on_msg(self._hear)

    @traitlets.default("files")
    def _files_that_open(self) -> dict[str, str]:
        """Return the formats that a panel reads, for its file button."""
        names = [each.name for each in known_formats()]
        suffixes = [suffix for each in known_formats() for suffix in each.suffixes]
        return {"accept": ",".join(suffixes), "names": f"{', '.join(names[:-1])} or {names[-1]}"}

    def load(self, recording: Recording | str | Path) -> None:
        """Show a recording of one's own."""
        raise NotImplementedError

    def write(self) -> None:
        """Let the robot write exactly what is seen."""
        if self.work["state"] == "working":
            return
        self._progress("wake", 0.0)
        strokes, size = self._written, self._size
        self._asked_for = self.robot
        self._job = Job(
            lambda report: _plan(strokes, self.page, size, report), self._progress, self._end
        )

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

    def _mark_older(self) -> None:
        """Another letter is seen than the robot has written; what could not be done before is over."""
        self.older = self.motion is not None and self.robot != self._on_the_table
        self.work = self.work if self.work["state"] == "working" else _IDLE

    def _progress(self, step: str, fraction: float) -> None:
        """Which step the robot is at, and how much of it is done; a bar never runs backwards."""
        at, part = (
            (list(_STEPS).index(step), round(fraction, 2))
            if step in _STEPS
            else (len(_STEPS) - 1, 0.0)
        )
        before = (
            (self.work["at"], self.work["fraction"])
            if self.work["state"] == "working"
            else (0, 0.0)
        )
        at, part = max(before, (at, part))
        self.work = {"state": "working", "steps": list(_STEPS.values()), "at": at, "fraction": part}

    def _end(self, result: Any) -> None:
        """Show the motion, or say what cannot be done and what would work."""
        if isinstance(result, StopPressed):
            self.work = _IDLE
        elif isinstance(result, Exception):
            self._cannot(str(result) or type(result).__name__, getattr(result, "cure", None))
        else:
            if self.scene is None:
                self.scene = SceneView(compact=True)
            elif self.motion is None:  # until now there was nothing to read on the page
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
        label = (
            "Move the page there"
            if isinstance(cure, Page)
            else cure and f"Write it {100 * cure:.1f} cm high"
        )
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
    from dmp_teach.robot import Fetch  # noqa: PLC0415 (PlaCo loads when a robot is wanted)

    report("wake", 0.5)
    # only what this module's call warns of: it is among the motion's notes, which are seen beside the robot
    warnings.filterwarnings("ignore", category=ReachWarning, module=__name__)
    return Fetch().write(strokes, page, size=size, progress=report)
