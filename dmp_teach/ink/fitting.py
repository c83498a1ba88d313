"""How one writing lies over another: one size, width, lean and turn for all, a place for each stroke."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.ink.matching import Matching, squared, undone
from dmp_teach.ink.points import features, rms_radius, spread
from dmp_teach.trajectory import Array, Trajectory

POINTS = 96  # over all the ink of a letter
STIFF = 0.005  # how firmly ink that tells nothing of width or lean, as an l, is taken for unchanged
ROUNDS = 6  # of asking which point is the nearest
FLAT = 0.01  # ink that is flattened more than this is a line, and no number says how flat
CRUSHED = 0.2  # a letter of which less is left across its length is not narrow, and does not lean: it is another shape
PLAIN = 0.0003  # of two fits that are as near, the one that changes the model less

SIDES = ("points", "others")
_Found = tuple[Array, Array, list[tuple[Array, Array]]]


@dataclass(frozen=True, eq=False)
class Fit:
    """What must be done to the model to get the writing.

    Args:
        size: How many times as large.
        width: How many times as wide for its height.
        lean: How far it leans more to the right, its lines staying level [degrees].
        turn: How far it is turned to the left, lines and all [degrees].
        rise: How far its lines rise more to the right, what is upright staying so [degrees].
        places: How far each pair's ink is from its place, after all that, shape (N, 2) [parts of the letter's size].
        shapes: How far its ink then is from the nearest of the model (rms, both ways), shape (N,) [the same].
        shape: The same over all ink.
        worst: Where that is most, a point of the model, and the number of its pair.
    """

    size: float
    width: float
    lean: float
    turn: float
    rise: float
    places: Array
    shapes: Array
    shape: float
    worst: tuple[Array, int]


@dataclass(frozen=True, eq=False)
class _Ink:
    """The ink of one pair: points (P, 2) and their directions (P, 2) on either side."""

    mine: Array
    my_way: Array
    yours: Array
    your_way: Array


def fitted(matching: Matching, written: Sequence[Trajectory], model: Sequence[Trajectory]) -> Fit:
    """Fit the model's strokes to those of the writing that belong to them, by least squares.

    The linear part is one for all strokes, the shift is each stroke's own, so that a stroke in a wrong place is no
    lean, and a lean no wrong place. Points belong to the nearest ones, and are asked again after each fit (iterative
    closest point: Besl and McKay 1992), from the order along the lines and from an unchanged model, whichever ends
    nearer: so it is the ink that is compared, and not how it was drawn.
    """
    inks = _inks(matching, written, model)
    size = float(np.ptp(np.concatenate([stroke.position for stroke in model]), axis=0).max())
    mine, yours = (np.stack([_centred(getattr(pair.laid, side)) for pair in matching.pairs]) for side in SIDES)
    scale = ratio(mine, yours)
    flat = mine.reshape(-1, 2), yours.reshape(-1, 2)
    along = _linear(*flat, scale)
    starts = along, along, scale * np.eye(2)
    found = [_refined(inks, start, scale, rounds) for start, rounds in zip(starts, (0, ROUNDS, ROUNDS), strict=True)]
    linear, shifts, far = min(found, key=lambda each: _cost(each, scale, size))
    if _is_crushed(linear):
        linear, shifts, far = _refined(inks, scale * np.eye(2), scale, 0)
    unit = scale * size
    shapes = [float(np.sqrt((a.mean() + b.mean()) / 2)) / unit for a, b in far]
    weights = np.array([len(ink.yours) for ink in inks])
    places = (shifts - [_median(axis, weights) for axis in shifts.T]) / unit
    worst = max(range(len(inks)), key=lambda k: far[k][1].max())
    point = inks[worst].yours[int(np.argmax(far[worst][1]))]
    return Fit(*_read(linear, scale), places, np.array(shapes), _rms(far) / unit, (point, worst))


def _inks(matching: Matching, written: Sequence[Trajectory], model: Sequence[Trajectory]) -> list[_Ink]:
    """Points evenly over all the ink of every pair."""
    back = undone(matching.mirrored, matching.turn)
    (mine, my_way, my_stroke, _), (yours, your_way, your_stroke, _) = spread(written, POINTS), spread(model, POINTS)
    masks = [(np.isin(my_stroke, pair.strokes), np.isin(your_stroke, pair.others)) for pair in matching.pairs]
    return [_Ink(mine[a] @ back.T, my_way[a] @ back.T, yours[b], your_way[b]) for a, b in masks]


def _refined(inks: Sequence[_Ink], linear: Array, scale: float, rounds: int) -> _Found:
    """The linear part (2, 2), each pair's shift (N, 2), and the squared distances both ways [m^2]."""
    shifts = np.array([ink.mine.mean(axis=0) - linear @ ink.yours.mean(axis=0) for ink in inks])
    unit = scale * rms_radius(_centred(np.concatenate([ink.yours for ink in inks])))
    for _ in range(rounds):
        nearest = [_nearest(ink, linear, shift, unit) for ink, shift in zip(inks, shifts, strict=True)]
        pairs = [
            (np.concatenate([ink.mine, ink.mine[back]]), np.concatenate([ink.yours[there], ink.yours]))
            for ink, (there, back) in zip(inks, nearest, strict=True)
        ]
        linear = _linear(*(np.concatenate([_centred(pair[side]) for pair in pairs]) for side in (0, 1)), scale)
        shifts = np.array([a.mean(axis=0) - linear @ b.mean(axis=0) for a, b in pairs])
    far = []
    for ink, shift in zip(inks, shifts, strict=True):
        apart = squared(ink.mine, ink.yours @ linear.T + shift)
        far.append((apart.min(axis=1), apart.min(axis=0)))
    return linear, shifts, far


