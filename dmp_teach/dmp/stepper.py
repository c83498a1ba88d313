"""A movement drawn step by step, so that something may happen on the way: push the pen, and see it come back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.checks import check_point, refuse_no_similarity, seconds
from dmp_teach.dmp.equation import Equation, turned_and_scaled
from dmp_teach.dmp.integrators import Spring, advanced
from dmp_teach.dmp.primitive import DMP
from dmp_teach.errors import TrajectoryError
from dmp_teach.trajectory import Array, Trajectory

LONGEST = 100  # movements that a pushed pen may take before it is given up


@dataclass(frozen=True, eq=False)
class Plan:
    """What will push the pen on its way, if nothing else does.

    Args:
        push: What pushes the spring at each step, per movement, shape (M, D).
        way: From start to goal, shape (D,) [m].
        start: y0, shape (D,) [m].
        start_velocity: Per movement, shape (D,) [m].
        duration: T [s].
        spring: The left side of the equation.
    """

    push: Array
    way: Array
    start: Array
    start_velocity: Array
    duration: float
    spring: Spring

    @classmethod
    def of(
        cls,
        primitive: DMP,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        duration: float | None = None,
    ) -> Self:
        """The plan of a primitive, as `DMP.rollout` would draw it.

        Raises:
            TrajectoryError, SettingError: As `DMP.rollout`.
        """
        p, D = primitive, len(primitive.start)
        start = p.start if start is None else check_point("start", start, D)
        goal = p.goal if goal is None else check_point("goal", goal, D)
        equation, taught, way = Equation(p.settings, p.steps), p.goal - p.start, goal - start
        push, velocity = equation.push(p.weights, p.biases, taught), p.start_velocity * p.duration
        if p.settings.transform == "original":
            push, velocity = push * (way / taught), velocity * (way / taught)
        elif p.settings.transform == "similarity" and (way != taught).any():
            refuse_no_similarity(way, taught, p.shown)
            turn = turned_and_scaled(way, taught).T
            push, velocity = push @ turn, velocity @ turn
        elif p.settings.transform == "star":
            push = push + equation.longer() * (way - taught)
        T = p.duration if duration is None else seconds("duration", duration)
        return cls(push, way, start, velocity, T, equation.spring)

    def waiting_push_at(self, clock: float, pace: float) -> Array:
        """The push for a clock that runs at this `pace`, so that the pen stays on the same path.

        K y + D y' + y'' is what the path needs at full pace; at another its speed is pace y', its acceleration
        pace^2 y'': without that a spring whose clock is slow would leave the path, and the clock would never recover.
        """
        push = self.push_at(clock)
        if pace == 1:
            return push
        y = self.path_at(clock)
        faster = self.spring.alpha * (self.path_at(clock + 1) - y) * self.spring.steps
        still = self.spring.K * y
        return still + pace * faster + pace**2 * (push - still - faster)

    def push_at(self, clock: float) -> Array:
        """The push after so many steps: before the start it holds the pen there, and after the end at the goal."""
        if clock < 0:
            return np.zeros_like(self.way)
        k = int(clock)
        if k >= len(self.push):
            return self.spring.K * self.way
        part = clock - k
        if part == 0 or k + 1 == len(self.push):
            return self.push[k]
        return self.push[k] + part * (self.push[k + 1] - self.push[k])

    def path_at(self, clock: float) -> Array:
        """Where the undisturbed pen is after so many steps, from its start, shape (D,) [m]."""
        last = len(self.path) - 1
        k = int(min(max(clock, 0.0), last - 1e-9))
        part = min(max(clock, 0.0), float(last)) - k
        return self.path[k] + part * (self.path[k + 1] - self.path[k])

    @cached_property
    def path(self) -> Array:
        """The path of a pen that nothing disturbs, from its start, shape (M + 1, D) [m]."""
        return self.spring.follow(self.push, self.start_velocity)


@dataclass(frozen=True, eq=False)
class Stepper:
    """A movement under way: a value; each `step` gives the next.

        pen = Stepper.begin(primitive)
        while not pen.over:
            pen = pen.step(push=(3.0, 0.0) if 0.5 < pen.t < 0.6 else None)

    Undisturbed it draws what `DMP.rollout` draws. Made by `Stepper.begin`.

    Args:
        plan: What pushes the pen.
        patience: How far off its path the pen must be for the clock to run at half speed [m]; None: the clock
            never waits.
        t: Time since the start [s].
        clock: How many steps of the movement are over; not a whole number once the clock has waited.
        states: z = y - y0 and its velocity per movement, one step earlier and now, shape (2, 2, D) [m].
    """

    plan: Plan
    patience: float | None
    t: float
    clock: float
    states: Array

    @classmethod
    def begin(
        cls,
        primitive: DMP,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        duration: float | None = None,
        patience: float | None = None,
    ) -> Self:
        """A pen at the start of a movement.

        Args:
            primitive: What was learned.
            start: As in `DMP.rollout` [m].
            goal: As in `DMP.rollout` [m].
            duration: As in `DMP.rollout` [s].
            patience: Phase stopping: how far off its path the pen halves the speed of the clock [m].

        Raises:
            TrajectoryError: As `DMP.rollout`, or a patience that is not a distance.
        """
        plan = Plan.of(primitive, start, goal, duration)
        if patience is not None and not (
            isinstance(patience, int | float) and 0 < patience < np.inf
        ):
            raise TrajectoryError(
                f"patience is {patience!r}, but it must be a distance over 0 m, or None."
            )
        now = np.array([np.zeros_like(plan.start), plan.start_velocity])
        return cls(plan, patience, 0.0, 0.0, np.array([np.full_like(now, np.nan), now]))

    def step(self, push: ArrayLike | None = None) -> Self:
        """The pen one step later; after the end of the movement it goes on to its goal.

        Args:
            push: What disturbs it, an acceleration, shape (D,) [m/s^2].

        Raises:
            TrajectoryError: A push of another dimension, or not finite.
        """
        plan, spring, pace = self.plan, self.plan.spring, self._pace
        force = plan.waiting_push_at(self.clock, pace)
        if push is not None:
            force = force + check_point("push", push, len(plan.start)) * plan.duration**2
        h = 1 / spring.steps
        states = advanced(spring.integrator, h, force, (spring.K, spring.alpha), self.states)
        return replace(self, t=self.t + h * plan.duration, clock=self.clock + pace, states=states)

    def moved(self, by: ArrayLike) -> Self:
        """The same pen, taken elsewhere by somebody's hand: `by` (D,) [m]."""
        hand = check_point("by", by, len(self.plan.start))
        return replace(self, states=self.states + np.array([hand, np.zeros_like(hand)]))

    def to_the_end(self, push: Callable[[float], ArrayLike | None] | None = None) -> Trajectory:
        """All the rest of the movement.

        Args:
            push: What disturbs the pen at a time since the start [s], an acceleration (D,) [m/s^2] or None.

        Returns:
            A trajectory that begins at the time `t`, a sample for each step.

        Raises:
            TrajectoryError: The pen is kept off its path so long that the movement does not end.
        """
        pen, times, positions = self, [self.t], [self.position]
        while not pen.over or len(times) < 2:
            if len(times) > LONGEST * self.plan.spring.steps:
                raise TrajectoryError(
                    f"The movement has not ended after {pen.t:.3g} s, for the clock waits while the pen is off its "
                    f"path: push it less, or give it more patience than {self.patience:g} m."
                )
            pen = pen.step(None if push is None else push(pen.t))
            times.append(pen.t)
            positions.append(pen.position)
        return Trajectory(times, positions)

    @property
    def position(self) -> Array:
        """Where the pen is, shape (D,) [m]."""
        return self.plan.start + self.states[1, 0]

    @property
    def velocity(self) -> Array:
        """How fast it is, shape (D,) [m/s]."""
        return self.states[1, 1] / self.plan.duration

    @property
    def over(self) -> bool:
        """Whether the clock has come to the end of the movement."""
        return self.clock >= self.plan.spring.steps - 1e-6

    @property
    def off_path(self) -> float:
        """How far the pen is from where it would be if nothing had happened, at this clock [m]."""
        return float(np.linalg.norm(self.states[1, 0] - self.plan.path_at(self.clock)))

    @property
    def _pace(self) -> float:
        """How much of a step the clock makes."""
        if self.patience is None or (off := self.off_path) < 1e-9:
            return 1.0
        return 1 / (1 + off / self.patience)
