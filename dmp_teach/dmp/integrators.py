"""The spring and damper that carry the pen, stepped through one movement, and the same read backwards."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter

from dmp_teach.trajectory import Array

LEAST_STEPS = 50  # a movement is never drawn in fewer
STEPS_PER_ALPHA = 2.0  # eight times what the explicit spring needs not to diverge
MOST_STEPS = 100_000


def least_steps(alpha: float, damping: float = 1.0) -> float:
    """How many steps a movement must have at least, whatever the integrator: a spring that swings needs more."""
    return max(LEAST_STEPS, STEPS_PER_ALPHA * alpha / min(1.0, damping) ** 2)


def most_alpha(damping: float) -> float:
    """The stiffest spring that can be followed in `MOST_STEPS` steps."""
    return MOST_STEPS * min(1.0, damping) ** 2 / STEPS_PER_ALPHA


@dataclass(frozen=True)
class Spring:
    """z'' = push - K z - D z', with time counted in movements (t/T), D = alpha and K = (alpha / (2 damping))^2.

        explicit       a_k = push_k - K z_k - D v_k,   z_{k+1} = z_k + h v_k,      v_{k+1} = v_k + h a_k
        semi-implicit  the same a_k,                   v_{k+1} = v_k + h a_k,      z_{k+1} = z_k + h v_{k+1}
        lagged         a_k = push_k - K z_{k-1} - D v_{k-1}, a_0 = 0, then as explicit   (Algorithms 1, 2 as printed)
        exact          the motion itself, where push_k is held for the step:
                       (z, v)_{k+1} = E (z, v)_k + (I - E) (push_k / K, 0),   E = exp(h [[0, 1], [-K, -D]])

    with h = 1/steps. Each is one linear recursion in the positions alone, so a whole movement is one filter.
    With damping 1, critical, the explicit scheme diverges from alpha = 4 steps on, the semi-implicit one from 1.65
    steps on, the lagged one from 0.91 steps on, the exact one never.

    Args:
        alpha: D over one movement.
        steps: How many steps a movement has: M.
        integrator: "explicit", "semi-implicit", "lagged" or "exact".
        damping: 1 for critical, less for a spring that swings.
    """

    alpha: float
    steps: int
    integrator: str
    damping: float = 1.0

    @property
    def K(self) -> float:  # noqa: N802 (the paper's name)
        """Stiffness for one movement: alpha beta; beta = alpha/4 where damping is critical."""
        return (self.alpha / (2 * self.damping)) ** 2

    @property
    def middle(self) -> float:
        """Where in its step a push is taken, in steps: a push that is held stands for the middle."""
        return 0.5 if self.integrator == "exact" else 0.0

    def follow(self, push: Array, start_velocity: Array | float = 0.0) -> Array:
        """The path from z = 0 under `push` (M, D), shape (M + 1, D); velocity per movement, shape (D,).

        Velocities beyond those of the D coordinates start paths of their own, which nothing pushes: they are the
        columns after D. One filter draws all of them, for calling it takes as long as drawing two.
        """
        h, K, D = 1 / self.steps, self.K, self.alpha
        drive = np.zeros(
            (max(push.shape[1], np.size(start_velocity)), self.steps + 1)
        ).T  # a coordinate in one piece
        pushed = drive[:, : push.shape[1]]
        if self.integrator == "explicit":
            pushed[2:] = h * h * push[:-1]
            drive[1] = h * start_velocity
            recursion = [1.0, -(2 - h * D), 1 - h * D + h * h * K]
        elif self.integrator == "semi-implicit":
            pushed[1:] = h * h * push
            drive[1] += (1 - h * D) * h * start_velocity
            recursion = [1.0, -(2 - h * D - h * h * K), 1 - h * D]
        elif self.integrator == "lagged":
            pushed[3:] = h * h * push[1:-1]
            drive[1] = h * start_velocity
            recursion = [1.0, -2.0, 1 + h * D, h * h * K - h * D]
        else:
            (zz, zv), (vz, vv) = propagator(K, D, h)
            z_push, v_push = (1 - zz) / K, -vz / K
            pushed[1:] = z_push * push
            pushed[2:] += (zv * v_push - vv * z_push) * push[:-1]
            drive[1] += zv * start_velocity
            recursion = [1.0, -(zz + vv), zz * vv - zv * vz]
        return lfilter([1.0], recursion, drive.T).T

    def needed(self, z: Array, derivatives: str = "inverse") -> tuple[Array, Array]:
        """The push (M, D) under which `follow` draws the path `z` (M + 1, D), and its start velocity (D,).

        "inverse": the discrete scheme read backwards, so that what the integrator gets wrong, the push makes good;
        where the scheme leaves one push open (the last of the explicit, the first of the semi-implicit), its
        acceleration is that of its neighbour. An exact spring takes its differences at the middle of each step, which
        is right to second order. "central": differences on both sides of a sample, twice, as one does on paper.
        """
        h = 1 / self.steps
        if derivatives == "central":
            v = np.gradient(z, h, axis=0)
            push = np.gradient(v, h, axis=0) + self.alpha * v + self.K * z
            return (push[1:] + push[:-1]) / 2 if self.integrator == "exact" else push[:-1], v[0]
        step = (z[1:] - z[:-1]) / h
        bend = (step[1:] - step[:-1]) / h
        if self.integrator == "semi-implicit":
            a, v = (
                np.concatenate([bend[:1], bend]),
                np.concatenate([step[:1] - h * bend[:1], step[:-1]]),
            )
        elif self.integrator == "lagged":  # a_k = push_k - K z_{k-1} - D v_{k-1}
            before = np.concatenate([z[:1], z[:-2]])
            a, v = np.concatenate([bend, bend[-1:]]), np.concatenate([step[:1], step[:-1]])
            return a + self.alpha * v + self.K * before, step[0]
        elif self.integrator == "exact":
            a = (np.concatenate([bend[:1], bend]) + np.concatenate([bend, bend[-1:]])) / 2
            return a + self.alpha * step + self.K * (z[1:] + z[:-1]) / 2, step[0] - h / 2 * bend[0]
        else:
            a, v = np.concatenate([bend, bend[-1:]]), step
        return a + self.alpha * v + self.K * z[:-1], v[0]

    def kick(self) -> Array:
        """The path (M + 1, 1) of a pen that starts with velocity 1 and is pushed no more."""
        return self.follow(np.zeros((self.steps, 0)), np.ones(1))


def propagator(K: float, D: float, h: float) -> Array:
    """E = exp(h [[0, 1], [-K, -D]]) in closed form, shape (2, 2): what a time h makes of (z, v) that nothing pushes."""
    r = D / 2
    w = math.sqrt(abs(r * r - K))
    if w * h < 1e-6:
        c, s = 1.0, h  # critical
    elif r * r < K:
        c, s = math.cos(w * h), math.sin(w * h) / w
    else:
        c, s = math.cosh(w * h), math.sinh(w * h) / w
    return math.exp(-r * h) * np.array([[c + r * s, s], [-K * s, c - r * s]])


def advanced(
    integrator: str, h: float, push: Array, stiffness: tuple[float, float], states: Array
) -> Array:
    """One step of z'' = push - K z - D z', as `Spring.follow` takes it.

    Args:
        integrator: As of `Spring`.
        h: How long the step is.
        push: Shape (D,).
        stiffness: K and D.
        states: z and v one step earlier, and now; NaN earlier than the start. Shape (2, 2, D).

    Returns:
        z and v now, and after the step, shape (2, 2, D).
    """
    (K, D), (before, (z, v)) = stiffness, states
    if integrator == "exact":
        rest = push / K
        (zz, zv), (vz, vv) = propagator(K, D, h)
        return np.array([[z, v], [rest + zz * (z - rest) + zv * v, vz * (z - rest) + vv * v]])
    z_seen, v_seen = before if integrator == "lagged" else (z, v)
    a = np.where(
        np.isnan(z_seen), 0.0, push - K * z_seen - D * v_seen
    )  # the lagged one's first step is not pushed
    faster = v + h * a
    return np.array([[z, v], [z + h * (faster if integrator == "semi-implicit" else v), faster]])
