"""Fit a model to a writing: one size, width, lean and turn for all, a place for each stroke."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dmp_teach.scoring.linear_map import centre, fit_linear_map, size_ratio
from dmp_teach.scoring.matching import Matching
from dmp_teach.scoring.overlay import ways_to_nearest
from dmp_teach.scoring.resampling import Resampled, dot, features, rms_radius, squared_distances
from dmp_teach.scoring.trimming import (
    CHANGE_PENALTY,
    Line,
    Trim,
    find_likely_trims,
    kept_points,
    trim_line,
)
from dmp_teach.trajectory import Array

# Rounds of finding the nearest points.
CLOSEST_POINT_ROUNDS = 6
# Ink that is flattened more than this is a line, and no number says how flat.
FLATTEST = 0.01
# A letter of which less is left across is not narrow and does not lean: it is another shape.
CRUSHED_ASPECT = 0.2
# A piece is missing or too much if the rest is nearer than the whole by this factor [squared] ...
LARGEST_TRIMMED_SHARE = 0.6
# ... by this much, a third of a pen's line [squared parts of the letter's size] ...
LEAST_TRIM_GAIN = 2e-5
# ... and is this near: of another shape no piece is missing [the same].
LARGEST_TRIMMED_COST = 0.04**2


@dataclass(frozen=True, eq=False)
class Fit:
    """What must be done to the model to get the writing.

    Args:
        size: How many times as large.
        width: How many times as wide for its height.
        lean: How far it leans more to the right, its lines staying level [degrees].
        turn: How far it is turned to the left, lines and all [degrees].
        rise: How far its lines rise more to the right, what is upright staying so [degrees].
        places: How far each pair's ink then is from its place, shape (N, 2) [parts of the size].
        shape: How far all ink then is from the nearest of the model (rms, both ways) [the same].
        worst: Where that is most, a point of the model, and the number of its pair.
        trim: A piece at an end of one stroke that only one side has, left out of all the other
            measures; or None.
        gap: How far the end of that stroke is from where it should be [parts of the size].
    """

    size: float
    width: float
    lean: float
    turn: float
    rise: float
    places: Array
    shape: float
    worst: tuple[Array, int]
    trim: Trim | None = None
    gap: float = 0.0


@dataclass(frozen=True, eq=False)
class _Problem:
    """What is fitted: ink and aligned lines of every pair, the model's size [m], and a trim."""

    inks: Sequence[tuple[Resampled, Resampled]]
    lines: Sequence[Line]
    size: float
    trim: Trim | None = None

    def without(self, trim: Trim, backwards: bool) -> _Problem:
        """Return the same without a piece; `backwards`: the writing's stroke runs that way."""
        inks, lines = list(self.inks), list(self.lines)
        (mine, yours), (line, other) = inks[trim.pair], lines[trim.pair]
        if trim.missing:
            yours = yours.only(kept_points(len(yours.points), trim, False))
            other = trim_line(other, trim)
        else:
            mine = mine.only(kept_points(len(mine.points), trim, backwards))
            line = trim_line(line, trim)
        inks[trim.pair], lines[trim.pair] = (mine, yours), (line, other)
        return _Problem(inks, lines, self.size, trim)


