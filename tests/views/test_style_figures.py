"""The sheet of a style shows the letters of the style."""

import numpy as np
import pytest

from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.styles import Style
from dmp_teach.views.figures.style import LETTERS_PER_ROW, draw_style_sheet


@pytest.fixture(scope="module")
def style():
    return Style.of([recording_of("D", hand) for hand in ("round", "slanted")])


def test_every_letter_of_the_sheet_is_one_of_the_style(style):
    panels = np.reshape(draw_style_sheet(style, seed=3).axes, (-1, LETTERS_PER_ROW))
    assert len(panels) == 4, "two writers have one principal style"
    ink = [
        [line.get_xydata() for line in panel.lines if len(line.get_xydata()) > 1]
        for panel in panels.flat
    ]
    morph = style.morph("writer-1", "writer-2", 0.5).write()
    for drawn, stroke in zip(ink[LETTERS_PER_ROW + 2], morph, strict=True):
        assert np.allclose(drawn, 1e3 * stroke.position)
    chance = style.sample(np.random.default_rng(3)).write()
    assert np.allclose(ink[3 * LETTERS_PER_ROW][0], 1e3 * chance[0].position)


def test_the_names_say_who_and_how_far(style):
    titles = [panel.get_title() for panel in draw_style_sheet(style).axes]
    assert titles[:2] == ["writer-1", "writer-2"]
    assert titles[LETTERS_PER_ROW : 2 * LETTERS_PER_ROW] == ["0 %", "25 %", "50 %", "75 %", "100 %"]
    assert titles[2 * LETTERS_PER_ROW : 2 * LETTERS_PER_ROW + 3] == [
        "−2 deviations",
        "−1 deviations",
        "the mean",
    ]
