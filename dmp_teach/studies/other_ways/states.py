"""A hidden Markov model: a letter is a row of states that the pen goes through."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from logging import ERROR, getLogger
from typing import ClassVar, Self

import numpy as np
import scipy
from numpy.typing import NDArray

from dmp_teach.studies.other_ways.way import (
    CUTS,
    Aligned,
    GaussianWay,
    align_takes,
    import_library,
    one_thread,
)
from dmp_teach.trajectory import Array, Trajectory

STATE_NUMBER = 16
LEAST_VARIANCE = 1e-5


@dataclass(frozen=True, eq=False, repr=False)
class HiddenMarkov(GaussianWay):
    """A hidden Markov model whose states follow one another (after Williams 2006).

    A state is where the pen is, how fast it goes and how that changes, each with a mean and a
    variance, learned by Baum and Welch's method. Each state lasts as long as it did on average; the
    path is the likeliest through their means (Tokuda 2000). Williams's model is factorial, and has
    several modes for one letter; this one has a single row of states.

    Args:
        aligned: The demonstrations.
        means: Of place, velocity and acceleration, shape (K, 3, D) [sizes a tenth].
        variances: The same shape.
        lengths: How many samples each state lasts, shape (K,).
    """

    aligned: Aligned
    means: Array
    variances: Array
    lengths: Array
    name: ClassVar[str] = "states (hidden Markov)"
    library: ClassVar[str] = "hmmlearn"

    @classmethod
    def learn(cls, demonstrations: Iterable[Trajectory]) -> Self:
        """Learn the states with hmmlearn, from equal pieces of the demonstrations on."""
        aligned = align_takes(demonstrations)
        hmm = import_library("hmmlearn.hmm", "hmmlearn")
        seen = np.concatenate([aligned.derivative(order) for order in range(3)], axis=2)
        count, samples, numbers = seen.shape
        pieces = np.array_split(seen, STATE_NUMBER, axis=1)
        stay = 1 - STATE_NUMBER / samples
        passes = stay * np.eye(STATE_NUMBER) + (1 - stay) * np.eye(STATE_NUMBER, k=1)
        passes[-1, -1] = 1
        model = hmm.GaussianHMM(
            STATE_NUMBER, n_iter=15, init_params="", params="mct", covars_prior=LEAST_VARIANCE
        )
        model.startprob_, model.transmat_ = np.eye(STATE_NUMBER)[0], passes
        model.means_ = np.array([piece.mean(axis=(0, 1)) for piece in pieces])
        model.covars_ = np.array([piece.var(axis=(0, 1)) + LEAST_VARIANCE for piece in pieces])
        # It warns where the least variance outweighs the last gain.
        getLogger("hmmlearn").setLevel(ERROR)
        rows, lengths = seen.reshape(-1, numbers), [samples] * count
        with one_thread():
            model.fit(rows, lengths)
            stays = model.predict_proba(rows, lengths).sum(axis=0) / count
        variances = np.array([np.diag(each) for each in model.covars_])
        shape = (STATE_NUMBER, 3, numbers // 3)
        return cls(aligned, model.means_.reshape(shape), variances.reshape(shape), stays)

    @property
    def states(self) -> NDArray[np.int_]:
        """The number of the state at each sample, shape (CUTS + 1,)."""
        ends = np.cumsum(self.lengths).round()
        return np.searchsorted(ends[:-1], np.arange(CUTS + 1), side="right")

    @cached_property
    def mean_path(self) -> Array:
        """The path that is likeliest in place, velocity and acceleration together."""
        return np.column_stack([path for path, _ in self._axes])

    @cached_property
    def end_gain(self) -> Array:
        """The likeliest path to another end: a column of the paths' covariance."""
        gain = np.zeros((CUTS + 1, *2 * self.means.shape[2:]))
        for axis, (_path, response) in enumerate(self._axes):
            gain[:, axis, axis] = response / response[-1]
        return gain

    @cached_property
    def _axes(self) -> list[tuple[Array, Array]]:
        """The likeliest path of each coordinate, and how it answers to a pull at its end."""
        slope = scipy.sparse.csr_array(np.gradient(np.eye(CUTS + 1), 10 / CUTS, axis=0))
        operators = scipy.sparse.eye_array(CUTS + 1), slope, slope @ slope
        last = np.eye(CUTS + 1)[-1]
        found = []
        for axis in range(self.means.shape[2]):
            certain = 1 / self.variances[self.states, :, axis]
            wanted = certain * self.means[self.states, :, axis]
            pairs = zip(operators, certain.T, strict=True)
            matrix = sum(each.T @ scipy.sparse.diags_array(sure) @ each for each, sure in pairs)
            pull = sum(each.T @ want for each, want in zip(operators, wanted.T, strict=True))
            factors = scipy.sparse.linalg.splu(scipy.sparse.csc_array(matrix))
            path, response = factors.solve(np.column_stack([pull, last])).T
            found.append((path, response))
        return found

    @property
    def numbers_stored(self) -> int:
        """Means, variances, the length of each state, and the duration."""
        return self.means.size + self.variances.size + self.lengths.size + 1
