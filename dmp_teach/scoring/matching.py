"""Which stroke of one writing is which stroke of another, told by where they are and how they look.

Order, direction and number are never assumed. Both letters become points evenly along their ink (`points.Ink`), moved
to their middles and scaled to one size. A pair of strokes costs the squared distances of its points to the nearest
point of the other stroke (the modified Hausdorff distance of Dubuisson and Jain 1994, squared, with the direction of
the ink as a third coordinate); a stroke without a partner costs a fixed distance a point. The cheapest assignment is
found exactly (Crouse 2016: `scipy.optimize.linear_sum_assignment`). Where one stroke does the work of two, the two
are one group. If the numbers differ, the letters are also laid over each other as if a stroke were missing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from dmp_teach.scoring.alignment import Laid, laid
from dmp_teach.scoring.resampling import Ink, features, ink_of, strokes_of
from dmp_teach.trajectory import Array

POINTS = 64  # over all the ink of a letter
ALONE = 4.0  # what a stroke without a partner costs: as a sixteenth of the letter a third of it away [radii^2]
STRANGE = 0.9  # strokes that are farther from each other are no partners [radii: about a third of the height]
DOT = 0.3  # a shorter stroke is a dot, and nobody sees which way it went [radii: a tenth of the height]
SPLIT = 0.5  # strokes that do the work of others: each of them lies this near to those [radii] ...
LONGER = 1.5  # ... and neither side is so many times as long: a line drawn twice is not a line in two pieces
WORK = 0.55  # and so much of a stroke's length is done by who does its work, too
PARTED = (
    0.25  # two pairs are one, cut at other places, if that leaves less than this of what they cost
)
COARSE = 2  # every second point is enough to see how a letter leans
SLANTS = np.array(
    [[[width, 0], [lean, 1]] for width in (0.5, 0.7, 1, 1.4, 2) for lean in np.linspace(-1, 1, 9)]
)
VIEWS = (
    (True, 0),
    (False, 2),
    (True, 2),
    (False, 1),
    (False, 3),
    (True, 1),
    (True, 3),
)  # mirrored, quarter turns
UPRIGHT = 0.15  # a letter that is as near as this in some lean and width is neither mirrored nor turned [radii]
SEEN = 0.6  # another letter is mirrored or turned if that leaves less than this much of its distance upright ...
SURELY = (
    0.1  # ... and is nearer by this much [radii], and twice as much if it has all strokes backwards
)
MOST = 6  # strokes of which every number may be missing


Group = tuple[tuple[int, ...], tuple[int, ...]]
"""Strokes of the one writing, and of the other, that are the same part of the letter."""


@dataclass(frozen=True, eq=False)
class Pair:
    """Strokes of two writings that are the same part of the letter; more than one on a side were joined or split.

    Args:
        strokes: Numbers of the strokes in the one writing, from 0.
        others: Numbers of the strokes in the other.
        laid: The two laid along each other, point by point, and whether one is backwards.
    """

    strokes: tuple[int, ...]
    others: tuple[int, ...]
    laid: Laid


@dataclass(frozen=True, eq=False)
class Matching:
    """Which strokes of two writings belong together.

    Args:
        pairs: In the order of the other writing.
        extra: Numbers of strokes that the other writing does not have.
        missing: Numbers of strokes of the other writing that are not there.
        mirrored: Whether the letter is the mirror image of the other, left for right.
        turn: By how many quarters it is turned to the left, mirrored or not: 0, 1, 2 or 3.
    """

    pairs: tuple[Pair, ...]
    extra: tuple[int, ...]
    missing: tuple[int, ...]
    mirrored: bool
    turn: int

    @property
    def reversed(self) -> tuple[int, ...]:
        """The other writing's numbers of the strokes that were written backwards."""
        return tuple(pair.others[0] for pair in self.pairs if pair.laid.backwards)

    @property
    def joined(self) -> tuple[Pair, ...]:
        """Where fewer strokes do the work of more."""
        return tuple(pair for pair in self.pairs if len(pair.strokes) < len(pair.others))

    @property
    def split(self) -> tuple[Pair, ...]:
        """Where more strokes do the work of fewer."""
        return tuple(pair for pair in self.pairs if len(pair.strokes) > len(pair.others))

    @property
    def divided(self) -> tuple[Pair, ...]:
        """Where as many strokes do the same work, and are divided from each other at other places."""
        return tuple(pair for pair in self.pairs if len(pair.strokes) == len(pair.others) > 1)

    @property
    def order(self) -> tuple[int, ...]:
        """The other writing's numbers of the strokes, in the order in which they were written here."""
        return tuple(
            pair.others[0] for pair in sorted(self.pairs, key=lambda pair: min(pair.strokes))
        )


