"""Words: letters that stand evenly, and one pen that never jumps."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.text.connection_points import (
    split_marks,
)
from dmp_teach.letters.text.connections import link_strokes
from dmp_teach.letters.text.lines import write_lines
from dmp_teach.trajectory import Trajectory
from tests.letters.text import HAND, HANDS, SMALL, TEXTS, fastest, points, word


@settings(max_examples=25, deadline=None)
@given(HAND, TEXTS, st.booleans())
def test_time_only_runs_forward_and_ink_begins_at_the_corner(name, text, joined):
    ink = word(text, name, joined=joined)
    assert ink[0].t[0] == 0
    assert all(before.t[-1] < after.t[0] for before, after in pairwise(ink))
    assert points(ink)[:, 0].min() == pytest.approx(0, abs=1e-12)
    assert ink.duration == pytest.approx(ink[-1].t[-1])


@settings(max_examples=25, deadline=None)
@given(HAND, SMALL)
def test_a_joined_word_never_jumps_and_never_has_more_strokes(name, text):
    apart, joined = word(text, name), word(text, name, joined=True)
    assert len(joined) <= len(apart)
    usual = max(fastest(stroke) for stroke in apart)
    for stroke in joined:
        assert fastest(stroke) < 2.5 * usual
        velocity = np.diff(stroke.position, axis=0) / np.diff(stroke.t)[:, None]
        bend = np.linalg.norm(np.diff(velocity, axis=0), axis=1)
        assert bend.max() < usual  # from one sample to the next the velocity does not leap


@pytest.mark.parametrize(
    ("text", "name", "strokes"),
    [("hello", "slanted", 1), ("nine", "slanted", 2), ("mute", "round", 2)],
)
def test_a_pen_lifts_only_for_dots_and_crosses_where_all_letters_join(text, name, strokes):
    ink = word(text, name, joined=True)
    assert len(ink) == strokes
    assert len(word(text, name)) >= len(text)


@pytest.mark.parametrize("name", alphabets())
def test_dots_and_crosses_come_after_the_word_from_left_to_right(name):
    ink = word("tintin", name, joined=True)
    marks = ink[-4:]
    lefts = [mark.position[:, 0].min() for mark in marks]
    assert lefts == sorted(lefts)
    size = HANDS[name].x_height
    assert all(np.ptp(mark.position, axis=0).max() < 1.1 * size for mark in marks)
    assert max(points(marks)[:, 1]) > size


@pytest.mark.parametrize("name", alphabets())
def test_capitals_and_digits_begin_afresh(name):
    alone = sum(len(HANDS[name].glyph(character)) for character in "B4R8")
    assert len(word("B4R8", name, joined=True)) == alone
    assert len(word("nB", name, joined=True)) == len(word("nB", name))


def test_a_word_of_one_letter_is_that_letter():
    (stroke,), (shown,) = word("o"), Letter.learn(recording_of("o")).write()
    np.testing.assert_allclose(
        stroke.position - stroke.position[0], shown.position - shown.position[0], atol=1e-12
    )


@settings(max_examples=20, deadline=None)
@given(st.floats(0.002, 0.2))
def test_another_size_is_the_same_word_scaled(size):
    usual, other = word("ago"), word("ago", x_height=size)
    factor = size / HANDS["round"].x_height
    for one, two in zip(usual, other, strict=True):
        np.testing.assert_allclose(two.position, factor * one.position, atol=1e-12)


@pytest.mark.parametrize("tempo", [0, 0.4, 1])
def test_the_time_grows_with_a_power_of_the_size(tempo):
    """Strokes and lifts alike; with 1 the speed stays, with 0 the time."""
    usual, small = (
        word("tip", tempo=tempo),
        word("tip", x_height=HANDS["round"].x_height / 8, tempo=tempo),
    )
    assert small.duration == pytest.approx(usual.duration / 8**tempo)
    for one, two in zip(usual, small, strict=True):
        assert two.duration == pytest.approx(one.duration / 8**tempo)
    assert fastest(small[0]) == pytest.approx(fastest(usual[0]) * 8 ** (tempo - 1))


def test_small_text_is_written_in_less_time_but_not_in_proportion():
    large, small = word("lift", x_height=0.07).duration, word("lift", x_height=0.007).duration
    assert 0.3 * large < small < 0.5 * large


def test_the_way_to_the_next_line_takes_its_time_however_small_the_letters_are():
    text = write_lines("on and on and on\nlo", x_height=0.004, width=0.2)
    for before, after in pairwise(text):
        far = np.linalg.norm(after.position[0] - before.position[-1])
        assert far / (after.t[0] - before.t[-1]) < 0.5 + 1e-9


def test_letters_stand_on_the_line():
    for character, low in (("x", 0), ("H", 0), ("g", -0.8), ("p", -0.8)):
        ink = points(word(character)) / HANDS["round"].x_height
        assert ink[:, 1].min() == pytest.approx(low, abs=0.1)


@pytest.mark.parametrize("joined", [False, True])
def test_ones_own_letters_write_the_word(joined):
    own = Letter.learn(recording_of("a", "slanted"))
    small = [Trajectory(s.t, 0.2 * s.position + 3) for s in own.write()]
    both = (
        word("baa", letters={"a": own}, joined=joined),
        word("baa", letters={"a": Letter.learn(small)}, joined=joined),
    )
    for one, other in zip(*both, strict=True):
        for corner in (np.min, np.max):
            assert (
                np.abs(corner(one.position, axis=0) - corner(other.position, axis=0)).max() < 1e-3
            )
    assert np.abs(points(both[0])[-1] - points(word("baa", joined=joined))[-1]).max() > 1e-3
    recorded = word("a", letters={"a": recording_of("a", "slanted")})
    tall = np.ptp(points(word("a"))[:, 1])
    assert np.ptp(points(recorded)[:, 1]) == pytest.approx(tall)


def test_a_connection_keeps_both_strokes_and_their_speeds():
    t = np.linspace(0, 1, 121)
    one = Trajectory(t, 0.05 * np.column_stack([t, 0.6 * t**2]))
    other = Trajectory(t, 0.05 * np.column_stack([1.6 + t, 0.9 + t - 0.4 * t**2]))
    both = link_strokes(one, other, 0.05)
    velocity = np.diff(both.position, axis=0) / np.diff(both.t)[:, None]
    assert np.linalg.norm(np.diff(velocity, axis=0), axis=1).max() < 0.01
    np.testing.assert_array_equal(both.position[0], one.position[0])
    np.testing.assert_array_equal(both.position[-1], other.position[-1])


@settings(max_examples=30, deadline=None)
@given(
    HAND,
    st.lists(st.tuples(st.floats(-1, 2), st.floats(-1, 2)), min_size=2, max_size=5, unique=True),
    st.booleans(),
)
def test_whatever_ones_own_letter_looks_like_it_is_joined_or_the_pen_lifts(name, corners, back):
    way = np.linspace(0, len(corners) - 1, 120)
    path = np.column_stack(
        [np.interp(way, range(len(corners)), axis) for axis in np.transpose(corners)]
    )
    if np.ptp(path[:, 1]) < 0.3 or np.linalg.norm(np.diff(path, axis=0), axis=1).min() < 1e-4:
        return
    own = Letter.learn(Trajectory(np.linspace(0, 1, 120), path))
    ink = word("nana" if back else "vaoa", name, joined=True, letters={"a": own})
    assert all(
        (np.diff(stroke.t) > 0).all() and np.isfinite(stroke.position).all() for stroke in ink
    )
    assert all(before.t[-1] < after.t[0] for before, after in pairwise(ink))


def test_what_comes_back_to_the_left_is_a_mark():
    for character, marks in (
        ("x", 1),
        ("t", 1),
        ("i", 1),
        ("o", 0),
        ("k", 0),
        ("H", 0),
        ("A", 0),
        ("5", 0),
    ):
        assert len(split_marks(character, HANDS["round"].glyph(character))[1]) == marks, character


@pytest.mark.slow
def test_accents_are_written_too():
    accented = [character for character in characters() if not character.isascii()]
    for character in accented:
        assert len(word(f"n{character}n", joined=True)) >= 2


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        (lambda: word(""), r"A word is letters without a space, but got ''"),
        (lambda: word("two words"), r"but got 'two words'; teach\.write_lines writes text with"),
        (lambda: word("a%"), r"The alphabet 'round' has no '%'; it has: a b c"),
        (
            lambda: word("%", letters={"%": recording_of("o")}),
            r"There is a letter for '%', but nobody knows how tall",
        ),
        (lambda: word("a", letters=[1]), r"letters is a list, but must be \{'a': letter\}"),
        (
            lambda: word("h", letters={"h": 3}),
            r"letters\['h'\] cannot be written\. A letter is learned .* got an int",
        ),
        (
            lambda: word("h", letters={"h": []}),
            r"letters\['h'\] cannot be written\. A letter is learned .* nothing",
        ),
        (lambda: word("hi", joined="yes"), r"joined is 'yes', but must be True or False"),
        (lambda: write_lines("hi", joined=2), r"joined is 2, but must be True or False"),
        (
            lambda: write_lines("a\nb\nc", pitch=0),
            r"pitch is 0 m, but lines .* on each other: give at least the x_height, 0\.008 m",
        ),
        (
            lambda: write_lines("a", pitch="wide"),
            r"pitch is 'wide', but must be a length from 0 to 10 m",
        ),
        (lambda: word("a", x_height=0), r"x_height is 0, but must be a height from 0\.0001 to 1 m"),
        (
            lambda: word("a", tempo=2),
            r"tempo is 2, but must be from 0 \(the same time in every size\) to 1",
        ),
        (lambda: write_lines("a", tempo="fast"), r"tempo is 'fast', but must be from 0"),
        (lambda: write_lines("  \n "), r"There is nothing to write in"),
        (lambda: write_lines("a", margin=-1), r"margin is -1, but must be a length from 0 to 10 m"),
        (lambda: write_lines("a", x_height="big"), r"x_height is 'big', but must be a height"),
    ],
)
def test_what_cannot_be_written_is_said_in_a_sentence(ask, answer):
    with pytest.raises(LetterError, match=answer):
        ask()


def test_an_alphabet_that_is_none_is_named_by_those_that_are():
    with pytest.raises(
        RecordingError, match=r"There is no alphabet 'gothic'; there are: round, slanted"
    ):
        word("a", "gothic")
