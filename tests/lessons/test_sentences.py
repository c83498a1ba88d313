"""What lessons say of an answer is so, and its numbers do not hide the verdict."""

import pytest

import dmp_teach as teach
from dmp_teach.classroom import tell_number
from dmp_teach.lessons.how_many_bumps import error_with_number

GAPS = "leaves gaps: for"


def said(key, **values):
    """What is said of the solution with other values."""
    lesson = teach.lesson(key)
    return lesson.check({name: (lesson.solution | values)[name] for name in lesson.settable}).reason


@pytest.mark.parametrize(
    ("key", "values", "words"),
    [
        ("01", {"alpha": 12, "beta": 4.4}, "goes past the ring by 1.01 % of the way"),
        ("01", {"alpha": 14, "beta": 3.3}, "after 0.9 s 2.1 % of the way is left"),
        ("01", {"alpha": 14, "beta": 3.6}, "It does not swing, and from 0.9 s on at most 1.0 %"),
        ("01", {"alpha": 13, "beta": 4.2}, "It goes past the ring by 0.3 % of the way"),
        ("02", {"change": 6.42457}, "+6.42 cm is the wrong way"),
        ("03", {"kernel_width": 0.29, "fit": "joint"}, f"Width 0.29 {GAPS} 71 %"),
        ("03", {"kernel_width": 0.99}, f"Width 0.99 {GAPS} 1 %"),
        (
            "03",
            {"kernel_width": 18, "fit": "joint"},
            "All together each bump is told what the others do, and at width 18 D is",
        ),
        ("03", {"kernel_width": 0.5, "kernel": "bell"}, "no gap however narrow it is"),
        ("03", {"kernel_width": 18, "kernel": "bell"}, "averages so many places"),
        ("03", {"kernel_width": 1.4}, "At width 1 bumps just touch"),
        ("05", {"rule": "original", "goal_x": 6.7}, "straight above or below the start"),
        ("05", {"rule": "original", "goal_x": 5.9, "goal_y": -0.5}, "The S shrinks sideways"),
        ("06", {"theta": 60, "sigma": 5.502087172973264}, "σ = 5.5 mm lets that count"),
    ],
)
def test_the_cause_is_named_with_its_numbers(key, values, words):
    assert words in said(key, **values)


def test_gaps_are_named_where_they_do_harm_and_else_are_not_refused():
    lesson = teach.lesson("03")
    for width in (0.6, 0.9, 0.98, 0.99, 0.999, 0.99999):
        verdict = lesson.check(lesson.solution | {"kernel_width": width})
        assert (GAPS in verdict.reason, "keeps both" in verdict.reason) == (
            not verdict.done,
            verdict.done,
        )


@pytest.mark.parametrize("value", [1.96, 2.0, 2.04, 2.0004, 1.9996, 0.0, -0.01, 94.9])
@pytest.mark.parametrize("limit", [0, 2, 95])
def test_a_number_stays_on_its_side_of_a_limit(value, limit):
    number = float(tell_number(value, limit, 0).replace("−", "-"))
    assert (number > limit, number < limit) == (value > limit, value < limit)


def test_ways_past_the_ring_carry_a_minus_sign():
    lesson = teach.lesson("01")
    told = lesson.tell_bet([[0.25, 26.0], [0.5, 100.0]])
    assert "−" in told
    assert "-" not in told


def test_a_doubling_leaves_what_the_letter_of_the_pupil_leaves():
    lesson = teach.lesson("04", pupil="w03")
    errors = [error_with_number(lesson.letter, n) for n in (10, 20, 40, 80)]
    told = lesson.tell_bet([[10, 5.0], [80, 5.0]])
    left = 100 * (errors[-1] / errors[0]) ** (1 / 3)
    assert f"leaves about {left:.0f} % of the error" in told
    assert 25 < left < 34
