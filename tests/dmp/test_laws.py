"""What must hold for every letter."""

import math
import re

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings, knobs
from dmp_teach.errors import SettingError
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter, letters, scrawls

few = settings(max_examples=40, deadline=None)


def sigmoid(**changes):
    return Settings.star(
        **{"phase": "sigmoid", "kernel": "mollifier", "kernel_width": 2.5} | changes
    )


def exact(**changes):
    return Settings.plus(integrator="exact", phase="exponential", **changes)


PRESETS = [Settings.star, Settings.joint, Settings.plus]
ALL = [*PRESETS, Settings.as_fixed, Settings.as_coded, sigmoid, exact]
presets = st.sampled_from(PRESETS)
every = st.sampled_from(ALL)
shifts = st.floats(-0.3, 0.3)


def close(a, b, metres=1e-12):
    return np.abs(a - b).max() <= metres


@few
@given(letters(), presets)
def test_all_transformations_draw_the_same_path_at_the_demonstrated_goal(demo, preset):
    way = demo.position[-1] - demo.position[0]
    assume(np.abs(way).min() > 1e-3)
    names = ("star", "original", "similarity")
    star, original, similarity = (
        DMP.imitate(demo, preset(transform=name)).rollout().position for name in names
    )
    assert close(star, original)
    assert close(star, similarity)


@few
@given(letters(), presets, shifts)
def test_any_goal_is_reached(demo, preset, shift):
    """The miss is the demonstrated one and at most exp(-alpha/2) of the shift, alpha >= 12."""
    p = DMP.imitate(demo, preset())
    end = p.rollout().position[-1] - p.goal
    moved = p.rollout(goal=p.goal + shift).position[-1] - (p.goal + shift)
    assert np.abs(moved - end).max() <= 0.004 * abs(shift) + 1e-12


@few
@given(letters(), shifts)
def test_without_feed_forward_a_moved_goal_is_missed_by_four_times_the_move_over_alpha(demo, shift):
    p = DMP.imitate(demo, Settings.star(feed_goal=False, alpha=100.0))
    miss = p.rollout().position[-1] + shift - p.rollout(goal=p.goal + shift).position[-1]
    assert np.allclose(miss, shift * 4 / 100, rtol=0.01, atol=1e-12)


@few
@given(letters(), every, shifts)
def test_a_goal_shift_moves_every_letter_alike(demo, preset, shift):
    other = letter(len(demo), demo.duration, dimensions=demo.dimensions, seed=99)
    moves = []
    for each in (demo, other):
        p = DMP.imitate(each, preset())
        moves.append(p.rollout(goal=p.goal + shift).position - p.rollout().position)
    assert close(*moves)


@few
@given(letters(), every, shifts)
def test_moving_start_and_goal_together_moves_the_letter(demo, preset, shift):
    p = DMP.imitate(demo, preset())
    moved = p.rollout(start=p.start + shift, goal=p.goal + shift)
    assert close(moved.position, p.rollout().position + shift)


@few
@given(letters(), every, shifts)
def test_a_letter_taught_elsewhere_is_the_same_letter(demo, preset, shift):
    elsewhere = DMP.imitate(Trajectory(demo.t, demo.position + shift), preset())
    assert close(
        elsewhere.rollout().position, DMP.imitate(demo, preset()).rollout().position + shift, 1e-11
    )


@few
@given(letters(), st.sampled_from([*ALL, Settings.original]), st.floats(0.25, 4.0))
def test_another_duration_is_the_same_path(demo, preset, factor):
    p = DMP.imitate(demo, preset())
    slow = p.rollout(duration=p.duration * factor)
    assert close(slow.position, p.rollout().position)
    assert slow.duration == pytest.approx(factor * demo.duration, rel=1e-9)
    assert slow.t[0] == demo.t[0]
    dt = p.duration / 700
    assert close(
        p.rollout(duration=p.duration * factor, dt=dt * factor).position, p.rollout(dt=dt).position
    )


@few
@given(letters(), every)
def test_when_the_recording_began_does_not_matter(demo, preset):
    for began, metres in ((1000.0, 1e-12), (1.7e9, 1e-6)):
        later = DMP.imitate(Trajectory(demo.t + began, demo.position), preset(n_kernels=6))
        assert close(
            later.rollout().position,
            DMP.imitate(demo, preset(n_kernels=6)).rollout().position,
            metres,
        )


@few
@given(letters(), presets)
def test_a_closed_stroke_is_drawn_like_any_other(demo, preset):
    """DMP* needs no way from start to goal: g == y0 is finite and exact."""
    u = np.linspace(0, 1, len(demo))[:, None]
    closed = Trajectory(demo.t, demo.position - u * (demo.position[-1] - demo.position[0]))
    p = DMP.imitate(closed, preset())
    assert close(p.goal, p.start, 1e-15)
    drawn, open_drawn = p.rollout().position, DMP.imitate(demo, preset()).rollout().position
    assert np.isfinite(drawn).all()
    straight = Trajectory(demo.t, u * (demo.position[-1] - demo.position[0]))
    rest = DMP.imitate(straight, preset()).rollout().position
    assert close(drawn + rest, open_drawn, 1e-9 if preset is Settings.plus else 1e-10)


