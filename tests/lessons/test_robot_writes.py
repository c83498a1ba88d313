"""The lesson on where a robot can write: its maps, curves and numbers are the robot's own."""

import subprocess
import sys

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.lessons.page_plan import border_of
from dmp_teach.lessons.writing_setup import WritingSetup, write_letter
from dmp_teach.robot import BREAKING_FORCE
from tests.classroom.browser import send

QUESTION = """
import sys, dmp_teach as teach
lesson = teach.lesson("08")
lesson.check(lesson.solution)
print([name for name in ("placo", "pybullet", "pinocchio", "matplotlib") if name in sys.modules])
"""


@pytest.fixture(params=[None, "w01", "w07", "w22"])
def lesson(request):
    return teach.lesson("08", pupil=request.param)


def test_neither_the_question_nor_its_check_needs_physics():
    told = subprocess.check_output([sys.executable, "-c", QUESTION], text=True)
    assert told.strip() == "[]"


def test_another_place_pen_or_speed_fails_and_says_why(lesson):
    for change, why in (
        ({"ahead": 115}, "out of the arm’s reach"),
        ({"pen": "rigid"}, "cannot give way"),
        ({"pen": "rigid", "press": 0}, "no ink"),
        ({"press": 0}, "It needs 0.2 N"),
        ({"press": 14}, "the spring is at its end"),
        ({"speed": 10}, "10 cm/s is too slow"),
    ):
        verdict = lesson.check(lesson.solution | change)
        assert not verdict.done
        assert why in verdict.reason


def test_a_board_is_reached_further_away_than_a_table_and_not_near_by():
    """As the notebook says: 25 cm further; and before a board there must be room for the arm."""
    table, board = (teach.known_reach(name).reached[18] for name in ("table", "board"))
    x = teach.known_reach("table").x
    assert x[board].max() - x[table].max() == pytest.approx(0.25)
    assert x[table].min() == pytest.approx(0.30)
    assert x[board].min() > 0.5
    verdict = teach.check("08", teach.lesson("08").solution | {"ahead": 30, "right": 0})
    assert "in its own way" in verdict.reason


def test_a_bet_on_the_true_border_is_told_so():
    lesson = teach.lesson("08")
    border = border_of("table")
    places = border[np.linspace(0, len(border) - 1, len(lesson.bet.handles)).astype(int)]
    told = lesson.tell_bet(places.tolist())
    assert "it is 85 cm ahead" in told
    assert int(told.partition("your line is ")[2].split()[0]) <= 1


def test_the_robot_writes_where_the_page_is_set_or_moves_the_knobs_to_its_cure():
    panel = teach.lesson("08").panel()
    panel.forget()
    panel.go("try")
    panel.write()
    assert panel.work["state"] == "cannot"
    told = panel.work["strong"] + panel.work["text"]
    assert panel.message["number"] in told
    assert "80 cm ahead" in told
    assert "Page." not in told
    assert panel.progress["done"] == []
    send(panel, {"kind": "cure"})
    assert panel.motion.page.X_world_page[0, 3] == pytest.approx(panel.values["ahead"] / 100)
    assert panel.values["ahead"] < 90
    assert panel.progress["done"] == [0]
    assert not panel.older
    panel.values = panel.values | {"right": 10}
    assert panel.older
    panel.forget()


@pytest.mark.parametrize("where", ["table", "board"])
def test_pens_press_as_in_the_simulation(where):
    """A spring to 0.05 N; a rigid pen breaks."""
    pytest.importorskip("pybullet", reason="pybullet is not installed")
    values = {"where": where, "ahead": 75, "right": 0, "pen": "sprung", "press": 6, "speed": 60}
    motion = teach.Fetch().write(write_letter("e", 60), WritingSetup(values).page)
    for pen, motors, press in (("sprung", "ideal", 6), ("rigid", "real", 1)):
        setup = WritingSetup(values | {"pen": pen, "press": press})
        run = teach.simulate(motion, **setup.physics(motors))
        if pen == "sprung":
            assert run.force_band == pytest.approx([setup.force] * 2, abs=0.05)
        else:
            assert min(run.greatest_force, setup.force) > BREAKING_FORCE
            assert "The pen broke" in teach.lesson("08").tell_run(run)
