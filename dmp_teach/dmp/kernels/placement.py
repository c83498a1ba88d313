"""Where kernels stand: at equal times, or at equal phases in one of three readings of the paper."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Placement(NamedChoice):
    """Kernels in the middles of N equal parts.

    Attributes:
        in_time: Whether the parts are parts of the time; else of the phase.
    """

    setting = "kernel_centers"
    in_time = False

    def places(self, number: int) -> Array:
        """Return m_i, the middles of the kernels in 1/N, shape (N,)."""
        return np.arange(number, dtype=float) + 0.5


PLACEMENTS: Registry[type[Placement]] = Registry()


@PLACEMENTS.add
class AtMiddles(Placement):
    """c_i is the phase at (i - 1/2)/N of the movement to come: at equal times."""

    name = "middles"
    in_time = True


@PLACEMENTS.add
class AtPhases(Placement):
    """c_i = (i - 1/2)/N."""

    name = "phases"


@PLACEMENTS.add
class AtEnds(Placement):
    """c_i = (i - 1)/(N - 1)."""

    name = "ends"

    def places(self, number: int) -> Array:
        """Return m_i, from 0 to N."""
        return np.arange(number) * number / (number - 1) if number > 1 else super().places(number)


@PLACEMENTS.add
class OnGrid(Placement):
    """c_i = i/N, as in the authors' program."""

    name = "grid"

    def places(self, number: int) -> Array:
        """Return m_i, from 1 to N."""
        return np.arange(number, dtype=float) + 1
