"""Lines of text: words that stand clearly apart, within their margins."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError
from dmp_teach.ink.alphabet import SIGNS, alphabets
from dmp_teach.letters.text.lines import write_lines
from dmp_teach.letters.text.words import write_word
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.layout import lay_out
from dmp_teach.robot.page import Page
from tests.letters.text import ALL, HANDS, points


def asked(x_height, width, height):
    """The strokes, or why there are none."""
    try:
        return write_lines("go dog all along", x_height=x_height, width=width, height=height)
    except LetterError as error:
        return error


def test_the_robot_writes_text_as_one_motion_where_it_stands():
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
