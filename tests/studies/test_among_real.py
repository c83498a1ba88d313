"""A P made of a D looks like its writer's own Ps, unless the primitive spoils it."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from dmp_teach.errors import LetterError
from dmp_teach.studies.authorship.made_among_real import attribute_among_real
from dmp_teach.studies.inputs import Written
from dmp_teach.trajectory import Trajectory
from tests.studies.pupils import Pupil

STAR, SIMILAR, ORIGINAL, ONLY_MOVED = (
    f"{way}, among real ones" for way in ("DMP*", "similarity", "original", "only moved")
)


@pytest.fixture(scope="module")
def class_of_ten():
    """Letters of which P, R, B, b, d, p, q and m are made, and these, by each of ten writers."""
    return [Pupil(seed).writes(character) for seed in range(10) for character in "DPRBlonmbdpq"]


@pytest.fixture(scope="module")
def found(class_of_ten):
    return attribute_among_real(class_of_ten)


def test_a_made_letter_is_nearest_to_what_its_writer_wrote(found):
    assert found[STAR].right[1] == 10 * 3
    assert found[ONLY_MOVED].right[1] == 10 * 6
    assert found[STAR].chance == pytest.approx(0.1)
    for words in (STAR, ONLY_MOVED):
        assert found[words].rate >= 2.5 * found[words].chance
        assert found[words].luck <= 0.01
    assert found[SIMILAR].right[1] == 10 * 3


def test_it_can_be_answered_wrongly(found, class_of_ten):
    assert found[ORIGINAL].rate < found[STAR].rate
    other = {f"w{k}": f"w{(k + 1) % 10}" for k in range(10)}
    mixed = [
        each
        if each.character in "Dlo"
        else Written(each.character, other[each.writer], each.strokes)
        for each in class_of_ten
    ]
    assert attribute_among_real(mixed)[ONLY_MOVED].rate < found[ONLY_MOVED].rate / 2


def test_one_person_under_several_names_is_not_told_apart():
    letters = [
        Pupil(5).writes(c, 10 * name + take, f"p{name}")
        for name in range(6)
        for c in "DP"
        for take in range(2)
    ]
    answers = attribute_among_real(letters)[STAR]
    assert answers.luck > 0.05
    assert answers.interval[0] < answers.chance


def test_whoever_wrote_no_such_letter_is_not_asked_about():
    pupils = [Pupil(seed) for seed in range(3)]
    letters = [each.writes("D") for each in pupils] + [each.writes("P") for each in pupils[:2]]
    answers = attribute_among_real(letters)[STAR]
    assert {writer for writer, _ in answers.items} == {"w0", "w1"}
    assert answers.chance == pytest.approx(0.5)


def test_a_letter_that_cannot_be_taken_apart_is_left_out():
    pupils = [Pupil(seed) for seed in range(3)]
    ring = Pupil(0).writes("O")
    letters = [each.writes("P") for each in pupils] + [each.writes("D") for each in pupils[:2]]
    answers = attribute_among_real([*letters, Written("D", "w2", ring.strokes)])[STAR]
    assert {writer for writer, _ in answers.items} == {"w0", "w1"}


def test_our_own_letters_are_taken_where_nothing_can_be_asked():
    ours = attribute_among_real()
    assert not ours.borrowed
    assert (ours[STAR].right[1], ours[ONLY_MOVED].right[1]) == (2 * 3, 2 * 26)
    assert attribute_among_real([Pupil(0).writes("D")]).borrowed


def test_an_executor_changes_nothing_and_progress_is_told(class_of_ten, found):
    told = []
    with ThreadPoolExecutor(2) as threads:
        assert (
            attribute_among_real(
                class_of_ten, executor=threads, progress=lambda *now: told.append(now)
            )
            == found
        )
    assert told[0] == (0, 9)
    assert told[-1] == (9, 9)


def test_ink_that_is_not_flat_is_refused_by_its_name():
    flat = Pupil(0).writes("D")
    high = tuple(Trajectory(s.t, np.column_stack([s.position, 0 * s.t])) for s in flat.strokes)
    with pytest.raises(LetterError, match="Stroke 0 of D w1 has 3 dimensions, but ink has 2"):
        attribute_among_real([flat, Written("D", "w1", high)])
