"""The start panel, by setting its values."""

import asyncio
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

import dmp_teach
from dmp_teach.classroom.panels.background_job import Job, StopPressed
from dmp_teach.classroom.panels.explore import explore
from dmp_teach.ink.alphabet import characters
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.recording_json import read_json, write_json
from dmp_teach.views import SceneView
from tests.classroom.browser import send


def points(panel, name="robot"):
    return np.frombuffer(getattr(panel, name), "<f4").reshape(-1, 2)


@pytest.fixture
def panel():
    return explore()


@pytest.mark.parametrize(
    ("knob", "value"), [("n_kernels", 30), ("kernel_width", 1.0), ("letter", "e"), ("goal_x", 0.01)]
)
def test_every_knob_redraws_the_letter_and_says_another_sentence(panel, knob, value):
    line, message, drawing = panel.robot, panel.message, panel.drawing
    setattr(panel, knob, value)
    assert panel.robot != line
    assert panel.message != message
    assert panel.drawing > drawing


def test_the_panel_shows_what_letter_learn_and_write_give(panel):
    panel.letter, panel.n_kernels, panel.kernel_width = "D", 20, 1.0
    panel.goal_shifts = [[0.0, 0.0], [0.01, 0.05]]
    letter = dmp_teach.Letter.learn(
        dmp_teach.recording_of("D"), dmp_teach.Settings.star(n_kernels=20, kernel_width=1.0)
    )
    expected = letter.write(goal_shifts={1: (0.01, 0.05)})
    assert np.allclose(points(panel), np.concatenate([s.position for s in expected]), atol=1e-6)
    assert panel.counts == [len(s) for s in expected]
    assert np.allclose(
        points(panel, "demo"), np.concatenate([s.position for s in letter.strokes]), atol=1e-6
    )


def test_a_slider_of_ones_own_moves_the_goal_of_the_chosen_stroke(panel):
    panel.letter = "D"
    assert panel.stroke == 1
    panel.goal_y = 0.04
    assert panel.goal_shifts == [[0.0, 0.0], [0.0, 0.04]]
    panel.stroke = 0
    assert (panel.goal_x, panel.goal_y) == (0.0, 0.0)
    panel.goal_x = -0.02
    assert panel.goal_shifts == [[-0.02, 0.0], [0.0, 0.04]]


def test_the_browser_is_sent_what_moves_a_goal_as_the_kernel_does(panel):
    panel.letter = "D"
    at_home, drawn = points(panel), panel.drawn_shifts
    x, y = (np.frombuffer(panel.goal_terms[axis]).reshape(-1, 2) for axis in "xy")
    shifts = np.repeat([[0.02, -0.01], [-0.03, 0.05]], panel.counts, axis=0)
    before = panel.drawing
    panel.goal_shifts = [[0.02, -0.01], [-0.03, 0.05]]
    assert panel.drawing == before + 1  # one answer, not one for each coordinate
    assert drawn == [[0.0, 0.0], [0.0, 0.0]]
    assert panel.drawn_shifts == panel.goal_shifts
    moved = at_home + shifts[:, :1] * x + shifts[:, 1:] * y
    assert np.allclose(points(panel), moved, atol=1e-6 * np.ptp(at_home))


def test_another_letter_has_its_goals_where_they_were_taught(panel):
    panel.goal_x = 0.05
    panel.letter = "D"
    assert panel.goal_shifts == [[0.0, 0.0], [0.0, 0.0]]
    assert panel.goal_x == 0.0


def test_no_letter_is_given_more_bumps_than_it_has_samples():
    t = np.linspace(0, 0.3, 13)
    short = Recording(t, np.column_stack([t, t**2, 0 * t]), "l", "w1", None, ((0, 13),))
    panel = explore(short)
    assert panel.most_kernels == 12
    assert panel.n_kernels <= 12


def test_a_setting_out_of_its_range_is_refused_with_the_range(panel):
    with pytest.raises(
        dmp_teach.TeachError, match=r"kernel_width is 0\.0, but it must be between 0\.2 and 40"
    ):
        panel.kernel_width = 0.0


