"""Measure how a letter was moved and how it stands: smoothness, pace, size and slant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from dmp_teach.filtering import lowpass
from dmp_teach.scoring.resampling import POINTS_FOR_SLANT, resample_path
from dmp_teach.trajectory import Array, Trajectory, all_points, interpolate_points, path_length
from dmp_teach.values import Value

# The clock on which every movement is looked at [Hz].
MOVEMENT_RATE = 100.0
# A hand trembles at 4 to 8 Hz and writes slower; what is faster is noise of the camera or pad [Hz].
MOVEMENT_CUTOFF = 8.0
# A peak of speed stands this much of the highest one over the valleys beside it.
PEAK_PROMINENCE = 0.1
# Samples of the longest stroke (an hour), and of the quickest tap.
MOST_MOVEMENT_SAMPLES = 360_000
FEWEST_MOVEMENT_SAMPLES = 5
# Between points on which a line is seen to be shaky [parts of the letter's size] ...
SHAKE_SPACING = 0.01
# ... of which this number makes a piece that a hand draws in one sweep.
SWEEP_POINTS = 35


@dataclass(frozen=True, eq=False, repr=False)
class Movement(Value):
    """One writing in numbers.

    Args:
        strokes: The number of strokes.
        width: Of the ink [m].
        height: Of the ink [m].
        slant: See `slant` [degrees].
        duration: From the first touch to the last lift, lifts between strokes included [s].
        pace: Length of the ink over the time that the pen was down [m/s].
        smoothness: See `log_dimensionless_jerk`, no unit.
        peaks: See `count_velocity_peaks`.
        shake: See `shake`.
    """

    strokes: int
    width: float
    height: float
    slant: float
    duration: float
    pace: float
    smoothness: float
    peaks: int
    shake: float

    @property
    def size(self) -> float:
        """The larger side of the ink [m]."""
        return max(self.width, self.height)


def measure_movement(strokes: Sequence[Trajectory]) -> Movement:
    """Measure a writing; its strokes are 2-D, and at least one has a length."""
    moving = [stroke for stroke in strokes if path_length(stroke.position) > 0]
    velocities = [_velocity(stroke) for stroke in moving]
    width, height = np.ptp(all_points(strokes), axis=0)
    durations = [stroke.duration for stroke in moving]
    jerks = [log_dimensionless_jerk(*each) for each in velocities]
    return Movement(
        strokes=len(strokes),
        width=float(width),
        height=float(height),
        slant=slant(strokes),
        duration=float(strokes[-1].t[-1] - strokes[0].t[0]),
        pace=sum(path_length(stroke.position) for stroke in moving) / sum(durations),
        smoothness=float(np.average(jerks, weights=durations)),
        peaks=sum(count_velocity_peaks(velocity) for velocity, _ in velocities),
        shake=shake([stroke.position for stroke in moving]),
    )


def log_dimensionless_jerk(velocity: Array, dt: float) -> float:
    """Compute the smoothness of one stroke from its velocity (K, 2) [m/s]; no unit.

    -ln(T^3 / v_peak^2 * integral of |jerk|^2 dt), the larger the smoother: Balasubramanian,
    Melendez-Calderon, Roby-Brami and Burdet 2015, On the analysis of movement smoothness (LDLJ),
    with the jerk of the movement over the page in place of the second derivative of its speed, so
    that sharp bends count. A straight stroke of least jerk has -ln(720 / 1.875^2) = -5.3.
    """
    jerk = np.gradient(np.gradient(velocity, dt, axis=0), dt, axis=0)
    speed = np.linalg.norm(velocity, axis=1)
    whole = (len(velocity) * dt) ** 3 * (jerk**2).sum() * dt / speed.max() ** 2
    return float(-np.log(whole)) if whole > 0 else 0.0


def count_velocity_peaks(velocity: Array) -> int:
    """Count the peaks of speed in one stroke, from its velocity (K, 2) [m/s].

    Fluent writing has about one for each piece between two sharp bends (Plamondon 1995). One
    counts if it stands a tenth of the highest speed above the valleys beside it.
    """
    speed = np.concatenate([[0.0], np.linalg.norm(velocity, axis=1), [0.0]])
    prominent = PEAK_PROMINENCE * speed.max()
    turns, direction, extreme = 0, 1, 0.0
    for now in speed.tolist():
        if direction * (now - extreme) > 0:
            extreme = now
        elif direction * (extreme - now) >= prominent:
            turns, direction, extreme = turns + 1, -direction, now
    # Each peak but the last is followed by a valley.
    return (turns + 1) // 2


def shake(lines: Sequence[Array]) -> float:
    """Measure how far lines (T, 2) tremble about themselves [parts of the letter's size].

    The median distance of points evenly along the ink from cubics through a third of the letter's
    size around each (Savitzky and Golay 1964): a bend is followed, a tremble is not, and a few
    corners do not count.
    """
    size = float(np.ptp(np.concatenate(lines), axis=0).max())
    off = []
    for line in lines:
        points = resample_path(line, int(path_length(line) / (SHAKE_SPACING * size)) + 1)[0]
        if len(points) >= SWEEP_POINTS:
            off.append(np.linalg.norm(points - _sweep(points), axis=1))
    return float(np.median(np.concatenate(off))) / size if off else 0.0


def slant(strokes: Sequence[Trajectory]) -> float:
    """Measure how far a letter leans to the right of upright by its steep parts [degrees].

    The mean direction of the ink that is steeper than 45 degrees, up and down being one, each
    piece weighed by the square of its rise (after Bozinovic and Srihari 1989, who average
    near-vertical pieces). A letter without verticals, as z, leans by itself: compare it with the
    same letter only, or take `Score.lean`, which is the difference of two writings and compares
    their whole shapes.
    """
    points = [resample_path(stroke.position, POINTS_FOR_SLANT)[0] for stroke in strokes]
    step = np.concatenate([np.diff(each, axis=0) for each in points])
    steep = step[np.abs(step[:, 1]) > np.abs(step[:, 0])]
    rise = float((steep[:, 1] ** 2).sum())
    if rise == 0:
        return 0.0
    return float(np.degrees(np.arctan((steep[:, 0] * steep[:, 1]).sum() / rise)))


def _velocity(stroke: Trajectory) -> tuple[Array, float]:
    """Return the low-passed velocity (K, 2) [m/s] on a clock of 100 Hz, and its step [s]."""
    samples = int(min(stroke.duration * MOVEMENT_RATE, MOST_MOVEMENT_SAMPLES)) + 1
    samples = max(FEWEST_MOVEMENT_SAMPLES, samples)
    clock = stroke.t[0] + stroke.duration / (samples - 1) * np.arange(samples)
    path = interpolate_points(clock, stroke.t, stroke.position)
    path = lowpass(path, MOVEMENT_CUTOFF / MOVEMENT_RATE, min(30, samples - 1), order=4)
    dt = float(clock[1] - clock[0])
    return np.gradient(path, dt, axis=0), dt


@cache
def _sweep_filter() -> Array:
    """Return what fits a cubic to points in a row, shape (SWEEP_POINTS, SWEEP_POINTS)."""
    cubic = np.vander(np.linspace(-1, 1, SWEEP_POINTS), 4)
    return np.asarray(cubic @ np.linalg.pinv(cubic), dtype=float)


def _sweep(points: Array) -> Array:
    """Return each point on the cubic through the points about it, shape (N, 2)."""
    fit, half = _sweep_filter(), SWEEP_POINTS // 2
    inner = np.lib.stride_tricks.sliding_window_view(points, SWEEP_POINTS, axis=0) @ fit[half]
    ends = fit[:half] @ points[:SWEEP_POINTS], fit[-half:] @ points[-SWEEP_POINTS:]
    return np.concatenate([ends[0], inner, ends[1]])
