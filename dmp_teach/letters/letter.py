"""A letter: strokes learned from a person, written again with other starts and goals."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers, checked
from dmp_teach.dmp import DMP, Responses, Settings, chain
from dmp_teach.errors import LetterError, kind_of, shown
from dmp_teach.files import Saved
from dmp_teach.ink import draw_svg
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.letters.kernel_choice import imitate_strokes
from dmp_teach.letters.letter_json import letter_parts, letter_to_json
from dmp_teach.letters.pauses import begin_times
from dmp_teach.scoring import LetterLike, list_strokes
from dmp_teach.trajectory import Array, Trajectory, rms
from dmp_teach.values import Value, locked

_Points = Mapping[int, ArrayLike] | None


def rms_distance(a: Iterable[Trajectory], b: Iterable[Trajectory]) -> float:
    """Return the root mean square distance of strokes `a` and `b`, sample by sample [m]."""
    return rms(np.concatenate([p.position - q.position for p, q in zip(a, b, strict=True)]))


@dataclass(frozen=True, eq=False, repr=False)
class Letter(Saved, Value):
    """A letter as one primitive for each stroke.

    Args:
        strokes: The demonstration, on the clock of its recording; of a composed letter its rollout.
        primitives: One for each stroke, in the same order.
        led_to: Goals other than the primitives' own, by the number of the stroke [m].
        made_of: The names of the strokes that it was composed of, such as "D.1".
    """

    strokes: tuple[Trajectory, ...]
    primitives: tuple[DMP, ...]
    led_to: Mapping[int, Array] = field(default_factory=dict, repr=False)
    made_of: tuple[str, ...] = ()

    file_kind, extra_fields = "letter", ("units",)

    def __post_init__(self) -> None:
        goals = {number: locked(goal) for number, goal in self.led_to.items()}
        object.__setattr__(self, "led_to", goals)
        super().__post_init__()

    @classmethod
    @checked
    def learn(cls, recording: LetterLike, settings: Settings | None = None) -> Self:
        """Learn a letter: one primitive for each stroke.

        Args:
            recording: A `Recording`, or strokes as trajectories, in the order of writing.
            settings: The same for every stroke; None takes `Settings.star()`, and more kernels for
                a stroke that was written so fast that these draw it visibly otherwise.

        Raises:
            LetterError: No strokes, or a stroke that begins before the one before it has ended.
        """
        strokes = _strokes_of(recording)
        return cls(strokes, imitate_strokes(strokes, settings))

    @classmethod
    @checked
    def compose(cls, pieces: Iterable[Piece], transform: str | None = None) -> Self:
        """Compose a new letter of strokes, one after the other, by their own primitives.

            bar, bowl = shelf["D"]
            p = Letter.compose([bar, bowl.led(lower=bar.at(0.5))])

        Strokes that followed each other in one letter keep the pause between them; before a stroke
        of another letter the pen is in the air for 0.36 s and 1 s a metre, 0.6 s at most.

        Args:
            pieces: In the order in which they are written.
            transform: The transformation to other ends, "star" or "similarity"; None: each its own.

        Raises:
            LetterError: No pieces, something that is no piece, or no such transformation.
        """
        pieces = tuple(pieces) if isinstance(pieces, Iterable) else (pieces,)
        wrong = [each for each in pieces if not isinstance(each, Piece)]
        if wrong or not pieces:
            got = kind_of(wrong[0]) if wrong else "nothing"
            raise LetterError(
                f"A letter is composed of strokes from a shelf (Piece), but got {got}."
            )
        if transform is not None:
            pieces = tuple(piece.using(transform) for piece in pieces)
        primitives = tuple(
            replace(p.primitive, times=p.primitive.times + (begin - p.primitive.times[0]))
            for p, begin in zip(pieces, begin_times(pieces), strict=True)
        )
        goals = {n: piece.led_to for n, piece in enumerate(pieces) if piece.led_to is not None}
        strokes = tuple(p.rollout(goal=goals.get(n)) for n, p in enumerate(primitives))
        return cls(strokes, primitives, goals, tuple(piece.name for piece in pieces))

    # Any: what `make_letter` takes.
    @classmethod
    def make(cls, *args: Any, **kwargs: Any) -> Letter:
        """Make a letter; use `make_letter`, as this name goes after one version."""
        from dmp_teach.letters import make_letter  # noqa: PLC0415 (`compose` imports this module)

        words = "Letter.make is now called dmp_teach.make_letter."
        warnings.warn(words, DeprecationWarning, stacklevel=2)
        return make_letter(*args, **kwargs)

    @checked
    def write(
        self,
        goals: Mapping[int, ArrayLike] | None = None,
        starts: Mapping[int, ArrayLike] | None = None,
        goal_shifts: Mapping[int, ArrayLike] | None = None,
        duration: float | None = None,
    ) -> tuple[Trajectory, ...]:
        """Write the letter, one trajectory for each stroke, all on the recording's clock.

        Args:
            goals: Where strokes end, absolute, by the number of the stroke, from 0 [m].
            starts: Where strokes begin, absolute [m].
            goal_shifts: How far the ends of strokes move [m].
            duration: Of the whole letter with its lifts, stretched evenly [s].

        Raises:
            LetterError: No stroke of that number, a goal and a shift for one stroke, or a duration
                that is not a time.
            TrajectoryError: A start or goal that is not a point of the stroke.
        """
        starts, goals = self._ends(goals, starts, goal_shifts)
        drawn = [p.rollout(starts.get(i), goals.get(i)) for i, p in enumerate(self.primitives)]
        return tuple(drawn) if duration is None else self._stretched(drawn, duration)

    def chain(
        self,
        overlap: float | Sequence[float] = 0.1,
        goals: Mapping[int, ArrayLike] | None = None,
        starts: Mapping[int, ArrayLike] | None = None,
        goal_shifts: Mapping[int, ArrayLike] | None = None,
    ) -> Trajectory:
        """Write the letter in one stroke, without a lift or a stop (Kulvicius 2012).

        Args:
            overlap: How long before the end of a stroke the next begins [s]; negative: a time for
                the connection between them. One for all joints, or one for each.
            goals: As in `write` [m].
            starts: As in `write` [m].
            goal_shifts: As in `write` [m].

        Raises:
            LetterError: As in `write`.
            TrajectoryError: As `dmp_teach.chain`.
        """
        starts, goals = self._ends(goals, starts, goal_shifts)
        return chain(self.primitives, overlap, starts, goals)

    # Any: what `chain` takes.
    def joined(self, *args: Any, **kwargs: Any) -> Trajectory:
        """Write the letter in one stroke; use `chain`, as this name goes after one version."""
        warnings.warn("Letter.joined is now called Letter.chain.", DeprecationWarning, stacklevel=2)
        return self.chain(*args, **kwargs)

    # Any: what JSON holds.
    def _to_json(self) -> dict[str, Any]:
        return letter_to_json(self)

    @classmethod
    def _from_json(cls, content: dict[str, Any]) -> Self:
        return cls(**letter_parts(content))

    @property
    def duration(self) -> float:
        """From the first sample of the first stroke to the last of the last, lifts included [s]."""
        return float(self.strokes[-1].t[-1] - self.strokes[0].t[0])

    @property
    def error(self) -> float:
        """The rms distance of the letter as learned from the demonstration, at equal times [m]."""
        return rms_distance(self.strokes, self.write())

    @property
    def responses(self) -> tuple[Responses, ...]:
        """How each stroke answers to its goal and to its weights."""
        return tuple(map(Responses, self.primitives))

    def __repr__(self) -> str:
        strokes = f"{len(self.strokes)} stroke{'s' * (len(self.strokes) > 1)}"
        kernels = sum(len(primitive.weights) for primitive in self.primitives)
        if self.made_of:
            return f"Letter({strokes}, {kernels} kernels, made of {', '.join(self.made_of)})"
        error = f"{1000 * self.error:.2f} mm rms from the demonstration"
        return f"Letter({strokes}, {kernels} kernels, {error})"

    def _repr_svg_(self) -> str | None:
        """Return what it writes as a small picture, for a notebook."""
        return draw_svg(self.write(), repr(self), dotted=False)

    def _stretched(self, drawn: list[Trajectory], duration: float) -> tuple[Trajectory, ...]:
        """Return the strokes on an evenly stretched clock, from the same beginning."""
        try:
            factor = float(duration) / self.duration
        except (TypeError, ValueError):
            factor = np.nan
        if not (np.isfinite(factor) and factor > 0):
            raise LetterError(
                f"duration is {shown(duration)}, but it must be a time longer than 0 s."
            )
        begin = drawn[0].t[0]
        return tuple(
            Trajectory(begin + (stroke.t - begin) * factor, stroke.position) for stroke in drawn
        )

    def _ends(
        self, goals: _Points, starts: _Points, goal_shifts: _Points
    ) -> tuple[dict[int, ArrayLike], dict[int, ArrayLike]]:
        """Return starts and goals by the number of the stroke."""
        ends = {**self.led_to, **self._by_stroke("goals", goals)}
        moved = self._by_stroke("starts", starts)
        for number, shift in self._by_stroke("goal_shifts", goal_shifts).items():
            if goals and number in goals:
                raise LetterError(f"Stroke {number} has a goal and a goal shift; give one of them.")
            ends[number] = self._shifted(number, shift)
        return moved, ends

    def _by_stroke(self, name: str, of: _Points) -> dict[int, ArrayLike]:
        """Return points by the number of the stroke, checked."""
        if of is not None and not isinstance(of, Mapping):
            raise LetterError(
                f"{name} must be a dictionary, stroke number: point [m], but is {kind_of(of)}."
            )
        for number in of or {}:
            if number not in range(len(self.strokes)):
                have = f"this letter has stroke {', '.join(map(str, range(len(self.strokes))))}"
                raise LetterError(f"{name} names stroke {shown(number)}, but {have}.")
        return dict(of or {})

    def _shifted(self, number: int, shift: ArrayLike) -> Array:
        """Return the goal of a stroke moved by a shift."""
        goal = self.led_to.get(number, self.primitives[number].goal)
        what = f"The goal shift of stroke {number} is {shown(shift)}, but it must be"
        try:
            step = as_numbers(shift)
        except ValueError:
            step = np.empty(0)
        if step.shape != goal.shape:
            raise LetterError(f"{what} {len(goal)} numbers [m].")
        if not np.isfinite(step).all():
            raise LetterError(f"{what} finite [m].")
        return goal + step


def _strokes_of(recording: LetterLike) -> tuple[Trajectory, ...]:
    """Return the strokes of a recording or of strokes, checked."""
    strokes = list_strokes(recording)
    wrong = [each for each in strokes if not isinstance(each, Trajectory)]
    if wrong or not strokes:
        what = kind_of(wrong[0]) if wrong else "nothing"
        raise LetterError(
            f"A letter is learned from a recording or from strokes (Trajectory), but got {what}."
        )
    for number, (before, after) in enumerate(pairwise(strokes), start=1):
        if after.dimensions != before.dimensions:
            raise LetterError(
                f"Stroke {number} has {after.dimensions} dimensions, but stroke {number - 1} has "
                f"{before.dimensions}; all strokes of a letter have as many."
            )
        if after.t[0] < before.t[-1]:
            raise LetterError(
                f"Stroke {number} begins at {after.t[0]} s, before stroke {number - 1} ends at "
                f"{before.t[-1]} s; put strokes in the order in which they were written, on one "
                "clock."
            )
    return strokes
