"""The lesson on pen lifts: what its texts say of the two thresholds is true of the recording."""

import numpy as np
import pytest

import dmp_teach as teach

PUPILS = [None, "w01", "w07", "w10", "w22"]
LOWEST = {"theta": 5, "sigma": 0.5}


@pytest.fixture(params=PUPILS)
def lesson(request):
    return teach.lesson("06", pupil=request.param)


def solved_alone(lesson, name):
    """The values of one threshold that meet the challenge while the other is at the bottom."""
    knob = lesson.knobs[name]
    values = np.arange(knob.low, knob.high + knob.step / 2, knob.step).tolist()
    return [each for each in values if lesson.check(LOWEST | {name: each}).done]


def test_neither_threshold_is_enough_alone(lesson):
    assert solved_alone(lesson, "theta") == []
    assert solved_alone(lesson, "sigma") == []


def test_the_lift_is_fast_and_high_and_the_others_are_one_of_both(lesson):
    pen = lesson.pen
    assert pen.fastest(pen.tilt) < 0.6 * pen.fastest(pen.lift)
    assert pen.highest(pen.tilt) > pen.highest(pen.lift)
    assert pen.fastest(pen.knock) > pen.fastest(pen.lift)
    assert pen.highest(pen.knock) < 0.5 * pen.highest(pen.lift)


def test_the_solution_has_room_on_both_sides(lesson):
    """The numbers hardly matter in the region between, as the notebook says."""
    for theta, sigma in ((-5, 0), (5, 0), (0, -1), (0, 1)):
        moved = {
            "theta": lesson.solution["theta"] + theta,
            "sigma": lesson.solution["sigma"] + sigma,
        }
        assert lesson.check(moved).done, moved


@pytest.mark.parametrize(
    ("answer", "cause"),
    [
        ({"theta": 200, "sigma": 8.0}, "At its fastest the lift rises"),
        ({"theta": 60, "sigma": 25.0}, "The lift is 16 mm high"),
        ({"theta": 80, "sigma": 1.5}, "Somebody knocked"),
        ({"theta": 20, "sigma": 10.0}, "The hand tilted"),
        ({"theta": 20, "sigma": 1.5}, "Both count as lifts"),
    ],
)
def test_the_cause_of_a_wrong_answer_is_named(answer, cause):
    verdict = teach.check("06", answer)
    assert not verdict.done
    assert cause in verdict.reason


def test_a_bet_on_the_true_places_is_told_so():
    lesson = teach.lesson("06")
    first, second = lesson.truth
    places = [first.position[-1].tolist(), second.position[0].tolist()]
    assert "0 mm from where it did, and land 0 mm" in lesson.tell_bet(places)


def test_the_paper_to_the_letter_fails_on_this_recording():
    """As the notebook's figure shows, and the rule of the panel does not."""
    lesson = teach.lesson("06")
    plain = lesson.recording.with_strokes(None)
    assert len(plain.strokes(0.075, 0.011)) == 2
    for rule in ("printed", "meant"):
        assert len(plain.strokes(0.075, 0.011, rule)) != 2
