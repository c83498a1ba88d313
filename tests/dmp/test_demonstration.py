"""A demonstration is made even and calm, and keeps its ends."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import butter, filtfilt

from dmp_teach.dmp.preprocessing import has_even_times, prepare_demonstration, sharpen_bends, smooth
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import letter, rms, scrawls


@settings(deadline=None, max_examples=40)
@given(st.integers(40, 600), st.floats(0.02, 0.4), st.integers(0, 999))
def test_smoothing_is_scipys_butterworth_forwards_and_backwards(n, cutoff, seed):
    path = np.cumsum(np.random.default_rng(seed).normal(size=(n, 2)), axis=0)
    pad = min(n - 1, int(np.ceil(3 / cutoff)))
    theirs = filtfilt(*butter(2, 2 * cutoff), path, axis=0, padlen=pad)
    along = np.linspace(0, 1, n)[:, None]
    theirs += (path[0] - theirs[0]) * (1 - along) + (path[-1] - theirs[-1]) * along
    assert np.abs(smooth(path, cutoff) - theirs).max() <= 1e-9 * np.abs(path).max()


@settings(deadline=None, max_examples=60)
@given(scrawls(), st.sampled_from([None, 10.0]), st.floats(2, 400))
def test_both_ends_and_the_number_of_steps_are_kept(demo, cutoff, least):
    path, _ = prepare_demonstration(demo, cutoff, least)
    steps = len(path) - 1
    assert steps >= least
    assert steps % (len(demo) - 1) == 0
    assert np.array_equal(path[0], demo.position[0])
    assert np.array_equal(path[-1], demo.position[-1])


def test_trembling_goes_and_a_straight_line_stays():
    t = np.arange(300) / 120
    line = np.outer(t, [0.1, -0.05])
    tremble = 0.001 * np.sin(2 * np.pi * 40 * t)[:, None]
    assert np.abs(smooth(line, 10 / 120) - line).max() < 1e-8
    assert np.abs(smooth(line + tremble, 10 / 120) - line)[10:-10].max() < 2e-5


@pytest.mark.parametrize(
    ("n", "rate", "why"),
    [
        (
            15,
            120,
            "Not smoothed: 15 samples at 120 a second; a filter of 10 Hz needs at least 20 "
            "samples at 25 a second.",
        ),
        (
            60,
            20,
            "Not smoothed: 60 samples at 20 a second; a filter of 10 Hz needs at least 20 "
            "samples at 25 a second.",
        ),
        (
            50,
            1000,
            "Not smoothed: 50 samples at 1000 a second; a filter of 10 Hz needs at least 100 "
            "samples at 25 a sec",
        ),
    ],
)
def test_where_smoothing_cannot_work_it_is_left_out_and_the_primitive_says_so(n, rate, why):
    p = DMP.imitate(letter(n, (n - 1) / rate))
    assert len(p.notes) == 1
    assert p.notes[0].startswith(why)
    assert not DMP.imitate(letter(n, (n - 1) / rate), Settings.star(smoothing=None)).notes


def test_uneven_times_are_resampled_and_the_primitive_says_so():
    smooth, rng = letter(2000, 2.5, seed=4), np.random.default_rng(0)
    picked = np.sort(
        np.concatenate([[0, 1999], rng.choice(np.arange(1, 1999), 150, replace=False)])
    )
    uneven = Trajectory(smooth.t[picked], smooth.position[picked])
    p = DMP.imitate(uneven)
    assert p.notes == ("Times were uneven: resampled at 60.4 samples a second.",)
    assert np.array_equal(p.rollout().t, uneven.t)
    assert rms(p.rollout().position, uneven.position) < 0.5
    assert not DMP.imitate(smooth).notes


@pytest.mark.parametrize("digits", [3, 6])
def test_times_rounded_by_a_file_are_even_to_a_hundredth_of_a_step(digits):
    t = np.round(np.arange(500) / 120, digits)
    assert has_even_times(t) == (digits == 6)


@settings(deadline=None, max_examples=40)
@given(st.integers(2, 200), st.floats(0.3, 60))
def test_sharpening_leaves_lines_and_ends_alone(n, spacing):
    line = np.outer(np.linspace(0, 1, n), [1.0, -2.0])
    assert np.abs(sharpen_bends(line, spacing) - line).max() < 1e-9
    scrawl = np.random.default_rng(n).normal(size=(n, 2))
    assert np.allclose(sharpen_bends(scrawl, spacing)[[0, -1]], scrawl[[0, -1]], atol=1e-12)


def test_sharpening_takes_off_what_touching_boxes_round_off():
    """A slow wave is rounded by (w h)^2/12 of itself, in theory; sharpen_bends, ten times less."""
    n, waves = 1201, 4
    u = np.linspace(0, 1, n)
    wave = Trajectory(10 * u, 0.05 * np.sin(2 * np.pi * waves * u))
    inner = slice(n // 8, -n // 8)
    lost = []
    for sharpen in (False, True):
        p = DMP.imitate(wave, Settings.star(n_kernels=60, sharpen=sharpen, smoothing=None))
        drawn = p.rollout().position[inner, 0]
        pure = np.sin(2 * np.pi * waves * u[inner])
        lost.append(1 - drawn @ pure / (0.05 * pure @ pure))
    theory = (2 * np.pi * waves / 60) ** 2 / 12
    assert lost[0] == pytest.approx(theory, rel=0.05)
    assert abs(lost[1]) < 0.1 * theory
