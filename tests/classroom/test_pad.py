"""The writing pad, by sending it what a browser sends."""

import asyncio
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from traitlets import TraitError

import dmp_teach
from dmp_teach.classroom.panels.kept import forget
from dmp_teach.classroom.panels.pad import pad
from dmp_teach.errors import PageError, RecordingError, TeachError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.ink.recording_json import read_json, recording_to_json, write_json
from dmp_teach.trajectory import Trajectory
from tests.classroom import browser


@pytest.fixture(autouse=True)
def _new_kernel():
    for key in ("pad", "pad w01", "pad w07"):
        forget(key)


@pytest.fixture
def panel():
    return pad()


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def rows_of(stroke, stretch=(1.0, 1.0), shift=(0.0, 0.0), pressure=0.5):
    """A stroke as a pad would send it: every other sample, in metres of the sheet."""
    points = stroke.position[::2] * stretch + shift
    return np.column_stack([stroke.t[::2] + 40, points, np.full(len(points), pressure)])


def send(panel, rows=None, kind="stroke", **more):
    number = more.pop("n", panel.answered + 1)
    buffers = [] if rows is None else [memoryview(np.asarray(rows, "<f8").tobytes())]
    browser.send(panel, {"kind": kind, "n": number, "pointer": "mouse", **more}, *buffers)


def write(panel, character="a", **how):
    if panel.character != character:
        panel.character = character
    for stroke in dmp_teach.recording_of(character).strokes():
        send(panel, rows_of(stroke, **how))


def points(panel, name):
    return np.frombuffer(getattr(panel, name), "<f4").reshape(-1, 2)


def test_ink_becomes_a_recording_that_is_learned_written_again_and_scored(panel):
    write(panel, "D", stretch=(1.1, 0.9))
    assert panel.counts == [len(stroke) for stroke in panel.recording.strokes()]
    assert panel.recording.character == "D"
    assert panel.recording.baseline == 0
    assert np.allclose(
        points(panel, "ink"),
        np.concatenate([s.position for s in panel.recording.strokes()]),
        atol=1e-6,
    )
    written = np.concatenate([stroke.position for stroke in panel.letter.write()])
    assert np.allclose(points(panel, "robot"), written, atol=1e-6)
    assert panel.letter.error < 0.001
    assert panel.error == panel.score.distance > 0
    assert [row["name"] for row in panel.parts] == ["Shape", "Size", "Lean", "Way of writing"]
    assert "It is a little wider than the robot’s, for its height." in panel.message["text"]
    assert panel.message["strong"] == "Write it narrower."
    assert panel.caught.startswith(f"Stroke 2: {panel.recording.strokes()[1].duration:.1f} s, ")
    assert panel.title.startswith("Your D, 2 strokes.")


def test_the_points_are_where_the_hand_was(panel):
    stroke = dmp_teach.recording_of("a").strokes()[0]
    send(panel, rows_of(stroke))
    ink = panel.recording.strokes()[0]
    apart = [np.linalg.norm(ink.position - place, axis=1).min() for place in stroke.position]
    assert max(apart) < 0.001


def test_a_letter_with_fewer_strokes_than_the_robots_is_scored_when_that_is_all(panel):
    panel.character = "D"
    send(panel, rows_of(dmp_teach.recording_of("D").strokes()[0]))
    assert panel.unfinished
    assert (panel.parts, panel.tries, panel.message["number"]) == ([], [], "")
    send(panel, kind="all")
    assert not panel.unfinished
    assert [(row["name"], row["reason"]) for row in panel.parts] == [("Shape", "looks like an l")]
    assert len(panel.tries) == 1


def test_a_tap_is_a_dot_and_a_flick_too_fast_says_what_to_do(panel):
    send(panel, [[1, 0.01, 0.1, 0.5]])
    assert panel.caught == "Stroke 1: a dot."
    send(panel, [[2, 0.01, 0.0, 0.5], [2.02, 0.05, 0.07, 0.5]])
    assert panel.caught == "Stroke 2: too fast to see. Write a little slower."
    assert len(panel.recording.strokes()) == 2


