"""From the forcing that a demonstration needs to the weights of the kernels.

Each fit takes the kernels laid over the phases (`Cells` or `Overlap`), the phases s (T, 1) and the needed
forcing F (T, D), and gives weights (N, D) and biases (N, D) or None, so that

    f(s) = s * sum psi_i w_i / sum psi_i  (+ sum psi_i b_i / sum psi_i)
"""

import numpy as np

from dmp_teach.dmp.kernels import Cells, Overlap, ratio
from dmp_teach.trajectory import Array

RIDGE = 1e-8  # of the mean square of a kernel's column


def forcing(kernels: Cells | Overlap, s: Array, weights: Array, biases: Array | None) -> Array:
    """f(s) at every sample, shape (T, D); 0 where no kernel is awake."""
    f = s * kernels.blend(weights)
    return f if biases is None else f + kernels.blend(biases)


def lwr(kernels: Cells | Overlap, s: Array, F: Array) -> tuple[Array, None]:
    """Locally weighted regression, each kernel for itself (the paper's equation 5): w_i = sum psi s F / sum psi s^2."""
    return ratio(kernels.gather(s * F), kernels.gather(s * s)), None


def bias(kernels: Cells | Overlap, s: Array, F: Array) -> tuple[Array, Array]:
    """Each kernel for itself learns a straight line, w_i s + b_i (DMP+, Wang 2016), by weighted least squares."""
    awake = kernels.gather(np.ones_like(s))
    mean_s, mean_F = ratio(kernels.gather(s), awake), ratio(kernels.gather(F), awake)
    spread = kernels.gather(s * s) - awake * mean_s**2
    together = kernels.gather(s * F) - awake * mean_s * mean_F
    line = spread > 1e-12 * awake * mean_s**2  # a kernel with a single sample has no slope: it learns as LWR does
    w = np.where(line, ratio(together, np.where(line, spread, 1.0)), ratio(mean_F, mean_s))
    return w, mean_F - w * mean_s


def joint(kernels: Cells | Overlap, s: Array, F: Array) -> tuple[Array, None]:
    """All weights at once: the least sum of (F - f)^2, with a ridge of 1e-8 that holds them to the LWR answer.

    Held to that answer, not to 0, the two transformations learn the same path: an addition of c s to F
    adds c to every weight, whatever the ridge.
    """
    w, _ = lwr(kernels, s, F)
    if isinstance(kernels, Cells):
        return w, None  # no kernel shares a sample with another: nothing is left to improve
    columns = s * kernels.shares
    gram = columns.T @ columns
    gram[np.diag_indices_from(gram)] += RIDGE * np.trace(gram) / len(gram)
    return w + np.linalg.solve(gram, columns.T @ (F - columns @ w)), None


FITS = {"lwr": lwr, "bias": bias, "joint": joint}
