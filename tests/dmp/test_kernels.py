"""Kernels share out the phase."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.kernels import KERNELS, Cells, Kernels, Overlap
from dmp_teach.dmp.phases import PHASES

numbers = st.integers(1, 120)
steps = st.integers(2, 1500)
LINEAR = PHASES["linear"]()
EXPONENTIAL = PHASES["exponential"](4.6)
phases = st.sampled_from([LINEAR, EXPONENTIAL, PHASES["exponential"](1.0)])


gaussian = KERNELS["gaussian"]


def falling(phase, m):
    return phase.at(np.arange(m, 0, -1) / m)


@settings(deadline=None)
@given(numbers, steps, phases)
def test_touching_kernels_leave_no_sample_alone_and_share_none(n, m, phase):
    awake = Kernels(n, phase=phase).heights(falling(phase, m)) > 0
    assert (awake.sum(axis=1) == 1).all()


@settings(deadline=None)
@given(
    numbers,
    steps,
    st.floats(0.2, 40) | st.just(math.inf),
    st.sampled_from([0.65, 4.0, math.inf]),
    phases,
)
def test_activations_sum_to_one_or_to_nothing(n, m, width, sigma, phase):
    kernels = Kernels(n, width, gaussian(sigma), phase)
    s = falling(phase, m)
    total = kernels.activations(s).sum(axis=1)
    assert np.all(np.isclose(total, 1) | (total == 0))
    if width >= 1:
        assert np.allclose(total, 1)


@settings(deadline=None)
@given(numbers, steps, st.floats(0.2, 1.0), st.sampled_from([0.65, math.inf]), phases)
def test_cells_take_the_same_sums_as_the_table_of_heights(n, m, width, sigma, phase):
    kernels = Kernels(n, width, gaussian(sigma), phase)
    left = np.sort(np.random.default_rng(n + m).uniform(0, 1, m))[::-1]
    values, weights = (
        np.random.default_rng(n).normal(size=(m, 2)),
        np.random.default_rng(m).normal(size=(n, 2)),
    )
    fast, plain = kernels.over(left), Overlap(kernels.heights(phase.at(left)))
    assert isinstance(fast, Cells)
    assert np.allclose(fast.gather(values), plain.gather(values), rtol=1e-12, atol=1e-12)
    assert np.allclose(fast.blend(weights), plain.blend(weights), rtol=1e-12, atol=1e-12)


def test_centres_and_widths_are_those_of_the_design():
    kernels = Kernels(4, 1.0, gaussian(2.0))
    assert kernels.centers == pytest.approx([0.125, 0.375, 0.625, 0.875])
    s, h = 0.30, (4 / 2.0) ** 2
    assert kernels.heights(np.array([s]))[0] == pytest.approx(
        [0, math.exp(-h / 2 * (s - 0.375) ** 2), 0, 0]
    )
    edges = Kernels(4).heights(np.array([0.0, 0.25, 0.4999999, 0.5, 1.0]))
    assert edges.argmax(axis=1).tolist() == [0, 1, 1, 2, 3]


def test_narrow_kernels_leave_gaps_where_none_is_awake():
    s = np.array([0.0, 0.25, 0.125])
    assert Kernels(4, width=0.5).activations(s).sum(axis=1).tolist() == [0, 0, 1]


@pytest.mark.parametrize("phase", [LINEAR, EXPONENTIAL])
def test_a_phase_runs_from_one_towards_nought_and_knows_its_speed(phase):
    left = np.linspace(1, 0, 2001)
    s = phase.at(left)
    assert s[0] == 1
    assert s[-1] == pytest.approx(0 if phase == LINEAR else math.exp(-4.6))
    assert np.allclose(phase.left(s[:-1]), left[:-1])
    assert np.allclose(-np.gradient(s, -left)[1:-1], phase.speed(s)[1:-1], rtol=1e-4)