def test_the_three_dimensions_are_sent_only_when_the_robot_is_asked_to_write(panel):
    traits = panel.trait_values(sync=True).values()
    sent = sum(len(value) for value in traits if isinstance(value, str | bytes))
    assert sent < 200_000
    assert panel.scene is None
    panel.write()
    assert panel.scene.camera == "over the shoulder"
    assert panel.scene.playing


def refuse(*args, **traits):
    raise AssertionError


def test_a_view_that_cannot_be_made_ends_the_job_with_a_sentence(panel, monkeypatch):
    monkeypatch.setattr(SceneView, "__init__", refuse)

    async def fail_late():
        asyncio.get_running_loop().set_exception_handler(lambda loop, context: raised.append(1))
        panel.write()
        while panel.work["state"] == "working":
            await asyncio.sleep(0.01)

    raised = []
    asyncio.run(fail_late())
    assert raised, "the fault is told to the kernel, too"
    assert panel.work["state"] == "cannot"
    assert "AssertionError" in panel.work["strong"]


def test_in_marimo_the_robot_needs_no_widget_that_was_not_made_with_the_panel(monkeypatch):
    monkeypatch.setitem(sys.modules, "marimo", sys)
    panel = explore()
    assert panel.scene is None
    monkeypatch.setattr(SceneView, "__init__", refuse)
    panel.write()
    assert panel.scene.motion is panel.motion


def test_the_robot_writes_exactly_what_is_seen(panel):
    panel.letter, panel.n_kernels, panel.kernel_width = "D", 30, 1.0
    panel.goal_y = 0.05
    seen = points(panel)
    panel.write()
    assert panel.work == {"state": "idle"}
    written = np.concatenate([stroke.position for stroke in panel.motion.strokes])
    middle = (written.max(axis=0) + written.min(axis=0)) / 2 - (
        seen.max(axis=0) + seen.min(axis=0)
    ) / 2
    assert np.allclose(written - middle, seen, atol=1e-6)
    assert panel.scene.motion is panel.motion
    assert not panel.older
    panel.n_kernels = 10
    assert panel.older
    panel.n_kernels = 30
    assert not panel.older


def test_steps_are_named_and_their_progress_never_falls(panel):
    heard = []
    panel.observe(lambda change: heard.append(change["new"]), "work")
    panel.write()
    working = [work for work in heard if work["state"] == "working"]
    assert [len(work["steps"]) for work in working] == [3] * len(working)
    order = [(work["at"], work["fraction"]) for work in working]
    assert order == sorted(order)
    assert {at for at, _ in order} == {0, 1, 2}
    assert len([at for at, _ in order if at == 2]) >= 10


def too_large(panel):
    t = np.linspace(0, 3, 361)
    panel.load(
        Recording(
            t, np.column_stack([0.1 * np.sin(t), 0.12 * t, 0 * t]), "l", "w1", None, ((0, 361),)
        )
    )


def test_a_letter_too_large_for_the_page_is_cured_by_one_button(panel):
    too_large(panel)
    panel.write()
    assert panel.work["state"] == "cannot"
    assert "210 x 297 mm" in panel.work["strong"]
    assert panel.work["cure"].startswith("Write it 28.7 cm high")
    assert panel.motion is None
    send(panel, {"kind": "cure"})
    assert panel.work == {"state": "idle"}
    assert np.ptp(panel.motion.strokes[0].position[:, 1]) == pytest.approx(0.287, abs=0.001)


def test_a_page_out_of_reach_is_cured_by_one_button():
    panel = explore(page=dmp_teach.Page.table(x=1.4))
    panel.write()
    assert panel.work["state"] == "cannot"
    assert panel.work["cure"] == "Move the page there"
    send(panel, {"kind": "cure"})
    assert panel.work == {"state": "idle"}
    assert panel.motion.page is panel.page


def test_near_the_end_of_the_arms_reach_notes_say_so_and_nothing_is_printed(recwarn):
    panel = explore(page=dmp_teach.Page.table(x=0.88))
    panel.write()
    assert any("nearly stretched out" in note for note in panel.motion.notes)
    assert not [each for each in recwarn if each.category is dmp_teach.errors.ReachWarning]


