"""The figure of the rules for strokes."""

from dmp_teach.segmentation import RULES
from dmp_teach.views.figures.stroke import RULE_NAMES, draw_strokes_by_rule
from dmp_teach.views.palette import STROKE_COLORS
from tests.segmentation.test_manual_cuts import D


def titles(figure):
    return [axes.get_title(loc="left") for axes in figure.axes if axes.get_title(loc="left")]


def test_every_rule_has_a_row_that_counts_its_strokes():
    assert titles(draw_strokes_by_rule(D)) == [
        f"{RULE_NAMES[rule]}: {len(D.strokes(rule=rule))} strokes" for rule in RULES
    ]


def test_cuts_by_hand_have_a_row_of_their_own_where_they_are():
    by_hand = D.with_strokes([(0.6, 1.2)])
    figure = draw_strokes_by_rule(by_hand)
    assert titles(figure)[-1] == f"{RULE_NAMES['hand']}: 1 stroke"
    assert titles(figure)[:4] == titles(draw_strokes_by_rule(D))
    panel = next(
        axes for axes in figure.axes if axes.get_title(loc="left").startswith(RULE_NAMES["hand"])
    )
    edges = {
        round(line.get_xdata()[0], 2)
        for line in panel.lines
        if line.get_color() == STROKE_COLORS[0]
    }
    assert edges == {0.6, 1.2}


def test_a_rule_that_finds_nothing_says_so():
    assert "no stroke" in titles(draw_strokes_by_rule(D, sigma=1e-6))[2]