def test_a_letter_that_is_dashed_off_is_too_fast_though_it_has_more_than_a_few_points(panel):
    stroke = dmp_teach.recording_of("a").strokes()[0]
    points = stroke.position[:: len(stroke) // 6]
    send(
        panel,
        np.column_stack([np.linspace(3, 3.2, len(points)), points, np.full(len(points), 0.5)]),
    )
    assert panel.caught == "Stroke 1: too fast to see. Write a little slower."


@pytest.mark.parametrize(
    ("outside", "words"),
    [(0, "Stroke 1"), (3, "left the sheet: write a little smaller"), ("x", "Stroke 1")],
)
def test_a_pen_that_left_the_sheet_is_told_so(panel, outside, words):
    send(panel, good(), outside=outside)
    assert words in panel.caught
    assert len(panel.counts) == 1


def test_small_marks_need_few_points_and_a_dot_alone_is_no_letter(panel):
    send(panel, [[2, 0.01, 0.0, 0.5], [2.04, 0.012, 0.002, 0.5], [2.08, 0.015, 0.002, 0.5]])
    assert panel.caught == "Stroke 1: 0.1 s, 3 points."
    send(panel, kind="again")
    send(panel, [[5, 0.01, 0.1, 0.5]])
    assert "only a dot" in panel.message["text"]
    assert panel.message["strong"] == "Undo"


@pytest.mark.parametrize(
    ("asked", "written", "other"), [("a", "e", "an e"), ("D", "P", "a P"), ("a", "o", "an o")]
)
def test_a_wrong_letter_is_named_and_its_width_is_compared_with_nothing(asked, written, other):
    panel = pad(asked)
    for stroke in recording_of(written).strokes():
        send(panel, rows_of(stroke))
    if panel.unfinished:
        send(panel, kind="all")
    assert panel.message["text"].strip() == f"This looks like {other}."
    assert f"how {'an' if asked == 'a' else 'a'} {asked} is written" in panel.message["strong"]
    assert [row["reason"] for row in panel.parts] == [f"looks like {other}"]
    assert panel.tries[0]["word"] == "far"


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(*[st.floats(0, 0.1)] * 2), min_size=14, max_size=25, unique=True))
def test_of_a_scribble_no_row_is_good_and_no_width_is_compared(corners):
    forget("pad")
    panel = pad("a")
    at = np.linspace(0, len(corners) - 1, 150)
    path = [np.interp(at, range(len(corners)), axis) for axis in zip(*corners, strict=True)]
    send(panel, np.column_stack([np.linspace(1, 5, 150), *path, np.ones(150)]))
    assert not any(row["level"] > 1 for row in panel.parts)
    assert "wider" not in str(panel.message) + str(panel.parts)


@pytest.mark.parametrize("slip", [0.0, 0.0001, 0.001])
def test_a_slip_is_a_dot_in_every_place(panel, slip):
    send(panel, [[1, 0.01, 0.1, 0.5], [1.05, 0.01 + slip, 0.1, 0.5]])
    assert panel.caught == "Stroke 1: a dot."
    assert "only a dot" in panel.message["text"]
    assert panel.message["number"] == ""
    assert (panel.parts, panel.tries) == ([], [])


@pytest.mark.parametrize("character", list("tfAEFHT"))
def test_a_left_hand_may_draw_bars_from_right_to_left(character):
    strokes = recording_of(character).strokes()
    for hand, said in (("right", "wrong end"), ("left", "looks the same")):
        panel = pad(character, writer="w07", hand=hand)
        for stroke in strokes:
            right, up = np.abs(stroke.position[-1] - stroke.position[0])
            position = stroke.position[::-1] if right > 2 * up else stroke.position
            send(panel, rows_of(Trajectory(stroke.t, position)))
        assert said in panel.message["text"] + panel.message["strong"]


def test_how_the_pen_moved_is_named_last_and_only_where_enough_points_tell(panel):
    stroke = dmp_teach.recording_of("a").strokes()[0]
    t = stroke.t + 0.05 * np.sin(
        2 * np.pi * 3 * stroke.t
    )  # stops and goes, and leaves the same line

    def say(size, step):
        points = stroke.position[::step] * size
        send(panel, np.column_stack([t[::step], points, np.ones(len(points))]))
        said = "".join(panel.message[part] for part in ("text", "strong", "after"))
        send(panel, kind="again")
        panel.character = "b"
        panel.character = "a"
        return said

    assert "looks the same as the robot’s. The pen speeds up" in say(1.0, 2)
    assert "The pen" not in say(0.6, 2)
    assert "smaller than the robot’s" in say(0.6, 2)
    assert "The pen" not in say(1.0, 6)


