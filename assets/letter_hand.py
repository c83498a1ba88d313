"""How a hand turns a drawn letter into a movement: a time law, lifts, a small wobble.

Along a stroke the plan follows the two-thirds power law (Lacquaniti, Terzuolo and Viviani, 1983),
speed ~ radius^(1/3), never gains or loses speed faster than the hand can, and rests at both ends.
It gets up to speed evenly over the first quarter of the way and slows down over the last: so the
largest speed of a round letter is 1.5 to 2.1 times its mean, as in the recordings of seven people.
Through the air it takes the minimum-jerk way (Flash and Hogan, 1985). Then the arm smooths the plan
in time, as muscles do: corners become small bends and every speed becomes a bell.
"""

import math
import random
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from letter_curves import Letter, Point, pieces
from scipy.ndimage import gaussian_filter1d

RATE = 120  # samples a second of the recordings
FINE = 10  # steps of the plan for each of them
STEP = 0.0002  # between points along the plan [m]
BEND = 0.030  # the radius at which a hand has its own pace [m]
FLAT = 0.200  # flatter bends than this are no faster [m]
SLOWEST = 0.008  # at which the plan leaves a stop [m/s]
CREEP = 0.035  # slower than this a hand only starts and stops [m/s]
RAMP = 0.25  # the share of the way on which a hand gets up to speed, or slows down


@dataclass(frozen=True)
class Hand:
    """What makes one person's writing.

    Args:
        writer: A pseudonym; with the letter it seeds the wobble.
        size: The height of a small letter without a stem [m].
        width: How wide letters are drawn, 1 being as the points say.
        slant: How far letters lean to the right: x gained for each y.
        pace: The speed in a bend of 30 mm radius [m/s].
        haste: The largest planned acceleration along the path [m/s^2].
        softness: How long the arm smooths, one standard deviation [s].
        wobble: How far the hand strays from the drawing [m].
        lift: How high the pen rises between strokes [m].
    """

    writer: str
    size: float
    width: float
    slant: float
    pace: float
    haste: float
    softness: float
    wobble: float
    lift: float


def write(
    character: str, strokes: Letter, hand: Hand
) -> tuple[np.ndarray, list[tuple[float, float]]]:
    """One letter as it is written, and when each of its strokes is on the paper.

    Args:
        character: The letter; with the writer it seeds the wobble.
        strokes: The points of each stroke in letter units, see `letter_curves`.
        hand: Who writes.

    Returns:
        Samples (T, 4): t [s], x, y, z [m]; and for each stroke its start and end [s].
    """
    chance = random.Random(f"{hand.writer} {character}")
    plan: list[np.ndarray] = []
    spans = []
    for points in strokes:
        stroke = _on_paper(points, hand, chance)
        if plan:
            plan.append(_through_air(plan[-1][-1], stroke[0], hand, chance))
        begin = sum(map(len, plan))
        plan.append(stroke)
        spans.append((begin, begin + len(stroke)))
    rest = round(3 * hand.softness * RATE) * FINE
    times = [((begin + rest) / (RATE * FINE), (end + rest) / (RATE * FINE)) for begin, end in spans]
    return _moved(np.vstack(plan), rest, hand, chance), times


def _moved(plan: np.ndarray, rest: int, hand: Hand, chance: random.Random) -> np.ndarray:
    """Return the plan (N, 3) as a camera sees the arm carry it out: samples (T, 4), to the um."""
    plan = np.pad(plan, ((rest, rest + 1 - len(plan) % FINE), (0, 0)), mode="edge")
    moved = gaussian_filter1d(
        plan, hand.softness * RATE * FINE, axis=0, mode="nearest", truncate=3.0
    )[::FINE]
    t = np.arange(len(moved)) / RATE
    moved[:, 2] += _wave(t, 0.0002, (2.3, 0.9), chance)
    moved[:, 0] -= moved[:, 0].min()
    return np.round(np.column_stack([t, moved]), 6) + 0.0  # never -0.0


def _on_paper(points: list[Point], hand: Hand, chance: random.Random) -> np.ndarray:
    """One stroke at every step of the plan, shape (N, 3) [m]."""
    drawn = [_evenly(_sized(piece, hand)) for piece in pieces(points)]
    speed = _speeds(drawn, hand)
    path = np.vstack(drawn)
    way = _way(path)
    path = path + np.column_stack(
        [_wave(way, hand.wobble, (0.23, 0.14, 0.09), chance) for _ in "xy"]
    )
    speed = speed * np.exp(_wave(way, 0.05, (0.13, 0.08), chance))
    when = np.concatenate([[0], np.cumsum(2 * np.diff(way) / (speed[1:] + speed[:-1]))])
    t = np.arange(0, when[-1], 1 / (RATE * FINE))
    return np.column_stack(
        [np.interp(t, when, path[:, 0]), np.interp(t, when, path[:, 1]), np.zeros(len(t))]
    )


