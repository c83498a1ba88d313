"""Movements chained into one, without a stop between them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.stepper import Plan
from dmp_teach.errors import TrajectoryError, kind_of
from dmp_teach.trajectory import Array, Trajectory

# Between two movements [s].
LONGEST_TRAVEL = 5.0


@checked
def chain(
    primitives: Iterable[DMP],
    overlap: float | Sequence[float] = 0.1,
    starts: Mapping[int, ArrayLike] | None = None,
    goals: Mapping[int, ArrayLike] | None = None,
) -> Trajectory:
    """Draw several movements as one (Kulvicius 2012): one spring with the input of each in turn.

        y'' = sum a_i (K_i (r_i - y) - D_i y') + what the moving goal needs,    sum a_i = 1

    r_i(t) is the point to which movement i attracts the pen, and the shares a_i overlap at a joint
    as kernels do: over the `overlap` they pass smoothly from the one that ends to the one that
    begins. Position and velocity of the one spring have no jump anywhere. Movements learned with
    the sigmoid phase keep their forcing to the last, as theirs do.

    Args:
        primitives: In the order in which they are drawn.
        overlap: How long before the end of one the next begins [s]; a negative one is a time for
            the way between them, in which the goal moves from the end of the one to the start of
            the next. One for all joints, or one for each.
        starts: Where movements begin, by their number counted from 0 [m].
        goals: Where they end [m].

    Returns:
        A trajectory that begins when the first demonstration began, with a sample for each step of
        the springs.

    Raises:
        TrajectoryError: Nothing to join, movements of different dimensions, no movement of that
            number, or an overlap that is longer than half of a movement.
    """
    primitives, starts, goals = tuple(primitives), dict(starts or {}), dict(goals or {})
    overlaps = _check(primitives, overlap, starts.keys() | goals.keys())
    parts: list[_Part] = []
    for number, primitive in enumerate(primitives):
        plan = Plan.of(primitive, starts.get(number), goals.get(number))
        parts.append(_Part(plan, parts[-1].end - overlaps[number - 1] if parts else 0.0))
    first = parts[0].plan
    now = np.array([first.start, first.start_velocity / first.duration])
    times, path, states = [0.0], [now[0]], np.array([np.full_like(now, np.nan), now])
    for part, following in zip(parts, [*parts[1:], None], strict=True):
        end = part.end if following is None else max(part.end, following.begin)
        for until in part.times(times[-1], end):
            t, h = times[-1], until - times[-1]
            if following is None:
                u, K, D = part.attraction(t, h)
            else:
                u, K, D = _blend(part, following, t, h)
            states = part.plan.spring.integrator.step(K, D, h, u, states)
            times.append(until)
            path.append(states[1, 0])
    return Trajectory(primitives[0].times[0] + np.array(times), np.array(path))


@dataclass(frozen=True, eq=False)
class _Part:
    """One of the movements that are chained, from the time `begin` on, in metres and seconds."""

    plan: Plan
    begin: float

    @property
    def end(self) -> float:
        return self.begin + self.plan.duration

    @property
    def h(self) -> float:
        return self.plan.duration / self.plan.spring.steps

    def times(self, t: float, end: float) -> Array:
        """Return when the steps from `t` to `end` end: its own, but for the first and the last."""
        first = np.floor((t - self.begin) / self.h + 1e-6) + 1
        last = np.ceil((end - self.begin) / self.h - 1e-6)
        own = self.begin + np.arange(first, last) * self.h
        return np.append(own, end) if last >= first else own

    def clock(self, t: float) -> float:
        """Return how many steps are over: a whole number wherever it is meant to be one."""
        clock = (t - self.begin) / self.h
        return float(round(clock)) if abs(clock - round(clock)) < 1e-6 else clock

    def attraction(self, t: float, h: float) -> tuple[Array, float, float]:
        """Return the input of the spring in a step of `h` from `t` on, K and D."""
        plan, T, K = self.plan, self.plan.duration, self.plan.spring.K
        u = (plan.input_at(self.clock(t)) + K * plan.start) / T**2
        return u, K / T**2, plan.spring.alpha / T

    def motion(self, t: float) -> tuple[Array, Array]:
        """Return where a pen is that draws this alone, and how fast."""
        clock = self.clock(t)
        here, later = self.plan.path_at(clock), self.plan.path_at(clock + 1)
        return self.plan.start + here, (later - here) / self.h


def _blend(part: _Part, following: _Part, t: float, h: float) -> tuple[Array, float, float]:
    """Blend two movements, while the one ends and the other begins.

    The share a of the second rises by 10 p^3 - 15 p^4 + 6 p^5, without a jump in its first two
    derivatives. A path from y_1 to y_2 by these shares is accelerated by a'' (y_2 - y_1) + 2 a'
    (y_2' - y_1') more than the two, and is faster by a' (y_2 - y_1), which the damper would brake.
    """
    a, b = sorted((following.begin, part.end))
    one, K, D = part.attraction(t, h)
    if t < a - 1e-9:
        return one, K, D
    other, K_2, D_2 = following.attraction(t, h)
    # An exact spring holds what is right in the middle of its step.
    t += part.plan.spring.integrator.middle * h
    p, span = min((t - a) / (b - a), 1.0) if b > a else 1.0, max(b - a, h)
    share = p**3 * (10 - 15 * p + 6 * p * p)
    rate, bend = 30 * (p * (1 - p)) ** 2 / span, 60 * p * (1 - p) * (1 - 2 * p) / span**2
    (y, v), (y_2, v_2) = part.motion(t), following.motion(t)
    K, D = K + share * (K_2 - K), D + share * (D_2 - D)
    return one + share * (other - one) + (bend + D * rate) * (y_2 - y) + 2 * rate * (v_2 - v), K, D


def _check(
    primitives: tuple[DMP, ...], overlap: float | Sequence[float], numbers: Iterable[int]
) -> Sequence[float]:
    """Return an overlap for each joint; raise a TrajectoryError where nothing can be chained."""
    wrong = [each for each in primitives if not isinstance(each, DMP)]
    if wrong or not primitives:
        what = kind_of(wrong[0]) if wrong else "nothing"
        raise TrajectoryError(f"Primitives are joined (DMP.imitate makes them), but got {what}.")
    sizes = sorted({len(each.start) for each in primitives})
    if len(sizes) > 1:
        raise TrajectoryError(
            f"Movements of {sizes[0]} and {sizes[-1]} dimensions cannot be joined: give all of "
            "them the same."
        )
    for number in numbers:
        if number not in range(len(primitives)):
            raise TrajectoryError(
                f"There is no movement {number!r} to start or end elsewhere; they are counted "
                f"from 0 to {len(primitives) - 1}."
            )
    most = min(each.duration for each in primitives) / 2
    joints = len(primitives) - 1
    given = list(overlap) if isinstance(overlap, Sequence) else [overlap] * max(joints, 1)
    fits = [isinstance(each, int | float) and -LONGEST_TRAVEL <= each <= most for each in given]
    if not all(fits) or len(given) < joints:
        raise TrajectoryError(
            f"overlap is {overlap!r}, but it must be between {-LONGEST_TRAVEL:g} s and {most:.3g} "
            f"s, half of the shortest movement: one number, or {joints}, one for each joint."
        )
    return given