@few
@given(letters(), every)
def test_the_mean_of_two_letters_weights_draws_the_mean_of_the_letters(demo, preset):
    other = letter(len(demo), demo.duration, dimensions=demo.dimensions, seed=7)
    a, b = DMP.imitate(demo, preset()), DMP.imitate(Trajectory(demo.t, other.position), preset())
    mean = DMP.imitate(Trajectory(demo.t, (demo.position + other.position) / 2), preset())
    size = np.abs(a.weights).max() + np.abs(b.weights).max()
    assert np.abs(mean.weights - (a.weights + b.weights) / 2).max() <= 1e-9 * size
    assert close(mean.rollout().position, (a.rollout().position + b.rollout().position) / 2, 1e-10)


@few
@given(letters(), every)
def test_inputs_and_outputs_are_never_changed(demo, preset):
    t, position = demo.t.copy(), demo.position.copy()
    p = DMP.imitate(demo, preset())
    first = p.rollout().position.copy()
    goal = p.goal + 0.1
    kept = goal.copy()
    p.rollout(goal=goal, start=p.start - 0.1, dt=p.duration / 50)
    assert np.array_equal(goal, kept)
    assert np.array_equal(demo.t, t)
    assert np.array_equal(demo.position, position)
    assert np.array_equal(p.rollout().position, first)
    for array in (p.weights, p.start, p.goal, p.start_velocity, p.times):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


@few
@given(letters(), every)
def test_start_and_goal_are_the_demonstrated_ones(demo, preset):
    p = DMP.imitate(demo, preset())
    assert np.array_equal(p.start, demo.position[0])
    assert np.array_equal(p.goal, demo.position[-1])
    assert np.array_equal(p.rollout().position[0], demo.position[0])
    assert np.array_equal(p.rollout().t, demo.t)


@few
@given(letters(), every, st.floats(0.02, 1.0))
def test_a_coarser_dt_shows_the_same_path_at_fewer_times(demo, preset, part):
    p = DMP.imitate(demo, preset())
    coarse, fine = p.rollout(dt=part * p.duration), p.rollout(dt=p.duration / p.steps)
    for axis in range(demo.dimensions):
        between = np.interp(coarse.t, fine.t, fine.position[:, axis])
        assert close(coarse.position[:, axis], between)
    assert coarse.t[-1] == pytest.approx(demo.t[-1], abs=1e-9)


@given(st.integers(1, 50), st.integers(1, 3000))
def test_the_last_sample_is_the_end_whatever_dt(seconds, steps):
    """Never one sample too many or too few, as ceil(T / dt) gives."""
    p = DMP.imitate(letter(40, float(seconds)))
    drawn = p.rollout(dt=seconds / steps)
    assert len(drawn) == steps + 1
    assert drawn.t[-1] == seconds


REFUSED = (
    "n_kernels is|original form cannot|stroke is closed|kernel is|cannot be left open|"
    "no step of ours"
)


def one_of(each):
    if each.choices:
        return st.sampled_from(each.choices)
    if each.whole:
        return st.integers(int(each.low), int(each.high)) | st.none()
    numbers = st.floats(each.low, each.high)
    return numbers | (
        st.none() if each.optional else st.just(math.inf) if each.endless else st.nothing()
    )


@pytest.mark.filterwarnings("ignore::dmp_teach.errors.SettingWarning")
@settings(max_examples=300, deadline=None)
@given(scrawls(), st.fixed_dictionaries({each.name: one_of(each) for each in knobs()}), shifts)
def test_no_setting_in_range_gives_nan(demo, chosen, shift):
    try:
        p = DMP.imitate(demo, Settings(**chosen))
    except SettingError as error:
        if re.search(REFUSED, str(error)):
            return
        raise
    if chosen["transform"] == "similarity" and np.array_equal(p.goal + shift, p.start):
        return
    for drawn in (
        p.rollout(),
        p.rollout(goal=p.goal + shift, duration=3.0),
        p.rollout(dt=p.duration / 7),
    ):
        assert np.isfinite(drawn.position).all()
    assert np.isfinite(p.weights).all()


@few
@given(letters())
def test_the_original_stays_at_its_start_when_told_to_go_there(demo):
    way = demo.position[-1] - demo.position[0]
    assume(np.abs(way).min() > 1e-6)
    p = DMP.imitate(demo, Settings.original())
    assert np.array_equal(
        p.rollout(goal=p.start).position, np.broadcast_to(p.start, demo.position.shape)
    )


def test_the_original_mirrors_a_letter_whose_goal_moves_across_its_start_and_dmp_star_does_not():
    demo = letter(seed=3)
    way = demo.position[-1] - demo.position[0]
    across = demo.position[0] - way
    turned = DMP.imitate(demo, Settings.original()).rollout(goal=across).position - demo.position[0]
    kept = DMP.imitate(demo).rollout(goal=across).position - demo.position[0]
    straight = np.linspace(0, 1, len(demo))[:, None] * way
    shape = demo.position - demo.position[0] - straight
    assert ((turned + straight) * shape).sum() < 0 < ((kept + straight) * shape).sum()
