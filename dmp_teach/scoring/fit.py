"""How one writing lies over another: one size, width, lean and turn for all, a place for each stroke."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from dmp_teach.scoring.linear_map import centred, linear_map, ratio
from dmp_teach.scoring.matching import Matching, squared, undone
from dmp_teach.scoring.resampling import features, rms_radius, size_of, spread
from dmp_teach.scoring.trimming import PLAIN, Line, Trim, ink_without, likely, line_without
from dmp_teach.trajectory import Array, Trajectory

POINTS = 96  # over all the ink of a letter
ROUNDS = 6  # of asking which point is the nearest
FLAT = 0.01  # ink that is flattened more than this is a line, and no number says how flat
CRUSHED = 0.2  # a letter of which less is left across its length is not narrow, and does not lean: it is another shape
CLEARLY = 0.6  # a piece is missing or too much if the rest is nearer by this factor than the whole [of the squares] ...
SEEN = (
    2e-5  # ... and by this much, a third of a pen's line [squared parts of the letter's size] ...
)
ALIKE = 0.04**2  # ... and this near: of another shape no piece is missing [the same]


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
        trim: A piece at an end of one stroke that only one side has, left out of all the other measures; or None.
        gap: How far the end of that stroke is from where it should be, for it [parts of the letter's size].
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
    trim: Trim | None = None
    gap: float = 0.0


@dataclass(frozen=True, eq=False)
class _Ink:
    """The ink of one pair: points (P, 2) and their directions (P, 2) on either side."""

    mine: Array
    my_way: Array
    yours: Array
    your_way: Array


@dataclass(frozen=True, eq=False)
class _Found:
    """A fit: the linear part (2, 2), each pair's shift (N, 2), and the squared distances both ways [m^2]."""

    inks: Sequence[_Ink]
    lines: Sequence[Line]
    linear: Array
    shifts: Array
    far: Sequence[tuple[Array, Array]]
    scale: float
    trim: Trim | None = None

    def cost(self, size: float) -> float:
        """How far it is from the writing, and a little of how much it changes the model."""
        unit = self.scale * size
        changed = ((self.linear / self.scale - np.eye(2)) ** 2).sum() + (
            self.places**2
        ).sum() / unit**2
        changed += 0.0 if self.trim is None else self.trim.part**2
        return (_rms(self.far) / unit) ** 2 + PLAIN * float(changed)

    @cached_property
    def places(self) -> Array:
        """How far each pair's ink is from its place, shape (N, 2) [m].

        A stroke lies where it should if its middle, its beginning or its end does: one that is too short or too large
        is not misplaced. Where it should is where most of the ink lies.
        """
        ends = [[a[e] - self.linear @ b[e] for e in (0, -1)] for a, b in self.lines]
        some = np.concatenate([self.shifts[:, None], np.array(ends)], axis=1)
        there = some.reshape(-1, 2)
        far = np.linalg.norm(some[:, :, None] - there, axis=3).min(axis=1)
        away = some - there[int(np.argmin(np.array([len(ink.yours) for ink in self.inks]) @ far))]
        return np.array([each[int(np.argmin(np.linalg.norm(each, axis=1)))] for each in away])


def fitted(matching: Matching, written: Sequence[Trajectory], model: Sequence[Trajectory]) -> Fit:
    """Fit the model's strokes to those of the writing that belong to them, by least squares.

    The linear part is one for all strokes, the shift is each stroke's own, so that a stroke in a wrong place is no
    lean, and a lean no wrong place. Points belong to the nearest ones, and are asked again after each fit (iterative
    closest point: Besl and McKay 1992), from the order along the lines and from an unchanged model, whichever ends
    nearer: so it is the ink that is compared, and not how it was drawn.
    """
    inks = _inks(matching, written, model)
    size = size_of(model)
    lines = [pair.laid.lines for pair in matching.pairs]
    whole = _laid_over(inks, lines, size, (0, ROUNDS))
    found = _trimmed(matching, inks, lines, size, whole)
    linear, far, scale, trim = found.linear, found.far, found.scale, found.trim
    unit = scale * size
    shapes = [float(np.sqrt((a.mean() + b.mean()) / 2)) / unit for a, b in far]
    worst = max(range(len(inks)), key=lambda k: far[k][1].max())
    point = found.inks[worst].yours[int(np.argmax(far[worst][1]))]
    gap = (
        0.0
        if trim is None
        else _gap(lines[trim.pair], trim, size * (1 if trim.missing else whole.scale))
    )
    return Fit(
        *_read(linear, scale),
        found.places / unit,
        np.array(shapes),
        _rms(far) / unit,
        (point, worst),
        trim,
        gap,
    )


def _laid_over(
    inks: Sequence[_Ink], lines: Sequence[Line], size: float, rounds: Sequence[int]
) -> _Found:
    """The best of the fits that begin with the order along the lines (P, 2) or an unchanged model."""
    mine, yours = (np.stack([centred(line[side]) for line in lines]) for side in (0, 1))
    scale = ratio(mine, yours)
    along, plain = linear_map(mine.reshape(-1, 2), yours.reshape(-1, 2), scale), scale * np.eye(2)
    starts = [
        (start, count) for count in rounds for start in ((along, plain) if count else (along,))
    ]
    tried = [_refined(inks, lines, start, scale, count) for start, count in starts]
    best = min(tried, key=lambda found: found.cost(size))
    return _refined(inks, lines, plain, scale, 0) if _is_crushed(best.linear) else best


