import numpy as np
import pytest
from hypothesis import strategies as st

from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import MOTION_RATE, connect_strokes
from dmp_teach.robot.smoothing import connect_smoothly
from dmp_teach.robot.time_scaling import (
    EASING,
    SPEED_SHARE,
    TimeScaling,
    compute_lateness,
    find_due_samples,
)
from dmp_teach.trajectory import Trajectory
from tests.robot import ink
from tests.robot.ink import LETTER, law
from tests.robot.sound import LIMITS, assert_sound

REACH = round(EASING * MOTION_RATE)
HURRY = st.lists(st.tuples(st.integers(0, 399), st.floats(1.01, 30)), min_size=1, max_size=5)


def hasty(factor, letter=LETTER):
    return tuple(Trajectory(s.t / factor, s.position) for s in letter)


def needed_at(hurry, n=400):
    needed = np.ones(n)
    for where, how in hurry:
        needed[where : where + 5] = how
    return needed


@law(hurry=HURRY)
def test_every_sample_lasts_as_long_as_it_must_and_those_far_from_a_hurry_no_longer(hurry):
    needed = needed_at(hurry)
    longer = compute_lateness(needed)
    assert (1 + longer >= needed - 1e-9).all()
    near = np.convolve(needed > 1, np.ones(4 * REACH + 1), "same") > 0
    assert (longer[~near] == 0).all()


@law(hurry=HURRY)
def test_the_clock_never_jumps(hurry):
    rate = 1 / (1 + compute_lateness(needed_at(hurry)))
    assert np.abs(np.diff(rate)).max() <= 1.5 / REACH
    samples = find_due_samples(compute_lateness(needed_at(hurry)))
    assert (np.diff(samples) > 0).all()
    assert np.diff(samples).max() <= 1 + 1e-9
    assert np.abs(np.diff(samples, n=2)).max() <= 1.5 / REACH


@law(hurry=HURRY)
def test_samples_after_a_slowed_place_are_those_of_the_unhurried_plan(hurry):
    longer = compute_lateness(needed_at(hurry))
    samples = find_due_samples(longer)
    assert samples[0] == 0
    assert samples[-1] == len(longer) - 1
    untouched = np.flatnonzero(longer == 0)
    assert np.isin(untouched, samples).all()


@pytest.mark.parametrize("length", [2, 3, 10])
def test_a_piece_of_few_samples_can_be_slowed_too(length):
    samples = find_due_samples(compute_lateness(np.full(length, 7.3)))
    assert len(samples) >= 7.3 * (length - 1) + 1
    np.testing.assert_allclose(np.diff(samples), np.diff(samples)[0])


def test_a_clock_heeds_the_joint_that_hurries_where_it_does():
    way = connect_strokes(lay_out(LETTER, Page.table()))
    clock, hurry = TimeScaling(way, ("slow", "fast")), way.rests[1] + 100
    assert not clock.slow_down(np.ones((way.rests[-1], 2)))
    assert clock.notes == ()
    longer = np.zeros((way.rests[-1], 2))
    longer[hurry, 1] = 2
    assert clock.slow_down(longer)
    assert clock.notes == (
        f"slowed from {way.rests[-1] / MOTION_RATE:.2f} s to "
        f"{(len(clock.samples) - 1) / MOTION_RATE:.2f} s: fast",
    )
    pace = np.diff(clock.samples)
    assert 2.0 <= 1 / pace.min() < 2.2
    slowed = clock.samples[:-1][pace < 1 - 1e-6]
    assert hurry - 2 * REACH - 2 < slowed.min() < hurry < slowed.max() < hurry + 2 * REACH + 2


@law(examples=8, letter=ink.letters(), faster=st.floats(2, 8))
def test_slowed_ink_is_the_same_ink_at_rest_at_both_ends_of_every_stroke(letter, faster):
    motion = Fetch().write(hasty(faster, letter), Page.board(width=0.5), size=0.19)
    assert_sound(motion)
    plain = connect_smoothly(motion.strokes).plan()
    position, speed = (
        motion.page.to_page(motion.target),
        np.linalg.norm(np.diff(motion.target, axis=0), axis=1) * MOTION_RATE,
    )
    edges = np.flatnonzero(np.diff(motion.pen_down.astype(int), prepend=0, append=0)).reshape(-1, 2)
    others = np.flatnonzero(np.diff(plain.pen_down.astype(int), prepend=0, append=0)).reshape(-1, 2)
    assert len(edges) == len(others) == len(motion.strokes)
    assert np.abs(position[motion.pen_down, 2]).max() < 1e-12
    assert position[~motion.pen_down, 2].min() > 0
    for (start, stop), stroke in zip(edges, motion.strokes, strict=True):
        np.testing.assert_allclose(
            position[[start, stop - 1], :2], stroke.position[[0, -1]], atol=1e-12
        )
        assert max(speed[start - 1 : start + 1].max(), speed[stop - 2 : stop].max()) < 0.01 * faster


def test_far_from_a_hurry_the_pace_stays_and_the_ink_is_nowhere_else():
    motion = Fetch().write(hasty(2), Page.table(), size=0.19)
    plain, position = connect_smoothly(motion.strokes).plan(), motion.page.to_page(motion.target)
    before = np.argmax(np.abs(position[: len(plain.t)] - plain.position).max(axis=1) > 1e-9)
    after = np.argmax(np.abs(position[::-1][: len(plain.t)] - plain.position[::-1]).max(1) > 1e-9)
    assert before > 50
    assert after > 200
    np.testing.assert_array_equal(motion.pen_down[-after:], plain.pen_down[-after:])
    fine = connect_smoothly(motion.strokes).plan(np.arange(0, len(plain.t) - 0.99, 0.05)).position
    missed = [np.linalg.norm(fine - spot, axis=1).min() for spot in position]
    assert max(missed) < 1e-4
    speed = np.abs(np.diff(motion.q, axis=0)).max(axis=0) * MOTION_RATE
    hurried = JOINTS.index(motion.notes[0].partition(": ")[2].split(", ")[0])
    assert speed[hurried] > 0.95 * SPEED_SHARE * LIMITS[hurried].velocity


def test_a_slowed_motion_is_the_same_bit_for_bit_when_it_is_planned_again():
    one, other = (Fetch().write(hasty(4), Page.table(), size=0.19) for _ in range(2))
    np.testing.assert_array_equal(one.q, other.q)
    assert one.notes == other.notes
