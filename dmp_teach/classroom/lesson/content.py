"""A lesson as a value: what can be set, a bet, tasks, a challenge with its check, and a picture."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TypeVar
from zlib import crc32

import numpy as np

from dmp_teach.arguments import is_whole
from dmp_teach.classroom.lesson.bets import Bet, KeptBet, LessonState
from dmp_teach.classroom.lesson.check import Answer, Condition, Verdict, judge
from dmp_teach.classroom.lesson.knobs import Knobs, check_answer
from dmp_teach.classroom.panels.messages import Message
from dmp_teach.classroom.panels.planning import Physics
from dmp_teach.errors import ReachError, SettingError, shown
from dmp_teach.ink import check_pseudonym
from dmp_teach.robot import Page, Run
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory

T = TypeVar("T")


@dataclass(frozen=True)
class Affine:
    """Points that follow knobs without the kernel: base + sum of value times term.

    Args:
        base: Shape (N, 2).
        terms: By the name of a knob, shape (N, 2): what one unit of it adds.
    """

    base: Array
    terms: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class Pick:
    """One of several pictures, by the place of a choice's value among its options.

    Args:
        knob: The name of the choice, or of a slider of whole numbers from its low end.
        pictures: One for each option.
    """

    knob: str
    pictures: Sequence[object]


# Arrays, `Affine` and `Pick` may stand at any depth; the rest is plain JSON.
Drawing = dict[str, object]


@dataclass(frozen=True)
class Picture:
    """What a lesson shows.

    Args:
        says: One number and one sentence.
        sheet: Of the letter: box, demo, robot, and what else `lesson.js` draws on paper.
        plots: Of each plot by its name: caption, note, and a scene of `plot.js`.
        strokes: What the robot writes when it is asked.
        page: Where it writes them; None where the lesson has no say in it.
        physics: What `simulate` is called with; None: the robot's motion is shown as planned.
        highs: Up to where sliders go here that may go further elsewhere, by the names of knobs.
    """

    says: Message
    sheet: Drawing | None = None
    plots: dict[str, Drawing] = field(default_factory=dict)
    strokes: tuple[Trajectory, ...] = ()
    page: Page | None = None
    physics: Physics | None = None
    highs: dict[str, float] = field(default_factory=dict)


class LessonContent:
    """What a lesson says, draws and judges.

    A lesson is a subclass of `Lesson`. Its texts are `marked` for the catalogue and stand with the
    class. They may name what the class or `vary` has set, {limit} or {solution[theta]}, and the
    praise and the mistakes what `measure` returns, too.

    Args:
        pupil: A pseudonym, from which letters, targets and starts follow; None: the first variant.
    """

    key: str
    question: str
    """The title."""
    bet_question: str
    """What to predict."""
    challenge: str
    """The task that is checked."""
    by_robot: Collection[int] = ()
    """The tasks that are done only when the robot has written what is set."""
    hints: tuple[str, ...]
    """Each more direct; the solution in the third alone."""
    praise: str
    """What is said when the challenge is met."""
    # Whether what was tried is drawn, which the kernel alone keeps.
    draws_tried = False

    start: Answer
    """What is set when the panel opens."""
    solution: Answer
    """One answer that meets the challenge."""

    def __init__(self, pupil: str | None = None):
        check_pseudonym(pupil, "pupil")
        self.pupil = pupil
        seed = crc32(f"{self.key} {self.pupil or ''}".encode())
        self.random = None if pupil is None else np.random.default_rng(seed)
        self.vary()
        for name in ("question", "bet_question", "challenge"):
            setattr(self, name, self.tell(getattr(self, name)))
        self.hints = tuple(map(self.tell, self.hints))

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.pupil == getattr(other, "pupil", None)

    def __hash__(self) -> int:
        return hash((self.key, self.pupil))

    def __repr__(self) -> str:
        """Return one line."""
        pupil = "" if self.pupil is None else f", pupil {self.pupil}"
        return f"Lesson({self.key} {self.question!r}{pupil})"

    def vary(self) -> None:
        """Set what differs between pupils: `start`, `solution`, and more that texts name."""

    def choose(self, options: Sequence[T]) -> T:
        """Return one of several, by the pupil; the first in the first variant."""
        return options[0 if self.random is None else int(self.random.integers(len(options)))]

    def tell(self, text: str, **more: object) -> str:
        """Return a marked text in the language of the moment, with what it names, and with more."""
        return _(text).format(**self._named | more)

    @property
    def _named(self) -> Answer:
        """What texts may name, the same for every answer."""
        return {**vars(type(self)), **vars(self)}

    @property
    def knobs(self) -> Knobs:
        """What a pupil can turn, by name."""
        raise NotImplementedError

    @property
    def bet(self) -> Bet:
        """What is predicted before the truth is seen."""
        raise NotImplementedError

    @property
    def tasks(self) -> Sequence[str]:
        """What to try, one after the other, and what to look for; `marked`."""
        raise NotImplementedError

    def done(self, v: Answer) -> Sequence[bool]:
        """Return whether each task is done by what is set."""
        raise NotImplementedError

    @property
    def settable(self) -> dict[str, tuple[float, ...] | tuple[str, ...]]:
        """What a pupil can set: the name, and (low, high) or the choices."""
        return {name: knob.allowed for name, knob in self._answer_knobs.items()}

    @property
    def _answer_knobs(self) -> Knobs:
        """The knobs that belong to the answer."""
        return {name: knob for name, knob in self.knobs.items() if not knob.is_view}

    def draw(self, state: LessonState) -> Picture:
        """Return what is seen; quick, since it is called while a slider moves."""
        raise NotImplementedError

    def values_on(self, page: Page, values: Answer) -> Answer:
        """Return what is to be set so that the robot writes on a page that cures a fault."""
        return values

    def tell_refusal(self, values: Answer, error: ReachError) -> str:
        """Return why the robot cannot write on a page, and where it could: its cure is a page."""
        return str(error)

    def tell_run(self, run: Run) -> str:
        """Return what physics made of the letter, where that is the lesson's matter."""
        return ""

    def conditions(self, answer: Answer) -> Sequence[Condition]:
        """Return what the challenge asks for, each with the number of this answer."""
        raise NotImplementedError

    def mistakes(self, answer: Answer) -> Iterable[str]:
        """Yield what is said of each usual mistake that was made, the most telling first."""
        return ()

    def praised(self, answer: Answer) -> str:
        """Return what is said when the challenge is met."""
        return _(self.praise)

    def measure(self, answer: Answer) -> Answer:
        """Return what mistakes and praise name of an answer."""
        return {}

    def tell_bet(self, bet: KeptBet) -> str:
        """Return how far off a bet was, when the truth is laid over it; never that it is wrong."""
        raise NotImplementedError

    def check(self, answer: object, hints: int = 0) -> Verdict:
        """Judge an answer, without a browser.

        Args:
            answer: What a panel's `.answer` holds: a value for each name of `settable`.
            hints: How many hints were seen; the next is given.

        Raises:
            SettingError: The hints are no whole number. A bad answer raises nothing.
        """
        if not is_whole(hints):
            raise SettingError(f"hints is {shown(hints)}, but must be a whole number.")
        hint = self.hints[min(max(hints, 0), 2)]
        if isinstance(answer, Mapping):
            views = self.knobs.keys() - self._answer_knobs.keys()
            answer = {name: value for name, value in answer.items() if name not in views}
        try:
            good = check_answer(self._answer_knobs, answer)
        except SettingError as error:
            return Verdict(False, str(error), hint)
        verdict = judge(
            self.conditions(good), self.mistakes(good), partial(self.praised, good), hint
        )
        facts = self._named | self.measure(good)
        return replace(verdict, reason=verdict.reason.format(**facts))
