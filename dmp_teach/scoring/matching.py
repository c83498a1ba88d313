"""Match the strokes of two writings by where they are and how they look.

Order, direction and number are never assumed. Both letters are resampled at equal arc length,
moved to their centroids and scaled to one size; `grouping` then finds which strokes are the same
part of the letter. If the numbers differ, the letters are also laid over each other as if a stroke
were missing; if the letter is far from the other in every lean, it is tried mirrored and turned.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from dmp_teach.scoring.alignment import Alignment, align
from dmp_teach.scoring.arguments import LetterLike, to_strokes
from dmp_teach.scoring.grouping import DOT_LENGTH, Group, group_strokes
from dmp_teach.scoring.resampling import (
    POINTS_TO_MATCH,
    Resampled,
    features,
    resample,
    squared_distances,
)
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

# Every second point is enough to see how a letter leans.
COARSE_STEP = 2
TRIED_SHEARS = np.array(
    [[[width, 0], [lean, 1]] for width in (0.5, 0.7, 1, 1.4, 2) for lean in np.linspace(-1, 1, 9)]
)
# A letter this near in some lean and width is neither mirrored nor turned [radii].
NEAR_UPRIGHT = 0.15
# Another is mirrored or turned if that leaves less than this of its distance upright ...
LARGEST_VIEWED_SHARE = 0.6
# ... and is nearer by this much [radii], and twice as much with all strokes backwards.
LEAST_VIEW_GAIN = 0.1
# Up to this number of strokes any may be missing.
MOST_STROKES_LEFT_OUT = 6


@dataclass(frozen=True)
class Orientation:
    """How a letter stands on the page.

    Args:
        mirrored: Whether left and right are exchanged.
        turn: By how many quarters it is turned to the left, mirrored or not: 0, 1, 2 or 3.
    """

    mirrored: bool
    turn: int

    def undo(self) -> Array:
        """Return the matrix (2, 2) that brings mirrored and then turned points back."""
        cos, sin = (1, 0, -1, 0)[self.turn], (0, 1, 0, -1)[self.turn]
        mirror = np.array([[-1.0 if self.mirrored else 1.0, 0.0], [0.0, 1.0]])
        return mirror @ np.array([[cos, sin], [-sin, cos]], dtype=float)


UPRIGHT_ORIENTATION = Orientation(False, 0)
TRIED_ORIENTATIONS = tuple(
    Orientation(*each)
    for each in (
        (True, 0), (False, 2), (True, 2), (False, 1), (False, 3), (True, 1), (True, 3)
    )
)  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Pair(Value):
    """Strokes of two writings that are the same part of the letter.

    Args:
        strokes: Numbers of the strokes in the one writing, from 0; several where it was split.
        others: Numbers of the strokes in the other; several where they were written in one.
        alignment: The two aligned point by point, and whether one is backwards.
        is_dot: Whether it is a dot, which has no direction.
    """

    strokes: tuple[int, ...]
    others: tuple[int, ...]
    alignment: Alignment
    is_dot: bool


@dataclass(frozen=True, eq=False, repr=False)
class Matching(Value):
    """Which strokes of two writings belong together.

    Args:
        pairs: In the order of the other writing.
        extra: Numbers of strokes that the other writing does not have.
        missing: Numbers of strokes of the other writing that are not there.
        orientation: Whether the letter is mirrored or turned.
    """

    pairs: tuple[Pair, ...]
    extra: tuple[int, ...]
    missing: tuple[int, ...]
    orientation: Orientation

    @property
    def mirrored(self) -> bool:
        """Whether the letter is the mirror image of the other, left for right."""
        return self.orientation.mirrored

    @property
    def turn(self) -> int:
        """By how many quarters the letter is turned to the left: 0, 1, 2 or 3."""
        return self.orientation.turn

    @property
    def reversed(self) -> tuple[int, ...]:
        """The other writing's numbers of the strokes that were written backwards."""
        return tuple(pair.others[0] for pair in self.pairs if pair.alignment.backwards)

    @property
    def written(self) -> int:
        """The number of strokes of the one writing."""
        return len(self.extra) + sum(len(pair.strokes) for pair in self.pairs)

    def written_before(self, pair: Pair) -> set[int]:
        """Return the other writing's numbers of the strokes that were written before a pair."""
        first = min(pair.strokes)
        return {k for each in self.pairs if min(each.strokes) < first for k in each.others}

    @property
    def order(self) -> tuple[int, ...]:
        """The other writing's numbers of the strokes, in the order in which they were written."""
        in_order = sorted(self.pairs, key=lambda pair: min(pair.strokes))
        return tuple(pair.others[0] for pair in in_order)


