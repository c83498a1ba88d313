"""How one writing lies over another: one size, width, lean and turn for all, a place for each stroke."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dmp_teach.ink.distances import warped
from dmp_teach.ink.matching import Pair
from dmp_teach.ink.points import length
from dmp_teach.trajectory import Array, Trajectory

STIFF = 0.01  # how firmly ink that tells nothing of width or lean, as an l, is taken for unchanged


@dataclass(frozen=True)
class Fit:
    """What must be done to the model to get the writing.

    Args:
        size: How many times as large.
        width: How many times as wide for its height.
        lean: How far it leans more to the right, its lines staying level [degrees].
        turn: How far it is turned to the left, lines and all [degrees].
        places: How far each pair's ink is from its place, after all that, shape (N, 2) [parts of the letter's size].
        shapes: How far each pair's shape is from the model's, after all that, by warping, shape (N,) [the same].
        shape: Root mean square of the same over all ink.
        worst: The pair whose shape is the farthest, and the point of the model there, shape (2,) [m].
    """

    size: float
    width: float
    lean: float
    turn: float
    places: Array
    shapes: Array
    shape: float
    worst: tuple[int, Array]


def fitted(pairs: Sequence[Pair], model: Sequence[Trajectory]) -> Fit:
    """Fit the model's strokes to those of the writing that belong to them, by least squares.

    Each pair is centred first, so that a stroke in a wrong place is no lean, and a lean no wrong place.
    """
    size = float(np.ptp(np.concatenate([stroke.position for stroke in model]), axis=0).max())
    ink = np.array([sum(length(model[k].position) for k in pair.others) for pair in pairs])
    weights = np.maximum(ink, 1e-3 * size) / np.maximum(ink, 1e-3 * size).sum()
    mine, yours = (np.stack([getattr(pair.laid, side) for pair in pairs]) for side in ("points", "others"))
    middles = mine.mean(axis=1), yours.mean(axis=1)
    mine, yours = mine - middles[0][:, None], yours - middles[1][:, None]
    linear, scale = _linear(mine, yours, weights)
    off = middles[0] - middles[1] @ linear.T
    off -= [_median(axis, weights) for axis in off.T]
    drawn = yours @ linear.T
    apart = np.array([warped(a, b) for a, b in zip(mine, drawn, strict=True)]) / (scale * size)
    worst = int(np.argmax(apart**2 * weights))
    where = int(np.argmax(np.linalg.norm(mine[worst] - drawn[worst], axis=1)))
    across = float(np.hypot(*linear[:, 0]))
    up = float(np.linalg.det(linear)) / across
    lean = float(np.degrees(np.arctan2(linear[:, 0] @ linear[:, 1] / across, up)))
    turn = float(np.degrees(np.arctan2(linear[1, 0], linear[0, 0])))
    return Fit(
        float(np.sqrt(across * abs(up))),
        across / abs(up),
        lean,
        turn,
        off / (scale * size),
        apart,
        float(np.sqrt((weights * apart**2).sum())),
        (worst, yours[worst][where] + middles[1][worst]),
    )


def _linear(mine: Array, yours: Array, weights: Array) -> tuple[Array, float]:
    """The matrix (2, 2) that brings centred `yours` (N, P, 2) nearest to `mine`, and the scale alone."""
    share = weights[:, None, None] / mine.shape[1]
    spread = np.einsum("npd,npe->de", share * yours, yours)
    together = np.einsum("npd,npe->de", share * mine, yours)
    scale = float(np.sqrt((share * mine**2).sum() / np.trace(spread)))
    firm = STIFF * np.trace(spread) * np.eye(2)
    return np.linalg.solve(spread + firm, (together + scale * firm).T).T, scale


def _median(values: Array, weights: Array) -> float:
    """The value (N,) that half of the weight lies on either side of."""
    order = np.argsort(values)
    return float(values[order][np.searchsorted(np.cumsum(weights[order]), 0.5)])
