"""What a pupil saves is one file, and *Forget* leaves none."""

import json

import pytest

import dmp_teach as teach
from dmp_teach.classroom import LessonPanel
from dmp_teach.classroom.panels.kept import forget


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
    forget("lesson 03 w07")
    again = teach.lesson("03", pupil="w07").panel()
    assert (again.values, again.progress["bet"]) == (panel.values, panel.progress["bet"])
    assert again.progress["step"] == "try"


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
    mine = folder / "work_w07.json"
    mine.write_text(content)
    panel = worked("w07")
    with pytest.raises(teach.RecordingError, match=r"work_w07\.json"):
        panel.save()
    assert mine.read_text() == content


def test_a_pupil_is_a_pseudonym():
    with pytest.raises(teach.TeachError, match="Anna Schmidt"):
        teach.lesson("03", pupil="Anna Schmidt")


def test_saved_work_that_does_not_fit_the_lesson_begins_afresh(folder):
    path = worked("w07").save()
    path.write_text(path.read_text().replace('"kernel_width": 0.5', '"kernel_width": 500'))
    forget("lesson 03 w07")
    panel = teach.lesson("03", pupil="w07").panel()
    assert isinstance(panel, LessonPanel)
    assert panel.values == panel.lesson.start
