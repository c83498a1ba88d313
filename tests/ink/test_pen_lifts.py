"""Flat ink gets lifts that look like a hand's."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.ink.pen_lifts import add_lifts
from dmp_teach.ink.recording import Recording
from dmp_teach.trajectory import Trajectory
from tests.formats.motive_csv import Pen, bar, bowl


def flat(pause=0.4, rate=120.0):
    """The two strokes of a D as a flat pad sees them."""
    pen = Pen().draw(bar()).hop((0.0, 0.0), seconds=pause).draw(bowl())
    t, page = pen.sampled(rate, noise=0.0)
    return [Trajectory(t[on], page[on, :2]) for on in ((t >= a) & (t <= b) for a, b in pen.touches)]


def test_strokes_and_pressures_are_kept_to_the_last_bit():
    strokes = flat()
    pressures = [np.full(len(stroke), 0.2 + 0.1 * k) for k, stroke in enumerate(strokes)]
    recording = add_lifts(strokes, pressures, character="D", writer="w07", baseline=-0.12)
    for got, given_stroke, span, pressure in zip(
        recording.strokes(), strokes, recording.given_strokes, pressures, strict=True
    ):
        assert np.array_equal(got.t, given_stroke.t)
        assert np.array_equal(got.position, given_stroke.position)
        assert np.array_equal(recording.pressure[slice(*span)], pressure)
        assert not recording.position[slice(*span), 2].any()
    lift = slice(recording.given_strokes[0][1], recording.given_strokes[1][0])
    assert not recording.pressure[lift].any()
    assert (recording.character, recording.writer, recording.baseline) == ("D", "w07", -0.12)


@settings(max_examples=20, deadline=None)
@given(pause=st.floats(0.15, 30), rate=st.sampled_from([60.0, 100.0, 120.0, 200.0]))
def test_a_lift_is_high_smooth_and_sampled_as_the_strokes(pause, rate):
    recording = add_lifts(flat(pause, rate))
    (_, end), (begin, _) = recording.given_strokes
    lift = recording.position[end - 1 : begin + 1]
    assert 0.012 < lift[:, 2].max() < 0.0201
    assert lift[:, 2].min() == 0
    step = np.diff(recording.t[end - 1 : begin + 1])
    assert np.ptp(step) < 1e-9
    assert step[0] < 2.1 / rate
    if pause > 0.5:
        assert (np.linalg.norm(np.diff(lift, axis=0), axis=1) / step).max() < 0.6


@pytest.mark.parametrize("pause", [0.25, 0.4, 1.0, 3.0])
def test_strokes_found_from_the_height_are_those_that_were_given(pause):
    recording = add_lifts(flat(pause))
    found = Recording(recording.t, recording.position).strokes()
    assert len(found) == 2
    for one, other in zip(found, recording.strokes(), strict=True):
        assert abs(one.t[0] - other.t[0]) < 0.08
        assert abs(one.t[-1] - other.t[-1]) < 0.08


def test_where_there_is_no_time_there_is_no_lift():
    t = np.arange(5) / 100
    line = np.column_stack([t, t])
    recording = add_lifts([Trajectory(t, line), Trajectory(t + 0.05, line + 0.01)])
    assert recording.given_strokes == ((0, 5), (5, 10))
    assert recording.pressure is None


def test_a_pause_of_years_takes_no_memory():
    t = np.arange(5) / 100
    line = np.column_stack([t, t])
    assert len(add_lifts([Trajectory(t, line), Trajectory(t + 1e9, line)]).t) < 7000


def test_what_cannot_be_strokes_is_named():
    t = np.arange(5) / 100
    line = Trajectory(t, np.column_stack([t, t]))
    with pytest.raises(RecordingError, match="no stroke"):
        add_lifts([])
    with pytest.raises(RecordingError, match=r"Stroke 1 is Trajectory\(5 samples, 1-D"):
        add_lifts([line, Trajectory(t + 1, t)])
    with pytest.raises(RecordingError, match="Stroke 0 is 'line'"):
        add_lifts(["line"])
    with pytest.raises(
        RecordingError, match=r"Stroke 1 begins at 0\.0 s, but stroke 0 ends at 0\.04 s"
    ):
        add_lifts([line, line])
    with pytest.raises(
        RecordingError, match=r"pressure must be one number for every sample, shape \(5,\)"
    ):
        add_lifts([line], [[0.5]])
    with pytest.raises(RecordingError, match=r"pressure\[0\] is 2"):
        add_lifts([line], [[2, 0, 0, 0, 0]])
