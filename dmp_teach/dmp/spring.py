"""The spring and damper that carry the pen, stepped through one movement, and the same read backwards."""

from dataclasses import dataclass

import numpy as np
from scipy.signal import lfilter

from dmp_teach.trajectory import Array


@dataclass(frozen=True)
class Spring:
    """z'' = push - K z - D z', with time counted in movements (t/T), K = alpha^2/4 and D = alpha: critically damped.

        explicit       a_k = push_k - K z_k - D v_k,   z_{k+1} = z_k + h v_k,      v_{k+1} = v_k + h a_k
        semi-implicit  the same a_k,                   v_{k+1} = v_k + h a_k,      z_{k+1} = z_k + h v_{k+1}

    with h = 1/steps. Both need two positions to know the next, so a whole movement is one linear recursion.
    The explicit scheme diverges from alpha = 4 steps on, the semi-implicit one from 1.65 steps on.

    Args:
        alpha: Stiffness of the spring over one movement.
        steps: How many steps a movement has: M.
        integrator: "explicit" or "semi-implicit".
    """

    alpha: float
    steps: int
    integrator: str

    @property
    def K(self) -> float:  # noqa: N802 (the paper's name)
        """Stiffness for one movement: alpha beta, beta = alpha/4."""
        return self.alpha**2 / 4

    def follow(self, push: Array, start_velocity: Array | float = 0.0) -> Array:
        """The path from z = 0 under `push` (M, D), shape (M + 1, D); velocity per movement, shape (D,)."""
        h, K, D = 1 / self.steps, self.K, self.alpha
        drive = np.zeros((self.steps + 1, push.shape[1]))
        if self.integrator == "explicit":
            drive[2:] = h * h * push[:-1]
            drive[1] = h * start_velocity
            recursion = [1.0, -(2 - h * D), 1 - h * D + h * h * K]
        else:
            drive[1:] = h * h * push
            drive[1] += (1 - h * D) * h * start_velocity
            recursion = [1.0, -(2 - h * D - h * h * K), 1 - h * D]
        return lfilter([1.0], recursion, drive, axis=0)

    def needed(self, z: Array) -> tuple[Array, Array]:
        """The push (M, D) under which `follow` draws the path `z` (M + 1, D), and its start velocity (D,).

        The exact inverse of the discrete scheme: what the integrator gets wrong, the push makes good. Where
        the scheme leaves one push open (the last of the explicit, the first of the semi-implicit), its
        acceleration is that of its neighbour.
        """
        h = 1 / self.steps
        step = (z[1:] - z[:-1]) / h
        bend = (step[1:] - step[:-1]) / h
        if self.integrator == "explicit":
            a, v = np.concatenate([bend, bend[-1:]]), step
        else:
            a, v = np.concatenate([bend[:1], bend]), np.concatenate([step[:1] - h * bend[:1], step[:-1]])
        return a + self.alpha * v + self.K * z[:-1], v[0]

    def kick(self) -> Array:
        """The path (M + 1, 1) of a pen that starts with velocity 1 and is pushed no more."""
        return self.follow(np.zeros((self.steps, 1)), 1.0)
