"""What every panel with a robot shares: its job, *Stop*, cures, and files of one's own."""

from __future__ import annotations

import sys
from base64 import b64encode
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import anywidget
import numpy as np
import traitlets
from IPython.display import display, update_display

from dmp_teach.classroom.panels.background_job import Job, StopPressed
from dmp_teach.classroom.panels.planning import Physics, name_steps, plan_motion
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import RecordingError, TeachError
from dmp_teach.formats import known_formats, read_recording
from dmp_teach.ink import Recording, characters
from dmp_teach.robot import Motion, Page, Run, check_page
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import SceneView, UnsavedWidget

MAX_FILE_BYTES = 8_000_000
# A picture, since a scene that nobody has asked for would be four fifths of a panel.
_PICTURE = Path(__file__).with_name("resting_robot.webp").read_bytes()
_STILL = f"data:image/webp;base64,{b64encode(_PICTURE).decode()}"
# Any, here and below: JSON for the browser.
_IDLE: dict[str, Any] = {"state": "idle"}


def pack_points(strokes: Sequence[Trajectory]) -> bytes:
    """Return all points as float32 x, y, x, y ... [m], one stroke after the other."""
    points = np.concatenate([np.empty((0, 2)), *(stroke.position for stroke in strokes)])
    return points.astype("<f4").tobytes()


def list_letter_choices() -> list[list[str]]:
    """Return our letters as a panel's list shows them: value, label, name and group."""
    choices = []
    for letter in characters():
        name = _("the digit {letter}") if letter.isdigit() else _("the letter {letter}")
        if letter.isdigit():
            group = _("Digits")
        elif not letter.isascii():
            group = _("With accents")
        else:
            group = _("Small letters") if letter.islower() else _("Capitals")
        choices.append([letter, letter, name.format(letter=letter), group])
    return choices


