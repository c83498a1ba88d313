"""A robot that is taught comes nearer, forgets, is taught again, and replays to the bit."""

import json
from dataclasses import replace

import numpy as np
import pytest

from dmp_teach.classroom import PupilTraits, RobotPupil, TeachingSession, known_pupils
from dmp_teach.classroom.teaching.faults import SHAPE_FAULTS, WAY_FAULTS
from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.files import ASSETS
from dmp_teach.ink import characters, recording_of
from dmp_teach.scoring import score
from dmp_teach.trajectory import Trajectory

TURNS = 6
FAULTY = {
    **{name: PupilTraits(name, {name: fault.usual}) for name, fault in SHAPE_FAULTS.items()},
    **{name: PupilTraits(name, {name: 1.0}) for name in WAY_FAULTS},
    **{name: PupilTraits.load(name) for name in known_pupils()},
}


def teach(letter, traits):
    """What comes of six turns: how near it began and ended, when it was good, what was forgotten.

    Returns the distances [m], the first good turn or None, and the number of forgotten letters that
    were noticed, and of those that were good again.
    """
    session = TeachingSession.by_the_book(traits, letter, TURNS)
    far, good = (session.far[0], session.far[-1]), session.good
    lapsed = [
        turn
        for turn, (pupil, was_good) in enumerate(zip(session.met[1:-1], good, strict=False))
        if pupil.memory.lost and was_good and not pupil.is_good()
    ]
    again = [any(good[turn + 1 :]) for turn in lapsed]
    return far, good.index(True) + 1 if True in good else None, again


@pytest.mark.slow
@pytest.mark.parametrize("name", FAULTY)
def test_every_pupil_learns_letters_and_every_letter_is_learned(name):
    """All together meet each of the 62 plain letters once: none goes farther, all become good."""
    letters = characters()[:62][list(FAULTY).index(name) :: len(FAULTY)]
    found = [teach(letter, FAULTY[name]) for letter in letters]
    assert [far for far, *_ in found if far[1] > far[0] + 1e-4] == []
    assert np.mean([good is not None for _, good, _ in found]) >= 0.95
    assert all(each for *_, lapses in found for each in lapses)


def test_a_forgotten_letter_is_bad_again_and_taught_again():
    session = TeachingSession.by_the_book(PupilTraits.load("Mia"), "b", 4, answers=False)
    mixed = [pupil.memory.muddles for pupil in session.met]
    assert mixed == [("mixed up",), (), (), ("mixed up",), ()]
    assert [pupil.is_good() for pupil in session.met] == [False, True, True, False, True]
    assert "forgotten" in session.met[3].says


@pytest.mark.parametrize("name", ["lean", "rise", "size", "width", "mirrored", "reversed"])
def test_a_fault_is_what_the_score_calls_it(name):
    pupil = RobotPupil.load(FAULTY[name], "b")
    assert pupil.score().faults[0].name == name
    # And so does the child's own weakest row become a pupil.
    assert PupilTraits.like(pupil.score()).faults.keys() == {name}


def test_a_step_of_learning_is_a_step_of_the_weights():
    pupil = RobotPupil.load(PupilTraits("Test", {"lean": 25.0}, pace=0.4), "b")
    [before] = pupil.hand
    [after] = pupil.learn(recording_of("b")).hand
    [wanted] = RobotPupil.load(PupilTraits("Test"), "b").hand
    before, after, wanted = (each.rollout().position for each in (before, after, wanted))
    # The place of the whole does not count.
    off = (after - wanted) - 0.6 * (before - wanted)
    np.testing.assert_allclose(off, np.broadcast_to(off[0], off.shape), atol=2e-4)


def test_the_robot_follows_what_is_shown_not_the_book():
    """A child's own H, its strokes in another order and number, becomes the robot's."""
    left, right, bar = recording_of("H").strokes()
    order = (bar, left, right)
    own = [Trajectory(each.t - each.t[0] + k, each.position) for k, each in enumerate(order)]
    pupil = RobotPupil.load(PupilTraits("Test", {"width": 1.5}, pace=0.6), "H")
    for _ in range(3):
        pupil = pupil.learn(own)
    found = score(pupil.strokes, own)
    assert found.matching.order == (0, 1, 2)
    assert not found.matching.reversed
    assert pupil.is_good(own)


def test_a_right_answer_saves_a_third_of_what_is_forgotten_and_another_one_makes_it_doubt():
    asked = RobotPupil.load(FAULTY["lean"], "b").learn(recording_of("b"))
    assert str(asked.question).endswith("?")
    right, wrong = (asked.answer(asked.question.is_so == kind) for kind in (True, False))
    assert "not sure" in wrong.says
    assert (right.question, right.answer(True)) == (None, right)
    traits = PupilTraits("Test", forgetting=0.6)
    turn = next(turn for turn in range(1, 4) if traits.forgets_after(turn))
    memory = replace(right.memory, traits=traits, turn=turn)
    assert memory.forget().lost == pytest.approx(0.4)
    assert memory.answer(False).forget().lost == 0.6
    assert memory.forget().forget() == memory.forget()


