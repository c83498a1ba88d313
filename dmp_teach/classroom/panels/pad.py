"""The writing pad: the robot shows a letter, somebody writes it, and the robot learns it and writes it again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import traitlets

from dmp_teach.classroom.panels import messages as words
from dmp_teach.classroom.panels.attempts import Tries, Try, as_rows
from dmp_teach.classroom.panels.robot_panel import RobotPanel, bundle, bytes_of, letter_choices
from dmp_teach.classroom.panels.saved_attempts import Kept
from dmp_teach.classroom.panels.sheets import around, laid_on, one_letter, sheet_of, writing_lines
from dmp_teach.errors import RecordingError
from dmp_teach.files import bundle as bundled
from dmp_teach.formats import read_recording
from dmp_teach.ink import Recording, characters, check_pseudonym, pad_stroke, recording_of
from dmp_teach.letters import Letter
from dmp_teach.robot import Page
from dmp_teach.scoring import Score
from dmp_teach.views import read_beside

_NEAR = "aeimDP"
_STRIP = 6  # tries that are shown; all are kept
_MOST_STROKES = 60


def pad(character: str | None = "a", page: Page | None = None, writer: str | None = None) -> Pad:
    """A writing pad for mouse, finger and stylus: the robot shows its letter, and learns yours.

    What is written stays in this notebook's memory until *Save* is pressed. The next cells have it as `pad.recording`
    and `pad.recordings` (every try in order), what the robot learned as `pad.letter`, and `pad.score`.

    Args:
        character: The letter to begin with; None for any letter, compared with nothing.
        page: Where the robot writes; None for a sheet of A4 on the table.
        writer: A pseudonym such as "w01" for what is saved; None takes the first that is free.

    Raises:
        RecordingError: No such letter, a word, or a writer that is no pseudonym.
    """
    return Pad(character, page, writer)


class Pad(RobotPanel):
    """The panel. The letter to be written is the trait `character`, "" for any."""

    _esm = bundled(Path(__file__).with_name("pad.js"))
    _css = read_beside("tokens.css") + bundle("panel.css", "paper.css", "pad.css")

    choices = traitlets.List().tag(sync=True)
    near = traitlets.List(["", *_NEAR]).tag(sync=True)
    character = traitlets.Unicode().tag(sync=True)
    sheet = traitlets.List().tag(sync=True)
    lines = traitlets.List().tag(sync=True)
    model = traitlets.Bytes().tag(sync=True)
    model_times = traitlets.List().tag(sync=True)
    robot_counts = traitlets.List().tag(sync=True)
    ink = traitlets.Bytes().tag(sync=True)
    counts = traitlets.List().tag(sync=True)
    caught = traitlets.Unicode().tag(sync=True)
    message = traitlets.Dict().tag(sync=True)
    parts = traitlets.List().tag(sync=True)
    tries = traitlets.List().tag(sync=True)
    tried = traitlets.Bytes().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    shift = traitlets.List([0.0, 0.0]).tag(sync=True)
    unfinished = traitlets.Bool(False).tag(sync=True)
    kept = traitlets.Unicode().tag(sync=True)
    drawing = traitlets.Int(0).tag(sync=True)
    answered = traitlets.Int(0).tag(sync=True)

    def __init__(
        self, character: str | None = "a", page: Page | None = None, writer: str | None = None
    ):
        check_pseudonym(writer)
        self.writer = writer
        self._tries = Tries()
        self._done = False
        self._files = Kept()
        self._model: Recording | None = None
        super().__init__(page)
        self.choices = [["", "any", "any letter", ""], *letter_choices()]
        if character:
            self.character = one_letter(character)
        else:
            self._choose()

    # What the next cells ask ---------------------------------------------------------------------

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """Every try, in order."""
        return self._tries.recordings

    @property
    def recording(self) -> Recording:
        """The newest try; a RecordingError while there is none."""
        return self._tries.newest.recording

    @property
    def letter(self) -> Letter:
        """What the robot learned from the newest try."""
        return self._tries.newest.letter

    @property
    def score(self) -> Score | None:
        """How near the newest try is to the robot's letter; None where no letter was chosen."""
        return self._tries.newest.score

    # What the person does ------------------------------------------------------------------------

    def add_stroke(self, points: Any, pressed: bool = False, outside: int = 0) -> None:
        """Put a stroke on the sheet.

        Args:
            points: A row for each event: time [s], right and up [m], pressure 0 to 1; shape (K, 4).
            pressed: Whether the pad can tell how hard the pen is pressed.
            outside: How many of the points were beyond the sheet, and were put on its edge.

        Raises:
            RecordingError: Points that cannot be a stroke, or too many strokes; the sheet stays as it is.
        """
        stroke, now = pad_stroke(points, pressed), self._tries.now
        if now is not None and not now.strokes:  # a recording from a file is a try of its own
            self.start_again()
            now = None
        strokes = (*(now.strokes if now else ()), stroke)
        if len(strokes) > _MOST_STROKES:
            raise RecordingError(f"One letter has at most {_MOST_STROKES} strokes: start again.")
        self._lay(Try.of(strokes, self._model, self.writer))
        self.caught = words.caught(len(strokes), stroke, outside)

    def undo(self) -> None:
        """Take the last stroke off the sheet; onto an empty sheet bring the try before, which stays among the tries."""
        now = self._tries.now
        if now is None:
            self._tries.bring_back(self._model)
            self.caught = (
                "Nothing to undo."
                if self._tries.now is None
                else "The try before is on your sheet again."
            )
        else:
            left, stays = now.strokes[:-1], " The try before stays." if self._tries.is_back else ""
            self._tries.now = Try.of(left, now.model, self.writer) if left else None
            self.caught = (
                f"Stroke {len(now.ink)} is gone." if left else "The sheet is empty."
            ) + stays
        self._redraw()

    def start_again(self) -> None:
        """Take an empty sheet; what was on the old one stays among the tries."""
        self._tries.take_a_new_sheet()
        self._done, self.caught = False, ""
        self._redraw()

    def load(self, recording: Recording | str | Path) -> None:
        """Put a recording of one's own on the sheet, as a try."""
        own = recording if isinstance(recording, Recording) else read_recording(recording)
        if not own.strokes():
            raise RecordingError("There is no stroke in this recording: the pen never wrote.")
        self.start_again()
        if own.character in characters():
            self.character = own.character
        laid = Try(laid_on(own, self.sheet), (), self._model)
        self._done = True
        self._lay(laid)
        self.sheet = around(self.sheet, laid.ink)
        self.caught = f"Your recording, {own.duration:.1f} s."

    def write(self) -> None:
        """Let the robot write what it has learned, or its own letter while the sheet is empty."""
        if self._written:
            super().write()
        else:
            self._cannot(
                "There is nothing to write yet. Choose a letter, or write one on your sheet."
            )

    def save(self) -> Path:
        """Write the newest try as JSON to where the notebook runs, under a pseudonym and without a time of day.

        Raises:
            RecordingError: Nothing is written yet.
            PathError: The folder cannot be written.
        """
        path = self._files.save(self._tries, self.writer)
        self.writer = self.writer or self.recording.writer
        self.kept = f"Saved as {path.name}, beside this notebook. Other tries are not kept."
        return path

    def forget(self) -> None:
        """Remove every try from memory and every file that this pad has saved."""
        if self._job:
            self._job.stop()
        names = self._files.forget()
        self._tries, self.motion, self._on_the_table = Tries(), None, b""
        if self.scene is not None:
            self.scene.show(None)
        self._done, self.caught = False, ""
        self._redraw()
        self.kept = (
            f"Everything is forgotten, and {names} removed."
            if names
            else "Everything is forgotten."
        )

    def _hear(self, _: Any, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """A stroke was written, a button was pressed, or a file was chosen."""
        kind, number = message.get("kind"), message.get("n")
        doing = {
            "undo": self.undo,
            "again": self.start_again,
            "all": self._all,
            "save": self.save,
            "forget": self.forget,
        }
        try:
            if kind == "stroke":
                self._stroke_came(message, buffers)
            elif kind in doing:
                doing[kind]()
            else:
                super()._hear(_, message, buffers)
        except Exception as error:  # nobody else hears it: the browser waits for a sentence
            setattr(
                self, "kept" if kind == "save" else "caught", str(error) or type(error).__name__
            )
        self.answered = max(self.answered, number if type(number) is int else 0)

    def _stroke_came(self, message: dict[str, Any], buffers: list[memoryview]) -> None:
        """A stroke from the browser: float64 rows t [s], x, y [m], pressure."""
        if type(message.get("n")) is int and message["n"] <= self.answered:
            raise RecordingError("A stroke came twice, or too late, and was left out.")
        content = b"".join(map(bytes, buffers))
        if not content or len(content) % 32:
            raise RecordingError("A stroke came in pieces and was left out: write it again.")
        rows, outside = np.frombuffer(content, "<f8").reshape(-1, 4), message.get("outside")
        self.add_stroke(
            rows, message.get("pointer") == "pen", outside if type(outside) is int else 0
        )

    def _lay(self, new: Try) -> None:
        """Put a try on the sheet, once the robot has learned it: what cannot be learned changes nothing."""
        _ = new.written, new.score
        self._tries.now = new
        self._redraw()

    def _all(self) -> None:
        """The letter has fewer strokes than the robot's, and is complete."""
        self._done = True
        self._redraw()

    # What is seen --------------------------------------------------------------------------------

    @traitlets.validate("character")
    def _one_letter(self, proposal: Any) -> str:
        """A word is refused before it is a letter."""
        return one_letter(proposal["value"])

    @traitlets.observe("character")
    def _choose(self, change: Any = None) -> None:
        """Another letter to be written: an empty sheet, in its size."""
        self._model = recording_of(self.character) if self.character else None
        strokes = self._model.strokes() if self._model else ()
        with self.hold_sync():
            self.sheet, self.lines = sheet_of(strokes), writing_lines()
            self.model, self.model_times = (
                bytes_of(strokes),
                [(s.t - strokes[0].t[0]).tolist() for s in strokes],
            )
            self.start_again()

    def _redraw(self) -> None:
        """Learn and write again, and say what there is to say."""
        now = self._tries.now
        with self.hold_sync():
            ink = now.ink if now else ()
            self._written = now.written if now else self._model.strokes() if self._model else ()
            self._size = None
            self.ink, self.counts = bytes_of(ink), [len(stroke) for stroke in ink]
            self.robot, self.robot_counts = (
                bytes_of(self._written),
                [len(stroke) for stroke in self._written],
            )
            self.unfinished = now is not None and now.is_short and not self._done
            scored = self._tries.scored(self._model, done=not self.unfinished)
            self._describe(now, [each for each in scored if each is not now])
            self._list_tries(scored)
            self.shift = now.score.shift.tolist() if now in scored else [0.0, 0.0]
            self._mark_older()
            self.kept = ""
            self.drawing += 1

    def _describe(self, now: Try | None, before: list[Try]) -> None:
        """The number, the sentence, the three rows and the text alternative."""
        self.parts = []
        if now is None:
            self.message = words.invitation(self.character)
        elif self.unfinished:
            self.message = words.next_stroke(len(now.ink), len(now.model.strokes()), self.character)
        elif now.score is None and self.character:
            self.message = words.dot_message(self.character)
        elif now.score is None:
            self.message = words.learned_message(now.letter.error)
        else:
            self.message = words.try_message(
                now.score, before[-1].score if before else None, now.is_coarse
            )
            rows = now.score.parts
            self.parts = [
                {"name": p.name, "level": p.level, "word": p.word, "reason": p.reason} for p in rows
            ]
        said = self.message["text"] + self.message["strong"] if now else ""
        self.title = words.pad_title(self.character, len(now.ink) if now else 0, said)

    def _list_tries(self, scored: list[Try]) -> None:
        """The newest tries of this letter, with their numbers."""
        shown = scored[-_STRIP:]
        self.tries = as_rows(shown, len(scored) - len(shown) + 1)
        self.tried = bytes_of(tuple(stroke for each in shown for stroke in each.laid))
