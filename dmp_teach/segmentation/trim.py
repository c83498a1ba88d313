"""What of a pen that is down between two lifts is writing: not its landing, its rests, or the swing into a lift."""

from __future__ import annotations

import numpy as np

from dmp_teach.segmentation.even_clock import Motion, runs
from dmp_teach.trajectory import Array

CREEP = 0.015  # slower than this the height stands still [m/s]
IDLE = 0.013  # slower than this a pen of ordinary speed rests [m/s] ...
STOP = 0.028  # a hand begins slowly and stops at once: under this it has stopped [m/s]
SLOW = 0.12  # ... and one that is slow, at this share of the pace of its stroke
FALTERS = 0.6  # ... but a hand that begins in fits and starts has not rested while it goes at this share of either
HALT = 0.08  # a small move belongs to its stroke if it, with the rest between, is faster than this share of the pace
REST = 0.02  # so much of a rest between the touch and the first move, or the last move and the lift, is kept [s]
EDGE = 0.05  # so near to the edge of the recording a filter cannot tell a move from a rest [s]
AFLOAT = 0.006  # a span begins and ends no higher than this over its own middle [m] ...
SLANT = 0.12  # ... unless the height wanders there: by less than this share of the way that the pen makes
STEP = 0.0005  # a hand that sinks or rises by more than this beside its writing is still landing, or leaves [m]
SETTLE = 0.15  # a fall that begins so soon after the last one belongs to the same landing [s]
BRISK = 0.15  # writing is faster than this share of the letter's pace
TAP = (
    0.05,
    1.5,
)  # a pen that is down this long between two lifts, and hardly moves, made a dot [s]
OVER = (
    0.008,
    0.002,
)  # ... unless it then touches this near to there, and lower by this much: it hovered [m]
RISES = 0.1  # no hand is up in one sample of so many [s]
TINY = 0.001  # a move that is shorter than a line is wide draws none, however often it is made [m]
TWITCH = 0.01  # a move at either end that is shorter than this share of the stroke is no writing
SWING = 0.05  # the same for one that runs into the lift: a hand takes a swing after a rest
STEEP = 0.2  # nor is one that goes up or down by more than this share of its length


def written(motion: Motion, spans: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Each span cut to its writing; spans that hold none are dropped, by speed and never by length."""
    landed = [_landed(motion, a, b) for a, b in spans]
    pace = max((_pace(motion.speed[a:b]) for a, b in landed), default=0.0)
    kept = []
    for k, ((a, b), (_, lift)) in enumerate(zip(landed, spans, strict=True)):
        brisk = _pace(motion.speed[a:b]) > BRISK * pace
        if brisk and np.ptp(motion.path[a:b], axis=0).max() > TINY:
            kept.append(_cropped(motion, a, b))
        elif kept and lift < len(motion.z) and _is_dot(motion, (a, b), landed[k + 1 :]):
            kept.append((a, b))
    return kept[1:] if len(kept) > 1 and _is_swing(motion, kept, spans[0]) else kept


def _is_dot(motion: Motion, tap: tuple[int, int], later: list[tuple[int, int]]) -> bool:
    """Whether a pen that hardly moved between two lifts made a dot; it did not if it hovered over its next touch."""
    if not TAP[0] < (tap[1] - tap[0]) * motion.dt < TAP[1]:
        return False
    if not later or later[0][1] - later[0][0] < 2:
        return True
    touch = later[0][0]
    away = np.linalg.norm(motion.path[touch] - motion.path[tap[1] - 1])
    return not (away < OVER[0] and np.median(motion.z[slice(*tap)]) - motion.z[touch] > OVER[1])


def _is_swing(motion: Motion, kept: list[tuple[int, int]], first: tuple[int, int]) -> bool:
    """Whether the first stroke is the swing that a resting hand takes into the hop to its letter.

    A marker that leaps is no hand: there the stroke is kept, and told from by whoever looks for leaps.
    """
    (a, b), (begin, lift) = kept[0], first
    ways = [motion.speed[slice(*each)].sum() for each in kept]
    if begin > 0 or a == 0 or not lift - 1 <= b <= lift or ways[0] >= SWING * max(ways):
        return False
    rise = motion.raw[b - 1 : b + max(1, round(RISES / motion.dt))]
    return bool(np.abs(np.diff(rise)).max() < 0.8 * np.ptp(rise))


def _pace(speed: Array) -> float:
    """The speed at which most of the way is made [m/s]: rests, however long, do not count."""
    way = float(speed.sum())
    return float(speed @ speed) / way if way > 0 else 0.0


def _landed(motion: Motion, a: int, b: int) -> tuple[int, int]:
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


def _cropped(motion: Motion, a: int, b: int) -> tuple[int, int]:
    """From the first move to the last, rests at both ends left out but for `REST` beside a lift."""
    speed, lifts = motion.speed[a:b], (a > 0, b < len(motion.z))
    moves = _moves(motion.z[a:b], speed, motion.dt, lifts)
    last = np.arange(*moves[-1])
    moving = last[speed[last] > min(STOP, SLOW * _pace(speed))]
    start, end = (
        _begun(motion, a, b, int(moves[0, 0])),
        int((moving if len(moving) else last)[-1]) + 1,
    )
    rests = [round((REST if lift else EDGE) / motion.dt) for lift in lifts]
    start = max(0, start - rests[0]) if lifts[0] or start < rests[0] else start
    end = min(b - a, end + rests[1]) if lifts[1] or end > b - a - rests[1] else end
    return a + start, a + end


def _begun(motion: Motion, a: int, b: int, start: int) -> int:
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
