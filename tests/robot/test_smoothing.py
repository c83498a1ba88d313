import numpy as np
import pytest
from numpy.lib.stride_tricks import sliding_window_view

from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import connect_strokes, interpolate
from dmp_teach.robot.smoothing import (
    LARGEST_STEP,
    PATH_TOLERANCE,
    connect_smoothly,
    measure_steps,
    smooth_stroke,
)
from dmp_teach.trajectory import Trajectory, all_points
from tests.recordings import RECORDINGS, needs_recordings
from tests.robot import ink
from tests.robot.ink import LETTER, distances, law

PAGE = Page.table()
SAMPLE = [
    (letter, alphabet, height)
    for alphabet in alphabets()
    for letter, height in zip("e6kmWAT", (0.06, 0.06, 0.12, 0.12, 0.19, 0.19, 0.19), strict=True)
]
SMOOTH = 0.2
"""What a recording's acceleration changes by; our alphabets', which are made, by less [m/s^2]."""


def largest_on_paper(path, pen_down):
    return measure_steps(path)[sliding_window_view(pen_down, 4).all(axis=1)].max()


def assert_no_larger_steps(recording, height, connect=connect_strokes):
    """With the pen down the arm's steps are at most the recording's; the path is the letter's."""
    scale = height / np.ptp(all_points(recording.strokes())[:, 1])
    drawn, shown = (
        [Trajectory(stroke.t, scale * stroke.position) for stroke in strokes]
        for strokes in (Letter.learn(recording).write(), recording.strokes())
    )
    motion, plan = Fetch().write(drawn, PAGE), connect(lay_out(shown, PAGE)).plan()
    recorded = largest_on_paper(plan.position, plan.pen_down)
    assert largest_on_paper(motion.tip, motion.pen_down) <= 1.001 * max(SMOOTH, recorded)
    smooth = [sampled(smooth_stroke(stroke), 2) for stroke in motion.strokes]
    assert max(map(miss, smooth, motion.strokes)) < PATH_TOLERANCE


def sampled(stroke, many):
    """Points between the samples of a stroke, too."""
    return interpolate(stroke)(np.linspace(stroke.t[0], stroke.t[-1], many * len(stroke)))


def miss(points, stroke):
    """The farthest that a point is from a stroke [m]."""
    return distances(points, sampled(stroke, 50)).max()


def largest_step(stroke):
    times = np.linspace(stroke.t[0], stroke.t[-1], int(np.ceil(stroke.duration * 240)) + 1)
    return measure_steps(interpolate(stroke)(times)).max()


@pytest.mark.parametrize(("letter", "alphabet", "height"), SAMPLE)
def test_a_letters_acceleration_steps_no_more_than_its_recordings(letter, alphabet, height):
    assert_no_larger_steps(recording_of(letter, alphabet), height)


@needs_recordings
def test_so_it_is_with_people():
    for path in RECORDINGS[1::5]:
        assert_no_larger_steps(read_recording(path), 0.06, connect_smoothly)


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
        assert miss(smooth.position, rough) < PATH_TOLERANCE
        assert smooth.t[0] == rough.t[0]
        assert smooth.duration >= rough.duration - 1e-9
        if smooth is not rough:
            # The clock of the arm may cut a shaken stroke a little higher than its own did.
            assert largest_step(smooth) < 1.1 * largest_step(rough)
