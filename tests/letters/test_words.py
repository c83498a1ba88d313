"""Words and lines: letters that stand evenly, never on each other, and one pen that never jumps."""

from functools import cache
from itertools import combinations, pairwise, product
from string import ascii_lowercase, digits

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.ink.alphabet import SIGNS, alphabets, characters, recording_of
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.text.connection_points import (
    can_arrive,
    can_leave,
    find_meeting,
    leaving_sample,
    split_marks,
)
from dmp_teach.letters.text.connections import link_strokes
from dmp_teach.letters.text.handwriting import Hand, plain_text
from dmp_teach.letters.text.lines import write_lines
from dmp_teach.letters.text.spacing import connected_spacing, letter_spacing
from dmp_teach.letters.text.words import write_word
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Trajectory


def word(text, alphabet=None, **about):
    """A word in the alphabet's own size, unless another is asked for."""
    return write_word(text, alphabet, **({"x_height": None} | about))


ALL = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
HANDS = {name: Hand.of(name, None, None) for name in alphabets()}
TEXTS = st.text(alphabet=ALL, min_size=1, max_size=5)
SMALL = st.text(alphabet="abcdefghijklmnopqrstuvwxyz", min_size=2, max_size=5)
HAND = st.sampled_from(alphabets())


def points(strokes):
    return np.concatenate([stroke.position for stroke in strokes])


def dense(strokes):
    return np.concatenate([_filled(stroke.position) for stroke in strokes])


def _filled(path):
    k = np.linspace(0, len(path) - 1, 8 * len(path))
    return np.column_stack([np.interp(k, np.arange(len(path)), axis) for axis in path.T])


def fastest(stroke):
    return float(
        (np.linalg.norm(np.diff(stroke.position, axis=0), axis=1) / np.diff(stroke.t)).max()
    )


@settings(max_examples=40, deadline=None)
@given(HAND, st.sampled_from(ALL), st.sampled_from(ALL))
def test_neighbours_do_not_touch(name, one, other):
    hand = HANDS[name]
    left, right = hand.glyph(one), hand.glyph(other)
    apart, _ = cKDTree(dense(left)).query(
        dense(right) + np.array([letter_spacing(left, right, hand.x_height), 0])
    )
    assert apart.min() > 0.1 * hand.x_height


@settings(max_examples=40, deadline=None)
@given(HAND, st.text(alphabet=ALL + SIGNS * 3, min_size=2, max_size=4))
def test_nothing_in_a_word_touches_its_neighbours_nor_theirs(name, text):
    strokes, glyphs = list(word(text, name)), []
    for character in text:
        count = len(HANDS[name].glyph(character))
        glyphs.append(cKDTree(dense(strokes[:count])))
        strokes = strokes[count:]
    assert not strokes
    for one, other in combinations(glyphs, 2):
        assert one.query(other.data)[0].min() > 0.09 * HANDS[name].x_height


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_punctuation_stands_where_it_should(name):
    size = HANDS[name].x_height

    def sign(text):
        return dense(word(text, name)[-len(HANDS[name].glyph(text[-1])) :]) / size

    for letters in ("o", "y", "T", "B"):
        rest = dense(word(letters, name)) / size
        for mark, low, high in (
            (".", 0, 0.15),
            (",", -0.3, 0.15),
            ("-", 0.4, 0.6),
            ("'", 1.5, 1.95),
            ("?", 0, 1.9),
        ):
            ink = sign(letters + mark)
            assert low - 0.05 < ink[:, 1].min() < ink[:, 1].max() < high + 0.05
            beside = [(x, rest[np.abs(rest[:, 1] - y) < 0.2, 0]) for x, y in ink[::20]]
            apart = [x - there.max() for x, there in beside if len(there)]
            if apart:
                assert 0.15 < min(apart) < 0.6, (letters, mark)
    t = dense(word("T", name)) / size
    assert sign("T.")[:, 0].max() < t[:, 0].max()


@pytest.mark.parametrize("name", alphabets())
def test_no_digit_leans_over_the_sign_of_a_sum(name):
    """Half an x-height above and below the sign, too: no hook of a 2 over the arm of a plus."""
    hand = HANDS[name]
    for text in [f"{digit}{sign}{digit}" for sign in "+=-:/" for digit in digits]:
        strokes = hand.word(text, False)
        ends = np.cumsum([len(hand.glyph(character)) for character in text])
        before, middle, after = (
            dense(part)[::8] / hand.x_height
            for part in (strokes[: ends[0]], strokes[ends[0] : ends[1]], strokes[ends[1] :])
        )
        for left, right in ((before, middle), (middle, after)):
            across, up = np.moveaxis(right[None] - left[:, None], 2, 0)
            assert across[np.abs(up) < 0.5].min() > 0.2, text


