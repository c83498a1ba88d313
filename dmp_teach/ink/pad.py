"""Make recordings of the events of a pad: a mouse, a finger or a stylus.

A pad reports its pointer about 60 times a second, unevenly, sometimes twice at one time, and not
at all while the pointer rests; it does not see the pen in the air. So each stroke is
cleaned and sampled evenly, and gets a lift before it. The curve goes through every point that was
caught and nowhere beyond them: nothing is smoothed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Unpack

import numpy as np
import scipy
from numpy.typing import ArrayLike

from dmp_teach.errors import RecordingError
from dmp_teach.ink.pen_lifts import add_lifts
from dmp_teach.ink.recording import About, Recording
from dmp_teach.trajectory import Array, Trajectory

# Samples of a stroke, as even as those of motion capture [Hz].
PAD_SAMPLE_RATE = 120.0
# The usual time between two events of a pad [s].
PAD_FRAME = 1 / 60
# A pointer that is silent for longer stood still, and moved within the last frame [s].
LONGEST_MOVING_SILENCE = 0.15
# A longer silence is the clock's, not the hand's [s].
LONGEST_SILENCE = 2.0
# Events overtake each other by no more than this [s].
LONGEST_OVERTAKING = 0.02
# Between two strokes the pen is in the air for at least, and at most [s].
PAD_LIFT_DURATION = (0.15, 2.0)
# A pen that goes no farther than this made a dot [m], and was down for at least this long [s].
DOT_RADIUS = 0.0015
DOT_PRESS = 0.1
# Fewer points show no curve, unless it is as small as a comma [m].
FEWEST_CURVE_POINTS = 6
COMMA_SIZE = 0.01
# A corner or a bend of which more than this is cut off is not what was written [m].
LARGEST_CUT_OFF = 0.0015
# Fewer points in a second do not show how fast the pen went, only where [Hz].
LEAST_POINT_RATE = 30.0
# No pad is larger [m], no stroke takes longer [s] or has more points.
PAD_REACH = 1.0
LONGEST_PAD_STROKE = 60.0
MOST_PAD_POINTS = 20_000


@dataclass(frozen=True, eq=False)
class PadStroke:
    """One stroke as the pad caught it.

    Args:
        path: 2-D, evenly sampled, on the pad's clock, in metres of its sheet.
        pressure: How hard the pen was pressed, 0 to 1, shape (T,), or None where unknown.
        points: How many points were caught.
        unseen: How far the pen may have been from the line between two points, where the line
            turns most [m].
    """

    path: Trajectory
    pressure: Array | None
    points: int
    unseen: float = 0.0

    @property
    def is_dot(self) -> bool:
        """Whether the pen was put down and hardly moved."""
        return bool(
            np.linalg.norm(self.path.position - self.path.position[0], axis=1).max() <= DOT_RADIUS
        )

    @property
    def is_blurred(self) -> bool:
        """Whether the pen was too fast for the pad: bends are cut off, or points are few.

        A quick straight line is seen well by few points; a quick bow is not.
        """
        is_small = bool(np.ptp(self.path.position, axis=0).max() <= COMMA_SIZE)
        return not is_small and (self.points < FEWEST_CURVE_POINTS or self.unseen > LARGEST_CUT_OFF)

    @property
    def is_coarse(self) -> bool:
        """Whether too few points were caught to know the pen's speed."""
        return not self.is_dot and self.points < LEAST_POINT_RATE * self.path.duration


def pad_stroke(points: ArrayLike, pressed: bool = False) -> PadStroke:
    """Make a stroke of the events of a pad.

    Args:
        points: A row for each event: time [s], right and up [m], pressure 0 to 1; shape (K, 4).
        pressed: Whether the pad measures the pressure of the pen.

    Raises:
        RecordingError: No points, too many, values that are not finite or not on a pad, a clock
            that runs backwards, or a stroke that takes too long.
    """
    events = _checked(points)
    order = np.argsort(events[:, 0], kind="stable")
    t, rows = events[order, 0], events[order, 1:]
    # Of two events at one time the later one holds.
    last = np.append(np.diff(t) > 0, True)
    t, rows = t[last], rows[last]
    caught, unseen = len(t), _unseen(rows[:, :2])
    t = t[0] + np.concatenate([[0.0], np.cumsum(np.minimum(np.diff(t), LONGEST_SILENCE))])
    t, rows = _add_rests(t, rows)
    if t[-1] - t[0] > LONGEST_PAD_STROKE:
        raise RecordingError(
            f"The stroke took {t[-1] - t[0]:.0f} s, but one stroke takes at most "
            f"{LONGEST_PAD_STROKE:.0f} s."
        )
    t, rows = _hold(t, rows)
    even = np.linspace(t[0], t[-1], round((t[-1] - t[0]) * PAD_SAMPLE_RATE) + 1)
    drawn = scipy.interpolate.PchipInterpolator(t, rows)(even)
    pressure = np.clip(drawn[:, 2], 0.0, 1.0) if pressed else None
    return PadStroke(Trajectory(even, drawn[:, :2]), pressure, caught, unseen)