@dataclass(frozen=True, eq=False)
class _Solution:
    """A fit: linear part (2, 2), shift of each pair (N, 2), squared distances both ways [m^2]."""

    problem: _Problem
    linear: Array
    shifts: Array
    far: Sequence[tuple[Array, Array]]
    scale: float

    @property
    def unit(self) -> float:
        """The size that the model then has [m]."""
        return self.scale * self.problem.size

    @property
    def rms(self) -> float:
        """Root mean square distance of the inks, both ways, over all pairs [m]."""
        there, back = (np.concatenate([each[side] for each in self.far]) for side in (0, 1))
        return float(np.sqrt((there.mean() + back.mean()) / 2))

    @cached_property
    def cost(self) -> float:
        """How far the model then is from the writing, and a little of how much it is changed."""
        changed = ((self.linear / self.scale - np.eye(2)) ** 2).sum()
        changed += (self.places**2).sum() / self.unit**2
        changed += 0.0 if self.problem.trim is None else self.problem.trim.part**2
        return (self.rms / self.unit) ** 2 + CHANGE_PENALTY * float(changed)

    @cached_property
    def places(self) -> Array:
        """How far each pair's ink is from its place, shape (N, 2) [m].

        A stroke lies where it should if its middle, its beginning or its end does: one that is too
        short or too large is not misplaced. Where it should is where most of the ink lies.
        """
        ends = [[a[e] - self.linear @ b[e] for e in (0, -1)] for a, b in self.problem.lines]
        shifts = np.concatenate([self.shifts[:, None], np.array(ends)], axis=1)
        tried = shifts.reshape(-1, 2)
        far = np.linalg.norm(shifts[:, :, None] - tried, axis=3).min(axis=1)
        weights = np.array([len(yours.points) for _, yours in self.problem.inks])
        away = shifts - tried[int(np.argmin(weights @ far))]
        return np.array([each[int(np.argmin(np.linalg.norm(each, axis=1)))] for each in away])


def fit_model(matching: Matching, written: Resampled, model: Resampled, size: float) -> Fit:
    """Fit the model's strokes to those of the writing that belong to them, by least squares.

    The linear part is one for all strokes, the shift is each stroke's own, so that a stroke in a
    wrong place is no lean, and a lean no wrong place. Points belong to the nearest ones, which are
    found again after each fit (iterative closest point: Besl and McKay 1992), from the order along
    the lines and from an unchanged model, whichever ends nearer: so it is the ink that is
    compared, and not how it was drawn.

    Args:
        matching: Which strokes belong together.
        written: The ink of the writing.
        model: The ink of the model.
        size: Of the model [m].
    """
    inks = _pair_inks(matching, written, model)
    lines = [pair.alignment.lines for pair in matching.pairs]
    whole = _solve(_Problem(inks, lines, size))
    best = _trimmed(matching, whole)
    trim = best.problem.trim
    worst = max(range(len(inks)), key=lambda k: best.far[k][1].max())
    point = best.problem.inks[worst][1].points[int(np.argmax(best.far[worst][1]))]
    gap = 0.0 if trim is None else _gap(lines[trim.pair], trim, size, whole.scale)
    return Fit(
        *_decompose(best.linear, best.scale),
        places=best.places / best.unit,
        shape=best.rms / best.unit,
        worst=(point, worst),
        trim=trim,
        gap=gap,
    )


def _pair_inks(
    matching: Matching, written: Resampled, model: Resampled
) -> list[tuple[Resampled, Resampled]]:
    """Return the ink of every pair, the writing's mirrored and turned back."""
    back = matching.orientation.undo().T
    upright = replace(written, points=written.points @ back, directions=written.directions @ back)
    return [
        (upright.only(upright.is_of(pair.strokes)), model.only(model.is_of(pair.others)))
        for pair in matching.pairs
    ]


def _solve(problem: _Problem, refine: bool = True) -> _Solution:
    """Return the best fit that begins with the order along the lines or an unchanged model."""
    mine, yours = (np.stack([centre(line[side]) for line in problem.lines]) for side in (0, 1))
    scale = size_ratio(mine, yours)
    along = fit_linear_map(mine.reshape(-1, 2), yours.reshape(-1, 2), scale)
    unchanged = scale * np.eye(2)
    tried = [_follow_closest_points(problem, along, scale, 0)]
    if refine:
        tried += [
            _follow_closest_points(problem, start, scale, CLOSEST_POINT_ROUNDS)
            for start in (along, unchanged)
        ]
    best = min(tried, key=lambda solution: solution.cost)
    long, short = np.linalg.svd(best.linear, compute_uv=False)
    if short < CRUSHED_ASPECT * long:
        return _follow_closest_points(problem, unchanged, scale, 0)
    return best


