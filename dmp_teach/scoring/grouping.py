"""Group the strokes of two letters, laid over each other, that are the same part of the letter.

A pair of strokes costs the squared distances of its points to the nearest point of the other
stroke (the modified Hausdorff distance of Dubuisson and Jain 1994, squared, with the direction of
the ink as a third coordinate); a stroke without a partner costs a fixed distance. The cheapest
assignment is found exactly (Crouse 2016: `scipy.optimize.linear_sum_assignment`, which takes long
to import: those of a few strokes are all tried). Where one stroke does the work of two, the two
are one group.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, permutations

import numpy as np
import scipy

from dmp_teach.scoring.resampling import Resampled, squared_distances
from dmp_teach.trajectory import Array

# Cost of a stroke without a partner: as a sixteenth of the letter a third of it away [radii^2].
UNMATCHED_COST = 4.0
# Strokes farther from each other are no partners [radii: about a third of the height].
FARTHEST_PARTNER = 0.9
# A shorter stroke is a dot, whose direction cannot be seen [radii: a tenth of the height].
DOT_LENGTH = 0.3
# Strokes that do the work of others lie this near to them [radii] ...
FARTHEST_PIECE = 0.5
# ... and neither side is longer by this factor: a line drawn twice is not a line in two pieces.
LARGEST_LENGTH_RATIO = 1.5
# A lone stroke joins a group that does at least this much of its work.
SHARED_WORK = 0.55
# Two pairs are one, cut at other places, if that leaves less than this of what they cost.
LARGEST_MERGED_COST = 0.25
# With up to so many strokes every assignment is tried, 24 at most.
MOST_STROKES_TRIED = 4

Group = tuple[tuple[int, ...], tuple[int, ...]]
"""Strokes of the one writing, and of the other, that are the same part of the letter."""


def group_strokes(ink: Resampled, other: Resampled) -> tuple[float, list[Group]]:
    """Find the cheapest groups, and their cost: summed squared distances of points [radii^2]."""
    costs = _Costs(ink, other)
    groups = costs.assign()
    while merged := costs.merge_best(groups):
        groups = merged
    best, *rest = sorted(groups, key=lambda group: costs.of(group) if all(group) else np.inf)
    groups = [best, *(part for group in rest for part in costs.part(group))]
    return sum(costs.of(group) for group in groups), groups


def _assign(cost: Array) -> list[tuple[int, int]]:
    """Return the rows and columns of the cheapest assignment."""
    if cost.shape[0] > cost.shape[1]:
        return [(row, column) for column, row in _assign(cost.T)]
    rows, columns = map(range, cost.shape)
    if len(columns) > MOST_STROKES_TRIED:
        found = scipy.optimize.linear_sum_assignment(cost)
        return [(int(row), int(column)) for row, column in zip(*found, strict=True)]
    costs = cost.tolist()
    tried = (list(enumerate(each)) for each in permutations(columns, len(rows)))
    return min(tried, key=lambda pairs: sum(costs[row][column] for row, column in pairs))


class _Costs:
    """The costs of taking strokes for the same part of the letter."""

    def __init__(self, ink: Resampled, other: Resampled) -> None:
        apart = squared_distances(ink.features(), other.features())
        self.inks = ink, other
        self.first = [
            np.searchsorted(each.stroke, np.arange(len(each.lengths))) for each in (ink, other)
        ]
        # Squared distances of every point from the nearest of each stroke on the other side.
        self.near = (
            np.minimum.reduceat(apart, self.first[1], axis=1),
            np.minimum.reduceat(apart, self.first[0], axis=0),
        )

    def assign(self) -> list[Group]:
        """Assign strokes one to one as far as they go."""
        mine = np.add.reduceat(self.near[0], self.first[0], axis=0)
        cost = mine + np.add.reduceat(self.near[1], self.first[1], axis=1)
        pairs = _assign(cost)
        rows, columns = zip(*pairs, strict=True)
        groups: list[Group] = [((i,), (j,)) for i, j in pairs]
        groups += [((i,), ()) for i in range(cost.shape[0]) if i not in rows]
        return groups + [((), (j,)) for j in range(cost.shape[1]) if j not in columns]

    def of(self, group: Group) -> float:
        """Return the squared distances of all points of a group, summed."""
        mine, yours = map(list, group)
        if not mine or not yours:
            return UNMATCHED_COST
        there = self.near[0][self.inks[0].is_of(mine)][:, yours].min(axis=1).sum()
        return float(there + self.near[1][mine][:, self.inks[1].is_of(yours)].min(axis=0).sum())

    def merge_best(self, groups: Sequence[Group]) -> list[Group] | None:
        """Return the groups with the two merged that gain most; None where no two do."""
        best, largest_gain = None, 0.0
        for one, two in combinations(groups, 2):
            both = tuple(sorted(one[0] + two[0])), tuple(sorted(one[1] + two[1]))
            gain = self._gain(one, two, both)
            if gain > largest_gain:
                best, largest_gain = (one, two, both), gain
        if best is None:
            return None
        return [*(group for group in groups if group not in best[:2]), best[2]]

    def _gain(self, one: Group, two: Group, both: Group) -> float:
        """Return how much cheaper two groups are as one; 0 where they cannot be one."""
        if not all(both) or not self._are_as_long(both):
            return 0.0
        is_lone = not all(one) or not all(two)
        lone, mate = (one, two) if not all(one) else (two, one)
        if is_lone and (self._has_dot(lone) or not self._does_work_of(mate, lone)):
            return 0.0
        before, after = self.of(one) + self.of(two), self.of(both)
        fits = after < before * (1 if is_lone else LARGEST_MERGED_COST) and self._is_near(both)
        return before - after if fits else 0.0

    def part(self, group: Group) -> list[Group]:
        """Return the group, or each of its strokes alone where they are nothing like each other."""
        points = sum(int(self.inks[side].is_of(group[side]).sum()) for side in (0, 1))
        if self.of(group) <= FARTHEST_PARTNER**2 * points:
            return [group]
        return [*(((k,), ()) for k in group[0]), *(((), (k,)) for k in group[1])]

    def _is_near(self, group: Group) -> bool:
        """Return whether every stroke of a group lies near the strokes on the other side."""
        mine, yours = map(list, group)
        there = self.near[0][:, yours].min(axis=1), self.near[1][mine].min(axis=0)
        return all(
            there[side][self.inks[side].is_of([k])].mean() < FARTHEST_PIECE**2
            for side in (0, 1)
            for k in group[side]
        )

    def _does_work_of(self, mate: Group, lone: Group) -> bool:
        """Return whether some ink across is nearer to a lone stroke than to the mate's strokes.

        An O lies near the accent over it, but all of its ink is an O's: the accent is missing.
        """
        side = 0 if lone[0] else 1
        near = self.near[0] if side else self.near[1].T
        across = near[self.inks[1 - side].is_of(mate[1 - side])]
        to_mate = across[:, list(mate[side])].min(axis=1, initial=np.inf)
        nearer = across[:, list(lone[side])].min(axis=1) < to_mate
        return bool(nearer.sum() >= SHARED_WORK * self.inks[side].is_of(lone[side]).sum())

    def _has_dot(self, group: Group) -> bool:
        """Return whether a stroke is a dot: no line does the work of a line and a dot."""
        return any(
            self.inks[side].lengths[list(group[side])].min(initial=np.inf) < DOT_LENGTH
            for side in (0, 1)
        )

    def _are_as_long(self, group: Group) -> bool:
        """Return whether both sides of a group have about the same length of ink."""
        mine, yours = (self.inks[side].lengths[list(group[side])].sum() for side in (0, 1))
        return bool(mine < LARGEST_LENGTH_RATIO * yours and yours < LARGEST_LENGTH_RATIO * mine)
