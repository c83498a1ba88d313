"""The robot at its page in three dimensions: live in a notebook, as one file, as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import traitlets

from dmp_teach.errors import ViewError, kind_of
from dmp_teach.files import check_path, join_modules, join_styles, write_whole
from dmp_teach.robot import Motion, Run
from dmp_teach.views.page_file import render_page
from dmp_teach.views.scene.cameras import CAMERA_NAMES
from dmp_teach.views.scene.commands import pack_robot, pack_viewer, record_stage
from dmp_teach.views.scene.packing import pack_commands
from dmp_teach.views.scene.picture import render_png
from dmp_teach.views.scene.stage import Stage
from dmp_teach.views.unsaved import UnsavedWidget

_HERE = Path(__file__).parent
STYLE_TOKENS = _HERE / "tokens.css"
"""The colours and sizes that the styles of every panel and view use."""

PLANNED = "as planned"
HAPPENED = "as it happened"


def _as_bytes() -> traitlets.Bytes:
    """Return a trait of bytes, which come from the browser as a memoryview."""
    return traitlets.Bytes().tag(sync=True, from_json=lambda value, widget: bytes(value))


class SceneView(UnsavedWidget):
    """The live view of a motion or a run, in a cell of its own or inside another widget.

    Args:
        motion: What the robot does, or the run that shows what it did; without one it waits at an
            empty page.
        compact: Without a frame and with one row of controls, to stand inside a panel.

    Raises:
        ViewError: Something that is neither a motion nor a run.
    """

    _esm = join_modules(_HERE / "scene.js")
    _css = join_styles(STYLE_TOKENS, _HERE / "scene.css", _HERE / "force.css")

    _open = ("time", "playing", "speed", "camera", "seen")

    viewer = _as_bytes()
    robot = _as_bytes()
    run = _as_bytes()
    facts = traitlets.Dict().tag(sync=True)
    planned_run = _as_bytes()
    planned_facts = traitlets.Dict().tag(sync=True)
    seen = traitlets.Enum((PLANNED, HAPPENED), default_value=HAPPENED).tag(sync=True)
    motion_id = traitlets.Unicode().tag(sync=True)
    time = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    speed = traitlets.Float(1.0).tag(sync=True)
    camera = traitlets.Enum(CAMERA_NAMES, default_value="over the shoulder").tag(sync=True)
    compact = traitlets.Bool(False).tag(sync=True)

    # Any: the values of the other traits.
    def __init__(self, motion: Motion | Run | None = None, **traits: Any) -> None:
        self._count = 0
        self._stage = _build_stage(motion)
        shown = _find_traits(self._stage)
        super().__init__(viewer=pack_viewer(), robot=pack_robot(), motion_id="0", **shown, **traits)

    @property
    def motion(self) -> Motion | Run | None:
        """The motion or run that is shown."""
        return self._stage.run or self._stage.motion

    def show(self, motion: Motion | Run | None, play: bool = True) -> None:
        """Show another motion in the same view; the camera stays where it is.

        Args:
            motion: What the robot does now, or what it did; None lets it wait at an empty page.
            play: Whether it starts at once. Where people ask for less movement it shows the
                written letter instead.

        Raises:
            ViewError: Something that is neither a motion nor a run.
        """
        stage = _build_stage(motion)
        shown = _find_traits(stage, play)
        self._stage = stage
        self._count += 1
        with self.hold_sync():
            self.set_trait("playing", False)
            for name, value in shown.items():
                self.set_trait(name, value)
            self.motion_id = str(self._count)
        # The browser has moved them since.
        self.send_state(["time", "playing"])

    def html(self, path: str | Path) -> Path:
        """Write the view as one file that opens from disk, without network or kernel.

        It has at most 0.8 MB.

        Args:
            path: Where to, ending with .html; its folder must exist.

        Returns:
            The path.

        Raises:
            PathError: A path that cannot be written; what was there before stays.
        """
        path = check_path(path, ".html")
        names = ("viewer", "robot", "run", "facts", "planned_run", "planned_facts")
        state = {name: getattr(self, name) for name in (*names, "camera", "seen", "texts")}
        state |= {"time": 0.0, "playing": True, "speed": 1.0, "compact": False, "motion_id": "0"}
        script = join_modules(_HERE / "page.js")
        label = self.facts["label"]
        text = render_page("A robot writes a letter", self._css, script, state, label)
        return write_whole(path, text, ".html")

    def png(
        self,
        path: str | Path,
        time: float | None = None,
        camera: str = "over the shoulder",
        width: int = 900,
        height: int = 600,
    ) -> Path:
        """Write a picture of one moment, drawn without a browser.

        Args:
            path: Where to, ending with .png; its folder must exist.
            time: The moment [s]; None for the end.
            camera: "whole robot", "over the shoulder" or "page from above".
            width: Of the picture [pixels].
            height: Of the picture [pixels].

        Returns:
            The path.

        Raises:
            SettingError: A time, camera or size that cannot be drawn.
            PathError: A path that cannot be written.
            MissingPartError: pybullet is not installed.
        """
        path, stage = check_path(path, ".png"), self._stage
        if stage.run and self.seen == PLANNED:
            stage = Stage(stage.run.planned)
        return write_whole(path, render_png(stage, time, camera, width, height), ".png")


def view(motion: Motion | Run) -> SceneView:
    """Show a motion, or a run as it was planned and as it happened.

    It is live in a notebook; `.html(path)` and `.png(path)` write it to a file.

    Raises:
        ViewError: Something that is neither a motion nor a run.
    """
    if motion is None:
        raise ViewError(_describe_wrong_motion(motion))
    return SceneView(motion)


def _build_stage(motion: object) -> Stage:
    """Return what is to be seen of a motion, or raise a ViewError."""
    if isinstance(motion, Run):
        return Stage(motion.motion, motion)
    if motion is not None and not isinstance(motion, Motion):
        raise ViewError(_describe_wrong_motion(motion))
    return Stage(motion)


def _describe_wrong_motion(value: object) -> str:
    """Return a sentence on what can be shown, and how to get it."""
    return (
        f"{kind_of(value, first=True)} cannot be shown; a Motion can, and Fetch().write(strokes, "
        "Page.table()) gives one; so can a Run, which simulate(motion) gives."
    )


def _find_traits(stage: Stage, play: bool = True) -> dict[str, object]:
    """Return the traits of a view that change with the motion."""
    plan = Stage(stage.run.planned) if stage.run else None
    return {
        "run": pack_commands(record_stage(stage)),
        "facts": stage.facts(),
        "planned_run": pack_commands(record_stage(plan)) if plan else b"",
        "planned_facts": plan.facts() if plan else {},
        "time": 0.0,
        "playing": play and stage.duration > 0,
    }
