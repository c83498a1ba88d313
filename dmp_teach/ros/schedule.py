"""Schedule a motion for a real Fetch: the way from its start to the page, then the writing."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline

from dmp_teach.errors import JointError, ReachError, SettingError, TrajectoryError
from dmp_teach.progress import Progress
from dmp_teach.robot import (
    JOINTS,
    Joint,
    Model,
    Motion,
    compute_torques,
    describe_collision,
    find_nearest,
)
from dmp_teach.ros.untuck import TUCKED, find_way
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

LEAD = 6.0
"""Time of the first point [s]: to get to it, and for a hand to get to the stop button."""

APPROACH_PACE = 0.5
"""On the way to the page no joint goes faster than this part of its limit."""

# Points a second on the way to the page; the writing keeps its own [Hz].
_RATE = 24
# A leg of the way takes at least this [s].
_SHORTEST = 0.5
# What is beyond a limit by less is not [rad, m, N m].
_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False, repr=False)
class Schedule(Value):
    """What the arm's controller is sent: a point a row.

    Args:
        t: Times from the start of the goal, whole nanoseconds from `LEAD` on, shape (T,) [s].
        q: Joint positions in the order of `JOINTS`, shape (T, 8) [m, rad].
        velocity: Of the cubic spline through them, 0 at both ends, shape (T, 8) [m/s, rad/s].
        writing: The row where the motion itself begins.
    """

    t: Array
    q: Array
    velocity: Array
    writing: int


def make_schedule(
    motion: Motion,
    start: str | ArrayLike | None = "tucked",
    report: Progress = lambda done, total: None,
) -> Schedule:
    """Compute the points of the goal: the way to the page, then the motion; see `write_rosbag`."""
    _check(motion)
    t, q = motion.t, motion.q
    if start is None:
        way_t, way_q = np.empty(0), np.empty((0, len(JOINTS)))
    else:
        way_t, way_q = _timed(find_way(motion, _start(start), report))
        q = q + np.round((way_q[-1] - q[0]) / (2 * np.pi)) * 2 * np.pi
        t = t - t[0] + way_t[-1]
        way_t, way_q = way_t[:-1], way_q[:-1]
    t = np.round(1e9 * (LEAD + np.concatenate([way_t, t]))) / 1e9
    q = np.concatenate([way_q, q])
    velocity = CubicSpline(t, q, bc_type="clamped")(t, 1)
    velocity[[0, -1]] = 0.0
    _check_limits(t, q, velocity)
    near, _ = find_nearest(motion.q, JOINTS, motion.page)
    if near is not None:
        raise ReachError(f"{describe_collision(near)} Let Fetch().write plan the motion again.")
    return Schedule(t, q, velocity, len(way_t))


def _timed(way: Array) -> tuple[Array, Array]:
    """Return times (T,) [s] and joints (T, 8) along a way (N, 8), at rest at each, least jerk."""
    fastest = np.array([joint.velocity for joint in _joints()])
    t, q = [np.zeros(1)], [way[:1]]
    for one, other in pairwise(way):
        # A move with least jerk peaks at 1.875 of its mean speed (Flash and Hogan 1985).
        lasts = max(_SHORTEST, 1.875 * (np.abs(other - one) / fastest).max() / APPROACH_PACE)
        s = np.linspace(0, 1, 1 + int(np.ceil(lasts * _RATE)))[1:]
        t.append(t[-1][-1] + s * lasts)
        q.append(one + (10 * s**3 - 15 * s**4 + 6 * s**5)[:, None] * (other - one))
    return np.concatenate(t), np.concatenate(q)


def _joints() -> list[Joint]:
    """Return the arm's joints, with their limits."""
    model = Model.load()
    return [model.joint(name) for name in JOINTS]


def _start(start: str | ArrayLike) -> Array:
    """Return the joints before the way to the page."""
    if isinstance(start, str) and start == "tucked":
        return TUCKED
    try:
        q = np.asarray(start, dtype=float)
    except (TypeError, ValueError):
        q = np.empty(0)
    if q.shape != (len(JOINTS),) or not np.isfinite(q).all():
        raise SettingError(
            f'start is {start!r}, but must be "tucked", None, or the positions of the '
            f"{len(JOINTS)} joints {', '.join(JOINTS)} [m, rad]."
        )
    for joint, value in zip(_joints(), q, strict=True):
        if not joint.lower <= value <= joint.upper:
            raise SettingError(
                f"start has {joint.name} at {value:g}, but it must be between {joint.lower:g} and "
                f"{joint.upper:g}."
            )
    return q


def _check(motion: Motion) -> None:
    """Raise unless this is a motion of the Fetch's arm."""
    if not isinstance(motion, Motion):
        raise TrajectoryError(
            f"A bag is written from a Motion, as Fetch().write gives it, not from {motion!r:.60}."
        )
    if motion.joint_names != JOINTS:
        raise JointError(
            f"The motion moves {', '.join(motion.joint_names)}; the arm's controller takes "
            f"{JOINTS}."
        )
    Trajectory(motion.t, motion.q)


def _check_limits(t: Array, q: Array, velocity: Array) -> None:
    """Raise where a joint would have to do more than it can: this goes to a real robot."""
    joints = _joints()
    lower, upper, speed, effort = np.array(
        [(joint.lower, joint.upper, joint.velocity, joint.effort) for joint in joints]
    ).T
    for what, values, low, high, units in (
        ("position", q, lower, upper, ("m", "rad")),
        ("speed", velocity, -speed, speed, ("m/s", "rad/s")),
        ("torque", compute_torques(q, t, JOINTS), -effort, effort, ("N", "N m")),
    ):
        bad = (values < low - _ROUNDING) | (values > high + _ROUNDING)
        if bad.any():
            row, number = np.argwhere(bad)[0]
            joint = joints[number]
            raise TrajectoryError(
                f"The {what} of {joint.name} is {values[row, number]:.3f} "
                f"{units[joint.type != 'prismatic']} after {t[row]:.2f} s, but must be between "
                f"{low[number]:g} and {high[number]:g}; let Fetch().write plan the motion again."
            )
