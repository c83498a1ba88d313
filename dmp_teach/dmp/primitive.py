"""The dynamic movement primitive: a movement learned once, drawn again to any goal."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Self, cast

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked
from dmp_teach.dmp.checks import as_settings, check_duration, check_point, count_steps
from dmp_teach.dmp.coverage import note_gaps
from dmp_teach.dmp.equation import Equation, kernels_of
from dmp_teach.dmp.fit import FITS
from dmp_teach.dmp.integrators import least_steps
from dmp_teach.dmp.kernels import Kernels
from dmp_teach.dmp.preprocessing import has_even_times, prepare_demonstration, sharpen_bends
from dmp_teach.dmp.primitive_json import clock_to_forget, primitive_from_json, primitive_to_json
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.transformations import TRANSFORMATIONS, Transformation
from dmp_teach.errors import TrajectoryError, kind_of
from dmp_teach.files import Saved
from dmp_teach.trajectory import Array, Trajectory, from_rollout
from dmp_teach.values import Value


@dataclass(frozen=True, eq=False, repr=False)
class DMP(Saved, Value):
    """A spring that is attracted by its goal and forced by a learned f (the paper's equation 1).

        original    y'' = K (g - y) - D y' + (g - y0) f
        star        y'' = K (g - y) - D y' - K (g - y0) s + K f   (Pastor 2009; the paper's DMP*)
        similarity  as star, turned and scaled so that g - y0 comes to the new one  (Ginesi 2019)
        f(s)        = s * sum psi_i w_i / sum psi_i      (+ sum psi_i b_i / sum psi_i with biases)

    with D = alpha / T and K = (D / (2 damping))^2. Made by `DMP.imitate`; never edited.

    Args:
        weights: Shape (N, D), kernel 1 at the end of the movement [m; 1/s^2 T^2 for the original].
        biases: Shape (N, D), or None.
        start: y0 of the demonstration, shape (D,) [m].
        goal: g of the demonstration, shape (D,) [m].
        duration: T [s].
        settings: As they were used: `n_kernels` and `alpha` are numbers.
        start_velocity: Of the pen, shape (D,) [m/s]; a shorter duration makes it faster.
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

    file_kind, extra_fields = "primitive", ("path",)

    # Any: whatever the fields hold.
    def __getstate__(self) -> dict[str, Any]:
        # Drawn again elsewhere, the last bits of the path may differ.
        return {**super().__getstate__(), "nominal_path": self.nominal_path}

    def __repr__(self) -> str:
        n_kernels, dimensions = self.weights.shape
        return (
            f"DMP({n_kernels} kernels, {dimensions}-D, {self.duration:.3f} s, "
            f"{self.settings.transform})"
        )

    @classmethod
    def imitate(cls, trajectory: Trajectory, settings: Settings | None = None) -> Self:
        """Learn a movement from one demonstration (Algorithms 1 and 2 of the paper).

        Where no kernel is active f is 0: a `SettingWarning`, and a note, say when.

        Args:
            trajectory: The demonstration, any number of dimensions.
            settings: `Settings.star()` unless given.

        Raises:
            TrajectoryError: It is not a `Trajectory`.
            SettingError: Settings that are none, more kernels than samples, `original` with a
                coordinate that ends where it began, or `similarity` with a closed stroke.
        """
        if not isinstance(trajectory, Trajectory):
            what = kind_of(trajectory)
            raise TrajectoryError(
                f"A primitive is learned from a Trajectory(t, position), but got {what}."
            )
        T = trajectory.duration
        settings = as_settings(settings).resolved(T, len(trajectory))
        n_kernels, alpha = cast(int, settings.n_kernels), cast(float, settings.alpha)
        fit = FITS[settings.fit].of(settings)
        TRANSFORMATIONS[settings.transform].of(settings).check_demonstration(trajectory.position)
        path, notes = prepare_demonstration(
            trajectory, settings.smoothing, least_steps(alpha, settings.damping)
        )
        z, offset = path - path[0], path[-1] - path[0]
        equation = Equation(settings, len(z) - 1)
        spring, kernels = equation.spring, equation.kernels

        rounded = settings.sharpen and fit.rounds_bends
        sharp = sharpen_bends(z, equation.steps / n_kernels) if rounded else z
        u, velocity = spring.needed(sharp, settings.derivatives)
        seen = equation if len(u) == equation.steps else replace(equation, samples=len(u))
        F = seen.needed_forcing(u, offset)
        weights, biases = fit.learn(seen.kernels, seen.s, F, spring)

        # One filter draws the path and, in a column of its own, what a start velocity adds to it.
        paths = spring.follow(equation.input(weights, biases, offset), np.array([*velocity, 1.0]))
        nominal, kick = paths[:, :-1], paths[:, -1]
        if settings.start_velocity == "fitted":
            faster = kick @ (z - nominal) / (kick @ kick)
            nominal = nominal + np.multiply.outer(faster, kick).T
            velocity = velocity + faster
        notes += note_gaps(kernels, settings, T)
        measures = trajectory.t, equation.steps, notes
        learned = cls(weights, biases, path[0], path[-1], T, settings, velocity / T, *measures)
        return learned._keep_path(nominal)

    def with_path(self, path: Array) -> Self:
        """Return the same with `path` (M + 1, D) as its nominal path, which is not drawn anew."""
        return replace(self)._keep_path(np.array(path))

    @checked
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
            dt: Time between samples [s], rounded so that the last sample is the end of the
                movement. The demonstration's own sample times, stretched with the duration, if not
                given. Coarser than those, the same path; finer, the spring takes finer steps too,
                which brings it nearer to the differential equation and, in a fast letter, up to
                2 mm away from the demonstration.

        Returns:
            A trajectory that begins when the demonstration began.

        Raises:
            TrajectoryError: A start or goal of another dimension or not finite, a duration or dt
                that is not a time, a dt longer than the movement.
            SettingError: A similarity is to lead a closed stroke elsewhere.
        """
        if start is duration is dt is None:
            if goal is None:
                return from_rollout(self.times, self._demonstrated)
            if TRANSFORMATIONS[self.settings.transform].is_translation:
                # It is affine in its goal, y(t; g) = A(t) g + b(t).
                position = self._goal_gain * check_point("goal", goal, len(self.start))
                position += self._path_to_zero
                return from_rollout(self.times, position)
        start = self.start if start is None else check_point("start", start, len(self.start))
        goal = self.goal if goal is None else check_point("goal", goal, len(self.start))
        T = self.duration if duration is None else check_duration("duration", duration)
        if dt is None:
            path = self._path(goal - start, self.steps)
            times = self.times if duration is None else self.times[0] + T * self._clock()
            return Trajectory(times, start + self.at_sample_times(path))
        steps = count_steps(T, check_duration("dt", dt))
        even = np.linspace(0, 1, steps + 1)
        path = self._path(goal - start, max(steps, self.steps))
        return Trajectory(self.times[0] + T * even, start + _interpolated(path, even))

    @checked
    def mapped(self, matrix: Array) -> Self:
        """Return the primitive whose path is this one's, mapped by a matrix (D, D) at its start.

        The weights of `original` belong to one goal offset: it cannot be mapped.
        """
        if np.shape(matrix) != 2 * self.start.shape:
            raise TrajectoryError(
                f"matrix has shape {np.shape(matrix)}, but must be {2 * self.start.shape}."
            )
        return replace(
            self,
            weights=self.weights @ matrix.T,
            biases=None if self.biases is None else self.biases @ matrix.T,
            goal=self.start + matrix @ (self.goal - self.start),
            start_velocity=matrix @ self.start_velocity,
        )

    @property
    def kernels(self) -> Kernels:
        """The bumps, for those who want to draw them."""
        return kernels_of(self.settings)

    @property
    def transformation(self) -> Transformation:
        """How the path follows its goal."""
        return TRANSFORMATIONS[self.settings.transform].of(self.settings)

    @cached_property
    def nominal_path(self) -> Array:
        """The path to the demonstrated goal, seen from its start, shape (M + 1, D) [m]."""
        return self._drawn(self.steps)

    @property
    def shown(self) -> Array:
        """The old name of `nominal_path`."""
        warnings.warn("DMP.shown is now called nominal_path.", DeprecationWarning, stacklevel=2)
        return self.nominal_path

    def showing(self, path: Array) -> Self:
        """Do what `with_path` does, by its old name."""
        warnings.warn("DMP.showing is now called with_path.", DeprecationWarning, stacklevel=2)
        return self.with_path(path)

    # Any: what JSON holds.
    def _to_json(self) -> dict[str, Any]:
        return primitive_to_json(self, clock_to_forget(self.times[0]))

    @classmethod
    def _from_json(cls, content: dict[str, Any]) -> Self:
        own = {k: v for k, v in content.items() if k not in ("format", "version")}
        return primitive_from_json(cls, own)

    def _keep_path(self, path: Array) -> Self:
        path.setflags(write=False)
        self.__dict__["nominal_path"] = path
        return self

    @cached_property
    def _goal_gain(self) -> Array:
        """A: how the path grows with each coordinate of the goal, shape (T, D)."""
        gain = Equation(self.settings, self.steps).goal_gain()
        gain = np.broadcast_to(gain, self.nominal_path.shape)
        # Each coordinate in one piece of memory halves a product with one number for each.
        return np.asfortranarray(self.at_sample_times(gain))

    @cached_property
    def _path_to_zero(self) -> Array:
        """b: the path to a goal at 0, shape (T, D) [m]."""
        return np.asfortranarray(self._demonstrated - self._goal_gain * self.goal)

    @cached_property
    def _demonstrated(self) -> Array:
        """The path to the demonstrated goal at the demonstration's sample times, shape (T, D)."""
        return self.at_sample_times(self.start + self.nominal_path)

    @checked
    def at_sample_times(self, path: Array) -> Array:
        """Return `path` (M + 1, D) at the demonstration's sample times, shape (T, D)."""
        stride = self.steps // (len(self.times) - 1)
        # Uneven times are learned in at least 4 steps a sample: 1 needs no look at the clock.
        if stride == 1 or has_even_times(self.times):
            return path[::stride]
        return _interpolated(path, self._clock())

    def _clock(self) -> Array:
        """Return the demonstration's sample times as parts of the movement, shape (T,)."""
        return (self.times - self.times[0]) / self.duration

    def _path(self, offset: Array, steps: int) -> Array:
        """Return the path from its start for a goal offset (D,), shape (steps + 1, D)."""
        path = self.nominal_path if steps == self.steps else self._drawn(steps)
        taught = self.goal - self.start
        if (offset == taught).all():
            return path
        self.transformation.check_goal(taught, offset, path)
        equation, velocity = Equation(self.settings, steps), self.start_velocity * self.duration
        moved = self.transformation.retarget(path, taught, offset, equation.goal_gain())
        if self.settings.start_velocity == "kept":
            change = self.transformation.retarget(velocity, taught, offset, 0.0) - velocity
            moved = moved - equation.spring.kick() * change
        return moved

    def _drawn(self, steps: int) -> Array:
        """Return the path to the demonstrated goal, in so many steps."""
        equation, velocity = Equation(self.settings, steps), self.start_velocity * self.duration
        u = equation.input(self.weights, self.biases, self.goal - self.start)
        return equation.spring.follow(u, velocity)


def _interpolated(path: Array, at: Array) -> Array:
    """Return `path` (M + 1, D) at the parts `at` (T,) of the movement, straight between steps."""
    place = at * (len(path) - 1)
    below = np.minimum(place.astype(int), len(path) - 2)
    part = (place - below)[:, None]
    return path[below] + part * (path[below + 1] - path[below])
