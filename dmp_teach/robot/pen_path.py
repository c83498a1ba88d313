"""Connect strokes to one path of the pen: hover, touch, write, lift, and over to the next.

The path of the ink is the letter's own. Only the clock changes: every stroke begins and ends at
rest, because strokes that were cut at a lift start at up to half a metre a second, and no arm can
do that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy
from numpy.typing import NDArray

from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

MOTION_RATE = 240
"""Samples a second [Hz]."""

HOVER = 0.025
"""Height at which the nib waits and travels over the paper [m]."""

STROKE_RAMP = 0.2
"""Time of a stroke from rest to the speed of the recording, and back at its end [s]."""

LIFT_TIME = 0.3
"""Time of the pen up to the hover, or down [s]."""

LONGEST_LIFT = 1.5
"""Longer pauses between strokes are shortened to this [s]."""

# The greatest speed [m/s] and acceleration [m/s^2] over the paper.
_TRAVEL_SPEED = 0.3
_TRAVEL_ACCELERATION = 3.0


@dataclass(frozen=True, eq=False, repr=False)
class PenPlan(Value):
    """Where the nib is meant to be, sample by sample.

    Args:
        t: Times from 0, evenly spaced, shape (T,) [s].
        position: On the page, and the height over it, shape (T, 3) [m].
        pen_down: True exactly while the nib is on the letter, shape (T,).
    """

    t: Array
    position: Array
    pen_down: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Segment:
    """A part of the pen's path from rest to rest, in so many samples where nothing slows it.

    `at` gives places on the page, with their heights (n, 3) [m], for parts (n,) of its time from 0
    to 1; `down` says whether the nib is on the letter.
    """

    steps: int
    at: Callable[[Array], Array]
    down: bool = False


@dataclass(frozen=True, eq=False)
class PenPath:
    """The pen's path, to be followed on any clock; between segments it rests on a sample."""

    segments: tuple[Segment, ...]

    @property
    def rests(self) -> Array:
        """The samples at which the pen is at rest: where segments begin, and the end, (P + 1,)."""
        return np.cumsum([0, *(segment.steps for segment in self.segments)])

    def plan(self, samples: Array | None = None) -> PenPlan:
        """Sample the path at `MOTION_RATE`.

        `samples` (T,) says which sample of the unhurried plan is due at each of this one, in
        fractions but whole at every one of `rests`; None: all of them.
        """
        rests = self.rests
        samples = np.arange(rests[-1] + 1.0) if samples is None else samples
        position = np.empty((len(samples), 3))
        down = np.zeros(len(samples), bool)
        for segment, start in zip(self.segments, rests[:-1], strict=True):
            first = np.searchsorted(samples, start)
            stop = np.searchsorted(samples, start + segment.steps, side="right")
            # A sample between a stroke and the air is the stroke's.
            rows = slice(first + down[first], stop)
            position[rows] = segment.at((samples[rows] - start) / segment.steps)
            down[rows] = segment.down
        return PenPlan(np.arange(len(samples)) / MOTION_RATE, position, down)


def connect_strokes(strokes: tuple[Trajectory, ...]) -> PenPath:
    """Return the pen's path over strokes that lie on the page [m].

    A stroke takes its own duration and `STROKE_RAMP` more; a lift as long as in the recording, but
    no less than the pen needs and no more than `LONGEST_LIFT`.
    """
    first, last = strokes[0].position[0], strokes[-1].position[-1]
    segments = [_move(_above(first), _on(first), LIFT_TIME), _draw(strokes[0])]
    for before, stroke in pairwise(strokes):
        segments += [*_lift_over(before, stroke), _draw(stroke)]
    return PenPath((*segments, _move(_on(last), _above(last), LIFT_TIME)))


def _draw(stroke: Trajectory) -> Segment:
    """Return a stroke on the paper, at rest on its ends."""
    curve = interpolate(stroke)
    lasts, clock = ease_in_and_out(stroke.duration)

    def at(part: Array) -> Array:
        return _on(curve(np.clip(stroke.t[0] + clock(part * lasts), stroke.t[0], stroke.t[-1])))

    return Segment(_steps(lasts), at, down=True)


def interpolate(stroke: Trajectory) -> Callable[[Array], Array]:
    """Return a smooth curve through every sample of a stroke.

    A cubic spline; Fritsch and Carlson's where times are so uneven that the cubic would swing out
    between two samples by half a step or more.
    """
    cubic = scipy.interpolate.CubicSpline(stroke.t, stroke.position)
    swing = np.linalg.norm(
        cubic((stroke.t[:-1] + stroke.t[1:]) / 2)
        - (stroke.position[:-1] + stroke.position[1:]) / 2,
        axis=1,
    )
    step = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
    near = np.maximum(step, np.maximum(np.append(step[1:], 0), np.append(0, step[:-1])))
    if (swing > near / 2 + 1e-6).any():
        return scipy.interpolate.PchipInterpolator(stroke.t, stroke.position)
    return cubic


def ease_in_and_out(
    duration: float, ramp: float = STROKE_RAMP
) -> tuple[float, Callable[[Array], Array]]:
    """Return how long a clock runs that ends at `duration`, and what it shows at times (T,).

    It starts and stops gently: its speed rises as 3 u^2 - 2 u^3, u = t / ramp, and falls so too
    [s].
    """
    speed = min(1.0, duration / ramp)
    lasts = 2 * ramp + (duration - speed * ramp) / speed

    def clock(t: Array) -> Array:
        rise, fall = np.clip(t / ramp, 0, 1), np.clip((lasts - t) / ramp, 0, 1)
        shown = _risen(rise) + np.clip(t / ramp - 1, 0, lasts / ramp - 2) + 0.5 - _risen(fall)
        return speed * ramp * shown

    return lasts, clock


def _risen(u: Array) -> Array:
    """Return the integral of 3 u^2 - 2 u^3."""
    return u**3 - u**4 / 2


def _lift_over(before: Trajectory, after: Trajectory) -> list[Segment]:
    """Lift, travel, touch between two strokes."""
    start, end = before.position[-1], after.position[0]
    far = float(np.linalg.norm(end - start))
    # A move with least jerk peaks at 1.875 of its mean speed, and at 5.77 distances over its
    # duration squared.
    travel = max(1.875 * far / _TRAVEL_SPEED, np.sqrt(5.77 * far / _TRAVEL_ACCELERATION))
    needed = 2 * LIFT_TIME + travel
    longer = np.clip(after.t[0] - before.t[-1], needed, max(needed, LONGEST_LIFT)) / needed
    return [
        _move(_on(start), _above(start), LIFT_TIME * longer),
        _move(_above(start), _above(end), travel * longer),
        _move(_above(end), _on(end), LIFT_TIME * longer),
    ]


def _move(start: Array, end: Array, duration: float) -> Segment:
    """Return a straight move in the air with least jerk (Flash and Hogan 1985)."""

    def at(s: Array) -> Array:
        return start + (end - start) * (10 * s**3 - 15 * s**4 + 6 * s**5)[:, None]

    return Segment(_steps(duration), at)


def _steps(duration: float) -> int:
    """Return how many samples a segment takes, at least one; it lasts no less than `duration`."""
    return max(1, int(np.ceil(duration * MOTION_RATE - 1e-6)))


def _on(points: Array) -> Array:
    """Return points of the page (..., 2) on the paper (..., 3)."""
    return np.concatenate([points, np.zeros((*points.shape[:-1], 1))], axis=-1)


def _above(points: Array) -> Array:
    """Return points of the page (..., 2) at the hover height (..., 3)."""
    return _on(points) + np.array([0, 0, HOVER])
