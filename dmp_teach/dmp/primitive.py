"""The dynamic movement primitive: a movement learned once, drawn again to any goal."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.checks import (
    as_settings,
    check_point,
    refuse_no_similarity,
    refuse_no_way,
    samples,
    seconds,
)
from dmp_teach.dmp.coverage import asleep
from dmp_teach.dmp.equation import Equation, kernels_of, turned_and_scaled
from dmp_teach.dmp.fit import FITS
from dmp_teach.dmp.integrators import least_steps
from dmp_teach.dmp.kernels import Kernels
from dmp_teach.dmp.preprocessing import has_even_times, prepared, sharpened
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import TrajectoryError, kind_of
from dmp_teach.trajectory import Array, Trajectory, locked


@dataclass(frozen=True, eq=False)
class DMP:
    """A movement as a spring that is pulled to its goal and pushed by a learned forcing f (the paper's equation 1).

        original    y'' = K (g - y) - D y' + (g - y0) f
        star        y'' = K (g - y) - D y' - K (g - y0) s + K f      (Pastor 2009; the paper's DMP*)
        similarity  as star, turned and scaled so that g - y0 comes to the new one      (Ginesi 2019, DMP++)
        f(s)        = s * sum psi_i w_i / sum psi_i                  (+ sum psi_i b_i / sum psi_i with biases)

    with D = alpha / T and K = (D / (2 damping))^2. Made by `DMP.imitate`; never edited.

    Args:
        weights: Shape (N, D), kernel 1 at the end of the movement [m; 1/s^2 T^2 for the original].
        biases: Shape (N, D), or None.
        start: y0 of the demonstration, shape (D,) [m].
        goal: g of the demonstration, shape (D,) [m].
        duration: T [s].
        settings: As they were used: `n_kernels` and `alpha` are numbers.
        start_velocity: How fast the pen was at the start, shape (D,) [m/s]; a shorter duration makes it faster.
        times: The demonstration's own sample times, shape (T,) [s].
        steps: How many steps the spring takes for one movement.
        notes: What was done to the demonstration, or could not be done, in sentences.
    """

    weights: Array
    biases: Array | None
    start: Array
    goal: Array
    duration: float
    settings: Settings
    start_velocity: Array
    times: Array = field(repr=False)
    steps: int
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Lock the arrays."""
        values = self.__dict__
        for name in ("weights", "biases", "start", "goal", "start_velocity", "times"):
            if values[name] is not None:
                values[name] = locked(values[name])

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        n_kernels, dimensions = self.weights.shape
        return f"DMP({n_kernels} kernels, {dimensions}-D, {self.duration:.3f} s, {self.settings.transform})"

    @classmethod
    def imitate(cls, trajectory: Trajectory, settings: Settings | None = None) -> Self:
        """Learn a movement from one demonstration (Algorithm 1 and 2 of the paper).

        Args:
            trajectory: What was shown, any number of dimensions.
            settings: `Settings.star()` unless given.

        Raises:
            TrajectoryError: It is not a `Trajectory`.
            SettingError: Settings that are none, more kernels than samples, `original` with a coordinate that ends
                where it began, or `similarity` with a closed stroke.

        Where no kernel is awake f is 0: a `SettingWarning`, and a note, say when.
        """
        if not isinstance(trajectory, Trajectory):
            what = kind_of(trajectory)
            raise TrajectoryError(
                f"A primitive is learned from a Trajectory(t, position), but got {what}."
            )
        T = trajectory.duration
        settings = as_settings(settings).resolved(T, len(trajectory))
        refuse_no_way(trajectory, settings)
        path, notes = prepared(
            trajectory, settings.smoothing, least_steps(settings.alpha, settings.damping)
        )
        z, way = path - path[0], path[-1] - path[0]
        equation = Equation(settings, len(z) - 1)
        spring, kernels, s = equation.spring, equation.kernels, equation.s

        rounding = settings.sharpen and settings.fit == "lwr"
        sharp = sharpened(z, equation.steps / settings.n_kernels) if rounding else z
        push, velocity = spring.needed(sharp, settings.derivatives)
        F = equation.needed_forcing(push, way)
        weights, biases = FITS[settings.fit](kernels, s, F, spring)

        paths = spring.follow(equation.push(weights, biases, way), np.array([*velocity, 1.0]))
        drawn, kick = paths[:, :-1], paths[:, -1]
        if settings.start_velocity == "fitted":  # the one that fits best
            faster = kick @ (z - drawn) / (kick @ kick)
            drawn, velocity = drawn + np.multiply.outer(faster, kick).T, velocity + faster
        notes += asleep(kernels, settings, T)
        measures = trajectory.t, equation.steps, notes
        learned = cls(weights, biases, path[0], path[-1], T, settings, velocity / T, *measures)
        drawn.setflags(write=False)
        learned.__dict__["shown"] = drawn  # what `shown` would draw again
        return learned

    def showing(self, path: Array) -> Self:
        """The same, with `path` for `shown`: it costs no second drawing, and keeps the last bits of the first."""
        same = replace(self)
        same.__dict__["shown"] = locked(path)
        return same

    def rollout(
        self,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        duration: float | None = None,
        dt: float | None = None,
    ) -> Trajectory:
        """Draw the movement.

        Args:
            start: Where it begins, shape (D,) [m]; as demonstrated if not given.
            goal: Where it ends, shape (D,) [m]; as demonstrated if not given.
            duration: How long it takes [s]; as demonstrated if not given. A longer one is slower.
            dt: Time between samples [s], rounded so that the last sample is the end of the movement. The
                demonstration's own sample times, stretched with the duration, if not given. Coarser than
                those, the same path; finer, the spring takes finer steps too, which brings it nearer to the
                differential equation and, in a fast letter, up to 2 mm away from the demonstration.

        Returns:
            A trajectory that begins when the demonstration began.

        Raises:
            TrajectoryError: A start or goal of another dimension or not finite, a duration or dt that is
                not a time, a dt longer than the movement.
            SettingError: A similarity is to lead a closed stroke elsewhere.
        """
        if start is duration is dt is None:
            if goal is None:
                return Trajectory._drawn(self.times, self._demonstrated)
            if self.settings.transform == "star":
                return Trajectory._drawn(
                    self.times, self._led_to(check_point("goal", goal, len(self.start)))
                )
        start = self.start if start is None else check_point("start", start, len(self.start))
        goal = self.goal if goal is None else check_point("goal", goal, len(self.start))
        T = self.duration if duration is None else seconds("duration", duration)
        if dt is None:
            path = self._path(goal - start, self.steps)
            times = self.times if duration is None else self.times[0] + T * self._clock
            return Trajectory(times, start + self._at_own_times(path))
        fine = samples(T, seconds("dt", dt))
        even = np.linspace(0, 1, fine + 1)
        path = self._path(goal - start, max(fine, self.steps))
        return Trajectory(self.times[0] + T * even, start + _read(path, even))

    @property
    def kernels(self) -> Kernels:
        """The bumps, for those who want to draw them."""
        return kernels_of(self.settings)

    @cached_property
    def shown(self) -> Array:
        """The path to the demonstrated goal, seen from its start, shape (M + 1, D), M being `steps` [m].

        It is kept: another goal costs one product and one sum.
        """
        return self._drawn(self.steps)

    @cached_property
    def _clock(self) -> Array:
        """The demonstration's sample times as parts of the movement, shape (T,)."""
        return (self.times - self.times[0]) / self.duration

    @cached_property
    def _own(self) -> slice | None:
        """Which steps are the demonstration's own samples; None if its times were uneven."""
        finer = self.steps // (
            len(self.times) - 1
        )  # uneven times are resampled finer: 1 needs no look at them
        return slice(None, None, finer) if finer == 1 or has_even_times(self.times) else None

    def _led_to(self, goal: Array) -> Array:
        """The demonstrated path, led to another goal, at the demonstration's own times: one product and one sum.

        What a slider waits for; `_path` draws the same, from any start, in any transformation and step.
        """
        position = self._longer * goal
        position += self._led_to_zero
        return position

    @cached_property
    def _led_to_zero(self) -> Array:
        """The same to the goal 0, shape (T, D): with it a path needs no difference of two goals."""
        return self._demonstrated - self._longer * self.goal

    @cached_property
    def _demonstrated(self) -> Array:
        """The path to the demonstrated goal at the demonstration's own times, shape (T, D)."""
        return self._at_own_times(self.start + self.shown)

    @cached_property
    def _longer(self) -> Array:
        """How that changes when its way becomes 1 longer in each coordinate, shape (T, D)."""
        return self._at_own_times(np.broadcast_to(self._answer, self.shown.shape))

    def _at_own_times(self, path: Array) -> Array:
        """`path` (M + 1, D) at the demonstration's times, shape (T, D).

        Each coordinate lies in one piece (Fortran's order): that halves a product with one number per coordinate.
        """
        return np.asfortranarray(path[self._own] if self._own else _read(path, self._clock))

    def _path(self, way: Array, steps: int) -> Array:
        """The path from its start, shape (steps + 1, D). It is linear in the way from start to goal."""
        kept = steps == self.steps
        shown, taught = self.shown if kept else self._drawn(steps), self.goal - self.start
        if self.settings.transform == "original":
            return shown * (way / taught)
        change = way - taught
        if not change.any():
            return shown
        if self.settings.transform == "similarity":
            refuse_no_similarity(way, taught, shown)
            return shown @ turned_and_scaled(way, taught).T
        return shown + (self._answer if kept else Equation(self.settings, steps).answer()) * change

    def _drawn(self, steps: int) -> Array:
        """The path to the demonstrated goal, in so many steps."""
        velocity = self.start_velocity * self.duration
        return Equation(self.settings, steps).draw(
            self.weights, self.biases, self.goal - self.start, velocity
        )

    @cached_property
    def _answer(self) -> Array:
        """How the path changes with its way, kept."""
        return Equation(self.settings, self.steps).answer()


def _read(path: Array, at: Array) -> Array:
    """`path` (M + 1, D) at the parts `at` (T,) of the movement, straight between its steps."""
    place = at * (len(path) - 1)
    below = np.minimum(place.astype(int), len(path) - 2)
    part = (place - below)[:, None]
    return path[below] + part * (path[below + 1] - path[below])
