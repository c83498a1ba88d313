"""The spring and damper that carry the pen, stepped through one movement, and read backwards.

    z'' = u - K z - D z'

Time is counted in movements (t/T), so that D = alpha and K = (alpha / (2 damping))^2.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.filtering import filter_recursively
from dmp_teach.trajectory import Array

FEWEST_SPRING_STEPS = 50
# Eight times what the explicit spring needs not to diverge.
STEPS_PER_ALPHA = 2.0
MOST_STEPS = 100_000

Row = tuple[float, float]
System = tuple[tuple[Row, Row], Row]
Kinematics = tuple[Array, Array, Array, Array]


def least_steps(alpha: float, damping: float = 1.0) -> float:
    """Return how many steps any integrator needs; a spring that swings needs more."""
    return max(FEWEST_SPRING_STEPS, STEPS_PER_ALPHA * alpha / min(1.0, damping) ** 2)


def most_alpha(damping: float) -> float:
    """Return the alpha of the stiffest spring that can be followed in `MOST_STEPS` steps."""
    return MOST_STEPS * min(1.0, damping) ** 2 / STEPS_PER_ALPHA


class Integrator(NamedChoice):
    """A way to step through time: x[k+1] = A x[k] + B u[k], with the state x = (z, z').

    Eliminating z' leaves a recursion in the positions alone, so one filter draws a whole movement.

    Attributes:
        middle: Where in its step an input is taken, in steps: one that is held stands for the
            middle.
        first_input: Which input is the first that has an effect.
    """

    setting = "integrator"
    middle: ClassVar[float] = 0.0
    first_input: ClassVar[int] = 0

    @abstractmethod
    def system(self, K: float, D: float, h: float) -> System:
        """Return A and B for steps of length h."""

    @abstractmethod
    def derivatives(self, z: Array, slope: Array, bend: Array, h: float) -> Kinematics:
        """Return what `needed` sees of a path z (M + 1, D) when it reads the scheme backwards.

        Args:
            z: The path.
            slope: Its first differences over h, shape (M, D).
            bend: Its second differences, shape (M - 1, D).
            h: The length of a step.

        Returns:
            Positions, velocities and accelerations that make the input of each step, shape (M, D),
            and the start velocity (D,).
        """

    def recursion(self, K: float, D: float, h: float) -> tuple[tuple[float, ...], Row, float]:
        """Return the recursion: of the positions, of the last two inputs, of the start velocity."""
        ((a, b), (c, d)), (e, f) = self.system(K, D, h)
        return (-(a + d), a * d - b * c), (e, b * f - d * e), b

    def step(self, K: float, D: float, h: float, u: Array, states: Array) -> Array:
        """Take one step of length h under the input u (D,).

        `states` (2, 2, D) are z and z' one step earlier, NaN earlier than the start, and now; those
        of now and after the step are returned.
        """
        A, B = self.system(K, D, h)
        return np.array([states[1], A @ states[1] + np.outer(B, u)])


INTEGRATORS: Registry[type[Integrator]] = Registry()


@INTEGRATORS.add
class Explicit(Integrator):
    """Forward Euler: z' drives z, z'' drives z', both as they are before the step.

    First order; with critical damping it diverges from alpha = 4 steps on.
    """

    name = "explicit"

    def system(self, K: float, D: float, h: float) -> System:
        """Return A and B for steps of length h."""
        return ((1, h), (-h * K, 1 - h * D)), (0, h)

    def derivatives(self, z: Array, slope: Array, bend: Array, h: float) -> Kinematics:
        """Take differences forwards; the last input, which is open, has its neighbour's z''."""
        return z[:-1], slope, np.concatenate([bend, bend[-1:]]), slope[0]


@INTEGRATORS.add
class SemiImplicit(Integrator):
    """Symplectic Euler: the position uses the new velocity.

    First order; with critical damping it diverges from alpha = 1.65 steps on.
    """

    name = "semi-implicit"

    def system(self, K: float, D: float, h: float) -> System:
        """Return A and B for steps of length h."""
        return ((1 - h * h * K, h * (1 - h * D)), (-h * K, 1 - h * D)), (h * h, h)

    def derivatives(self, z: Array, slope: Array, bend: Array, h: float) -> Kinematics:
        """Take differences backwards; the first input, which is open, has its neighbour's z''."""
        v = np.concatenate([slope[:1] - h * bend[:1], slope[:-1]])
        return z[:-1], v, np.concatenate([bend[:1], bend]), v[0]


@INTEGRATORS.add
class Exact(Integrator):
    """The motion itself, where the input is held for the step (zero-order hold). Never diverges."""

    name = "exact"
    middle = 0.5

    def system(self, K: float, D: float, h: float) -> System:
        """Return E = exp(h [[0, 1], [-K, -D]]) in closed form, and (I - E) (1/K, 0)."""
        r = D / 2
        w = math.sqrt(abs(r * r - K))
        if w * h < 1e-6:
            c, s = 1.0, h
        elif r * r < K:
            c, s = math.cos(w * h), math.sin(w * h) / w
        else:
            c, s = math.cosh(w * h), math.sinh(w * h) / w
        fade = math.exp(-r * h)
        zz, zv, vz, vv = fade * (c + r * s), fade * s, -fade * K * s, fade * (c - r * s)
        return ((zz, zv), (vz, vv)), ((1 - zz) / K, -vz / K)

    def derivatives(self, z: Array, slope: Array, bend: Array, h: float) -> Kinematics:
        """Take differences at the middle of each step, which is right to second order."""
        a = (np.concatenate([bend[:1], bend]) + np.concatenate([bend, bend[-1:]])) / 2
        return (z[1:] + z[:-1]) / 2, slope, a, slope[0] - h / 2 * bend[0]


@INTEGRATORS.add
class Lagged(Integrator):
    """Algorithms 1 and 2 as printed: z'' comes from the state one step earlier.

        z''_k = u_k - K z_{k-1} - D z'_{k-1},  z''_0 = 0,  then as explicit

    With critical damping it diverges from alpha = 0.91 steps on.
    """

    name = "lagged"
    first_input = 1

    def system(self, K: float, D: float, h: float) -> System:
        """Return how z'' drives the state: the rest comes from a step earlier."""
        return ((1, h), (0, 1)), (0, h)

    def recursion(self, K: float, D: float, h: float) -> tuple[tuple[float, ...], Row, float]:
        """Return the recursion, which goes back three steps."""
        return (-2.0, 1 + h * D, h * h * K - h * D), (0.0, h * h), h

    def step(self, K: float, D: float, h: float, u: Array, states: Array) -> Array:
        """Take one step; the first has no input."""
        z, v = states[0]
        return super().step(K, D, h, np.where(np.isnan(z), 0.0, u - K * z - D * v), states)

    def derivatives(self, z: Array, slope: Array, bend: Array, h: float) -> Kinematics:
        """Take differences forwards, of the state one step earlier."""
        before, v = np.concatenate([z[:1], z[:-2]]), np.concatenate([slope[:1], slope[:-1]])
        return before, v, np.concatenate([bend, bend[-1:]]), slope[0]


@dataclass(frozen=True)
class Spring:
    """The left side of the equation over the steps of one movement.

    Args:
        alpha: D over one movement.
        steps: How many steps a movement has: M.
        integrator: How it is stepped through time.
        damping: 1 for critical, less for a spring that swings.
    """

    alpha: float
    steps: int
    integrator: Integrator
    damping: float = 1.0

    @property
    def K(self) -> float:  # noqa: N802 (the paper's name)
        """Stiffness for one movement: alpha beta; beta = alpha/4 where damping is critical."""
        return (self.alpha / (2 * self.damping)) ** 2

    def follow(self, u: Array, start_velocity: Array | float = 0.0) -> Array:
        """Draw the path from z = 0 under the input u (M, D), shape (M + 1, D).

        Velocities (per movement) beyond those of the D coordinates start paths of their own, which
        have no input: they are the columns after D.
        """
        recursion, (now, before), kick = self.integrator.recursion(
            self.K, self.alpha, 1 / self.steps
        )
        columns = max(u.shape[1], np.size(start_velocity))
        # Each coordinate in one piece of memory: the filter runs along it.
        drive = np.zeros((columns, self.steps + 1)).T
        forced = drive[:, : u.shape[1]]
        first = self.integrator.first_input
        forced[2 + first :] = before * u[first:-1]
        if now:
            forced[1:] += now * u
        drive[1] += kick * start_velocity
        return filter_recursively(recursion, drive.T).T

    def needed(self, z: Array, derivatives: str = "inverse") -> tuple[Array, Array]:
        """Return the input by which `follow` draws z (M + 1, D), and its start velocity.

        The input has shape (M, D), or (M + 1, D) where it is known at the last sample, too.
        """
        return DERIVATIVES[derivatives](self, z)

    def kick(self) -> Array:
        """Draw the path (M + 1, 1) of a pen that starts with velocity 1 and has no input."""
        return self.follow(np.zeros((self.steps, 0)), np.ones(1))


def inverse_derivatives(spring: Spring, z: Array) -> tuple[Array, Array]:
    """Read the discrete scheme backwards: the input makes good what the integrator gets wrong."""
    h = 1 / spring.steps
    slope = (z[1:] - z[:-1]) / h
    bend = (slope[1:] - slope[:-1]) / h
    seen, v, a, start_velocity = spring.integrator.derivatives(z, slope, bend, h)
    return a + spring.alpha * v + spring.K * seen, start_velocity


def central_derivatives(spring: Spring, z: Array) -> tuple[Array, Array]:
    """Take differences on both sides of a sample, twice, as one does on paper."""
    h = 1 / spring.steps
    v = np.gradient(z, h, axis=0)
    u = np.gradient(v, h, axis=0) + spring.alpha * v + spring.K * z
    return (u[1:] + u[:-1]) / 2 if spring.integrator.middle else u, v[0]


DERIVATIVES: dict[str, Callable[[Spring, Array], tuple[Array, Array]]] = {
    "inverse": inverse_derivatives,
    "central": central_derivatives,
}
