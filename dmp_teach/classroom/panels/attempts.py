"""What was written on the pad, attempt by attempt: ink, what a robot learns of it, its score."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np

from dmp_teach.classroom.panels.messages import show_millimetres
from dmp_teach.classroom.panels.pad_messages import rate_attempt
from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.ink import PadStroke, Recording, characters, pad_recording
from dmp_teach.letters import Letter
from dmp_teach.scoring import MATTERS, Score, list_reasons, read_letter, score, size_of
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory


@dataclass(frozen=True, eq=False)
class Attempt:
    """One writing of a letter.

    Args:
        recording: The ink, a recording like any other.
        strokes: As the pad caught them; none where the recording came from a file.
        model: The robot's letter that was to be written, or None.
        hand: As in `score`.
        strict: As in `score`.
    """

    recording: Recording
    strokes: tuple[PadStroke, ...] = ()
    model: Recording | None = None
    hand: str = "right"
    strict: tuple[str, ...] = MATTERS

    @classmethod
    def of(
        cls,
        strokes: tuple[PadStroke, ...],
        model: Recording | None,
        writer: str | None,
        hand: str = "right",
        strict: tuple[str, ...] = MATTERS,
    ) -> Self:
        """Make an attempt at the model's letter, on the writing line y = 0."""
        character = None if model is None else model.character
        recording = pad_recording(strokes, character=character, writer=writer, baseline=0.0)
        return cls(recording, strokes, model, hand, strict)

    @cached_property
    def ink(self) -> tuple[Trajectory, ...]:
        """The strokes on the clock of the recording."""
        return self.recording.strokes()

    @cached_property
    def letter(self) -> Letter:
        """What a robot learns from it."""
        return Letter.learn(self.ink)

    @cached_property
    def written(self) -> tuple[Trajectory, ...]:
        """What the robot then writes."""
        return self.letter.write()

    @cached_property
    def score(self) -> Score | None:
        """How near it is to the model; None without a model, or where it is only dots."""
        if self.model is None or self.is_dot:
            return None
        try:
            return score(self.recording, self.model, self.hand, self.strict)
        except LetterError:
            return None

    @cached_property
    def looks_like(self) -> str | None:
        """The other letter that it looks like, "" for none at all; None where it may be right."""
        found = self.score
        is_known = self.character in characters()
        if found is None or not is_known or found.matching.mirrored:
            return None
        # What is turned is read upright: so somebody may write on the turned sheet of a left hand.
        cos, sin = np.cos(np.radians(found.turn)), np.sin(np.radians(found.turn))
        back = np.array([[cos, -sin], [sin, cos]])
        upright = [replace(stroke, position=stroke.position @ back) for stroke in self.ink]
        return read_letter(upright, self.character)

    @property
    def is_dot(self) -> bool:
        """Whether the pen hardly moved, as in a slip."""
        return bool(self.strokes) and all(stroke.is_dot for stroke in self.strokes)

    @property
    def aligned(self) -> tuple[Trajectory, ...]:
        """The ink laid on the model, as the score does."""
        if self.score is None:
            return self.ink
        shift = self.score.shift
        return tuple(replace(stroke, position=stroke.position + shift) for stroke in self.ink)

    def named(self, writer: str) -> Self:
        """Return the same under a pseudonym."""
        return replace(self, recording=replace(self.recording, writer=writer))

    @property
    def is_coarse(self) -> bool:
        """Whether the pad caught too few points of a stroke to tell how the pen was moved."""
        return any(stroke.is_coarse for stroke in self.strokes)

    @property
    def character(self) -> str:
        """The letter that was to be written, "" for any."""
        return "" if self.model is None else str(self.model.character)

    @property
    def missing_strokes(self) -> int:
        """How many strokes the model has more; 0 where a letter may be written in any way."""
        if self.model is None or self.is_free:
            return 0
        return max(0, len(self.model.strokes()) - len(self.ink))

    @property
    def is_free(self) -> bool:
        """Whether the letter may be written in any way, with as many strokes as one likes."""
        return "lift" not in list_reasons(self.strict)

    @property
    def is_whole(self) -> bool:
        """Whether all of the letter is there.

        It has the model's number of strokes or, where it may be written in any way, can be read.
        """
        if self.model is None or not self.is_free:
            return not self.missing_strokes
        found = self.score
        return found is not None and not found.matching.missing and self.looks_like is None

    @property
    def is_right(self) -> bool:
        """Whether all strokes of the model are there and no others, and it can be read."""
        if self.is_free or not self.is_whole or self.score is None or self.looks_like is not None:
            return False
        return not self.score.matching.missing and not self.score.matching.extra

    def is_at(self, model: Recording | None) -> bool:
        """Whether it was this letter, in this script, that was to be written."""
        mine = self.model
        if mine is None or model is None:
            return mine is model
        alike = mine.character == model.character
        return alike and np.array_equal(mine.position, model.position)


