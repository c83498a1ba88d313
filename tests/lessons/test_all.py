"""What holds of every lesson: its check teaches, varies with the pupil, and never raises."""

import re
import time
from itertools import product
from string import ascii_lowercase

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.classroom import LessonState
from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.lessons import lessons

KEYS = list(lessons())
PUPILS = [None, "b_2", "pupil-3", *(f"w{n:02d}" for n in range(18))]
NONSENSE = [None, 3, "width", [], {}, {"x": 1}, {1: 2}, object(), float("nan"), b"", [("a", 1)]]
NUMBER = re.compile(r"\d")


def answer_of(lesson, values):
    """What a pupil's panel would hand in with these values."""
    return {name: values[name] for name in lesson.settable}


def draw_answer(lesson, random):
    """An answer drawn from all that a pupil can set."""
    answer = {}
    for name, knob in lesson.knobs.items():
        if name not in lesson.settable:
            continue
        if isinstance(knob.allowed[0], str):
            answer[name] = str(random.choice(knob.allowed))
        elif getattr(knob, "is_log", False):
            answer[name] = float(np.exp(random.uniform(*np.log(knob.allowed))))
        else:
            steps = round((knob.high - knob.low) / knob.step)
            answer[name] = knob.low + knob.step * int(random.integers(steps + 1))
    return answer


@pytest.fixture(params=KEYS)
def key(request):
    return request.param


@pytest.mark.parametrize("pupil", PUPILS)
def test_a_check_says_no_at_the_start_and_yes_to_a_solution_that_the_sliders_have(key, pupil):
    lesson = teach.lesson(key, pupil=pupil)
    start = lesson.check(answer_of(lesson, lesson.start))
    assert (start.done, bool(start.reason), bool(start.hint)) == (False, True, True)
    end = teach.check(key, answer_of(lesson, lesson.solution), pupil=pupil)
    assert (end.done, end.hint) == (True, ""), end
    for name, knob in lesson.knobs.items():
        value = lesson.solution[name]
        if not isinstance(value, str):
            steps = value / float(f"{value:.2g}") if knob.is_log else value / knob.step
            assert steps == pytest.approx(round(steps)), name


def test_every_lesson_runs_with_a_schools_own_letters(tmp_path):
    for letter in ascii_lowercase:
        file = tmp_path / f"{letter}.json"
        teach.write_recording(teach.recording_of(letter, "slanted"), file)
    try:
        teach.use_script(tmp_path)
        for key in KEYS:
            lesson = teach.lesson(key, pupil="w03")
            found = [lesson.check(answer_of(lesson, at)) for at in (lesson.start, lesson.solution)]
            assert [verdict.done for verdict in found] == [False, True], key
    finally:
        teach.use_script(None)


def test_neighbours_have_other_challenges_and_a_pupil_has_the_same_again(key):
    texts = [teach.lesson(key, pupil=f"w{n:02d}") for n in range(12)]
    facts = [(each.challenge, str(each.start), str(each.solution)) for each in texts]
    assert len(set(facts)) >= 3
    again = teach.lesson(key, pupil="w07")
    assert (again.challenge, str(again.start), str(again.solution)) == facts[7]


def test_wrong_answers_are_told_what_is_wrong_with_them(key):
    """At least nine in ten get a sentence of their own mistake, with a number of theirs in it."""
    lesson = teach.lesson(key)
    random = np.random.default_rng(3)
    reasons = []
    while len(reasons) < 100:
        answer = draw_answer(lesson, random)
        verdict = lesson.check(answer)
        if verdict.done:
            continue
        short = [each.shortfall for each in verdict.conditions if not each.is_met]
        is_named = verdict.reason not in short and NUMBER.search(verdict.reason)
        reasons.append((bool(is_named), verdict.reason, verdict.hint))
    assert np.mean([is_named for is_named, *_ in reasons]) >= 0.9
    assert len({reason for _, reason, _ in reasons}) >= 15
    assert {hint for *_, hint in reasons} == {lesson.hints[0]}


@pytest.mark.parametrize("answer", NONSENSE, ids=lambda answer: type(answer).__name__)
def test_nonsense_gets_a_sentence_and_no_traceback(key, answer):
    verdict = teach.check(key, answer)
    assert not verdict.done
    assert verdict.reason.endswith(".")


def test_a_value_beyond_its_knob_is_named(key):
    lesson = teach.lesson(key)
    for name, allowed in lesson.settable.items():
        wrong = "nothing" if isinstance(allowed[0], str) else 10 * max(map(abs, allowed)) + 1
        verdict = lesson.check(answer_of(lesson, lesson.solution) | {name: wrong})
        assert not verdict.done
        assert name in verdict.reason


