"""Where letters meet: they touch only by the way between them, and the white is even."""

from functools import cache
from itertools import product
from string import ascii_lowercase

import numpy as np
import pytest
from scipy.spatial import cKDTree

from dmp_teach.ink.alphabet import alphabets
from dmp_teach.letters.text.connection_points import (
    can_arrive,
    can_leave,
    find_meeting,
    leaving_sample,
    split_marks,
)
from dmp_teach.letters.text.connections import link_strokes
from dmp_teach.letters.text.spacing import connected_spacing, letter_spacing
from dmp_teach.trajectory import Trajectory
from tests.letters.text import HANDS, dense, filled, points


@cache
def joints(name):
    """Every pair of small letters that are joined: the last stroke and the first, in place."""
    return tuple(_joints(HANDS[name]))


def connection(end, start, size):
    """The samples of two linked strokes, and between which of them the connection is."""
    both, a = link_strokes(end, start, size), leaving_sample(end, size)
    there = start.position[find_meeting(end.position[a], start, size).sample]
    return both, a, int(np.flatnonzero(np.abs(both.position - there).max(axis=1) < 1e-12)[0])


def _joints(hand):
    for one, other in product(ascii_lowercase, repeat=2):
        glyphs = hand.glyph(one), hand.glyph(other)
        bodies = split_marks(one, glyphs[0])[0], split_marks(other, glyphs[1])[0]
        if can_leave(one, bodies[0], hand.x_height) and can_arrive(other, bodies[1], hand.x_height):
            step = connected_spacing(glyphs, bodies, hand.x_height)
            start = bodies[1][0]
            yield (
                one + other,
                bodies[0][-1],
                Trajectory(start.t, start.position + np.array([step, 0])),
            )


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_joined_letters_touch_only_by_the_way_between_them(name):
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        a = leaving_sample(end, size)
        met = find_meeting(end.position[a], start, size)
        right = (
            Trajectory(start.t[met.sample :], start.position[met.sample :])
            if not met.back
            else start
        )
        apart, _ = cKDTree(filled(end.position[: a + 1])).query(filled(right.position))
        assert apart.min() > 0.1 * size, pair


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_a_pen_that_moves_keeps_its_heading_where_letters_meet(name):
    """At both ends of a connection; where the pen rests, as on the peak of a v, it may turn."""
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        both, *seams = connection(end, start, size)
        step = np.diff(both.position, axis=0)
        speed = np.linalg.norm(step, axis=1) / np.diff(both.t)
        turn = np.abs(
            np.degrees(np.angle(np.exp(1j * np.diff(np.arctan2(step[:, 1], step[:, 0])))))
        )
        for seam in seams:
            around = slice(max(seam - 2, 0), seam + 1)
            moves = np.minimum(speed[:-1], speed[1:])[around] > 0.25 * np.median(speed)
            assert turn[around][moves].max(initial=0) < 22, (pair, seam)


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_the_way_between_letters_makes_no_detour(name):
    """It rises no higher than its ends and sinks no lower but for a dip, and leads to the right."""
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        both, a, k = connection(end, start, size)
        way = both.position[a : k + 1]
        here, there = way[0], way[-1]
        low, high = sorted([here[1], there[1]])
        assert way[:, 1].max() < high + 0.06 * size, pair
        assert way[:, 1].min() > low - 0.35 * size, pair
        assert np.diff(way[:, 0]).clip(max=0).sum() > -0.35 * size, pair
        rise, run = there[1] - here[1], there[0] - here[0]
        assert here[1] > 0.6 * size or rise < 1.9 * run, pair


@pytest.mark.parametrize("name", alphabets())
def test_the_white_between_letters_is_even(name):
    """Stems, bowls and mixed pairs have the same white, though their boxes stand unlike."""
    hand = HANDS[name]
    boxes, whites = [], []
    for one, other in ("nn", "oo", "no", "on", "ac", "ve"):
        left, right = hand.glyph(one), hand.glyph(other)
        moved = dense(right) + np.array([letter_spacing(left, right, hand.x_height), 0])
        bands = np.linspace(0.02, 0.98, 40) * hand.x_height
        edges = [
            [ink[np.abs(ink[:, 1] - y) < 0.03 * hand.x_height, 0] for ink in (dense(left), moved)]
            for y in bands
        ]
        gaps = [b.min() - a.max() if len(a) and len(b) else np.inf for a, b in edges]
        whites.append(np.minimum(gaps, 0.5 * hand.x_height).mean() / hand.x_height)
        boxes.append((moved[:, 0].min() - dense(left)[:, 0].max()) / hand.x_height)
    assert np.ptp(whites) < 0.12
    assert np.ptp(boxes) > 0.1


def test_round_letters_stand_nearer_than_stems_and_slopes_fit_into_each_other():
    hand = HANDS["round"]

    def gap(pair):
        left, right = map(hand.glyph, pair)
        step = letter_spacing(left, right, hand.x_height)
        return (step + points(right)[:, 0].min() - points(left)[:, 0].max()) / hand.x_height

    assert gap("OO") < gap("HH") - 0.08
    assert gap("AV") < gap("HH") - 0.2
