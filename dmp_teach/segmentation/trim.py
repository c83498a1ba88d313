"""Trim a pen-down span to the part that leaves ink: no landing, no rests, no swing into a lift."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from dmp_teach.segmentation.even_clock import Flags, PenMotion, find_runs
from dmp_teach.trajectory import Array

STILL_RISE = 0.015  # slower than this the height stands still [m/s]
REST_SPEED = 0.013  # a pen rests under this [m/s] ...
REST_PACE = 0.12  # ... or this share of the pace of its stroke if that is less
STOP_SPEED = 0.028  # a hand begins slowly and stops at once: under this it has stopped [m/s]
FALTER_SHARE = 0.6  # a hand that begins in fits and starts has not rested at this share of either
JOINED_PACE = 0.08  # a small move belongs to its stroke if, with its rest, it is so fast for it
KEPT_REST = 0.02  # the part of a rest beside a lift that is kept [s]
FILTER_EDGE = 0.05  # so near the edge of the recording a filter blurs moves and rests [s]
LANDING_FALL = 0.0005  # a hand that sinks or rises by more beside its writing lands or leaves [m]
LANDING_PAUSE = 0.15  # a fall so soon after the last one belongs to the same landing [s]
WRITING_PACE = 0.15  # writing is faster than this share of the letter's pace
TAP_DURATION = (
    0.05,
    1.5,
)  # a pen that is down so long between lifts, and rests, made a dot [s] ...
HOVERED = (0.008, 0.002)  # ... unless it then touches so near to there, and lower: it hovered [m]
HAND_RISE = 0.1  # a hand takes longer than this to rise; a marker may leap in one sample [s]
SHORTEST_MOVE = 0.001  # a shorter move draws no line, however often it is made [m]
TWITCH_SHARE = 0.01  # a move at either end under this share of the stroke is no writing ...
SWING_SHARE = 0.05  # ... nor is one under this that runs into the lift: a rested hand takes a swing
STEEPEST_MOVE = 0.2  # ... nor is one that goes up or down by more than this share of its length

Span = tuple[int, int]


def trim_to_writing(motion: PenMotion, spans: list[Span]) -> list[Span]:
    """Trim each span to its writing; drop those without any, by speed and never by length."""
    landed = [_without_flight(motion, a, b) for a, b in spans]
    pace = max((_pace(motion.speed[a:b]) for a, b in landed), default=0.0)
    kept: list[Span] = []
    for k, ((a, b), (_, lift)) in enumerate(zip(landed, spans, strict=True)):
        brisk = _pace(motion.speed[a:b]) > WRITING_PACE * pace
        if brisk and np.ptp(motion.path[a:b], axis=0).max() > SHORTEST_MOVE:
            kept.append(_crop(motion, a, b))
        elif kept and lift < len(motion.z) and _is_dot(motion, (a, b), landed[k + 1 :]):
            kept.append((a, b))
    return kept[1:] if len(kept) > 1 and _is_swing(motion, kept, spans[0]) else kept


def _is_dot(motion: PenMotion, tap: Span, later: list[Span]) -> bool:
    """Return whether a pen that hardly moved between two lifts made a dot, and did not hover."""
    shortest, longest = TAP_DURATION
    if not shortest < (tap[1] - tap[0]) * motion.dt < longest:
        return False
    if not later or later[0][1] - later[0][0] < 2:
        return True
    touch = later[0][0]
    away = np.linalg.norm(motion.path[touch] - motion.path[tap[1] - 1])
    above = np.median(motion.z[slice(*tap)]) - motion.z[touch]
    return not (away < HOVERED[0] and above > HOVERED[1])


def _is_swing(motion: PenMotion, kept: list[Span], first: Span) -> bool:
    """Return whether the first stroke is the swing of a resting hand into the hop to its letter.

    A marker that leaps is no hand: there the stroke is kept, for whoever looks for leaps.
    """
    (a, b), (begin, lift) = kept[0], first
    ways = [motion.speed[slice(*each)].sum() for each in kept]
    if begin > 0 or a == 0 or not lift - 1 <= b <= lift or ways[0] >= SWING_SHARE * max(ways):
        return False
    rise = motion.raw[b - 1 : b + max(1, round(HAND_RISE / motion.dt))]
    return bool(np.abs(np.diff(rise)).max() < 0.8 * np.ptp(rise))


def _pace(speed: Array) -> float:
    """Return the speed at which most of the way is made [m/s]: rests do not count."""
    way = float(speed.sum())
    return float(speed @ speed) / way if way > 0 else 0.0


def _without_flight(motion: PenMotion, a: int, b: int) -> Span:
    """Return the span without the rest of its landing, and of a flight too slow for a lift.

    A hand that hovers, or pauses while it lands, sinks once more before it writes.
    """
    z, rise, speed = motion.z[a:b], motion.rise[a:b], motion.speed[a:b]
    way = speed * motion.dt
    brisk = np.flatnonzero(speed >= 0.5 * _pace(speed))
    first = 0
    for start, end in _find_slopes(z, -rise > STILL_RISE / 2, way):
        if start <= max(brisk[0], first + LANDING_PAUSE / motion.dt):
            first = end
    climbs = [k for k, _ in _find_slopes(z, rise > STILL_RISE, way) if k >= brisk[-1]]
    return a + first, a + min([b - a, *(k + 1 for k in climbs)])


def _find_slopes(z: Array, climbing: Flags, way: Array) -> list[Span]:
    """Find runs of `climbing` (K,) that are steep for the `way` (K,) along the page."""
    return [
        (start, end)
        for start, end in find_runs(climbing)
        if abs(z[end - 1] - z[start]) > max(LANDING_FALL, STEEPEST_MOVE * way[start:end].sum())
    ]


def _crop(motion: PenMotion, a: int, b: int) -> Span:
    """Return a span from its first move to its last, with a moment of rest beside a lift."""
    speed, lifts = motion.speed[a:b], (a > 0, b < len(motion.z))
    moves = _find_moves(motion.z[a:b], speed, motion.dt, lifts)
    first_end, (last, end) = moves[0, 1], moves[-1]
    slow = REST_PACE * _pace(speed)
    # Before its first move a hand may only have faltered; the end of its last one may be a rest.
    falters = find_runs(speed[:first_end] > FALTER_SHARE * min(REST_SPEED, slow))[-1][0]
    start = falters + int(np.argmax(speed[falters:first_end] > min(REST_SPEED, slow)))
    moving = np.flatnonzero(speed[last:end] > min(STOP_SPEED, slow))
    end = last + int(moving[-1]) + 1 if len(moving) else end
    before, after = (round((KEPT_REST if lift else FILTER_EDGE) / motion.dt) for lift in lifts)
    start = max(0, start - before) if lifts[0] or start < before else start
    end = min(b - a, end + after) if lifts[1] or end > b - a - after else end
    return a + start, a + end


def _find_moves(z: Array, speed: Array, dt: float, lifts: tuple[bool, bool]) -> NDArray[np.int_]:
    """Find runs of samples (K,) that move and write, shape (M, 2); `lifts`: at either end."""
    pace = _pace(speed)
    moves = np.array(find_runs(speed > min(REST_SPEED, REST_PACE * pace)))
    way = np.array([speed[k:end].sum() * dt for k, end in moves])
    climb = np.array([np.ptp(z[k:end]) for k, end in moves])
    level = climb < np.maximum(LANDING_FALL, STEEPEST_MOVE * way)
    swings = (lifts[0] & (moves[:, 0] == 0)) | (lifts[1] & (moves[:, 1] == len(z)))
    # How long a move lasts, with the rest towards the longest one.
    before = np.append(moves[1:, 0], len(z)) - moves[:, 0]
    after = moves[:, 1] - np.append(0, moves[:-1, 1])
    durations = np.where(np.arange(len(moves)) < np.argmax(way), before, after)
    near = (way > JOINED_PACE * pace * dt * durations) & ~swings
    large = way > np.where(swings, SWING_SHARE, TWITCH_SHARE) * way.sum()
    return moves[((way > SHORTEST_MOVE) & level & (large | near)) | (way == way.max())]