def matched(strokes: Any, others: Any) -> Matching:
    """Find which strokes of two writings of a letter belong together, by shape and place alone.

    Args:
        strokes: A `Recording`, a `Letter` or strokes: the writing that is asked about.
        others: The same for the writing that it is compared with.

    Raises:
        LetterError: One of them is nothing, something else, or all in one place.
    """
    written, model = strokes_of(strokes, "strokes"), strokes_of(others, "others")
    ink, other = ink_of(written, POINTS), ink_of(model, POINTS)
    mirrored, turn, groups = _seen(ink, other)
    back = undone(mirrored, turn)
    both = sorted(
        (group for group in groups if group[0] and group[1]), key=lambda group: min(group[1])
    )
    pairs = []
    for mine, yours in both:
        lines = laid(
            [written[k].position @ back.T for k in mine], [model[k].position for k in yours]
        )
        dot = other.lengths[list(yours)].sum() < DOT
        pairs.append(Pair(mine, yours, replace(lines, backwards=False) if dot else lines))
    extra = tuple(sorted(k for mine, yours in groups if not yours for k in mine))
    missing = tuple(sorted(k for mine, yours in groups if not mine for k in yours))
    return Matching(tuple(pairs), extra, missing, mirrored, turn)


def undone(mirrored: bool, turn: int) -> Array:
    """The matrix (2, 2) that brings points that were mirrored, and then turned to the left, back again."""
    cos, sin = (1, 0, -1, 0)[turn], (0, 1, 0, -1)[turn]
    return np.array([[-1.0 if mirrored else 1.0, 0.0], [0.0, 1.0]]) @ np.array(
        [[cos, sin], [-sin, cos]], dtype=float
    )


def _seen(ink: Ink, other: Ink) -> tuple[bool, int, list[Group]]:
    """How the letter is mirrored and turned, and the cheapest groups of its strokes then."""
    slanted, plain = _slanted(ink, other)
    cost, groups = _cheapest((ink, slanted), other)
    if plain > UPRIGHT:
        view, near, slanted = min(
            (_viewed(ink, other, view) for view in VIEWS), key=lambda found: found[1]
        )
        if near < min(SEEN * plain, plain - SURELY):
            turned_cost, turned_groups = _cheapest((ink.turned(undone(*view)), slanted), other)
            if turned_cost < SEEN**2 * cost:
                return *view, turned_groups
    return False, 0, groups


def _viewed(ink: Ink, other: Ink, view: tuple[bool, int]) -> tuple[tuple[bool, int], float, Ink]:
    """How near the letter is in one view, farther where that has its strokes run backwards; and the letter there."""
    slanted, near = _slanted(ink.turned(undone(*view)), other)
    nearest = squared(slanted.features(), other.features()).argmin(axis=1)
    backwards = float(((slanted.along * other.along[nearest]).sum(axis=1) < 0).mean())
    return view, near + SURELY * backwards, slanted


def _cheapest(inks: Sequence[Ink], other: Ink) -> tuple[float, list[Group]]:
    """The cheapest groups of strokes over all ways to lay the letters over each other, and what they cost."""
    return min(
        (_grouped(*pair) for ink in inks for pair in _overlays(ink, other)),
        key=lambda found: found[0],
    )


def _slanted(ink: Ink, other: Ink) -> tuple[Ink, float]:
    """The letter in that lean and width in which it is nearest to the other as a whole, and how near [radii]."""
    place, along = ink.place[::COARSE] @ SLANTS, ink.along[::COARSE] @ SLANTS
    place /= np.sqrt((place**2).sum(axis=2).mean(axis=1))[:, None, None]
    along /= np.maximum(np.sqrt((along**2).sum(axis=2, keepdims=True)), 1e-12)
    apart = squared(features(place, along), other.features()[::COARSE])
    near = np.sqrt((apart.min(axis=2).mean(axis=1) + apart.min(axis=1).mean(axis=1)) / 2)
    best = int(np.argmin(near))
    return ink.turned(SLANTS[best].T), float(near[best])


def squared(a: Array, b: Array) -> Array:
    """Squared distances of points (..., P, D) from points (Q, D), shape (..., P, Q)."""
    apart = (a * a).sum(axis=-1)[..., None] + (b * b).sum(axis=-1) - 2 * a @ b.T
    return np.maximum(apart, 0.0)


def _overlays(ink: Ink, other: Ink) -> Iterator[tuple[Ink, Ink]]:
    """The letters laid over each other whole, and, where the numbers of strokes differ, as if some were not there."""
    yield ink, other
    mine, yours = len(ink.lengths), len(other.lengths)
    if max(mine, yours) <= MOST:
        yield from ((less, other) for less in _fewer(ink, mine - yours))
        yield from ((ink, less) for less in _fewer(other, yours - mine))


def _fewer(ink: Ink, number: int) -> Iterator[Ink]:
    """The letter laid as if so many of its strokes were not there, whichever; never as a dot alone."""
    for left_out in combinations(range(len(ink.lengths)), number) if number > 0 else ():
        if np.delete(ink.lengths, left_out).any():
            yield ink.without(left_out)


