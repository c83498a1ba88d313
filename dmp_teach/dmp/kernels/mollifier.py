"""The mollifier kernel."""

from __future__ import annotations

import numpy as np

from dmp_teach.dmp.kernels.kernel import KERNELS, Kernel
from dmp_teach.trajectory import Array


@KERNELS.add
class Mollifier(Kernel):
    """psi_i = exp(-1 / (1 - r^2)): all its derivatives are 0 at its ends (DMP++, Ginesi 2019)."""

    name = "mollifier"
    # The paper's figure 2 shows none.
    examples = ()

    def height(self, r: Array, z: Array) -> Array:
        """Return exp(-1 / (1 - r^2)), and 0 at the ends."""
        inside = np.maximum(1 - r**2, 0.0)
        return np.where(inside > 0, np.exp(-1 / np.where(inside > 0, inside, 1.0)), 0.0)
