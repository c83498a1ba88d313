"""Where the pen touched the paper, told from its height and its speed.

No fixed height tells a lift from writing: the marker rides on a finger, 16 to 85 mm over the paper, and wanders.
So a lift is measured from its own foot. In order:

1. height low-passed at 12 Hz, path at 10 Hz, on an even clock;
2. a lift begins where the height rises faster than `theta`, walked back to the foot of that rise, and counts if it
   gets `sigma` above that foot; it lasts until the height is back near the foot and falls no more, or has fallen by
   half and stands, for a marker may ride higher where it lands;
3. between lifts the pen is on the paper; each such span is cut to the part where it moves, after the last fall of
   the landing (people hover and pause while they land), and a span that never moves like writing is dropped.

So a stroke is what left a line, and not how long the pen lay on the paper: of the rest between a touch and the first
move only a moment is kept, and so before a lift.
"""

from dataclasses import dataclass
from numbers import Real

import numpy as np
from scipy.signal import butter, filtfilt

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.trajectory import Array

CREEP = 0.015  # slower than this the height stands still [m/s]
NEAR = 0.005  # a landed pen is this near to the foot of its lift, or nearer than a quarter of the lift [m]
HIGHER = 0.015  # nor does the marker stand higher than this over that foot, where the hand has turned meanwhile [m] ...
STANDS = 0.08  # ... and a height that stands for so long is no flight [s]
SKIN = 0.0007  # a foot is walked up again while the pen is less than this above it [m]
IDLE = 0.013  # slower than this a pen of ordinary speed rests [m/s] ...
STOP = 0.028  # a hand begins slowly and stops at once: under this it has stopped [m/s]
SLOW = 0.12  # ... and one that is slow, at this share of the pace of its stroke
FALTERS = 0.6  # ... but a hand that begins in fits and starts has not rested while it goes at this share of either
HALT = 0.08  # a small move belongs to its stroke if it, with the rest between, is faster than this share of the pace
REST = 0.02  # so much of a rest between the touch and the first move, or the last move and the lift, is kept [s]
EDGE = 0.05  # so near to the edge of the recording a filter cannot tell a move from a rest [s]
UNEVEN = 100  # a clock with more holes than this many samples to each that is there is broken
AFLOAT = 0.006  # a span begins and ends no higher than this over its own middle [m] ...
SLANT = 0.12  # ... unless the height wanders there: by less than this share of the way that the pen makes
STEP = 0.0005  # a hand that sinks or rises by more than this beside its writing is still landing, or leaves [m]
SETTLE = 0.15  # a fall that begins so soon after the last one belongs to the same landing [s]
BRISK = 0.15  # writing is faster than this share of the letter's pace
TAP = (0.05, 1.5)  # a pen that is down this long between two lifts, and hardly moves, made a dot [s]
TINY = 0.001  # a move that is shorter than a line is wide draws none, however often it is made [m]
TWITCH = 0.01  # a move at either end that is shorter than this share of the stroke is no writing
SWING = 0.05  # the same for one that runs into the lift: a hand takes a swing after a rest
STEEP = 0.2  # nor is one that goes up or down by more than this share of its length


@dataclass(frozen=True)
class _Motion:
    """The recording on an even clock: height, its rate, speed over the page, each of shape (K,)."""

    dt: float
    z: Array
    rise: Array
    speed: Array
    path: Array


def find_strokes(t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006) -> tuple[tuple[int, int], ...]:
    """The strokes of a recording, in the order in which they were written.

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
    motion = _evenly(t, position)
    lifted = _between_lifts(motion.z, motion.rise, theta, sigma, round(STANDS / motion.dt))
    spans = _written(motion, _landings_out(motion, lifted, theta, sigma)) or _written(motion, lifted)
    edges = np.searchsorted(t, t[0] + motion.dt * (np.array(spans).reshape(-1, 2) - 0.5)).tolist()
    strokes = tuple((a, b) for a, b in edges if b - a >= 2)
    if not strokes:
        raise RecordingError("There is no writing here: the pen never moves along the page while it is down.")
    return strokes


def check_thresholds(theta: float, sigma: float) -> None:
    """Raise a SettingError unless both are positive numbers."""
    for name, value, unit in (("theta", theta, "m/s"), ("sigma", sigma, "m")):
        if isinstance(value, bool) or not isinstance(value, Real) or not 0 < value < np.inf:
            raise SettingError(f"{name} is {value!r}, but it must be a positive number [{unit}].")


def smoothed(values: Array, dt: float, cutoff: float) -> Array:
    """`values` (K, ...) without what is faster than `cutoff` [Hz], not delayed."""
    if len(values) < 12:
        return values
    b, a = butter(2, min(cutoff * 2 * dt, 0.8))
    return filtfilt(b, a, values, axis=0, padlen=min(9, len(values) - 1))


def _evenly(t: Array, position: Array) -> _Motion:
    """The motion on an even clock from `t[0]` on, whatever the jitter of the recording's own."""
    dt = float(np.median(np.diff(t)))
    samples = round((t[-1] - t[0]) / dt) + 1
    if samples > UNEVEN * len(t):
        raise RecordingError(
            f"{len(t)} samples, mostly {dt:.3g} s apart, are spread over {t[-1] - t[0]:.6g} s: too uneven to find "
            "strokes. Cut the recording at its longest break."
        )
    clock = np.linspace(t[0], t[-1], max(2, samples))
    dt = float(clock[1] - clock[0])
    even = np.column_stack([np.interp(clock, t, axis) for axis in position.T])
    z, path = smoothed(even[:, 2], dt, 12.0), smoothed(even[:, :2], dt, 10.0)
    speed = np.linalg.norm(np.gradient(path, dt, axis=0), axis=1)
    return _Motion(dt, z, np.gradient(z, dt), speed, path)


