"""The primitive as a value, and every sentence it may answer with."""

import dataclasses
import math

import numpy as np
import pytest

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, TrajectoryError
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter


@pytest.fixture
def p():
    return DMP.imitate(letter())


def test_shapes_and_resolved_settings(p):
    assert p.weights.shape == (30, 2)
    assert p.biases is None
    assert p.start.shape == p.goal.shape == p.start_velocity.shape == (2,)
    assert p.duration == 2.5
    assert (p.settings.n_kernels, p.settings.alpha) == (30, 60.0)
    assert p.kernels.number == 30
    assert p.kernels.activations(np.array([0.99]))[0, -1] == 1
    plus = DMP.imitate(letter(), Settings.plus())
    assert plus.biases.shape == plus.weights.shape
    with pytest.raises(dataclasses.FrozenInstanceError):
        p.goal = p.start


def test_kept_responses_are_what_would_be_drawn_anew(p):
    fresh = dataclasses.replace(p)
    assert "nominal_path" not in vars(fresh)
    goal = p.goal + 0.02
    assert np.allclose(fresh.rollout(goal=goal).position, p.rollout(goal=goal).position, atol=1e-14)


def test_old_names_stay_for_one_version(p):
    with pytest.warns(DeprecationWarning, match="DMP.shown is now called nominal_path"):
        assert p.shown is p.nominal_path
    with pytest.warns(DeprecationWarning, match="DMP.showing is now called with_path"):
        same = p.showing(2 * p.nominal_path)
    assert np.array_equal(same.nominal_path, 2 * p.nominal_path)


def test_a_pen_that_is_already_moving_starts_with_its_speed():
    t = np.linspace(0, 1, 121)
    p = DMP.imitate(Trajectory(t, np.column_stack([0.2 * t, -0.1 * t])))
    assert p.start_velocity == pytest.approx([0.2, -0.1], rel=0.02)


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        (
            {"goal": [1.0, 2.0, 3.0]},
            r"goal has shape \(3,\), but this movement has 2 dimensions: give 2 numbers \[m\].",
        ),
        (
            {"start": 1.0},
            r"start has shape \(\), but this movement has 2 dimensions: give 2 numbers \[m\].",
        ),
        ({"goal": [0.1, math.nan]}, r"goal is \[0.1 +nan\], but it must be finite \[m\]."),
        ({"start": [math.inf, 0]}, r"start is \[inf +0.\], but it must be finite \[m\]."),
        ({"goal": "right"}, r"goal is 'right', but it must be 2 numbers \[m\]."),
        ({"duration": 0.0}, "duration is 0.0, but it must be a time longer than 0 s."),
        ({"duration": -1}, "duration is -1, but it must be a time longer than 0 s."),
        ({"duration": math.nan}, "duration is nan, but it must be a time longer than 0 s."),
        ({"dt": 0}, "dt is 0, but it must be a time longer than 0 s."),
        ({"dt": "fast"}, "dt is 'fast', but it must be a time longer than 0 s."),
        ({"dt": 9.0}, "dt is 9 s, but the movement lasts only 2.5 s; dt must be shorter."),
        ({"dt": 1e-9}, "dt is 1e-09 s, but must be at least 1.25e-06 s for 2.5 s."),
    ],
)
def test_what_cannot_be_drawn_is_said_in_a_sentence(p, asked, answer):
    with pytest.raises(TrajectoryError, match=f"^{answer}$"):
        p.rollout(**asked)


def test_only_a_trajectory_can_be_imitated():
    with pytest.raises(
        TrajectoryError, match=r"learned from a Trajectory\(t, position\), but got an ndarray\."
    ):
        DMP.imitate(np.zeros((10, 2)))


def test_more_kernels_than_samples_are_refused():
    with pytest.raises(
        SettingError,
        match=r"n_kernels is 9, but the trajectory has only 8 samples; use at most 8\.",
    ):
        DMP.imitate(letter(8), Settings.star(n_kernels=9))
    assert DMP.imitate(letter(8), Settings.star(n_kernels=8)).weights.shape == (8, 2)


@pytest.mark.parametrize("alpha", [1.0, 500.0, 10_000.0])
@pytest.mark.parametrize(
    "preset", [Settings.star, Settings.joint, Settings.plus, Settings.original]
)
def test_any_stiffness_that_is_taken_is_followed(alpha, preset):
    demo = letter()
    drawn = DMP.imitate(demo, preset(alpha=alpha)).rollout().position
    assert np.abs(drawn - demo.position).max() < (0.1 if alpha > 1 else 10)


def test_a_primitive_says_in_one_line_what_it_is():
    t = np.linspace(0, 2, 241)
    learned = DMP.imitate(
        Trajectory(t, np.column_stack([np.sin(t), t])), Settings.star(n_kernels=20)
    )
    assert repr(learned) == "DMP(20 kernels, 2-D, 2.000 s, star)"
