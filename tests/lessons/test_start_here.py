"""What lesson 00 and its notebook say of bumps and goals is true."""

from pathlib import Path

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.classroom import LessonState
from dmp_teach.lessons.start_here import error_with, most_kernels

NOTEBOOK = Path(__file__).parents[2] / "notebooks" / "00_start_here.ipynb"


@pytest.mark.parametrize("said", ["5", "40", "400"])
def test_a_bet_is_told_the_errors_that_are_computed(said):
    told = teach.lesson("00").tell_bet(said)
    assert said in told
    for number in (5, 40, most_kernels("a")):
        assert f"{number}" in told
        error = error_with("a", number)
        assert (f"{error:.0f} mm" if error > 10 else f"{error:.2f}") in told
    assert error_with("a", 40) == pytest.approx(0.1, abs=0.02), "as thick as a hair"
    assert f"seen {most_kernels('a')} times" in NOTEBOOK.read_text(encoding="utf-8")


@pytest.mark.parametrize("pupil", [None, *(f"w{n:02d}" for n in range(12))])
def test_a_letter_that_nobody_wrote_is_one_drag_away_and_the_line_follows_in_the_browser(pupil):
    lesson = teach.lesson("00", pupil=pupil)
    picture = lesson.draw(LessonState(lesson.solution, "challenge", None, True))
    line = picture.sheet["robot"][-1]
    seen = line.base + sum(lesson.solution[name] * term for name, term in line.terms.items())
    assert np.allclose(seen, picture.strokes[-1].position, atol=1e-9)
    assert np.linalg.norm(seen[-1] - lesson.end) < 0.0015
    unmoved = lesson.solution | {"goal_x": 0.0, "goal_y": 0.0}
    reason = lesson.check(unmoved).reason
    assert ("below" if lesson.solution["goal_y"] > 0 else "above") in reason
    assert f"{abs(lesson.solution['goal_y']):.1f} cm" in reason


def test_a_task_of_the_robot_is_ticked_when_it_has_written():
    panel = teach.lesson("00").panel()
    panel.forget()
    panel.go("try")
    panel.write()
    assert panel.progress["done"] == [2]
    panel.forget()
