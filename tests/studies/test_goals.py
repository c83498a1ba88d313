"""Goals that move: what the tables say is what the equations say."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.reach.posture import START_POSTURES
from dmp_teach.studies.experiments.goal_change import change_goals_1d, change_goals_2d
from dmp_teach.studies.experiments.goal_drawings import draw_goal_change, trace_goal_change
from dmp_teach.studies.experiments.goal_near_start import change_goals_near_start, close_up
from dmp_teach.studies.experiments.initial_acceleration import measure_initial_acceleration
from dmp_teach.studies.experiments.joint_demand import (
    ARM_JOINTS,
    arm_at_table,
    greatest_acceleration,
)
from dmp_teach.studies.experiments.variants import rms_error
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.floats(0.005, 0.3))
def test_dmp_star_stays_within_the_shift_and_the_original_mirrors_as_its_factor_says(seed, shift):
    ink = letter(100, 1.0, seed=seed)
    way = ink.position[-1] - ink.position[0]
    learned = rms_error(ink, Settings.star())
    found = change_goals_2d([ink], shift)
    if found.refused:
        return
    for case in found.cases:
        factor = (way + case.shift) / way
        np.testing.assert_allclose(case.factor, factor)
        assert case.mirrored == bool((factor < 0).any())
        assert case.star <= 0.8 * shift + learned
        assert case.distance == pytest.approx(shift)
    assert found.mirrored == sum(case.mirrored for case in found.cases)


def test_the_original_draws_the_letter_times_the_factor():
    ink = letter(200, 2.0, seed=3)
    paths = draw_goal_change(ink, (0.1, -0.05))
    drawn = DMP.imitate(ink, Settings.original()).rollout().position
    stretched = ink.position[0] + (drawn - ink.position[0]) * paths.factor
    np.testing.assert_allclose(paths.paths["original"], stretched, atol=1e-9)


def test_one_dimension_has_a_case_for_each_coordinate_and_side():
    found = change_goals_1d([letter(100, 1.0, seed=1)], 0.01)
    assert [case.stroke for case in found.cases] == ["? 1 x", "? 1 x", "? 1 y", "? 1 y"]
    assert [case.shift for case in found.cases] == [(0.01,), (-0.01,)] * 2
    assert {"DMP* [mm]", "original [mm]", "DMP* [mm/s]", "original [mm/s]"} <= set(found.rows()[0])


def test_what_the_original_refuses_is_named_and_not_counted():
    t = np.linspace(0, 1, 100)
    closed = Trajectory(t, np.column_stack([np.sin(2 * np.pi * t), t]))
    assert change_goals_2d([closed]).refused == ("? 1",)
    assert change_goals_2d([closed]).cases == ()
    assert change_goals_2d([closed]).table() == "(no rows)"


def test_traces_end_at_the_new_goal_and_velocity_belongs_to_position():
    ink = letter(300, 2.5, seed=2)
    traces = trace_goal_change(ink, 1, 0.01, "name")
    assert traces.paths["DMP*"][-1] == pytest.approx(ink.position[-1, 1] + 0.01, abs=0.001)
    for name, path in traces.paths.items():
        np.testing.assert_allclose(traces.velocities[name], np.gradient(path, traces.t, axis=0))


@pytest.mark.parametrize("axis", [0, 1])
def test_a_close_up_stroke_ends_where_it_should_and_starts_as_it_did(axis):
    ink = letter(200, 2.0, seed=5)
    bent = close_up(ink, axis, 0.002)
    assert bent.position[-1, axis] - bent.position[0, axis] == pytest.approx(0.002)
    np.testing.assert_array_equal(bent.position[0], ink.position[0])
    np.testing.assert_array_equal(bent.position[:, 1 - axis], ink.position[:, 1 - axis])


def test_the_nearer_the_goal_the_harder_the_original_pulls_and_dmp_star_never():
    near = change_goals_near_start(
        [letter(200, 1.5, seed=seed) for seed in range(3)], ways=(0.02, 0.002, 0.0005)
    )
    assert (np.diff(near.growth[:, 0]) > 0).all()
    assert (near.growth[:, 1] < 1.1).all()
    assert near.rows()[0]["g from y0 [mm]"] == 20.0
    assert (near.broken[:, 1] <= near.broken[:, 0]).all()


def test_the_decay_term_leaves_nothing_of_the_first_jump():
    found = measure_initial_acceleration(
        [letter(200, 1.5, seed=seed) for seed in range(3)], shift=0.01
    )
    assert np.abs(found.with_term).max() <= 1e-9 * found.without.min()
    alpha = 2 * 18
    np.testing.assert_allclose(found.without, alpha**2 / 4 / 1.5**2 * 0.01)
    assert ((found.fed > 0) & (found.fed < found.without)).all()


def test_a_swinging_spring_and_one_that_lags_pull_with_their_own_stiffness():
    """The authors' program has K = 32 / s^2."""
    found = measure_initial_acceleration([letter(200, 1.5, seed=1)], 0.01, Settings.as_coded())
    np.testing.assert_allclose(found.without, 32 * 0.01)
    assert 0 < found.fed[0] < found.without[0]


def test_joint_speeds_move_the_pen_as_they_should():
    """By another route: the joints turned for a moment, and the pen where the model says."""
    model, arm = Model.load(), arm_at_table()
    limits = np.array([model.joint(name).velocity for name in ARM_JOINTS])
    for k, world in enumerate(([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])):
        q = np.array([START_POSTURES[0], START_POSTURES[0]])
        q[1, 1:] += 1e-4 * arm.speed[:, k] * limits
        X = model.frame("pen_tip", q, JOINTS)
        np.testing.assert_allclose((X[1] - X[0])[:3, 3], 1e-4 * np.array(world), atol=1e-6)
        np.testing.assert_allclose((X[1] - X[0])[:2, 2], 0, atol=1e-6)


def test_twice_as_fast_asks_twice_the_speed_and_four_times_the_torque():
    ink = letter(200, 2.0, seed=6)
    quick = Trajectory(ink.t / 2, ink.position)
    speed, effort = arm_at_table().demand(ink)
    np.testing.assert_allclose(arm_at_table().demand(quick), (2 * speed, 4 * effort))
    assert greatest_acceleration(quick) == pytest.approx(4 * greatest_acceleration(ink))
