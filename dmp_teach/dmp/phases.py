"""Phases: the canonical system, a phase s that runs from 1 towards 0 and replaces time."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.trajectory import Array

# A phase that no exponential comes to, but whose logarithm is a number.
_TINY_PHASE = 1e-300


class Phase(NamedChoice):
    """How the phase runs down; t/T is the part of the movement that is over.

    Attributes:
        has_plateau: Whether it stays so flat for so long that kernels are round in time instead.
        steps_left: How many steps of the movement are still to come where it ends.
    """

    setting = "phase"
    has_plateau: ClassVar[bool] = False
    steps_left: ClassVar[int] = 0

    @abstractmethod
    def at(self, left: ArrayLike) -> Array:
        """Return the phase s where the part `left` = 1 - t/T of the movement is still to come."""

    @abstractmethod
    def left(self, s: ArrayLike) -> Array:
        """Return the part of the movement that is still to come at phase s, the inverse of `at`."""

    @abstractmethod
    def speed(self, s: ArrayLike) -> Array:
        """Return how fast the phase falls, -T ds/dt."""

    @abstractmethod
    def bend(self, s: ArrayLike) -> Array:
        """Return how fast that fall becomes slower, T^2 d^2s/dt^2."""


PHASES: Registry[type[Phase]] = Registry()


@PHASES.add
class Linear(Phase):
    """s = 1 - t/T (Wu 2018; what the paper's equations 7 and 9 mean by a linear decay)."""

    name = "linear"

    def at(self, left: ArrayLike) -> Array:
        """Return `left` itself."""
        return np.asarray(left, dtype=float)

    def left(self, s: ArrayLike) -> Array:
        """Return s itself."""
        return np.asarray(s, dtype=float)

    def speed(self, s: ArrayLike) -> Array:
        """Return 1."""
        return np.ones(np.shape(s))

    def bend(self, s: ArrayLike) -> Array:
        """Return 0."""
        return np.zeros(np.shape(s))


@PHASES.add
@dataclass(frozen=True)
class Exponential(Phase):
    """s = exp(-decay t/T) (the paper's equation 3; never quite 0).

    Args:
        decay: alpha_x.
    """

    name = "exponential"
    decay: float = 4.6

    def at(self, left: ArrayLike) -> Array:
        """Return exp(-decay (1 - left))."""
        return np.exp(self.decay * (np.asarray(left, dtype=float) - 1))

    def left(self, s: ArrayLike) -> Array:
        """Return 1 + log(s) / decay."""
        return 1 + np.log(np.maximum(np.asarray(s, dtype=float), _TINY_PHASE)) / self.decay

    def speed(self, s: ArrayLike) -> Array:
        """Return decay s."""
        return self.decay * np.asarray(s, dtype=float)

    def bend(self, s: ArrayLike) -> Array:
        """Return decay^2 s."""
        return self.decay * self.speed(s)


@PHASES.add
@dataclass(frozen=True)
class Sigmoid(Phase):
    """s = (1 + exp(-k m)) / (1 + exp(k (t/T - m))), k = decay / (1 - m) (Kulvicius 2012).

    It stays near 1 until its middle m. Theirs is half over at T, ours earlier, so that it is down
    to about exp(-decay) at T and the goal is reached.

    Args:
        decay: How far it falls.
        middle: m.
    """

    name = "sigmoid"
    has_plateau = True
    decay: float = 4.6
    middle: float = 0.75

    def at(self, left: ArrayLike) -> Array:
        """Return the sigmoid at t/T = 1 - left."""
        left = np.asarray(left, dtype=float)
        return self._top / (1 + np.exp(self._steepness * (1 - left - self.middle)))

    def left(self, s: ArrayLike) -> Array:
        """Return the inverse of the sigmoid."""
        tail = self._top / np.asarray(s, dtype=float) - 1
        tail = np.maximum(tail, np.exp(-self._steepness * self.middle))
        return 1 - self.middle - np.log(tail) / self._steepness

    def speed(self, s: ArrayLike) -> Array:
        """Return k s (1 - s / s_0), where s_0 is the phase long before the movement."""
        s = np.asarray(s, dtype=float)
        return self._steepness * s * (1 - s / self._top)

    def bend(self, s: ArrayLike) -> Array:
        """Return k (1 - 2 s / s_0) times the speed."""
        s = np.asarray(s, dtype=float)
        return self._steepness * (1 - 2 * s / self._top) * self.speed(s)

    @property
    def _steepness(self) -> float:
        """Return k."""
        return self.decay / (1 - self.middle)

    @property
    def _top(self) -> float:
        """Return s_0, where the phase would begin to be 1 at the start of the movement."""
        return 1 + math.exp(-self._steepness * self.middle)


@PHASES.add
class Counted(Linear):
    """s = 1 - i/n at sample i of n, so that it ends at 1/n (the authors' program)."""

    name = "counted"
    steps_left = 1