def _landings_out(motion: _Motion, spans: list[tuple[int, int]], theta: float, sigma: float) -> list[tuple[int, int]]:
    """The spans between lifts without landings: a second look runs backwards in time.

    A landing is a lift seen backwards, and may be the only fast part of it. Where the first look saw the pen land, the
    second takes no beginning away.
    """
    touching = []
    hold = round(STANDS / motion.dt)
    for a, b in spans:
        back = _between_lifts(motion.z[a:b][::-1], -motion.rise[a:b][::-1], theta, sigma, hold, down=a > 0)
        touching += [(b - end, b - start) for start, end in reversed(back)]
    return touching


def _between_lifts(
    z: Array, rise: Array, theta: float, sigma: float, hold: int, *, down: bool = False
) -> list[tuple[int, int]]:
    """Spans of height (K,) between the rises that are lifts; `down`: the pen is known to be down at the end."""
    spans, landed = [], 0
    for start, end in runs(rise > theta):
        if start < landed:
            continue
        foot = _foot(z, rise, start, landed)
        peak, landing = _landing(z, rise, foot, end, hold)
        if z[peak] - z[foot] > sigma and not (down and landing == len(z)):
            spans.append((landed, foot + 1))
            landed = landing
    return [*spans, (landed, len(z))] if landed < len(z) else spans


def _foot(z: Array, rise: Array, start: int, earliest: int) -> int:
    """The last sample on the paper before the rise that is fast at `start`."""
    foot = start
    while foot > earliest and rise[foot] > CREEP:
        foot -= 1
    skin = z[foot] + SKIN
    while foot < start and z[foot + 1] < skin:
        foot += 1
    return foot


def _landing(z: Array, rise: Array, foot: int, risen: int, hold: int) -> tuple[int, int]:
    """The highest sample of a lift, and the first on the paper after it (the end, if it flies away).

    The pen has landed where the height is near the foot and falls no more; or where it fell by half and then stands
    for `hold` samples, for the paper may seem higher there.
    """
    peak, still = foot, 0
    for k in range(foot, len(z)):
        peak = k if z[k] > z[peak] else peak
        lift = z[peak] - z[foot]
        still = still + 1 if k > max(peak, risen) and abs(rise[k]) < CREEP else 0
        if still and z[k] < z[foot] + max(NEAR, 0.25 * lift):
            return peak, k
        if still >= hold and z[k] < z[foot] + min(HIGHER, 0.5 * lift):
            return peak, k - still + 1
    return peak, len(z)


