"""The differential equation of a primitive, laid out over the steps of one movement."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dmp_teach.dmp.fit import forcing
from dmp_teach.dmp.kernels import Cells, Kernels, Overlap
from dmp_teach.dmp.phase import Phase
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.spring import Spring
from dmp_teach.trajectory import Array


@dataclass(frozen=True, eq=False)
class Equation:
    """What pushes the spring, where z = y - y0 is the path from its start and g - y0 the way to its goal.

        original  z'' = K (g - y0) + (g - y0) f              - K z - D z'   (the paper's equation 1)
        star      z'' = K (g - y0) - K (g - y0) s + K f      - K z - D z'   (Pastor 2009; the paper's DMP*)
                  + D (change of g - y0) (-ds/dt)                           where the goal is fed forward

    Time is counted in movements (t/T), so that a duration changes nothing here; K = alpha^2/4, D = alpha.

    Args:
        settings: With numbers for `n_kernels` and `alpha`.
        steps: How many steps a movement has: M.
    """

    settings: Settings
    steps: int

    @cached_property
    def spring(self) -> Spring:
        """The left side: K and D."""
        return Spring(self.settings.alpha, self.steps, self.settings.integrator)

    @cached_property
    def s(self) -> Array:
        """The phases at which the spring takes its steps, shape (M, 1)."""
        return self._phase.at(self._left)[:, None]

    @cached_property
    def kernels(self) -> Cells | Overlap:
        """The kernels, laid over these steps."""
        return kernels_of(self.settings).over(self._left)

    @cached_property
    def _left(self) -> Array:
        """The part of the movement that is still to come at each step, shape (M,)."""
        return np.arange(self.steps, 0, -1) / self.steps

    @property
    def _phase(self) -> Phase:
        return kernels_of(self.settings).phase

    def needed_forcing(self, push: Array, way: Array) -> Array:
        """The f (M, D) that gives this `push` (M, D) on this `way` (D,): the equation, solved for f."""
        K = self.spring.K
        return push / way - K if self.settings.transform == "original" else push / K - way * (1 - self.s)

    def draw(self, weights: Array, biases: Array | None, way: Array, velocity: Array) -> Array:
        """The path z (M + 1, D) to the demonstrated goal; `velocity` (D,) at the start, per movement."""
        K, f = self.spring.K, forcing(self.kernels, self.s, weights, biases)
        push = way * (K + f) if self.settings.transform == "original" else K * (way * (1 - self.s) + f)
        return self.spring.follow(push, velocity)

    def answer(self) -> Array:
        """How the path of DMP* changes when its way becomes 1 longer, shape (M + 1, 1)."""
        K, D = self.spring.K, self.spring.alpha
        ahead = D * self._phase.speed(self.s) if self.settings.feed_goal else 0.0
        return self.spring.follow(K * (1 - self.s) + ahead)


def kernels_of(settings: Settings) -> Kernels:
    """The kernels that these settings describe."""
    phase = Phase(settings.phase, settings.phase_decay)
    return Kernels(settings.n_kernels, settings.kernel_width, settings.kernel_sigma, phase)
