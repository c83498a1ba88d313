"""The fast path against the textbook's loops, SciPy's own integrator, and its own finer steps."""

import warnings
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from dmp_teach.dmp import textbook
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingWarning, TrajectoryError
from dmp_teach.trajectory import from_rollout
from tests.dmp.ink import in_all_its_steps, letter, letters


def swinging(**changes):
    return Settings.star(
        **{"phase": "sigmoid", "damping": 0.6, "kernel_width": 3.0, "kernel_sigma": 1.0} | changes
    )


def smooth(**changes):
    return Settings.star(
        **{"kernel": "mollifier", "kernel_width": 2.5, "integrator": "lagged"} | changes
    )


def unswerving(**changes):
    return Settings.plus(**{"integrator": "exact"} | changes)


PRESETS = [Settings.star, Settings.joint, Settings.plus, Settings.original]
MORE = [swinging, smooth]


def kernel(p, left):
    """The kernels of a primitive at `left` = 1 - t/T, for the textbook's sums."""
    N, phase, width = p.settings.n_kernels, p.settings.phase, p.settings.kernel_width
    if phase == "linear" and p.settings.kernel == "gaussian":
        return textbook.gaussian_kernel(N, p.settings.kernel_sigma, width)
    decay = p.settings.phase_decay

    def psi(x, i):
        # Ends are compared as the primitive compares them: rounding decides on an edge.
        u, middle = min(N * left, np.nextafter(N, 0)), i + 0.5
        if not middle - width / 2 <= u < middle + width / 2:
            return 0.0
        off = u - middle
        if p.settings.kernel == "mollifier":
            return np.exp(-1 / (1 - (2 * off / width) ** 2))
        if phase == "exponential":
            c = np.exp(-decay * (1 - (i + 0.5) / N))
            off = (x - c) / (decay * c / N)
        return np.exp(-0.5 * (off / p.settings.kernel_sigma) ** 2)

    return psi


def acceleration(p, state, left, goal):
    """The equations one sample at a time, from nothing but what the primitive makes public.

    Time in movements; `left` = 1 - t/T.
    """
    alpha, decay = p.settings.alpha, p.settings.phase_decay
    x, fed = left, alpha  # what 1 - x needs of spring and pen
    if p.settings.phase == "exponential":
        x = np.exp(-decay * (1 - left))
        fed = alpha * decay * x - decay**2 * x
    if p.settings.phase == "sigmoid":
        m = p.settings.phase_middle
        k = decay / (1 - m)
        x = (1 + np.exp(-k * m)) / (1 + np.exp(k * (1 - left - m)))
        part = x / (1 + np.exp(-k * m))
        fed = alpha * k * x * (1 - part) - k**2 * x * (1 - part) * (1 - 2 * part)
    original = p.settings.transform == "original"
    law = textbook.original_acceleration if original else textbook.star_acceleration
    psi, found = kernel(p, left), []
    for d, (y, dy) in enumerate(zip(*state, strict=True)):
        f = textbook.forcing_term(
            x, p.weights[:, d], psi, None if p.biases is None else p.biases[:, d]
        )
        beta = alpha / (2 * p.settings.damping) ** 2
        a = law(y, dy, x, f, y0=p.start[d], g=goal[d], alpha_z=alpha, beta_z=beta)
        found.append(a + p.settings.feed_goal * fed * (goal[d] - p.goal[d]))
    return np.array(found)


def plain(p, goal):
    """Step by step, as Algorithms 1 and 2 print it."""
    h, y, v = 1 / p.steps, p.start, p.start_velocity * p.duration
    if p.settings.transform == "original":
        v = v * (goal - p.start) / (p.goal - p.start)
    path = [y]
    for k in range(p.steps):
        a = acceleration(p, (y, v), (p.steps - k) / p.steps, goal)
        moved = v + h * a
        y, v = y + h * (v if p.settings.integrator == "explicit" else moved), moved
        path.append(y)
    return np.array(path)


@pytest.mark.filterwarnings("ignore:Kernels leave gaps")
@settings(max_examples=15, deadline=None)
@given(
    st.integers(0, 999),
    st.sampled_from(["star", "original"]),
    st.sampled_from([(4.0, 1.0), (1.0, 2.5), (0.65, np.inf), (0.5, 0.7)]),
    st.floats(-0.1, 0.1),
)
def test_a_primitive_is_the_papers_algorithm(seed, transform, kernel, shift):
    """Algorithm 1 and Algorithm 2, from the demonstration to the last sample."""
    demo, (sigma, width) = letter(101, 1.0, seed=seed), kernel
    assume(np.abs(demo.position[-1] - demo.position[0]).min() > 1e-3)
    about = {"n_kernels": 7, "alpha": 25.0, "kernel_sigma": sigma, "kernel_width": width}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        p = DMP.imitate(demo, Settings.as_fixed(transform=transform, **about))
    algorithm = textbook.star_dmp if transform == "star" else textbook.original_dmp
    psi, goal = textbook.gaussian_kernel(7, sigma, width), p.goal + shift
    theirs = [
        algorithm(theta, psi, 7, 25.0, g)
        for theta, g in zip(demo.position.T.tolist(), goal, strict=True)
    ]
    assert p.steps == 100
    ours = p.rollout(goal=goal).position
    assert np.abs(ours - np.transpose(theirs)).max() <= 1e-9 * max(1, np.abs(ours).max())


