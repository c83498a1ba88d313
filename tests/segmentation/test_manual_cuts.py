"""Laws of strokes that are cut by hand."""

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
    assert [(s.t[0], s.t[-1]) for s in by_hand.strokes(theta, sigma, "meant")] == times
    assert D.given_strokes is None  # the one that was cut stays as it was
    assert ends(by_hand.with_strokes(None)) == ends(D)


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
        (lambda d: d.with_strokes([("0.6", 1.2)]), "cut is at '0.6' s"),
        (lambda d: d.with_strokes([0.6, 1.2]), r"must be pairs \(first, last\) of times"),
        (lambda d: d.with_strokes(3), r"must be pairs \(first, last\) of times"),
    ],
)
def test_a_cut_that_cannot_be_says_why(cut, words):
    with pytest.raises(RecordingError, match=words):
        cut(D)