def match_strokes(strokes: LetterLike, others: LetterLike) -> Matching:
    """Find which strokes of two writings of a letter belong together, by shape and place alone.

    Args:
        strokes: A `Recording`, a `Letter` or strokes: the writing that is looked at.
        others: The same for the writing that it is compared with.

    Raises:
        LetterError: One of them is nothing, something else, or all in one place.
    """
    written, model = to_strokes(strokes, "strokes"), to_strokes(others, "others")
    ink = resample(written, POINTS_TO_MATCH).normalized()
    other = resample(model, POINTS_TO_MATCH).normalized()
    return pair_up(written, model, other.lengths, *_viewed_groups(ink, other))


def pair_up(
    written: Sequence[Trajectory],
    model: Sequence[Trajectory],
    lengths: Array,
    view: Orientation,
    groups: Sequence[Group],
) -> Matching:
    """Return groups of strokes, aligned point by point; `lengths` are the model's [radii]."""
    back = view.undo()
    pairs = []
    for mine, yours in sorted(
        (group for group in groups if all(group)), key=lambda group: min(group[1])
    ):
        lines = align(
            [written[k].position @ back.T for k in mine], [model[k].position for k in yours]
        )
        is_dot = bool(lengths[list(yours)].sum() < DOT_LENGTH)
        lines = replace(lines, backwards=lines.backwards and not is_dot)
        pairs.append(Pair(mine, yours, lines, is_dot))
    extra = tuple(sorted(k for mine, yours in groups if not yours for k in mine))
    missing = tuple(sorted(k for mine, yours in groups if not mine for k in yours))
    return Matching(tuple(pairs), extra, missing, view)


def _viewed_groups(ink: Resampled, other: Resampled) -> tuple[Orientation, list[Group]]:
    """Return how the letter is mirrored and turned, and the cheapest groups of its strokes then."""
    sheared, upright = _nearest_shear(ink, other)
    cost, groups = _cheapest((ink, sheared), other)
    if upright > NEAR_UPRIGHT:
        near, view, sheared = min(
            (_seen_in(view, ink, other) for view in TRIED_ORIENTATIONS), key=lambda found: found[0]
        )
        if near < min(LARGEST_VIEWED_SHARE * upright, upright - LEAST_VIEW_GAIN):
            viewed_cost, viewed = _cheapest((ink.transformed(view.undo()), sheared), other)
            if viewed_cost < LARGEST_VIEWED_SHARE**2 * cost:
                return view, viewed
    return UPRIGHT_ORIENTATION, groups


def _seen_in(
    view: Orientation, ink: Resampled, other: Resampled
) -> tuple[float, Orientation, Resampled]:
    """Return how near the letter is in a view, farther where its strokes run backwards there."""
    sheared, near = _nearest_shear(ink.transformed(view.undo()), other)
    nearest = squared_distances(sheared.features(), other.features()).argmin(axis=1)
    along = (sheared.directions * other.directions[nearest]).sum(axis=1)
    return near + LEAST_VIEW_GAIN * float((along < 0).mean()), view, sheared


def _cheapest(inks: Sequence[Resampled], other: Resampled) -> tuple[float, list[Group]]:
    """Return the cheapest groups over all ways to lay the letters over each other, and the cost."""
    return min(
        (group_strokes(*pair) for ink in inks for pair in _overlays(ink, other)),
        key=lambda found: found[0],
    )


def _nearest_shear(ink: Resampled, other: Resampled) -> tuple[Resampled, float]:
    """Return the letter in the lean and width nearest to the other, and how near [radii]."""
    points = ink.points[::COARSE_STEP] @ TRIED_SHEARS
    directions = ink.directions[::COARSE_STEP] @ TRIED_SHEARS
    points /= np.sqrt((points**2).sum(axis=2).mean(axis=1))[:, None, None]
    directions /= np.maximum(np.sqrt((directions**2).sum(axis=2, keepdims=True)), 1e-12)
    apart = squared_distances(features(points, directions), other.features()[::COARSE_STEP])
    near = np.sqrt((apart.min(axis=2).mean(axis=1) + apart.min(axis=1).mean(axis=1)) / 2)
    best = int(np.argmin(near))
    return ink.transformed(TRIED_SHEARS[best].T), float(near[best])


def _overlays(ink: Resampled, other: Resampled) -> Iterator[tuple[Resampled, Resampled]]:
    """Yield the letters whole and, where the numbers of strokes differ, as if some were missing."""
    yield ink, other
    mine, yours = len(ink.lengths), len(other.lengths)
    if max(mine, yours) <= MOST_STROKES_LEFT_OUT:
        yield from ((less, other) for less in _with_fewer(ink, mine - yours))
        yield from ((ink, less) for less in _with_fewer(other, yours - mine))


def _with_fewer(ink: Resampled, number: int) -> Iterator[Resampled]:
    """Yield the letter without a number of its strokes, whichever; never as a dot alone."""
    for left_out in combinations(range(len(ink.lengths)), number) if number > 0 else ():
        if np.delete(ink.lengths, left_out).any():
            yield ink.without(left_out)
