"""What somebody wrote on the pad, try by try: the ink, what a robot learns from it, and how near it is to the model."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self

from dmp_teach.classroom.panels.messages import beside, millimetres
from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.ink import PadStroke, Recording, pad_recording
from dmp_teach.letters import Letter
from dmp_teach.scoring import Score, score, size_of
from dmp_teach.trajectory import Trajectory


@dataclass(frozen=True, eq=False)
class Try:
    """One writing of a letter.

    Args:
        recording: The ink, a recording like any other.
        strokes: As the pad caught them; none where the recording came from a file.
        model: The robot's letter that was to be written, or None.
    """

    recording: Recording
    strokes: tuple[PadStroke, ...] = ()
    model: Recording | None = None

    @classmethod
    def of(
        cls, strokes: tuple[PadStroke, ...], model: Recording | None, writer: str | None
    ) -> Self:
        """A try of these strokes, of the model's letter, on the writing line y = 0."""
        character = None if model is None else model.character
        return cls(
            pad_recording(strokes, character=character, writer=writer, baseline=0.0), strokes, model
        )

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
        """How near it is to the model; None without a model, or where it has no shape: a dot, or two."""
        try:
            return None if self.model is None else score(self.recording, self.model)
        except LetterError:
            return None

    @property
    def size(self) -> float:
        """How large the model is, the longer of its sides [m]."""
        return size_of(self.model.strokes())

    @property
    def laid(self) -> tuple[Trajectory, ...]:
        """Its ink, laid on the model."""
        return tuple(
            replace(stroke, position=stroke.position + self.score.shift) for stroke in self.ink
        )

    def named(self, writer: str) -> Self:
        """The same, under a pseudonym."""
        return replace(self, recording=replace(self.recording, writer=writer))

    @property
    def is_coarse(self) -> bool:
        """Whether the pad caught too few points of a stroke to tell how the pen was moved."""
        return any(stroke.is_coarse for stroke in self.strokes)

    @property
    def is_short(self) -> bool:
        """Whether the model has more strokes."""
        return self.model is not None and len(self.ink) < len(self.model.strokes())


class Tries:
    """Every try in order, the one on the sheet last; nothing of it is written anywhere.

    A try that was brought back stays in its place, too: whatever is then done to the sheet, it is not lost.
    """

    def __init__(self) -> None:
        self._all: list[Try | None] = [None]  # None: the sheet is empty

    @property
    def now(self) -> Try | None:
        """What is on the sheet."""
        return self._all[-1]

    @now.setter
    def now(self, value: Try | None) -> None:
        """Put something else on the sheet."""
        self._all[-1] = value

    @property
    def newest(self) -> Try:
        """What is on the sheet, or the try before; a RecordingError while there is none."""
        newest = next((each for each in reversed(self._all) if each is not None), None)
        if newest is None:
            raise RecordingError("Nothing is written on the pad yet: write a letter first.")
        return newest

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """The ink of every try."""
        return tuple(each.recording for each in self._each())

    @property
    def is_back(self) -> bool:
        """Whether what is on the sheet is the try before, brought back and not changed since."""
        return self.now is not None and self.now in self._all[:-1]

    def take_a_new_sheet(self) -> None:
        """The try on the sheet stays among the others."""
        if self.is_back:
            self.now = None
        elif self.now is not None:
            self._all.append(None)

    def bring_back(self, model: Recording | None) -> None:
        """Onto an empty sheet the try before, if that is a try of the same letter."""
        if len(self._all) > 1 and self._all[-2].model is model:
            self.now = self._all[-2]

    def name_the_newest(self, writer: str) -> Try:
        """The newest try under a pseudonym, in the place of the one without."""
        newest, named = self.newest, self.newest.named(writer)
        self._all = [named if each is newest else each for each in self._all]
        return named

    def scored(self, model: Recording | None, done: bool) -> list[Try]:
        """The tries of one letter that have a score; that on the sheet only if it is done."""
        tries = self._each(None if done else -1)
        return [each for each in tries if each.model is model and each.score is not None]

    def _each(self, end: int | None = None) -> list[Try]:
        """Every try once, up to a place in the list."""
        return list(dict.fromkeys(each for each in self._all[:end] if each is not None))


def as_rows(tries: list[Try], first: int) -> list[dict[str, Any]]:
    """Tries with a score as the browser shows them; `first` is the number of the first one."""
    words = [(millimetres(each.score.distance), beside(each.score, each.size)) for each in tries]
    return [
        {"number": n, "mm": mm, "word": word, "counts": [len(stroke) for stroke in each.ink]}
        for n, (each, (mm, word)) in enumerate(zip(tries, words, strict=True), first)
    ]
