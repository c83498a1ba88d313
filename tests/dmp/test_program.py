"""The authors' program: `as_coded` against its formulas, written down once more on their own.

Two classes, one for DMP* and one for the original form, at 120 samples a second; x_i = 1 - i/n,
c_j = j/N, alpha 4, beta 8, every step with the acceleration of the step before.
"""

import math
import warnings

import numpy as np
import pytest

from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingWarning
from dmp_teach.segmentation.paper_rules import find_strokes_by_program
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter

ORIGINAL = {"transform": "original", "kernel_spread": 0.02}
# By the kind: theta in 1/N, what is beyond it, sigma^2, and the same as changes of `as_coded`.
KINDS = {
    "DMP*, 1/N to both sides": (True, 1.0, 0.0, 0.5, {}),
    "DMP*, full": (True, math.inf, 0.0, 4e-4, {"kernel_spread": 0.02, "kernel_width": math.inf}),
    "original, 2/3N": (
        *(False, 1 / 3, 1e-10, 4e-4),
        ORIGINAL | {"kernel_width": 2 / 3, "kernel_floor": 1e-10},
    ),
    "original, 10/N": (False, 5.0, 0.0, 4e-4, ORIGINAL | {"kernel_width": 10.0}),
    "original, full": (False, math.inf, 0.0, 4e-4, ORIGINAL | {"kernel_width": math.inf}),
}


def by_formulas(y, N, kind, goal_error):
    """One coordinate as the program learns and draws it."""
    is_star, theta, beyond, variance, _ = kind
    n, dt, K = len(y), 1 / 120, 4.0 * 8.0
    dy = np.gradient(y, dt)
    ddy = np.gradient(dy, dt)
    x = np.array([1 - i / n for i in range(n)])
    far = x[:, None] - np.array([j / N for j in range(1, N + 1)])
    psi = np.where(np.abs(far) <= theta / N, np.exp(-(far**2) / (2 * variance)), beyond)
    way = y[-1] - y[0]
    f = ddy - 4.0 * (8.0 * (y[-1] - y) - dy) + (K * x * way if is_star else 0.0)
    s = x * (K if is_star else way)
    w = (psi.T @ (s * f)) / (psi.T @ (s * s))
    f = psi @ w / psi.sum(axis=1) * x * (K if is_star else way + goal_error)
    if is_star:
        f -= K * x * (way + goal_error)
    drawn, v, a = [y[0]], dy[0], 0.0
    for i in range(1, n):
        new = 4.0 * (8.0 * (y[-1] + goal_error - drawn[-1]) - v) + f[i]
        drawn.append(drawn[-1] + v * dt)
        v, a = v + a * dt, new
    return np.array(drawn)


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
@pytest.mark.parametrize(("samples", "N"), [(300, 30), (301, 200), (97, 9)])
def test_as_coded_is_the_program_line_by_line(kind, samples, N):
    demo = letter(samples, (samples - 1) / 120, seed=samples)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SettingWarning)
        learned = DMP.imitate(demo, Settings.as_coded(n_kernels=N, **kind[-1]))
    for error in (0.0, 0.1):
        drawn = learned.rollout(goal=learned.goal + error).position
        columns = [by_formulas(y, N, kind, error) for y in demo.position.T]
        assert np.abs(drawn - np.column_stack(columns)).max() < 1e-9


def test_the_last_of_its_kernels_leaves_the_end_bare_where_it_gives_nan_and_we_nought():
    demo = letter(300, 299 / 120)
    with pytest.warns(SettingWarning, match=r"2\.4\d+ to 2\.4\d+ s from its start"):
        learned = DMP.imitate(demo, Settings.as_coded(kernel_width=1.0))
    assert np.isfinite(learned.rollout().position).all()


def test_a_kept_start_velocity_leaves_a_goal_on_the_start_and_a_scaled_one_stays():
    demo = letter(200, 199 / 120, seed=4)
    demo = Trajectory(demo.t, demo.position + np.linspace(0, 0.05, 200)[:, None])
    for velocity, far in (("measured", False), ("kept", True)):
        learned = DMP.imitate(demo, Settings.original(start_velocity=velocity))
        away = learned.rollout(goal=learned.start).position - learned.start
        assert (np.abs(away).max() > 1e-4) == far


def test_strokes_by_the_programs_fixed_numbers():
    """Sample 100 on, 6 mm off and faster than 0.1 m/s; marks within 20 samples are one lift."""
    t, z = np.arange(400) / 120, np.zeros(400)
    z[20:40] = 0.05 * np.sin(np.linspace(0, np.pi, 20))
    z[200:240] = 0.05 * np.sin(np.linspace(0, np.pi, 40))
    position = np.column_stack([t, t, z])
    marks = np.flatnonzero((np.abs(z) > 0.006) & (np.abs(np.gradient(z, t)) > 0.1))
    marks = marks[marks >= 100]
    assert find_strokes_by_program(t, position) == ((0, marks[0]), (marks[-1], 400))
