"""Writers who differ are told apart, one person is not, and made letters stay their writer's."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError, SettingError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.studies.authorship.answers import Answers, permutation_luck
from dmp_teach.studies.authorship.made import attribute_made_letters, ink_directions, question
from dmp_teach.studies.authorship.real import (
    BY_MOVEMENT,
    BY_SHAPE,
    BY_TAKES,
    classify_writers,
    distinct_takes,
    movement_features,
    shape_features,
)
from dmp_teach.studies.inputs import Written
from dmp_teach.trajectory import Trajectory
from tests.recordings import RECORDINGS, needs_recordings
from tests.studies.pupils import Pupil

FOUR = (
    "DMP*, less the mean",
    "DMP*, varied, less the mean",
    "DMP*, as drawn",
    "DMP*, varied, as drawn",
)


@pytest.fixture(scope="module")
def class_of_eight():
    """Four letters by each of eight writers, the a three times and the D twice."""
    pupils = [Pupil(seed) for seed in range(8)]
    return [p.writes(character) for p in pupils for character in "aDne"] + [
        p.writes(*take) for p in pupils for take in (("a", 1), ("a", 2), ("D", 1))
    ]


@pytest.fixture(scope="module")
def one_person():
    """Three takes of two letters under each of six names, all by the same hand."""
    return [
        Pupil(5).writes(character, 10 * name + take, f"p{name}")
        for name in range(6)
        for character in "aD"
        for take in range(3)
    ]


@pytest.fixture(scope="module")
def made(class_of_eight):
    return attribute_made_letters(class_of_eight, 4)


def test_writers_are_told_apart_on_real_letters(class_of_eight):
    found = classify_writers(class_of_eight)
    takes = found[BY_TAKES]
    assert takes.right[1] == 8 * 5
    assert takes.chance == pytest.approx((24 * 2 / 23 + 16 / 15) / 40)
    assert takes.rate >= 0.6
    assert found[BY_SHAPE].right[1] == found[BY_MOVEMENT].right[1] == 8 * 4
    for each in found:
        assert each.luck <= 0.01
        assert each.interval[0] > each.chance


def test_one_person_under_several_names_is_not_told_apart(one_person):
    for each in [*classify_writers(one_person), *attribute_made_letters(one_person, 3)]:
        assert each.luck > 0.05, each.question
        assert each.rate <= each.chance + 0.2, each.question
        assert each.interval[0] < each.chance, each.question


def test_made_letters_are_given_to_their_writer(made):
    for words in (*FOUR[:2], "similarity, less the mean"):
        assert made[words].rate > 3 * made[words].chance
        assert made[words].luck <= 0.05


def test_the_original_form_loses_the_style(made):
    """So the question can be answered wrongly, most of all where ends vary to both sides."""
    star, original = (made[question(way, True, True)] for way in ("DMP*", "original"))
    assert original.rate < star.rate


def test_a_stroke_is_never_its_own_neighbour():
    pupils = [Pupil(seed) for seed in range(4)]
    once = [each.writes("D") for each in pupils]
    strange = [
        each.writes("D", 1, pupils[k - 1].name) for k, each in enumerate(pupils)
    ]  # somebody else's hand
    assert attribute_made_letters(once, 1).borrowed
    found = attribute_made_letters(once + strange, 1)[FOUR[0]]
    assert found.rate < 0.3
    assert found.chance == pytest.approx(1 / 7)


def test_a_take_that_was_exported_twice_is_one_take(class_of_eight):
    first = class_of_eight[0]
    finer = tuple(
        Trajectory(
            t := np.linspace(s.t[0], s.t[-1], 500),
            np.column_stack([np.interp(t, s.t, x) for x in s.position.T]),
        )
        for s in first.strokes
    )
    again = Written(first.character, first.writer, finer)
    assert distinct_takes([first, again, class_of_eight[32]]) == [first, class_of_eight[32]]
    ones = [Pupil(seed).writes("a") for seed in range(3)]
    assert not classify_writers([*ones, Written("a", "w0", finer)])[BY_TAKES].items


def test_whoever_lacks_a_letter_is_left_out_and_nothing_is_asked_of_one_letter():
    pupils = [Pupil(seed) for seed in range(3)]
    found = classify_writers(
        [each.writes("a") for each in pupils] + [pupils[0].writes("D"), pupils[1].writes("D")]
    )
    assert set(found[BY_SHAPE].writers) == {"w0", "w1"}
    (nothing, *_) = classify_writers([each.writes("a") for each in pupils])
    assert (nothing.right, nothing.luck) == ((0, 0), 1.0)
    assert np.isnan([nothing.rate, *nothing.interval, nothing.chance]).all()


def test_two_writers_prove_nothing():
    found = attribute_made_letters(variations=1)
    assert found.borrowed is False
    assert found[FOUR[0]].rate == 1
    assert found[FOUR[0]].luck > 0.3


def test_where_nobody_else_could_be_named_our_own_letters_are_taken():
    assert attribute_made_letters([recording_of("a")], 1).borrowed
    assert attribute_made_letters([recording_of("D"), recording_of("a", "slanted")], 1).borrowed
    pupils = [Pupil(seed) for seed in range(3)]
    found = attribute_made_letters(
        [each.writes("D", take) for each in pupils for take in (0, 1)] + [pupils[0].writes("B")], 1
    )
    assert not found.borrowed
    assert found[FOUR[0]].right[1] == 3 * 2 * 2  # the bowl of the one B is not asked about


def test_what_the_original_form_cannot_learn_counts_as_wrong():
    """A bowl that ends as high as it began has no way from start to goal to be scaled by."""
    letters = [Pupil(seed).writes("D", take) for seed in range(3) for take in (0, 1)]
    bar, bowl = letters[0].strokes
    path = bowl.position.copy()
    path[:, 0] += np.linspace(0, path[0, 0] - path[-1, 0], len(path))
    letters[0] = Written("D", "w0", (bar, Trajectory(bowl.t, path)))
    found = attribute_made_letters(letters, 1)
    assert ("w0", None) in found["original, less the mean"].items
    assert ("w0", None) not in found["DMP*, less the mean"].items
    assert found["original, less the mean"].confusion.sum(axis=1).min() == 0.5


def test_an_executor_changes_nothing_and_progress_is_told(class_of_eight):
    told = []
    some = [each for each in class_of_eight if each.writer < "w3"]
    with ThreadPoolExecutor(2) as threads:
        found = attribute_made_letters(
            some, 2, executor=threads, progress=lambda *now: told.append(now)
        )
        real = classify_writers(some, executor=threads)
    assert found == attribute_made_letters(some, 2)
    assert real.rows()[1] == classify_writers(some).rows()[1]
    assert told[0] == (0, 9)
    assert told[-1] == (9, 9)


def test_variations_must_be_a_number():
    with pytest.raises(
        SettingError, match="variations is 0, but must be a whole number of at least 1"
    ):
        attribute_made_letters(variations=0)


def test_a_question_that_was_not_asked_is_refused_and_all_are_rows(made):
    with pytest.raises(
        SettingError, match="'who' was not asked; asked was: DMP\\*, less the mean, "
    ):
        _ = made["who"]
    assert len(made.rows()) == 12
    assert set(FOUR) <= {row["question"] for row in made.rows()}
    assert "by luck" in str(made)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.2, 5.0), st.floats(-1, 1), st.floats(-1, 1))
def test_place_and_size_do_not_count(scale, x, y):
    strokes = recording_of("D").strokes()
    moved = [Trajectory(s.t, scale * s.position + [x, y]) for s in strokes]
    np.testing.assert_allclose(shape_features(moved), shape_features(strokes), atol=1e-6)
    np.testing.assert_allclose(
        ink_directions(moved[1].position), ink_directions(strokes[1].position), atol=1e-6
    )
    np.testing.assert_allclose(
        movement_features(moved) - movement_features(strokes),
        [0, np.log(scale), np.log(scale), 0],
        atol=1e-5,
    )


@settings(max_examples=20, deadline=None)
@given(st.floats(0.1, 0.5))
def test_lean_counts(lean):
    strokes = recording_of("D").strokes()
    leaned = [Trajectory(s.t, s.position @ [[1, 0], [lean, 1]]) for s in strokes]
    apart = shape_features(leaned) - shape_features(strokes)
    assert apart[-2] == pytest.approx(lean, rel=0.15)  # the points lie elsewhere along longer ink
    assert (
        np.linalg.norm(ink_directions(leaned[1].position) - ink_directions(strokes[1].position))
        > 0.3 * lean
    )


def test_a_bowl_drawn_from_its_foot_is_the_same_bowl():
    bowl = recording_of("D").strokes()[1].position
    np.testing.assert_allclose(ink_directions(bowl[::-1]), ink_directions(bowl), atol=1e-9)


def test_every_writer_counts_alike_and_as_one():
    items = (*[("a", "a")] * 98, ("a", "b"), ("a", None), ("b", "a"))
    found = Answers("?", items, 0.5, 1.0)
    assert found.right == (98, 101)
    assert found.rate == pytest.approx(0.49)
    low, high = found.interval
    assert low < 0.15
    assert high > 0.85
    np.testing.assert_allclose(found.confusion, [[0.98, 0.01], [1.0, 0.0]])
    ten = Answers("?", tuple((f"w{k}", f"w{k}") for k in range(10)), 0.1, 1.0)
    assert ten.interval == (
        pytest.approx(1 / (1 + 1.959964**2 / 10)),
        pytest.approx(1.0),
    )  # Wilson 1927, all right


def test_luck_is_the_share_of_shuffles_that_do_as_well():
    names = np.arange(3)
    luck = permutation_luck(lambda order: int((names[order] == names).sum()), [0, 0, 0])
    assert luck == pytest.approx(1 / 6, abs=0.04)
    assert permutation_luck(lambda order: 1, [0, 1, 2]) == 1.0
    assert permutation_luck(lambda order: 0, []) == 1.0


@pytest.mark.parametrize("study", [classify_writers, attribute_made_letters])
def test_ink_that_is_not_flat_or_a_dot_is_refused_by_its_name(study):
    flat = Pupil(0).writes("D")
    high = tuple(Trajectory(s.t, np.column_stack([s.position, 0 * s.t])) for s in flat.strokes)
    with pytest.raises(LetterError, match="Stroke 0 of D w1 has 3 dimensions, but ink has 2"):
        study([flat, Written("D", "w1", high)])
    with pytest.raises(LetterError, match="i w1 is a dot"):
        study([flat, Written("i", "w1", (Trajectory([0, 0.1, 0.2], np.zeros((3, 2))),))])


@needs_recordings
def test_writers_of_one_take_of_one_letter_cannot_be_asked():
    assert attribute_made_letters([path for path in RECORDINGS if path.name[0] == "D"], 1).borrowed
