"""Lesson 10: its verdicts are what writers say; real writers take the place of made ones."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import binomtest

import dmp_teach as teach
from dmp_teach.formats import write_recording
from dmp_teach.lessons.many_writers import FOLDER_VARIABLE, find_writers, make_writers
from dmp_teach.lessons.tested_claims import (
    COUNTER_TEST,
    ONE_SETTING,
    PAPERS_WAY,
    STANDS,
    TOO_FEW,
    UNFAIR,
    WriterRatios,
    find_truth,
    measure,
    tell_ratios,
)

NOTEBOOK = Path(__file__).parents[2] / "notebooks" / "10_be_a_scientist.ipynb"


@pytest.fixture(autouse=True)
def made_writers(monkeypatch):
    """Verdicts below are those of our own hands, whatever recordings lie here."""
    monkeypatch.delenv(FOLDER_VARIABLE, raising=False)


@pytest.mark.parametrize(("number", "for_it"), [(1, 1), (3, 3), (5, 5), (8, 2), (12, 7), (12, 10)])
def test_luck_is_what_a_coin_does(number, for_it):
    measured = WriterRatios("gaps", np.array([9.0] * for_it + [0.5] * (number - for_it)), ())
    most = max(for_it, number - for_it)
    luck = binomtest(most, number, 0.5, alternative="greater").pvalue
    assert measured.luck == pytest.approx(luck)
    wanted = None if luck > 0.05 else 2 * for_it > number
    assert measured.verdict is wanted


@pytest.mark.parametrize("letter", "aS")
def test_what_the_text_says_of_the_claims_is_so(letter):
    writers = make_writers(letter)
    truths = {"rule": UNFAIR, "level": ONE_SETTING, "cut": ONE_SETTING, "gaps": STANDS}
    for claim, truth in (truths | {"goal": STANDS}).items():
        assert find_truth(claim, 12, writers) == truth
        assert find_truth(claim, 4, writers) == TOO_FEW
    assert measure("rule", PAPERS_WAY, writers).ratios.min() > 8
    assert 5 < np.median(measure("level", COUNTER_TEST, writers).ratios) < 12
    assert np.abs(measure("rule", COUNTER_TEST, writers).ratios - 1).max() < 1e-6


def test_what_the_notebook_says_of_one_letter_is_so():
    ratios = measure("rule", PAPERS_WAY, make_writers("a")).ratios
    spread = r"\"{:.0f} times\" hides that one writer had {:.0f} and another {:.0f}"
    words = NOTEBOOK.read_text(encoding="utf-8")
    assert spread.format(np.median(ratios), ratios.min(), ratios.max()) in words


def test_one_asks_as_many_writers_as_there_are_for_a_claim():
    panel = teach.lesson("10").panel()
    panel.go("try")
    few = str(1 + panel.lesson.claims.index(panel.lesson.few))
    panel.values = panel.values | {"claim": few, "how": COUNTER_TEST, "writers": 12}
    assert panel.picture["highs"] == {"writers": panel.lesson.numbers[panel.lesson.few]}
    assert 2 in panel.progress["done"]
    panel.values = panel.values | {"claim": panel.lesson.start["claim"]}
    assert panel.picture["highs"] == {"writers": 12}
    panel.forget()


def test_hands_that_we_make_differ():
    shapes = [stroke.position / np.ptp(stroke.position) for stroke in make_writers("e").strokes]
    apart = [np.abs(shapes[0] - each).max() for each in shapes[2::2]]
    assert min(apart) > 0.02


def write_letters(folder, number):
    recording = teach.recording_of("e")
    for n in range(number):
        write_recording(replace(recording, writer=f"w{n:02d}"), folder / f"e_w{n:02d}.json")
    (folder / "notes.txt").write_text("no recording")


@pytest.mark.parametrize(("number", "letter", "are_real"), [(7, "e", True), (5, "a", False)])
def test_real_writers_of_a_folder_are_asked_where_there_are_enough(
    number, letter, are_real, tmp_path, monkeypatch
):
    write_letters(tmp_path, number)
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path))
    writers = find_writers("a")
    assert (writers.character, writers.are_real) == (letter, are_real)
    lesson = teach.lesson("10")
    assert len(lesson.writers.strokes) == (number if are_real else 12)
    assert lesson.check({name: lesson.solution[name] for name in lesson.settable}).done


@pytest.mark.parametrize(
    ("verdicts", "words"),
    [
        (
            "holds one_setting too_few",
            r"12 are for it in the paper’s way \(\d\d times\) and 0 in the",
        ),
        ("one_setting one_setting too_few", "spring and clock that were changed, too; the rule"),
        ("unfair unfair too_few", r"0\.\d\d times in one setting and [\d.]+ times in the other"),
        ("unfair one_setting holds", r"3 writers only\. 3 coins fall the same way once in 8"),
        ("unfair open too_few", "Not judged yet: 2. Verdicts that stand so far: 2."),
    ],
)
def test_a_verdict_that_does_not_stand_is_told_by_its_numbers(verdicts, words):
    answer = {f"verdict_{n}": said for n, said in enumerate(verdicts.split(), start=1)}
    assert re.search(words, teach.check("10", answer).reason)


def test_the_praise_counts_each_verdict_and_names_how_few_writers_there_were():
    lesson = teach.lesson("10")
    praise = lesson.check({name: lesson.solution[name] for name in lesson.settable}).reason
    assert "holds 0, unfair 1, one setting 1, too few 1 (n = 3)" in praise


def test_where_both_rules_write_the_same_line_nothing_is_counted():
    said = tell_ratios(measure("rule", COUNTER_TEST, make_writers("a")), COUNTER_TEST, False)
    assert (said["number"], "nothing to count" in said["strong"]) == ("1.00", True)
