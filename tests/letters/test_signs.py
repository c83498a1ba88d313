"""Letters and signs stand beside each other and never on each other, in every language."""

from itertools import combinations
from string import digits

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from dmp_teach.ink.alphabet import SIGNS, alphabets
from dmp_teach.letters.text.handwriting import plain_text
from dmp_teach.letters.text.lines import write_lines
from dmp_teach.letters.text.spacing import letter_spacing
from tests.letters.text import ALL, HAND, HANDS, dense, points, word


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
