"""Each variant that the paper names: that it is what its source says, and what it is good for."""

import math
import warnings

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from dmp_teach.dmp.equation import Equation
from dmp_teach.dmp.integrators import INTEGRATORS, Spring, least_steps
from dmp_teach.dmp.kernels import KERNELS, PLACEMENTS, Kernels
from dmp_teach.dmp.phases import PHASES
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.dmp.transformations import similarity_matrix
from dmp_teach.errors import SettingWarning
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter, letters, rms

few = settings(max_examples=40, deadline=None)
ways = st.integers(0, 10**6).map(np.random.default_rng)


def test_a_sigmoid_phase_stays_up_and_then_falls_and_is_kulvicius_differential_equation():
    phase, left = PHASES["sigmoid"](4.6, 0.75), np.linspace(1, 0, 4001)
    s, k = phase.at(left), 4.6 / 0.25
    assert s[0] == 1
    assert s[1500] > 0.98
    assert np.interp(0.25, left[::-1], s[::-1]) == pytest.approx(0.5, abs=1e-3)
    assert s[-1] == pytest.approx(math.exp(-4.6), rel=0.02)
    e = np.exp(k * (0.75 - (1 - left)))  # ds/dt = -k e / (1 + e)^2, but for its beginning at 1
    assert np.allclose(phase.speed(s), k * e / (1 + e) ** 2, rtol=1e-4)


def test_a_mollifier_is_smooth_and_falls_to_nought_at_its_ends():
    """DMP++: exp(-1/(1 - r^2)) with compact support; all its derivatives are 0 at the ends."""
    kernels = Kernels(5, 2.0, KERNELS["mollifier"]())
    s = np.linspace(0.3, 0.7, 401)
    middle = kernels.heights(s)[:, 2]
    r = (s - 0.5) / 0.2
    inside = np.abs(r) < 1 - 1e-9
    assert np.allclose(middle[inside], np.exp(-1 / (1 - r[inside] ** 2)))
    assert middle[[0, -1]].max() < 1e-12
    assert np.abs(np.diff(middle, 3)).max() < 1e-3
    assert np.allclose(kernels.activations(np.linspace(0, 1, 501)).sum(axis=1), 1)


def test_a_one_sided_kernel_is_awake_wherever_the_paper_prints_it():
    """x - c_i <= theta, without the bars of an absolute value."""
    s = np.linspace(0, 1, 101)
    kernels = Kernels(4, 1.0, placement=PLACEMENTS["ends"](), sides="one")
    theta, centers = 1 / 8, np.array([0, 1 / 3, 2 / 3, 1])
    assert kernels.centers == pytest.approx(centers)
    clear = np.abs(s[:, None] - centers - theta) > 1e-9
    assert np.array_equal((kernels.heights(s) > 0)[clear], (s[:, None] - centers <= theta)[clear])


@pytest.mark.parametrize(
    ("stand", "centers"),
    [
        ("phases", [0.125, 0.375, 0.625, 0.875]),
        ("ends", [0, 1 / 3, 2 / 3, 1]),
        ("grid", [0.25, 0.5, 0.75, 1]),
    ],
)
@pytest.mark.parametrize("phase", [PHASES["linear"](), PHASES["exponential"](1.0)])
def test_centres_that_are_phases_are_phases_whatever_the_clock(stand, centers, phase):
    kernels = Kernels(4, 1.0, KERNELS["gaussian"](0.5), phase, PLACEMENTS[stand]())
    assert kernels.centers == pytest.approx(centers)
    assert np.diagonal(kernels.heights(kernels.centers))[:-1] == pytest.approx(1)
    assert kernels.heights(np.array([centers[1] + 0.1]))[0, 1] == pytest.approx(
        math.exp(-0.5 * 0.8**2)
    )


@few
@given(ways, st.integers(1, 4))
def test_a_similarity_carries_way_onto_way_and_turns_no_more_than_it_must(rng, D):
    taught, way = rng.normal(size=(2, D))
    S = similarity_matrix(taught, way)
    scale = np.linalg.norm(way) / np.linalg.norm(taught)
    assert S @ taught == pytest.approx(way, abs=1e-9)
    assert np.allclose(S.T @ S, scale**2 * np.eye(D))
    if D > 1:
        assert np.linalg.det(S) > 0
        Q = np.linalg.qr(np.column_stack([taught, way, rng.normal(size=(D, max(0, D - 2)))]))[0]
        for across in Q[:, 2:].T:  # what is square to both stays where it is
            assert S @ across == pytest.approx(scale * across, abs=1e-9)