def _through_air(
    start: np.ndarray, goal: np.ndarray, hand: Hand, chance: random.Random
) -> np.ndarray:
    """Return a lift (N, 3): up and down again, over to the next stroke on the way."""
    far = float(np.linalg.norm(goal - start))
    lasts = min(0.58, 0.36 + far + chance.uniform(-0.02, 0.02))
    s = np.linspace(0, 1, round(lasts * RATE * FINE) + 2)[1:-1]
    over = _minimum_jerk((s - 0.12) / 0.76)[:, None]
    high = hand.lift * chance.uniform(0.9, 1.1) + 0.06 * far
    air = start + (goal - start) * over
    air[:, 2] = high * _minimum_jerk(s / 0.45) * _minimum_jerk((1 - s) / 0.55)
    air[:, 0] += 0.15 * far * (over * (1 - over))[:, 0]  # nobody flies in a straight line
    return air


def _speeds(drawn: list[np.ndarray], hand: Hand) -> np.ndarray:
    """Return the planned speed at every point of a stroke, shape (N,) [m/s]."""
    speed = np.concatenate([_power_law(piece, hand) for piece in drawn])
    way = np.linspace(0, 1, len(speed))
    speed *= np.sqrt(np.clip(np.minimum(way, 1 - way) / RAMP, 0, 1))
    speed = np.maximum(speed, CREEP)
    ends = np.cumsum([0, *map(len, drawn)])
    for before, after, k in zip(drawn, drawn[1:], ends[1:], strict=False):
        a, b = before[-1] - before[-4], after[3] - after[0]
        turn = math.atan2(abs(a[0] * b[1] - a[1] * b[0]), a @ b)
        speed[k - 1 : k + 1] = max(SLOWEST, 0.35 * hand.pace * math.cos(turn / 2))
    speed[0] = speed[-1] = SLOWEST
    for order in (range(1, len(speed)), range(len(speed) - 2, -1, -1)):
        towards = 1 if order.step < 0 else -1
        for k in order:
            speed[k] = min(speed[k], math.sqrt(speed[k + towards] ** 2 + 2 * hand.haste * STEP))
    return speed


def _power_law(piece: np.ndarray, hand: Hand) -> np.ndarray:
    """Return the speed that the bends of a piece (N, 2) allow, shape (N,) [m/s]."""
    ahead = np.gradient(piece, axis=0)
    heading = gaussian_filter1d(
        np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0])), 0.003 / STEP, mode="nearest"
    )
    bend = np.abs(np.gradient(heading, STEP))
    return hand.pace * (BEND * (bend + 1 / FLAT)) ** (-1 / 3)


def _sized(piece: np.ndarray, hand: Hand) -> np.ndarray:
    """Points in letter units as this hand draws them [m]."""
    x, y = piece.T * hand.size
    return np.column_stack([hand.width * x + hand.slant * y, y])


def _evenly(line: np.ndarray) -> np.ndarray:
    """Return a polyline with a point about every `STEP`."""
    way = _way(line)
    even = np.linspace(0, way[-1], max(5, round(way[-1] / STEP) + 1))
    return np.column_stack([np.interp(even, way, line[:, i]) for i in range(2)])


def _way(line: np.ndarray) -> np.ndarray:
    """How far along a polyline its points are, shape (N,)."""
    return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])


def _minimum_jerk(s: np.ndarray) -> np.ndarray:
    """From 0 at s = 0 to 1 at s = 1, at rest before and after."""
    s = np.clip(s, 0, 1)
    return s**3 * (10 - 15 * s + 6 * s**2)


def _wave(
    s: np.ndarray, size: float, lengths: Iterable[float], chance: random.Random
) -> np.ndarray:
    """Return a slow wobble of about `size`: sines of these wavelengths, random phase and size."""
    parts = [(length, chance.uniform(0, math.tau), chance.uniform(0.5, 1.0)) for length in lengths]
    return size * sum(
        strength * np.sin(math.tau * s / length + phase) for length, phase, strength in parts
    )
