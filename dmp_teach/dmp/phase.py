"""The canonical system: a phase s that runs from 1 towards 0 and replaces time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Phase:
    """How the phase runs down; t/T is the part of the movement that is over.

        linear       s = 1 - t/T              (Wu 2018; the paper's section on kernel shape)
        exponential  s = exp(-decay t/T)      (the paper's equation 3; never quite 0)

    Args:
        kind: "linear" or "exponential".
        decay: alpha_x of the exponential phase.
    """

    kind: str = "linear"
    decay: float = 4.6

    def at(self, left: ArrayLike) -> Array:
        """The phase s where the part `left` = 1 - t/T of the movement is still to come."""
        left = np.asarray(left, dtype=float)
        return left if self.kind == "linear" else np.exp(self.decay * (left - 1))

    def left(self, s: ArrayLike) -> Array:
        """The part of the movement that is still to come at phase s: the inverse of `at`."""
        s = np.asarray(s, dtype=float)
        return s if self.kind == "linear" else 1 + np.log(s) / self.decay

    def speed(self, s: ArrayLike) -> Array:
        """How fast the phase falls, -T ds/dt."""
        s = np.asarray(s, dtype=float)
        return np.ones_like(s) if self.kind == "linear" else self.decay * s
