"""Lesson 11: what its readings cost is so, and three of them matter."""

from itertools import combinations
from pathlib import Path

import pytest

import dmp_teach as teach
from dmp_teach.dmp import Settings
from dmp_teach.lessons import paper_readings as readings
from dmp_teach.lessons.paper_readings import error_by, error_left, facts_of, find_idlest, mend
from dmp_teach.lessons.reading_a_paper import MISREAD_LETTERS, tell_way

NOTEBOOK = Path(__file__).parents[2] / "notebooks" / "11_reading_a_paper.ipynb"
# What the notebook says before how far off a letter is with one place left as printed.
WHAT_IT_COSTS = {
    "stand": "in the middles of N equal parts",
    "step": "A push that comes one step late",
    "spring": "The spring has no number",
    "clock": "The clock is called linear and slows down",
}


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
    words = NOTEBOOK.read_text(encoding="utf-8")
    for name, said in WHAT_IT_COSTS.items():
        assert f"{said}: {tell_way(error_left('a', name))}" in words
    assert f"*a* is {tell_way(error_by('a', readings.AS_FIXED))} off" in words
    assert 0.9 * error_left("a", "clock") < error_by("a", readings.AS_FIXED), "as if mended"
    assert error_by("a", mend("spring")) > 2 * error_by("a", readings.AS_PRINTED)
    assert set(readings.find_best("n", 3)) == {"push", "ends", "clock"}


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ((), "The a is {error} off. Something drives the pen {k} times too hard."),
        (("push",), "all {n} bumps are still awake, and learn averages."),
        (("push", "ends"), "At {gaps} moments no bump is awake"),
        (("push", "ends", "clock"), "“clock” does least: as printed {back}. At {gaps} moments"),
        (("push", "ends", "stand", "step"), "{error} off, with 4 changes. “step” does least"),
        (("ends", "clock", "spring"), "“spring” does harm: as printed {back}"),
    ],
)
def test_what_spoils_the_letter_most_is_told_by_numbers_and_not_named(names, words):
    mended = mend(*names)
    facts = facts_of("a", mended) | {"error": tell_way(error_by("a", mended))}
    if names:
        facts["back"] = tell_way(find_idlest("a", mended)[1])
    reason = teach.check("11", mended).reason
    assert words.format(**facts) in reason
    missing = set(readings.find_best("a", 3)) - set(names)
    assert not any(f"“{readings.names()[name]}”" in reason for name in missing)


def lessons():
    """A lesson with every letter."""
    return [teach.lesson("11"), *(teach.lesson("11", pupil=f"w{n:02d}") for n in range(60))]