def _nearest(ink: _Ink, linear: Array, shift: Array, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Which point of the model each point of the writing is nearest to, in place and direction, and the reverse."""
    way = ink.your_way @ linear.T
    way /= np.maximum(np.sqrt((way**2).sum(axis=1, keepdims=True)), 1e-12)
    apart = squared(features(ink.mine / unit, ink.my_way), features((ink.yours @ linear.T + shift) / unit, way))
    return apart.argmin(axis=1), apart.argmin(axis=0)


def _linear(mine: Array, yours: Array, scale: float) -> Array:
    """The matrix (2, 2) that brings centred points `yours` (P, 2) nearest to `mine`."""
    spread_of, together = yours.T @ yours, mine.T @ yours
    if not spread_of.any():
        return scale * np.eye(2)
    firm = STIFF * np.trace(spread_of) * np.eye(2)
    return np.linalg.solve(spread_of + firm, (together + scale * firm).T).T


def _is_crushed(linear: Array) -> bool:
    """Whether it makes a line of a letter, as for a line where a round letter should be."""
    long, short = np.linalg.svd(linear, compute_uv=False)
    return bool(short < CRUSHED * long)


def _cost(found: _Found, scale: float, size: float) -> float:
    """How far a fit is from the writing, and a little of how much it changes the model."""
    linear, _, far = found
    return (_rms(far) / (scale * size)) ** 2 + PLAIN * float(((linear / scale - np.eye(2)) ** 2).sum())


def _read(linear: Array, scale: float) -> tuple[float, float, float, float, float]:
    """Size, width, lean, turn and rise of a linear map: a turn is what upright and level lines have in common."""
    across, up = np.hypot(*linear[:, 0]), np.hypot(*linear[:, 1])
    right = float(np.degrees(np.arctan2(linear[0, 1], linear[1, 1])))
    left = float(np.degrees(np.arctan2(linear[1, 0], linear[0, 0])))
    turn = float(np.sign(left)) * min(abs(left), abs(right)) if left * right < 0 else 0.0
    size = float(np.sqrt(abs(np.linalg.det(linear))))
    return (
        max(size, FLAT * scale),
        float(max(across, FLAT * scale) / max(up, FLAT * scale)),
        right + turn,
        turn,
        left - turn,
    )


def ratio(mine: Array, yours: Array) -> float:
    """How many times as large centred points (..., 2) are; 1 where one side is a dot."""
    both = float((mine**2).sum()), float((yours**2).sum())
    return float(np.sqrt(both[0] / both[1])) if min(both) > 0 else 1.0


def _rms(far: Sequence[tuple[Array, Array]]) -> float:
    """Root mean square of squared distances both ways, over all pairs [m]."""
    there, back = (np.concatenate([each[side] for each in far]) for side in (0, 1))
    return float(np.sqrt((there.mean() + back.mean()) / 2))


def _centred(points: Array) -> Array:
    """Points (..., 2) about their mean."""
    return points - points.mean(axis=0)


def _median(values: Array, weights: Array) -> float:
    """The value (N,) that half of the weight lies on either side of."""
    order = np.argsort(values)
    sums = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(sums, 0.5 * sums[-1])])
