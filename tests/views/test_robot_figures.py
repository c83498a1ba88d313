"""The reach map shows what its data says, and its marks stay apart without colour."""

import numpy as np
import pytest

from dmp_teach.errors import ViewError
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.map import ReachMap
from dmp_teach.views.figures.robot import draw_reach, draw_writing

INF = np.inf


def made(name, across):
    """A map with one page of every kind in its first row."""
    x = (0.2, 0.5, 0.8, 1.1)
    pages = tuple(tuple(Page.table(far) for far in x) for _ in across)
    effort = [[INF, 1.0, 3.0, INF]] * len(across)
    return ReachMap(x, across, name, pages, effort, [[0.0, 0.0, 0.0, 0.3]] * len(across))


MAPS = made("y", (-0.3, 0.0, 0.5)), made("tilt", np.radians((0, 90)))


@pytest.fixture(scope="module")
def figure():
    return draw_reach(*MAPS)


def marks(panel):
    return {line.get_label(): line for line in panel.lines if not line.get_label().startswith("_")}


def test_every_kind_of_page_stands_where_it_is(figure):
    above, by_tilt = figure.axes
    for name, x in (
        ("near enough, but robot or paper is in the way", 0.2),
        ("reached", 0.5),
        ("reached, but a joint must hurry", 0.8),
        ("too far", 1.1),
    ):
        np.testing.assert_allclose(np.sort(marks(above)[name].get_xdata()), (-0.5, 0.0, 0.3))
        np.testing.assert_allclose(marks(above)[name].get_ydata(), x)
        np.testing.assert_allclose(marks(by_tilt)[name].get_xdata(), x)
        np.testing.assert_allclose(marks(by_tilt)[name].get_ydata(), (0, 90))


def test_without_colour_the_marks_stay_apart(figure):
    forms = [line.get_marker() for line in marks(figure.axes[0]).values()]
    assert len(set(forms)) == len(forms) == 4


@pytest.mark.parametrize("maps", [MAPS[:1], MAPS[1:], MAPS], ids=("from above", "by tilt", "both"))
def test_every_mark_is_explained_within_the_figure_and_every_word_stands_within_it(maps):
    drawn = draw_reach(*maps)
    drawn.draw_without_rendering()
    (legend,) = drawn.legends
    assert {text.get_text() for text in legend.texts} == set(marks(drawn.axes[0]))
    for text in (*legend.texts, *(text for panel in drawn.axes for text in panel.texts)):
        box = text.get_window_extent()
        assert drawn.bbox.x0 <= box.x0
        assert box.x1 <= drawn.bbox.x1


def test_the_robot_is_seen_from_above_in_its_place(figure):
    above = figure.axes[0]
    corners = np.concatenate([patch.get_xy() for patch in above.patches])
    assert np.abs(corners[:, 0]).max() == pytest.approx(0.27, abs=0.03)
    assert above.get_aspect() == 1
    (arm,) = [text for text in above.texts if "arm begins" in text.get_text()]
    assert arm.xy == pytest.approx((0.0, 0.033), abs=0.002)


def test_axes_have_units(figure):
    above, by_tilt = figure.axes
    assert all("[m]" in label for label in (above.get_xlabel(), above.get_ylabel()))
    assert "[m]" in by_tilt.get_xlabel()
    assert "[degrees]" in by_tilt.get_ylabel()


@pytest.mark.parametrize("maps", [(), (None,), (MAPS[0], 3)])
def test_what_is_no_map_is_refused(maps):
    with pytest.raises(
        ViewError, match=r"takes maps, as reach_map\(\) and reach_around\(\) give them"
    ):
        draw_reach(*maps)


def test_from_frame_to_frame_there_is_more_ink(motion):
    pytest.importorskip("pybullet", reason="pybullet draws the frames")
    frames = [panel.images[0].get_array() for panel in draw_writing(motion, "page from above").axes]
    ink = [(frame[..., 2] - frame[..., 0] > 0.4).sum() for frame in frames]
    assert len(ink) == 6
    assert ink == sorted(ink)
    assert ink[-1] > 2 * ink[0]