def pad_recording(strokes: Sequence[PadStroke], **about: Unpack[About]) -> Recording:
    """Make a recording of strokes in the order in which they came, on a clock that begins at 0.

    The time between two strokes is kept where a hand could have been in the air for so long, and
    bounded where a clock has jumped or the writer paused.

    Args:
        strokes: As the pad caught them.
        **about: The recording's `character`, `writer` and `baseline`.

    Raises:
        RecordingError: There is no stroke.
    """
    placed: list[Trajectory] = []
    for k, stroke in enumerate(strokes):
        clock = 0.0
        if k:
            lift = stroke.path.t[0] - strokes[k - 1].path.t[-1]
            clock = float(placed[-1].t[-1] + np.clip(lift, *PAD_LIFT_DURATION))
        placed.append(Trajectory(clock + stroke.path.t - stroke.path.t[0], stroke.path.position))
    pressures = [stroke.pressure for stroke in strokes if stroke.pressure is not None]
    return add_lifts(placed, pressures if len(pressures) == len(placed) else None, **about)


def _checked(points: ArrayLike) -> Array:
    """Return the events as numbers (K, 4); a RecordingError says why they are none."""
    try:
        events = np.asarray(points, dtype=float)
    except (TypeError, ValueError):
        events = np.empty(0)
    if events.ndim != 2 or events.shape[1:] != (4,) or not len(events):
        raise RecordingError(
            f"A stroke is rows of t, x, y and pressure, at least one, but got shape {events.shape}."
        )
    if len(events) > MOST_PAD_POINTS:
        raise RecordingError(
            f"The stroke has {len(events)} points, but one stroke has at most {MOST_PAD_POINTS}."
        )
    if not np.isfinite(events).all():
        raise RecordingError("The stroke has points that are no numbers; write it again.")
    farthest = float(np.abs(events[:, 1:3]).max())
    if farthest > PAD_REACH:
        raise RecordingError(
            f"The stroke has a point {farthest:.3g} m away, but a pad reaches {PAD_REACH} m "
            "at most."
        )
    back = float((np.maximum.accumulate(events[:, 0]) - events[:, 0]).max())
    if back > LONGEST_OVERTAKING:
        raise RecordingError(
            f"The pad's clock ran backwards by {back:.3g} s within a stroke; write it again."
        )
    return events


def _unseen(places: Array) -> float:
    """Return how much of the bends straight lines between points (K, 2) may cut off [m].

    A bow that turns by an angle a over a chord of length h rises h a / 8 above it.
    """
    chords = np.diff(places, axis=0)
    lengths = np.linalg.norm(chords, axis=1)
    chords, lengths = chords[lengths > 0], lengths[lengths > 0]
    if len(lengths) < 2:
        return 0.0
    along = (chords[1:] * chords[:-1]).sum(axis=1) / (lengths[1:] * lengths[:-1])
    turns = np.arccos(np.clip(along, -1.0, 1.0))
    return float((np.maximum(lengths[1:], lengths[:-1]) * turns).max() / 8)


def _add_rests(t: Array, rows: Array) -> tuple[Array, Array]:
    """Add a point where the pointer was silent: it stood still until a frame before it moved."""
    silent = np.flatnonzero(np.diff(t) > LONGEST_MOVING_SILENCE)
    moved = np.insert(t, silent + 1, t[silent + 1] - PAD_FRAME)
    return moved, np.insert(rows, silent + 1, rows[silent], axis=0)


def _hold(t: Array, rows: Array) -> tuple[Array, Array]:
    """Return the same, at least as long as a pen needs to make a dot."""
    if t[-1] - t[0] >= DOT_PRESS:
        return t, rows
    if len(t) > 1 and np.linalg.norm(rows[:, :2] - rows[0, :2], axis=1).max() > DOT_RADIUS:
        if t[-1] - t[0] < 2 / PAD_SAMPLE_RATE:
            t = t[0] + np.linspace(0, 2 / PAD_SAMPLE_RATE, len(t))
        return t, rows
    return np.append(t, t[0] + DOT_PRESS), np.vstack([rows, rows[-1]])
