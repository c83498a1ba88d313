"""A session of teaching: a log without identity that replays to the bit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from dmp_teach.classroom.teaching.pupil import RobotPupil, is_good
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.errors import RecordingError
from dmp_teach.files import must
from dmp_teach.ink import recording_of
from dmp_teach.scoring import LetterLike, to_strokes
from dmp_teach.trajectory import Trajectory

FORMAT, SESSION_VERSION = "dmp_teach teaching", 1
# A log keeps whole milliseconds and hundredths of a millimetre.
TICK, GRAIN = 1e-3, 1e-5
MOST_TURNS = 100

# Of each stroke: t [ms], x, y [0.01 mm], point by point.
LoggedStrokes = list[list[list[int]]]


@dataclass(frozen=True)
class TeachingTurn:
    """One turn: what was shown, and what was answered to the question, if anything."""

    strokes: LoggedStrokes
    answer: bool | None = None


@dataclass(frozen=True, eq=False)
class TeachingSession:
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
    placed: tuple[Trajectory, ...] = ()

    @classmethod
    def begin(cls, traits: PupilTraits, letter: str) -> Self:
        """Return a session in which nothing was shown yet; a RecordingError: no such letter."""
        pupil = RobotPupil.load(traits, letter)
        return cls(traits, letter, met=(pupil,), far=(pupil.score().distance,))

    def show(self, demonstration: LetterLike) -> Self:
        """Return the session with one turn more.

        Raises:
            LetterError: No strokes.
            RecordingError: More turns than a session has.
        """
        must(len(self.turns) < MOST_TURNS, "turns", len(self.turns) + 1, f"at most {MOST_TURNS}")
        turn = TeachingTurn([_log(each) for each in to_strokes(demonstration)])
        # What is learned is what the log holds.
        shown = _strokes_of(turn.strokes)
        pupil = self.met[-1].learn(shown)
        far = self.far if self.turns else (self.met[0].score(shown).distance,)
        next_one, seen = pupil.forget(), pupil.score(shown)
        return replace(
            self,
            turns=(*self.turns, turn),
            shown=(*self.shown, pupil),
            met=(*self.met, next_one),
            far=(*far, next_one.score(shown).distance),
            learned=(*self.learned, seen.distance),
            good=(*self.good, is_good(seen)),
            placed=tuple(replace(s, position=s.position - seen.shift) for s in shown),
        )

    def answer(self, is_yes: bool) -> Self:
        """Return the session with an answer to the question of the last turn."""
        if not self.turns:
            return self
        next_one = self.shown[-1].answer(is_yes).forget()
        far = next_one.score(self.placed).distance
        turns = (*self.turns[:-1], replace(self.turns[-1], answer=is_yes))
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
        """Whether something was forgotten, and the letter was good again after that."""
        lapsed = [turn for turn, pupil in enumerate(self.met[1:]) if pupil.memory.lost]
        return any(any(self.good[turn + 1 :]) for turn in lapsed)

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
            RecordingError: It is none.
        """
        try:
            must(content["format"] == FORMAT, "format", content["format"], FORMAT)
            session = cls.begin(PupilTraits.of(content["pupil"]), content["letter"])
            for turn in content["turns"]:
                session = session.show(_strokes_of(turn["strokes"]))
                must(
                    turn["answer"] in (True, False, None), "answer", turn["answer"], "true or false"
                )
                session = session if turn["answer"] is None else session.answer(turn["answer"])
        except (KeyError, TypeError, ValueError, IndexError, OverflowError) as error:
            raise RecordingError(f"This is no log of teaching: {error!r:.100}") from None
        return session


def _log(stroke: Trajectory) -> list[list[int]]:
    """Return a stroke in whole numbers; points at one moment become the later one."""
    t = np.rint(stroke.t / TICK).astype(int)
    xy = np.rint(stroke.position / GRAIN).astype(int)
    last = np.append(np.diff(t) > 0, True)
    return np.column_stack([t, xy])[last].tolist()


def _strokes_of(logged: Sequence[Sequence[Sequence[int]]]) -> tuple[Trajectory, ...]:
    """Return the strokes of a log."""
    rows = [np.array(stroke, dtype=float) for stroke in logged]
    return tuple(Trajectory(each[:, 0] * TICK, each[:, 1:] * GRAIN) for each in rows)
