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
        (readings.AS_PRINTED, Settings.as_printed()),
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
    assert 1 < error_left("a", "stand") < 2
    assert max(error_left("a", name) for name in ("clock", "spring", "step")) < 1
    assert error_by("a", mend("spring")) > 2 * error_by("a", readings.AS_PRINTED)
    assert set(readings.find_best("m", 3)) == {"push", "ends", "clock"}


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ((), "The a is 5.6 m off. The push is learned with the spring’s K in it"),
        (("push",), "all 33 bumps stay awake to the end, and learn averages. Mended: 1.6 mm"),
        (("push", "ends"), "from 0 to 1 leave 32 gaps"),
        (("push", "ends", "clock"), "“clock” does least: as printed 1.6 mm. 33 bumps of width"),
        (("push", "ends", "stand", "step"), "0.54 mm off, with 4 changes. “step” does least"),
        (("ends", "clock", "spring"), "“spring” does harm: as printed 6.4 m"),
    ],
)
def test_the_reading_that_costs_most_is_named_with_its_millimetres(names, words):
    assert words in teach.check("11", mend(*names)).reason


def lessons():
    """A lesson with every letter."""
    return [teach.lesson("11"), *(teach.lesson("11", pupil=f"w{n:02d}") for n in range(60))]