def _trimmed(
    matching: Matching, inks: Sequence[_Ink], lines: Sequence[Line], size: float, whole: _Found
) -> _Found:
    """The fit without a piece that one side lacks, if that is clearly nearer than the fit of the `whole`."""

    def nearest(tried: Iterable[Trim]) -> _Found | None:
        found = [_without(matching, inks, lines, size, trim) for trim in tried]
        return min(found, key=lambda each: each.cost(size), default=None)

    if whole.cost(size) < SEEN:
        return whole
    best = nearest(likely(matching, lines, size))
    if best is None:
        return whole
    best = min(best, nearest(best.trim.beside()), key=lambda each: each.cost(size))
    near, far = best.cost(size), whole.cost(size)
    return best if near < min(CLEARLY * far, far - SEEN, ALIKE) else whole


def _without(
    matching: Matching, inks: Sequence[_Ink], lines: Sequence[Line], size: float, trim: Trim
) -> _Found:
    """The fit of what is left without a piece."""
    inks, lines = list(inks), list(lines)
    ink, (mine, yours) = inks[trim.pair], lines[trim.pair]
    if trim.missing:
        left = ink_without(len(ink.yours), trim, False)
        inks[trim.pair] = replace(ink, yours=ink.yours[left], your_way=ink.your_way[left])
        lines[trim.pair] = mine, line_without(yours, trim)
    else:
        left = ink_without(len(ink.mine), trim, matching.pairs[trim.pair].laid.backwards)
        inks[trim.pair] = replace(ink, mine=ink.mine[left], my_way=ink.my_way[left])
        lines[trim.pair] = line_without(mine, trim), yours
    return replace(_laid_over(inks, lines, size, (0,)), trim=trim)


def _gap(line: Line, trim: Trim, size: float) -> float:
    """How far the end without the piece is from the end with it [parts of the letter's size]."""
    longer = line[1] if trim.missing else line[0]
    end = 0 if trim.first else -1
    return float(np.linalg.norm(longer[end] - line_without(longer, trim)[end])) / size


def _inks(
    matching: Matching, written: Sequence[Trajectory], model: Sequence[Trajectory]
) -> list[_Ink]:
    """Points evenly over all the ink of every pair."""
    back = undone(matching.mirrored, matching.turn)
    (mine, my_way, my_stroke, _), (yours, your_way, your_stroke, _) = (
        spread(written, POINTS),
        spread(model, POINTS),
    )
    masks = [
        (np.isin(my_stroke, pair.strokes), np.isin(your_stroke, pair.others))
        for pair in matching.pairs
    ]
    return [_Ink(mine[a] @ back.T, my_way[a] @ back.T, yours[b], your_way[b]) for a, b in masks]


def _refined(
    inks: Sequence[_Ink], lines: Sequence[Line], linear: Array, scale: float, rounds: int
) -> _Found:
    """The fit from a linear part (2, 2) on, after so many rounds of asking which points belong together."""
    shifts = np.array([ink.mine.mean(axis=0) - linear @ ink.yours.mean(axis=0) for ink in inks])
    unit = scale * rms_radius(centred(np.concatenate([ink.yours for ink in inks]))) or 1.0
    for _ in range(rounds):
        nearest = [
            _nearest(ink, linear, shift, unit) for ink, shift in zip(inks, shifts, strict=True)
        ]
        pairs = [
            (
                np.concatenate([ink.mine, ink.mine[back]]),
                np.concatenate([ink.yours[there], ink.yours]),
            )
            for ink, (there, back) in zip(inks, nearest, strict=True)
        ]
        linear = linear_map(
            *(np.concatenate([centred(pair[side]) for pair in pairs]) for side in (0, 1)), scale
        )
        shifts = np.array([a.mean(axis=0) - linear @ b.mean(axis=0) for a, b in pairs])
    there = [ink.yours @ linear.T + shift for ink, shift in zip(inks, shifts, strict=True)]
    far = [_off_each_other(ink.mine, line) for ink, line in zip(inks, there, strict=True)]
    return _Found(inks, lines, linear, shifts, far, scale)


def _off_each_other(mine: Array, yours: Array) -> tuple[Array, Array]:
    """Squared distances of points (P, 2) from the line through others (Q, 2), and the reverse."""
    apart = squared(mine, yours)
    return _off(mine, yours, apart.argmin(axis=1)), _off(yours, mine, apart.argmin(axis=0))


def _off(points: Array, line: Array, vertex: np.ndarray) -> Array:
    """Squared distance of points (P, 2) from a line through points (Q, 2), given which of these is nearest, (P,)."""
    pieces = np.clip(vertex + np.array([[-1], [0]]), 0, len(line) - 2)
    begin, along = line[pieces], line[pieces + 1] - line[pieces]
    away, long = points - begin, (along**2).sum(axis=2)
    at = np.clip((away * along).sum(axis=2) / np.maximum(long, 1e-30), 0, 1)
    return ((away - at[..., None] * along) ** 2).sum(axis=2).min(axis=0)


def _nearest(ink: _Ink, linear: Array, shift: Array, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Which point of the model each point of the writing is nearest to, in place and direction, and the reverse."""
    way = ink.your_way @ linear.T
    way /= np.maximum(np.sqrt((way**2).sum(axis=1, keepdims=True)), 1e-12)
    apart = squared(
        features(ink.mine / unit, ink.my_way), features((ink.yours @ linear.T + shift) / unit, way)
    )
    return apart.argmin(axis=1), apart.argmin(axis=0)


def _is_crushed(linear: Array) -> bool:
    """Whether it makes a line of a letter, as for a line where a round letter should be."""
    long, short = np.linalg.svd(linear, compute_uv=False)
    return bool(short < CRUSHED * long)


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


def _rms(far: Sequence[tuple[Array, Array]]) -> float:
    """Root mean square of squared distances both ways, over all pairs [m]."""
    there, back = (np.concatenate([each[side] for each in far]) for side in (0, 1))
    return float(np.sqrt((there.mean() + back.mean()) / 2))