@pytest.mark.parametrize(
    "way", [[1.0, 0.5], [0.3, -0.2, 0.1], [0.0, 0.0, 2.0], [-1.0], [1.0, 2.0, 3.0, 4.0]]
)
def test_a_way_turned_right_round_is_turned_in_the_page_and_a_line_is_turned_over(way):
    way = np.array(way)
    S = similarity_matrix(way, -way)
    assert S @ way == pytest.approx(-way)
    assert np.allclose(S.T @ S, np.eye(len(way)))
    assert np.linalg.det(S) == pytest.approx(-1 if len(way) == 1 else 1)
    if len(way) == 3 and way[2] == 0.1:
        page = np.array([way[1], -way[0], 0.0])
        assert S @ page == pytest.approx(-page)


@few
@given(letters(), ways)
def test_a_similar_letter_is_the_letter_turned_and_scaled_and_its_start_velocity_too(demo, rng):
    way = demo.position[-1] - demo.position[0]
    assume(np.linalg.norm(way) > 1e-3)
    p = DMP.imitate(demo, Settings.star(transform="similarity"))
    new = rng.normal(size=len(way))
    drawn, S = p.rollout(goal=p.start + new).position - p.start, similarity_matrix(way, new)
    assert np.allclose(
        drawn, (p.rollout().position - p.start) @ S.T, atol=1e-9 * np.abs(drawn).max()
    )
    star = DMP.imitate(demo).rollout().position
    assert np.array_equal(p.rollout().position, star)


@few
@given(st.floats(1, 200), st.floats(0.1, 2.0), st.floats(1e-4, 0.1))
def test_the_exact_spring_is_the_matrix_exponential(alpha, damping, h):
    K = (alpha / (2 * damping)) ** 2
    assert np.allclose(
        INTEGRATORS["exact"]().system(K, alpha, h)[0],
        expm(h * np.array([[0, 1], [-K, -alpha]])),
        rtol=1e-7,
        atol=1e-9,
    )


def test_the_exact_spring_follows_a_held_push_to_the_last_digit_whatever_its_steps():
    coarse, fine = (Spring(60.0, steps, INTEGRATORS["exact"]()) for steps in (50, 400))
    push = np.random.default_rng(0).normal(size=(50, 2))
    a, b = coarse.follow(push, np.ones(2)), fine.follow(np.repeat(push, 8, axis=0), np.ones(2))
    assert np.abs(a - b[::8]).max() < 1e-14


@pytest.mark.parametrize("preset", [Settings.star, Settings.joint, Settings.plus])
def test_with_the_exact_spring_a_finer_dt_draws_the_same_path_where_kernels_end_at_a_step(preset):
    demo = letter(301, 2.5, seed=4)
    p = DMP.imitate(demo, preset(integrator="exact"))
    assert rms(p.rollout(dt=2.5 / 3000).position[::10], p.rollout().position) < 0.05
    assert rms(p.rollout().position, demo.position) < 0.5


@few
@given(
    st.floats(1, 200),
    st.floats(0.1, 2.0),
    st.sampled_from(list(INTEGRATORS)),
)
def test_in_the_steps_that_it_is_given_no_spring_diverges(alpha, damping, integrator):
    steps = math.ceil(least_steps(alpha, damping))
    kicked = np.abs(
        Spring(8 * alpha, 8 * steps, INTEGRATORS[integrator](), damping).kick()
    )  # the same steps, eight times as long
    assert kicked[6 * steps :].max() <= kicked[: 2 * steps].max()


def test_the_lagged_spring_is_algorithm_1_line_by_line():
    spring = Spring(20.0, 80, INTEGRATORS["lagged"](), 0.35)
    push = np.random.default_rng(1).normal(size=(80, 1))
    h, y, dy, ddy, path = 1 / 80, 0.0, 0.3, 0.0, [0.0]
    for t in range(1, 81):
        now = push[min(t, 79), 0] - spring.K * y - 20.0 * dy  # y''_t, of y and y' at t - 1
        dy, y, ddy = dy + ddy * h, y + dy * h, now
        path.append(y)
    assert np.allclose(spring.follow(push, 0.3)[:, 0], path)


