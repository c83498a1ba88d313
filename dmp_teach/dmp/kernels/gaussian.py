"""The Gaussian kernel, full or cut."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from dmp_teach.dmp.kernels.kernel import KERNELS, Kernel
from dmp_teach.trajectory import Array


@KERNELS.add
@dataclass(frozen=True)
class Gaussian(Kernel):
    """psi_i = exp(-h_i/2 (s - c_i)^2), h_i = 1 / (sigma * spacing at c_i)^2.

    The paper's equation 4, whose h_i is half as large; with ends the truncated one of equation 6,
    of width 1/N that of equation 10.

    Args:
        sigma: The roundness, in spacings between kernels, 1/N; infinite for boxes.
    """

    name = "gaussian"
    endless = True
    sigma: float = math.inf

    def height(self, r: Array, z: Array) -> Array:
        """Return exp(-(z / sigma)^2 / 2)."""
        return np.exp(-0.5 * (z / self.sigma) ** 2)

    @property
    def is_box(self) -> bool:
        """Whether sigma is infinite."""
        return math.isinf(self.sigma)


# The paper's figure 2.
Gaussian.examples = (
    ("full Gaussian", math.inf, Gaussian(0.65)),
    ("truncated, touching: width 1/N", 1.0, Gaussian(0.5)),
    ("truncated, with gaps: width 2/3N", 2 / 3, Gaussian(0.5)),
    ("truncated, overlapping: width 2/N", 2.0, Gaussian(0.65)),
)
