import numpy as np
import pytest
from hypothesis import strategies as st

from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import (
    HOVER,
    LIFT_TIME,
    MOTION_RATE,
    STROKE_RAMP,
    connect_strokes,
    ease_in_and_out,
    interpolate,
)
from dmp_teach.trajectory import Trajectory
from tests.robot import ink
from tests.robot.ink import distances, law

PAGE = Page.table()


def planned(letter):
    placed = lay_out(letter, PAGE)
    return placed, connect_strokes(placed).plan()


def pieces(plan):
    """Slices of the samples on the paper, one a stroke."""
    edges = np.flatnonzero(np.diff(plan.pen_down.astype(int), prepend=0, append=0))
    return [slice(*pair) for pair in edges.reshape(-1, 2)]


@law(letter=ink.letters())
def test_the_pen_is_down_exactly_on_the_letter(letter):
    placed, plan = planned(letter)
    heights = plan.position[:, 2]
    assert (heights[plan.pen_down] == 0).all()
    assert (heights[~plan.pen_down] > 0).all()
    assert len(pieces(plan)) == len(placed)
    for piece, stroke in zip(pieces(plan), placed, strict=True):
        written = plan.position[piece, :2]
        np.testing.assert_allclose(written[[0, -1]], stroke.position[[0, -1]], atol=1e-12)


@law(letter=ink.letters())
def test_the_pen_stays_on_the_letter_between_its_samples(letter):
    placed, plan = planned(letter)
    for piece, stroke in zip(pieces(plan), placed, strict=True):
        fine = interpolate(stroke)(np.linspace(stroke.t[0], stroke.t[-1], 20 * len(stroke)))
        assert distances(plan.position[piece, :2], fine).max() < 2e-5
        steps = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
        assert distances(plan.position[piece, :2], stroke.position).max() < steps.max() / 4


@law(letter=ink.letters())
def test_all_of_the_letter_is_written(letter):
    placed, plan = planned(letter)
    for piece, stroke in zip(pieces(plan), placed, strict=True):
        assert distances(stroke.position, plan.position[piece, :2]).max() < 1e-4


@law(letter=ink.letters())
def test_every_stroke_starts_and_ends_at_rest(letter):
    _, plan = planned(letter)
    speed = np.linalg.norm(np.diff(plan.position, axis=0), axis=1) * MOTION_RATE
    for piece in pieces(plan):
        for row in (piece.start, piece.stop - 1):
            assert speed[row - 1 : row + 1].max() < 0.01


@law(letter=ink.letters())
def test_the_pen_never_goes_faster_than_the_hand_did(letter):
    placed, plan = planned(letter)
    speed = np.linalg.norm(np.diff(plan.position[:, :2], axis=0), axis=1) * MOTION_RATE
    for piece, stroke in zip(pieces(plan), placed, strict=True):
        fine = np.linspace(stroke.t[0], stroke.t[-1], 20 * len(stroke))
        hand = np.linalg.norm(np.diff(interpolate(stroke)(fine), axis=0), axis=1) / (
            fine[1] - fine[0]
        )
        assert speed[piece][:-1].max() <= 1.001 * hand.max()


@law(letter=ink.letters())
def test_the_plan_is_sampled_evenly_and_starts_and_ends_at_the_hover(letter):
    placed, plan = planned(letter)
    np.testing.assert_allclose(plan.t, np.arange(len(plan.t)) / MOTION_RATE)
    np.testing.assert_allclose(plan.position[[0, -1], 2], HOVER)
    np.testing.assert_allclose(plan.position[0, :2], placed[0].position[0])
    np.testing.assert_allclose(plan.position[-1, :2], placed[-1].position[-1])
    assert plan.position[:, 2].max() <= HOVER + 1e-12


@law(letter=ink.letters())
def test_the_nib_comes_down_and_goes_up_along_the_normal(letter):
    _, plan = planned(letter)
    rows = round(LIFT_TIME * MOTION_RATE)
    for piece in pieces(plan):
        for air in (
            plan.position[piece.start - rows : piece.start],
            plan.position[piece.stop : piece.stop + rows],
        ):
            assert np.ptp(air[:, :2], axis=0).max() < 1e-12


@law(letter=ink.letters())
def test_a_stroke_takes_its_own_time_and_one_ramp(letter):
    placed, plan = planned(letter)
    for piece, stroke in zip(pieces(plan), placed, strict=True):
        lasts = (piece.stop - 1 - piece.start) / MOTION_RATE
        assert (
            stroke.duration + STROKE_RAMP - 1e-6
            <= lasts
            <= stroke.duration + STROKE_RAMP + 1 / MOTION_RATE
        )


