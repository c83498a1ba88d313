"""Lesson 11: what its readings cost is so, and three of them matter."""

from itertools import combinations

import pytest

import dmp_teach as teach
from dmp_teach.dmp import Settings
from dmp_teach.lessons import paper_readings as readings
from dmp_teach.lessons.paper_readings import error_by, error_left, mend
from dmp_teach.lessons.reading_a_paper import MISREAD_LETTERS


@pytest.mark.parametrize(
    ("answer", "preset"),
    [
        (mend("push"), Settings.as_printed()),
        (readings.AS_CODED, Settings.as_coded()),
        (readings.AS_FIXED, Settings.as_fixed()),
    ],
)
def test_the_three_readings_are_settings_of_the_switches(answer, preset):
    assert readings.settings_of(answer) == preset


@pytest.mark.parametrize("letter", MISREAD_LETTERS)
def test_three_places_and_no_two_bring_a_letter_within_the_limit(letter):
    lesson = next(each for each in lessons() if each.letter == letter)
    two = min(error_by(letter, mend(*names)) for names in combinations(readings.FAULTY, 2))
    assert error_by(letter, lesson.solution) <= lesson.limit < two


def test_what_the_text_says_each_place_costs_is_so():
    assert error_left("a", "push") > 10_000
    assert 9 < error_left("a", "ends") < 20
    costs = {"stand": 1.55, "step": 0.94, "spring": 0.54, "clock": 0.23}
    for name, cost in costs.items():
        assert error_left("a", name) == pytest.approx(cost, abs=0.005)
    assert error_by("a", readings.AS_FIXED) == pytest.approx(0.23, abs=0.005)
    assert error_by("a", mend("spring")) > 2 * error_by("a", readings.AS_PRINTED)
    assert set(readings.find_best("m", 3)) == {"push", "ends", "clock"}


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ((), "The a is 5.6 m off. Something drives the pen 156 times too hard."),
        (("push",), "all 33 bumps are still awake, and learn averages."),
        (("push", "ends"), "At 32 moments no bump is awake"),
        (("push", "ends", "clock"), "“clock” does least: as printed 1.7 mm. At 32 moments"),
        (("push", "ends", "stand", "step"), "0.54 mm off, with 4 changes. “step” does least"),
        (("ends", "clock", "spring"), "“spring” does harm: as printed 6.4 m"),
    ],
)
def test_what_spoils_the_letter_most_is_told_by_numbers_and_not_named(names, words):
    reason = teach.check("11", mend(*names)).reason
    assert words in reason
    missing = set(readings.find_best("a", 3)) - set(names)
    assert not any(f"“{readings.names()[name]}”" in reason for name in missing)


def lessons():
    """A lesson with every letter."""
    return [teach.lesson("11"), *(teach.lesson("11", pupil=f"w{n:02d}") for n in range(60))]
