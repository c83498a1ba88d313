"""Whose letter it is, drawn: what the figures show is what was found."""

import numpy as np
import pytest

from dmp_teach.errors import SettingError
from dmp_teach.studies.authorship.answers import Answers, Attributions
from dmp_teach.views.figures import draw_attribution_bars, draw_confusion

ITEMS = (("w1", "w1"), ("w1", "w2"), ("w2", "w2"), ("w3", None))
ASKED = Answers("DMP*, as drawn", ITEMS, 1 / 3, 0.04)
NOTHING = Answers("other takes", (), float("nan"), 1.0)


def texts(figure):
    figure.canvas.draw()
    return [text.get_text() for panel in figure.axes for text in panel.texts]


def test_a_bar_is_the_rate_and_a_line_its_interval():
    figure = draw_attribution_bars(Attributions((NOTHING, ASKED)), Attributions((ASKED,)))
    (panel,) = figure.axes
    assert [bar.get_width() for bar in panel.patches] == pytest.approx(
        [50.0, 50.0]
    )  # 1/2, 1 and 0 of three writers
    intervals, guesses = panel.collections
    np.testing.assert_allclose(
        [line[:, 0] for line in intervals.get_segments()], [100 * np.array(ASKED.interval)] * 2
    )
    np.testing.assert_allclose([line[0, 0] for line in guesses.get_segments()], [100 / 3] * 2)
    assert texts(figure) == ["2 of 4, by luck 0.040"] * 2
    assert [label.get_text() for label in panel.get_yticklabels()] == ["DMP*, as drawn"] * 2


def test_who_was_taken_for_whom_is_a_row_for_each_writer():
    figure = draw_confusion(ASKED)
    (panel,) = figure.axes
    np.testing.assert_allclose(panel.images[0].get_array(), ASKED.confusion)
    assert texts(figure) == ["50", "50", "100"]
    assert [label.get_text() for label in panel.get_yticklabels()] == ["w1", "w2", "w3"]


def test_many_writers_are_shades_only():
    many = Answers("all", tuple((f"w{k:02}", f"w{k:02}") for k in range(30)), 1 / 30, 0.001)
    assert texts(draw_confusion(many)) == []


def test_nothing_is_not_drawn():
    with pytest.raises(
        SettingError,
        match="Nothing was asked; give what classify_writers or attribute_made_letters",
    ):
        draw_attribution_bars(Attributions((NOTHING,)))
    with pytest.raises(SettingError, match="'other takes' could be asked of no letter"):
        draw_confusion(NOTHING)
