"""The connection from one letter to the next: one curve with the headings and speeds of both."""

from __future__ import annotations

import numpy as np
import scipy

from dmp_teach.letters.text.connection_points import (
    Meeting,
    ends_in_peak,
    find_meeting,
    headings,
    leaving_sample,
)
from dmp_teach.trajectory import Array, Trajectory, arc_lengths, interpolate_points, path_length

# The heading in which a pen leaves the peak of a v or w.
PEAK_EXIT_HEADING = np.radians(-38.0)
# An o that ends with a heading whose cosine is below this makes a small loop first, of this radius
# [x-heights], up to this heading.
LOOP_COSINE = -0.3
LOOP_RADIUS = 0.09
LOOP_EXIT_HEADING = np.radians(-8.0)
# The handles of the cubic between two letters, as shares of its chord.
CUBIC_HANDLES = (0.35, 0.28)
# A pen that rests at the start of a letter arrives at this slope, or this many times the chord's.
LEAST_ARRIVAL_SLOPE = 0.5
ARRIVAL_SLOPE_BY_CHORD = 1.25
# The curvature at which a connection has the pace of the letters [1 / x-height].
USUAL_CURVATURE = 2.0
CONNECTION_POINTS = 240


def link_strokes(before: Trajectory, after: Trajectory, x_height: float) -> Trajectory:
    """Link a stroke to the next letter's, whose clock is moved so that it follows."""
    a = leaving_sample(before, x_height)
    here = before.position[a]
    meeting = find_meeting(here, after, x_height)
    rest = _after_meeting(after, meeting)
    v, w = _velocity(before, a), _velocity(rest, 0)
    exit_heading, entry_heading = v, w
    if ends_in_peak(before.position, x_height):
        v, exit_heading = np.zeros(2), _unit_vector(PEAK_EXIT_HEADING)
    if meeting.rests:
        right, up = rest.position[0] - here
        slope = max(LEAST_ARRIVAL_SLOPE, ARRIVAL_SLOPE_BY_CHORD * up / max(right, 1e-9))
        w, entry_heading = np.zeros(2), np.array([1.0, slope])
    path = _curve((here, exit_heading), (rest.position[0], entry_heading), x_height)
    pace, step = (_mean_speed(before) + _mean_speed(after)) / 2, float(np.median(np.diff(before.t)))
    between = _timed(path, (v, w), pace, x_height, step)
    t, position = before.t[: a + 1], before.position[: a + 1]
    for part in (between, rest):
        t = np.concatenate([t, t[-1] + part.t[1:] - part.t[0]])
        position = np.concatenate([position, part.position[1:]])
    return Trajectory(t, position)


def _after_meeting(stroke: Trajectory, met: Meeting) -> Trajectory:
    """Return the movement from the meeting point: back to the start if need be, and to the end."""
    if not met.back:
        return Trajectory(stroke.t[met.sample :], stroke.position[met.sample :])
    back = slice(met.sample, 0, -1)
    t = np.concatenate([2 * stroke.t[0] - stroke.t[back], stroke.t])
    return Trajectory(t, np.concatenate([stroke.position[back], stroke.position]))


def _curve(leave: tuple[Array, Array], meet: tuple[Array, Array], x_height: float) -> Array:
    """Return a dense path (N, 2) from a point in a heading to a point in a heading, (2,) each."""
    (start, u), (goal, w) = ((point, _normalized(heading)) for point, heading in (leave, meet))
    loop = np.empty((0, 2))
    if u[0] < LOOP_COSINE:
        radius, points = LOOP_RADIUS * x_height, CONNECTION_POINTS // 4
        angle = (LOOP_EXIT_HEADING - np.arctan2(u[1], u[0])) % (2 * np.pi)
        turn = np.linspace(0, angle, points)[:, None]
        side = radius * np.array([-u[1], u[0]])
        loop = start + side - np.cos(turn) * side + np.sin(turn) * radius * u
        start, u = loop[-1], _unit_vector(LOOP_EXIT_HEADING)
    chord = float(np.linalg.norm(goal - start))
    one, two = start + CUBIC_HANDLES[0] * chord * u, goal - CUBIC_HANDLES[1] * chord * w
    cubic = scipy.interpolate.BPoly(np.array([start, one, two, goal])[:, None], [0, 1])
    return np.concatenate([loop[:-1], cubic(np.linspace(0, 1, CONNECTION_POINTS))])


def _timed(
    path: Array, velocities: tuple[Array, Array], pace: float, x_height: float, step: float
) -> Trajectory:
    """Return a connection with its times.

        q(t) = the quintic with given speeds, but no acceleration, at its ends
        dq   = (curvature + 1/4 / x_height)^(1/3) ds

    so that the speed follows the two-thirds power law and has the `velocities` of both letters
    [m/s].
    """
    arc = arc_lengths(path)
    turn = np.abs(np.gradient(np.unwrap(headings(path))))
    ease = (turn / np.maximum(np.gradient(arc), 1e-12) + 0.25 / x_height) ** (1 / 3)
    q = np.concatenate([[0.0], np.cumsum(np.diff(arc) * (ease[1:] + ease[:-1]) / 2)])
    v, w = (
        float(np.linalg.norm(velocity)) * e
        for velocity, e in zip(velocities, (ease[0], ease[-1]), strict=True)
    )
    duration = q[-1] / max(pace * (USUAL_CURVATURE / x_height) ** (1 / 3), (v + w) / 2)
    s = np.linspace(0, 1, max(4, int(np.ceil(duration / step))) + 1)
    v, w = v * duration / q[-1], w * duration / q[-1]
    at = scipy.interpolate.BPoly.from_derivatives([0, 1], [[0, v, 0], [1, w, 0]])(s)
    position = interpolate_points(at * q[-1], q, path)
    return Trajectory(s * duration, position)


def _velocity(stroke: Trajectory, k: int) -> Array:
    one, other = max(k - 1, 0), min(k + 1, len(stroke) - 1)
    return (stroke.position[other] - stroke.position[one]) / (stroke.t[other] - stroke.t[one])


def _mean_speed(stroke: Trajectory) -> float:
    return max(path_length(stroke.position) / stroke.duration, 1e-9)


def _unit_vector(heading: float) -> Array:
    return np.array([np.cos(heading), np.sin(heading)])


def _normalized(v: Array) -> Array:
    return v / max(float(np.linalg.norm(v)), 1e-12)
