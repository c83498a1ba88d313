"""A letter as a sum of bumps: what each one adds to the push, and to the path."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from dmp_teach.dmp import Settings, textbook
from dmp_teach.lessons.drawing import lesson_letter
from dmp_teach.letters import Letter
from dmp_teach.trajectory import Array, rms

BUMP_NUMBER = 14


@dataclass(frozen=True, eq=False)
class Bumps:
    """A letter of one stroke as a sum of bumps, of which the up-and-down weights can be changed.

    Bumps are counted from 1 in order of time, lengths in metres.

    Args:
        t: Times, shape (T,) [s].
        demonstration: The person's path, shape (T, 2).
        path: The robot's, shape (T, 2).
        responses: How high the path goes at each time for each weight, shape (N, T).
        shares: How much of its weight each bump gives to f, x psi_i / sum psi, shape (N, T).
        weights: Of the height, shape (N,).
        needed: The f that the person's letter needs, shape (T,).
    """

    t: Array
    demonstration: Array
    path: Array
    responses: Array
    shares: Array
    weights: Array
    needed: Array

    def write(self, *changes: tuple[float, float]) -> Array:
        """Return the path with the weights of some bumps changed, (bump, metres), shape (T, 2)."""
        up = sum(
            (by * self.responses[int(bump) - 1] for bump, by in changes), np.zeros(len(self.t))
        )
        return self.path + np.column_stack([np.zeros(len(up)), up])

    def awake(self, bump: float) -> slice:
        """Return the part of the times at which a bump is awake."""
        times = np.flatnonzero(self.shares[int(bump) - 1] > 1e-3)
        return slice(int(times[0]), int(times[-1]) + 1)

    def wakes(self, bump: float) -> float:
        """Return when a bump wakes up [s]."""
        return float(self.t[self.awake(bump)][0])

    @property
    def hardest(self) -> int:
        """The bump that pushes most, up or down."""
        return 1 + int(np.argmax(np.abs(self.weights) * self.shares.max(axis=1)))

    def error(self, *changes: tuple[float, float]) -> float:
        """Return how far off the letter is with these changes, on average."""
        return rms(self.write(*changes) - self.demonstration)


@lru_cache(maxsize=16)
def learn_bumps(character: str) -> Bumps:
    """Learn a letter by locally weighted regression."""
    settings = Settings.star(n_kernels=BUMP_NUMBER, kernel="mollifier", kernel_width=1.6)
    letter = Letter.learn(lesson_letter(character), settings)
    [stroke], [primitive] = letter.strokes, letter.primitives
    t = primitive.times - primitive.times[0]
    x = primitive.kernels.phase.at(1 - t / primitive.duration)
    heights = primitive.kernels.heights(x)
    shares = x[:, None] * heights / heights.sum(axis=1, keepdims=True)
    return Bumps(
        t,
        stroke.position,
        letter.responses[0].base,
        letter.responses[0].to_weights[::-1, :, 1],
        shares.T[::-1],
        primitive.weights[::-1, 1],
        find_needed_forcing(stroke.position[:, 1], float(primitive.settings.alpha or 0)),
    )


def find_needed_forcing(y: Array, alpha: float) -> Array:
    """Return the f of equation 11 that a height needs at even times, shape (T,) [m]."""
    dy, ddy = map(np.array, textbook.differentiate(y.tolist()))
    beta, x = alpha / 4, np.linspace(1, 0, len(y))
    spring = alpha * (beta * (y[-1] - y) - dy)
    return (ddy - spring) / (alpha * beta) + (y[-1] - y[0]) * x
