"""The panel of a lesson: its steps, its knobs and its card, whatever the lesson."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import traitlets

from dmp_teach.classroom.lesson.bets import KeptBet, LessonState
from dmp_teach.classroom.lesson.check import Answer, Verdict
from dmp_teach.classroom.lesson.content import LessonContent, Picture
from dmp_teach.classroom.lesson.knobs import check_answer
from dmp_teach.classroom.lesson.packing import describe_card, describe_lesson, describe_page, pack
from dmp_teach.classroom.lesson.progress import (
    LESSON_STEPS,
    LessonProgress,
    add_done,
    begin_progress,
    take_up,
)
from dmp_teach.classroom.lesson.work_file import forget_work, read_work, save_work
from dmp_teach.classroom.panels.kept import forget_all, kept
from dmp_teach.classroom.panels.panel_page import PanelPage
from dmp_teach.classroom.panels.robot_panel import RobotPanel
from dmp_teach.classroom.panels.saved_attempts import find_free_pseudonym
from dmp_teach.classroom.panels.sheets import SHEET_OF_ANY_LETTER
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import ReachError, SettingError, TeachError
from dmp_teach.files import join_modules, join_styles
from dmp_teach.robot import Motion, Page, Run
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import STYLE_TOKENS

_HERE = Path(__file__).parent
_PANELS = _HERE.parent / "panels"
# So many of the pupil's settings are drawn as tried.
MOST_TRIED = 200


class RefusedValueError(SettingError, traitlets.TraitError):
    """A value that no knob has; traitlets puts back the old one."""


class LessonPanel(RobotPanel, PanelPage):
    """A lesson as a pupil sees it.

    `values` are the knobs, which may be set from Python, too; `answer` is what `teach.check` takes.
    Browser and kernel keep `progress` while they live.
    """

    _esm = join_modules(_HERE / "lesson.js")
    _css = join_styles(
        STYLE_TOKENS,
        *(_PANELS / f"{name}.css" for name in ("panel", "paper", "plot")),
        _HERE / "lesson.css",
    )
    _open = ("values", "asked")
    _page_script, _page_traits = _HERE / "lesson_page.js", ("title", "texts")

    # Any, here and below: JSON for the browser.
    spec: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    values: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    asked = traitlets.Int(0).tag(sync=True)
    picture: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    progress: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    card: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    status = traitlets.Unicode().tag(sync=True)

    def __init__(self, lesson: LessonContent):
        self.lesson = lesson
        # Where the notebook runs now: a cell may go elsewhere.
        self._folder = Path.cwd()
        self._mine = f"lesson {lesson.pupil or ''} "
        self._kept = kept(self._mine + lesson.key)
        self._tried: list[Answer] = []
        super().__init__(spec=describe_lesson(lesson))
        self._restore(self._kept or self._read_saved())

    @property
    def answer(self) -> Answer:
        """What is set now: the answer that `teach.check` judges."""
        return {name: self.values[name] for name in self.lesson.settable}

    # What is kept ---------------------------------------------------------------------------------

    def _restore(self, work: object) -> None:
        """Take up work where it was left; what does not fit the lesson begins afresh."""
        try:
            progress, values = take_up(self.lesson, work)
        except SettingError:
            progress, values = begin_progress(), dict(self.lesson.start)
        self._tried = []
        with self.hold_sync(), self.hold_trait_notifications():
            self.values = values
        self._redraw(progress)

    def _read_saved(self) -> object:
        """Return the work that the pupil has saved; what cannot be read is told and left alone."""
        try:
            saved = read_work(self._folder, self.lesson.pupil) if self.lesson.pupil else {}
        except (TeachError, OSError) as error:
            self.status = str(error)
            saved = {}
        return saved.get(self.lesson.key)

    def _work(self) -> dict[str, Any]:
        """Return what is kept of the lesson, as JSON."""
        variant = self.lesson.pupil or ""
        return {"variant": variant, "values": dict(self.values), "progress": self.progress}

    # What the browser asks for --------------------------------------------------------------------

    # Any: as in the base class.
    def _hear(self, _widget: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Do what a button of the lesson asks for, or what one of the robot does."""
        kind = message.get("kind")
        hears: dict[object, Callable[[], object]] = {
            "bet": lambda: self.bet(message["bet"]),
            "reveal": self.reveal,
            "step": lambda: self.go(message["step"]),
            "check": self.check,
            "hint": self.show_hint,
            "restore": lambda: self._restore_once(message["work"]),
            "save": self.save,
            "forget": self.forget,
        }
        if kind not in hears:
            super()._hear(_widget, message, buffers)
            return
        try:
            hears[kind]()
        except (TeachError, OSError, KeyError) as error:
            self.status = str(error)

    def _restore_once(self, work: object) -> None:
        """Take up what the browser has kept, where the kernel has no bet yet."""
        if self._progress()["bet"] is None:
            self._restore(work)

    def bet(self, bet: KeptBet) -> None:
        """Keep a bet: an option's name, or a place [x, y] for each handle.

        Raises:
            SettingError: It is no bet of this lesson.
        """
        self._change(bet=self.lesson.bet.checked(bet))

    def reveal(self) -> None:
        """Lay the truth over the bet, once there is one."""
        if self._progress()["bet"] is not None:
            self._change(revealed=True)

    def go(self, step: str) -> None:
        """Go to a step: "bet", "try" or "challenge".

        Raises:
            SettingError: There is no such step.
        """
        if step not in LESSON_STEPS:
            steps = ", ".join(LESSON_STEPS)
            raise SettingError(f"The step is {step!r}, but must be one of: {steps}.")
        self._change(step=step, verdict=None)

    def check(self) -> Verdict:
        """Judge what is set, and count a miss."""
        progress = self._progress()
        verdict = self.lesson.check(self.answer, progress["hints"])
        misses = progress["misses"] + (not verdict.done)
        passed = self.answer if verdict.done else progress["passed"]
        packed = {"done": verdict.done, "reason": verdict.reason}
        self._change(verdict=packed, misses=misses, passed=passed)
        return verdict

    def show_hint(self) -> None:
        """Show one hint more."""
        self._change(hints=min(self._progress()["hints"] + 1, len(self.lesson.hints)))

    def save(self) -> Path:
        """Write the work to the file of the pupil, in the folder of the notebook.

        Raises:
            RecordingError: A file of that name is there that is not ours.
            PathError: The folder cannot be written.
        """
        pupil = self.lesson.pupil or self._progress()["saved_as"]
        pupil = pupil or find_free_pseudonym(self._folder)
        self._change(saved_as=pupil)
        path = save_work(self._folder, pupil, self.lesson.key, self._work())
        self.status = _("Saved as {name}.").format(name=path.name)
        return path

    def forget(self) -> None:
        """Begin afresh in every lesson, and leave nothing of what was done, in no file either."""
        pupil = self.lesson.pupil or self._progress()["saved_as"]
        variant = self.lesson.pupil or ""
        gone = forget_work(self._folder, pupil, variant) if pupil else []
        forget_all(self._mine)
        self._forget_robot()
        self.scene = None
        self._restore(None)
        words = _("Everything is forgotten.")
        self.status = f"{words} {', '.join(gone)}" if gone else words

    def _progress(self) -> LessonProgress:
        """Return the progress that all panels of this lesson and pupil share."""
        return dict(self._kept.get("progress", begin_progress()))

    # Any: as `progress`.
    def _change(self, **changes: Any) -> None:
        """Change the progress, and show it."""
        self._redraw(self._progress() | changes)

    @traitlets.validate("values")
    def _refuse_other_values(self, proposal: dict[str, Any]) -> dict[str, Any]:
        """Return values, every one on its knob, or raise a SettingError that says what is not."""
        try:
            return check_answer(self.lesson.knobs, proposal["value"])
        except SettingError as error:
            raise RefusedValueError(*error.args) from None

    @traitlets.observe("values")
    def _try_values(self, _change: object) -> None:
        """Draw anew; a verdict was on other values, and a task may be done."""
        if not self.progress:
            return
        if self.progress["step"] != "bet":
            self._tried = [*self._tried, dict(self.values)][-MOST_TRIED:]
        done = add_done(self.lesson, self._progress(), self.values, by_robot=False)
        self._change(done=done, verdict=None)

    def _show_result(self, result: object) -> None:
        """Show the motion, and tick what the robot was to do; or say what it cannot."""
        if isinstance(result, ReachError) and result.cure:
            result = ReachError(self.lesson.tell_refusal(self._written, result), cure=result.cure)
        super()._show_result(result)
        if isinstance(result, Motion | Run):
            self._change(done=add_done(self.lesson, self._progress(), self._written, by_robot=True))
        if isinstance(result, Run) and not self.older:
            self.card = self.card | {"run": self.lesson.tell_run(result)}
            self.drawing += 1

    def write(self) -> None:
        """Let the robot write what is seen; tasks are about that."""
        if self.work["state"] != "working":
            self._written = dict(self.values)
        super().write()

    def _move_page(self, page: Page) -> None:
        """Turn the lesson's knobs to a page that works."""
        super()._move_page(page)
        self.values = self.lesson.values_on(page, dict(self.values))

    @traitlets.observe("asked")
    def _answer(self, _change: object) -> None:
        """Say that what was asked for is drawn."""
        self.answered += 1

    # What is shown --------------------------------------------------------------------------------

    # Any: as `progress`.
    def _redraw(self, progress: dict[str, Any]) -> None:
        """Draw the lesson at this progress, and its card."""
        seen = (progress["step"], progress["bet"], progress["revealed"])
        state = LessonState(dict(self.values), *seen, tuple(self._tried))
        picture = self.lesson.draw(state)
        with self.hold_sync():
            self.progress = progress
            self.picture = pack(picture)
            self.message = picture.says
            self._draw_on_still(picture)
            self.card = describe_card(self.lesson, progress, self.answer)
            self._show_strokes(picture.strokes, picture.page, picture.physics)
            self.drawing += 1
            self.answered += 1
        self._kept.update(self._work())

    def _draw_on_still(self, picture: Picture) -> None:
        """Set what an exported notebook shows: our own letter, and never the pupil's bet."""
        # Any: whatever a sheet holds.
        sheet: dict[str, Any] = picture.sheet or {}
        self.title = self.lesson.question
        box = None if picture.page else sheet.get("box")
        self.sheet = [float(side) for side in box or SHEET_OF_ANY_LETTER]
        self._demonstration = [
            Trajectory(np.arange(len(path), dtype=float), path) for path in sheet.get("demo", ())
        ]

    def draw_still(self) -> Still:
        """Return the letter and the robot's, with the sentence."""
        return super().draw_still()._replace(person=self._demonstration, robot=self._strokes)

    def _describe_page(self) -> dict[str, object]:
        """Return the lesson as it begins; what a pupil has done is in no page."""
        return describe_page(self.lesson)
