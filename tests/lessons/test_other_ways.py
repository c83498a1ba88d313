"""Lesson 12: what its sentences say of five ways to learn is so, for every hand and letter."""

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.classroom import LessonState
from dmp_teach.lessons.five_ways import WAY_KEYS, Led, meant_by
from dmp_teach.lessons.goals import CM

pytest.importorskip("sklearn")
pytest.importorskip("hmmlearn", reason="it has no wheel for this computer")

VARIANTS = [teach.lesson("12", pupil=f"w{n:02d}") for n in range(12)]


def led(lesson, way, shown, shift=None):
    return Led(lesson.letter, lesson.hand, way, shown, shift or lesson.shift)


def test_one_letter_is_enough_for_dmp_star_and_not_for_spread():
    for lesson in VARIANTS:
        star = led(lesson, "dmp", 1)
        assert star.share > 95
        assert star.miss < 1
        assert led(lesson, "states", 1).share < star.share - 1
        assert led(lesson, "cost", 1).share < 92
        assert led(lesson, "spread", 1).miss > 40
        assert led(lesson, "spread", 5).miss < 0.1
        assert led(lesson, "spread", 5).share < 90


def test_the_fewest_letters_are_the_fewest_and_no_other_way_will_do():
    for lesson in VARIANTS:
        errors = [led(lesson, "cost", n).error for n in range(1, lesson.needed + 1)]
        assert errors[-1] <= lesson.limit < min(errors[:-1])
        assert led(lesson, "dmp", lesson.needed).error > lesson.limit
    for way in ("mixture", "states", "spread"):
        assert not VARIANTS[0].check({"way": way, "shown": VARIANTS[0].needed}).done


@pytest.mark.parametrize("way", ["dmp", "states", "cost", "spread"])
def test_the_line_that_follows_the_ring_is_what_is_written(way):
    lesson = VARIANTS[0]
    line = led(lesson, way, 4).line
    drawn = line.base + 2.5 * line.terms["goal_x"] - 4 * line.terms["goal_y"]
    goal = meant_by(lesson.letter)[-1] + CM * np.array([2.5, -4.0])
    assert np.abs(drawn - led(lesson, way, 4).tried.way.write(goal).position).max() < 1e-9


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (
            {"way": "dmp", "shown": 7},
            "shown 7, and learned the first alone, with its slips: {error:.1f}",
        ),
        ({"way": "spread", "shown": 2}, "spread is {error:.1f} mm off, and it stores 861 numbers"),
        ({"way": "states", "shown": 6}, "it stores 209 numbers; 100 are allowed"),
        ({"way": "cost", "shown": 2}, "The mean of 2 still has some of their slips"),
        ({"way": "cost", "shown": 8}, "fewer will do, too"),
    ],
)
def test_each_mistake_is_told_with_the_numbers_of_the_answer(answer, words):
    lesson = teach.lesson("12")
    error = led(lesson, **answer).error
    assert words.format(error=error) in lesson.check(answer).reason


def test_in_the_challenge_the_goal_is_at_home_wherever_it_was_tried():
    lesson = teach.lesson("12")
    for goal in ({}, {"goal_x": -5.0, "goal_y": 2.0}):
        solved = LessonState(lesson.solution | goal, "challenge", None, True)
        picture = lesson.draw(solved)
        assert np.abs(picture.strokes[0].position[-1] - meant_by("S")[-1]).max() < 0.005
        assert np.array_equal(picture.sheet["rings"][0]["at"], [meant_by("S")[-1]])


def test_all_ways_are_seen_side_by_side_after_the_bet_and_none_before():
    lesson = teach.lesson("12")
    hidden, seen = (lesson.draw(LessonState(lesson.start, "bet", None, is_r)) for is_r in (0, 1))
    kinds = [
        [line["kind"] for line in each.plots["ways"].get("lines", [])] for each in (hidden, seen)
    ]
    assert (kinds[0], hidden.sheet["robot"]) == ([], [])
    assert (kinds[1].count("robot"), kinds[1].count("quiet")) == (1, len(WAY_KEYS) - 1)


def test_without_its_library_a_way_is_not_offered(monkeypatch):
    monkeypatch.setattr(WAY_KEYS["states"], "library", "no_such_library")
    lesson = teach.lesson("12")
    assert lesson.settable["way"] == ("dmp", "mixture", "cost", "spread")
    assert lesson.check({"way": "cost", "shown": lesson.needed}).done
    assert lesson.draw(LessonState(lesson.start, "bet", None, True)).strokes