class RobotPanel(UnsavedWidget):
    """A panel with a sheet, whose letter a robot can write.

    A new panel is a subclass with a script and a style sheet beside it (`_esm`, `_css`). Browser
    and kernel talk by traits and messages, and keep in step by three numbers:

    - `asked`, for panels whose knobs are traits (`Explore`): the browser raises it with each knob.
    - `answered`: up to which question the kernel has answered. A question is a value of `asked`,
      or a message with a number `n` (`Pad`); while the answer is out, the panel says so.
    - `drawing`: the kernel raises it when all traits of a picture are set; the browser then draws.

    Whenever the letter changes, a subclass sets within one `hold_sync()` the traits `sheet`,
    `counts`, `message` and `title` (and its own), calls `_show_strokes` with what the robot
    would write, and raises `answered` and `drawing`. For another letter it sets `_size` to None:
    the robot writes as large as is seen, unless a cure has set a height [m]. It says in `_show_own`
    how to show a recording, and passes messages that it does not know on to `_hear`.

    The other traits are set here: `robot` (the strokes, packed), `work` (idle, working or cannot),
    `older` (whether the robot has written another letter than is seen), `scene` (its view, once it
    has written) and `still` (its picture until then), and `files` (the formats that `load` reads).
    """

    choices: traitlets.List[list[str]] = traitlets.List().tag(sync=True)
    sheet: traitlets.List[float] = traitlets.List().tag(sync=True)
    counts: traitlets.List[int] = traitlets.List().tag(sync=True)
    message = traitlets.Dict().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    answered = traitlets.Int(0).tag(sync=True)
    drawing = traitlets.Int(0).tag(sync=True)

    robot = traitlets.Bytes().tag(sync=True)
    work = traitlets.Dict(_IDLE).tag(sync=True)
    older = traitlets.Bool(False).tag(sync=True)
    scene = anywidget.WidgetTrait().tag(sync=True)
    still = traitlets.Unicode(_STILL).tag(sync=True)
    files = traitlets.Dict(read_only=True).tag(sync=True)

    # Any: values of traits.
    def __init__(self, page: Page | None = None, **traits: Any):
        self.page = Page.table() if page is None else page
        check_page(self.page)
        self.motion: Motion | None = None
        self._physics: Physics | None = None
        self._job: Job | None = None
        self._strokes: tuple[Trajectory, ...] = ()
        self._size: float | None = None
        self._cure: Page | float | None = None
        # What the robot plans, and what it has written: strokes, packed, page and physics.
        self._in_work: tuple[object, ...] = ()
        self._on_the_table: tuple[object, ...] = ()
        super().__init__(**traits)
        # marimo opens a widget only while a cell runs, so there the view waits from the start.
        self._view = SceneView(compact=True) if "marimo" in sys.modules else None
        self.on_msg(self._hear)

    @traitlets.default("files")
    def _describe_formats(self) -> dict[str, object]:
        """Return the formats that a panel reads, for its file button."""
        names = [each.name for each in known_formats()]
        suffixes = [suffix for each in known_formats() for suffix in each.suffixes]
        return {
            "accept": ",".join(dict.fromkeys(suffixes)),
            "names": _("{names} or {last}").format(names=", ".join(names[:-1]), last=names[-1]),
            "limit": MAX_FILE_BYTES,
        }

    def draw_still(self) -> Still:
        """Return what an exported notebook shows of the panel: nothing that a pupil has written."""
        return Still(self.title, self.message, self.sheet)

    def _ipython_display_(self) -> None:
        """Show the panel, and below it the still picture, which a living panel hides."""
        bundle, metadata = self._repr_mimebundle_()
        display(bundle, metadata=metadata, raw=True)
        display({"text/html": self.draw_still().html()}, raw=True, display_id=self.model_id)

    # Any: what IPython passes on.
    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the living panel, and its sentence for where there is only text."""
        bundle, metadata = super()._repr_mimebundle_(**kwargs) or ({}, {})
        return {**bundle, "text/plain": self.draw_still().text()}, metadata

    def load(self, recording: Recording | str | Path) -> None:
        """Show a recording of one's own.

        Raises:
            RecordingError: It cannot be read, has no stroke, or this panel has its own letters.
        """
        own = recording if isinstance(recording, Recording) else read_recording(recording)
        if not own.strokes():
            raise RecordingError("There is no stroke in this recording: the pen never wrote.")
        self._show_own(own)

    def _show_own(self, own: Recording) -> None:
        """Show a recording that has strokes, where the panel can."""
        raise RecordingError("This panel has its own letters; try explore(recording).")

    def write(self) -> None:
        """Let the robot write exactly what is seen."""
        if self.work["state"] == "working":
            return
        self._show_progress("wake", 0.0)
        self._in_work = self._wanted
        strokes, size, page, physics = self._strokes, self._size, self.page, self._physics
        self._job = Job(
            plan_motion(strokes, page, size, physics),
            self._show_progress,
            self._show_result,
        )

    @property
    def _wanted(self) -> tuple[object, ...]:
        """What the robot would write now, to be compared."""
        return self.robot, repr(self.page), repr(self._physics)

    def _show_strokes(
        self,
        strokes: tuple[Trajectory, ...],
        page: Page | None = None,
        physics: Physics | None = None,
    ) -> None:
        """Set what the robot would write, and where if not on the last page; what was is over."""
        self._strokes, self.page, self._physics = strokes, page or self.page, physics
        self.robot = pack_points(strokes)
        self.older = self.motion is not None and self._wanted != self._on_the_table
        if self.work["state"] != "working":
            self.work = _IDLE

    def _hear(self, widget: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Do what a button asks for, or open a file that was chosen."""
        kind = message.get("kind")
        if kind == "write":
            self.write()
        elif kind == "stop" and self._job:
            self._job.stop()
        elif kind == "cure":
            self._apply_cure()
        elif kind == "still":
            update_display(
                {"text/html": self.draw_still().html()}, raw=True, display_id=self.model_id
            )
        elif kind == "close":
            self.work = _IDLE
        elif kind == "file":
            self._open_bytes(message["name"], bytes(buffers[0]))
        elif kind == "too large":
            said = _("{name} has {mb:.0f} MB. A recording of one letter has less than {limit:.0f}.")
            sizes = {"mb": message["size"] / 1e6, "limit": MAX_FILE_BYTES / 1e6}
            self._refuse(said.format(name=message["name"], **sizes))

    def _open_bytes(self, name: str, content: bytes) -> None:
        """Read a file that came from the browser; it is kept nowhere."""
        try:
            with TemporaryDirectory() as folder:
                path = Path(folder) / (Path(name.replace("\\", "/")).name or "recording.csv")
                path.write_bytes(content)
                self.load(path)
        except (TeachError, OSError) as error:
            self._refuse(str(error))

    def _show_progress(self, step: str, fraction: float) -> None:
        """Show the robot's step, and how much of it is done; a bar never runs backwards."""
        steps = name_steps(self._physics)
        names = list(steps)
        place = (len(names) - 1, 0.0)
        if step in names:
            place = (names.index(step), round(fraction, 2))
        if self.work["state"] == "working":
            place = max(place, (self.work["at"], self.work["fraction"]))
        self.work = {
            "state": "working",
            "steps": list(steps.values()),
            "at": place[0],
            "fraction": place[1],
        }

    def _show_result(self, result: object) -> None:
        """Show the motion, or say what cannot be done and what would work."""
        if isinstance(result, StopPressed):
            self.work = _IDLE
        elif isinstance(result, Exception):
            broken = _("The program has a fault here: {kind}.").format(kind=type(result).__name__)
            self._refuse(str(result) or broken, getattr(result, "cure", None))
        elif isinstance(result, Motion | Run):
            self.motion = result.planned if isinstance(result, Run) else result
            if self._view is None:
                self._view = SceneView(result, compact=True)
            else:
                self._view.show(result)
            self.scene = self._view
            self._on_the_table = self._in_work
            self.older = self._wanted != self._on_the_table
            self.work = _IDLE

    def _forget_robot(self) -> None:
        """Stop the robot, and forget what it has written."""
        if self._job:
            self._job.stop()
        self.motion = None
        self._on_the_table = ()
        if self._view is not None:
            self._view.show(None)

    def _refuse(self, sentence: str, cure: Page | float | None = None) -> None:
        """Say what cannot be done, with one button that cures it; the last picture stays."""
        strong, dot, text = sentence.partition(". ")
        self._cure = cure
        label = None
        if isinstance(cure, Page):
            label = _("Move the page there")
        elif cure:
            label = _("Write it {cm:.1f} cm high").format(cm=100 * cure)
        self.work = {"state": "cannot", "strong": strong + dot.strip(), "text": text, "cure": label}

    def _apply_cure(self) -> None:
        """Write again, on the page or in the size that works."""
        if isinstance(self._cure, Page):
            self._move_page(self._cure)
        else:
            self._size = self._cure
        self.work = _IDLE
        self.write()

    def _move_page(self, page: Page) -> None:
        """Lay the page where it works."""
        self.page = page
