"""The exponent of the power law of speed and curvature in ink, with an interval.

v = gain * curvature^(-beta), beta = 1/3 in a hand (Lacquaniti, Terzuolo and Viviani 1983). Both
sides come from the same noisy, smoothed path, so a regression alone is drawn to 1/3 by smoothing
and to 0 by noise (Maoz, Portugaly, Flash and Weiss 2006). So the same path is written with known
exponents and with the ink's own noise, and measured in the same way; the exponent that measures
like the ink is the ink's (indirect inference, Gourieroux, Monfort and Renault 1993).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from dmp_teach.arguments import checked
from dmp_teach.filtering import lowpass
from dmp_teach.trajectory import Array, Trajectory, arc_lengths
from dmp_teach.values import Value

# The clock on which ink is looked at [Hz].
INK_RATE = 120.0
# Low-passes that are tried; the one that brings known exponents back best is taken [Hz].
INK_CUTOFFS = (2.5, 3.5, 5.0, 7.0, 10.0, 14.0)
PADDING = 60
# Noise is seen in this band above the low-pass [cutoffs].
NOISE_BAND = (1.3, 2.5)
# The law is one of bends: not of straighter lines than this, nor of corners [letter sizes].
LARGEST_RADIUS, SMALLEST_RADIUS = 0.6, 1 / 40
# A path that is written with a known exponent is no straighter than this [letter sizes].
STRAIGHTEST_RADIUS = 2.5
# The pen comes to a rest or a corner, and leaves it, for this long [s].
TIME_OF_REST = 0.1
# A path that is written again is smoothed a little more: its noise is no bend [cutoffs].
CUTOFF_WRITTEN = 0.7
# Known exponents, and how often the noise is drawn for each.
KNOWN_EXPONENTS = np.array([0.2, 1 / 3, 0.5])
DRAWS = 4
# Of what noise and smoothing did, this share may be left, as on ellipses and letters of ours.
SHARE_LEFT = 1 / 3
# Below this, ink of any exponent measures the same.
LEAST_RESPONSE = 0.3
FEWEST_BEND_SAMPLES = 5
# An interval as wide as this says nothing.
WIDEST_INTERVAL = 1.0
# Samples that are left out together for the interval.
BLOCK_SAMPLES = 48


@dataclass(frozen=True, eq=False, repr=False)
class Exponent(Value):
    """An exponent with its interval of 95 %; NaN where there is too little ink to know.

    Args:
        value: The exponent.
        low: The lower end of the interval.
        high: The upper end.
    """

    value: float
    low: float
    high: float

    @classmethod
    @checked
    def around(cls, value: float, error: float, freedom: float) -> Exponent:
        """Return an estimate with its standard error and the degrees of freedom of that."""
        half = float(scipy.special.stdtrit(max(freedom, 1), 0.975)) * error
        return cls(float(value), float(value - half), float(value + half))


UNKNOWN = Exponent(np.nan, np.nan, np.nan)


@dataclass(frozen=True, eq=False, repr=False)
class Bends(Value):
    """A stroke as it was moved, smoothed.

    Args:
        path: On an even clock, shape (T, 2) [m].
        speed: Shape (T,) [m/s].
        curvature: Shape (T,) [1/m].
        is_used: Which samples the law is asked of, shape (T,).
        size: Of the letter [m].
        dt: Between samples [s].
    """

    path: Array
    speed: Array
    curvature: Array
    is_used: NDArray[np.bool_]
    size: float
    dt: float

    def logarithms(self) -> Array:
        """Return log curvature and log speed of the bends, each about its mean, shape (N, 2)."""
        pairs = np.log(np.column_stack([self.curvature, self.speed])[self.is_used])
        return pairs - pairs.mean(axis=0)


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredInk(Value):
    """Strokes through one low-pass, with what it makes of known exponents."""

    bends: tuple[Bends, ...]
    response: float
    offset: float
    error: float

    def exponent(self) -> Exponent:
        """Return the exponent of the ink, with an interval by leaving out a piece at a time."""
        whole, added = np.zeros(2), []
        for stroke in self.bends:
            pairs = stroke.logarithms()
            piece = np.flatnonzero(stroke.is_used) // BLOCK_SAMPLES
            moments = _moments(pairs)
            whole += moments
            added += [moments - _moments(pairs[piece != k]) for k in np.unique(piece)]
        pieces = np.array(added)
        raw = -whole[0] / whole[1]
        products, squares = (whole - pieces).T
        without = -products / np.maximum(squares, 1e-9)
        count = len(pieces)
        spread = np.sqrt((count - 1) / count * ((without - raw) ** 2).sum())
        value = (raw - self.offset) / self.response
        left = SHARE_LEFT * abs(value - raw) / 2
        # Of pieces that say little there may be many: freedom is that of as many equal ones.
        freedom = pieces[:, 1].sum() ** 2 / (pieces[:, 1] ** 2).sum() - 1
        found = Exponent.around(value, float(np.hypot(spread / self.response, left)), freedom)
        return found if count > 1 and found.high - found.low < WIDEST_INTERVAL else UNKNOWN


def measure_power_law(strokes: Sequence[Trajectory], sizes: Sequence[float]) -> MeasuredInk | None:
    """Measure strokes of letters of these sizes [m] through the low-pass that suits them best.

    Returns:
        None where there are too few bends, or too much noise, to tell one exponent from another.
    """
    inks = [(*_even(stroke), size) for stroke, size in zip(strokes, sizes, strict=True)]
    found = [_through(inks, cutoff) for cutoff in INK_CUTOFFS]
    return min((each for each in found if each), key=lambda each: each.error, default=None)


def _through(inks: list[tuple[Array, float, float]], cutoff: float) -> MeasuredInk | None:
    """Measure paths (T, 2) with their steps [s] and sizes [m] through one low-pass."""
    all_bends = [_bends_of(*ink, cutoff) for ink in inks]
    kept = [k for k, each in enumerate(all_bends) if each.is_used.sum() >= FEWEST_BEND_SAMPLES]
    bends = tuple(all_bends[k] for k in kept)
    if sum(each.is_used.sum() for each in bends) < 4 * FEWEST_BEND_SAMPLES:
        return None
    models = [_bends_of(*inks[k], CUTOFF_WRITTEN * cutoff) for k in kept]
    if not all(each.is_used.any() for each in models):
        return None
    noise = [_noise(inks[k][0], cutoff * inks[k][1]) for k in kept]
    draw = np.random.default_rng(1).normal
    slopes = np.zeros((len(KNOWN_EXPONENTS), DRAWS))
    for row, beta in zip(slopes, KNOWN_EXPONENTS, strict=True):
        paths = [_rewritten(each, beta) for each in models]
        for k in range(DRAWS):
            noisy = [
                _bends_of(path + level * draw(size=path.shape), each.dt, each.size, cutoff)
                for path, level, each in zip(paths, noise, bends, strict=True)
            ]
            row[k] = _slope(noisy)
    mean = slopes.mean(axis=1)
    response, offset = np.polyfit(KNOWN_EXPONENTS, mean, 1)
    if response < LEAST_RESPONSE:
        return None
    spread = slopes.std(axis=1, ddof=1).mean() / response
    error = np.hypot(spread, SHARE_LEFT * np.sqrt(((mean - KNOWN_EXPONENTS) ** 2).mean()))
    return MeasuredInk(bends, float(response), float(offset), float(error))


def _moments(pairs: Array) -> Array:
    """Return the sums of x y and of x x about the means of pairs (N, 2), shape (2,)."""
    if not len(pairs):
        return np.zeros(2)
    x, y = (pairs - pairs.mean(axis=0)).T
    return np.array([x @ y, x @ x])


def _bends_of(path: Array, dt: float, size: float, cutoff: float) -> Bends:
    """Smooth a path (T, 2) [m], and choose its bends.

    Left out are straight lines, and corners and rests (both ends of a stroke) with what lies
    beside them. No sample is left out for its speed, as that would bend the law.
    """
    smooth = lowpass(path, min(cutoff * dt, 0.45), min(PADDING, len(path) - 1))
    velocity = np.gradient(smooth, dt, axis=0)
    turn = np.gradient(velocity, dt, axis=0)
    speed = np.maximum(np.hypot(*velocity.T), 1e-9)
    curvature = np.abs(velocity[:, 0] * turn[:, 1] - velocity[:, 1] * turn[:, 0]) / speed**3
    is_rest = curvature * size > 1 / SMALLEST_RADIUS
    is_rest[[0, -1]] = True
    beside = np.ones(2 * round(TIME_OF_REST / dt) + 1)
    is_resting = np.convolve(is_rest, beside, mode="same") > 0
    is_bend = curvature * size > 1 / LARGEST_RADIUS
    return Bends(smooth, speed, curvature, is_bend & ~is_resting, size, dt)


def _rewritten(bends: Bends, beta: float) -> Array:
    """Return the path as it is written with another exponent, on the same clock (T', 2)."""
    bent = bends.curvature * bends.size
    speed = np.clip(bent, 1 / STRAIGHTEST_RADIUS, 1 / SMALLEST_RADIUS) ** -beta
    speed *= np.exp(np.log(bends.speed / speed)[bends.is_used].mean())
    step = np.diff(arc_lengths(bends.path))
    t = np.concatenate([[0.0], np.cumsum(2 * step / (speed[1:] + speed[:-1]))])
    return scipy.interpolate.CubicSpline(t, bends.path)(np.arange(0.0, t[-1], bends.dt))


def _slope(bends: Sequence[Bends]) -> float:
    """Return the exponent as a regression has it, with a gain for each stroke."""
    pairs = [each.logarithms() for each in bends if each.is_used.sum() >= FEWEST_BEND_SAMPLES]
    x, y = np.concatenate(pairs).T if pairs else np.zeros((2, 1))
    return float(-(x @ y) / max(x @ x, 1e-12))


def _noise(path: Array, cutoff: float) -> float:
    """Return how far samples scatter, as seen above the low-pass [m], cutoff [cycles a sample]."""
    white = np.random.default_rng(0).normal(size=(2000, 2))
    seen = [np.median(np.abs(_band(each, cutoff))) for each in (path, white)]
    return float(seen[0] / seen[1])


def _band(path: Array, cutoff: float) -> Array:
    """Return what of a path (T, 2) moves a little too quickly for the low-pass."""
    low, high = (
        lowpass(path, min(edge * cutoff, 0.45), min(PADDING, len(path) - 1)) for edge in NOISE_BAND
    )
    return high - low


def _even(stroke: Trajectory) -> tuple[Array, float]:
    """Return the path (T, 2) [m] on an even clock, and its step [s]."""
    count = max(round(stroke.duration * INK_RATE), 2 * FEWEST_BEND_SAMPLES)
    clock = np.linspace(stroke.t[0], stroke.t[-1], count + 1)
    return scipy.interpolate.CubicSpline(stroke.t, stroke.position)(clock), clock[1] - clock[0]
