"""A contact sheet shows every letter as it was written, and how."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.ink.recording import Recording
from dmp_teach.views.figures import draw_contact_sheet
from dmp_teach.views.figures.alphabet import NUMBER_OFFSET

FEW = [recording_of(letter) for letter in "xDiEç"]
SCALE = 1.35 / max(
    np.ptp(np.concatenate([s.position for s in each.strokes()]), axis=0).max() for each in FEW
)
STROKES = [SCALE * stroke.position for recording in FEW for stroke in recording.strokes()]


def panel_of(**about):
    """The one panel of a sheet of a few letters."""
    (panel,) = draw_contact_sheet(recordings=FEW, **about).axes
    return panel


def ink_of(panel):
    """What was drawn as ink, and neither a writing line nor a start, (T, 2) each [inch]."""
    return [np.column_stack(line.get_data()) for line in panel.lines if len(line.get_xdata()) > 2]


@pytest.mark.parametrize("name", alphabets())
def test_the_sheet_of_an_alphabet_shows_every_stroke_of_every_letter(name):
    figure = draw_contact_sheet(name, numbers=False)
    every = [
        stroke for letter in characters(name) for stroke in recording_of(letter, name).strokes()
    ]
    drawn = ink_of(figure.axes[0])
    assert [len(ink) for ink in drawn] == [len(stroke) for stroke in every]
    low, high = (
        np.column_stack([figure.axes[0].get_xlim(), figure.axes[0].get_ylim()])[k] for k in (0, 1)
    )
    assert all((ink > low).all() and (ink < high).all() for ink in drawn)


@pytest.mark.parametrize("numbers", [True, False])
def test_ink_is_drawn_in_one_scale_and_stands_on_its_line(numbers):
    panel = panel_of(numbers=numbers)
    line = panel.lines[0].get_ydata()[0]
    for drawn, stroke in zip(ink_of(panel), STROKES, strict=True):
        np.testing.assert_allclose(drawn - drawn[0], stroke - stroke[0], atol=1e-9)
        assert drawn[0, 1] - line == pytest.approx(stroke[0, 1])


def test_the_second_line_is_as_high_as_an_x():
    panel = panel_of()
    height = panel.lines[1].get_ydata()[0] - panel.lines[0].get_ydata()[0]
    assert height == pytest.approx(max(stroke[:, 1].max() for stroke in STROKES[:2]))


def test_a_small_hand_is_shown_as_large_as_a_large_one():
    small = []
    for each in FEW:
        spans = [
            each.t.searchsorted([stroke.t[0], stroke.t[-1] + 1e-4]) for stroke in each.strokes()
        ]
        small.append(
            replace(each, position=each.position / 9, given_strokes=tuple(map(tuple, spans)))
        )
    (panel,) = draw_contact_sheet(recordings=small).axes
    for drawn, stroke in zip(ink_of(panel), ink_of(panel_of()), strict=True):
        np.testing.assert_allclose(drawn, stroke, atol=1e-9)


def test_letters_do_not_touch():
    letters = iter(ink_of(panel_of()))
    boxes = [
        np.concatenate([next(letters) for _ in recording.strokes()])[:, 0] for recording in FEW
    ]
    assert all(left.max() + 0.1 < right.min() for left, right in pairwise(boxes))


def test_every_stroke_has_its_number_beside_its_start():
    panel = panel_of()
    numbers = [text for text in panel.texts if text.get_text()]
    expected = [str(k + 1) for recording in FEW for k in range(len(recording.strokes()))]
    assert [text.get_text() for text in numbers] == expected
    for text, ink in zip(numbers, ink_of(panel), strict=True):
        assert np.linalg.norm(np.subtract(text.get_position(), ink[0])) == pytest.approx(
            NUMBER_OFFSET
        )
    places = [text.get_position() for text in numbers]
    assert all(
        np.linalg.norm(np.subtract(a, b)) > 0.04 for k, a in enumerate(places) for b in places[:k]
    )


def test_arrows_point_where_the_pen_went_and_a_dot_has_none():
    panel, pointed = panel_of(), []
    inks = ink_of(panel)
    for arrow in (text for text in panel.texts if not text.get_text()):
        tail = np.array(arrow.xyann)
        number = int(np.argmin([np.linalg.norm(ink - tail, axis=1).min() for ink in inks]))
        k = int(np.argmin(np.linalg.norm(inks[number][1:-1] - tail, axis=1)))
        assert (inks[number][k + 2] - inks[number][k]) @ (np.array(arrow.xy) - tail) > 0
        pointed.append(number)
    dot = [len(stroke) for stroke in STROKES].index(min(map(len, STROKES)))
    assert set(pointed) == set(range(len(STROKES))) - {dot}


def test_without_numbers_the_sheet_is_ink_alone():
    panel = panel_of(numbers=False)
    assert len(panel.texts) == 0
    assert len({line.get_color() for line in panel.lines if len(line.get_xdata()) > 2}) == 1


def test_a_letter_without_a_line_stands_on_its_lowest_point():
    d = recording_of("D")
    panel = draw_contact_sheet(
        recordings=Recording(d.t, d.position + np.array([0, 0.3, 0]), "D")
    ).axes[0]
    assert min(ink[:, 1].min() for ink in ink_of(panel)) == pytest.approx(
        panel.lines[0].get_ydata()[0]
    )


def test_any_recording_can_be_shown_however_short_its_strokes():
    t = np.linspace(0, 1, 20)
    for path in (0 * t, 1e-4 * t, 0.01 * np.sin(9 * t)):
        point = Recording(t, np.column_stack([path, 0 * t, 0 * t]), given_strokes=((0, 20),))
        assert len(ink_of(draw_contact_sheet(recordings=[point]).axes[0])) == 1


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"recordings": []}, "made of recordings, but got none"),
        ({"recordings": ["a"]}, "made of recordings, but got a str"),
        ({"recordings": 3}, "made of recordings, but got an int"),
        (
            {"alphabet": "round", "recordings": FEW},
            "recordings and an alphabet, 'round'; give one of them",
        ),
        ({"alphabet": "runes"}, "There is no alphabet 'runes'"),
    ],
)
def test_what_cannot_be_shown_is_said(asked, sentence):
    with pytest.raises(RecordingError, match=sentence):
        draw_contact_sheet(**asked)