def test_dots_and_crosses_come_before_the_sign_that_follows():
    for text in ("it!", "tit?", "i."):
        ink = word(text, "slanted", joined=True)
        end = HANDS["slanted"].glyph(text[-1])
        for drawn, shown in zip(ink[-len(end) :], end, strict=True):
            np.testing.assert_allclose(
                np.diff(drawn.position, axis=0), np.diff(shown.position, axis=0), atol=1e-12
            )
    assert (
        len(word("it-it", "slanted", joined=True))
        == 2 * len(word("it", "slanted", joined=True)) + 1
    )


@pytest.mark.parametrize(
    ("printed", "plain"),
    [
        ("don\u2019t", "don't"),
        ("\u201cja\u201d", '"ja"'),
        ("a\u2013b", "a-b"),
        ("scho\u0308n", "sch\u00f6n"),
        ("wait\u2026", "wait..."),
        ("3\u22122", "3-2"),
    ],
)
def test_print_and_parted_accents_are_written_plainly(printed, plain):
    for one, other in zip(word(printed), word(plain), strict=True):
        np.testing.assert_array_equal(one.position, other.position)


def test_a_line_spaces_print_as_what_is_written_for_it():
    for printed, typed in (
        ("so\u2026 yes", "so... yes"),
        ("\u201cno\u201d \u2014 no", '"no" - no'),
    ):
        for one, other in zip(write_lines(printed), write_lines(typed), strict=True):
            np.testing.assert_array_equal(one.position, other.position)


SPELT = (
    "¿Qué?",
    "¡Hola!",
    "NÃO",
    "LÕES",
    "Œuvre",
    "NOËL",
    "Île",
    "Ægir",
    "L\u2019Haÿ-les-Roses",
    "ALTÉRATION",
)
SPELT += ("ÙLTIMO", "2+2=4", "3/4", "wait\u2026", "«ça»", "déjà!", "œæœ")


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_every_language_that_we_have_letters_for_is_written(name):
    """Letter by letter; joined, in no more strokes, as high and as deep as its letters."""
    hand = HANDS[name]
    for text in SPELT:
        apart, joined = (hand.word(text, joined) for joined in (False, True))
        glyphs = [hand.glyph(character) for character in plain_text(text)]
        assert len(joined) <= len(apart) == sum(map(len, glyphs)), text
        height = points(sum(glyphs, ()))[:, 1]
        for ink in (points(apart)[:, 1], points(joined)[:, 1]):
            assert ink.max() == pytest.approx(height.max(), abs=0.05 * hand.x_height), text
            assert ink.min() == pytest.approx(height.min(), abs=0.05 * hand.x_height), text


@cache
def joints(name):
    """Every pair of small letters that are joined: the last stroke and the first, in place."""
    return tuple(_joints(HANDS[name]))


def connection(end, start, size):
    """The samples of two linked strokes, and between which of them the connection is."""
    both, a = link_strokes(end, start, size), leaving_sample(end, size)
    there = start.position[find_meeting(end.position[a], start, size).sample]
    return both, a, int(np.flatnonzero(np.abs(both.position - there).max(axis=1) < 1e-12)[0])


def _joints(hand):
    for one, other in product(ascii_lowercase, repeat=2):
        glyphs = hand.glyph(one), hand.glyph(other)
        bodies = split_marks(one, glyphs[0])[0], split_marks(other, glyphs[1])[0]
        if can_leave(one, bodies[0], hand.x_height) and can_arrive(other, bodies[1], hand.x_height):
            step = connected_spacing(glyphs, bodies, hand.x_height)
            start = bodies[1][0]
            yield (
                one + other,
                bodies[0][-1],
                Trajectory(start.t, start.position + np.array([step, 0])),
            )


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_joined_letters_touch_only_by_the_way_between_them(name):
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        a = leaving_sample(end, size)
        met = find_meeting(end.position[a], start, size)
        right = (
            Trajectory(start.t[met.sample :], start.position[met.sample :])
            if not met.back
            else start
        )
        apart, _ = cKDTree(_filled(end.position[: a + 1])).query(_filled(right.position))
        assert apart.min() > 0.1 * size, pair


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_a_pen_that_moves_keeps_its_heading_where_letters_meet(name):
    """At both ends of a connection; where the pen rests, as on the peak of a v, it may turn."""
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        both, *seams = connection(end, start, size)
        step = np.diff(both.position, axis=0)
        speed = np.linalg.norm(step, axis=1) / np.diff(both.t)
        turn = np.abs(
            np.degrees(np.angle(np.exp(1j * np.diff(np.arctan2(step[:, 1], step[:, 0])))))
        )
        for seam in seams:
            around = slice(max(seam - 2, 0), seam + 1)
            moves = np.minimum(speed[:-1], speed[1:])[around] > 0.25 * np.median(speed)
            assert turn[around][moves].max(initial=0) < 22, (pair, seam)


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_the_way_between_letters_makes_no_detour(name):
    """It rises no higher than its ends and sinks no lower but for a dip, and leads to the right."""
    size = HANDS[name].x_height
    for pair, end, start in joints(name):
        both, a, k = connection(end, start, size)
        way = both.position[a : k + 1]
        here, there = way[0], way[-1]
        low, high = sorted([here[1], there[1]])
        assert way[:, 1].max() < high + 0.06 * size, pair
        assert way[:, 1].min() > low - 0.35 * size, pair
        assert np.diff(way[:, 0]).clip(max=0).sum() > -0.35 * size, pair
        rise, run = there[1] - here[1], there[0] - here[0]
        assert here[1] > 0.6 * size or rise < 1.9 * run, pair


