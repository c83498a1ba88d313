"""Lesson 05: what its sentences say of rules and goals is so."""

import itertools

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.dmp import Stepper
from dmp_teach.lessons.goals import GOAL_RULES, LEAST_SHARE, MovedLetter, draw_moved, learn

VARIANTS = [teach.lesson("05", pupil=f"w{n:02d}") for n in range(30)]


def moved(lesson, **values):
    """The letter of a lesson, with other values than those of its solution."""
    return MovedLetter(lesson.letter, lesson.solution | values)


@pytest.mark.parametrize("rule", GOAL_RULES)
@pytest.mark.parametrize("step", [0, 37, 150])
def test_a_moved_goal_is_drawn_as_the_stepper_draws_it(rule, step):
    primitive = learn("S", rule)
    goal = primitive.goal + np.array([0.06, -0.02])
    pen = Stepper.begin(primitive, goal=goal if step == 0 else None)
    path = [pen.position]
    while not pen.over:
        pen = (pen.led(goal) if len(path) == step + 1 else pen).step()
        path.append(pen.position)
    stepped = primitive.at_sample_times(np.array(path))
    assert np.abs(draw_moved(primitive, goal, step) - stepped).max() < 1e-12


def test_all_rules_draw_the_same_letter_to_its_old_goal():
    home = {"goal_x": 0.0, "goal_y": 0.0}
    paths = [moved(VARIANTS[0], rule=rule, **home).path for rule in GOAL_RULES]
    assert max(np.abs(a - b).max() for a, b in itertools.pairwise(paths)) < 1e-9


def test_the_line_that_follows_the_ring_is_the_rollout():
    for rule in GOAL_RULES:
        led = moved(VARIANTS[0], rule=rule, goal_x=-7.3, goal_y=2.1)
        drawn = led.primitive.rollout(goal=led.primitive.goal + np.array([-0.073, 0.021])).position
        assert np.abs(led.path - drawn).max() < 1e-9


def test_every_bet_is_on_a_mirrored_letter_that_is_hardly_wider():
    factors = [MovedLetter(each.letter, each.start).factors[0] for each in VARIANTS]
    assert -1.05 < min(factors) <= max(factors) < -0.5


def test_a_goal_under_the_start_makes_the_first_rule_explode():
    led = MovedLetter("C", VARIANTS[0].start | {"goal_x": 1.0})
    assert -9 < led.factors[0] < -8, "as the notebook says"
    assert np.ptp(led.path[:, 0]) > 7 * np.ptp(led.strokes[0].position[:, 0])


def test_the_challenge_asks_for_a_rule_that_slides_from_the_start_on():
    for lesson in VARIANTS:
        assert lesson.check({k: lesson.solution[k] for k in lesson.settable}).done
        assert moved(lesson, rule="original").share < 50
        assert moved(lesson, rule="printed").miss > 1
        assert moved(lesson, moves_at=lesson.latest).share < LEAST_SHARE - 3
        assert moved(lesson).share > LEAST_SHARE + 3


@pytest.mark.parametrize(
    ("values", "words"),
    [
        (
            {"rule": "original"},
            "The S is mirrored. The first rule multiplies by new way / old way: {fx} sideways",
        ),
        ({"rule": "original", "goal_x": 6.7}, "the S is thin"),
        ({"rule": "similarity"}, "turns it by"),
        ({"rule": "printed"}, "stops {mm} mm from its goal"),
        ({"moves_at": 2.0}, "At 2.0 s a part of the S is written already"),
        ({"goal_x": -3.0}, "moved 3.0 cm to the left; it is to move 10 cm to the right"),
        ({"goal_y": 1.0}, "moved 1.0 cm up; it is to move 4 cm up"),
    ],
)
def test_each_mistake_is_told_with_the_numbers_of_the_answer(values, words):
    lesson = teach.lesson("05")
    answer = {k: (lesson.solution | values)[k] for k in lesson.settable}
    facts = MovedLetter(lesson.letter, answer).facts
    assert words.format(**facts) in teach.check("05", answer).reason


def test_a_bet_on_the_old_shape_is_told_what_keeps_it():
    lesson = teach.lesson("05")
    lines = {name: MovedLetter("S", lesson.start | {"rule": name}).path for name in GOAL_RULES}
    told = {name: lesson.tell_bet(line[::20].tolist()) for name, line in lines.items()}
    assert "as a newer rule does" in told["star"]
    assert "You saw that coming" in told["original"]
    straight = lesson.bet.described()["handles"]
    assert "A newer rule keeps the shape" in lesson.tell_bet(straight)
