"""A rollout is a sum of paths: what `Responses` adds up is what `DMP.rollout` draws."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import dmp_teach
from dmp_teach.dmp.presets import PRESETS
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.responses import Responses
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingError, SettingWarning, TrajectoryError
from tests.dmp.ink import letter, letters
from tests.dmp.test_every_law import calm, variants

numbers = st.integers(0, 10**6).map(np.random.default_rng)


def learned(demo, kind):
    way = np.abs(demo.position[-1] - demo.position[0])
    assume(kind.transform == "star" or way.min() > 1e-2 * np.ptp(demo.position))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        return DMP.imitate(demo, kind)


def keeps_the_law(p, rng):
    """Goal and weights, each alone, and both where they add up."""
    size = np.ptp(p.rollout().position)
    goal = p.goal + size * rng.uniform(-2, 2, len(p.goal))
    weights = p.weights + np.abs(p.weights).max() * rng.normal(size=p.weights.shape)
    other, responses = replace(p, weights=weights), Responses(p)
    if p.settings.transform == "similarity" and len(goal) > 2:
        with pytest.raises(SettingError, match="not affine in its goal"):
            responses.at(goal)
    else:
        same(responses.at(goal), p.rollout(goal=goal), size)
    same(responses.at(weights=weights), other.rollout(), size)
    if p.settings.transform == "star":
        same(responses.at(goal, weights), other.rollout(goal=goal), size)
    else:
        with pytest.raises(SettingError, match="a goal or weights"):
            responses.at(goal, weights)


def same(path, drawn, size):
    assert np.abs(path - drawn.position).max() <= 1e-9 * max(size, np.ptp(drawn.position))


@settings(max_examples=60, **calm)
@given(letters(), st.sampled_from(list(PRESETS)), numbers)
def test_every_preset_is_affine_in_its_goal_and_in_its_weights(demo, name, rng):
    keeps_the_law(learned(demo, getattr(Settings, name)()), rng)


@settings(max_examples=200, **calm)
@given(letters(), variants, numbers)
def test_every_kernel_phase_fit_and_integrator_is(demo, variant, rng):
    kernels, rest = variant
    assume(rest["fit"] != "joint" or len(demo) < 500)
    keeps_the_law(learned(demo, Settings.star(**kernels, **rest)), rng)


def test_nothing_asked_for_is_the_rollout_and_shapes_are_as_said():
    p = DMP.imitate(letter(120), Settings.star(n_kernels=7))
    responses = Responses(p)
    assert np.array_equal(responses.at(), p.rollout().position)
    assert responses.to_goal.shape == (2, 120, 2)
    assert responses.to_weights.shape == (7, 120, 2)
    for wrong in (p.weights[:-1], p.weights[:, :1], 1.0):
        with pytest.raises(TrajectoryError, match=r"shape \(7, 2\)"):
            responses.at(weights=wrong)


def test_a_letter_gives_those_of_each_stroke():
    made = dmp_teach.Letter.learn(dmp_teach.recording_of("D"))
    assert [each.primitive for each in made.responses] == list(made.primitives)
    goal = made.primitives[1].goal + 0.03
    same(made.responses[1].at(goal), made.write(goals={1: goal})[1], 0.1)
