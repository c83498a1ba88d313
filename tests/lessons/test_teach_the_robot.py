"""Lesson 09: what its pad teaches, and what its record says, is what the engine does."""

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.classroom import PupilTraits, forecast
from dmp_teach.errors import LetterError, RecordingError
from dmp_teach.lessons.teach_the_robot import TURNS, TeachTheRobot

PUPILS = [None, *(f"w{n:02d}" for n in range(30))]


@pytest.fixture
def panel():
    panel = teach.lesson("09").panel()
    panel.forget()
    panel.go("try")
    return panel


def write(panel, letter="b", size=1.0):
    """Write a letter of ours with a mouse."""
    for stroke in teach.recording_of(letter).strokes():
        pressure = np.full((len(stroke), 1), 0.5)
        panel.add_stroke(np.hstack([stroke.t[:, None], size * stroke.position, pressure])[::4])


def test_a_pupil_is_taught_asks_forgets_and_is_taught_again(panel):
    assert panel.message["number"] == "22"
    for turn in range(TURNS):
        write(panel)
        panel.show()
        assert panel.teaching["asks"]
        assert panel.message["strong"].endswith("?")
        panel.answer_question(False)
        assert not panel.teaching["asks"]
        assert (turn < 3) == (2 not in panel.progress["done"]), turn
    assert panel.progress["done"] == [0, 1, 2]
    far = np.array(panel.session.far)
    assert far[1] < far[0] / 4
    assert far[3] > far[2]
    # The log is that of the session, and names nobody.
    again = teach.TeachingSession.of(panel.session.as_json())
    assert again.far == panel.session.far


def test_what_is_forecast_is_what_is_taught_without_an_answer(panel):
    for _ in range(4):
        panel.show_book()
    expected = [far for _, far in forecast(panel.session.traits, "b", 4)]
    np.testing.assert_allclose(panel.session.far, expected, atol=6e-4)


def test_another_pupil_begins_a_session_of_its_own_and_forget_leaves_none(panel):
    write(panel)
    panel.show()
    panel.values = panel.values | {"pupil": "Ida"}
    assert (panel.session.turns, panel.teaching["asks"]) == ((), False)
    write(panel)
    panel.undo()
    with pytest.raises(LetterError, match="nothing on the sheet"):
        panel.show()
    panel.forget()
    assert (panel.lesson.ink, panel.session.turns) == ((), ())


def test_a_pupil_like_you_gets_wrong_what_was_weakest_in_your_letter(panel):
    [stroke] = teach.recording_of("b").strokes()
    wide = stroke.position * [1.8, 1.0]
    panel.add_stroke(np.hstack([stroke.t[:, None], wide, np.full((len(stroke), 1), 0.5)])[::4])
    panel.show()
    panel.values = panel.values | {"pupil": "Echo"}
    assert panel.session.traits.faults.keys() == {"width"}
    assert "wider" in panel.session.met[0].score().sentence


def test_a_bad_stroke_is_told_and_leaves_the_sheet_as_it_was(panel):
    with pytest.raises(RecordingError):
        panel.add_stroke([[0.0, 0.0, np.nan, 0.0]])
    assert panel.teaching["strokes"] == 0


@pytest.mark.parametrize("pupil", PUPILS)
def test_the_record_is_not_of_the_first_pupil_and_only_its_own_line_fits_well(pupil):
    lesson = TeachTheRobot(pupil)
    assert lesson.solution["pupil"] != lesson.start["pupil"]
    for name in ("pace", "forgetting"):
        far = lesson.solution | {name: lesson.solution[name] - 20}
        assert not lesson.check(far).done, name


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"pace": 80}, "it learned more slowly"),
        ({"pace": 20}, "it learned faster"),
        ({"forgetting": 10}, "it forgot more"),
        ({"forgetting": 90}, "it forgot less"),
        ({"pupil": "Ida"}, "Ida begins"),
    ],
)
def test_a_mistake_is_called_what_it_is(change, words):
    lesson = TeachTheRobot()
    assert words in lesson.check(lesson.solution | change).reason


def test_praise_tells_the_record_as_it_is_and_what_was_said():
    lesson = TeachTheRobot()
    said = lesson.check(lesson.solution | {"pace": lesson.solution["pace"] - 5})
    assert said.done
    assert "45 % of the difference" in said.reason
    assert "You said 40 %" in said.reason


def test_what_is_forgotten_is_seen_before_a_question_is_answered(panel):
    for _ in range(4):
        panel.show_book()
        if panel.session.met[-1].memory.lost:
            break
    assert panel.teaching["asks"]
    assert "forgotten" in panel.message["text"]
    assert float(panel.message["number"]) > 1000 * panel.session.learned[-1] + 1


@pytest.mark.parametrize(("shown", "is_taught"), [("XXXb", False), ("bXXb", True)])
def test_only_a_letter_that_was_shown_before_can_be_taught_again(panel, shown, is_taught):
    for character in shown:
        write(panel, character)
        panel.show()
    assert any(pupil.memory.lost for pupil in panel.session.met)
    assert (2 in panel.progress["done"]) == is_taught


def test_a_slip_of_the_pen_is_refused_and_another_letter_ticks_nothing(panel):
    write(panel, size=0.05)
    with pytest.raises(LetterError, match="dot"):
        panel.show()
    assert panel.session.turns == ()
    panel.undo()
    write(panel, "X")
    panel.show()
    assert (panel.progress["done"], len(panel.session.turns)) == ([], 1)
    assert "cannot read b" in panel.status


def test_who_is_chosen_to_be_taught_sets_its_own_pace_and_a_challenge_keeps_it(panel):
    panel.values = panel.values | {"pupil": "Leo"}
    leo = {"pupil": "Leo", "pace": 50, "forgetting": 20}
    assert panel.values == leo
    panel.go("challenge")
    panel.values = panel.values | {"pupil": "Ida"}
    assert panel.values == leo | {"pupil": "Ida"}


def test_a_pupil_of_a_teachers_own_is_taught_in_the_panel_and_stays():
    lesson = teach.lesson("09", pupil="w03")
    lesson.echo = PupilTraits("Tom", {"lean": 20.0}, pace=1.0, forgetting=0.1)
    assert lesson.knobs["pupil"].options["Tom"] == "Tom"
    panel = lesson.panel()
    panel.go("try")
    write(panel, lesson.letter)
    panel.show()
    panel.values = panel.values | {"pupil": "Tom"}
    assert panel.values == {"pupil": "Tom", "pace": 95, "forgetting": 10}
    assert panel.session.traits.faults == {"lean": 20.0}
    panel.forget()


def test_an_unknown_pupil_is_answered_with_the_known_ones():
    with pytest.raises(RecordingError, match="Bo, Ida, Leo, Mia, Zoe"):
        PupilTraits.load("Tom")
