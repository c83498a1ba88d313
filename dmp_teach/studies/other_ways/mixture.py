"""A mixture of Gaussians over where the pen is and what pulls it there: a field without a clock."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp import check_point
from dmp_teach.studies.other_ways.way import (
    CUTS,
    Aligned,
    Way,
    align_takes,
    import_library,
    one_thread,
)
from dmp_teach.trajectory import Array, Trajectory

COMPONENT_NUMBER = 10
# The spring's frequency, in radians in a tenth of the movement; it is critically damped.
STIFFNESS = 2.0
# From here on the mixture is less and less sure of what it never saw [squared deviations].
FAMILIAR, UNFAMILIAR = 20.0, 40.0
SMOOTHER = 4
# It waits so long for the pen to arrive [durations], so near to the goal [sizes].
LONGEST, ARRIVED = 1.5, 0.005


@dataclass(frozen=True, eq=False, repr=False)
class Mixture(Way):
    """A time-invariant system of mixed Gaussians, seen from its goal (Khansari and Billard 2011).

        y'' = omega^2 (c(y, y') - y) - 2 omega y',    c = sum h_k (m_k + R_k ((y, y') - mu_k))

    c is the regression of the point that pulls the pen on where the pen is and how fast; h_k is how
    likely component k is there. Khansari and Billard make every component stable by constraints on
    its matrix, in a search of its own; here the pull fades to the goal itself where the mixture has
    seen nothing. Either arrives from anywhere, and either knows the letter only near where it was
    shown.

    Args:
        aligned: The demonstrations.
        shares: Of the components, shape (K,).
        means: Of place, velocity and pull seen from the goal, shape (K, 3 D) [sizes a tenth].
        covariances: Shape (K, 3 D, 3 D).
    """

    aligned: Aligned
    shares: Array
    means: Array
    covariances: Array
    name: ClassVar[str] = "mixture"
    library: ClassVar[str] = "sklearn"

    @classmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Learn the mixture with scikit-learn, from equal pieces of the demonstrations on."""
        aligned = align_takes(demonstrations)
        library = import_library("sklearn.mixture", "scikit-learn")
        places = aligned.paths - aligned.paths[:, -1:]
        speed, push = aligned.derivative(1), aligned.derivative(2)
        pull = places + push / STIFFNESS**2 + 2 * speed / STIFFNESS
        seen = np.concatenate([places, speed, pull], axis=2)
        # The last component is the pen at rest on its goal.
        rest = np.zeros((len(seen), CUTS // COMPONENT_NUMBER, seen.shape[2]))
        pieces = [*np.array_split(seen, COMPONENT_NUMBER - 1, axis=1), rest]
        rows = [piece.reshape(-1, seen.shape[2]) for piece in pieces]
        spread = [np.cov(each.T) + 1e-3 * np.eye(seen.shape[2]) for each in rows]
        model = library.GaussianMixture(
            COMPONENT_NUMBER,
            # All three, or k-means would look for them first.
            weights_init=np.full(COMPONENT_NUMBER, 1 / COMPONENT_NUMBER),
            means_init=[each.mean(axis=0) for each in rows],
            precisions_init=np.linalg.inv(spread),
            reg_covar=1e-4,
            random_state=0,
        )
        # It warns where 100 steps left a little to gain.
        with one_thread(), warnings.catch_warnings(action="ignore"):
            model.fit(np.concatenate(rows))
        return cls(aligned, model.weights_, model.means_, model.covariances_)

    def pull(self, place: Array, speed: Array) -> Array:
        """Return the point that pulls the pen, seen from the goal, shape (D,) [sizes]."""
        inverses, sizes, slopes = self._regression
        known = inverses.shape[1]
        apart = np.concatenate([place, speed]) - self.means[:, :known]
        distance = np.einsum("ki,kij,kj->k", apart, inverses, apart)
        likely = np.exp(sizes - 0.5 * (distance - distance.min()))
        guesses = self.means[:, known:] + np.einsum("kij,kj->ki", slopes, apart)
        sure = np.exp(min(0.0, FAMILIAR - distance.min()) / UNFAMILIAR)
        return sure * (likely @ guesses) / likely.sum()

    def write(self, goal: ArrayLike | None = None) -> Trajectory:
        """Let the pen be pulled until it has arrived."""
        at = self.aligned
        if goal is None:
            end = at.mean[-1]
        else:
            end = (check_point("goal", goal, len(at.start)) - at.start) / at.size
        place, speed = -end, at.derivative(1)[:, 0].mean(axis=0)
        step = 10 / CUTS / SMOOTHER
        path = [place]
        for number in range(round(LONGEST * CUTS) * SMOOTHER):
            push = STIFFNESS**2 * (self.pull(place, speed) - place) - 2 * STIFFNESS * speed
            speed = speed + step * push
            place = place + step * speed
            if (number + 1) % SMOOTHER == 0:
                path.append(place)
                if len(path) > CUTS and np.linalg.norm(place) < ARRIVED:
                    break
        t = at.duration * np.arange(len(path)) / CUTS
        return Trajectory(t, at.start + at.size * (end + np.array(path)))

    @property
    def duration(self) -> float:
        """The mean of the demonstrations' [s]."""
        return self.aligned.duration

    @property
    def numbers_stored(self) -> int:
        """Shares, means, one half of the covariances, how it begins, and the duration."""
        count, numbers = self.means.shape
        return count * (1 + numbers + numbers * (numbers + 1) // 2) + 2 * numbers // 3 + 1

    @cached_property
    def _regression(self) -> tuple[Array, Array, Array]:
        """Of each component: the inverse covariance of what is known, log size, and slope."""
        known = 2 * self.means.shape[1] // 3
        inverses = np.asarray(np.linalg.inv(self.covariances[:, :known, :known]), dtype=float)
        sizes = np.log(self.shares) + 0.5 * np.linalg.slogdet(inverses)[1]
        return inverses, sizes, self.covariances[:, known:, :known] @ inverses
