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
from dmp_teach.classroom.lesson.packing import describe_lesson, pack
from dmp_teach.classroom.lesson.work_file import (
    find_free_pupil,
    forget_work,
    read_work,
    save_work,
)
from dmp_teach.classroom.panels.kept import forget, kept
from dmp_teach.classroom.panels.robot_panel import RobotPanel
from dmp_teach.classroom.panels.sheets import SHEET_OF_ANY_LETTER
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import SettingError, TeachError
from dmp_teach.files import join_modules, join_styles
from dmp_teach.robot import Motion
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import STYLE_TOKENS

_HERE = Path(__file__).parent
_PANELS = _HERE.parent / "panels"
LESSON_STEPS = ("bet", "try", "challenge")
# So many of the pupil's settings are drawn as tried.
MOST_TRIED = 200
HINTS_AFTER_MISSES = 2


class LessonPanel(RobotPanel):
    """A lesson as a pupil sees it.

    `values` are the knobs, which may be set from Python, too; `answer` is what `teach.check` takes.
    The browser keeps `progress` while the page is open; the kernel keeps it while it lives.
    """

    _esm = join_modules(_HERE / "lesson.js")
    _css = join_styles(
        STYLE_TOKENS,
        *(_PANELS / f"{name}.css" for name in ("panel", "paper", "plot")),
        _HERE / "lesson.css",
    )

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
        self._key = f"lesson {lesson.key} {lesson.pupil or ''}"
        self._kept = kept(self._key)
        self._tried: list[Answer] = []
        super().__init__(spec=describe_lesson(lesson))
        self._restore(dict(self._kept) or self._read_saved())

    @property
    def answer(self) -> Answer:
        """What is set now: the answer that `teach.check` judges."""
        return {name: self.values[name] for name in self.lesson.settable}

    # What is kept ---------------------------------------------------------------------------------

    def _restore(self, work: dict[str, Any]) -> None:
        """Take up work where it was left; what does not fit the lesson begins afresh."""
        fresh: dict[str, Any] = {"step": "bet", "bet": None, "revealed": False, "done": []}
        fresh |= {"hints": 0, "misses": 0, "verdict": None, "passed": False, "saved_as": None}
        progress = {name: work.get("progress", {}).get(name, fresh[name]) for name in fresh}
        values = work.get("values", self.lesson.start)
        try:
            values = check_answer(self.lesson.knobs, values)
            if progress["bet"] is not None:
                progress["bet"] = self.lesson.bet.checked(progress["bet"])
        except SettingError:
            progress, values = fresh, dict(self.lesson.start)
        if progress["step"] not in LESSON_STEPS:
            progress["step"] = "bet"
        self._tried = [each for each in work.get("tried", []) if isinstance(each, dict)]
        with self.hold_sync(), self.hold_trait_notifications():
            self.values = values
        self._redraw(progress)

    def _read_saved(self) -> dict[str, Any]:
        """Return the work that the pupil has saved; what cannot be read is told and left alone."""
        try:
            saved = read_work(Path.cwd(), self.lesson.pupil) if self.lesson.pupil else {}
        except (TeachError, OSError) as error:
            self.status = str(error)
            saved = {}
        work = saved.get(self.lesson.key, {})
        return work if isinstance(work, dict) else {}

    def _keep(self) -> None:
        """Keep the work as it is now."""
        self._kept.update(values=self.values, progress=self.progress, tried=self._tried)

    # What the browser asks for --------------------------------------------------------------------

    # Any: as in the base class.
    def _hear(self, _widget: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Do what a button of the lesson asks for, or what one of the robot does."""
        kind = message.get("kind")
        if kind == "bet":
            self.bet(message["bet"])
        elif kind == "reveal":
            self.reveal()
        elif kind == "step":
            self.go(message["step"])
        elif kind == "check":
            self.check()
        elif kind == "hint":
            self.show_hint()
        elif kind == "restore":
            if not self._kept.get("progress", {}).get("bet"):
                self._restore(message["work"])
        elif kind == "save":
            self._try(self.save)
        elif kind == "forget":
            self._try(self.forget)
        else:
            super()._hear(_widget, message, buffers)

    def bet(self, bet: KeptBet) -> None:
        """Keep a bet: an option's name, or a place [x, y] for each handle.

        Raises:
            SettingError: It is no bet of this lesson.
        """
        self._change(bet=self.lesson.bet.checked(bet))

    def reveal(self) -> None:
        """Lay the truth over the bet, once there is one."""
        if self.progress["bet"] is not None:
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
        verdict = self.lesson.check(self.answer, self.progress["hints"])
        misses = self.progress["misses"] + (not verdict.done)
        passed = self.progress["passed"] or verdict.done
        packed = {"done": verdict.done, "reason": verdict.reason}
        self._change(verdict=packed, misses=misses, passed=passed)
        return verdict

    def show_hint(self) -> None:
        """Show one hint more."""
        self._change(hints=min(self.progress["hints"] + 1, len(self.lesson.hints)))

    def save(self) -> Path:
        """Write the work to the file of the pupil, in the folder of the notebook.

        Raises:
            RecordingError: A file of that name is there that is not ours.
            PathError: The folder cannot be written.
        """
        folder = Path.cwd()
        pupil = self.lesson.pupil or self.progress["saved_as"] or find_free_pupil(folder)
        work = {"values": self.values, "progress": self.progress | {"saved_as": pupil}}
        path = save_work(folder, pupil, self.lesson.key, work)
        self._change(saved_as=pupil)
        self.status = _("Saved as {name}.").format(name=path.name)
        return path

    def forget(self) -> None:
        """Begin afresh, and leave nothing of what was done, in no file either."""
        pupil = self.lesson.pupil or self.progress["saved_as"]
        gone = forget_work(Path.cwd(), pupil) if pupil else []
        forget(self._key)
        self._tried = []
        self._restore({})
        words = _("Everything is forgotten.")
        self.status = f"{words} {', '.join(gone)}" if gone else words

    def _try(self, do: Callable[[], object]) -> None:
        """Save or forget, or say why it cannot be done."""
        try:
            do()
        except (TeachError, OSError) as error:
            self.status = str(error)

    # Any: as `progress`.
    def _change(self, **changes: Any) -> None:
        """Change the progress, and show it."""
        self._redraw(self.progress | changes)

    @traitlets.validate("values")
    def _refuse_other_values(self, proposal: dict[str, Any]) -> dict[str, Any]:
        """Return values, every one on its knob, or raise a SettingError that says what is not."""
        return check_answer(self.lesson.knobs, proposal["value"])

    @traitlets.observe("values")
    def _try_values(self, _change: object) -> None:
        """Draw anew; a verdict was on other values, and a task may be done."""
        if not self.progress:
            return
        if self.progress["step"] != "bet":
            self._tried = [*self._tried, dict(self.values)][-MOST_TRIED:]
        done = set(self.progress["done"])
        if self.progress["step"] == "try":
            done |= {i for i, task in enumerate(self.lesson.tasks) if task.is_done(self.values)}
        self._change(done=sorted(done), verdict=None)

    def _show_result(self, result: object) -> None:
        """Show the motion, and tick what the robot was to do; or say what it cannot."""
        super()._show_result(result)
        if isinstance(result, Motion) and self.progress["step"] == "try":
            written = {i for i, task in enumerate(self.lesson.tasks) if task.by_robot}
            self._change(done=sorted(written.union(self.progress["done"])))

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
            self.picture = pack({"sheet": picture.sheet, "plots": picture.plots})
            self.message = picture.says
            self._draw_on_still(picture)
            self.card = self._write_card(picture)
            self._show_strokes(picture.strokes)
            self.drawing += 1
            self.answered += 1
        self._keep()

    def _draw_on_still(self, picture: Picture) -> None:
        """Set what an exported notebook shows: our own letter, and never the pupil's bet."""
        # Any: whatever a sheet holds.
        sheet: dict[str, Any] = picture.sheet or {"box": SHEET_OF_ANY_LETTER}
        self.title = self.lesson.question
        self.sheet = [float(side) for side in sheet["box"]]
        self._demonstration = [
            Trajectory(np.arange(len(path), dtype=float), path) for path in sheet.get("demo", ())
        ]

    def draw_still(self) -> Still:
        """Return the letter and the robot's, with the sentence."""
        return super().draw_still()._replace(person=self._demonstration, robot=self._strokes)

    def _write_card(self, picture: Picture) -> dict[str, Any]:
        """Return the words of the step."""
        lesson, progress = self.lesson, self.progress
        conditions = lesson.conditions(self.answer) if progress["step"] == "challenge" else ()
        hints = list(lesson.hints[: progress["hints"]])
        bet = lesson.tell_bet(progress["bet"]) if progress["revealed"] else ""
        offered = progress["misses"] >= HINTS_AFTER_MISSES and len(hints) < len(lesson.hints)
        return {
            "bet": bet,
            "rows": [[each.name, each.shown, each.rule, each.is_met] for each in conditions],
            "hints": hints,
            "offersHint": offered and not progress["passed"],
        }
