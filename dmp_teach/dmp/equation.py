"""The differential equation of a primitive, laid out over the steps of one movement."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np

from dmp_teach.dmp.fit import forcing
from dmp_teach.dmp.integrators import INTEGRATORS, Spring
from dmp_teach.dmp.kernels import KERNELS, PLACEMENTS, Cells, Kernels, Overlap
from dmp_teach.dmp.phases import PHASES
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.transformations import TRANSFORMATIONS, Transformation
from dmp_teach.trajectory import Array


@dataclass(frozen=True, eq=False)
class Equation:
    """A spring under the input that its transformation makes of the forcing term.

    Args:
        settings: With numbers for `n_kernels` and `alpha`.
        steps: How many steps a movement has: M.
        samples: How many samples of it are looked at; M, all but the last, unless given.
    """

    settings: Settings
    steps: int
    samples: int | None = None

    @cached_property
    def spring(self) -> Spring:
        """The left side: K and D."""
        settings = self.settings
        integrator = INTEGRATORS[settings.integrator].of(settings)
        return Spring(cast(float, settings.alpha), self.steps, integrator, settings.damping)

    @cached_property
    def transformation(self) -> Transformation:
        """How the forcing term enters, and the path follows its goal."""
        return TRANSFORMATIONS[self.settings.transform].of(self.settings)

    @cached_property
    def bank(self) -> Kernels:
        """The kernels over the phase."""
        return kernels_of(self.settings)

    @cached_property
    def s(self) -> Array:
        """The phases at which the spring takes its steps, or of the samples, shape (M, 1)."""
        return self.bank.phase.at(self._left)[:, None]

    @cached_property
    def kernels(self) -> Cells | Overlap:
        """The kernels, laid over these steps."""
        return self.bank.over(self._left)

    @cached_property
    def _left(self) -> Array:
        """The part of the movement that is still to come at each step, shape (M,)."""
        steps = self.steps + self.bank.phase.steps_left
        over = np.arange(self.samples or self.steps) + self.spring.integrator.middle
        # The program's own order, which decides what a sample on the end of a kernel belongs to.
        return 1 - over / steps if steps > self.steps else (steps - over) / steps

    def needed_forcing(self, u: Array, offset: Array) -> Array:
        """Return the f (M, D) that gives the input u (M, D) for a goal offset (D,)."""
        return self.transformation.needed_forcing(
            u, offset, self.spring.K, self.s, self.settings.divide
        )

    def input(self, weights: Array, biases: Array | None, offset: Array) -> Array:
        """Return the input of the spring at each step, shape (M, D)."""
        f = forcing(self.kernels, self.s, weights, biases)
        return self.transformation.input(f, offset, self.spring.K, self.s)

    def input_gain(self) -> Array:
        """Return how the input of DMP* grows with its goal offset, shape (M, 1).

        A goal that is fed forward moves the path by 1 - s: the spring is given what that needs.
        """
        phase, gain = self.bank.phase, self.spring.K * (1 - self.s)
        if self.settings.feed_goal:
            gain += self.spring.alpha * phase.speed(self.s) - phase.bend(self.s)
        return gain

    def goal_gain(self) -> Array:
        """Return how the path of DMP* grows with its goal offset, shape (M + 1, 1)."""
        return self.spring.follow(self.input_gain())


def kernels_of(settings: Settings) -> Kernels:
    """Return the kernels that these settings describe."""
    return Kernels(
        cast(int, settings.n_kernels),
        settings.kernel_width,
        KERNELS[settings.kernel].of(settings),
        PHASES[settings.phase].of(settings),
        PLACEMENTS[settings.kernel_centers].of(settings),
        settings.kernel_sides,
        settings.kernel_floor,
    )
