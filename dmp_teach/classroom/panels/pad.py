"""The writing pad: the robot shows a letter, learns how a person writes it, and writes it again."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

import traitlets
from numpy.typing import ArrayLike

from dmp_teach.arguments import is_whole
from dmp_teach.classroom.panels import pad_messages, pad_view, sheets
from dmp_teach.classroom.panels.attempts import Attempt, Attempts, Results
from dmp_teach.classroom.panels.kept import forget, kept
from dmp_teach.classroom.panels.pen_lift import PenLift
from dmp_teach.classroom.panels.robot_panel import RobotPanel, list_letter_choices, pack_points
from dmp_teach.classroom.panels.saved_attempts import SavedAttempts, list_files
from dmp_teach.classroom.panels.still import Still
from dmp_teach.errors import RecordingError
from dmp_teach.files import join_modules, join_styles, must
from dmp_teach.ink import Recording, characters, check_pseudonym, pad_stroke, recording_of
from dmp_teach.robot import Page
from dmp_teach.scoring import MATTERS
from dmp_teach.texts import gettext as _
from dmp_teach.views import STYLE_TOKENS

_HERE = Path(__file__).parent
MAX_STROKES = 60


def pad(
    character: str | None = "a",
    page: Page | None = None,
    writer: str | None = None,
    hand: str = "right",
    strict: Collection[str] = MATTERS,
) -> Pad:
    """Show a writing pad for mouse, finger and stylus.

    The robot shows its letter, and learns yours. What is written stays in this notebook's memory
    until *Save* is pressed. The next cells have it as `pad.recording` and `pad.recordings` (every
    try in order), what the robot learned as `pad.letter`, and `pad.score`.

    Args:
        character: The letter to begin with; None for any letter, compared with nothing.
        page: Where the robot writes; None for a sheet of A4 on the table.
        writer: A pseudonym such as "w01" for what is saved; None takes the first that is free.
        hand: "left" for bars from right to left, as that of a t, on a pad the other way round whose
            paper is turned with the clock by 30 degrees: so left-handers are taught to lay it, for
            then the hand stays below the line, and neither hides nor smears what is written.
        strict: What is judged at each lift of the pen, of "start", "direction", "order", "place"
            and "size". Without the first three a letter may have any strokes, and is complete as
            soon as it can be read.

    Raises:
        RecordingError: No such letter, a word, or a writer that is no pseudonym.
        LetterError: No such hand, or another word in `strict`.
    """
    return Pad(character, page, writer, hand, strict)


class Pad(Results, pad_view.PadTraits, RobotPanel):
    """The writing pad."""

    _esm = join_modules(_HERE / "pad.js")
    _css = join_styles(
        STYLE_TOKENS, *(_HERE / sheet for sheet in ("panel.css", "paper.css", "pad.css"))
    )

    _open = ("character",)

    def __init__(
        self,
        character: str | None,
        page: Page | None,
        writer: str | None,
        hand: str,
        strict: Collection[str] = MATTERS,
    ):
        check_pseudonym(writer)
        self._pen_lift = PenLift(hand, strict)
        self.strict = self._pen_lift.strict
        self._key = f"pad {writer or ''}".strip()
        self.writer = writer or kept(self._key).get("writer")
        self._take_kept()
        self._is_done = False
        # The last question that was asked.
        self._heard = 0
        self._model: Recording | None = None
        super().__init__(page, hand=hand)
        self.choices = [["", _("any"), _("any letter"), ""], *list_letter_choices()]
        if character:
            self.character = sheets.check_character(character)
        else:
            self._choose()

    def draw_still(self) -> Still:
        """Return an empty sheet with the robot's own letter: what a pupil wrote is kept nowhere."""
        return pad_view.describe_empty_pad(self._model, self.character)

    def add_stroke(self, points: ArrayLike, pressed: bool = False, outside: int = 0) -> None:
        """Put a stroke on the sheet.

        Args:
            points: A row for each event: time [s], right and up [m], pressure 0 to 1; shape (K, 4).
            pressed: Whether the pad can tell how hard the pen is pressed.
            outside: How many of the points were beyond the sheet, and were put on its edge.

        Raises:
            RecordingError: Points that cannot be a stroke, or too many strokes; the sheet stays as
                it is.
        """
        must(is_whole(outside), "outside", outside, "a whole number")
        stroke = pad_stroke(points, pressed)
        now = self._attempts.now
        before = now.strokes if now else ()
        if now is not None and (not before or (now.is_right and not self._pen_lift.missed)):
            # A recording from a file is an attempt of its own, and so is a letter with all strokes.
            self.start_again()
            before = ()
        if len(before) >= MAX_STROKES:
            raise RecordingError(f"One letter has at most {MAX_STROKES} strokes: start again.")
        strokes = self._pen_lift.take(before, stroke)
        attempt = Attempt.of(strokes, self._model, self.writer, self.hand, self.strict)
        self.caught = pad_messages.describe_stroke(
            len(strokes), stroke if strokes[-1] is stroke else None, outside
        )
        self._put(attempt)

    def undo(self) -> None:
        """Take the last stroke off the sheet, or bring the try before onto an empty one."""
        now = self._attempts.now
        if now is None:
            self._attempts.bring_back(self._model)
            found = self._attempts.now is not None
            said = _("The try before is on your sheet again.") if found else _("Nothing to undo.")
        else:
            left = now.strokes[:-1]
            self._pen_lift.verdict = None
            said = pad_messages.describe_undone(len(now.ink), not left, self._attempts.is_back)
            self._attempts.now = (
                Attempt.of(left, now.model, self.writer, self.hand, self.strict) if left else None
            )
        self.caught = said
        self._redraw()

    def start_again(self) -> None:
        """Take an empty sheet; what was on the old one stays among the tries."""
        self._attempts.take_a_new_sheet()
        self._pen_lift.verdict = None
        self._is_done = False
        self.caught = ""
        self._redraw()

    def _show_own(self, own: Recording) -> None:
        """Put a recording on the sheet, as a try."""
        self.start_again()
        if own.character in characters():
            self.character = own.character
        attempt = Attempt(
            sheets.place_on_sheet(own, self.sheet), (), self._model, self.hand, self.strict
        )
        # What cannot be learned changes nothing.
        _written = attempt.written
        self._is_done = True
        self._put(attempt)
        self.sheet = sheets.extend_sheet(self.sheet, attempt.ink)
        self.caught = _("Your recording, {seconds:.1f} s.").format(seconds=own.duration)

    def write(self) -> None:
        """Let the robot write what it has learned, or its own letter while the sheet is empty."""
        if self._strokes:
            super().write()
        else:
            said = _("There is nothing to write yet. Choose a letter, or write one on your sheet.")
            self._refuse(said)

    def save(self) -> Path:
        """Write the newest try as JSON to where the notebook runs.

        The file has a pseudonym, and no time of day.

        Raises:
            RecordingError: Nothing is written yet.
            PathError: The folder cannot be written.
        """
        was_saved = self._saved.find(self.recording) is not None
        path = self._saved.save(self._attempts, self.writer)
        self.writer = self.writer or self.recording.writer
        kept(self._key)["writer"] = self.writer
        self.kept = pad_messages.describe_saved(path.name, was_saved)
        return path

    def forget(self) -> None:
        """Remove every try from memory, and every file that this pupil's pads saved here."""
        self._forget_robot()
        names = self._saved.forget(self.writer)
        forget(self._key)
        self._take_kept()
        self.start_again()
        self.kept = pad_messages.describe_forgotten(
            names, [path.name for path in list_files(Path.cwd())]
        )

    def _take_kept(self) -> None:
        """Go on with the tries of this pupil's pads before, of the same hand."""
        held = kept(self._key)
        tries = held.setdefault("attempts", {})
        self._attempts = Attempts(tries.setdefault(self._pen_lift.hand, []))
        self._saved = SavedAttempts(held.setdefault("saved", {}))

    # Any: JSON from the browser.
    def _hear(self, widget: object, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """Take a stroke, do what a button asks for, or open a file that was chosen."""
        kind, number = message.get("kind"), message.get("n")
        self._heard = max(self.answered, number if type(number) is int else 0)
        actions: dict[object, Callable[[], object]] = {
            "undo": self.undo,
            "again": self.start_again,
            "all": self._finish,
            "save": self.save,
            "forget": self.forget,
        }
        try:
            if kind == "stroke":
                self.add_stroke(*pad_view.unpack_stroke(message, buffers, self.answered))
            elif kind in actions:
                actions[kind]()
            else:
                super()._hear(widget, message, buffers)
        except Exception as error:
            # The browser waits for a sentence, whatever went wrong.
            said = str(error) or type(error).__name__
            self.set_trait("kept" if kind == "save" else "caught", said)
        self.answered = self._heard

    def _put(self, attempt: Attempt) -> None:
        """Put an attempt on the sheet: the verdict is out before it is scored and learned."""
        self._attempts.now = attempt
        self._show(pad_view.describe_lift(attempt, self.character, self._is_done, self._pen_lift))
        self._redraw()

    def _finish(self) -> None:
        """Take a letter with fewer strokes than the robot's as complete."""
        self._is_done = True
        self._redraw()

    @traitlets.validate("character")
    def _check(self, proposal: dict[str, object]) -> str:
        """Refuse a word before it becomes a letter."""
        return sheets.check_character(proposal["value"])

    @traitlets.observe("character")
    def _choose(self, change: object = None) -> None:
        """Take an empty sheet in the size of another letter."""
        model = recording_of(self.character, hand=self.hand) if self.character else None
        strokes = model.strokes() if model else ()
        # Its strokes are asked for at each lift, and found once.
        ends = [(stroke.t[0], stroke.t[-1]) for stroke in strokes]
        self._model = model.with_strokes(ends) if model else None
        self._pen_lift.begin(self._model)
        with self.hold_sync():
            self.wanted = pad_messages.add_article(self.character)
            self.sheet = sheets.fit_pad_sheet(strokes)
            self.lines = sheets.find_writing_lines()
            self.model = pack_points(strokes)
            self.model_times = [(stroke.t - strokes[0].t[0]).tolist() for stroke in strokes]
            self.start_again()

    def _redraw(self) -> None:
        """Show what is on the sheet, what the robot would write, and what there is to say."""
        now = self._attempts.now
        strokes = self._model.strokes() if self._model else ()
        if now is not None:
            strokes = now.written
        with self.hold_sync():
            self._size = None
            self._show_strokes(strokes)
            self.robot_counts = [len(stroke) for stroke in strokes]
            self._show(
                pad_view.describe_pad(self._attempts, self._model, self._is_done, self._pen_lift)
            )
            self.drawing += 1

    def _show(self, traits: dict[str, object]) -> None:
        """Send the browser what the last question is answered with: it draws the sheet."""
        with self.hold_sync():
            for name, value in traits.items():
                self.set_trait(name, value)
            self.kept = ""
            self.answered = self._heard
