"""A session of teaching: a log without identity that replays to the bit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any, Self

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.classroom.teaching.pupil import RobotPupil, is_good
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.errors import RecordingError, shown
from dmp_teach.files import checked_object, must
from dmp_teach.ink import LONGEST_PAD_STROKE, recording_of
from dmp_teach.scoring import LetterLike, read_letter, to_strokes
from dmp_teach.trajectory import Trajectory
from dmp_teach.values import Value

FORMAT, SESSION_VERSION = "dmp_teach teaching", 1
SESSION_FIELDS = ("format", "version", "letter", "pupil", "turns")
# A log keeps whole milliseconds and hundredths of a millimetre.
TICK, GRAIN = 1e-3, 1e-5
MOST_TURNS, MOST_INK = 100, 20
# Numbers beyond this are not kept exactly.
MOST_TICKS = 2**53

# Of each stroke: t [ms], x, y [0.01 mm], point by point.
LoggedStrokes = list[list[list[int]]]


@dataclass(frozen=True, eq=False, repr=False)
class TeachingTurn(Value):
    """One turn: what was shown, and what was answered to the question, if anything."""

    strokes: LoggedStrokes
    answer: bool | None = None


@dataclass(frozen=True, eq=False, repr=False)
class TeachingSession(Value):
    """A pupil that is taught, turn by turn; made by `TeachingSession.begin`.

    Args:
        traits: Of the pupil.
        letter: What it is taught.
        turns: Every turn, in order.
        shown: The pupil when it had been shown each turn, before its question was answered.
        met: The pupil as it came to each turn, and as it would come to the next.
        far: How far each of these was from the letter that was shown last [m].
        learned: How far it was when it had been shown each turn [m].
        good: Whether it was good then.
        read: Whether what was shown each turn may well be the letter.
        placed: What was shown last, laid on what the pupil then wrote.
    """

    traits: PupilTraits
    letter: str
    turns: tuple[TeachingTurn, ...] = ()
    shown: tuple[RobotPupil, ...] = ()
    met: tuple[RobotPupil, ...] = ()
    far: tuple[float, ...] = ()
    learned: tuple[float, ...] = ()
    good: tuple[bool, ...] = ()
    read: tuple[bool, ...] = ()
    placed: tuple[Trajectory, ...] = ()

    @classmethod
    def begin(cls, traits: PupilTraits | str | PathLike[str], letter: str) -> Self:
        """Return a session in which nothing was shown yet; arguments as of `RobotPupil.load`."""
        pupil = RobotPupil.load(traits, letter)
        return cls(pupil.memory.traits, letter, met=(pupil,), far=(pupil.score().distance,))

    @checked
    def show(self, demonstration: LetterLike) -> Self:
        """Return the session with one turn more.

        Raises:
            LetterError: No strokes.
            RecordingError: More turns than a session has, more strokes than a letter, or a stroke
                that takes too long or is far off the sheet.
        """
        must(len(self.turns) < MOST_TURNS, "turns", len(self.turns) + 1, f"at most {MOST_TURNS}")
        strokes = to_strokes(demonstration)
        must(len(strokes) <= MOST_INK, "strokes", len(strokes), f"at most {MOST_INK}")
        turn = TeachingTurn([_log(each) for each in strokes])
        # What is learned is what the log holds.
        kept = _strokes_of(turn.strokes)
        pupil = self.met[-1].learn(kept)
        far = self.far if self.turns else (self.met[0].score(kept).distance,)
        next_one, seen = pupil.forget(), pupil.score(kept)
        then = seen if next_one is pupil else next_one.score(kept)
        return replace(
            self,
            turns=(*self.turns, turn),
            shown=(*self.shown, pupil),
            met=(*self.met, next_one),
            far=(*far, then.distance),
            learned=(*self.learned, seen.distance),
            good=(*self.good, is_good(seen)),
            read=(*self.read, read_letter(kept, self.letter) is None),
            placed=tuple(replace(s, position=s.position - seen.shift) for s in kept),
        )

    def answer(self, is_yes: bool) -> Self:
        """Return the session with an answer to the question of the last turn.

        Raises:
            RecordingError: Neither True nor False.
        """
        must(isinstance(is_yes, bool | np.bool_), "answer", is_yes, "True or False")
        if not self.turns:
            return self
        pupil = self.shown[-1].answer(is_yes)
        next_one, far = pupil.forget(), self.learned[-1]
        if next_one is not pupil:
            far = next_one.score(self.placed).distance
        turns = (*self.turns[:-1], replace(self.turns[-1], answer=bool(is_yes)))
        return replace(self, turns=turns, met=(*self.met[:-1], next_one), far=(*self.far[:-1], far))

    @classmethod
    def by_the_book(
        cls, traits: PupilTraits, letter: str, turns: int, answers: bool = True
    ) -> Self:
        """Return a session in which our own letter was shown, whatever the pupil wrote.

        Args:
            traits: Of the pupil.
            letter: What it is taught.
            turns: How often it is shown.
            answers: Whether its questions are answered, and rightly.
        """
        session = cls.begin(traits, letter)
        for _turn in range(turns):
            session = session.show(recording_of(letter))
            question = session.shown[-1].question
            if answers and question is not None:
                session = session.answer(question.is_so)
        return session

    @property
    def asks(self) -> bool:
        """Whether a question of the pupil waits for an answer."""
        return bool(self.turns) and self.turns[-1].answer is None

    @property
    def is_taught_again(self) -> bool:
        """Whether the letter was shown, something forgotten, and the letter then good again."""
        good = [both == (True, True) for both in zip(self.good, self.read, strict=True)]
        lapsed = [turn for turn, pupil in enumerate(self.met[1:], start=1) if pupil.memory.lost]
        return any(any(self.read[:turn]) and any(good[turn:]) for turn in lapsed)

    @property
    def is_doubted(self) -> bool:
        """Whether what was shown last does not look like the letter."""
        return not all(self.read[-1:])

    def as_json(self) -> dict[str, Any]:
        """Return the log: nothing in it says who has taught, or when."""
        turns = [{"strokes": each.strokes, "answer": each.answer} for each in self.turns]
        about = {"format": FORMAT, "version": SESSION_VERSION, "letter": self.letter}
        return {**about, "pupil": self.traits.as_json(), "turns": turns}

    # Any: JSON.
    @classmethod
    def of(cls, content: Any) -> Self:
        """Return the session of a log.

        Raises:
            RecordingError: It is none, or holds more than a log does.
        """
        try:
            content = checked_object(content, FORMAT, (SESSION_VERSION,), SESSION_FIELDS)
            session = cls.begin(PupilTraits.of(content["pupil"]), content["letter"])
            for turn in content["turns"]:
                must(set(turn) == {"strokes", "answer"}, "a turn", turn, "strokes and an answer")
                session = session.show(_strokes_of(turn["strokes"]))
                session = session if turn["answer"] is None else session.answer(turn["answer"])
        except (KeyError, TypeError, ValueError, IndexError, OverflowError) as error:
            raise RecordingError(f"This is no log of teaching: {shown(error)}") from None
        return session


def _log(stroke: Trajectory) -> list[list[int]]:
    """Return a stroke in whole numbers; points at one moment become the later one."""
    seconds = round(stroke.duration, 1)
    must(seconds <= LONGEST_PAD_STROKE, "time of a stroke", seconds, f"{LONGEST_PAD_STROKE} s")
    rows = np.rint(np.column_stack([stroke.t / TICK, stroke.position / GRAIN]))
    must(np.abs(rows).max() < MOST_TICKS, "a stroke", stroke, "near the sheet")
    last = np.append(np.diff(rows[:, 0]) > 0, True)
    return rows[last].astype(int).tolist()


def _strokes_of(logged: Sequence[Sequence[Sequence[int]]]) -> tuple[Trajectory, ...]:
    """Return the strokes of a log."""
    rows = [np.array(stroke) for stroke in logged]
    for each in rows:
        must(each.dtype.kind == "i" and each.ndim == 2, "a stroke", each, "rows of whole numbers")
    return tuple(Trajectory(each[:, 0] * TICK, each[:, 1:] * GRAIN) for each in rows)