def test_a_worse_try_is_further_away_and_the_tries_stay_in_order(panel):
    praise = "Well written: it looks the same as the robot’s."
    said = (
        (1.1, None),
        (1.6, "Further away this time"),
        (1.3, "Nearer"),
        (1.3, "As near as"),
        (1.4, "A little further"),
    )
    for size, after in said:
        write(panel, stretch=(size, size))
        assert after is None or after in panel.message["after"]
        assert panel.message["strong"] == ("Write it smaller." if size > 1.1 else praise)
        send(panel, kind="again")
    heights = [np.ptp(recording.strokes()[0].position[:, 1]) for recording in panel.recordings]
    assert np.allclose(heights, np.array([1.1, 1.6, 1.3, 1.3, 1.4]) * heights[0] / 1.1, rtol=1e-6)
    assert [each["number"] for each in panel.tries] == [1, 2, 3, 4, 5]
    for _ in range(3):
        write(panel)
        send(panel, kind="again")
    assert [each["number"] for each in panel.tries] == [3, 4, 5, 6, 7, 8]
    assert sum(sum(each["counts"]) for each in panel.tries) == len(points(panel, "tried"))


def test_undo_takes_stroke_after_stroke_and_then_brings_the_try_before_which_is_never_lost(panel):
    send(panel, kind="undo")
    assert panel.caught == "Nothing to undo."
    write(panel, "D")
    send(panel, kind="again")
    write(panel, "D")
    send(panel, kind="undo")
    assert len(panel.counts) == 1
    send(panel, kind="undo")
    assert panel.counts == []
    assert len(panel.recordings) == 1
    send(panel, kind="undo")
    assert len(panel.counts) == 2
    assert panel.caught == "The try before is on your sheet again."
    assert len(panel.recordings) == len(panel.tries) == 1
    first = panel.recording
    send(panel, kind="undo")
    assert panel.caught == "Stroke 2 is gone. The try before stays."
    for _ in range(7):
        send(panel, kind="undo")
        assert panel.recordings[0] is first


def test_what_is_done_to_a_try_that_was_brought_back_makes_another_try(panel, folder):
    write(panel)
    send(panel, kind="again")
    send(panel, kind="undo")
    send(panel, kind="again")
    assert len(panel.recordings) == 1
    send(panel, kind="undo")
    assert panel.save().name == "a_w01.json"
    send(panel, kind="again")
    send(panel, kind="save")
    assert panel.kept == "Nothing new to save: your newest try is in a_w01.json."
    assert [recording.writer for recording in panel.recordings] == ["w01"]
    send(panel, good())
    assert [len(recording.strokes()) for recording in panel.recordings] == [1, 1]
    assert [each["number"] for each in panel.tries] == [1, 2]


@pytest.mark.parametrize("character", ["a", "D"])
def test_a_letter_written_after_a_right_one_is_the_next_try(panel, character):
    for _ in range(2):
        write(panel, character)
    assert len(panel.recordings) == len(panel.tries) == 2
    assert {each["word"] for each in panel.tries} == {"the same"}


def test_a_letter_that_stands_upright_on_a_turned_sheet_is_called_turned(panel):
    rows = good()
    rows[:, 1:3] @= np.array([[np.cos(0.6), np.sin(0.6)], [-np.sin(0.6), np.cos(0.6)]])
    send(panel, rows)
    assert "turned to the left, by 3" in panel.message["text"]


def test_another_letter_begins_on_an_empty_sheet_of_its_own_size(panel):
    write(panel, "a")
    sheet = panel.sheet
    panel.character = "g"
    assert panel.counts == []
    assert panel.tries == []
    assert panel.sheet[1] < sheet[1]
    assert panel.lines[0] == 0
    send(panel, kind="undo")
    assert panel.counts == []
    assert panel.recording.character == "a"


