"""Find where the pen touched the paper, from its height and its speed.

No fixed height tells a lift from writing: the marker rides on a finger, 16 to 85 mm over the
paper, and wanders. So a lift is measured from its own foot. In order:

1. height low-passed at 12 Hz, path at 10 Hz, on an even clock;
2. a lift begins where the height rises faster than `theta`, walked back to the foot of that rise,
   and counts if it gets `sigma` above that foot; it lasts until the height is back near the foot
   and falls no more, or has fallen by half and stands, for a marker may ride higher where it lands;
3. between lifts the pen is on the paper; each such span is trimmed to the part where it moves,
   after the last fall of the landing (people hover and pause while they land), and a span that
   never moves like writing is dropped.

So a stroke is what left a line, and not how long the pen lay on the paper: of the rest between a
touch and the first move only a moment is kept, and so before a lift.
"""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real

import numpy as np

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.segmentation.even_clock import PenMotion, Spans, find_runs, to_even_clock
from dmp_teach.segmentation.trim import STILL_RISE, trim_to_writing
from dmp_teach.trajectory import Array

LANDED_HEIGHT = 0.005  # a landed pen is so near the foot of its lift [m], or below half of it ...
LANDED_STAND = 0.08  # ... where the hand has turned meanwhile, and stands there for this long [s]
FOOT_HEIGHT = 0.0007  # a foot is walked up again while the pen is less than this above it [m]


def find_strokes(t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006) -> Spans:
    """Find the strokes of a recording, in the order in which they were written.

    Args:
        t: Times, strictly increasing, shape (T,) [s].
        position: The pen in its page's frame, z out of the page, shape (T, 3) [m].
        theta: A lift rises faster than this somewhere [m/s].
        sigma: A lift gets this far above its own foot [m].

    Returns:
        Pairs (start, end): a stroke is the samples `start:end`, at least 2 of them.

    Raises:
        SettingError: theta or sigma is not a positive number.
        RecordingError: Nothing was written.
    """
    check_thresholds(theta, sigma)
    motion = to_even_clock(t, position)
    hold = round(LANDED_STAND / motion.dt)
    lifted = _find_between_lifts(motion.z, motion.rise, theta, sigma, hold)
    landed = _without_landings(motion, lifted, theta, sigma, hold)
    spans = trim_to_writing(motion, landed) or trim_to_writing(motion, lifted)
    edges = np.searchsorted(t, t[0] + motion.dt * (np.array(spans).reshape(-1, 2) - 0.5)).tolist()
    strokes = tuple((a, b) for a, b in edges if b - a >= 2)
    if not strokes:
        raise RecordingError(
            "There is no writing here: the pen never moves along the page while it is down."
        )
    return strokes


def check_thresholds(theta: float, sigma: float) -> None:
    """Raise a SettingError unless both are positive numbers."""
    for name, value, unit in (("theta", theta, "m/s"), ("sigma", sigma, "m")):
        if isinstance(value, bool) or not isinstance(value, Real) or not 0 < value < np.inf:
            raise SettingError(f"{name} is {value!r}, but it must be a positive number [{unit}].")


def _without_landings(
    motion: PenMotion, spans: list[tuple[int, int]], theta: float, sigma: float, hold: int
) -> list[tuple[int, int]]:
    """Return the spans between lifts without their landings, by a look backwards in time.

    A landing is a lift seen backwards, and may be the only fast part of it. Where the first look
    saw the pen land, the second takes no beginning away.
    """
    touching = []
    for a, b in spans:
        z, rise = motion.z[a:b][::-1], -motion.rise[a:b][::-1]
        back = _find_between_lifts(z, rise, theta, sigma, hold, down=a > 0)
        touching += [(b - end, b - start) for start, end in reversed(back)]
    return touching


def _find_between_lifts(
    z: Array, rise: Array, theta: float, sigma: float, hold: int, *, down: bool = False
) -> list[tuple[int, int]]:
    """Find the spans of height (K,) between lifts; `down`: the pen is known to end down."""
    spans, landed = [], 0
    for start, _ in find_runs(rise > theta):
        if start < landed:
            continue
        foot = _find_foot(z, rise, start, landed)
        peak, landing = _find_landing(z, rise, foot, hold)
        if z[peak] - z[foot] > sigma and not (down and landing == len(z)):
            spans.append((landed, foot + 1))
            landed = landing
    return [*spans, (landed, len(z))] if landed < len(z) else spans


def _find_foot(z: Array, rise: Array, start: int, earliest: int) -> int:
    """Return the last sample on the paper before the rise that is fast at `start`."""
    foot = start
    while foot > earliest and rise[foot] > STILL_RISE:
        foot -= 1
    top = z[foot] + FOOT_HEIGHT
    while foot < start and z[foot + 1] < top:
        foot += 1
    return foot


def _find_landing(z: Array, rise: Array, foot: int, hold: int) -> tuple[int, int]:
    """Return the highest sample of a lift, and the first on the paper after it, or the end.

    The pen has landed where the height is near the foot and falls no more; or where it fell by
    half and then stands for `hold` samples, for the paper may seem higher there.
    """
    peak, still = foot, 0
    for k in range(foot, len(z)):
        peak = k if z[k] > z[peak] else peak
        lift = z[peak] - z[foot]
        still = still + 1 if k > peak and abs(rise[k]) < STILL_RISE else 0
        if still and z[k] < z[foot] + LANDED_HEIGHT:
            return peak, k
        if still >= hold and z[k] < z[foot] + 0.5 * lift:
            return peak, k - still + 1
    return peak, len(z)


def cut_at_times(t: Array, times: Sequence[tuple[float, float]]) -> Spans:
    """Return strokes from pairs (first, last) of times [s], both ends part of the stroke."""
    try:
        pairs = [(first, last) for first, last in times]
    except (TypeError, ValueError):
        raise RecordingError(
            f"Strokes are {times!r}, but must be pairs (first, last) of times [s], such as "
            "[(0.7, 2.4), (3.6, 8.2)]."
        ) from None
    return tuple((_sample(t, first), _sample(t, last) + 1) for first, last in pairs)


def _sample(t: Array, time: float) -> int:
    """Return the sample nearest to a time [s] of the recording."""
    half = float(np.diff(t).max()) / 2
    is_number = isinstance(time, Real) and not isinstance(time, bool)
    if not is_number or not t[0] - half <= time <= t[-1] + half:
        raise RecordingError(
            f"A cut is at {time!r} s, but must be a time of the recording, from {t[0]:.3f} to "
            f"{t[-1]:.3f} s."
        )
    return int(np.argmin(np.abs(t - float(time))))
