"""The robot at its page in three dimensions: live in a notebook, as one file, as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import anywidget
import traitlets

from dmp_teach.errors import ViewError, kind_of
from dmp_teach.files import write_whole
from dmp_teach.robot import Motion, Run
from dmp_teach.views.scene.cameras import CAMERAS
from dmp_teach.views.scene.commands import robot_bundle, run_commands, viewer_script
from dmp_teach.views.scene.packing import bundle
from dmp_teach.views.scene.page_file import page, read_beside
from dmp_teach.views.scene.picture import png
from dmp_teach.views.scene.stage import Stage

_SCRIPT = read_beside("scene_3d.js") + read_beside("force.js") + read_beside("scene.js")
_STYLE = read_beside("tokens.css") + read_beside("scene.css") + read_beside("force.css")


SEEN = ("as planned", "as it happened")
"""What a view of a run can show; a motion is only planned."""


def _as_bytes() -> traitlets.Bytes:
    """Bytes for the browser; from it they come as a memoryview, which traitlets would refuse."""
    return traitlets.Bytes().tag(sync=True, from_json=lambda value, widget: bytes(value))


class SceneView(anywidget.AnyWidget):
    """The live view of a motion, or of what became of it, in a cell of its own or inside another widget.

    Args:
        motion: What the robot does, or the run that shows what it did; without one it waits at an empty page.
        compact: Without a frame and with one row of controls, to stand inside a panel.

    Raises:
        ViewError: Something that is neither a motion nor a run.
    """

    _esm = _SCRIPT
    _css = _STYLE

    viewer = _as_bytes()
    robot = _as_bytes()
    run = _as_bytes()
    facts = traitlets.Dict().tag(sync=True)
    planned_run = _as_bytes()
    planned_facts = traitlets.Dict().tag(sync=True)
    seen = traitlets.Enum(SEEN, default_value=SEEN[1]).tag(sync=True)
    motion_id = traitlets.Unicode().tag(sync=True)
    time = traitlets.Float(0.0).tag(sync=True)
    playing = traitlets.Bool(False).tag(sync=True)
    speed = traitlets.Float(1.0).tag(sync=True)
    camera = traitlets.Enum(CAMERAS, default_value="over the shoulder").tag(sync=True)
    compact = traitlets.Bool(False).tag(sync=True)

    def __init__(self, motion: Motion | Run | None = None, **traits: Any) -> None:
        self._count = 0
        start = _traits(motion)
        super().__init__(
            viewer=viewer_script(), robot=robot_bundle(), motion_id="0", **start, **traits
        )
        self._motion = motion

    @property
    def motion(self) -> Motion | Run | None:
        """What is shown in this view."""
        return self._motion

    def show(self, motion: Motion | Run | None, play: bool = True) -> None:
        """Another motion in the same view; the camera stays where it is.

        Args:
            motion: What the robot does now, or what it did; None lets it wait at an empty page.
            play: Whether it starts at once. Where people ask for less movement it shows the written letter instead.

        Raises:
            ViewError: Something that is neither a motion nor a run.
        """
        start = _traits(motion, play)
        self._motion, self._count = motion, self._count + 1
        with self.hold_sync():
            self.set_trait("playing", False)
            for name, value in start.items():
                self.set_trait(name, value)
            self.motion_id = str(self._count)
        self.send_state(["time", "playing"])  # the browser has moved them since

    def html(self, path: str | Path) -> Path:
        """Write the view as one file that opens from disk, without network or kernel; at most 0.8 MB.

        Args:
            path: Where to, ending with .html; its folder must exist.

        Returns:
            The path.

        Raises:
            PathError: A path that cannot be written; what was there before stays.
        """
        parts = {name: getattr(self, name) for name in ("viewer", "robot", "run", "planned_run")}
        state = {name: getattr(self, name) for name in ("facts", "planned_facts", "camera", "seen")}
        state |= {"time": 0.0, "playing": True, "speed": 1.0, "compact": False, "motion_id": "0"}
        text = page("A robot writes a letter", _STYLE, _SCRIPT, state, parts)
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
        planned = isinstance(self._motion, Run) and self.seen == SEEN[0]
        shown = self._motion.planned if planned else self._motion
        return write_whole(path, png(_stage(shown), time, camera, width, height), ".png")


def view(motion: Motion | Run) -> SceneView:
    """Show a motion, or a run as it was planned and as it happened.

    It is live in a notebook; `.html(path)` and `.png(path)` write it to a file.

    Raises:
        ViewError: Something that is neither a motion nor a run.
    """
    if motion is None:
        raise ViewError(_not_a_motion(motion))
    return SceneView(motion)


def _stage(motion: Any) -> Stage:
    """What is to be seen of a motion."""
    if isinstance(motion, Run):
        return Stage(motion.motion, motion)
    if motion is not None and not isinstance(motion, Motion):
        raise ViewError(_not_a_motion(motion))
    return Stage(motion)


def _not_a_motion(value: Any) -> str:
    """What can be shown, and how to get it."""
    return (
        f"{kind_of(value, first=True)} cannot be shown; a Motion can, and Fetch().write(strokes, Page.table()) gives "
        "one; so can a Run, which simulate(motion) gives."
    )


def _traits(motion: Motion | Run | None, play: bool = True) -> dict[str, Any]:
    """The traits of a view that change with the motion."""
    stage, plan = _stage(motion), Stage(motion.planned) if isinstance(motion, Run) else None
    return {
        "run": bundle(run_commands(stage)),
        "facts": stage.facts(),
        "planned_run": bundle(run_commands(plan)) if plan else b"",
        "planned_facts": plan.facts() if plan else {},
        "time": 0.0,
        "playing": play and stage.duration > 0,
    }
