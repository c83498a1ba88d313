import numpy as np
import pytest

from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import interpolate
from dmp_teach.robot.smoothing import LARGEST_STEP, PATH_TOLERANCE, measure_steps, smooth_stroke
from dmp_teach.trajectory import Trajectory
from tests.recordings import RECORDINGS, needs_recordings
from tests.robot import ink
from tests.robot.ink import LETTER, distances, law

PAGE = Page.table()
SAMPLE = [(letter, alphabet) for alphabet in alphabets() for letter in "aekD6"]


def assert_no_larger_steps(recording):
    """The arm's steps are at most the recording's, and the tip's path is the letter's."""
    letter = Letter.learn(recording).write()
    motion, shown = Fetch().write(letter, PAGE), Fetch().write(recording.strokes(), PAGE)
    assert measure_steps(motion.tip).max() <= 1.001 * measure_steps(shown.tip).max()
    smooth = [smooth_stroke(stroke).position for stroke in motion.strokes]
    assert max(map(miss, smooth, motion.strokes)) < PATH_TOLERANCE + 1e-6


def miss(points, stroke):
    """The farthest that a point is from a stroke [m]."""
    fine = interpolate(stroke)(np.linspace(stroke.t[0], stroke.t[-1], 50 * len(stroke)))
    return distances(points, fine).max()


def largest_step(stroke):
    times = np.linspace(stroke.t[0], stroke.t[-1], int(np.ceil(stroke.duration * 240)) + 1)
    return measure_steps(interpolate(stroke)(times)).max()


@pytest.mark.parametrize(("letter", "alphabet"), SAMPLE)
def test_a_letters_acceleration_steps_no_more_than_its_recordings(letter, alphabet):
    assert_no_larger_steps(recording_of(letter, alphabet))


@needs_recordings
def test_so_it_is_with_people():
    for path in RECORDINGS[1::5]:
        assert_no_larger_steps(read_recording(path))


def test_what_is_smooth_already_stays_as_it_is():
    strokes = lay_out(LETTER, PAGE)
    assert max(largest_step(stroke) for stroke in strokes) < LARGEST_STEP
    assert all(smooth_stroke(stroke) is stroke for stroke in strokes)


@law(examples=20, letter=ink.letters(), noise=ink.st.floats(0, 3e-4), seed=ink.st.integers(0, 1000))
def test_any_stroke_keeps_its_path_its_ends_and_at_least_its_time(letter, noise, seed):
    for stroke in letter:
        shaken = np.random.default_rng(seed).normal(0, noise, stroke.position.shape)
        rough = Trajectory(stroke.t, stroke.position + shaken)
        smooth = smooth_stroke(rough)
        np.testing.assert_allclose(smooth.position[[0, -1]], rough.position[[0, -1]], atol=1e-15)
        assert miss(smooth.position, rough) < PATH_TOLERANCE + 1e-6
        assert smooth.t[0] == rough.t[0]
        assert smooth.duration >= rough.duration - 1e-9
        if smooth is not rough:
            assert measure_steps(smooth.position).max() < largest_step(rough)
