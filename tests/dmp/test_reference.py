"""The fast path against a plain loop, against SciPy's own integrator, and against its own finer steps."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import TrajectoryError
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter, letters


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


def acceleration(p, state, left, way, change):
    """The equations of the design, one sample at a time, from nothing but what the primitive makes public.

    Time in movements; `left` = 1 - t/T.
    """
    y, v = state
    N, alpha = p.settings.n_kernels, p.settings.alpha
    K, decay = (alpha / (2 * p.settings.damping)) ** 2, p.settings.phase_decay
    linear, sigmoid = p.settings.phase == "linear", p.settings.phase == "sigmoid"
    s = left if linear else np.exp(-decay * (1 - left))
    fed = (
        alpha if linear else alpha * decay * s - decay**2 * s
    )  # what 1 - s needs of spring and pen
    if sigmoid:
        m = p.settings.phase_middle
        k = decay / (1 - m)
        s = (1 + np.exp(-k * m)) / (1 + np.exp(k * (1 - left - m)))
        part = s / (1 + np.exp(-k * m))
        fed = alpha * k * s * (1 - part) - k**2 * s * (1 - part) * (1 - 2 * part)
    above, below = np.zeros(len(y)), 0.0
    for i in range(1, N + 1):
        middle = (i - 0.5) / N
        c = middle if linear else np.exp(-decay * (1 - middle))
        spacing = 1 / N if linear else decay * c / N
        u, half = N * left, p.settings.kernel_width / 2
        if i - 0.5 - half <= u < i - 0.5 + half or (u == N == i - 0.5 + half):
            psi = np.exp(-0.5 * ((s - c) / (p.settings.kernel_sigma * spacing)) ** 2)
            if sigmoid:  # round in time
                psi = np.exp(-0.5 * ((u - i + 0.5) / p.settings.kernel_sigma) ** 2)
            if p.settings.kernel == "mollifier":
                psi = np.exp(-1 / (1 - ((u - i + 0.5) / half) ** 2))
            above += psi * (p.weights[i - 1] * s + (0 if p.biases is None else p.biases[i - 1]))
            below += psi
    f = above / below if below > 0 else above
    if p.settings.transform == "original":
        return K * (p.start + way - y) - alpha * v + way * f
    fed = change * fed if p.settings.feed_goal else 0
    return K * (p.start + way - y) - alpha * v - K * way * s + K * f + fed


def plain(p, goal, steps):
    """Step by step, as Algorithms 1 and 2 print it."""
    h, way = 1 / steps, goal - p.start
    change = way - (p.goal - p.start)
    v = p.start_velocity * p.duration
    if p.settings.transform == "original":
        v = v * way / (p.goal - p.start)
    y, path = p.start.copy(), [p.start.copy()]
    for k in range(steps):
        a = acceleration(p, (y, v), (steps - k) / steps, way, change)
        if p.settings.integrator == "explicit":
            y, v = y + h * v, v + h * a
        else:
            v = v + h * a
            y = y + h * v
        path.append(y.copy())
    return np.array(path)


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
    p = DMP.imitate(demo, preset(**changes, n_kernels=5))
    goal = p.goal + shift
    fast = p._path(goal - p.start, p.steps) + p.start
    assert np.abs(fast - plain(p, goal, p.steps)).max() <= 1e-12 * max(1, np.abs(fast).max())


@settings(max_examples=15, deadline=None)
@given(letters(), st.sampled_from(PRESETS), st.floats(-0.1, 0.1))
def test_a_rollout_with_only_the_goal_changed_is_the_long_way_to_it(demo, preset, shift):
    p = DMP.imitate(demo, preset(n_kernels=5))
    goal = p.goal + shift
    quick, long = p.rollout(goal=goal), p.rollout(goal=goal, duration=p.duration)
    assert np.abs(quick.position - long.position).max() <= 1e-12 * max(
        1, np.abs(long.position).max()
    )
    plainly = (p.start + p._path(goal - p.start, p.steps))[p._own]
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
            Trajectory._drawn(demo.t, broken)


def exact(p, goal, times):
    """The same movement by SciPy's integrator, kernel by kernel so that no jump of the forcing hides in a step."""
    way = goal - p.start
    change, D = way - (p.goal - p.start), len(way)
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
            return np.concatenate([x[D:], acceleration(p, (x[:D], x[D:]), left, way, change)])

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