def _trimmed(matching: Matching, whole: _Solution) -> _Solution:
    """Return the fit without a piece that one side lacks, if that is clearly nearer."""
    problem = whole.problem
    if whole.cost < LEAST_TRIM_GAIN:
        return whole
    likely = find_likely_trims(matching, problem.lines, problem.size)
    if not likely:
        return whole

    def solve_without(trim: Trim) -> _Solution:
        backwards = matching.pairs[trim.pair].alignment.backwards
        return _solve(problem.without(trim, backwards), refine=False)

    solutions = {trim: solve_without(trim) for trim in likely}
    nearest = min(solutions, key=lambda trim: solutions[trim].cost)
    solutions |= {trim: solve_without(trim) for trim in nearest.refine()}
    best = min(solutions.values(), key=lambda solution: solution.cost)
    most = min(
        LARGEST_TRIMMED_SHARE * whole.cost, whole.cost - LEAST_TRIM_GAIN, LARGEST_TRIMMED_COST
    )
    return best if best.cost < most else whole


def _gap(line: Line, trim: Trim, size: float, scale: float) -> float:
    """Return how far the trimmed end is from the end as it is [parts of the letter's size]."""
    longer = line[1] if trim.missing else line[0]
    end = 0 if trim.first else -1
    unit = size if trim.missing else size * scale
    return float(np.linalg.norm(longer[end] - trim_line(longer, trim)[end])) / unit


def _follow_closest_points(
    problem: _Problem, linear: Array, scale: float, rounds: int
) -> _Solution:
    """Return the fit after rounds of closest points that begin with a linear part (2, 2)."""
    inks = [(mine.points, yours.points) for mine, yours in problem.inks]
    shifts = np.array([a.mean(axis=0) - linear @ b.mean(axis=0) for a, b in inks])
    unit = scale * rms_radius(centre(np.concatenate([yours for _, yours in inks]))) or 1.0
    before = None
    for _ in range(rounds):
        pairs, closest = [], []
        for ink, (a, b), shift in zip(problem.inks, inks, shifts, strict=True):
            there, back = _closest_points(*ink, linear, shift, unit)
            pairs.append((np.concatenate([a, a[back]]), np.concatenate([b[there], b])))
            closest += [there, back]
        if before is not None and all(map(np.array_equal, closest, before)):
            break
        before = closest
        linear = fit_linear_map(
            np.concatenate([centre(a) for a, _ in pairs]),
            np.concatenate([centre(b) for _, b in pairs]),
            scale,
        )
        shifts = np.array([a.mean(axis=0) - linear @ b.mean(axis=0) for a, b in pairs])
    far = []
    for (mine, yours), shift in zip(problem.inks, shifts, strict=True):
        fitted = replace(yours, points=yours.points @ linear.T + shift)
        to_model, to_writing = ways_to_nearest(mine, fitted)
        far.append((dot(to_model, to_model), dot(to_writing, to_writing)))
    return _Solution(problem, linear, shifts, far, scale)


def _closest_points(
    mine: Resampled, yours: Resampled, linear: Array, shift: Array, unit: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the closest point of the model for each of the writing, and the reverse."""
    directions = yours.directions @ linear.T
    directions /= np.maximum(np.sqrt(dot(directions, directions)), 1e-12)[:, None]
    apart = squared_distances(
        features(mine.points / unit, mine.directions),
        features((yours.points @ linear.T + shift) / unit, directions),
    )
    return apart.argmin(axis=1), apart.argmin(axis=0)


def _decompose(linear: Array, scale: float) -> tuple[float, float, float, float, float]:
    """Return size, width, lean, turn and rise; the turn is what upright and level lines share."""
    across, up = np.hypot(*linear[:, 0]), np.hypot(*linear[:, 1])
    right = float(np.degrees(np.arctan2(linear[0, 1], linear[1, 1])))
    left = float(np.degrees(np.arctan2(linear[1, 0], linear[0, 0])))
    turn = float(np.sign(left)) * min(abs(left), abs(right)) if left * right < 0 else 0.0
    size = float(np.sqrt(abs(np.linalg.det(linear))))
    flattest = FLATTEST * scale
    width = float(max(across, flattest) / max(up, flattest))
    return max(size, flattest), width, right + turn, turn, left - turn
