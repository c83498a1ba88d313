"""The dynamic movement primitive: a movement learned once, drawn again to any goal."""

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.demonstration import has_even_times, prepared
from dmp_teach.dmp.fit import FITS, forcing
from dmp_teach.dmp.kernels import Cells, Kernels, Overlap
from dmp_teach.dmp.phase import Phase
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.spring import Spring
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.trajectory import Array, Trajectory, locked

LEAST_STEPS, MOST_STEPS = 50, 2_000_000


@dataclass(frozen=True, eq=False)
class DMP:
    """A movement as a spring that is pulled to its goal and pushed by a learned forcing f (the paper's equation 1).

        original  y'' = K (g - y) - D y' + (g - y0) f
        star      y'' = K (g - y) - D y' - K (g - y0) s + K f      (Pastor 2009; the paper's DMP*)
        f(s)      = s * sum psi_i w_i / sum psi_i                  (+ sum psi_i b_i / sum psi_i with biases)

    with K = alpha^2/4 / T^2 and D = alpha / T. Made by `DMP.imitate`; never edited.

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
        for name in ("weights", "biases", "start", "goal", "start_velocity", "times"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, locked(getattr(self, name)))

    @classmethod
    def imitate(cls, trajectory: Trajectory, settings: Settings | None = None) -> Self:
        """Learn a movement from one demonstration (Algorithm 1 and 2 of the paper).

        Args:
            trajectory: What was shown, any number of dimensions.
            settings: `Settings.star()` unless given.

        Raises:
            SettingError: More kernels than samples, or `original` with a coordinate that ends where it began.
        """
        settings = (settings or Settings.star()).resolved(trajectory.duration, len(trajectory))
        way = trajectory.position[-1] - trajectory.position[0]
        if settings.transform == "original":
            _refuse_no_way(way, np.ptp(trajectory.position))
        path, notes = prepared(trajectory, settings.smoothing, _least_steps(settings))
        spring = Spring(settings.alpha, len(path) - 1, settings.integrator)
        s, kernels = _laid_out(settings, spring.steps)
        push, velocity = spring.needed(path - path[0])
        F = push / spring.K - way * (1 - s) if settings.transform == "star" else push / way - spring.K
        weights, biases = FITS[settings.fit](kernels, s, F)
        start, goal, T = path[0], path[-1], trajectory.duration
        return cls(weights, biases, start, goal, T, settings, velocity / T, trajectory.t, spring.steps, notes)

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
                demonstration's own sample times, stretched with the duration, if not given.

        Returns:
            A trajectory that begins when the demonstration began.

        Raises:
            TrajectoryError: A start or goal of another dimension or not finite, a duration or dt that is
                not a time, a dt longer than the movement.
        """
        start = self.start if start is None else self._point("start", start)
        goal = self.goal if goal is None else self._point("goal", goal)
        T = self.duration if duration is None else _time("duration", duration)
        if dt is None:
            times = (
                self.times if duration is None else self.times[0] + (self.times - self.times[0]) * (T / self.duration)
            )
            return Trajectory(times, start + self._at_own_times(self._path(goal - start, self.steps)))
        samples = _samples(T, _time("dt", dt))
        every = math.ceil(self.steps / samples)
        path = self._path(goal - start, samples * every)[::every]
        return Trajectory(self.times[0] + np.linspace(0, T, samples + 1), start + path)

    @property
    def kernels(self) -> Kernels:
        """The bumps, for those who want to draw them."""
        return _kernels(self.settings)

    def _path(self, way: Array, steps: int) -> Array:
        """The path relative to its start, shape (steps + 1, D). It is linear in the way from start to goal."""
        shown, answer = self._shown if steps == self.steps else self._draw(steps)
        if self.settings.transform == "original":
            return shown * (way / (self.goal - self.start))
        return shown + answer * (way - (self.goal - self.start))

    @cached_property
    def _shown(self) -> tuple[Array, Array]:
        """`_draw` at the demonstration's own steps, kept: another goal costs one product and one sum."""
        return self._draw(self.steps)

    def _draw(self, steps: int) -> tuple[Array, Array]:
        """The demonstrated path (steps + 1, D), and the answer (steps + 1, 1) to a goal 1 m further away."""
        settings, way = self.settings, self.goal - self.start
        spring = Spring(settings.alpha, steps, settings.integrator)
        s, kernels = _laid_out(settings, steps)
        f = forcing(kernels, s, self.weights, self.biases)
        velocity = self.start_velocity * self.duration
        if settings.transform == "original":
            return spring.follow(way * (spring.K + f), velocity), np.zeros((steps + 1, 1))
        pull = spring.K * (1 - s)
        ahead = settings.alpha * _phase(settings).speed(s) if settings.feed_goal else 0.0
        return spring.follow(pull * way + spring.K * f, velocity), spring.follow(pull + ahead)

    def _at_own_times(self, path: Array) -> Array:
        """`path` where the demonstration had its samples."""
        if self._even:
            return path[:: (len(path) - 1) // (len(self.times) - 1)]
        at = (self.times - self.times[0]) * ((len(path) - 1) / self.duration)
        below = np.minimum(at.astype(int), len(path) - 2)
        part = (at - below)[:, None]
        return path[below] * (1 - part) + path[below + 1] * part

    @cached_property
    def _even(self) -> bool:
        return has_even_times(self.times)

    def _point(self, name: str, value: ArrayLike) -> Array:
        """`value` as a point of this movement, or a sentence."""
        try:
            point = np.asarray(value, dtype=float)
        except (TypeError, ValueError):
            raise TrajectoryError(f"{name} is {value!r}, but it must be {len(self.start)} numbers [m].") from None
        if point.shape != self.start.shape:
            raise TrajectoryError(
                f"{name} has shape {point.shape}, but this movement has {len(self.start)} dimensions: "
                f"give {len(self.start)} numbers [m]."
            )
        if not np.isfinite(point).all():
            raise TrajectoryError(f"{name} is {point}, but it must be finite [m].")
        return point


def _phase(settings: Settings) -> Phase:
    return Phase(settings.phase, settings.phase_decay)


def _kernels(settings: Settings) -> Kernels:
    return Kernels(settings.n_kernels, settings.kernel_width, settings.kernel_sigma, _phase(settings))


def _laid_out(settings: Settings, steps: int) -> tuple[Array, Cells | Overlap]:
    """The phases (steps, 1) at which the spring takes its steps, and the kernels laid over them."""
    s = _phase(settings).at(np.arange(steps, 0, -1) / steps)
    return s[:, None], _kernels(settings).over(s)


def _least_steps(settings: Settings) -> float:
    """Enough for any stiffness: an explicit spring needs more than alpha/4 steps, a semi-implicit one alpha/1.65."""
    return max(LEAST_STEPS, 2 * settings.alpha)


def _refuse_no_way(way: Array, size: float) -> None:
    """The original form divides by g - y0."""
    for axis, part in enumerate(way):
        if abs(part) <= 1e-9 * size:
            raise SettingError(
                f"The original form cannot learn a movement that ends where it began: goal and start are equal in "
                f"coordinate {axis} ({'xyz'[axis] if axis < 3 else axis}). Use Settings.star(), which can."
            )


def _time(name: str, value: float) -> float:
    """`value` as a length of time, or a sentence."""
    try:
        seconds = float(value)
    except (TypeError, ValueError):
        seconds = math.nan
    if not (math.isfinite(seconds) and seconds > 0):
        raise TrajectoryError(f"{name} is {value!r}, but it must be a time longer than 0 s.")
    return seconds


def _samples(duration: float, dt: float) -> int:
    """How many steps of about `dt` a movement has."""
    if dt > duration * (1 + 1e-9):
        raise TrajectoryError(f"dt is {dt:g} s, but the movement lasts only {duration:g} s; dt must be shorter.")
    if duration / dt > MOST_STEPS:
        raise TrajectoryError(f"dt is {dt:g} s, but must be at least {duration / MOST_STEPS:.3g} s for {duration:g} s.")
    return max(1, round(duration / dt))
