"""How a letter was moved, and how it stands."""

from itertools import product

import numpy as np
import pytest
from scipy.signal import find_peaks, savgol_filter

from dmp_teach.ink.alphabet import recording_of
from dmp_teach.scoring.kinematics import count_velocity_peaks, measure_movement, shake, slant
from dmp_teach.scoring.resampling import resample_path
from dmp_teach.trajectory import Trajectory
from tests.laws import for_every


def least_jerk(duration=1.0, rate=120):
    t = np.linspace(0, 1, round(duration * rate) + 1)
    way = t**3 * (10 - 15 * t + 6 * t**2)
    return Trajectory(duration * t, np.column_stack([0.1 * way, 0.05 * way]))


def resampled(stroke, rate):
    t = np.arange(stroke.t[0], stroke.t[-1], 1 / rate)
    return Trajectory(
        t, np.column_stack([np.interp(t, stroke.t, axis) for axis in stroke.position.T])
    )


@pytest.mark.parametrize("duration", [0.5, 1.0, 4.0])
def test_a_stroke_of_least_jerk_is_as_smooth_as_theory_says(duration):
    found = measure_movement([least_jerk(duration)])
    assert found.smoothness == pytest.approx(-np.log(720 / 1.875**2), abs=0.1)
    assert found.peaks == 1


@for_every(product("aDgM8", (40, 60, 100, 250, 1000)))
def test_smoothness_hardly_depends_on_the_sampling_rate(character, rate):
    strokes = recording_of(character).strokes()
    given, other = (
        measure_movement(strokes),
        measure_movement([resampled(stroke, rate) for stroke in strokes]),
    )
    assert other.smoothness == pytest.approx(given.smoothness, abs=0.3)
    assert other.peaks == given.peaks


@pytest.mark.parametrize("character", list("aDgM8"))
def test_smoothness_falls_and_peaks_grow_with_a_shaking_hand_and_little_with_noise(character):
    strokes, rng = recording_of(character).strokes(), np.random.default_rng(0)
    given = measure_movement(strokes)
    noisy = measure_movement(
        [Trajectory(s.t, s.position + rng.normal(0, 1e-4, s.position.shape)) for s in strokes]
    )
    assert noisy.smoothness == pytest.approx(given.smoothness, abs=0.6)
    before = given.smoothness
    for size in (0.0005, 0.001, 0.002, 0.004):
        shaking = measure_movement(
            [Trajectory(s.t, s.position + size * np.sin(38 * s.t)[:, None]) for s in strokes]
        )
        assert shaking.smoothness < before - 0.5
        before = shaking.smoothness
    assert shaking.peaks > given.peaks


def test_size_pace_and_duration_are_those_of_the_ink():
    found = measure_movement(
        [Trajectory([0, 1], [[0, 0], [0.03, 0]]), Trajectory([2, 4], [[0, 0.02], [0, 0.08]])]
    )
    assert (found.strokes, found.width, found.height, found.duration) == (2, 0.03, 0.08, 4.0)
    assert found.pace == pytest.approx(0.09 / 3)


@pytest.mark.parametrize("lean", [-20, -5, 0, 10, 25])
def test_slant_is_the_lean_of_what_is_upright(lean):
    up = np.column_stack([np.zeros(50), np.linspace(0, 0.1, 50)])
    level = np.column_stack([np.linspace(-0.03, 0.03, 30), np.full(30, 0.07)])
    leaned = [path @ [[1, 0], [np.tan(np.radians(lean)), 1]] for path in (up, level)]
    assert slant([Trajectory(np.arange(len(path)), path) for path in leaned]) == pytest.approx(
        lean, abs=0.5
    )


def test_a_tap_has_measures_too():
    tap = Trajectory([0, 0.008], [[0, 0], [0.0002, 0]])
    assert np.isfinite(measure_movement([tap]).smoothness)
    still = Trajectory([1, 1.1], [[0.02, 0.02], [0.02, 0.02]])
    assert measure_movement([tap, still]).strokes == 2


def test_peaks_and_sweeps_are_those_of_scipy():
    random = np.random.default_rng(0)
    for _ in range(200):
        path = random.normal(size=(random.integers(60, 300), 2)).cumsum(axis=0)
        speed = np.concatenate([[0.0], np.linalg.norm(path, axis=1), [0.0]])
        peaks = find_peaks(speed, prominence=speed.max() / 10)[0]
        assert count_velocity_peaks(path) == len(peaks)
        size = np.ptp(path, axis=0).max()
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        points = resample_path(path, int(100 * length / size) + 1)[0]
        off = np.linalg.norm(points - savgol_filter(points, 35, 3, axis=0), axis=1)
        assert shake([path]) == pytest.approx(np.median(off) / size)
