"""The small picture of ink in a notebook."""

import re
from pathlib import Path
from xml.etree.ElementTree import fromstring

import numpy as np
import pytest

import dmp_teach
from dmp_teach.ink import svg_repr as drawing
from dmp_teach.ink.alphabet import characters, signs
from dmp_teach.trajectory import Trajectory
from tests.laws import for_every

ROOT = Path(__file__).parents[2]
NAMES = "{http://www.w3.org/2000/svg}"


def numbers(path):
    return np.array(re.findall(r"-?[0-9.]+", path.get("d")), float)


@pytest.mark.slow
@for_every([(character,) for character in [*characters(), *signs()]])
def test_every_letter_lies_on_its_sheet_with_a_circle_where_each_stroke_begins(character):
    recording = dmp_teach.recording_of(character)
    picture = fromstring(recording._repr_svg_())
    size = np.array([int(picture.get(side)) for side in ("width", "height")])
    assert 60 <= size.max() < 340
    inked = picture.findall(f"{NAMES}g/{NAMES}path")
    assert len(inked) == len(recording.strokes()) == len(list(picture.iter(f"{NAMES}circle")))
    for path in inked:
        if "h" not in path.get("d"):
            places = numbers(path).reshape(-1, 2)
            assert (places > 8).all()
            assert (places < size - 8).all()
    assert picture.find(f"{NAMES}title").text == repr(recording)


def test_a_person_is_dots_and_the_robot_a_line_in_the_colours_of_the_panels():
    strokes = dmp_teach.recording_of("D").strokes()
    person, robot = (drawing.draw_svg(strokes, "D", dotted=dotted) for dotted in (True, False))
    assert drawing.PERSON_INK in person
    assert "dasharray" in person
    assert drawing.ROBOT_INK in robot
    assert "dasharray" not in robot
    tokens = (ROOT / "dmp_teach" / "views" / "scene" / "tokens.css").read_text()
    for name in ("child", "robot", "ink", "paper", "paper-edge"):
        color = re.search(rf"--dt-{name}: (#[0-9a-f]+)", tokens)[1]
        assert color in (
            drawing.PERSON_INK,
            drawing.ROBOT_INK,
            drawing.START_COLOR,
            drawing.SHEET_COLOR,
            drawing.SHEET_EDGE_COLOR,
        ), name


def test_up_is_up_and_the_shape_is_kept():
    stroke = Trajectory(np.arange(3.0), [[0.0, 0.0], [0.02, 0.0], [0.02, 0.06]])
    (path,) = fromstring(drawing.draw_svg([stroke], "a corner", dotted=False)).iter(f"{NAMES}path")
    (x0, y0), (x1, y1), (x2, y2) = numbers(path).reshape(-1, 2)
    assert y0 == y1 > y2
    assert (y1 - y2) / (x1 - x0) == pytest.approx(3, rel=0.01)
    assert x1 == x2


def test_a_long_line_of_text_is_not_wider_than_a_notebook_and_a_very_long_stroke_has_few_points():
    t = np.arange(20_000.0)
    long = drawing.draw_svg(
        [Trajectory(t, np.column_stack([t, 0.01 * np.sin(t)]))], "long", dotted=True
    )
    assert int(fromstring(long).get("width")) < 1000
    assert len(long) < 20_000


def test_no_ink_is_no_picture_and_a_title_may_be_any_text():
    assert drawing.draw_svg([], "nothing", dotted=True) is None
    still = Trajectory([0.0, 0.1], [[0.0, 0.0], [0.0, 0.0]])
    picture = fromstring(drawing.draw_svg([still], "<a> & b", dotted=True))
    assert picture.find(f"{NAMES}title").text == "<a> & b"
    assert drawing.INK_CLASS in picture.get("class")