def test_where_a_part_is_missing_the_panel_goes_on_and_says_what_works(panel, monkeypatch):
    def missing(*_, **__):
        raise dmp_teach.errors.MissingPartError("PlaCo is not here. Letters can still be learned.")

    monkeypatch.setattr(dmp_teach.Fetch, "write_in_slices", missing)
    panel.write()
    assert panel.work["strong"] == "PlaCo is not here."
    panel.n_kernels = 20
    assert panel.message["number"]


def test_stop_ends_the_planning_and_the_next_letter_is_written(panel):
    async def press_stop():
        panel.write()
        send(panel, {"kind": "stop"})
        while panel.work["state"] == "working":
            await asyncio.sleep(0.01)

    asyncio.run(press_stop())
    assert panel.motion is None
    panel.write()
    assert panel.motion is not None


def slices(result, heard):
    heard.append(threading.current_thread())
    yield "step", 0.5
    return result()


@pytest.mark.parametrize("threads", [True, False])
def test_a_job_tells_the_thread_that_asked(threads):
    heard, where = [], []

    async def ask():
        ended = asyncio.Event()
        Job(
            slices(lambda: "result", where),
            lambda *p: heard.append((*p, threading.current_thread())),
            lambda r: (heard.append(r), ended.set()),
            threads=threads,
        )
        await ended.wait()

    asyncio.run(ask())
    here = threading.current_thread()
    assert heard == [("step", 0.5, here), "result"]
    assert (where == [here]) is not threads


def test_without_threads_stop_is_heard_between_two_slices_and_jobs_wait_for_each_other():
    heard = []

    def forever(name):
        while True:
            heard.append(name)
            yield "step", 0.5

    async def ask():
        ended = asyncio.Event()
        first = Job(forever("first"), lambda *p: None, heard.append, threads=False)
        second = Job(
            slices(lambda: 1 / 0, []),
            lambda *p: None,
            lambda r: (heard.append(r), ended.set()),
            threads=False,
        )
        for _ in range(5):
            await asyncio.sleep(0)
        first.stop()
        await ended.wait()
        return second

    asyncio.run(ask())
    *turns, stopped, failed = heard
    assert len(turns) > 3
    assert isinstance(stopped, StopPressed)
    assert isinstance(failed, ZeroDivisionError)


def test_what_a_job_raises_is_its_result():
    heard = []
    Job(slices(lambda: 1 / 0, []), print, heard.append)
    assert isinstance(heard[0], ZeroDivisionError)


def test_a_recording_of_ones_own_stands_beside_the_letters(panel, tmp_path):
    path = tmp_path / "q.json"
    write_json(dmp_teach.recording_of("q"), path)
    send(panel, {"kind": "file", "name": "q.json"}, path.read_bytes())
    assert panel.choices[-1][2] == "your own q"
    own = np.concatenate([stroke.position for stroke in read_json(path).strokes()])
    assert np.allclose(points(panel, "demo"), own, atol=1e-6)
    assert explore(path).letter == panel.letter


@pytest.mark.parametrize("name", ["notes.csv", "../../notes.json", "..", ""])
def test_a_file_that_is_no_recording_gets_a_sentence_and_the_letter_stays(panel, name):
    before = panel.robot
    send(panel, {"kind": "file", "name": name}, b"shopping,list\n")
    assert panel.work["state"] == "cannot"
    assert panel.robot == before


def test_a_file_of_many_megabytes_is_refused_with_its_size(panel):
    send(panel, {"kind": "too large", "name": "film.csv", "size": 90_000_000})
    assert panel.work["strong"] == "film.csv has 90 MB."


@pytest.mark.parametrize(
    "end", [lambda p: send(p, {"kind": "close"}), lambda p: setattr(p, "n_kernels", 20)]
)
def test_what_cannot_be_done_goes_away_when_closed_and_when_something_is_changed(panel, end):
    send(panel, {"kind": "file", "name": "notes.csv"}, b"shopping,list\n")
    assert panel.work["state"] == "cannot"
    end(panel)
    assert panel.work == {"state": "idle"}


def test_gaps_between_bumps_are_told_by_the_panels_own_sentence(panel, recwarn):
    panel.n_kernels = 40
    panel.kernel_width = 0.5
    assert "gaps" in panel.message["after"]
    assert not recwarn.list


