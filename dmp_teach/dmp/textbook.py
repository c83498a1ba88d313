"""The paper's two algorithms as a reader of the paper would write them: loops, and no haste.

Symbols and equation numbers are the paper's. Every function is for one coordinate; each coordinate
is learned and drawn alone. Where the paper is silent or contradicts itself we do as
`Settings.as_fixed()` does: the phase x falls evenly from 1 to 0, kernel i has its centre at
(i - 1/2)/N and is 0 farther than theta = width/(2N) from it, and the forcing term is divided by
what multiplies it. Time is counted in movements, so that T = 1 and dt = 1/M.

    theta = trajectory.position[:, 0].tolist()
    y = star_dmp(theta, gaussian_kernel(N), N, alpha_z, g)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

# Psi_i(x) for the phase x and the kernel i = 0 ... N - 1.
KernelFunction = Callable[[float, int], float]


def gaussian_kernel(N: int, sigma: float = 4.0, width: float = 1.0) -> KernelFunction:
    """Return the truncated Gaussian kernels of equations 6 and 10; of 4 for an infinite width.

    Args:
        N: How many kernels there are.
        sigma: Their roundness: h_i = (N / sigma)^2, in equation 4 half of it.
        width: Where they end: theta_i = width / (2 N).
    """

    def psi(x: float, i: int) -> float:
        # Ends are compared in units of 1/N: there rounding leaves no x between two kernels. x = 1
        # belongs to the last one.
        u = min(N * x, math.nextafter(N, 0))
        if not i + 0.5 - width / 2 <= u < i + 0.5 + width / 2:
            return 0.0
        h, c = (N / sigma) ** 2, (i + 0.5) / N
        return math.exp(-h / 2 * (x - c) ** 2)

    return psi


def forcing_term(
    x: float, w: Sequence[float], psi: KernelFunction, b: Sequence[float] | None = None
) -> float:
    """Return f by equation 2, where w_i x may have a bias b_i; 0 where no kernel is active."""
    above, below = 0.0, 0.0
    for i in range(len(w)):
        above += psi(x, i) * (w[i] * x + (0.0 if b is None else b[i]))
        below += psi(x, i)
    return above / below if below > 0 else 0.0


def learn_weights(
    x: Sequence[float], f: Sequence[float], N: int, psi: KernelFunction
) -> list[float]:
    """Return all w_i by locally weighted regression, equation 5."""
    w = []
    for i in range(N):
        above = sum(x_t * psi(x_t, i) * f_t for x_t, f_t in zip(x, f, strict=True))
        below = sum(x_t * psi(x_t, i) * x_t for x_t in x)
        w.append(above / below if below > 0 else 0.0)
    return w


def original_acceleration(
    y: float, dy: float, x: float, f: float, *, y0: float, g: float, alpha_z: float, beta_z: float
) -> float:
    """Return ddy by equations 1 and 8; the phase x enters by f alone."""
    return alpha_z * (beta_z * (g - y) - dy) + (g - y0) * f


def star_acceleration(
    y: float, dy: float, x: float, f: float, *, y0: float, g: float, alpha_z: float, beta_z: float
) -> float:
    """Return ddy by equation 11, DMP*."""
    spring = alpha_z * (beta_z * (g - y) - dy)
    return spring - alpha_z * beta_z * (g - y0) * x + alpha_z * beta_z * f


def original_dmp(
    theta: Sequence[float], psi: KernelFunction, N: int, alpha_z: float, g: float | None = None
) -> list[float]:
    """Learn and draw one coordinate of a movement by Algorithm 1.

    Args:
        theta: The demonstrated positions, at even times [m].
        psi: The kernels.
        N: How many there are.
        alpha_z: The damping of the spring over one movement.
        g: The goal; as demonstrated unless given [m].

    Returns:
        The positions y, as many as theta [m].
    """
    M, beta_z = len(theta) - 1, alpha_z / 4
    dy, ddy = differentiate(theta)
    y0, end = theta[0], theta[-1]
    x = [(M - t) / M for t in range(M)]
    f = []
    for t in range(M):
        spring = alpha_z * (beta_z * (end - theta[t]) - dy[t])
        f.append((ddy[t] - spring) / (end - y0))
    w = learn_weights(x, f, N, psi)

    g = end if g is None else g
    # A velocity that the demonstration began with is a part of its shape, and grows with it.
    dt, y, velocity = 1 / M, y0, dy[0] * (g - y0) / (end - y0)
    path = [y]
    for t in range(M):
        a = original_acceleration(
            y, velocity, x[t], forcing_term(x[t], w, psi),
            y0=y0, g=g, alpha_z=alpha_z, beta_z=beta_z,
        )  # fmt: skip
        y, velocity = y + velocity * dt, velocity + a * dt
        path.append(y)
    return path


def star_dmp(
    theta: Sequence[float], psi: KernelFunction, N: int, alpha_z: float, g: float | None = None
) -> list[float]:
    """Learn and draw one coordinate of a movement by Algorithm 2; arguments as `original_dmp`."""
    M, beta_z = len(theta) - 1, alpha_z / 4
    dy, ddy = differentiate(theta)
    y0, end = theta[0], theta[-1]
    x = [(M - t) / M for t in range(M)]
    f = []
    for t in range(M):
        spring = alpha_z * (beta_z * (end - theta[t]) - dy[t])
        decay = alpha_z * beta_z * (end - y0) * x[t]
        f.append((ddy[t] - spring + decay) / (alpha_z * beta_z))
    w = learn_weights(x, f, N, psi)

    g = end if g is None else g
    dt, y, velocity = 1 / M, y0, dy[0]
    path = [y]
    for t in range(M):
        a = star_acceleration(
            y, velocity, x[t], forcing_term(x[t], w, psi),
            y0=y0, g=g, alpha_z=alpha_z, beta_z=beta_z,
        )  # fmt: skip
        y, velocity = y + velocity * dt, velocity + a * dt
        path.append(y)
    return path


def differentiate(theta: Sequence[float]) -> tuple[list[float], list[float]]:
    """Return velocity and acceleration by differences on both sides of a sample."""

    def slope(y: Sequence[float]) -> list[float]:
        last = len(y) - 1
        found = []
        for t in range(len(y)):
            before, after = max(t - 1, 0), min(t + 1, last)
            found.append((y[after] - y[before]) * last / (after - before))
        return found

    velocity = slope(theta)
    return velocity, slope(velocity)