def test_without_a_letter_the_robot_learns_whatever_is_written():
    free = pad(None)
    assert free.character == ""
    send(free, rows_of(dmp_teach.recording_of("g").strokes()[0]))
    assert (free.score, free.error) == (None, None)
    assert free.recording.character is None
    assert free.message["number"] == "0.1"
    assert free.parts == []
    free.write()
    assert free.motion is not None


def test_a_stroke_that_is_refused_is_not_on_the_sheet(panel):
    with pytest.raises(RecordingError, match="outside"):
        panel.add_stroke(good(), outside=None)
    with pytest.raises(RecordingError, match="Nothing is written"):
        _ = panel.recording


def test_before_anything_is_written_the_next_cells_are_told_so_and_the_robot_writes_its_own(panel):
    for name in ("recording", "letter", "score", "error"):
        with pytest.raises(RecordingError, match="Nothing is written on the pad yet"):
            getattr(panel, name)
    assert panel.recordings == ()
    assert np.array_equal(points(panel, "robot"), points(panel, "model"))
    panel.write()
    assert len(panel.motion.strokes) == 1


def test_the_robots_own_letter_comes_with_its_tempo(panel):
    panel.character = "D"
    model = dmp_teach.recording_of("D").strokes()
    assert [len(times) for times in panel.model_times] == [len(stroke) for stroke in model]
    assert panel.model_times[1][0] == pytest.approx(model[1].t[0] - model[0].t[0])
    assert np.allclose(
        points(panel, "model"), np.concatenate([s.position for s in model]), atol=1e-6
    )


def test_the_robot_writes_what_is_on_the_sheet_and_an_older_letter_is_marked(panel):
    write(panel)
    assert panel.scene is None
    send(panel, kind="write")
    assert panel.work == {"state": "idle"}
    assert panel.scene.motion is panel.motion
    placed = panel.motion.strokes[0].position
    assert np.allclose(
        placed - placed[0], points(panel, "robot") - points(panel, "robot")[0], atol=1e-6
    )
    send(panel, kind="again")
    assert panel.older


def test_an_empty_sheet_without_a_letter_gives_the_robot_nothing_to_write():
    free = pad(None)
    send(free, kind="write")
    assert free.work["state"] == "cannot"
    assert "nothing to write" in free.work["strong"]


def test_save_writes_one_file_with_a_pseudonym_and_no_time_of_day(panel, folder):
    write(panel)
    assert list(folder.iterdir()) == []
    send(panel, kind="save")
    (file,) = folder.iterdir()
    assert file.name == "a_w01.json"
    assert "a_w01.json" in panel.kept
    again = read_json(file)
    assert (again.character, again.writer, again.t[0]) == ("a", "w01", 0)
    assert np.array_equal(again.position, panel.recording.position)
    fields = "format version character writer baseline units strokes pressure samples"
    assert set(json.loads(file.read_text())) == set(fields.split())
    send(panel, kind="save")
    assert len(list(folder.iterdir())) == 1
    send(panel, kind="again")
    write(panel)
    assert panel.kept == ""
    send(panel, kind="save")
    assert {file.name for file in folder.iterdir()} == {"a_w01.json", "a_w01_2.json"}


def test_another_writer_takes_the_next_free_pseudonym_unless_given_one(folder):
    for make, name in (
        (pad, "a_w01.json"),
        (pad, "a_w02.json"),
        (lambda: pad(writer="w07"), "a_w07.json"),
    ):
        forget("pad")
        panel = make()
        write(panel)
        assert panel.save().name == name
    with pytest.raises(RecordingError, match="pseudonym"):
        pad(writer="Anna Meyer")
    with pytest.raises(PageError, match="page is 5"):
        pad(page=5)


@pytest.mark.parametrize(
    "character", ["../escaped", "/", "?", "a/b", "..", "CON:", "eighteen letters ", "\\"]
)
def test_whatever_was_written_a_file_lies_beside_the_notebook(folder, character):
    panel = pad(None)
    panel.load(replace(recording_of("a"), character=character))
    file = panel.save()
    assert file.parent == folder
    assert re.fullmatch(r"ink_w\d\d\.json|ink_writer-1\.json", file.name)
    assert [each.name for each in folder.iterdir()] == [file.name]
    assert not [each for each in folder.parent.iterdir() if each.suffix == ".json"]


