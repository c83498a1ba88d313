"""From one letter to the next without lifting the pen: one curve with the headings and the speeds of both."""

from __future__ import annotations

import numpy as np

from dmp_teach.letters.compose.geometry import long
from dmp_teach.letters.text.connection_points import Meeting, headings, leaving, meeting, peaks
from dmp_teach.trajectory import Array, Trajectory, ways

DIP = np.radians(-38.0)  # the heading in which a pen leaves the peak of a v or w
LOOP = 0.09  # the radius of the small loop of an o that ends leftwards, in x-heights
LEFTWARDS = -0.3  # the cosine of a heading that is leftwards
LOOP_TO = np.radians(-8.0)  # the heading after that loop
HANDLES = (0.35, 0.28)  # of the cubic between two letters, in parts of its chord
FLATTEST, BOWED = (
    0.5,
    1.25,
)  # a pen that rests at the start of a letter arrives at least so steep, or as its chord
USUAL_BEND = 2.0  # the curvature at which a connection has the pace of the letters, in 1 / x-height
DENSE = 240  # points of a connection, before it is given its times


def linked(before: Trajectory, after: Trajectory, x_height: float) -> Trajectory:
    """Two strokes as one.

    Args:
        before: The stroke so far.
        after: The stroke of the next letter; its clock is moved so that it follows.
        x_height: The height of a small letter without a stem [m].
    """
    a = leaving(before, x_height)
    here = before.position[a]
    met = meeting(here, after, x_height)
    rest = _after_meeting(after, met)
    v, w = _velocity(before, a), _velocity(rest, 0)
    out, towards = v, w
    if peaks(before.position, x_height):
        v, out = np.zeros(2), _towards(DIP)
    if met.rests:
        rise = rest.position[0] - here
        w, towards = (
            np.zeros(2),
            np.array([1.0, max(FLATTEST, BOWED * rise[1] / max(rise[0], 1e-9))]),
        )
    way = _curve((here, out), (rest.position[0], towards), x_height)
    pace, step = (_pace(before) + _pace(after)) / 2, float(np.median(np.diff(before.t)))
    between = _timed(way, (v, w), pace, x_height, step)
    t, position = before.t[: a + 1], before.position[: a + 1]
    for part in (between, rest):
        t = np.concatenate([t, t[-1] + part.t[1:] - part.t[0]])
        position = np.concatenate([position, part.position[1:]])
    return Trajectory(t, position)


def _after_meeting(stroke: Trajectory, met: Meeting) -> Trajectory:
    """What the pen does from where it meets a stroke: back to its start if it has to, and on to its end."""
    if not met.back:
        return Trajectory(stroke.t[met.sample :], stroke.position[met.sample :])
    back = slice(met.sample, 0, -1)
    t = np.concatenate([2 * stroke.t[0] - stroke.t[back], stroke.t])
    return Trajectory(t, np.concatenate([stroke.position[back], stroke.position]))


def _curve(leave: tuple[Array, Array], meet: tuple[Array, Array], x_height: float) -> Array:
    """From a point in a heading to a point in a heading, all (2,): points (N, 2), close to each other."""
    (start, u), (goal, w) = ((point, _unit(heading)) for point, heading in (leave, meet))
    loop = np.empty((0, 2))
    if u[0] < LEFTWARDS:  # an o that ends at its top: a small loop first
        radius = LOOP * x_height
        turn = np.linspace(0, (LOOP_TO - np.arctan2(u[1], u[0])) % (2 * np.pi), DENSE // 4)[:, None]
        side = radius * np.array([-u[1], u[0]])
        loop = start + side - np.cos(turn) * side + np.sin(turn) * radius * u
        start, u = loop[-1], _towards(LOOP_TO)
    far = float(np.linalg.norm(goal - start))
    one, two = start + HANDLES[0] * far * u, goal - HANDLES[1] * far * w
    s = np.linspace(0, 1, DENSE)[:, None]
    cubic = (
        (1 - s) ** 3 * start + 3 * (1 - s) ** 2 * s * one + 3 * (1 - s) * s**2 * two + s**3 * goal
    )
    return np.concatenate([loop[:-1], cubic])


def _timed(
    way: Array, ends: tuple[Array, Array], pace: float, x_height: float, step: float
) -> Trajectory:
    """When the pen is where on a connection.

        q(t) = the quintic with given speeds, but no acceleration, at its ends
        dq   = (curvature + 1/4 / x_height)^(1/3) ds

    so that the speed follows the two-thirds power law and has the `ends` of both letters, (2,) each [m/s].
    """
    bend = np.abs(np.gradient(np.unwrap(headings(way)))) / np.maximum(np.gradient(ways(way)), 1e-12)
    ease = (bend + 0.25 / x_height) ** (1 / 3)
    q = np.concatenate([[0.0], np.cumsum(np.diff(ways(way)) * (ease[1:] + ease[:-1]) / 2)])
    v, w = (
        float(np.linalg.norm(end)) * e for end, e in zip(ends, (ease[0], ease[-1]), strict=True)
    )
    lasts = q[-1] / max(pace * (USUAL_BEND / x_height) ** (1 / 3), (v + w) / 2)
    s = np.linspace(0, 1, max(4, int(np.ceil(lasts / step))) + 1)
    v, w = v * lasts / q[-1], w * lasts / q[-1]
    rest, change = 1 - v, w - v
    at = (
        v * s
        + (10 * rest - 4 * change) * s**3
        + (7 * change - 15 * rest) * s**4
        + (6 * rest - 3 * change) * s**5
    )
    return Trajectory(
        s * lasts, np.column_stack([np.interp(at * q[-1], q, axis) for axis in way.T])
    )


def _velocity(stroke: Trajectory, k: int) -> Array:
    one, other = max(k - 1, 0), min(k + 1, len(stroke) - 1)
    return (stroke.position[other] - stroke.position[one]) / (stroke.t[other] - stroke.t[one])


def _pace(stroke: Trajectory) -> float:
    """The mean speed of a stroke [m/s]."""
    return max(long(stroke.position) / stroke.duration, 1e-9)


def _towards(heading: float) -> Array:
    return np.array([np.cos(heading), np.sin(heading)])


def _unit(v: Array) -> Array:
    return v / max(float(np.linalg.norm(v)), 1e-12)
