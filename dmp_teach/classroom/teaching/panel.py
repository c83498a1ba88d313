"""The panel of a lesson in which a robot is taught: the sheet is a writing pad."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import traitlets

from dmp_teach.classroom.lesson.packing import describe_page
from dmp_teach.classroom.lesson.panel import LessonPanel
from dmp_teach.classroom.panels.pad_view import unpack_stroke
from dmp_teach.classroom.teaching.content import TeachingContent
from dmp_teach.classroom.teaching.session import MOST_INK, TeachingSession
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.errors import LetterError, RecordingError, TeachError
from dmp_teach.files import join_modules, join_styles
from dmp_teach.ink import PadStroke, pad_recording, pad_stroke, recording_of
from dmp_teach.scoring import score, size_of
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

_HERE = Path(__file__).parent
# What is smaller than this part of our own letter is a slip of the pen.
SMALLEST_SHARE = 0.15


class TeachingPanel(LessonPanel):
    """A lesson in whose second step the sheet takes ink, which nobody keeps beyond the kernel."""

    _esm = join_modules(_HERE / "teach.js")
    _css = "\n".join([LessonPanel._css, join_styles(_HERE / "teach.css")])

    # Any: JSON for the browser.
    teaching: traitlets.Dict[str, Any] = traitlets.Dict().tag(sync=True)
    lesson: TeachingContent

    def __init__(self, lesson: TeachingContent):
        self._pen: list[PadStroke] = []
        super().__init__(lesson)

    @property
    def session(self) -> TeachingSession:
        """The session as it is now: `session.as_json()` is its log."""
        return self.lesson.session_with(self.values)

    def show(self) -> None:
        """Show the pupil what is on the sheet, and take an empty one.

        Raises:
            LetterError: Nothing is written, or no more than a dot.
        """
        if not self._pen:
            raise LetterError(_("There is nothing on the sheet yet: write the letter first."))
        shown = pad_recording(self._pen).strokes()
        book = recording_of(self.lesson.letter)
        if size_of(shown) < SMALLEST_SHARE * size_of(book.strokes()):
            words = _("That is hardly more than a dot. Press Undo, and write {letter} larger.")
            raise LetterError(words.format(letter=self.lesson.letter))
        if self.values["pupil"] != self.lesson.echo.name and not self.lesson.has_guest:
            self.lesson.echo = PupilTraits.like(score(shown, book), self.lesson.echo.name)
        self._teach(shown)

    def show_book(self) -> None:
        """Show the pupil our own letter."""
        self._teach(recording_of(self.lesson.letter).strokes())

    def answer_question(self, is_yes: bool) -> None:
        """Answer the pupil's question."""
        self.lesson.session = self.session.answer(is_yes)
        self._after_turn()

    def add_stroke(self, *stroke: Any) -> None:
        """Put a stroke on the sheet: points as in `Pad.add_stroke`, and whether they have pressure.

        Raises:
            RecordingError: No such points, or too many strokes.
        """
        if len(self._pen) >= MOST_INK:
            raise RecordingError(_("That is more than a letter: press Undo."))
        self._pen.append(pad_stroke(*stroke))
        self._draw_ink()

    def undo(self) -> None:
        """Take the last stroke off the sheet."""
        del self._pen[-1:]
        self._draw_ink()

    # Any: as traitlets calls it.
    @traitlets.observe("values")
    def _try_values(self, change: Any) -> None:
        """Set pace and forgetting to those of a pupil that was chosen, and draw."""
        old, new = change["old"], change["new"]
        chosen = [name for name in new if old and old[name] != new[name]]
        if self.progress and self.progress["step"] == "try" and chosen == ["pupil"]:
            # Which calls this again.
            self.values = new | self.lesson.habits_of(new["pupil"])
        super()._try_values(change)

    def forget(self) -> None:
        """Begin afresh, and leave nothing of what was written."""
        self._pen, self.lesson.session, self.lesson.ink = [], None, ()
        super().forget()

    def _teach(self, shown: tuple[Trajectory, ...]) -> None:
        """Let the pupil learn, and take an empty sheet."""
        self.lesson.session = self.session.show(shown)
        self._pen = []
        self.lesson.ink = ()
        self._after_turn()

    def _after_turn(self) -> None:
        """Tick what is done, and draw."""
        done = {i for i, is_done in enumerate(self.lesson.done(self.values)) if is_done}
        words = _("I learned that, but I cannot read {letter} in it. Is it one?")
        self.status = words.format(letter=self.lesson.letter) if self.session.is_doubted else ""
        self._change(done=sorted(done.union(self._progress()["done"])))

    def _draw_ink(self) -> None:
        self.lesson.ink = pad_recording(self._pen).strokes() if self._pen else ()
        self.status = ""
        self._change()

    # Any: as in the base class.
    def _hear(self, _widget: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Take a stroke, or do what a button of the session asks for."""
        kind = message.get("kind")
        hears: dict[object, Callable[[], object]] = {
            "stroke": lambda: self.add_stroke(*unpack_stroke(message, buffers, self.answered)[:2]),
            "undo": self.undo,
            "show": self.show,
            "book": self.show_book,
            "yes": lambda: self.answer_question(True),
            "no": lambda: self.answer_question(False),
        }
        if kind not in hears:
            super()._hear(_widget, message, buffers)
            return
        try:
            hears[kind]()
        except TeachError as error:
            with self.hold_sync():
                # The browser waits for what it has drawn by itself.
                self._change()
                self.message = {**self.message, "text": str(error), "strong": "", "after": ""}

    # Any: JSON for the browser.
    def _describe_page(self) -> dict[str, Any]:
        """Return the lesson as it begins, without the session: no ink is in a page."""
        fresh = type(self.lesson)(self.lesson.pupil)
        fresh.takes_ink = False
        return describe_page(fresh)

    # Any: as in the base class.
    def _redraw(self, progress: dict[str, Any]) -> None:
        """Draw the lesson, and what its pad can do."""
        is_open = progress["step"] == "try"
        session = self.session if is_open else None
        book = recording_of(self.lesson.letter).strokes()
        with self.hold_sync():
            self.teaching = {
                "is_open": is_open,
                "letter": self.lesson.letter,
                "home": book[0].position[0].tolist(),
                "asks": bool(session and session.asks),
                "strokes": len(self._pen),
            }
            super()._redraw(progress)