def test_a_file_opened_while_the_robot_plans_leaves_its_steps_in_sight(panel, tmp_path):
    path = tmp_path / "q.json"
    write_json(dmp_teach.recording_of("q"), path)
    panel.work = {"state": "working", "steps": [], "at": 2, "fraction": 0.5}
    send(panel, {"kind": "file", "name": "q.json"}, path.read_bytes())
    assert panel.work["state"] == "working"
    assert panel.title.startswith("Your own q")


@pytest.mark.parametrize(
    ("n", "thing"), [(5, "the width of a finger"), (40, "the thickness of a hair")]
)
def test_what_the_first_notebook_says_of_the_guess_is_true(panel, n, thing):
    panel.n_kernels, panel.kernel_width = n, 1.0
    assert thing in panel.message["strong"]
    text = (Path(__file__).parents[2] / "notebooks" / "00_start_here.ipynb").read_text(
        encoding="utf-8"
    )
    assert f"{thing}" in text[text.index("## What happened") :]


def test_the_list_of_letters_has_groups_and_every_letter_that_we_have(panel):
    groups = {}
    for value, label, name, group in panel.choices:
        assert value == label == name[-1]
        groups.setdefault(group, []).append(value)
    assert list(groups) == ["Small letters", "Capitals", "Digits", "With accents"]
    assert [value for inside in groups.values() for value in inside] == list(characters())
    for group, letter in (
        ("Small letters", "b"),
        ("Capitals", "B"),
        ("Digits", "7"),
        ("With accents", "\u00e4"),
    ):
        assert letter in groups[group]


def test_a_panel_begins_with_the_parts_and_the_settings_that_were_asked_for():
    panel = explore("e", show=("sheet", "n_kernels"), n_kernels=5, kernel_width=1.0, fit="joint")
    assert panel.shown == ["sheet", "n_kernels"]
    settings = dmp_teach.Settings.star(n_kernels=5, kernel_width=1.0, fit="joint")
    expected = dmp_teach.Letter.learn(dmp_teach.recording_of("e"), settings).write()
    assert np.array_equal(points(panel), np.concatenate([s.position for s in expected], dtype="f4"))


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"show": ["sheet", "robots"]}, "no part 'robots'; its parts are: letters, sheet, goal"),
        ({"n_kernel": 5}, "no setting 'n_kernel'. The settings are: n_kernels"),
        ({"n_kernels": 5.5}, "n_kernels is 5.5, but it must be a whole number"),
        ({"n_kernels": None}, "n_kernels is None, but this panel's slider ends at 80"),
        ({"n_kernels": 81}, "n_kernels is 81, but this panel's slider ends at 80"),
        ({"kernel_width": float("inf"), "kernel_sigma": 1.0}, "kernel_width is inf"),
        ({"fit": "best"}, "fit is 'best'"),
    ],
)
def test_a_part_or_a_setting_that_is_not_there_is_refused_by_name(wrong, told):
    with pytest.raises(dmp_teach.SettingError) as said:
        explore("e", **wrong)
    assert told in str(said.value)


def test_more_kernels_than_the_letter_has_samples_are_refused_at_the_start():
    t = np.linspace(0, 0.3, 13)
    short = Recording(t, np.column_stack([t, t**2, 0 * t]), "l", "w1", None, ((0, 13),))
    with pytest.raises(dmp_teach.SettingError, match="samples for at most 12"):
        explore(short, n_kernels=13)


def test_a_check_can_ask_a_panel_for_its_letter_its_error_and_what_is_set(panel):
    panel.letter, panel.n_kernels, panel.kernel_width = "D", 20, 1.0
    assert panel.recording.character == "D"
    assert panel.learned.primitives[0].settings.n_kernels == 20
    distance = dmp_teach.letter_distance(panel.learned.write(), panel.recording)
    assert 0 < panel.error < 3 * distance + 1e-3
    before = panel.error
    panel.goal_y = 0.03
    assert panel.error == before
    panel.n_kernels = 40
    assert panel.error < before
    assert panel.answer == {
        "letter": "D",
        "n_kernels": 40,
        "kernel_width": 1.0,
        "goal_shifts": [[0.0, 0.0], [0.0, 0.03]],
    }
    assert len(str(panel.answer)) <= 160
