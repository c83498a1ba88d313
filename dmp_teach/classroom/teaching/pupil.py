"""A robot that learns a letter by being shown it: badly at first, and never once and for all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from os import PathLike
from typing import Self

from dmp_teach.arguments import checked
from dmp_teach.classroom.teaching.faults import (
    WAY_FAULTS,
    PupilStrokes,
    distort,
    follow_way,
    put_in_sequence,
    share_of_way,
    write_other,
)
from dmp_teach.classroom.teaching.memory import LEAST_RELAPSE, PupilMemory
from dmp_teach.classroom.teaching.questions import Question, ask
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.dmp import DMP
from dmp_teach.ink import recording_of
from dmp_teach.letters import Letter
from dmp_teach.scoring import LetterLike, Score, leading_fault, match_strokes, score, to_strokes
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, resample_in_time
from dmp_teach.values import Value

# So often a second a pupil's strokes are sampled, and never by fewer points.
RATE, FEWEST_PUPIL_SAMPLES = 100, 40
# Faults of a score that are of the way of writing, or of another letter altogether.
WAY_NAMES = (*WAY_FAULTS, "turned", "round", "missing", "extra", "joined", "split", "divided")
# A letter is good where every row of its score is "close" or "the same".
GOOD_LEVEL = 2


@dataclass(frozen=True, eq=False, repr=False)
class RobotPupil(Value):
    """A robot that is taught one letter; what is done to it returns the pupil that it then is.

        pupil = RobotPupil.load("Mia", "b")
        pupil = pupil.learn(demonstration)
        print(pupil.says, pupil.question)
        pupil = pupil.answer(True).forget()

    Every step of its learning is one of its primitives' weights, starts and goals, a share of the
    way to those of what was shown: its path, which is affine in them, goes straight there.

    Args:
        letter: The character.
        memory: What it has learned and forgotten.
        hand: How it writes each stroke, as the strokes were shown.
        first: The same before anything was learned.
        rhythm: What share of a stroke's way it has gone at each sample, whatever the way.
        says: What it says of itself, in one or two sentences.
        question: What it asks; None where it has nothing to ask.
    """

    letter: str
    memory: PupilMemory
    hand: tuple[DMP, ...] = field(repr=False)
    first: tuple[DMP, ...] = field(repr=False)
    rhythm: tuple[Array, ...] = field(repr=False)
    says: str = ""
    question: Question | None = None

    @classmethod
    def load(cls, pupil: PupilTraits | str | PathLike[str], letter: str = "b") -> Self:
        """Return a pupil that knows a letter from a book, and writes it badly.

        Args:
            pupil: What it is like, a file of that, or the name of one of ours.
            letter: One of our alphabet.

        Raises:
            RecordingError: No such file, pupil or letter.
        """
        traits = pupil if isinstance(pupil, PupilTraits) else PupilTraits.load(pupil)
        book = recording_of(letter).strokes()
        memory = PupilMemory(traits, traits.muddles_of(letter))
        hand, rhythm = _imitate(distort(book, traits.faults)), _rhythm_of(book)
        says = _("I am {name}. This is how I write {letter}. Please show me how you do it.")
        return cls(letter, memory, hand, hand, rhythm, says.format(name=traits.name, letter=letter))

    @cached_property
    def strokes(self) -> PupilStrokes:
        """What it writes, with all its faults, on a clock that begins at 0."""
        traits, muddles = self.memory.traits, self.memory.muddles
        strokes = put_in_sequence(tuple(each.rollout() for each in self.hand))
        for name in reversed(muddles):
            if name in WAY_FAULTS:
                strokes = WAY_FAULTS[name](strokes)
        other = traits.writes_instead_of(self.letter) if "mixed up" in muddles else None
        return write_other(other, traits.faults, 1 - self.memory.learned) if other else strokes

    @cached_property
    def written(self) -> Letter:
        """The letter that it writes, as primitives that a robot can follow."""
        return Letter(self.strokes, _imitate(self.strokes))

    @checked
    def learn(self, demonstration: LetterLike) -> Self:
        """Return the pupil after it was shown a letter: nearer to it, and with a question.

        The place on the page does not count. Where the demonstration has other strokes than it
        knows of, or in another order or direction, it takes them over in its own hand.

        Args:
            demonstration: A `Recording`, a `Letter` (what it writes) or strokes.

        Raises:
            LetterError: It is nothing, something else, or all in one place.
        """
        shown = to_strokes(demonstration, "demonstration")
        seen = score(self.strokes, shown)
        shown = tuple(replace(s, position=s.position - seen.shift) for s in shown)
        traits, memory = self.memory.traits, self.memory
        hand, first, rhythm = self.hand, self.first, self.rhythm
        if not _are_alike(tuple(each.rollout() for each in hand), shown):
            first, rhythm = _imitate(distort(shown, traits.faults)), _rhythm_of(shown)
            hand = _go(first, _imitate_like(first, rhythm, shown), memory.learned)
        hand = _go(hand, _imitate_like(hand, rhythm, shown), traits.pace)
        return replace(
            self,
            memory=memory.learn(differs_in_way(seen)),
            hand=hand,
            first=first,
            rhythm=rhythm,
            says=_describe_lesson(self.letter, seen),
            question=ask(shown, traits.seed, memory.turn),
        )

    @checked
    def practised(self, memory: PupilMemory) -> Self:
        """Return the pupil with another memory, as our own letter would have taught it."""
        book = _imitate_like(self.first, self.rhythm, recording_of(self.letter).strokes())
        return replace(self, memory=memory, hand=_go(self.first, book, memory.learned))

    def answer(self, is_yes: bool) -> Self:
        """Return the pupil after its question was answered: it remembers a right answer better."""
        if self.question is None:
            return self
        is_right = is_yes == self.question.is_so
        says = _("Thank you. So I shall remember it better.")
        if not is_right:
            says = self.question.doubt
        return replace(self, memory=self.memory.answer(is_right), says=says, question=None)

    def forget(self) -> Self:
        """Return the pupil as it comes to the next turn: some days it has forgotten something."""
        memory = self.memory.forget()
        if memory is self.memory:
            return self
        hand = _go(self.hand, self.first, memory.lost)
        says = _("It is another day, and I have forgotten a little. Please show me again.")
        if memory.lost >= LEAST_RELAPSE:
            says = _("It is another day, and I have forgotten much. Look: please show me again.")
        return replace(self, memory=memory, hand=hand, says=says, question=None)

    @checked
    def score(self, model: LetterLike | None = None) -> Score:
        """Compare what it writes with a model; None is our own letter."""
        return self._score_by_the_book if model is None else score(self.strokes, model)

    @cached_property
    def _score_by_the_book(self) -> Score:
        return score(self.strokes, recording_of(self.letter))

    @checked
    def is_good(self, model: LetterLike | None = None) -> bool:
        """Return whether every row of its score is close, or the same."""
        return is_good(self.score(model))


def is_good(score: Score) -> bool:
    """Return whether every row of a score is close, or the same."""
    return all(part.level >= GOOD_LEVEL for part in score.parts)


def differs_in_way(seen: Score) -> bool:
    """Return whether a score shows another way of writing, or a letter that is far off."""
    is_other = any(each.name in WAY_NAMES and each.steps > 1 for each in seen.faults)
    return is_other or any(part.level == 0 for part in seen.parts)


def _describe_lesson(letter: str, seen: Score) -> str:
    """Return what a pupil says it has seen, in the words of the score."""
    fault = leading_fault(seen.faults)
    if fault is None:
        return _("Mine looks like yours now: I have kept my {letter}.").format(letter=letter)
    mine, yours = _("yours"), _("your")
    said = _(
        "My {letter} before you showed me: “{difference}” I told myself: “{advice}” "
        "Now I write it like this."
    )
    return said.format(
        letter=letter,
        difference=fault.wording.format(model=mine, models=mine),
        advice=fault.advice.format(model=mine, models=yours),
    )


def _are_alike(strokes: PupilStrokes, shown: PupilStrokes) -> bool:
    """Return whether two letters have the same strokes, in one order and direction."""
    found = match_strokes(strokes, shown)
    pairs = [(pair.strokes, pair.others) for pair in found.pairs]
    is_same = pairs == [((k,), (k,)) for k in range(len(shown))] and len(strokes) == len(shown)
    return is_same and not (found.mirrored or found.turn or found.reversed)


def _imitate(strokes: Sequence[Trajectory]) -> tuple[DMP, ...]:
    """Return a primitive for each stroke, sampled evenly."""
    return tuple(DMP.imitate(_even(stroke)) for stroke in strokes)


def _even(stroke: Trajectory) -> Trajectory:
    """Return a stroke sampled evenly in time."""
    return resample_in_time(stroke, max(FEWEST_PUPIL_SAMPLES, round(stroke.duration * RATE)))


def _rhythm_of(strokes: PupilStrokes) -> tuple[Array, ...]:
    """Return what share of its way each stroke has gone at its even samples."""
    return tuple(share_of_way(_even(stroke).position) for stroke in strokes)


def _imitate_like(
    hand: tuple[DMP, ...], rhythm: tuple[Array, ...], shown: PupilStrokes
) -> tuple[DMP, ...]:
    """Return primitives of what was shown, on a hand's clock, in its rhythm, with its kernels."""
    return tuple(
        DMP.imitate(Trajectory(own.times, follow_way(stroke.position, way)), own.settings)
        for own, way, stroke in zip(hand, rhythm, shown, strict=True)
    )


def _go(hand: tuple[DMP, ...], there: tuple[DMP, ...], part: float) -> tuple[DMP, ...]:
    """Return primitives a part of the way from one hand to another."""
    names = ("weights", "start", "goal", "start_velocity")
    return tuple(
        replace(a, **{n: getattr(a, n) + part * (getattr(b, n) - getattr(a, n)) for n in names})
        for a, b in zip(hand, there, strict=True)
    )