@pytest.mark.parametrize("name", alphabets())
def test_the_white_between_letters_is_even(name):
    """Stems, bowls and mixed pairs have the same white, though their boxes stand unlike."""
    hand = HANDS[name]
    boxes, whites = [], []
    for one, other in ("nn", "oo", "no", "on", "ac", "ve"):
        left, right = hand.glyph(one), hand.glyph(other)
        moved = dense(right) + np.array([letter_spacing(left, right, hand.x_height), 0])
        bands = np.linspace(0.02, 0.98, 40) * hand.x_height
        edges = [
            [ink[np.abs(ink[:, 1] - y) < 0.03 * hand.x_height, 0] for ink in (dense(left), moved)]
            for y in bands
        ]
        gaps = [b.min() - a.max() if len(a) and len(b) else np.inf for a, b in edges]
        whites.append(np.minimum(gaps, 0.5 * hand.x_height).mean() / hand.x_height)
        boxes.append((moved[:, 0].min() - dense(left)[:, 0].max()) / hand.x_height)
    assert np.ptp(whites) < 0.12
    assert np.ptp(boxes) > 0.1


def test_round_letters_stand_nearer_than_stems_and_slopes_fit_into_each_other():
    hand = HANDS["round"]

    def gap(pair):
        left, right = map(hand.glyph, pair)
        step = letter_spacing(left, right, hand.x_height)
        return (step + points(right)[:, 0].min() - points(left)[:, 0].max()) / hand.x_height

    assert gap("OO") < gap("HH") - 0.08
    assert gap("AV") < gap("HH") - 0.2


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


def asked(x_height, width, height):
    """The strokes, or why there are none."""
    try:
        return write_lines("go dog all along", x_height=x_height, width=width, height=height)
    except LetterError as error:
        return error


def test_the_robot_writes_text_as_one_motion_where_it_stands():
    pytest.importorskip("placo")
    text = write_lines("go\nup", x_height=0.012, joined=True)
    motion = Fetch().write(text, Page.table(), at=text.middle)
    assert len(motion.strokes) == len(text)
    assert np.abs(points(motion.strokes) - points(text)).max() < 1e-9
    assert np.linalg.norm(motion.tip - motion.target, axis=1).max() < 1e-4


TEXT = "the quick brown fox jumps over the lazy dog"


@pytest.mark.slow
@pytest.mark.parametrize("joined", [False, True])
@pytest.mark.parametrize("x_height", [0.005, 0.009])
def test_lines_stay_inside_their_margins(x_height, joined):
    ink = points(
        write_lines(TEXT, width=0.15, height=0.2, margin=0.02, x_height=x_height, joined=joined)
    )
    assert np.abs(ink[:, 0]).max() <= 0.055 + 1e-9
    assert np.abs(ink[:, 1]).max() <= 0.08 + 1e-9
    assert ink[:, 0].min() == pytest.approx(-0.055)
    assert ink[:, 1].max() == pytest.approx(0.08, abs=3e-4)


def whites(name, parts, strokes, size):
    """The white along a line that leans as the hand does, after every character [x-heights]."""
    strokes, ends = iter(strokes), []
    for part in parts:
        ink = [next(strokes).position for _ in HANDS[name].glyph(part)]
        upright = np.concatenate(ink) @ (1.0, -HANDS[name].lean) / size
        ends.append((upright.min(), upright.max()))
    assert next(strokes, None) is None
    return np.array(
        [after[0] - before[1] for before, after in zip(ends[::2], ends[1::2], strict=True)]
    )