def test_what_was_there_is_never_overwritten(panel, folder):
    (folder / "a_w01.json").mkdir()
    panel.writer = "w01"
    write(panel)
    assert panel.save().name == "a_w01_2.json"


def test_forget_leaves_no_byte(panel, folder):
    for _ in range(2):
        write(panel)
        send(panel, kind="save")
        send(panel, kind="again")
    panel.write()
    (folder / "other.json").write_text("{}")
    send(panel, kind="forget")
    assert [file.name for file in folder.iterdir()] == ["other.json"]
    assert panel.recordings == ()
    assert (panel.ink, panel.tried, panel.tries, panel.counts) == (b"", b"", [], [])
    assert panel.robot == panel.model
    assert panel.motion is None
    assert panel.scene.motion is None
    assert "a_w01.json, a_w01_2.json" in panel.kept


def test_running_the_cell_again_keeps_every_try_and_the_pupil(panel, folder):
    for _ in range(2):
        write(panel)
        send(panel, kind="again")
    assert panel.save().name == "a_w01.json"
    again = pad()
    assert again.counts == []
    assert again.recordings == panel.recordings
    assert [each["number"] for each in again.tries] == [1, 2]
    send(again, kind="undo")
    assert again.caught == "The try before is on your sheet again."
    write(again)
    assert len(again.recordings) == 3
    assert again.save().name == "a_w01_2.json"
    assert pad(writer="w07").recordings == ()


@given(
    letters=st.lists(st.sampled_from(["a", "b", "i"]), min_size=1, max_size=4),
    runs=st.lists(st.booleans(), min_size=4, max_size=4),
)
@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_forget_leaves_no_byte_of_a_pupils_pads_and_all_of_others(tmp_path_factory, letters, runs):
    folder = tmp_path_factory.mktemp("notebook")
    others = {"a_w02.json": recording_json("w02"), "a_w01_notes.json": b"{}", "w01.json": b"{}"}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        for name, content in others.items():
            (folder / name).write_bytes(content)
        panel = pad(writer="w01")
        for letter, run_again in zip(letters, runs, strict=False):
            write(panel, letter)
            send(panel, kind="save")
            panel = pad(letter, writer="w01") if run_again else panel
            send(panel, kind="again")
        # After a restart nothing is in memory.
        forget("pad w01")
        (folder / ".ipynb_checkpoints").mkdir()
        copy = folder / ".ipynb_checkpoints" / "a_w01-checkpoint.json"
        copy.write_bytes(recording_json("w01"))
        panel = pad(writer="w01")
        send(panel, kind="forget")
        assert not copy.exists()
        assert {each.name for each in folder.glob("*.json")} == set(others)
        assert panel.kept.endswith("Of other pupils there are still: a_w02.json.")


def recording_json(writer):
    return recording_to_json(replace(recording_of("a"), writer=writer)).encode()


def test_forget_also_ends_a_robot_that_plans(panel):
    write(panel)

    async def forget_meanwhile():
        panel.write()
        send(panel, kind="forget")
        while panel.work["state"] == "working":
            await asyncio.sleep(0.01)

    asyncio.run(forget_meanwhile())
    assert panel.motion is None


def test_save_and_forget_without_ink_say_so(panel, folder):
    send(panel, kind="save")
    assert "Nothing is written" in panel.kept
    send(panel, kind="forget")
    assert panel.kept == "Everything is forgotten."
    assert list(folder.iterdir()) == []


def test_a_place_that_cannot_be_written_gets_a_sentence(panel, folder, monkeypatch):
    write(panel)
    monkeypatch.setattr("pathlib.Path.cwd", lambda: folder / "gone")
    send(panel, kind="save")
    assert "gone" in panel.kept
    assert "Saved" not in panel.kept


def test_a_recording_of_ones_own_is_a_try_of_its_letter(panel, tmp_path):
    write_json(dmp_teach.recording_of("b"), tmp_path / "b_w09.json")
    content = (tmp_path / "b_w09.json").read_bytes()
    browser.send(panel, {"kind": "file", "name": "b_w09.json", "n": 1}, content)
    assert panel.character == "b"
    assert panel.parts
    assert panel.recording.character == "b"
    stroke = dmp_teach.recording_of("a").strokes()[0]
    send(panel, rows_of(stroke))
    assert len(panel.recordings) == 2
    browser.send(panel, {"kind": "file", "name": "notes.csv", "n": 9}, b"milk,2\n")
    assert panel.work["state"] == "cannot"