def test_a_session_is_a_log_without_identity_that_replays_to_the_bit():
    session = TeachingSession.by_the_book(PupilTraits.load("Zoe"), "k", 3)
    log = json.dumps(session.as_json())
    again = TeachingSession.of(json.loads(log))
    assert json.dumps(again.as_json()) == log
    for one, other in zip(session.met, again.met, strict=True):
        assert (one.says, one.memory) == (other.says, other.memory)
        for a, b in zip(one.strokes, other.strokes, strict=True):
            np.testing.assert_array_equal(a.position, b.position)
    assert session.as_json().keys() == {"format", "version", "letter", "pupil", "turns"}


def test_five_pupils_come_with_it_in_at_most_twenty_lines_and_are_kept(tmp_path):
    files = list((ASSETS / "pupils").glob("*.json"))
    assert len(files) == len(known_pupils()) == 5
    for file in files:
        assert len(file.read_text(encoding="utf-8").splitlines()) <= 20
        traits = PupilTraits.load(file)
        assert PupilTraits.load(traits.save(tmp_path / file.name)) == traits


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"faults": {"lazy": 1}}, "lazy"),
        ({"faults": {"size": 9}}, "size"),
        ({"mixes_up": ["bdp"]}, "mixes_up"),
        ({"mixes_up": None}, "mixes_up"),
        ({"pace": 0}, "pace"),
        ({"forgetting": "much"}, "forgetting"),
        ({"seed": -1}, "seed"),
        ({"name": ""}, "name"),
    ],
)
def test_a_pupil_that_cannot_be_is_refused_by_the_field(tmp_path, change, word):
    path = tmp_path / "pupil.json"
    path.write_text(json.dumps(PupilTraits.load("Mia").as_json() | change), encoding="utf-8")
    with pytest.raises(RecordingError, match=word):
        PupilTraits.load(path)


@pytest.fixture(scope="module")
def log():
    return TeachingSession.by_the_book(PupilTraits.load("Mia"), "b", 1).as_json()


STROKE = [[0, 0, 0], [500, 1000, 1000]]


@pytest.mark.parametrize(
    "change",
    [
        {"turns": [1]},
        {"version": 9},
        {"teacher": "Anna"},
        {"pupil": PupilTraits.load("Mia").as_json() | {"teacher": "Anna"}},
        {"pupil": {}},
        *(
            {"turns": [{"strokes": strokes, "answer": None}]}
            for strokes in (
                [[[0, 0, 0], [10**12, 1000, 1000]]],
                [[[0, 0, 0], [500, 10**300, 1000]]],
                [[[0, 0, 0], [500, 2**60, 1000]]],
                [[[0, 0, 0], [500, 0.5, 1000]]],
                [[["0", "0", "0"], ["500", "1000", "1000"]]],
                [STROKE] * 200,
            )
        ),
        *({"turns": [{"strokes": [STROKE], "answer": answer}]} for answer in (1, 0.0, "no", [])),
        {"turns": [{"strokes": [STROKE], "answer": True, "teacher": "Anna"}]},
    ],
)
def test_what_is_no_log_is_refused(log, change):
    with pytest.raises(RecordingError, match="log"):
        TeachingSession.of(log | change)


@pytest.mark.parametrize("log", [None, {}, [], "log"])
def test_what_is_nothing_like_a_log_is_refused(log):
    with pytest.raises(RecordingError, match="log"):
        TeachingSession.of(log)


def test_a_session_begins_with_a_name_and_takes_yes_and_no_alone(log):
    assert TeachingSession.begin("Mia", "b").as_json() == log | {"turns": []}
    session = TeachingSession.of(log)
    for odd in (None, "no", float("nan"), 1):
        with pytest.raises(RecordingError, match="answer"):
            session.answer(odd)
    assert json.dumps(session.answer(np.True_).as_json())


def test_a_pupil_is_a_key_and_without_a_letter_is_none():
    assert len({PupilTraits("X", {"lean": 9.0}), PupilTraits("X", {"lean": 9.0})}) == 1
    with pytest.raises(RecordingError, match="mixes_up"):
        PupilTraits("X", mixes_up=None)
    with pytest.raises(RecordingError, match="None"):
        RobotPupil.load("Mia", None)
    with pytest.raises(RecordingError, match="pupil"):
        PupilTraits.of({})


def test_nothing_is_learned_from_a_dot():
    with pytest.raises(LetterError, match="dot"):
        RobotPupil.load("Mia").learn([Trajectory([0.0, 0.1], [[0.0, 0.0], [0.0, 0.0]])])