def _grouped(ink: Ink, other: Ink) -> tuple[float, list[Group]]:
    """The cheapest groups of strokes and what they cost: a sum of squared distances over points [radii^2]."""
    costs = _Costs(ink, other)
    groups = costs.assigned()
    while merged := costs.merged(groups):
        groups = merged
    best, *rest = sorted(groups, key=lambda group: costs.of(group) if all(group) else np.inf)
    groups = [best, *(part for group in rest for part in costs.parted(group))]
    return sum(costs.of(group) for group in groups), groups


class _Costs:
    """What it costs to take strokes for the same part of the letter."""

    def __init__(self, ink: Ink, other: Ink):
        apart = squared(ink.features(), other.features())
        self.inks = ink, other
        self.first = [
            np.searchsorted(each.stroke, np.arange(len(each.lengths))) for each in (ink, other)
        ]
        self.near = (
            np.minimum.reduceat(apart, self.first[1], axis=1),
            np.minimum.reduceat(apart, self.first[0], axis=0),
        )

    def assigned(self) -> list[Group]:
        """One to one as far as they go, none split or joined."""
        pair = np.add.reduceat(self.near[0], self.first[0], axis=0) + np.add.reduceat(
            self.near[1], self.first[1], axis=1
        )
        rows, columns = linear_sum_assignment(pair)
        groups = [((int(i),), (int(j),)) for i, j in zip(rows, columns, strict=True)]
        groups += [((i,), ()) for i in range(len(pair)) if i not in rows]
        return groups + [((), (j,)) for j in range(pair.shape[1]) if j not in columns]

    def of(self, group: Group) -> float:
        """The squared distances of all points of a group, summed."""
        mine, yours = map(list, group)
        if not mine or not yours:
            return ALONE
        there = self.near[0][self.inks[0].of(mine)][:, yours].min(axis=1).sum()
        return float(there + self.near[1][mine][:, self.inks[1].of(yours)].min(axis=0).sum())

    def merged(self, groups: Sequence[Group]) -> list[Group] | None:
        """The groups with those two in one that fit best together; None where no two do."""
        best, gain = None, 0.0
        for a, b in combinations(range(len(groups)), 2):
            both = (
                tuple(sorted(groups[a][0] + groups[b][0])),
                tuple(sorted(groups[a][1] + groups[b][1])),
            )
            if not both[0] or not both[1] or not self._as_long(both):
                continue
            before, after = self.of(groups[a]) + self.of(groups[b]), self.of(both)
            alone = not all(groups[a] + groups[b])
            lone, mate = (groups[a], groups[b]) if not all(groups[a]) else (groups[b], groups[a])
            if alone and (self._has_dot(lone) or not self._does_work_of(mate, lone)):
                continue
            if (
                after < before * (1 if alone else PARTED)
                and self._near(both)
                and before - after > gain
            ):
                best, gain = (a, b, both), before - after
        if best is None:
            return None
        return [*(group for k, group in enumerate(groups) if k not in best[:2]), best[2]]

    def parted(self, group: Group) -> list[Group]:
        """The group, or each of its strokes alone where they are nothing like each other."""
        alone: list[Group] = [*(((k,), ()) for k in group[0]), *(((), (k,)) for k in group[1])]
        points = sum(int(self.inks[side].of(group[side]).sum()) for side in (0, 1))
        return alone if self.of(group) > STRANGE**2 * points else [group]

    def _near(self, group: Group) -> bool:
        """Whether every stroke of a group lies near to the strokes on the other side."""
        mine, yours = map(list, group)
        there = self.near[0][:, yours].min(axis=1), self.near[1][mine].min(axis=0)
        return all(
            there[side][self.inks[side].of([k])].mean() < SPLIT**2
            for side in (0, 1)
            for k in group[side]
        )

    def _does_work_of(self, mate: Group, lone: Group) -> bool:
        """Whether some ink across from a lone stroke is nearer to it than to the strokes that it was given to.

        An O lies near to the accent over it, but all of its ink is an O's: nobody wrote the accent.
        """
        side = 0 if lone[0] else 1
        near = self.near[0] if side else self.near[1].T
        across = near[self.inks[1 - side].of(mate[1 - side])]
        nearer = across[:, list(lone[side])].min(axis=1) < across[:, list(mate[side])].min(
            axis=1, initial=np.inf
        )
        return bool(nearer.sum() >= WORK * self.inks[side].of(lone[side]).sum())

    def _has_dot(self, group: Group) -> bool:
        """Whether a stroke of a group is a dot: no line does the work of a line and a dot."""
        return any(
            self.inks[side].lengths[list(group[side])].min(initial=np.inf) < DOT for side in (0, 1)
        )

    def _as_long(self, group: Group) -> bool:
        """Whether both sides of a group have about the same length of ink."""
        mine, yours = (self.inks[side].lengths[list(group[side])].sum() for side in (0, 1))
        return bool(mine < LONGER * yours and yours < LONGER * mine)
