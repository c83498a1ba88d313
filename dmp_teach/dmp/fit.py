"""From the forcing that a demonstration needs to the weights of the kernels.

Each fit takes the kernels laid over the phases (`Cells` or `Overlap`), the phases s (T, 1) and the needed
forcing F (T, D), and the spring that will be pushed, and gives weights (N, D) and biases (N, D) or None, so that

    f(s) = s * sum psi_i w_i / sum psi_i  (+ sum psi_i b_i / sum psi_i)
"""

from __future__ import annotations

import numpy as np

from dmp_teach.dmp.integrators import Spring
from dmp_teach.dmp.kernels import Cells, Overlap, ratio
from dmp_teach.trajectory import Array

RIDGE = 1e-8  # of the square of each column


def forcing(kernels: Cells | Overlap, s: Array, weights: Array, biases: Array | None) -> Array:
    """f(s) at every sample, shape (T, D); 0 where no kernel is awake."""
    f = s * kernels.blend(weights)
    return f if biases is None else f + kernels.blend(biases)


def lwr(kernels: Cells | Overlap, s: Array, F: Array, spring: Spring) -> tuple[Array, None]:
    """Locally weighted regression, each kernel for itself (the paper's equation 5): w_i = sum psi s F / sum psi s^2."""
    sums = kernels.gather(s * np.concatenate([F, s], axis=1))  # both sums at once
    return ratio(sums[:, :-1], sums[:, -1:]), None


def bias(kernels: Cells | Overlap, s: Array, F: Array, spring: Spring) -> tuple[Array, Array]:
    """Each kernel for itself learns a straight line, w_i s + b_i (DMP+, Wang 2016), by weighted least squares."""
    awake = kernels.gather(np.ones_like(s))
    mean_s, mean_F = ratio(kernels.gather(s), awake), ratio(kernels.gather(F), awake)
    spread = kernels.gather(s * s) - awake * mean_s**2
    together = kernels.gather(s * F) - awake * mean_s * mean_F
    line = (
        spread > 1e-12 * awake * mean_s**2
    )  # a kernel with a single sample has no slope: it learns as LWR does
    w = np.where(line, ratio(together, np.where(line, spread, 1.0)), ratio(mean_F, mean_s))
    return w, mean_F - w * mean_s


def joint(kernels: Cells | Overlap, s: Array, F: Array, spring: Spring) -> tuple[Array, None]:
    """All weights at once, for the path that comes closest to the demonstrated one.

    The path is linear in the weights and in the start velocity: each kernel's part of it is a column, found
    by letting the spring follow that kernel alone. Least squares with a ridge of 1e-8 that holds the weights
    to the LWR answer. Held to that answer, not to 0, the two transformations learn the same path: an addition
    of c s to F adds c to every weight, whatever the ridge.
    """
    w, _ = lwr(kernels, s, F, spring)
    if isinstance(kernels, Cells):
        return w, None  # no kernel shares a sample with another
    columns = np.hstack([spring.follow(s * kernels.shares), spring.kick()])
    missed = spring.follow(F - forcing(kernels, s, w, None))
    gram = columns.T @ columns
    size = np.sqrt(np.diag(gram))
    size = np.where(size > 0, size, 1.0)[:, None]  # every column counts alike
    better = (
        np.linalg.solve(
            gram / (size * size.T) + RIDGE * np.eye(len(gram)), columns.T @ missed / size
        )
        / size
    )
    return w + better[:-1], None


FITS = {"lwr": lwr, "bias": bias, "joint": joint}
