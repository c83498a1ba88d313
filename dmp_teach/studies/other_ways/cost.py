"""Inverse optimal control: a cost is learned, and the letter is what costs least."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import ClassVar, Self

import numpy as np
import scipy

from dmp_teach.studies.other_ways.way import CUTS, Aligned, GaussianWay, align_takes
from dmp_teach.trajectory import Array, Trajectory

PLACE_NUMBER = 20
SAMPLES_OF_PLACES = np.linspace(0, CUTS, PLACE_NUMBER).round().astype(int)
# No take is the same again within less [sizes].
LEAST_SPREAD = 1e-3
# Logarithms of the weight of the jerk, and of those of the places [1/sizes^2].
JERK_RANGE, PLACE_RANGE = (-12.0, 12.0), (0.0, 16.0)


@dataclass(frozen=True, eq=False, repr=False)
class LearnedCost(GaussianWay):
    """A quadratic cost of which the letter is the minimum.

        J(y) = w_0 integral of jerk^2 + sum w_k |y(t_k) - p_k|^2

    A person who writes so as to pay little writes y with a probability of exp(-J / 2); the weights
    are those that make the demonstrations likeliest. J is quadratic, so that the approximation of
    Levine and Koltun (2012) to that probability is exact. The places p_k are where the
    demonstrations are on average: where they agree, w_k is large. Yin (2016) learns such costs for
    handwriting, many for each letter; here it is one.

    Args:
        aligned: The demonstrations.
        places: p_k, shape (K, D) [sizes].
        weights: w_0 to w_K, shape (K + 1,).
    """

    aligned: Aligned
    places: Array
    weights: Array
    name: ClassVar[str] = "cost"

    @classmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Find the weights by maximum likelihood."""
        aligned = align_takes(demonstrations)
        apart = (aligned.paths - aligned.mean).transpose(0, 2, 1).reshape(-1, CUTS + 1)
        freedoms = max(len(apart) - aligned.mean.shape[1], 1)
        # The mean square jerk, and the mean square distance from each place, of the takes.
        jerk = np.sum((apart @ _third_difference().T) ** 2) / CUTS / freedoms
        jerk += LEAST_SPREAD**2 * _jerk_bands()[0].sum()
        spread = (apart[:, SAMPLES_OF_PLACES] ** 2).sum(axis=0) / freedoms + LEAST_SPREAD**2

        def misfit(logarithms: Array) -> tuple[float, Array]:
            """Return -2 log likelihood of the weights for one coordinate, and its gradient."""
            w = np.exp(logarithms)
            root = scipy.linalg.cholesky_banded(_bands(w), lower=True)
            at_places = scipy.linalg.cho_solve_banded(
                (root, True), np.eye(CUTS + 1)[:, SAMPLES_OF_PLACES]
            )
            variance = at_places[SAMPLES_OF_PLACES, np.arange(PLACE_NUMBER)]
            expected_jerk = (CUTS + 1 - w[1:] @ variance) / w[0]
            value = w[0] * jerk + w[1:] @ spread - 2 * np.log(root[0]).sum()
            return value, w * np.array([jerk - expected_jerk, *(spread - variance)])

        begin = np.array([0.0] + [8.0] * PLACE_NUMBER)
        bounds = [JERK_RANGE] + [PLACE_RANGE] * PLACE_NUMBER
        # It calls no LAPACK, whose threads cost a hundred times what they give on 21 numbers.
        how = {"method": "TNC", "options": {"maxfun": 100}}
        found = scipy.optimize.minimize(misfit, begin, jac=True, bounds=bounds, **how)
        return cls(aligned, aligned.mean[SAMPLES_OF_PLACES], np.exp(found.x))

    @cached_property
    def mean_path(self) -> Array:
        """The minimum of the cost."""
        pull = np.zeros((CUTS + 1, self.places.shape[1]))
        pull[SAMPLES_OF_PLACES] = self.weights[1:, None] * self.places
        return scipy.linalg.solveh_banded(_bands(self.weights), pull, lower=True)

    @cached_property
    def end_gain(self) -> Array:
        """The minimum where the end is given: a column of the inverse of the cost's matrix."""
        response = scipy.linalg.solveh_banded(
            _bands(self.weights), np.eye(CUTS + 1)[-1], lower=True
        )
        return np.multiply.outer(response / response[-1], np.eye(self.places.shape[1]))

    @property
    def numbers_stored(self) -> int:
        """The weights, the places, and the duration."""
        return self.weights.size + self.places.size + 1


def _third_difference() -> Array:
    """Return the matrix that takes the jerk of a path, in tenths, shape (CUTS - 2, CUTS + 1)."""
    return np.diff(np.eye(CUTS + 1), 3, axis=0) * (CUTS / 10) ** 3


@cache
def _jerk_bands() -> Array:
    """Return the lower bands of the matrix of the integral of jerk^2, shape (4, CUTS + 1)."""
    third = _third_difference()
    rows = [(third[:, k:] * third[:, : CUTS + 1 - k]).sum(axis=0) / CUTS for k in range(4)]
    return np.array([np.pad(row, (0, k)) for k, row in enumerate(rows)])


def _bands(weights: Array) -> Array:
    """Return the lower bands of the matrix of the cost for one coordinate."""
    bands = weights[0] * _jerk_bands()
    bands[0, SAMPLES_OF_PLACES] += weights[1:]
    return bands