@few
@given(letters(), st.sampled_from(list(INTEGRATORS)))
def test_central_differences_need_a_push_close_to_that_of_the_exact_inverse(demo, integrator):
    z = demo.position - demo.position[0]
    spring = Spring(30.0, len(z) - 1, INTEGRATORS[integrator]())
    assume(len(z) > 200)
    (push, v), (central, v_central) = spring.needed(z), spring.needed(z, "central")
    assert push.shape == (len(z) - 1, z.shape[1])
    central = central[: len(push)]
    size = np.abs(push).max()
    assert np.abs(push - central)[3:-3].max() < 0.25 * size
    assert v == pytest.approx(v_central, abs=0.1 * np.abs(np.diff(z, axis=0)).max() * len(z))


@pytest.mark.parametrize("phase", list(PHASES))
@pytest.mark.parametrize("fit", ["lwr", "bias", "joint"])
@pytest.mark.parametrize(
    "kernel", [{}, {"kernel": "mollifier", "kernel_width": 2.5}, {"kernel_sigma": 0.65}]
)
def test_every_phase_kernel_and_fit_draws_a_letter_within_its_millimetres(phase, fit, kernel):
    about = {"kernel_width": 2.0, **kernel, "phase": phase, "fit": fit}
    for seed in range(4):
        demo = letter(301, 2.5, seed=seed)
        drawn = DMP.imitate(demo, Settings.star(**about)).rollout().position
        assert (
            rms(drawn, demo.position) < {"lwr": 6.0, "bias": 1.0, "joint": 1.0}[fit]
        )  # overlap is what LWR ignores


def test_only_with_feed_forward_does_a_moved_goal_of_the_linear_phase_arrive():
    for feed, miss in ((True, 0.0), (False, 4 / 60)):
        answer = Equation(Settings.star(alpha=60.0, n_kernels=30, feed_goal=feed), 600).goal_gain()
        assert 1 - answer[-1, 0] == pytest.approx(miss, rel=0.01, abs=1e-6)


@pytest.mark.parametrize("phase", ["exponential", "sigmoid"])
@pytest.mark.parametrize("alpha", [12.0, 30.0, 60.0])
def test_a_goal_that_is_fed_forward_moves_the_path_by_what_the_phase_has_run_down(phase, alpha):
    equation = Equation(
        Settings.star(alpha=alpha, n_kernels=6, phase=phase, integrator="exact"), 4000
    )
    moved, s = equation.goal_gain()[:, 0], PHASES[phase]().at(np.linspace(1, 0, 4001))
    late = (
        np.linspace(0, 1, 4001) > 16 / alpha
    )  # by then the pen has forgotten that it began at rest
    assert np.abs(moved - (1 - s))[late].max(initial=0) < 0.01
    assert abs(1 - moved[-1]) < 0.03


@pytest.mark.parametrize("phase", list(PHASES))
def test_truncated_kernels_touch_gap_and_overlap_by_their_width(phase):
    s = PHASES[phase]().at(np.linspace(1, 0.002, 499))
    touching, gapped, overlapping = (
        (Kernels(10, width, KERNELS["gaussian"](0.5), PHASES[phase]()).heights(s) > 0).sum(axis=1)
        for width in (1.0, 0.6, 1.5)
    )
    assert set(touching) == {1}
    assert set(gapped) == {0, 1}
    assert set(overlapping[60:-60]) == {1, 2}


def test_a_swinging_spring_learns_too():
    demo = letter(301, 2.5, seed=1)
    p = DMP.imitate(demo, Settings.star(damping=0.4))
    assert p.steps >= 2 * p.settings.alpha / 0.16
    assert rms(p.rollout().position, demo.position) < 1.0


def test_touching_kernels_say_nothing_and_gaps_are_said_once():
    demo = letter(300, 2.5)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for kind in (
            {},
            {"kernel_width": 2.0},
            {"kernel_sigma": 0.5},
            {"kernel_width": math.inf, "kernel_sigma": 0.65},
        ):
            assert DMP.imitate(demo, Settings.star(**kind)).notes == ()
    with pytest.warns(SettingWarning) as caught:
        DMP.imitate(demo, Settings.star(kernel_width=0.6))
    assert len(caught) == 1
    assert caught[0].filename == __file__


def test_a_stroke_that_stands_still_is_learned_by_dmp_star():
    still = Trajectory(np.linspace(0, 1, 50), np.full((50, 2), 0.3))
    for preset in (
        Settings.star,
        Settings.joint,
        Settings.plus,
        Settings.as_fixed,
        Settings.as_coded,
    ):
        assert DMP.imitate(still, preset()).rollout().position == pytest.approx(0.3)
