"""Ink from a pad: uneven events become an even stroke through every point, and a recording."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import dmp_teach
from dmp_teach.errors import RecordingError
from dmp_teach.ink.alphabet import characters
from dmp_teach.ink.pad import (
    DOT_RADIUS,
    FEWEST_CURVE_POINTS,
    LONGEST_PAD_STROKE,
    PAD_LIFT_DURATION,
    PAD_SAMPLE_RATE,
    pad_recording,
    pad_stroke,
)


def events(seed=0, seconds=1.2, begin=5.0, size=0.05, pressure=0.5):
    """A bow as a hand would write it, seen about 60 times a second, unevenly."""
    rng = np.random.default_rng(seed)
    t = begin + np.sort(np.append(rng.uniform(0, seconds, round(60 * seconds)), [0, seconds]))
    u = (t - begin) / seconds
    return np.column_stack(
        [t, size * np.cos(4 * u), size * np.sin(4 * u), np.full(len(t), pressure)]
    )


uneven = st.builds(
    events, st.integers(0, 1000), st.floats(0.3, 4), st.floats(0, 1e6), st.floats(0.01, 0.2)
)


@given(uneven)
def test_a_stroke_is_even_and_begins_and_ends_where_the_pen_did(rows):
    path = pad_stroke(rows).path
    steps = np.diff(path.t)
    assert np.allclose(steps, steps[0], atol=1e-6)
    assert steps[0] == pytest.approx(1 / PAD_SAMPLE_RATE, rel=0.05)
    assert np.allclose(path.position[[0, -1]], rows[[0, -1], 1:3])
    assert path.duration == pytest.approx(np.ptp(rows[:, 0]))


@given(uneven)
def test_every_point_that_was_caught_lies_on_the_stroke_and_nothing_lies_beyond_them(rows):
    stroke = pad_stroke(rows)
    seen = np.column_stack(
        [np.interp(rows[:, 0], stroke.path.t, axis) for axis in stroke.path.position.T]
    )
    longest = np.linalg.norm(np.diff(rows[:, 1:3], axis=0), axis=1).max()
    assert np.linalg.norm(seen - rows[:, 1:3], axis=1).max() <= longest
    for axis in (0, 1):
        assert stroke.path.position[:, axis].min() >= rows[:, 1 + axis].min() - 1e-12
        assert stroke.path.position[:, axis].max() <= rows[:, 1 + axis].max() + 1e-12


def test_an_even_stroke_stays_as_it_is():
    t = np.arange(121) / PAD_SAMPLE_RATE
    rows = np.column_stack([t, 0.05 * np.cos(3 * t), 0.05 * np.sin(3 * t), 0 * t])
    assert np.allclose(pad_stroke(rows).path.position, rows[:, 1:3], atol=1e-9)


@given(uneven, st.randoms())
def test_events_that_come_twice_or_overtake_each_other_change_nothing(rows, random):
    again = np.repeat(rows, 2, axis=0)
    for k in range(1, len(again) - 1, 2):
        if random.random() < 0.5 and again[k + 1, 0] - again[k, 0] < 0.02:
            again[[k, k + 1]] = again[[k + 1, k]]
    assert np.array_equal(pad_stroke(again).path.position, pad_stroke(rows).path.position)
    assert pad_stroke(again).points == len(np.unique(rows[:, 0]))


def test_of_two_events_at_one_time_the_later_one_holds():
    rows = np.array([[0, 0, 0, 0.5], [0.1, 0.01, 0, 0.5], [0.1, 0.02, 0, 0.5], [0.2, 0.03, 0, 0.5]])
    assert pad_stroke(rows).path.position[12] == pytest.approx([0.02, 0])


def test_a_pen_that_rests_stands_still_and_does_not_creep():
    first, second = events(seconds=0.5, begin=0), events(seconds=0.5, begin=1.4)
    second[:, 1:3] += first[-1, 1:3] - second[0, 1:3]
    rows = np.vstack([first, second[1:]])
    path = pad_stroke(rows).path
    rest = (path.t > 0.5) & (path.t < 1.35)
    assert np.allclose(path.position[rest], first[-1, 1:3])
    assert path.duration == pytest.approx(1.9)


@given(st.floats(3, 1e9))
def test_a_clock_that_jumps_within_a_stroke_does_not_make_it_last(jump):
    rows = events(seconds=1.0, begin=0)
    rows[30:, 0] += jump
    assert 2.9 < pad_stroke(rows).path.duration < 3.1


def test_a_tap_is_a_dot_that_can_be_learned_and_written():
    dot = pad_stroke([[7.0, 0.03, 0.1, 0.5]])
    assert dot.is_dot
    assert dot.path.duration == pytest.approx(0.1)
    assert np.allclose(dot.path.position, [0.03, 0.1])
    recording = pad_recording([pad_stroke(events(begin=6)), dot], character="i")
    bow, point = dmp_teach.Letter.learn(recording).write()
    assert np.allclose(point.position, [0.03, 0.1], atol=1e-6)
    assert len(bow) > len(point)


def test_a_pen_that_trembles_makes_a_dot_and_one_that_goes_further_a_stroke():
    tremble = np.array([[0, 0, 0, 0.5], [0.02, 0.0008, 0, 0.5], [0.05, 0, 0.0008, 0.5]])
    assert pad_stroke(tremble).is_dot
    tremble[1, 1] = 2 * DOT_RADIUS
    assert not pad_stroke(tremble).is_dot


@pytest.mark.parametrize("seconds", [1e-9, 0.004, 0.03])
def test_a_stroke_too_fast_for_the_pad_is_kept_and_says_so(seconds):
    flick = pad_stroke([[0, 0, 0, 0.5], [seconds, 0.06, 0.02, 0.5]])
    assert flick.is_blurred
    assert np.allclose(flick.path.position[-1], [0.06, 0.02])
    assert dmp_teach.Letter.learn(pad_recording([flick])).write()
    assert not pad_stroke(events()).is_blurred


def sparsely(stroke, points):
    """A stroke of our alphabet as a pad sees it that catches only some points."""
    t = np.linspace(stroke.t[0], stroke.t[-1], points)
    return np.column_stack(
        [t, *(np.interp(t, stroke.t, axis) for axis in stroke.position.T), 0 * t]
    )


def test_a_bow_is_too_fast_where_its_points_cut_it_off_however_many_there_are():
    (bow,) = dmp_teach.recording_of("a").strokes()
    for points in (7, 12, 18):
        assert pad_stroke(sparsely(bow, points)).is_blurred
    bar = dmp_teach.recording_of("D").strokes()[0]
    assert not pad_stroke(sparsely(bar, 7)).is_blurred, "a straight line is seen by few points"


@pytest.mark.slow
@pytest.mark.parametrize("rate", [25, 30, 60, 120])
def test_no_letter_at_its_own_tempo_is_too_fast_also_for_a_slow_pad(rate):
    for character in characters():
        for stroke in dmp_teach.recording_of(character).strokes():
            caught = pad_stroke(
                sparsely(stroke, max(FEWEST_CURVE_POINTS, round(rate * stroke.duration)))
            )
            assert not caught.is_blurred, character


@given(uneven, st.floats(0.1, 3.0), st.floats(-3, 3))
def test_what_is_cut_off_grows_with_the_ink_and_does_not_depend_on_its_place_or_turn(
    rows, size, angle
):
    other = rows.copy()
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    other[:, 1:3] = 0.01 + size * rows[:, 1:3] @ turn
    assert pad_stroke(other).unseen == pytest.approx(
        size * pad_stroke(rows).unseen, rel=1e-3, abs=1e-9
    )


def test_pressure_is_kept_where_the_pad_can_tell_and_is_none_elsewhere():
    rows = events()
    rows[:, 3] = np.linspace(0.2, 0.9, len(rows))
    pen, mouse = pad_stroke(rows, pressed=True), pad_stroke(rows)
    assert mouse.pressure is None
    assert pen.pressure[[0, -1]] == pytest.approx([0.2, 0.9])
    rows[:, 3] *= 100
    assert pad_stroke(rows, pressed=True).pressure.max() == 1
    recording = pad_recording([pen, pen])
    (_, end), (begin, _) = recording.given_strokes
    assert recording.pressure[end - 1] == pytest.approx(0.9)
    assert recording.pressure[end:begin].max() == 0
    assert pad_recording([pen, mouse]).pressure is None


@given(st.lists(st.floats(-1e7, 1e7), min_size=2, max_size=4))
def test_a_lift_lasts_as_long_as_a_hand_needs_whatever_the_clock_says(begins):
    strokes = [pad_stroke(events(seed=k, begin=begin)) for k, begin in enumerate(begins)]
    recording = pad_recording(strokes, character="E", writer="w01", baseline=0.0)
    ink = recording.strokes()
    assert recording.t[0] == 0
    assert [len(stroke) for stroke in ink] == [len(stroke.path) for stroke in strokes]
    for before, after in pairwise(ink):
        assert (
            PAD_LIFT_DURATION[0] - 1e-9 <= after.t[0] - before.t[-1] <= PAD_LIFT_DURATION[1] + 1e-9
        )


def test_a_lift_of_ordinary_length_is_kept():
    ink = pad_recording([pad_stroke(events(begin=1)), pad_stroke(events(begin=2.9))]).strokes()
    assert ink[1].t[0] - ink[0].t[-1] == pytest.approx(0.7)


def test_the_papers_rule_finds_the_strokes_of_a_pad_again_from_the_height_that_it_was_given():
    strokes = [pad_stroke(events(seed=k, begin=2.0 * k)) for k in range(3)]
    given = pad_recording(strokes)
    found = replace(given, given_strokes=None).strokes()
    for a, b in zip(given.strokes(), found, strict=True):
        assert abs(a.t[0] - b.t[0]) < 0.05
        assert abs(a.t[-1] - b.t[-1]) < 0.05


def nan(rows):
    rows[3, 1] = np.nan
    return rows


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([], "at least one"),
        (np.zeros((3, 3)), "shape \\(3, 3\\)"),
        ("ink", "rows of t, x, y and pressure"),
        (nan(events()), "no numbers"),
        (events()[::-1], "ran backwards"),
        (np.zeros((100_000, 4)), "100000 points"),
        (events(size=7.0), "a pad reaches 1.0 m"),
        (events(seconds=LONGEST_PAD_STROKE + 3, size=0.1), "takes at most 60 s"),
    ],
)
def test_what_cannot_be_a_stroke_is_refused_with_a_sentence(rows, words):
    with pytest.raises(RecordingError, match=words):
        pad_stroke(rows)


def test_a_recording_of_no_stroke_is_refused():
    with pytest.raises(RecordingError, match="no stroke"):
        pad_recording([])
