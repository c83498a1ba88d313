"""Laws of cuts that are moved by hand."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.recording_json import read_json, write_json
from dmp_teach.letters.letter import Letter
from tests.formats.motive_csv import Pen, bar, bowl


def written():
    pen = Pen().rest(0.5).draw(bar()).hop((0.0, 0.0)).draw(bowl()).rest(0.5)
    t, page = pen.sampled(noise=0.0)
    page[:, 2] -= pen.height
    return Recording(t, page, "D", "w01")


D = written()
T = D.t


def ends(recording):
    return [(stroke.t[0], stroke.t[-1]) for stroke in recording.strokes()]


cut = st.integers(0, len(T) - 1)


@settings(max_examples=40, deadline=None)
@given(
    st.lists(cut, min_size=2, max_size=12, unique=True), st.floats(0.01, 1), st.floats(0.001, 0.1)
)
def test_strokes_cut_by_hand_are_kept_whatever_the_rule_says(samples, theta, sigma):
    samples = sorted(samples)[: len(samples) // 2 * 2]
    times = [(T[a], T[b]) for a, b in zip(samples[::2], samples[1::2], strict=True)]
    by_hand = D.with_strokes(times)
    assert ends(by_hand) == times
    assert [(s.t[0], s.t[-1]) for s in by_hand.strokes(theta, sigma, "authors")] == times
    assert D.given_strokes is None  # the one that was cut stays as it was
    assert ends(by_hand.with_strokes(None)) == ends(D)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 1), st.floats(0.05, 0.95), st.floats(0, 100))
def test_joining_undoes_splitting_and_when_it_was_written_does_not_matter(stroke, share, later):
    shifted = Recording(T + later, D.position)
    first, last = ends(D)[stroke]
    time = first + share * (last - first)
    for recording, at in ((D, time), (shifted, time + later)):
        parts = recording.split(stroke, at)
        assert len(parts.strokes()) == 3
        assert sum(map(len, parts.strokes())) == sum(map(len, recording.strokes()))
        assert ends(parts.merge_strokes(stroke)) == ends(recording)
        assert len(parts.without(stroke).strokes()) == 2
        np.testing.assert_allclose(ends(parts)[stroke + 1][0] - at, 0, atol=0.006)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 1), st.sampled_from(["start", "end"]), st.floats(-0.05, 0.05))
def test_a_moved_cut_moves_one_end_and_moves_back(stroke, end, by):
    side = ("start", "end").index(end)
    old = ends(D)
    moved = D.moved_cut(stroke, end, old[stroke][side] + by)
    new = ends(moved)
    assert abs(new[stroke][side] - old[stroke][side] - by) < 0.0051
    assert [e for k, e in enumerate(np.ravel(new)) if k != 2 * stroke + side] == [
        e for k, e in enumerate(np.ravel(old)) if k != 2 * stroke + side
    ]
    assert ends(moved.moved_cut(stroke, end, old[stroke][side])) == old


def test_the_old_name_of_merging_stays_for_one_version():
    parts = D.split(0, 0.9)
    with pytest.warns(DeprecationWarning, match=r"now called Recording\.merge_strokes"):
        assert ends(parts.joined(0)) == ends(parts.merge_strokes(0))


def test_cuts_are_learned_and_saved(tmp_path):
    by_hand = D.with_strokes([(0.6, 1.2), (1.9, 2.8)])
    write_json(by_hand, tmp_path / "D.json")
    assert ends(read_json(tmp_path / "D.json")) == ends(by_hand)
    learned = Letter.learn(by_hand)
    assert [(s.t[0], s.t[-1]) for s in learned.strokes] == ends(by_hand)


@pytest.mark.parametrize(
    ("cut", "words"),
    [
        (lambda d: d.with_strokes([]), "given_strokes is empty"),
        (lambda d: d.with_strokes([(0.6, 1.2), (1.1, 2.0)]), "one after the other"),
        (
            lambda d: d.with_strokes([(0.6, 99.0)]),
            r"cut is at 99.0 s, but must be a time of the recording, from 0.000",
        ),
        (lambda d: d.with_strokes([(0.6, float("nan"))]), "cut is at nan s"),
        (lambda d: d.with_strokes([0.6, 1.2]), r"must be pairs \(first, last\) of times"),
        (lambda d: d.with_strokes(3), r"must be pairs \(first, last\) of times"),
        (
            lambda d: d.moved_cut(0, "end", 2.5),
            r"Stroke 0 cannot end at 2.500 s: its end lies between .* touches no",
        ),
        (lambda d: d.moved_cut(1, "start", 0.7), "Stroke 1 cannot start at 0.700 s"),
        (lambda d: d.moved_cut(0, "middle", 0.7), "end is 'middle', but must be 'start' or 'end'"),
        (
            lambda d: d.moved_cut(2, "end", 0.7),
            "stroke is 2, but must be a whole number from 0 to 1",
        ),
        (lambda d: d.split(True, 0.7), "stroke is True"),
        (
            lambda d: d.split(0, 0.1),
            "Stroke 0 lasts from .* cannot be split at 0.100 s: both parts need 2 samples",
        ),
        (lambda d: d.merge_strokes(1), "Stroke 1 is the last one"),
        (lambda d: d.without(0).without(0), "the only stroke"),
    ],
)
def test_a_cut_that_cannot_be_says_why(cut, words):
    with pytest.raises(RecordingError, match=words):
        cut(D)