def test_ink_of_ones_own_that_is_large_lies_within_a_larger_sheet(panel):
    panel.load(dmp_teach.Recording(*_large()))
    low, high = points(panel, "ink").min(axis=0), points(panel, "ink").max(axis=0)
    assert panel.sheet[0] <= low[0] + 1e-6
    assert panel.sheet[3] >= high[1] - 1e-6


def _large():
    t = np.linspace(0, 2, 241)
    return (
        t,
        np.column_stack([3 + 0.2 * np.cos(t), 5 + 0.3 * np.sin(t), 0 * t]),
        None,
        None,
        None,
        ((0, 241),),
    )


def test_pressure_of_a_pen_is_kept_and_that_of_a_mouse_is_not(panel):
    stroke = dmp_teach.recording_of("a").strokes()[0]
    send(panel, rows_of(stroke, pressure=0.8), pointer="pen")
    assert np.allclose(panel.recording.pressure, 0.8)
    send(panel, kind="again")
    send(panel, rows_of(stroke))
    assert panel.recording.pressure is None


def good():
    return rows_of(dmp_teach.recording_of("a").strokes()[0])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "came in pieces"),
        (b"12345", "came in pieces"),
        (np.full((5, 4), np.nan).tobytes(), "no numbers"),
        (np.zeros((100_000, 4)).tobytes(), "100000 points"),
        (good()[::-1].tobytes(), "ran backwards"),
        ((good() * 1e6).tobytes(), "away"),
    ],
)
def test_bad_input_gets_a_sentence_and_the_sheet_stays(panel, content, words):
    write(panel)
    before = panel.ink
    browser.send(panel, {"kind": "stroke", "n": 7}, memoryview(content))
    assert words in panel.caught
    assert panel.ink == before
    assert panel.answered == 7
    write(panel)
    assert len(panel.recordings) == 2


def test_a_stroke_that_comes_twice_or_too_late_is_left_out(panel):
    send(panel, good(), n=3)
    for number in (3, 2):
        send(panel, good(), n=number)
        assert "twice, or too late" in panel.caught
    assert len(panel.counts) == 1


def test_a_letter_of_very_many_strokes_ends_with_a_sentence(panel):
    for k in range(61):
        send(panel, [[k, 0.01, 0.01 + k / 1000, 0.5]])
    assert "at most 60 strokes" in panel.caught
    assert len(panel.counts) == 60


KINDS = st.sampled_from(["stroke", "undo", "again", "all", "close", "stop", "nonsense", None])
MESSAGES = st.tuples(
    KINDS, st.one_of(st.none(), st.integers(-5, 50), st.text(max_size=2)), st.binary(max_size=256)
)
PLACES = st.lists(st.tuples(*[st.floats(-2, 2) | st.floats()] * 4), max_size=8)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.one_of(MESSAGES, PLACES), max_size=8))
def test_no_message_ever_kills_the_panel(messages):
    panel = pad("i")
    for each in messages:
        if isinstance(each, tuple):
            browser.send(panel, {"kind": each[0], "n": each[1]}, memoryview(each[2]))
        else:
            send(panel, each)
    send(panel, kind="again", n=99)
    write(panel, "i")
    assert panel.counts
    assert len(panel.parts) == 4


def test_a_pad_takes_one_letter_and_an_accent_may_be_a_sign_of_its_own(panel):
    for wrong, words in (
        ("hello", r"teach.write_word\('hello'\)"),
        (5, "character is 5, but must be one letter"),
    ):
        with pytest.raises(RecordingError, match=words):
            pad(wrong)
        with pytest.raises(TraitError if wrong == 5 else RecordingError):
            panel.character = wrong
        assert panel.character == "a"
    assert pad("a\u0308").character == "\u00e4"
    assert pad("").sheet == pad(None).sheet != []


def test_a_letter_that_nobody_has_is_refused_by_name():
    with pytest.raises(TeachError, match="has no"):
        pad("☃")
