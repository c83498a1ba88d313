"""What a pad does when the pen is lifted: it judges the stroke, shows the next, or writes it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence

import numpy as np

from dmp_teach.errors import LetterError
from dmp_teach.ink import PadStroke, Recording, check_hand
from dmp_teach.scoring import Fault, StrokeVerdict, check_strict, judge_stroke, letter_distance
from dmp_teach.trajectory import Array, Trajectory, all_points

# So many misses of one stroke, and it is shown as a ghost, or written by the robot.
MISSES_TO_SHOW = 2
MISSES_TO_WRITE = 4
LIFT_WITHIN = 0.1
"""How long a lift takes that is none, when two strokes are judged as one [s]."""


class PenLift:
    """The strokes on a sheet, judged one by one.

    A stroke that was missed stays until it is written again, which takes its place.

    Args:
        hand: As in `judge_stroke`.
        strict: As in `judge_stroke`.
    """

    def __init__(self, hand: str, strict: Collection[str]) -> None:
        check_hand(hand)
        check_strict(strict)
        self.hand = hand
        self.strict = tuple(strict)
        self.verdict: StrokeVerdict | None = None
        self.begin(None)

    def begin(self, model: Recording | None) -> None:
        """Take another letter, of which nothing was missed."""
        self._model = () if model is None else model.strokes()
        self._misses: Counter[int] = Counter()
        self._robots: list[PadStroke] = []
        self.verdict = None

    def take(self, before: Sequence[PadStroke], stroke: PadStroke) -> tuple[PadStroke, ...]:
        """Judge a stroke, given those before, and return what is then on the sheet."""
        last = self.verdict
        self.verdict, strokes = None, (*before, stroke)
        if not self._model:
            return strokes
        if before and last is not None and not last.good:
            again = self._judge((*before[:-1], stroke))
            is_same = again is not None and again.due == last.due and again.stroke == last.due
            if is_same and not self._is_lifted(before[-1].path, stroke.path, last.due):
                strokes = (*before[:-1], stroke)
        verdict = self.verdict = self._judge(strokes)
        if verdict is None:
            return strokes
        if verdict.good:
            del self._misses[verdict.due]
            return strokes
        self._misses[verdict.due] += 1
        if self._misses[verdict.due] < MISSES_TO_WRITE:
            return strokes
        del self._misses[verdict.due]
        self.verdict = None
        return self._write(strokes[:-1], verdict.due, stroke.path.t[0])

    def _is_lifted(self, first: Trajectory, then: Trajectory, number: int) -> bool:
        """Return whether two strokes together are nearer to the one that is due than the second."""
        due = [self._model[number]]
        t = np.append(first.t, first.t[-1] + LIFT_WITHIN + then.t - then.t[0])
        whole = Trajectory(t, np.concatenate([first.position, then.position]))
        return letter_distance([whole], due) < letter_distance([then], due)

    def _judge(self, strokes: Sequence[PadStroke]) -> StrokeVerdict | None:
        """Return the verdict on the last stroke; None where there are only dots."""
        try:
            paths = [stroke.path for stroke in strokes]
            return judge_stroke(paths, self._model, self.hand, self.strict)
        except LetterError:
            return None

    def _write(
        self, strokes: Sequence[PadStroke], number: int, begin: float
    ) -> tuple[PadStroke, ...]:
        """Return the strokes and one by the robot."""
        own = self._model[number]
        path = Trajectory(own.t - own.t[0] + begin, own.position + self._shift(strokes))
        self._robots.append(PadStroke(path, None, len(path)))
        return (*strokes, self._robots[-1])

    def _shift(self, strokes: Sequence[PadStroke]) -> Array:
        """Return what moves the model beside the strokes that are written, shape (2,) [m]."""
        count = min(len(strokes), len(self._model))
        if not count:
            return np.zeros(2)
        here, there = (
            all_points(paths[:count])
            for paths in ([stroke.path for stroke in strokes], self._model)
        )
        return (np.ptp(here, axis=0) - np.ptp(there, axis=0)) / 2 + here.min(0) - there.min(0)

    @property
    def missed(self) -> Fault | None:
        """What is wrong with the last stroke."""
        return self.verdict.fault if self.verdict else None

    def find_robots(self, strokes: Sequence[PadStroke]) -> list[int]:
        """Return which of the strokes are the robot's."""
        return [k for k, stroke in enumerate(strokes) if stroke in self._robots]

    def describe(self, strokes: Sequence[PadStroke]) -> dict[str, object]:
        """Return what the browser shows: the ghost, whose strokes are whose, and what is asked."""
        robots = self.find_robots(strokes)
        verdict = self.verdict
        due = len(strokes) if verdict is None or verdict.good else verdict.due
        ghost: list[list[float]] = []
        if self._misses[due] >= MISSES_TO_SHOW:
            before = strokes if due == len(strokes) else strokes[:-1]
            ghost = (self._model[due].position + self._shift(before)).round(5).tolist()
        shown: dict[str, object] = {"ghost": ghost, "robots": robots, "missed": None}
        if verdict is not None and not verdict.good:
            times = strokes[-1].path.t - strokes[-1].path.t[0]
            shown["missed"] = {"expected": verdict.due, "times": times.round(3).tolist()}
        return shown
