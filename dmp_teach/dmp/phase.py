"""The canonical system: a phase s that runs from 1 towards 0 and replaces time."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.trajectory import Array

TINY = 1e-300  # a phase that no exponential comes to, but whose logarithm is a number


@dataclass(frozen=True)
class Phase:
    """How the phase runs down; t/T is the part of the movement that is over.

        linear       s = 1 - t/T              (Wu 2018; the paper's section on kernel shape)
        exponential  s = exp(-decay t/T)      (the paper's equation 3; never quite 0)
        sigmoid      s = (1 + exp(-k m)) / (1 + exp(k (t/T - m))),   k = decay / (1 - m)

    The sigmoid one (Kulvicius 2012) stays near 1 until its middle m; theirs is half over at T, ours earlier, so that
    it is down to about exp(-decay) at T and the goal is reached.

    Args:
        kind: "linear", "exponential" or "sigmoid".
        decay: alpha_x of the exponential phase; how far the sigmoid one falls.
        middle: m of the sigmoid phase.
    """

    kind: str = "linear"
    decay: float = 4.6
    middle: float = 0.75

    def at(self, left: ArrayLike) -> Array:
        """The phase s where the part `left` = 1 - t/T of the movement is still to come."""
        left = np.asarray(left, dtype=float)
        if self.kind == "linear":
            return left
        if self.kind == "exponential":
            return np.exp(self.decay * (left - 1))
        return self._top / (1 + np.exp(self._steepness * (1 - left - self.middle)))

    def left(self, s: ArrayLike) -> Array:
        """The part of the movement that is still to come at phase s: the inverse of `at`."""
        s = np.asarray(s, dtype=float)
        if self.kind == "linear":
            return s
        if self.kind == "exponential":
            return 1 + np.log(np.maximum(s, TINY)) / self.decay
        tail = np.maximum(self._top / s - 1, np.exp(-self._steepness * self.middle))
        return 1 - self.middle - np.log(tail) / self._steepness

    def speed(self, s: ArrayLike) -> Array:
        """How fast the phase falls, -T ds/dt."""
        s = np.asarray(s, dtype=float)
        if self.kind == "linear":
            return np.ones_like(s)
        return (
            self.decay * s
            if self.kind == "exponential"
            else self._steepness * s * (1 - s / self._top)
        )

    def bend(self, s: ArrayLike) -> Array:
        """How fast that fall becomes slower, T^2 d^2s/dt^2."""
        s = np.asarray(s, dtype=float)
        if self.kind == "linear":
            return np.zeros_like(s)
        rate = (
            self.decay if self.kind == "exponential" else self._steepness * (1 - 2 * s / self._top)
        )
        return rate * self.speed(s)

    @property
    def _steepness(self) -> float:
        """The k of the sigmoid phase."""
        return self.decay / (1 - self.middle)

    @property
    def _top(self) -> float:
        """Where the sigmoid phase would begin, long before the movement, if it is 1 at its start."""
        return 1 + math.exp(-self._steepness * self.middle)
