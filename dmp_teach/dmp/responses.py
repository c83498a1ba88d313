"""How a rollout answers to its goal and to its weights, as arrays that are only added."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp.checks import check_point
from dmp_teach.dmp.equation import Equation
from dmp_teach.dmp.fit import forcing
from dmp_teach.dmp.primitive import DMP
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.trajectory import Array


@dataclass(frozen=True, eq=False)
class Responses:
    """A rollout as sums of paths: one for each coordinate of its goal, one for each weight.

    The spring is linear, so that a rollout at the demonstration's sample times is affine in its
    goal g and, the goal held, in its weights w:

        y(t) = base(t) + sum_k (g - g0)_k to_goal_k(t)
        y(t) = base(t) + sum_n (w - w0)_n to_weights_n(t)

    In DMP* both sums add up. In the other forms a moved goal also stretches or turns what the
    weights draw: there one of the two is held as it was learned.

    Args:
        primitive: What was learned, with its goal g0 and its weights w0.
    """

    primitive: DMP

    @cached_property
    def base(self) -> Array:
        """The rollout as learned, shape (T, D) [m]."""
        return self.primitive.rollout().position

    @cached_property
    def to_goal(self) -> Array:
        """How the path moves with each coordinate of the goal, shape (D, T, D).

        Raises:
            SettingError: A similarity beyond the plane, whose turn is not affine in the goal, or
                of a closed stroke.
        """
        p, D = self.primitive, len(self.primitive.goal)
        if p.settings.transform == "similarity" and D > 2:
            raise SettingError(
                f"In {D} dimensions a similarity is not affine in its goal: draw each goal by "
                "rollout, or learn the movement as DMP*, transform='star'."
            )
        moved = [p.rollout(goal=p.goal + unit).position for unit in np.eye(D)]
        return np.array(moved) - self.base

    @cached_property
    def to_weights(self) -> Array:
        """How each coordinate of the path grows with its own weight, shape (N, T, D)."""
        p = self.primitive
        equation, offset = Equation(p.settings, p.steps), p.goal - p.start
        f = forcing(equation.kernels, equation.s, np.eye(len(p.weights)), None)
        alone = p.at_sample_times(equation.spring.follow(f))
        # What a forcing term of 1 adds to the input: K, or the goal offset in the original form.
        zero = np.zeros((1, len(offset)))
        K, end = equation.spring.K, np.zeros((1, 1))
        pushed, rest = (
            equation.transformation.input(each, offset, K, end) for each in (zero + 1, zero)
        )
        return alone.T[:, :, None] * (pushed - rest)

    def at(self, goal: ArrayLike | None = None, weights: ArrayLike | None = None) -> Array:
        """Return the path to a goal, or with other weights, or both, shape (T, D) [m].

        Args:
            goal: Shape (D,) [m]; as demonstrated if not given.
            weights: Shape (N, D); as learned if not given.

        Raises:
            TrajectoryError: A goal of another dimension, weights of another shape.
            SettingError: Both, where they multiply: all but DMP*.
        """
        p, path = self.primitive, self.base
        if goal is not None and weights is not None and not p.transformation.is_translation:
            raise SettingError(
                f"In the form {p.settings.transform!r} a moved goal multiplies what the weights "
                "draw: give a goal or weights, not both, or learn the movement as DMP*."
            )
        if goal is not None:
            shift = check_point("goal", goal, len(p.goal)) - p.goal
            path = path + np.tensordot(shift, self.to_goal, 1)
        if weights is not None:
            change = np.asarray(weights, dtype=float)
            if change.shape != p.weights.shape:
                raise TrajectoryError(
                    f"Weights have the shape {p.weights.shape}, a row for each kernel, but got "
                    f"{change.shape}."
                )
            path = path + np.einsum("nd,ntd->td", change - p.weights, self.to_weights)
        return path