@settings(max_examples=15, deadline=None)
@given(
    letters(),
    st.sampled_from(PRESETS),
    st.sampled_from(
        [
            {},
            {"kernel_width": 0.7},
            {"kernel_width": 2.5},
            {"kernel_width": 0.8, "kernel_sigma": 0.5},
        ]
    ),
    st.floats(-0.1, 0.1),
)
def test_the_fast_path_is_the_plain_loop(demo, preset, changes, shift):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        p = DMP.imitate(demo, preset(**changes, n_kernels=5))
    goal = p.goal + shift
    fast = in_all_its_steps(p, goal)
    assert np.abs(fast - plain(p, goal)).max() <= 1e-12 * max(1, np.abs(fast).max())


@settings(max_examples=15, deadline=None)
@given(letters(), st.sampled_from(PRESETS), st.floats(-0.1, 0.1))
def test_a_rollout_with_only_the_goal_changed_is_the_long_way_to_it(demo, preset, shift):
    p = DMP.imitate(demo, preset(n_kernels=5))
    goal = p.goal + shift
    quick, long = p.rollout(goal=goal), p.rollout(goal=goal, duration=p.duration)
    assert np.abs(quick.position - long.position).max() <= 1e-12 * max(
        1, np.abs(long.position).max()
    )
    plainly = in_all_its_steps(p, goal)[:: p.steps // (len(demo) - 1)]
    assert np.abs(quick.position - plainly).max() <= 1e-12 * max(1, np.abs(plainly).max())
    assert np.array_equal(quick.t, demo.t)
    assert not quick.position.flags.writeable
    as_shown = p.rollout().position
    assert np.abs(p.rollout(goal=p.goal).position - as_shown).max() <= 1e-12 * max(
        1, np.abs(as_shown).max()
    )


@pytest.mark.filterwarnings("ignore:overflow")
def test_what_was_drawn_is_finite_or_named():
    demo = letter(60, 1.0)
    far = DMP.imitate(demo).rollout(goal=[1e200, 0.0])  # a number, though its square is none
    assert far.position[-1, 0] == pytest.approx(1e200, rel=0.1)
    for bad in (np.nan, np.inf):
        broken = demo.position.copy()
        broken[7, 1] = bad
        with pytest.raises(TrajectoryError, match=r"position\[7\] is .* but must be finite"):
            from_rollout(demo.t, broken)


def exact(p, goal, times):
    """The same by SciPy's integrator, kernel by kernel: no jump of f hides in a step."""
    way, D = goal - p.start, len(goal)
    v = (
        p.start_velocity
        * p.duration
        * (way / (p.goal - p.start) if p.settings.transform == "original" else 1)
    )
    N = p.settings.n_kernels
    cuts = np.unique(np.concatenate([np.arange(N + 1) / N, (np.arange(2 * N + 1) / (2 * N))]))
    state, out = np.concatenate([p.start, v]), {0.0: p.start}
    for a, b in pairwise(cuts):

        def rate(t, x, inside=(a, b)):
            left = 1 - min(max(t, inside[0] + 1e-12), inside[1] - 1e-12)
            return np.concatenate([x[D:], acceleration(p, (x[:D], x[D:]), left, goal)])

        wanted = times[(times > a) & (times <= b)]
        solved = solve_ivp(
            rate, (a, b), state, rtol=1e-8, atol=1e-11, t_eval=np.unique([*wanted, b])
        )
        out.update(zip(solved.t, solved.y[:D].T, strict=True))
        state = solved.y[:, -1]
    return np.array([out[t] for t in times])


@pytest.mark.parametrize("preset", [*PRESETS, *MORE])
def test_rollout_agrees_with_solve_ivp_and_halving_the_step_halves_the_error(preset):
    demo = letter(121, 1.0, seed=2)
    p = DMP.imitate(demo, preset(n_kernels=4))
    goal = p.goal + np.array([0.05, -0.03])
    times = np.array([0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0])
    true = exact(p, goal, times)
    errors = []
    for steps in (1600, 3200, 6400, 12800):
        drawn = p.rollout(goal=goal, dt=p.duration / steps).position[:: steps // 8]
        errors.append(np.abs(drawn - true).max())
    assert errors[-1] < 1e-4
    assert np.allclose(np.array(errors[:-1]) / errors[1:], 2.0, atol=0.1)


def test_halving_the_step_of_the_exact_spring_quarters_what_holding_the_push_leaves():
    demo = letter(121, 1.0, seed=2)
    p = DMP.imitate(demo, unswerving(n_kernels=4, smoothing=None))
    goal, times = p.goal + np.array([0.05, -0.03]), np.linspace(0, 1, 9)
    true = exact(p, goal, times)
    errors = [
        np.abs(p.rollout(goal=goal, dt=p.duration / steps).position[:: steps // 8] - true).max()
        for steps in (128, 256, 512)
    ]
    assert errors[0] < 2e-4
    assert np.allclose(np.array(errors[:-1]) / errors[1:], 4.0, atol=0.4)
