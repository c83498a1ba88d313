"""A probabilistic movement primitive: the mean of several takes, and how they vary together."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Self

import numpy as np

from dmp_teach.studies.other_ways.way import CUTS, Aligned, GaussianWay, align_takes
from dmp_teach.trajectory import Array, Trajectory

BASIS_NUMBER = 20
# How exactly a path that is conditioned must begin and end [sizes].
END_DEVIATION = 1e-6


@dataclass(frozen=True, eq=False, repr=False)
class Probabilistic(GaussianWay):
    """A Gaussian over weights of bumps (Paraschos 2013, equations 1 to 5).

    Each demonstration is fitted by least squares; the weights of all have a mean and a covariance.
    One demonstration has no covariance, so that no goal can lead it; n have n - 1 ways to vary, and
    a start that stays while the goal moves needs 2 D.

    Args:
        aligned: The demonstrations.
        mean: Of the weights, one coordinate after the other, shape (D N,) [sizes].
        covariance: Of the weights, shape (D N, D N).
    """

    aligned: Aligned
    mean: Array
    covariance: Array
    name: ClassVar[str] = "spread (ProMP)"

    @classmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Fit the weights of every demonstration, and take their mean and covariance."""
        aligned = align_takes(demonstrations)
        fit = np.linalg.pinv(_bumps())
        weights = np.array([(fit @ path).T.ravel() for path in aligned.paths])
        apart = weights - weights.mean(axis=0)
        return cls(aligned, weights.mean(axis=0), apart.T @ apart / max(len(weights) - 1, 1))

    @cached_property
    def mean_path(self) -> Array:
        """The bumps, times their mean weights."""
        return _bumps() @ self.mean.reshape(-1, BASIS_NUMBER).T

    @cached_property
    def end_gain(self) -> Array:
        """Condition the weights on both ends of the path (Paraschos 2013, equations 5 and 6)."""
        count = len(self.mean) // BASIS_NUMBER
        ends = np.kron(np.eye(count), _bumps()[[0, -1]])
        noise = END_DEVIATION**2 * np.eye(2 * count)
        gain = self.covariance @ ends.T @ np.linalg.inv(ends @ self.covariance @ ends.T + noise)
        # The start stays; every second column is of the end.
        gain = gain[:, 1::2].reshape(count, BASIS_NUMBER, count)
        return np.einsum("tn,dne->tde", _bumps(), gain)

    @property
    def numbers_stored(self) -> int:
        """The mean, one half of the symmetric covariance, and the duration."""
        count = len(self.mean)
        return count + count * (count + 1) // 2 + 1


def _bumps() -> Array:
    """Return normalised Gaussian bumps, as wide as they are apart, shape (CUTS + 1, N)."""
    centres = np.linspace(-0.02, 1.02, BASIS_NUMBER)
    away = (np.linspace(0, 1, CUTS + 1)[:, None] - centres) / (centres[1] - centres[0])
    heights = np.exp(-0.5 * away**2)
    return heights / heights.sum(axis=1, keepdims=True)
