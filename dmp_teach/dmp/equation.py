"""The differential equation of a primitive, laid out over the steps of one movement."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dmp_teach.dmp.fit import forcing
from dmp_teach.dmp.integrators import Spring
from dmp_teach.dmp.kernels import Cells, Kernels, Overlap
from dmp_teach.dmp.phase import Phase
from dmp_teach.dmp.settings import Settings
from dmp_teach.trajectory import Array


@dataclass(frozen=True, eq=False)
class Equation:
    """What pushes the spring, where z = y - y0 is the path from its start and g - y0 the way to its goal.

        original  z'' = K (g - y0) + (g - y0) f              - K z - D z'   (the paper's equation 1)
        star      z'' = K (g - y0) - K (g - y0) s + K f      - K z - D z'   (Pastor 2009; the paper's DMP*)
                  + (change of g - y0) (-D s' - s'')     where the goal is fed forward: the path changes by 1 - s
        similarity  as star, with all of it turned and scaled to another way    (Ginesi 2019, DMP++)

    Time is counted in movements (t/T), so that a duration changes nothing here; K and D are those of the spring.

    Args:
        settings: With numbers for `n_kernels` and `alpha`.
        steps: How many steps a movement has: M.
    """

    settings: Settings
    steps: int

    @cached_property
    def spring(self) -> Spring:
        """The left side: K and D."""
        return Spring(
            self.settings.alpha, self.steps, self.settings.integrator, self.settings.damping
        )

    @cached_property
    def s(self) -> Array:
        """The phases at which the spring takes its steps, shape (M, 1)."""
        return self._bumps.phase.at(self._left)[:, None]

    @cached_property
    def kernels(self) -> Cells | Overlap:
        """The kernels, laid over these steps."""
        return self._bumps.over(self._left)

    @cached_property
    def _left(self) -> Array:
        """The part of the movement that is still to come at each step, shape (M,)."""
        return (np.arange(self.steps, 0, -1) - self.spring.middle) / self.steps

    @cached_property
    def _bumps(self) -> Kernels:
        return kernels_of(self.settings)

    def needed_forcing(self, push: Array, way: Array) -> Array:
        """The f (M, D) that gives this `push` (M, D) on this `way` (D,): the equation, solved for f."""
        K, times = self.spring.K, self.settings.divide
        if self.settings.transform == "original":
            return push / way - K if times else push - K * way
        return push / K - self._pull(way) if times else push - K * self._pull(way)

    def push(self, weights: Array, biases: Array | None, way: Array) -> Array:
        """What pushes the spring at each step, shape (M, D); the start is where z = 0."""
        K, f = self.spring.K, forcing(self.kernels, self.s, weights, biases)
        return way * (K + f) if self.settings.transform == "original" else K * (self._pull(way) + f)

    def _pull(self, way: Array) -> Array:
        """The way, as far as the phase lets it pull: way * (1 - s), shape (M, D), each coordinate in one piece."""
        return np.multiply.outer(way, 1 - self.s[:, 0]).T

    def draw(self, weights: Array, biases: Array | None, way: Array, velocity: Array) -> Array:
        """The path z (M + 1, D) to the demonstrated goal; `velocity` (D,) at the start, per movement."""
        return self.spring.follow(self.push(weights, biases, way), velocity)

    def longer(self) -> Array:
        """How the push of DMP* changes when its way becomes 1 longer, shape (M, 1)."""
        K, D = self.spring.K, self.spring.alpha
        phase = self._bumps.phase
        ahead = D * phase.speed(self.s) - phase.bend(self.s) if self.settings.feed_goal else 0.0
        return K * (1 - self.s) + ahead

    def answer(self) -> Array:
        """How the path of DMP* changes when its way becomes 1 longer, shape (M + 1, 1)."""
        return self.spring.follow(self.longer())


def turned_and_scaled(way: Array, taught: Array) -> Array:
    """The matrix (D, D) that carries the `taught` way (D,) onto `way` (D,): the smallest rotation, times a scale.

        R = I + X + X^2 / (1 + a.b),   X = b a' - a b'      (Rodrigues, in any number of dimensions)

    with unit vectors a (taught) and b. In one dimension there is no rotation: it is the signed quotient, so that the
    letter turns over when its goal crosses its start, as in the original form. A way turned right round has no smallest
    rotation: it is turned in the plane of the first two coordinates, where the page is.
    """
    a, b = taught / np.linalg.norm(taught), way / np.linalg.norm(way)
    scale = np.linalg.norm(way) / np.linalg.norm(taught)
    if len(a) == 1:
        return np.array([[scale * a[0] * b[0]]])
    across = np.outer(b, a) - np.outer(a, b)
    if 1 + a @ b > 1e-9:
        return scale * (np.eye(len(a)) + across + across @ across / (1 + a @ b))
    beside = np.zeros(len(a))
    beside[:2] = (-a[1], a[0]) if np.hypot(a[0], a[1]) > 1e-6 else (1.0, 0.0)
    beside -= a * (a @ beside)
    beside /= np.linalg.norm(beside)
    return scale * (np.eye(len(a)) - 2 * np.outer(a, a) - 2 * np.outer(beside, beside))


def kernels_of(settings: Settings) -> Kernels:
    """The kernels that these settings describe."""
    phase = Phase(settings.phase, settings.phase_decay, settings.phase_middle)
    shape, stand, sides = settings.kernel, settings.kernel_centers, settings.kernel_sides
    return Kernels(
        settings.n_kernels, settings.kernel_width, settings.kernel_sigma, phase, shape, stand, sides
    )
