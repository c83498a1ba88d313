"""Match the strokes written so far with a model, while others are still to come."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from dmp_teach.scoring.grouping import DOT_LENGTH, Group, group_strokes
from dmp_teach.scoring.linear_map import centre
from dmp_teach.scoring.matching import UPRIGHT_ORIENTATION, Matching, pair_up
from dmp_teach.scoring.resampling import POINTS_TO_MATCH, Resampled, resample, rms_radius
from dmp_teach.trajectory import Array, Trajectory

# Of a letter that is not yet complete: what a place of the letter that is farther right or up by a
# radius costs, a size that is larger by the factor e, and strokes that are not the next ones.
PRICE_OF_PLACE = np.array([3.0, 6.0])
PRICE_OF_SIZE = 10.0
COST_OF_ORDER = 4.0
# What it costs that a stroke is none of the model, beside having no partner.
COST_OF_NO_STROKE = 12.0
# What it costs that the last stroke alone lies elsewhere.
COST_OF_PLACE = 5.0
# Ink that is farther from the middle of the model is not on its sheet [radii].
SHEET_REACH = 6.0


def match_so_far(written: Sequence[Trajectory], model: Sequence[Trajectory]) -> Matching:
    """Find which strokes of a model are written, while others are still to come.

    One stroke alone does not tell which bar of an E it is. So each way to lay the ink on some
    strokes of the model costs what a hand seldom does on a sheet that shows where to write: to
    write elsewhere, in another size, or not the next strokes.
    """
    raw = resample(model, POINTS_TO_MATCH)
    other, first = raw.normalized(), set(range(len(written)))
    best: list[Group] = []
    least = np.inf
    for ink, price in _lay_on_some(resample(written, POINTS_TO_MATCH), raw):
        cost, groups = group_strokes(ink, other)
        found = {k for mine, yours in groups if mine for k in yours}
        cost += price + (COST_OF_ORDER if found - first else 0.0)
        cost += COST_OF_NO_STROKE * sum(not yours for _, yours in groups)
        if cost < least:
            best, least = groups, cost
    return pair_up(written, model, other.lengths, UPRIGHT_ORIENTATION, best)


def _lay_on_some(ink: Resampled, other: Resampled) -> Iterator[tuple[Resampled, float]]:
    """Yield the ink as it lies, then laid on any of the other's strokes, and the price of that.

    Both are in radii of the other from its middle. Ink far beyond its sheet has no place there.
    The last stroke alone may also lie elsewhere than the next of the other.
    """
    middle = other.points.mean(axis=0)
    radius = rms_radius(other.points - middle)
    ink, other = (
        replace(each, points=(each.points - middle) / radius, lengths=each.lengths / radius)
        for each in (ink, other)
    )
    last, count = len(ink.lengths) - 1, len(other.lengths)
    is_on_sheet = bool(np.abs(ink.points).max() < SHEET_REACH)
    every = [
        each
        for each in combinations(range(count), min(last + 1, count))
        if other.lengths[list(each)].sum() > DOT_LENGTH
    ]
    laid = [(ink, 0.0)] if is_on_sheet else []
    laid += [_lay(ink, ink.points, other.points[other.is_of(chosen)]) for chosen in every]
    if 0 < last < count:
        before = ink.stroke < last
        on_first = other.points[other.is_of(range(last))]
        for each, price in (*laid[:is_on_sheet], _lay(ink, ink.points[before], on_first)):
            points = each.points.copy()
            away = points[~before].mean(axis=0) - other.points[other.is_of([last])].mean(axis=0)
            points[~before] -= away
            far = COST_OF_PLACE + PRICE_OF_PLACE[0] * float(away @ away)
            far = min(far, COST_OF_NO_STROKE)
            laid.append((replace(each, points=points), price + far))
    for each, price in laid:
        yield each, price if is_on_sheet else 0.0


def _lay(ink: Resampled, some: Array, on: Array) -> tuple[Resampled, float]:
    """Return the ink with some of its points laid on others, and the price of that."""
    size, middle, there = rms_radius(centre(some)), some.mean(axis=0), on.mean(axis=0)
    scale = rms_radius(centre(on)) / size if size > 0 else 1.0
    price = PRICE_OF_PLACE @ (middle - there / scale) ** 2 + PRICE_OF_SIZE * np.log(scale) ** 2
    points = (ink.points - middle) * scale + there
    return replace(ink, points=points, lengths=ink.lengths * scale), float(price)