def seams(name, some, others):
    """For all pairs of these: the white in a word of the two, and the white between two words."""
    rows = [[part for other in others for part in (one, other)] for one in some]
    apart = write_lines(
        "\n".join(map(" ".join, rows)), x_height=0.004, width=10, height=10, alphabet=name
    )
    between = whites(name, [part for row in rows for part in row], apart, 0.004)
    pairs = [(one, other) for one in some for other in others]
    hand = HANDS[name]
    return [
        whites(name, pair, hand.word("".join(pair), False), hand.x_height)[0] for pair in pairs
    ], between


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_the_white_between_any_two_words_is_wider_than_any_within_a_word_and_varies_little(name):
    inside, between = seams(name, ALL, ALL)
    assert between.min() > 1.7 * max(inside)
    assert 0.59 < between.min() < between.max() < 0.92


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
def test_no_sign_stands_so_far_off_that_it_looks_like_another_word(name):
    """Brackets and fractions lean, as the letters beside them do; quotation marks stand high."""
    for some, others in ((ALL, SIGNS), (SIGNS, ALL), (SIGNS, SIGNS)):
        inside, between = seams(name, some, others)
        assert max(inside) < 0.46
        assert between.min() > 0.59


@pytest.mark.slow
@pytest.mark.parametrize("name", alphabets())
@pytest.mark.parametrize("joined", [False, True])
def test_words_stand_clearly_apart(name, joined):
    hand = HANDS[name]
    lines = ["jagen Viktor", "ein Tag", 'dog. "Who', "T. T", "a, j", "AV AV", "of all", "(so) f(x)"]
    ink = write_lines(
        "\n".join(lines), x_height=hand.x_height, width=9, height=9, alphabet=name, joined=joined
    )
    strokes = iter(points([stroke]) @ (1.0, -hand.lean) for stroke in ink)
    for line in lines:
        left, right = (
            np.concatenate([next(strokes) for _ in hand.word(part, joined)])
            for part in line.split()
        )
        assert 0.59 * hand.x_height < right.min() - left.max() < 1.0 * hand.x_height, line
    assert next(strokes, None) is None


def test_a_new_line_begins_at_the_left_margin_one_pitch_lower():
    upper, lower = write_lines("lo\nlo", pitch=0.05), write_lines("lo", pitch=0.05)
    half = len(upper) // 2
    for first, second, same in zip(upper[:half], upper[half:], lower, strict=True):
        np.testing.assert_allclose(second.position, first.position - (0, 0.05), atol=1e-12)
        np.testing.assert_allclose(first.position, same.position, atol=1e-12)


@pytest.mark.slow
@settings(max_examples=8, deadline=None)
@given(st.floats(0.004, 0.06), st.floats(0.06, 0.3), st.floats(0.06, 0.4))
def test_text_fits_or_the_error_names_a_size_that_does(x_height, width, height):
    answer = asked(x_height, width, height)
    if isinstance(answer, LetterError) and answer.cure is not None:
        assert answer.cure < x_height
        assert len(asked(answer.cure, width, height)) > 12
        assert isinstance(asked(answer.cure + 0.00011, width, height), LetterError)
    elif isinstance(answer, LetterError):
        assert "nothing readable fits" in str(answer)


def test_what_does_not_fit_is_said():
    with pytest.raises(
        LetterError, match=r"the word 'wide' is \d+ mm wide, but a line has 10 mm; x_height=.* fits"
    ):
        write_lines("wide", width=0.05)
    with pytest.raises(
        LetterError,
        match=r"there is room for \d lines inside the margins, but the text needs more; x_",
    ):
        write_lines(TEXT, height=0.1, x_height=0.02)


def test_text_is_written_on_the_page_where_it_stands():
    text = write_lines("two\nlines", x_height=0.01, joined=True)
    for placed, own in zip(lay_out(text, Page.table(), at=text.middle), text, strict=True):
        np.testing.assert_allclose(placed.position, own.position, atol=1e-12)
    assert repr(text).startswith("Text(")


@pytest.mark.parametrize("name", alphabets())
@pytest.mark.parametrize("joined", [False, True])
def test_a_long_word_fits_a_sheet_of_a4_unless_another_size_is_asked_for(name, joined):
    placed_there = lay_out(write_word("programming", name, joined=joined), Page.table())
    assert np.ptp(np.concatenate([s.position for s in placed_there])[:, 0]) > 0.1
