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

    A kernel is awake on a cell `width`/N long: i - 1/2 - width/2 <= u < i - 1/2 + width/2, where u = N s for the
    linear phase, and N times the part of the movement to come for any; the last cell is closed at s = 1.
    Touching kernels never leave or share a sample.

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
        s = np.asarray(s, dtype=float)
        return self._psi(s[:, None], self._place(self.phase.left(s))[:, None], np.arange(self.number))

    def activations(self, s: Array) -> Array:
        """How awake each kernel is at each phase, psi_i / sum of psi.

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Activations, shape (T, N); rows sum to 1, or to 0 where no kernel is awake.
        """
        heights = self.heights(s)
        return ratio(heights, heights.sum(axis=1, keepdims=True))

    def over(self, left: Array) -> "Cells | Overlap":
        """The kernels laid over a movement, ready for the sums of a fit.

        Args:
            left: The part of the movement that is still to come at each sample, falling, shape (T,).
        """
        s, u = self.phase.at(left), self._place(left)
        if self.width > 1:
            return Overlap(self._psi(s[:, None], u[:, None], np.arange(self.number)))
        owner = u.astype(int)
        touching_boxes = self.width == 1 and np.isinf(self.sigma)
        return Cells(self.number, owner, None if touching_boxes else self._psi(s, u, owner))

    def _place(self, left: Array) -> Array:
        """The place u = N left; just under N at the start, which belongs to the last cell."""
        return np.clip(self.number * left, 0, np.nextafter(self.number, 0))

    def _psi(self, s: Array, u: Array, i: Array) -> Array:
        """The height of kernels `i`, counted from 0, at phase s and place u."""
        awake = (i + 0.5 - self.width / 2 <= u) & (u < i + 0.5 + self.width / 2)
        if np.isinf(self.sigma):
            return awake.astype(float)
        off = (s - self.centers[i]) / (self.sigma * self.spacings[i])
        return np.where(awake, np.exp(-0.5 * off**2), 0.0)


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