class Attempts:
    """Every attempt in order, and the one on the sheet; nothing of it is written anywhere.

    An attempt that was brought back stays in its place, too: whatever is then done to the sheet,
    it is not lost.
    """

    def __init__(self, before: list[Attempt] | None = None) -> None:
        """Take an empty sheet; attempts are added to the list of those before."""
        self._all = [] if before is None else before
        self._now: Attempt | None = None
        self._is_back = False

    @property
    def now(self) -> Attempt | None:
        """What is on the sheet, or None while it is empty."""
        return self._now

    @now.setter
    def now(self, value: Attempt | None) -> None:
        """Put something else on the sheet."""
        at = len(self._all)
        if self._now in self._all and not self._is_back:
            at = self._all.index(self._now)
        self._all[at : at + 1] = [] if value is None else [value]
        self._now, self._is_back = value, False

    @property
    def newest(self) -> Attempt:
        """What is on the sheet, or the attempt before; a RecordingError while there is none."""
        if self._now is not None or self._all:
            return self._now or self._all[-1]
        raise RecordingError("Nothing is written on the pad yet: write a letter first.")

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """The ink of every attempt."""
        return tuple(each.recording for each in self._all)

    @property
    def is_back(self) -> bool:
        """Whether what is on the sheet is the attempt before, brought back and unchanged."""
        return self._is_back

    def take_a_new_sheet(self) -> None:
        """Leave the attempt on the sheet among the others."""
        self._now, self._is_back = None, False

    def bring_back(self, model: Recording | None) -> None:
        """Put the attempt before onto an empty sheet, if it is one at the same letter."""
        if self._all and self._all[-1].is_at(model):
            self._now, self._is_back = self._all[-1], True

    def name_the_newest(self, writer: str) -> Attempt:
        """Put the newest attempt under a pseudonym in the place of the one without."""
        newest = self.newest
        named = newest.named(writer)
        self._all[self._all.index(newest)] = named
        if self._now is newest:
            self._now = named
        return named

    def scored(self, model: Recording | None, with_sheet: bool) -> list[Attempt]:
        """Return the attempts at one letter that have a score, with that on the sheet or not."""
        return [
            each
            for each in self._all
            if each.is_at(model)
            and (with_sheet or each is not self._now)
            and each.score is not None
        ]


class Results:
    """What the next cells have of a pad."""

    _attempts: Attempts

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """Every try, in order."""
        return self._attempts.recordings

    @property
    def recording(self) -> Recording:
        """The newest try; a RecordingError while there is none."""
        return self._attempts.newest.recording

    @property
    def letter(self) -> Letter:
        """What the robot learned from the newest try."""
        return self._attempts.newest.letter

    @property
    def score(self) -> Score | None:
        """How near the newest try is to the robot's letter; None where no letter was chosen."""
        return self._attempts.newest.score

    @property
    def error(self) -> float | None:
        """How far the newest try is from the robot's letter [m]; None without a `score`."""
        return None if self.score is None else self.score.distance


def list_rows(attempts: list[Attempt], first: int) -> list[dict[str, object]]:
    """Return attempts with a score as the browser shows them, numbered from `first`."""
    rows: list[dict[str, object]] = []
    for number, attempt in enumerate(attempts, first):
        if attempt.score is not None and attempt.model is not None:
            word = rate_attempt(attempt.score, size_of(attempt.model.strokes()))
            word = word if attempt.looks_like is None else _("far")
            millimetres = show_millimetres(attempt.score.distance)
            counts = [len(stroke) for stroke in attempt.ink]
            rows.append({"number": number, "mm": millimetres, "word": word, "counts": counts})
    return rows
