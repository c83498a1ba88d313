"""Kernels: the bumps that share out the phase, and the two sums that are taken over them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dmp_teach.dmp.phase import Phase
from dmp_teach.trajectory import Array

LINEAR = Phase()


@dataclass(frozen=True)
class Kernels:
    """N kernels over the phase, kernel 1 at the end of the movement (phase 0).

        gaussian   psi_i = exp(-h_i/2 (s - c_i)^2)  where kernel i is awake, else 0   (the paper's truncated kernels)
        mollifier  psi_i = exp(-1 / (1 - r^2))      r = (u - m_i) / (width/2)         (DMP++, Ginesi 2019)
        c_i        middles: s at (i - 1/2)/N of the movement to come, so that kernels stand at equal times;
                   phases: (i - 1/2)/N; ends: (i - 1)/(N - 1); grid: i/N
        h_i        1 / (sigma * spacing at c_i)^2; (N / sigma)^2 for the linear phase

    A kernel is awake on a cell `width`/N long: m_i - width/2 <= u < m_i + width/2. For middles m_i = i - 1/2 and u is
    N times the part of the movement to come; for the others m_i = N c_i and u = N s. The last cell is closed at
    s = 1, so touching kernels never leave or share a sample. A one-sided kernel is what the paper prints,
    x - c_i <= theta: awake wherever u <= m_i + width/2. Under a sigmoid phase, flat for so long, Gaussians are round
    in time (Kulvicius 2012).

    Args:
        number: N.
        width: The whole support, in 1/N; infinite for full Gaussians.
        sigma: The roundness, in 1/N; infinite for boxes.
        phase: What the kernels are spread over.
        shape: "gaussian" or "mollifier".
        stand: "middles", "phases", "ends" or "grid".
        sides: "both" or "one".
    """

    number: int
    width: float = 1.0
    sigma: float = np.inf
    phase: Phase = LINEAR
    shape: str = "gaussian"
    stand: str = "middles"
    sides: str = "both"

    @cached_property
    def centers(self) -> Array:
        """The phases c_i, shape (N,)."""
        part = self.places / self.number
        return self.phase.at(part) if self.stand == "middles" else part

    @cached_property
    def spacings(self) -> Array:
        """The distance in phase from one centre to the next, shape (N,)."""
        equal = self.stand != "middles"
        return (
            np.full(self.number, 1 / self.number)
            if equal
            else self.phase.speed(self.centers) / self.number
        )

    @cached_property
    def places(self) -> Array:
        """m_i, the middle of each kernel in 1/N, shape (N,)."""
        i = np.arange(self.number)
        if self.stand == "ends" and self.number > 1:
            return i * self.number / (self.number - 1)
        return i + 1.0 if self.stand == "grid" else i + 0.5

    def heights(self, s: Array) -> Array:
        """How high each bump is, psi_i(s).

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Heights between 0 and 1, shape (T, N).
        """
        s = np.asarray(s, dtype=float)
        return self._psi(
            s[:, None], self._place(self.phase.left(s), s)[:, None], np.arange(self.number)
        )

    def activations(self, s: Array) -> Array:
        """How awake each kernel is at each phase, psi_i / sum of psi.

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Activations, shape (T, N); rows sum to 1, or to 0 where no kernel is awake.
        """
        heights = self.heights(s)
        return ratio(heights, heights.sum(axis=1, keepdims=True))

    def over(self, left: Array) -> Cells | Overlap:
        """The kernels laid over a movement, ready for the sums of a fit.

        Args:
            left: The part of the movement that is still to come at each sample, falling, shape (T,).
        """
        s = self.phase.at(left)
        u = self._place(left, s)
        if self.width > 1 or self.stand != "middles" or self.sides == "one":
            return Overlap(self._psi(s[:, None], u[:, None], np.arange(self.number)))
        owner = u.astype(int)
        touching_boxes = self.width == 1 and math.isinf(self.sigma) and self.shape == "gaussian"
        return Cells(self.number, owner, None if touching_boxes else self._psi(s, u, owner))

    def _place(self, left: Array, s: Array) -> Array:
        """The place u; just under N at the start, which belongs to the last cell."""
        part = left if self.stand == "middles" else s
        return np.minimum(self.number * part, math.nextafter(self.number, 0))

    def _psi(self, s: Array, u: Array, i: Array) -> Array:
        """The height of kernels `i`, counted from 0, at phase s and place u."""
        off, half = u - self.places[i], self.width / 2
        if self.shape == "mollifier":
            inside = np.maximum(1 - (off / half) ** 2, 0.0)
            return np.where(inside > 0, np.exp(-1 / np.where(inside > 0, inside, 1.0)), 0.0)
        awake = (
            off <= half
            if self.sides == "one"
            else (self.places[i] - half <= u) & (u < self.places[i] + half)
        )
        if np.isinf(self.sigma):
            return awake.astype(float)
        in_time = self.phase.kind == "sigmoid" and self.stand == "middles"
        off = (
            off / self.sigma if in_time else (s - self.centers[i]) / (self.sigma * self.spacings[i])
        )
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

    @property
    def asleep(self) -> Array:
        """At which samples no kernel is awake, shape (T,)."""
        return ~self.psi.any(axis=1)

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
        sums[self.owner.take(first)] = np.add.reduceat(values, first)
        return sums

    def blend(self, weights: Array) -> Array:
        """The mean sum psi_i w_i / sum psi_i at each sample, 0 where no kernel is awake: (N, D) -> (T, D)."""
        blended = weights.take(self.owner, axis=0)  # what weights[owner] is, in a fifth of its time
        return blended if self.psi is None else np.where(self.psi[:, None] > 0, blended, 0.0)

    @property
    def asleep(self) -> Array:
        """At which samples no kernel is awake, shape (T,)."""
        return np.zeros(len(self.owner), dtype=bool) if self.psi is None else self.psi == 0

    @cached_property
    def _first(self) -> Array:
        """Where each run of samples with one owner begins."""
        change = np.empty(len(self.owner), dtype=bool)
        change[0] = True
        np.not_equal(self.owner[1:], self.owner[:-1], out=change[1:])
        return np.flatnonzero(change)


def ratio(above: Array, below: Array) -> Array:
    """The quotient above / below, and 0 where there is nothing to divide by."""
    if np.count_nonzero(below) == below.size:
        return above / below
    nothing = below == 0
    return np.where(nothing, 0.0, above / np.where(nothing, 1.0, below))
