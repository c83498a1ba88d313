"""Kernels: the bumps that share out the phase, and the two sums that are taken over them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dmp_teach.dmp.phase import Phase
from dmp_teach.trajectory import Array

LINEAR = Phase()


@dataclass(frozen=True)
class Kernels:
    """N kernels at equal times, counted from the end of the movement (phase 0) to its start (phase 1).

        psi_i(s) = exp(-h_i/2 (s - c_i)^2)  where kernel i is awake, else 0    (the paper's truncated kernels)
        c_i      = s at (i - 1/2)/N of the movement to come; (i - 1/2)/N itself for the linear phase
        h_i      = 1 / (sigma * spacing at c_i)^2; (N / sigma)^2 for the linear phase

    A kernel is awake on a cell `width`/N long: i - 1/2 - width/2 <= u < i - 1/2 + width/2 with u = N s
    (the last cell is closed at s = 1), so that touching kernels never leave or share a sample.

    Args:
        number: N.
        width: The whole support, in 1/N; infinite for full Gaussians.
        sigma: The roundness, in 1/N; infinite for boxes.
        phase: What the kernels are spread over.
    """

    number: int
    width: float = 1.0
    sigma: float = np.inf
    phase: Phase = LINEAR

    @cached_property
    def centers(self) -> Array:
        """The phases c_i, shape (N,)."""
        return self.phase.at((np.arange(self.number) + 0.5) / self.number)

    @cached_property
    def spacings(self) -> Array:
        """The distance in phase from one centre to the next, shape (N,)."""
        return self.phase.speed(self.centers) / self.number

    def heights(self, s: Array) -> Array:
        """How high each bump is, psi_i(s).

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Heights between 0 and 1, shape (T, N).
        """
        s = np.asarray(s, dtype=float)[:, None]
        awake = self._awake(self._cell_coordinate(s), np.arange(self.number))
        return np.where(awake, self._gaussian(s, self.centers, self.spacings), 0.0)

    def activations(self, s: Array) -> Array:
        """How awake each kernel is at each phase, psi_i / sum of psi.

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Activations, shape (T, N); rows sum to 1, or to 0 where no kernel is awake.
        """
        heights = self.heights(s)
        return ratio(heights, heights.sum(axis=1, keepdims=True))

    def over(self, s: Array) -> "Cells | Overlap":
        """The kernels laid over falling phases s, shape (T,), ready for the sums of a fit."""
        if self.width > 1:
            return Overlap(self.heights(s))
        u = self._cell_coordinate(s)
        owner = u.astype(int)
        if self.width == 1 and np.isinf(self.sigma):
            return Cells(self.number, owner)
        return Cells(self.number, owner, self._awake(u, owner) * self._gaussian(s, self.centers[owner], self.spacings[owner]))

    def _cell_coordinate(self, s: Array) -> Array:
        """The place u = N s for the linear phase; just under N at the start, which belongs to the last cell."""
        return np.clip(self.number * self.phase.left(s), 0, np.nextafter(self.number, 0))

    def _awake(self, u: Array, index: Array) -> Array:
        """Whether u is in the cell of a kernel; `index` counts from 0, so its middle is at index + 1/2."""
        return (index + 0.5 - self.width / 2 <= u) & (u < index + 0.5 + self.width / 2)

    def _gaussian(self, s: Array, c: Array, spacing: Array) -> Array | float:
        """exp(-h/2 (s - c)^2), or 1 for a box."""
        if np.isinf(self.sigma):
            return 1.0
        return np.exp(-0.5 * ((s - c) / (self.sigma * spacing)) ** 2)


@dataclass(frozen=True, eq=False)
class Overlap:
    """Kernels of which several may be awake at once: `psi` has shape (T, N)."""

    psi: Array

    def gather(self, values: Array) -> Array:
        """The sum over samples of psi_i(s_k) values_k, for each kernel: (T, D) -> (N, D)."""
        return self.psi.T @ values

    def blend(self, weights: Array) -> Array:
        """The mean sum psi_i w_i / sum psi_i at each sample, 0 where no kernel is awake: (N, D) -> (T, D)."""
        return self.shares @ weights

    @cached_property
    def shares(self) -> Array:
        """psi_i / sum psi_i, shape (T, N)."""
        return ratio(self.psi, self.psi.sum(axis=1, keepdims=True))


@dataclass(frozen=True, eq=False)
class Cells:
    """Kernels that never overlap: sample k belongs to one `owner` (T,), whose height there is `psi` (T,) or 1.

    The same two sums as `Overlap`, in a time that does not grow with the number of kernels.
    """

    number: int
    owner: Array
    psi: Array | None = None

    def gather(self, values: Array) -> Array:
        """The sum over samples of psi_i(s_k) values_k, for each kernel: (T, D) -> (N, D)."""
        first = self._first
        if self.psi is not None:
            values = self.psi[:, None] * values
        sums = np.zeros((self.number, values.shape[1]))
        sums[self.owner[first]] = np.add.reduceat(values, first)
        return sums

    def blend(self, weights: Array) -> Array:
        """The mean sum psi_i w_i / sum psi_i at each sample, 0 where no kernel is awake: (N, D) -> (T, D)."""
        blended = weights[self.owner]
        return blended if self.psi is None else np.where(self.psi[:, None] > 0, blended, 0.0)

    @cached_property
    def _first(self) -> Array:
        """Where each run of samples with one owner begins."""
        change = np.empty(len(self.owner), dtype=bool)
        change[0] = True
        np.not_equal(self.owner[1:], self.owner[:-1], out=change[1:])
        return np.flatnonzero(change)


def ratio(above: Array, below: Array) -> Array:
    """The quotient above / below, and 0 where there is nothing to divide by."""
    nothing = below == 0
    return above / below if not nothing.any() else np.where(nothing, 0.0, above / np.where(nothing, 1.0, below))
