"""From the forcing that is needed to the weights."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.fit import FITS, forcing
from dmp_teach.dmp.integrators import INTEGRATORS, Spring
from dmp_teach.dmp.kernels import KERNELS, Kernels

lwr, bias, joint = (FITS[name]().learn for name in ("lwr", "bias", "joint"))
widths = st.sampled_from(
    [(1.0, math.inf), (0.6, math.inf), (1.0, 0.65), (3.0, 1.0), (math.inf, 0.65)]
)


def case(n, m, width, sigma, seed):
    s = np.arange(m, 0, -1) / m
    F = np.random.default_rng(seed).normal(size=(m, 2))
    spring = Spring(2.0 * max(n, 6), m, INTEGRATORS["semi-implicit"]())
    return Kernels(n, width, KERNELS["gaussian"](sigma)), s, F, spring


@settings(deadline=None)
@given(st.integers(1, 20), st.integers(60, 300), widths, st.integers(0, 99))
def test_lwr_is_the_papers_equation_kernel_by_kernel(n, m, width, seed):
    kernels, s, F, spring = case(n, m, *width, seed)
    w, none = lwr(kernels.over(s), s[:, None], F, spring)
    psi = kernels.heights(s)
    for i in range(n):
        assert w[i] == pytest.approx(
            (psi[:, i] * s) @ F / (psi[:, i] @ (s * s)), rel=1e-9, abs=1e-12
        )
    assert none is None


@settings(deadline=None)
@given(st.integers(1, 20), st.integers(100, 300), widths, st.integers(0, 99))
def test_local_bias_is_the_best_line_of_each_kernel(n, m, width, seed):
    kernels, s, F, spring = case(n, m, *width, seed)
    w, b = bias(kernels.over(s), s[:, None], F, spring)
    psi = kernels.heights(s)
    for i in range(n):
        root = np.sqrt(psi[:, i])
        line = np.linalg.lstsq(
            np.column_stack([s, np.ones_like(s)]) * root[:, None], F * root[:, None], rcond=None
        )[0]
        assert w[i] == pytest.approx(line[0], rel=1e-6, abs=1e-7)
        assert b[i] == pytest.approx(line[1], rel=1e-6, abs=1e-7)


@settings(deadline=None, max_examples=30)
@given(st.integers(2, 20), st.integers(0, 99))
def test_no_other_weights_come_closer_than_the_joint_ones(n, seed):
    kernels, s, F, spring = case(n, 300, math.inf, 0.65, seed)
    laid = kernels.over(s)

    def miss(weights):
        """The squared distance of the two paths, each with its best start velocity."""
        gone, kick = spring.follow(F - forcing(laid, s[:, None], weights, None)), spring.kick()
        return ((gone - kick * (kick * gone).sum(axis=0) / (kick**2).sum()) ** 2).sum()

    w, _ = joint(laid, s[:, None], F, spring)
    best = miss(w)
    assert best <= miss(lwr(laid, s[:, None], F, spring)[0])
    rng = np.random.default_rng(seed)
    for size in (1e-3, 1e-1):
        assert best <= miss(w + size * np.abs(w).max() * rng.normal(size=w.shape)) * (1 + 1e-6)


@settings(deadline=None)
@given(st.integers(1, 20), widths, st.sampled_from([lwr, bias, joint]), st.floats(-5, 5))
def test_adding_a_multiple_of_the_phase_adds_it_to_every_weight(n, width, fit, c):
    kernels, s, F, spring = case(n, 300, *width, 3)
    laid, column = kernels.over(s), s[:, None]
    before, after = fit(laid, column, F, spring)[0], fit(laid, column, F + c * column, spring)[0]
    awake = laid.gather(np.ones_like(column)) > 0
    if width[0] >= 1:
        assert np.allclose(after - before, c, atol=1e-7 * (1 + np.abs(before).max()))
    else:
        assert np.allclose((after - before)[awake[:, 0]], c, atol=1e-7)
    assert np.isfinite(before).all()


def test_a_kernel_with_a_single_sample_learns_no_slope():
    s = np.array([0.9, 0.4])
    kernels, F = Kernels(2), np.array([[1.8], [0.4]])
    w, b = bias(kernels.over(s), s[:, None], F, Spring(12.0, 2, INTEGRATORS["explicit"]()))
    assert w[:, 0] == pytest.approx([1.0, 2.0])
    assert np.abs(b).max() < 1e-12
