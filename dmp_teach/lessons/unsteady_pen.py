"""A letter of two strokes by an unsteady hand: what is no lift looks like one to one threshold."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.ink import Recording
from dmp_teach.lessons.drawing import lesson_letter
from dmp_teach.segmentation import lowpass_hertz
from dmp_teach.trajectory import Array

# The hand trembles by so much [m], at these frequencies [Hz].
TREMBLE = 0.0003
TREMBLE_HERTZ = (5.2, 6.3, 7.4)
# The knock and the tilt, as shares of the lift: the knock is as fast, the tilt as high.
KNOCK_SHARE = 0.45
KNOCK_SECONDS = 0.018
TILT_SHARE = 1.05
# The tilt lasts for this part of the longer stroke.
TILT_PART = (0.1, 0.9)

Times = tuple[float, float]
"""When something begins and ends [s]."""


@dataclass(frozen=True)
class UnsteadyPen:
    """A recording with a height, and what happens in it.

    Args:
        recording: It knows its two strokes; `with_strokes(None)` has them found.
        height: As the rule for strokes smooths it, shape (T,) [m].
        rise: The rate of that, shape (T,) [m/s].
        lift: The pen is in the air.
        tilt: The hand tilts, and the marker on its finger goes up and down slowly.
        knock: Somebody knocks at the table.
    """

    recording: Recording
    height: Array
    rise: Array
    lift: Times
    tilt: Times
    knock: Times

    def fastest(self, times: Times, *, falls: bool = False) -> float:
        """Return the fastest rise between two times [m/s], or the fastest of rises and falls."""
        rise = self.rise[self._between(times)]
        return float((np.abs(rise) if falls else rise).max())

    def highest(self, times: Times) -> float:
        """Return how far the pen gets above where it was at the first of two times [m]."""
        heights = self.height[self._between(times)]
        return float(heights.max() - heights[0])

    def _between(self, times: Times) -> slice:
        """Return the samples between two times."""
        first, last = np.searchsorted(self.recording.t, times)
        return slice(int(first), int(last) + 1)


def disturb(character: str, lift_height: float, random: np.random.Generator) -> UnsteadyPen:
    """Return a letter of our alphabet, of two strokes, as an unsteady hand would have written it.

    Args:
        character: Its longer stroke takes more than a second, or the tilt would be as fast as a
            lift.
        lift_height: How high the pen is lifted [m].
        random: Places the knock and the trembling.
    """
    steady = lesson_letter(character)
    first, second = strokes = steady.strokes()
    short, long = sorted(strokes, key=lambda each: each.duration)
    t, knock_at = steady.t, short.t[0] + random.uniform(0.4, 0.6) * short.duration
    begin, end = (float(long.t[0] + part * long.duration) for part in TILT_PART)
    waves = [np.sin(2 * np.pi * (hertz * t + random.random())) for hertz in TREMBLE_HERTZ]
    z = steady.position[:, 2] * lift_height / steady.position[:, 2].max()
    z += TREMBLE * np.sum(waves, axis=0) / np.abs(np.sum(waves, axis=0)).max()
    tilted = np.sin(np.pi * np.clip((t - begin) / (end - begin), 0, 1)) ** 2
    knocked = np.exp(-0.5 * ((t - knock_at) / KNOCK_SECONDS) ** 2)
    z += lift_height * (TILT_SHARE * tilted + KNOCK_SHARE * knocked)
    position = np.column_stack([steady.position[:, :2], z])
    times = [(float(each.t[0]), float(each.t[-1])) for each in strokes]
    recording = replace(steady, position=position).with_strokes(times)
    dt = float(np.median(np.diff(t)))
    smooth = lowpass_hertz(z, dt, 12.0)
    lift = (float(first.t[-1]), float(second.t[0]))
    knock = (float(knock_at) - 0.1, float(knock_at) + 0.1)
    return UnsteadyPen(recording, smooth, np.gradient(smooth, t), lift, (begin, end), knock)
