"""A bank of kernels that share out the phase."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dmp_teach.dmp.kernels.gaussian import Gaussian
from dmp_teach.dmp.kernels.kernel import Kernel
from dmp_teach.dmp.kernels.placement import AtMiddles, Placement
from dmp_teach.dmp.kernels.sums import Cells, Overlap, ratio
from dmp_teach.dmp.phases import Linear, Phase
from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Kernels:
    """N kernels over the phase, kernel 1 at the end of the movement (phase 0).

    A kernel is active on a cell `width`/N long: m_i - width/2 <= u < m_i + width/2, where u is
    N times the part of the movement to come, or N s where kernels stand at equal phases. The last
    cell is closed at s = 1, so touching kernels never leave or share a sample. Other sides: "one"
    is what the paper prints, x - c_i <= theta: active wherever u <= m_i + width/2; "closed" is
    |s - c_i| <= theta as the authors' program compares it.

    Args:
        number: N.
        width: The whole support, in 1/N; infinite for kernels without ends.
        kernel: The shape of each.
        phase: What the kernels are spread over.
        placement: Where they stand.
        sides: Where they end: on "both" sides, on "one", or "closed" on both.
        floor: Their height beyond their ends.
    """

    number: int
    width: float = 1.0
    kernel: Kernel = field(default_factory=Gaussian)
    phase: Phase = field(default_factory=Linear)
    placement: Placement = field(default_factory=AtMiddles)
    sides: str = "both"
    floor: float = 0.0

    @cached_property
    def centers(self) -> Array:
        """The phases c_i, shape (N,)."""
        part = self.places / self.number
        return self.phase.at(part) if self.placement.in_time else part

    @cached_property
    def spacings(self) -> Array:
        """The distance in phase from one centre to the next, shape (N,)."""
        if self.placement.in_time:
            return self.phase.speed(self.centers) / self.number
        return np.full(self.number, 1 / self.number)

    @cached_property
    def places(self) -> Array:
        """m_i, the middle of each kernel in 1/N, shape (N,)."""
        return self.placement.places(self.number)

    def heights(self, s: Array) -> Array:
        """Return how high each bump is, psi_i(s).

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Heights between 0 and 1, shape (T, N).
        """
        s = np.asarray(s, dtype=float)
        u = self._place(self.phase.left(s), s)
        return self._psi(s[:, None], u[:, None], np.arange(self.number))

    def activations(self, s: Array) -> Array:
        """Return the normalized activations psi_i / sum of psi.

        Args:
            s: Phases between 0 and 1, shape (T,).

        Returns:
            Activations, shape (T, N); rows sum to 1, or to 0 where no kernel is active.
        """
        heights = self.heights(s)
        return ratio(heights, heights.sum(axis=1, keepdims=True))

    def over(self, left: Array) -> Cells | Overlap:
        """Lay the kernels over a movement, ready for the sums of a fit.

        Args:
            left: The part of the movement that is still to come at each sample, falling, (T,).
        """
        s = self.phase.at(left)
        u = self._place(left, s)
        is_shared = self.width > 1 or self.floor > 0 or not self.placement.in_time
        if is_shared or self.sides != "both":
            return Overlap(self._psi(s[:, None], u[:, None], np.arange(self.number)))
        owner = u.astype(int)
        touching_boxes = self.width == 1 and self.kernel.is_box
        return Cells(self.number, owner, None if touching_boxes else self._psi(s, u, owner))

    def _place(self, left: Array, s: Array) -> Array:
        """Return the place u; just under N at the start, which belongs to the last cell."""
        part = left if self.placement.in_time else s
        return np.minimum(self.number * part, math.nextafter(self.number, 0))

    def _psi(self, s: Array, u: Array, i: NDArray[np.intp]) -> Array:
        """Return the height of the kernels `i`, counted from 0, at phase s and place u."""
        half = self.width / 2
        off = u - self.places[i]
        if self.sides == "closed":
            active = np.abs(s - self.centers[i]) <= half / self.number
        elif self.sides == "one":
            active = off <= half
        else:
            active = (self.places[i] - half <= u) & (u < self.places[i] + half)
        if self.phase.has_plateau and self.placement.in_time:
            z = off
        else:
            z = (s - self.centers[i]) / self.spacings[i]
        return np.where(active, self.kernel.height(off / half, z), self.floor)