@law(gap=st.floats(0, 60))
def test_a_lift_takes_its_time_within_reason(gap):
    first, second = ink.wave(1.0, seed=1), ink.wave(1.0, seed=2)
    second = Trajectory(second.t + first.t[-1] + gap + 1e-3, second.position)
    _, plan = planned((first, second))
    before, after = pieces(plan)
    lift = (after.start - before.stop + 1) / MOTION_RATE
    assert 2 * LIFT_TIME <= lift <= 1.5 + 3 / MOTION_RATE
    if 1.2 < gap < 1.5:
        assert lift == pytest.approx(gap, abs=4 / MOTION_RATE)


@law(letter=ink.letters(), seed=st.integers(0, 1000))
def test_on_any_clock_it_is_the_same_path_and_the_pen_is_down_on_the_letter(letter, seed):
    placed = lay_out(letter, PAGE)
    way, plan = connect_strokes(placed), connect_strokes(placed).plan()
    between = np.random.default_rng(seed).uniform(0, way.rests[-1], 500)
    samples = np.unique(np.concatenate([way.rests, between]))
    odd = way.plan(samples)
    np.testing.assert_array_equal(odd.t, np.arange(len(samples)) / MOTION_RATE)
    np.testing.assert_array_equal(
        odd.position[np.isin(samples, way.rests)], plan.position[way.rests]
    )
    assert (odd.position[odd.pen_down, 2] == 0).all()
    assert (odd.position[~odd.pen_down, 2] > 0).all()
    assert len(pieces(odd)) == len(placed)
    for piece, other in zip(pieces(odd), pieces(plan), strict=True):
        assert distances(odd.position[piece, :2], plan.position[other, :2]).max() < 2e-4
        np.testing.assert_array_equal(odd.position[piece][[0, -1]], plan.position[other][[0, -1]])


@law(letter=ink.letters())
def test_the_pen_does_not_jerk(letter):
    placed, plan = planned(letter)
    acceleration = np.linalg.norm(np.diff(plan.position, n=2, axis=0), axis=1) * MOTION_RATE**2
    hand = 0.0
    for stroke in placed:
        fine = np.linspace(stroke.t[0], stroke.t[-1], 8 * len(stroke))
        step = fine[1] - fine[0]
        path = interpolate(stroke)(fine)
        speed = np.linalg.norm(np.diff(path, axis=0), axis=1).max() / step
        hand = max(
            hand,
            np.linalg.norm(np.diff(path, n=2, axis=0), axis=1).max() / step**2
            + 1.5 * speed / STROKE_RAMP,
        )
    assert acceleration.max() < 1.05 * max(hand, 3.0)


@law(duration=st.floats(0.001, 20))
def test_the_gentle_clock_starts_and_stops_at_rest_and_shows_it_all(duration):
    lasts, clock = ease_in_and_out(duration)
    times = np.linspace(0, lasts, 2001)
    shown = clock(times)
    assert shown[0] == pytest.approx(0, abs=1e-12)
    assert shown[-1] == pytest.approx(duration)
    rate = np.diff(shown) / np.diff(times)
    assert rate.min() >= 0
    assert rate.max() <= 1 + 1e-9
    assert rate[[0, -1]].max() < 0.01 + 3 * lasts / 2000 / STROKE_RAMP
    assert lasts >= max(2 * STROKE_RAMP, duration + STROKE_RAMP) - 1e-12


def test_uneven_times_do_not_make_the_curve_swing_out():
    t = np.cumsum(np.tile([0.001, 0.04], 20))
    rng = np.random.default_rng(0)
    stroke = Trajectory(
        t, np.column_stack([0.002 * np.arange(40), 0.001 * rng.standard_normal(40)])
    )
    fine = interpolate(stroke)(np.linspace(t[0], t[-1], 4000))
    assert distances(fine, stroke.position).max() < 0.002
    assert fine[:, 0].min() >= 0
    assert fine[:, 0].max() <= 0.078 + 1e-12


def test_two_samples_are_a_straight_stroke():
    stroke = Trajectory([0, 0.5], [[-0.02, 0], [0.02, 0]])
    plan = connect_strokes((stroke,)).plan()
    assert np.abs(plan.position[:, 1]).max() < 1e-12
    assert plan.pen_down.sum() == round(0.7 * MOTION_RATE) + 1


def test_a_dot_is_touched_and_left():
    plan = connect_strokes((Trajectory([0, 0.01], [[0.0, 0.0], [0.0, 0.0]]),)).plan()
    assert plan.pen_down.any()
    assert np.abs(plan.position[:, :2]).max() == 0
