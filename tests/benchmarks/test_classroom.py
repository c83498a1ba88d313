"""The benchmark of a class measures every letter of every pupil, and no other."""

import json

import numpy as np
import pytest

import dmp_teach as teach
from tests.benchmarks.classroom import classroom, lines, taken, written


def test_a_class_is_measured_and_its_figures_are_plain():
    found = classroom((1, 2), "aDi")
    assert found["letters"] == 3
    assert set(found["seconds"]) == {"reading", "segmenting", "learning", "scoring"}
    assert all(len(each) == 2 and min(each) > 0 for each in found["seconds"].values())
    whole = sum(each[1] for each in found["seconds"].values())
    assert found["seconds_a_letter"][1] == pytest.approx(whole / 6)
    assert 1e4 < found["bytes_of_a_pupil"] < 1e7
    assert list(found["seconds_of_a_style"]) == [2]
    assert json.loads(json.dumps(found))["pupils"] == [1, 2]
    text = "\n".join(lines(found))
    assert "3 letters by each pupil" in text
    assert "for 2 pupils" in text


def test_one_pupil_has_no_growth_and_no_style():
    found = classroom((1,), "aDi")
    assert (found["exponent_of_a_letter"], found["seconds_of_a_style"]) == (0.0, {})
    assert "style" not in "\n".join(lines(found))


def test_every_step_does_its_work(tmp_path):
    models = {character: teach.recording_of(character, "round").strokes() for character in "aDi"}
    files = written(tmp_path, 1, "aDi")
    _, kept = taken(files, models)
    assert [each.character for each in kept["reading"]] == ["a", "D", "i"]
    assert [each.given_strokes for each in kept["reading"]] == [None] * 3
    assert [len(each) for each in kept["segmenting"]] == [1, 2, 2]
    assert [len(each.strokes) for each in kept["learning"]] == [1, 2, 2]
    assert all(0.0001 < each.distance < 0.02 for each in kept["scoring"])


def test_pupils_differ_and_the_same_pupil_does_not(tmp_path):
    one, again, other = (
        teach.read_recording(written(tmp_path, pupil, "a")[0]) for pupil in (0, 0, 1)
    )
    np.testing.assert_array_equal(one.position, again.position)
    assert teach.letter_distance(one, other, upright=False) > 0.05
