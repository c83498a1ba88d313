"""What a pupil saves is one file, and *Forget* leaves none."""

import json
import sys

import pytest

import dmp_teach as teach
from dmp_teach.classroom import LessonPanel
from dmp_teach.classroom.lesson.progress import begin_progress
from dmp_teach.classroom.panels.kept import forget
from dmp_teach.errors import SettingError
from dmp_teach.lessons import lessons
from tests.classroom.browser import send


def worked(pupil):
    """A panel in which something was done."""
    panel = teach.lesson("03", pupil=pupil).panel()
    panel.forget()
    panel.bet([[x, y / 2] for x, y in panel.lesson.bet.handles.tolist()])
    panel.go("try")
    panel.values = panel.values | {"kernel_width": 0.5}
    return panel


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_nothing_is_written_before_save_and_one_file_after(folder):
    panel = worked("w07")
    assert list(folder.iterdir()) == []
    for _ in range(2):
        panel.save()
    assert [path.name for path in folder.iterdir()] == ["work_w07.json"]
    assert set(json.loads((folder / "work_w07.json").read_text())["lessons"]) == {"03"}


def test_work_is_taken_up_after_a_restart(folder):
    panel = worked("w07")
    panel.save()
    # The kernel's memory goes with it.
    forget("lesson w07 03")
    again = teach.lesson("03", pupil="w07").panel()
    assert (again.values, again.progress["bet"]) == (panel.values, panel.progress["bet"])
    assert again.progress["step"] == "try"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot limit the size of a file")
def test_on_a_full_disk_what_was_saved_stays_and_a_sentence_is_said(folder):
    import resource  # noqa: PLC0415 (Windows has none)

    panel = worked("w07")
    before = panel.save().read_bytes()
    panel.values = panel.values | {"kernel_width": 0.8}
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) // 2, limits[1]))
    try:
        send(panel, {"kind": "save"})
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert "Saved" not in panel.status
    assert "work_w07.json" in panel.status
    assert [path.read_bytes() for path in folder.iterdir()] == [before]
    send(panel, {"kind": "save"})
    assert (folder / "work_w07.json").read_bytes() != before


@pytest.mark.parametrize("pupil", ["w07", None])
def test_forget_leaves_no_byte(folder, pupil):
    panel = worked(pupil)
    path = panel.save()
    (folder / ".ipynb_checkpoints").mkdir()
    copy = folder / ".ipynb_checkpoints" / f"{path.stem}-checkpoint.json"
    copy.write_bytes(path.read_bytes())
    others = folder / "work_w09.json"
    others.write_text(path.read_text().replace('"w07"', '"w09"').replace('"w01"', '"w09"'))
    panel.forget()
    assert sorted(each.name for each in folder.rglob("*.json")) == ["work_w09.json"]
    assert panel.progress["bet"] is None


@pytest.mark.parametrize("content", ["", "[]", '{"format": "another"}', "{"])
def test_a_file_that_is_not_ours_is_told_and_left_alone(folder, content):
    panel = worked("w07")
    mine = folder / "work_w07.json"
    mine.write_text(content)
    with pytest.raises(teach.RecordingError, match=r"work_w07\.json"):
        panel.save()
    assert mine.read_text() == content


def test_a_pupil_is_a_pseudonym():
    with pytest.raises(teach.TeachError, match="pupil is 'Anna Schmidt'"):
        teach.lesson("03", pupil="Anna Schmidt")


def test_saved_work_that_does_not_fit_the_lesson_begins_afresh(folder):
    path = worked("w07").save()
    path.write_text(path.read_text().replace('"kernel_width": 0.5', '"kernel_width": 500'))
    forget("lesson w07 03")
    panel = teach.lesson("03", pupil="w07").panel()
    assert isinstance(panel, LessonPanel)
    assert panel.values == panel.lesson.start


def test_forget_takes_damaged_files_and_copies_too(folder):
    panel = worked("w07")
    panel.save()
    whole = (folder / "work_w07.json").read_text()
    (folder / "work_w07-Copy1.json").write_text(whole)
    (folder / "work_w07.json").write_text(whole[:200])
    (folder / "work_w070.json").write_text(whole)
    panel.forget()
    assert [path.name for path in folder.iterdir()] == ["work_w070.json"]


def test_forget_reaches_every_panel_and_every_lesson_of_the_pupil():
    first = worked("w07")
    second = teach.lesson("03", pupil="w07").panel()
    other = teach.lesson("01", pupil="w07").panel()
    other.bet([[x, y / 2] for x, y in other.lesson.bet.handles.tolist()])
    first.forget()
    second.go("challenge")
    assert second.progress["bet"] is None
    assert teach.lesson("01", pupil="w07").panel().progress["bet"] is None


def test_two_panels_of_a_lesson_share_the_bet():
    early = teach.lesson("03", pupil="w07").panel()
    bet = worked("w07").progress["bet"]
    early.go("try")
    assert early.progress["bet"] == bet


def test_who_gave_no_name_cannot_forget_another_pupils_file(folder):
    worked("w03").save()
    stranger = worked(None)
    saved = {**begin_progress(), "saved_as": "w03"}
    work = {"variant": "", "values": stranger.lesson.start, "progress": saved}
    stranger.forget()
    send(stranger, {"kind": "restore", "work": work})
    stranger.forget()
    assert (folder / "work_w03.json").exists()


WHOLE = {"variant": "", "values": None, "progress": begin_progress()}
HOSTILE = [None, 5, [], {}, {**WHOLE, "progress": None}, {**WHOLE, "variant": "w01"}]
# What a lesson itself judges; the frame judges the rest, alike in every lesson.
OF_LESSON = ("bet", "done", "hints", "passed")


def hostile(names):
    for value in ("x", 2.5, [], {}, [{}], ["a", 1], -1, 10**400, "x/../../y", "Anna Meier"):
        for name in names:
            yield {**WHOLE, "progress": WHOLE["progress"] | {name: value}}


@pytest.mark.parametrize("key", list(lessons()))
def test_nothing_that_a_browser_sends_breaks_a_panel(key):
    panel = teach.lesson(key).panel()
    for work in [*HOSTILE, *hostile(WHOLE["progress"] if key == "03" else OF_LESSON)]:
        panel.forget()
        values = panel.lesson.start if work and isinstance(work, dict) else None
        sent = {**work, "values": values} if isinstance(work, dict) else work
        send(panel, {"kind": "restore", "work": sent})
        panel.go("challenge")
        panel.check()
    for message in ({"kind": "bet"}, {"kind": "step"}, {"kind": "step", "step": []}):
        send(panel, message)
    for bet in ("x", [["a", "b"]] * 7, [[0, 0]] * 7, [[1e308, 1e308]] * 7, [[-5.0, -5.0]] * 9):
        send(panel, {"kind": "bet", "bet": bet})
        panel.reveal()
        assert "nan" not in panel.card["bet"]


def test_a_value_that_the_browser_sends_beyond_its_knob_leaves_the_old_one():
    panel = teach.lesson("04").panel()
    before = panel.values
    for values in ({}, {"n_kernels": 81, "rate": "120"}, {"n_kernels": 10**400, "rate": "120"}):
        with pytest.raises(SettingError):
            panel.set_state({"values": values})
        assert panel.values == before
        panel.check()