def test_hints_come_one_by_one_and_the_last_one_stays(key):
    lesson = teach.lesson(key)
    wrong = answer_of(lesson, lesson.start)
    assert [lesson.check(wrong, hints=n).hint for n in (0, 1, 2, 3)] == [
        *lesson.hints,
        lesson.hints[2],
    ]
    assert len(set(lesson.hints)) == 3


def test_a_check_takes_less_than_a_second_of_the_processor(key):
    lesson = teach.lesson(key, pupil="w55")
    begin = time.process_time()
    lesson.check(answer_of(lesson, lesson.start))
    assert time.process_time() - begin < 1


def test_tasks_are_not_done_at_the_start(key):
    lesson = teach.lesson(key)
    done = lesson.done(lesson.start)
    assert len(done) == len(lesson.tasks)
    assert [i for i, is_done in enumerate(done) if is_done and i not in lesson.by_robot] == []


def test_a_task_to_drag_is_not_done_by_a_choice(key):
    lesson = teach.lesson(key)
    drags = [i for i, text in enumerate(lesson.tasks) if "drag" in text.lower()]
    choices = {
        name: each.allowed for name, each in lesson.knobs.items() if hasattr(each, "options")
    }
    for chosen in product(*choices.values()):
        values = lesson.start | dict(zip(choices, chosen, strict=True))
        assert [i for i in drags if lesson.done(values)[i]] == []


@pytest.mark.parametrize("pupil", PUPILS[:3])
def test_a_panel_plays_from_the_bet_to_the_green_card(key, pupil):
    lesson = teach.lesson(key, pupil=pupil)
    panel = lesson.panel()
    panel.forget()
    assert panel.answer == answer_of(lesson, lesson.start)
    bet = lesson.bet.described()
    bet = bet["handles"] if "handles" in bet else bet["options"][0][0]
    panel.bet(bet)
    hidden = panel.drawing
    panel.reveal()
    assert panel.drawing > hidden
    assert NUMBER.search(panel.card["bet"]) or isinstance(bet, str)
    panel.go("challenge")
    assert not panel.check().done
    assert not panel.check().done
    assert panel.card["offersHint"]
    panel.values = lesson.solution
    assert panel.check().done
    assert panel.progress["passed"]
    # Running the cell again finds the work as it was.
    again = teach.lesson(key, pupil=pupil).panel()
    assert again.progress == panel.progress
    assert again.values == panel.values
    panel.forget()
    assert teach.lesson(key, pupil=pupil).panel().progress["bet"] is None


def test_every_step_is_drawn_at_both_ends_of_every_knob(key):
    lesson = teach.lesson(key)
    for name, knob in lesson.knobs.items():
        for value in (knob.allowed[0], knob.allowed[-1]):
            for step, is_revealed in (("bet", False), ("try", True), ("challenge", True)):
                values = lesson.start | {name: value}
                picture = lesson.draw(LessonState(values, step, None, is_revealed))
                assert set(picture.says) == {"number", "unit", "text", "strong", "after"}


def test_a_panel_refuses_a_value_that_no_knob_has_and_keeps_the_old_one(key):
    panel = teach.lesson(key).panel()
    before = panel.values
    with pytest.raises(SettingError):
        panel.values = {"nothing": 1}
    assert panel.values == before


@pytest.mark.parametrize("hints", [None, float("nan"), "a"])
def test_hints_are_counted_in_whole_numbers(hints):
    with pytest.raises(SettingError, match="hints"):
        teach.check("02", {}, hints=hints)


@pytest.mark.parametrize(
    "answer", [10**5000, {"n_kernels": 10**5000}, {10**5000: 1}], ids=["whole", "value", "name"]
)
def test_an_answer_that_cannot_be_printed_is_refused(answer):
    assert not teach.check("02", answer).done


def test_a_lesson_shows_no_recording_of_ones_own():
    with pytest.raises(RecordingError, match=r"explore\(recording\)"):
        teach.lesson("03").panel().load(teach.recording_of("a"))


def test_a_lesson_is_found_by_its_number_and_its_name(key):
    assert type(teach.lesson(lessons()[key])) is type(teach.lesson(key))
    assert teach.lesson(key).key == key


def test_an_unknown_lesson_is_refused_by_name():
    with pytest.raises(SettingError, match="bump_width"):
        teach.lesson("77")


def test_an_exported_panel_is_a_picture_with_its_sentence(key):
    lesson = teach.lesson(key)
    still = lesson.panel().draw_still()
    assert lesson.question in still.text()
    assert still.svg().count("<polyline") >= 1
