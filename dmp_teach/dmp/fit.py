"""Fits: from the forcing term that a demonstration needs to the weights of the kernels.

f(s) = s * sum psi_i w_i / sum psi_i  (+ sum psi_i b_i / sum psi_i)
"""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np

from dmp_teach.dmp.integrators import Spring
from dmp_teach.dmp.kernels import Cells, Overlap, ratio
from dmp_teach.dmp.registry import NamedChoice, Registry
from dmp_teach.trajectory import Array

LaidKernels = Cells | Overlap
Learned = tuple[Array, Array | None]

# Of the square of each column.
JOINT_FIT_RIDGE = 1e-8


def forcing(kernels: LaidKernels, s: Array, weights: Array, biases: Array | None) -> Array:
    """Return f(s) at every sample (the paper's equation 2), (M, D); 0 where no kernel is active."""
    f = s * kernels.blend(weights)
    return f if biases is None else f + kernels.blend(biases)


class WeightFit(NamedChoice):
    """How the weights are found.

    Attributes:
        rounds_bends: Whether it averages over boxes, which rounds the bends of a path.
    """

    setting = "fit"
    rounds_bends: ClassVar[bool] = False

    @abstractmethod
    def learn(self, kernels: LaidKernels, s: Array, F: Array, spring: Spring) -> Learned:
        """Return weights (N, D), and biases (N, D) or None.

        Args:
            kernels: Laid over the phases.
            s: Phases, shape (M, 1), or (M + 1, 1) with the last sample.
            F: The needed forcing, shape (M, D) or (M + 1, D).
            spring: Which will follow it.
        """


FITS: Registry[type[WeightFit]] = Registry()


@FITS.add
class LWR(WeightFit):
    """Locally weighted regression, each kernel for itself (the paper's equation 5).

    w_i = sum psi s F / sum psi s^2
    """

    name = "lwr"
    rounds_bends = True

    def learn(self, kernels: LaidKernels, s: Array, F: Array, spring: Spring) -> Learned:
        """Return both sums' quotients, and no biases."""
        sums = kernels.gather(s * np.concatenate([F, s], axis=1))
        return ratio(sums[:, :-1], sums[:, -1:]), None


@FITS.add
class LocalBias(WeightFit):
    """Each kernel for itself learns a line, w_i s + b_i, by weighted least squares (Wang 2016)."""

    name = "bias"

    def learn(self, kernels: LaidKernels, s: Array, F: Array, spring: Spring) -> Learned:
        """Return slopes and offsets; a kernel with a single sample learns as LWR does."""
        total = kernels.gather(np.ones_like(s))
        mean_s, mean_F = ratio(kernels.gather(s), total), ratio(kernels.gather(F), total)
        variance = kernels.gather(s * s) - total * mean_s**2
        covariance = kernels.gather(s * F) - total * mean_s * mean_F
        has_slope = variance > 1e-12 * total * mean_s**2
        slope = ratio(covariance, np.where(has_slope, variance, 1.0))
        w = np.where(has_slope, slope, ratio(mean_F, mean_s))
        return w, mean_F - w * mean_s


@FITS.add
class JointFit(WeightFit):
    """All weights at once, for the path that comes closest to the demonstrated one.

    The path is linear in the weights and in the start velocity: each kernel's part of it is a
    column, found by letting the spring follow that kernel alone. Least squares with a ridge of
    1e-8 that holds the weights to the LWR answer. Held to that answer, not to 0, the two
    transformations learn the same path: an addition of c s to F adds c to every weight, whatever
    the ridge.
    """

    name = "joint"

    def learn(self, kernels: LaidKernels, s: Array, F: Array, spring: Spring) -> Learned:
        """Return the weights of all kernels, and no biases."""
        w, _ = LWR().learn(kernels, s, F, spring)
        if isinstance(kernels, Cells):
            # No kernel shares a sample with another.
            return w, None
        columns = np.hstack([spring.follow((s * kernels.shares)[: spring.steps]), spring.kick()])
        missed = spring.follow((F - forcing(kernels, s, w, None))[: spring.steps])
        gram = columns.T @ columns
        size = np.sqrt(np.diag(gram))
        # Every column counts alike.
        size = np.where(size > 0, size, 1.0)[:, None]
        scaled = gram / (size * size.T) + JOINT_FIT_RIDGE * np.eye(len(gram))
        better = np.linalg.solve(scaled, columns.T @ missed / size) / size
        return w + better[:-1], None