def _written(motion: _Motion, spans: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Each span cut to its writing; spans that hold none are dropped, by speed and never by length."""
    landed = [_landed(motion, a, b) for a, b in spans]
    pace = max((_pace(motion.speed[a:b]) for a, b in landed), default=0.0)
    kept = []
    for (a, b), (_, lift) in zip(landed, spans, strict=True):
        brisk = _pace(motion.speed[a:b]) > BRISK * pace
        if brisk and np.ptp(motion.path[a:b], axis=0).max() > TINY:
            kept.append(_cropped(motion, a, b))
        elif kept and lift < len(motion.z) and TAP[0] < (b - a) * motion.dt < TAP[1]:
            kept.append((a, b))
    return kept


def _pace(speed: Array) -> float:
    """The speed at which most of the way is made [m/s]: rests, however long, do not count."""
    way = float(speed.sum())
    return float(speed @ speed) / way if way > 0 else 0.0


def _landed(motion: _Motion, a: int, b: int) -> tuple[int, int]:
    """The span without what is left of its landing, and of a flight at the end that was too slow for a lift.

    A hand that hovers, or pauses while it lands, sinks once more before it writes.
    """
    z, rise, speed = motion.z[a:b], motion.rise[a:b], motion.speed[a:b]
    moving = speed >= 0.5 * _pace(speed)
    low = np.flatnonzero((z <= np.median(z[moving]) + AFLOAT) | ~_afloat(z, speed * motion.dt))
    first, last = int(low[0]), int(low[-1])
    brisk = np.flatnonzero(moving[first : last + 1]) + first
    if not len(brisk):
        return a + first, a + last + 1
    for start, end in _slopes(z, -rise > CREEP / 2, speed * motion.dt):
        if start <= max(brisk[0], first + SETTLE / motion.dt):
            first = max(first, end)
    for start, _ in _slopes(z, rise > CREEP, speed * motion.dt):
        if start >= brisk[-1]:
            last = min(last, start)
    return a + first, a + last + 1


def _afloat(z: Array, way: Array) -> Array:
    """Where a pen of height (K,) must still come down, or has left: no hand wanders so much on so short a way."""
    gone = SLANT * np.cumsum(way)
    later, sooner = (np.minimum.accumulate((z + gone)[::-1])[::-1], np.minimum.accumulate(z - gone))
    return (z + gone > later + AFLOAT) | (z - gone > sooner + AFLOAT)


def _slopes(z: Array, climbing: Array, way: Array) -> list[tuple[int, int]]:
    """Runs (start, end) of `climbing` (K,) that are steep for the `way` (K,) along the page that the pen makes."""
    return [
        (start, end)
        for start, end in runs(climbing)
        if abs(z[end - 1] - z[start]) > max(STEP, STEEP * way[start:end].sum())
    ]


def _cropped(motion: _Motion, a: int, b: int) -> tuple[int, int]:
    """From the first move to the last, rests at both ends left out but for `REST` beside a lift."""
    speed, lifts = motion.speed[a:b], (a > 0, b < len(motion.z))
    moves = _moves(motion.z[a:b], speed, motion.dt, lifts)
    last = np.arange(*moves[-1])
    moving = last[speed[last] > min(STOP, SLOW * _pace(speed))]
    start, end = _begun(motion, a, b, int(moves[0, 0])), int((moving if len(moving) else last)[-1]) + 1
    rests = [round((REST if lift else EDGE) / motion.dt) for lift in lifts]
    start = max(0, start - rests[0]) if lifts[0] or start < rests[0] else start
    end = min(b - a, end + rests[1]) if lifts[1] or end > b - a - rests[1] else end
    return a + start, a + end


def _begun(motion: _Motion, a: int, b: int, start: int) -> int:
    """The first move of a span (a, b), which begins at `start`, with those before it that it only faltered after."""
    z, speed = motion.z[a:b], motion.speed[a:b]
    idle = min(IDLE, SLOW * _pace(speed))
    before = next(k for k, end in runs(speed > FALTERS * idle) if k <= start < end)
    first = before + int(np.argmax(speed[before : start + 1] > idle))
    way = speed[first:start].sum() * motion.dt
    swing = a > 0 and before == 0
    return start if swing or np.ptp(z[first : start + 1]) > max(STEP, STEEP * way) else first


def _moves(z: Array, speed: Array, dt: float, lifts: tuple[bool, bool]) -> Array:
    """Runs (start, end) of samples (K,) that move and write, shape (M, 2); `lifts`: whether a lift is at either end."""
    pace = _pace(speed)
    moves = np.array(runs(speed > min(IDLE, SLOW * pace)))
    way = np.array([speed[k:end].sum() * dt for k, end in moves])
    climb = np.array([np.ptp(z[k:end]) for k, end in moves])
    level = (climb < np.maximum(STEP, STEEP * way)) & ~_aloft(z, moves, way)
    swings = (lifts[0] & (moves[:, 0] == 0)) | (lifts[1] & (moves[:, 1] == len(z)))
    large = way > np.where(swings, SWING, TWITCH) * way.sum()
    near = (way > HALT * pace * dt * _lasts(moves, int(np.argmax(way)), len(z))) & ~swings
    return moves[((way > TINY) & level & (large | near)) | (way == way.max())]


def _lasts(moves: Array, main: int, samples: int) -> Array:
    """How long each of the moves (M, 2) lasts, with the rest on its side towards the `main` one (M,) [samples]."""
    before = np.append(moves[1:, 0], samples) - moves[:, 0]
    after = moves[:, 1] - np.append(0, moves[:-1, 1])
    return np.where(np.arange(len(moves)) < main, before, after)


def _aloft(z: Array, moves: Array, way: Array) -> Array:
    """Moves before the longest one that must still come down to it, and moves after it that have left (M,)."""
    main, gone = int(np.argmax(way)), np.concatenate([[0.0], np.cumsum(way)])
    falls = [z[k] - z[moves[main][0]] for k, _ in moves[:main]]
    rises = [z[end - 1] - z[moves[main][1] - 1] for _, end in moves[main + 1 :]]
    apart = np.concatenate([gone[main] - gone[:main], gone[main + 2 :] - gone[main + 1]])
    return np.insert(np.array([*falls, *rises]) > np.maximum(STEP, STEEP * apart), main, False)


def runs(flags: Array) -> list[tuple[int, int]]:
    """Where `flags` (K,) stay true: pairs (start, end), end not included."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int)))
    return [(int(a), int(b)) for a, b in edges.reshape(-1, 2)]
