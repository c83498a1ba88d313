"""The spring, forwards and backwards."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import butter, lfilter, sosfiltfilt

from dmp_teach.dmp.integrators import INTEGRATORS, Spring
from dmp_teach.filtering import filter_recursively, lowpass

springs = st.builds(
    lambda alpha, finer, integrator: Spring(
        alpha, int(max(50, 2 * alpha) * finer), INTEGRATORS[integrator]()
    ),
    st.floats(1.0, 200.0),
    st.floats(1.0, 3.0),
    st.sampled_from(["explicit", "semi-implicit"]),
)


@settings(max_examples=60, deadline=None)
@given(springs, st.integers(0, 10**6))
def test_reading_a_path_backwards_and_following_it_draws_it_again(spring, seed):
    z = np.cumsum(np.random.default_rng(seed).normal(size=(spring.steps + 1, 2)), axis=0)
    z -= z[0]
    push, velocity = spring.needed(z)
    assert np.abs(spring.follow(push, velocity) - z).max() <= 1e-9 * np.abs(z).max()


@settings(max_examples=60, deadline=None)
@given(springs)
def test_the_spring_comes_to_rest_at_its_goal_without_passing_it(spring):
    """Critically damped: a constant push of K leads to 1 and never beyond."""
    z = spring.follow(np.full((spring.steps, 1), spring.K))
    assert z.max() <= 1 + 1e-9
    rest = (1 + spring.alpha / 2) * np.exp(-spring.alpha / 2)
    assert z[-1, 0] == pytest.approx(1 - rest, abs=0.06)


@pytest.mark.parametrize(
    ("integrator", "limit"), [("explicit", 4.0), ("semi-implicit", 4 * (2**0.5 - 1))]
)
def test_a_spring_diverges_beyond_the_stated_stiffness_and_not_before(integrator, limit):
    for alpha, calm in ((0.99 * limit * 400, True), (1.01 * limit * 400, False)):
        spring = Spring(alpha, 400, INTEGRATORS[integrator]())
        kicked = np.abs(spring.kick())
        assert (kicked[-20:].max() < kicked[:20].max()) == calm


def test_a_kick_fades():
    kicked = Spring(60.0, 300, INTEGRATORS["explicit"]()).kick()
    assert kicked.max() == pytest.approx(2 / 60 / np.e, rel=0.1)
    assert abs(kicked[-1, 0]) < 1e-9


@pytest.mark.parametrize("samples", [1, 64, 65, 700])
@pytest.mark.parametrize("poles", [(0.9, 0.9), (0.95 + 0.1j, 0.95 - 0.1j), (0.9, 0.5, -0.3)])
def test_our_recursive_filter_is_that_of_scipy(samples, poles):
    x = np.random.default_rng(samples).normal(size=(2, samples))
    recursion = np.poly(poles).real
    known = lfilter([1.0], recursion, x)
    assert np.abs(filter_recursively(tuple(recursion[1:]), x) - known).max() < (
        1e-12 * np.abs(known).max()
    )


@pytest.mark.parametrize("cutoff", [0.01, 0.05, 0.2])
@pytest.mark.parametrize("order", [2, 4])
def test_our_low_pass_is_a_butterworth_filter_forwards_and_backwards(cutoff, order):
    path = np.cumsum(np.random.default_rng(0).normal(size=(300, 2)), axis=0)
    known = sosfiltfilt(butter(order, 2 * cutoff, output="sos"), path, axis=0, padlen=60)
    assert np.abs(lowpass(path, cutoff, 60, order) - known).max() < 1e-12 * np.ptp(path)
