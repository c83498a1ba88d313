"""A movement drawn step by step, so that the pen may be pushed on its way, and comes back."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked
from dmp_teach.dmp.checks import check_duration, check_point
from dmp_teach.dmp.equation import Equation
from dmp_teach.dmp.integrators import Spring
from dmp_teach.dmp.primitive import DMP
from dmp_teach.errors import TrajectoryError, shown
from dmp_teach.trajectory import Array
from dmp_teach.values import Value


@dataclass(frozen=True, eq=False, repr=False)
class Plan(Value):
    """The input that a pen will have on its way, if nothing disturbs it; per movement.

    Args:
        primitive: What was learned.
        inputs: The input of the spring at each step, shape (M, D).
        offset: From start to goal, shape (D,) [m].
        start: y0, shape (D,) [m].
        start_velocity: Shape (D,) [m].
        duration: T [s].
        spring: The left side of the equation.
    """

    primitive: DMP
    inputs: Array
    offset: Array
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
        """Return the plan of a primitive, as `DMP.rollout` would draw it, with the same errors."""
        p, D = primitive, len(primitive.start)
        start = p.start if start is None else check_point("start", start, D)
        goal = p.goal if goal is None else check_point("goal", goal, D)
        equation, taught, offset = Equation(p.settings, p.steps), p.goal - p.start, goal - start
        inputs = equation.input(p.weights, p.biases, taught)
        velocity = p.start_velocity * p.duration
        if (offset != taught).any():
            transformation = equation.transformation
            transformation.check_goal(taught, offset, p.nominal_path)
            inputs = transformation.retarget(inputs, taught, offset, equation.input_gain())
            if p.settings.start_velocity != "kept":
                velocity = transformation.retarget(velocity, taught, offset, 0.0)
        T = p.duration if duration is None else check_duration("duration", duration)
        return cls(p, inputs, offset, start, velocity, T, equation.spring)

    def input_at(self, clock: float) -> Array:
        """Return the input after so many steps; before and after, it holds the pen at rest."""
        if clock < 0:
            return np.zeros_like(self.offset)
        k = int(clock)
        if k >= len(self.inputs):
            return self.spring.K * self.offset
        part = clock - k
        if part == 0 or k + 1 == len(self.inputs):
            return self.inputs[k]
        return self.inputs[k] + part * (self.inputs[k + 1] - self.inputs[k])

    def waiting_input_at(self, clock: float, pace: float) -> Array:
        """Return the input for a clock that runs at this `pace`, so that the pen keeps its path.

        At another pace than 1 its speed is pace y', its acceleration pace^2 y'': without that a
        spring whose clock is slow would leave the path, and the clock would never recover.
        After the end nothing waits, and the pen goes to its goal, which its path may miss.
        """
        u = self.input_at(clock)
        if pace == 1 or clock >= len(self.inputs):
            return u
        y = self.path_at(clock)
        moving = self.spring.alpha * (self.path_at(clock + 1) - y) * self.spring.steps
        still = self.spring.K * y
        return still + pace * moving + pace**2 * (u - still - moving)

    def path_at(self, clock: float) -> Array:
        """Return where the undisturbed pen is after so many steps, from its start, (D,) [m]."""
        last = len(self.path) - 1
        k = int(min(max(clock, 0.0), last - 1e-9))
        part = min(max(clock, 0.0), float(last)) - k
        return self.path[k] + part * (self.path[k + 1] - self.path[k])

    @cached_property
    def path(self) -> Array:
        """The path of an undisturbed pen, from its start, shape (M + 1, D) [m]."""
        return self.spring.follow(self.inputs, self.start_velocity)


@dataclass(frozen=True, eq=False, repr=False)
class Stepper(Value):
    """A movement under way: a value; each `step` gives the next.

        pen = Stepper.begin(primitive)
        while not pen.over:
            pen = pen.step(push=(3.0, 0.0) if 0.5 < pen.t < 0.6 else None)

    Undisturbed it draws what `DMP.rollout` draws. Made by `Stepper.begin`.

    Args:
        plan: The input of the pen.
        patience: Phase stopping: how far off its path the pen must be for the clock to run at half
            speed [m]; None: the clock never waits.
        t: Time since the start [s].
        clock: How many steps of the movement are over; not a whole number once the clock has
            waited.
        states: z = y - y0 and its velocity per movement, one step earlier and now, (2, 2, D) [m].
    """

    plan: Plan
    patience: float | None
    t: float
    clock: float
    states: Array

    @classmethod
    @checked
    def begin(
        cls,
        primitive: DMP,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        duration: float | None = None,
        patience: float | None = None,
    ) -> Self:
        """Return a pen at the start of a movement.

        Args:
            primitive: What was learned.
            start: As in `DMP.rollout` [m].
            goal: As in `DMP.rollout` [m].
            duration: As in `DMP.rollout` [s].
            patience: Phase stopping: how far off its path the pen halves the speed of the clock
                [m].

        Raises:
            TrajectoryError: As `DMP.rollout`, or a patience that is not a distance.
        """
        plan = Plan.of(primitive, start, goal, duration)
        if patience is not None and not (
            isinstance(patience, int | float) and 0 < patience < np.inf
        ):
            raise TrajectoryError(
                f"patience is {shown(patience)}, but it must be a distance over 0 m, or None."
            )
        now = np.array([np.zeros_like(plan.start), plan.start_velocity])
        return cls(plan, patience, 0.0, 0.0, np.array([np.full_like(now, np.nan), now]))

    @checked
    def step(self, push: ArrayLike | None = None) -> Self:
        """Return the pen one step later; after the end of the movement it goes on to its goal.

        Args:
            push: What disturbs it, an acceleration, shape (D,) [m/s^2].

        Raises:
            TrajectoryError: A push of another dimension, or not finite.
        """
        plan, spring, pace = self.plan, self.plan.spring, self._pace()
        u = plan.waiting_input_at(self.clock, pace)
        if push is not None:
            u = u + check_point("push", push, len(plan.start)) * plan.duration**2
        h = 1 / spring.steps
        states = spring.integrator.step(spring.K, spring.alpha, h, u, self.states)
        return replace(self, t=self.t + h * plan.duration, clock=self.clock + pace, states=states)

    @checked
    def moved(self, by: ArrayLike) -> Self:
        """Return the same pen, taken elsewhere by somebody's hand: `by` (D,) [m]."""
        hand = check_point("by", by, len(self.plan.start))
        return replace(self, states=self.states + np.array([hand, np.zeros_like(hand)]))

    def __repr__(self) -> str:
        of = f"{self.plan.duration:.3f} s, {self.clock:g} of {self.plan.spring.steps} steps"
        return f"Stepper({self.t:.3f} s of {of}, pen at {self.position} m)"

    @checked
    def led(self, goal: ArrayLike) -> Self:
        """Return the same pen with another goal (D,) [m] from now on.

        Place, speed and clock stay; the acceleration steps by what the equation's input for this
        goal has more at this clock. A pen that learns late of a far goal is still on its way when
        its clock is at the end: its next steps take it there.

        Raises:
            TrajectoryError: As `DMP.rollout`.
        """
        plan = self.plan
        return replace(self, plan=Plan.of(plan.primitive, plan.start, goal, plan.duration))

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
        """How far the pen is from where it would be undisturbed, at this clock [m]."""
        return float(np.linalg.norm(self.states[1, 0] - self.plan.path_at(self.clock)))

    def _pace(self) -> float:
        """Return how much of a step the clock makes."""
        if self.patience is None or (off := self.off_path) < 1e-9:
            return 1.0
        return 1 / (1 + off / self.patience)
