"""The lesson on new letters: what the browser draws is what the robot writes, and whose it is."""

from itertools import pairwise

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.lessons.two_hands import (
    BOWL,
    NewLetter,
    arrange_strokes,
    find_goals,
    learn_hands,
    speed_of,
)
from dmp_teach.scoring import read_letter

START = teach.lesson("07").start
MOVED = {"goal_x": 1.3, "goal_y": -1.7, "third_x": 6.1, "third_y": 2.2}
CM = 0.01


def answer_of(letter):
    """The answer that makes this letter, half by each hand."""
    third = {"D": "none", "P": "none", "R": "stem", "B": "bowl"}[letter]
    values = START | {"share": 50, "third": third}
    return values if letter == "D" else find_goals(values)


@pytest.mark.parametrize("share", [-50, 35, 150])
def test_a_blend_in_the_browser_is_the_blend_of_weights(share):
    style = learn_hands()
    blended = style.morph(*style.writers, share / 100)
    goals = {1: blended.primitives[1].goal + CM * np.array([1.3, -1.7])}
    drawn = NewLetter(START | MOVED | {"share": share}).lifted
    for points, stroke in zip(drawn, blended.write(goals), strict=False):
        assert np.abs(points - stroke.position).max() < 1e-12


@pytest.mark.parametrize("third", ["stem", "bowl", "hump", "ring"])
@pytest.mark.parametrize("hand", [0, 1])
def test_a_third_stroke_is_led_by_its_own_primitive(third, hand):
    values = START | MOVED | {"third": third, "share": 100 * hand}
    drawn = NewLetter(values).lifted
    letter = arrange_strokes(third)[hand]
    ways = {n: [MOVED[f"{knob}_x"], MOVED[f"{knob}_y"]] for n, knob in ((1, "goal"), (2, "third"))}
    goals = {n: letter.primitives[n].goal + CM * np.array(way) for n, way in ways.items()}
    written = letter.write(goals, starts={2: drawn[BOWL][-1]})
    assert np.abs(drawn[2] - written[2].position).max() < 1e-12
    assert np.abs(drawn[-1][0] - goals[2]).max() < 1e-12


@pytest.mark.parametrize("letter", ["R", "B"])
def test_in_one_line_the_pen_stops_to_turn_back_and_not_at_the_second_joint(letter):
    values = answer_of(letter) | {"way": "joined"}
    stem, bowl, third = NewLetter(values | {"way": "lifted"}).strokes
    (line,) = NewLetter(values).strokes
    t, speed = speed_of((line,)).T
    assert speed[(t > stem.t[-1] - 0.1) & (t < bowl.t[0] + 0.1)].min() < 0.5
    assert speed[(t > bowl.t[-1] - 0.25) & (t < bowl.t[-1] + 0.2)].min() > 4
    assert speed_of((third,))[:10, 1].min() < 2.5
    assert speed.max() < 70


@pytest.mark.parametrize("letter", ["P", "R", "B"])
def test_what_is_made_is_read_as_that_letter(letter):
    strokes = NewLetter(answer_of(letter)).strokes
    assert read_letter(strokes, wanted="D") == letter


def test_the_moved_bowl_is_taken_for_the_other_hand_and_the_turned_one_is_not():
    """As the notebook says of hand 2."""
    for share, hand in ((0, 1), (100, 2)):
        made = NewLetter(find_goals(START | {"share": share}))
        assert made.nearest == {"DMP*": 1, "similarity": hand}


def test_the_stem_leans_more_with_more_of_hand_2():
    leans = [NewLetter(START | {"share": share}).lean for share in range(-50, 151, 25)]
    assert all(b > a + 2 for a, b in pairwise(leans))


@pytest.mark.parametrize(
    ("changes", "cause"),
    [
        ({"goal_x": 3.0}, "{made.gap:.1f} mm right of the stem"),
        ({"goal_x": -1.0}, "left of the stem"),
        ({"goal_x": 0.0, "goal_y": -1.5}, "below the stem"),
        ({"goal_x": 1.7, "goal_y": 10.0}, "has a larger one"),
        ({"goal_x": 0.1, "goal_y": 1.0}, "nearly a D"),
        ({"third": "ring"}, "P has 2 strokes"),
        ({"share": 60, "goal_x": 1.2}, "With 60 % of hand 2 the stem leans by {made.lean:.1f}°"),
    ],
)
def test_the_cause_of_a_wrong_answer_is_named(changes, cause):
    answer = {name: answer_of("P")[name] for name in teach.lesson("07").settable}
    made = NewLetter(START | answer | changes)
    assert cause.format(made=made) in teach.check("07", answer | changes).reason
