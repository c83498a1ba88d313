"""Numbers as a child reads them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import dmp_teach
from dmp_teach.classroom.panels import messages, pad_messages
from dmp_teach.trajectory import Trajectory


@pytest.mark.parametrize(
    ("metres", "shown"),
    [
        (0.0, "under 0.1"),
        (0.00004, "under 0.1"),
        (0.00006, "0.1"),
        (0.0078, "7.8"),
        (0.00994, "9.9"),
        (0.00996, "10"),
        (0.024, "24"),
    ],
)
def test_a_length_is_shown_in_tenths_below_ten_millimetres_and_whole_above(metres, shown):
    assert messages.format_millimetres(metres) == shown


@pytest.mark.parametrize(
    ("metres", "thing"),
    [
        (0.00002, "less than a hair"),
        (0.0001, "a hair"),
        (0.001, "a pen line"),
        (0.0078, "a pencil"),
        (0.013, "a finger"),
        (0.09, "a hand"),
    ],
)
def test_a_length_is_compared_with_a_thing_of_that_size(metres, thing):
    assert thing in messages.name_comparable_width(metres)


@given(st.floats(0.00008, 0.24))
def test_a_thing_is_of_about_the_size_that_it_is_compared_with(metres):
    things = {
        "hair": 0.1, "two hairs": 0.2, "half the width of a pen line": 0.5, "of a pen line": 1.0,
        "two pen lines": 2.0, "half the width of a pencil": 3.5, "of a pencil": 7.0,
        "finger": 14.0, "two fingers": 28.0, "three fingers": 42.0, "four fingers": 56.0,
        "hand": 100.0, "two hands": 200.0,
    }  # fmt: skip
    said = messages.name_comparable_width(metres)
    size = things[max((words for words in things if words in said), key=len)]
    assert size / 1.6 < 1000 * metres < 1.6 * size


@given(st.floats(0, 10), st.floats(0, 10))
def test_a_longer_distance_is_never_compared_with_a_smaller_thing(a, b):
    order = ["less than", "hair", "pen line", "pencil", "finger", "hand"]
    rank = [
        next(i for i, word in enumerate(order) if word in messages.name_comparable_width(x))
        for x in sorted((a, b))
    ]
    assert rank[0] <= rank[1]


@given(st.floats(1e-6, 0.1), st.integers(1, 80), st.floats(0.2, 40))
def test_every_fit_has_a_number_a_sentence_and_something_to_try(error, n, width):
    message = messages.describe_fit(error, n, width)
    assert message["number"]
    assert message["strong"].endswith(".")
    assert message["after"].strip().endswith(".")


def test_a_moved_goal_is_judged_by_where_the_pen_stops():
    message = messages.describe_moved_goal(moved=0.07, miss=0.0031, error=0.0004, stroke=1)
    assert message["number"] == "3.1"
    assert "goal of stroke 2" in message["text"]
    assert "7.0 cm" in message["text"]
    assert "0.4 mm" in message["after"]


def test_the_largest_gap_names_the_stroke_and_the_place():
    t = np.linspace(0, 1, 11)
    straight = Trajectory(t, np.zeros((11, 2)))
    bent = Trajectory(t, np.where(np.arange(11)[:, None] == 9, 0.01, 0.0) * np.ones(2))
    assert (
        messages.describe_largest_gap((straight, straight), (straight, bent))
        == "most near the end of stroke 2"
    )
    assert messages.describe_largest_gap((straight,), (bent,)) == "most near its end"


def test_a_try_is_a_little_further_away_only_if_it_is():
    for now, before, said in (
        (0.012, 0.010, "A little further away this time."),
        (0.022, 0.00003, "Further away this time."),
        (0.016, 0.010, "Further away this time."),
        (0.002, 0.00003, "A little further away this time."),
        (0.00004, 0.00001, "As near as the try before."),
        (0.005, 0.010, "Nearer than the try before."),
    ):
        assert pad_messages.compare_attempts(now, before) == said


@pytest.mark.parametrize("character", ["a", "D", "k"])
def test_no_try_is_called_nearer_than_its_number_is(character):
    model = dmp_teach.recording_of(character)
    places = np.concatenate([stroke.position for stroke in model.strokes()])
    size = np.ptp(places, axis=0).max()
    rank = ["far", "not far", "close", "the same"]
    found = []
    for times in (1.0, 1.1, 1.3, 1.6, 2.0, 2.5, 3.0):
        tried = [Trajectory(stroke.t, times * stroke.position) for stroke in model.strokes()]
        found.append(rank.index(pad_messages.rate_attempt(dmp_teach.score(tried, model), size)))
    assert found == sorted(found, reverse=True)
    assert found[0] == 3
    assert found[-1] == 0
    mirrored = [Trajectory(stroke.t, stroke.position * [-1, 1]) for stroke in model.strokes()]
    assert pad_messages.rate_attempt(dmp_teach.score(mirrored, model), size) == "far", (
        "whatever its number"
    )
