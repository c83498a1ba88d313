"""The figure of the rules for strokes."""

from dmp_teach.views.figures.figure_style import COLOURS
from dmp_teach.views.figures.stroke import NAMES, strokes_by_rule
from tests.segmentation.test_manual_cuts import D


def titles(figure):
    return [axes.get_title(loc="left") for axes in figure.axes if axes.get_title(loc="left")]


def test_every_rule_has_a_row_that_counts_its_strokes():
    assert titles(strokes_by_rule(D)) == [
        f"{NAMES[rule]}: {len(D.strokes(rule=rule))} strokes"
        for rule in ("foot", "printed", "authors")
    ]


def test_cuts_by_hand_have_a_row_of_their_own_where_they_are():
    by_hand = D.with_strokes([(0.6, 1.2)])
    figure = strokes_by_rule(by_hand)
    assert titles(figure)[-1] == f"{NAMES['hand']}: 1 stroke"
    assert titles(figure)[:3] == titles(strokes_by_rule(D))
    panel = next(
        axes for axes in figure.axes if axes.get_title(loc="left").startswith(NAMES["hand"])
    )
    edges = {
        round(line.get_xdata()[0], 2) for line in panel.lines if line.get_color() == COLOURS[0]
    }
    assert edges == {0.6, 1.2}


def test_a_rule_that_finds_nothing_says_so():
    assert "no stroke" in titles(strokes_by_rule(D, sigma=1e-6))[2]


def test_the_figure_is_drawn():
    assert strokes_by_rule(D)._repr_png_().startswith(b"\x89PNG")
