"""The work folder: what a pupil has changed stays, the rest follows ours, and nothing is lost."""

import json
from pathlib import Path

import pytest

from dmp_teach.launcher.work import copy_lessons, title_of

START, WIDTH, OWN = "00_start_here.ipynb", "03_bump_width.ipynb", "teachers_own.ipynb"


def write(path, *sources):
    cells = [
        {"cell_type": "code", "id": f"c{n}", "metadata": {}, "source": [text], "outputs": []}
        for n, text in enumerate(sources)
    ]
    path.write_text(json.dumps({"cells": cells, "metadata": {}, "nbformat": 4}))


def sources(path):
    return ["".join(cell["source"]) for cell in json.loads(path.read_text())["cells"]]


@pytest.fixture
def folders(tmp_path):
    ours = tmp_path / "notebooks"
    ours.mkdir()
    for name in (START, WIDTH, OWN):
        write(ours / name, name)
    return ours, tmp_path / "work"


def test_every_notebook_is_copied_under_a_strip_of_the_lessons(folders):
    ours, work = folders
    assert copy_lessons(ours, work) == []
    assert sources(work / WIDTH) == [
        "[00 Start here](00_start_here.ipynb) · **03 Bump width**",
        WIDTH,
    ]
    assert sources(work / OWN) == [OWN]
    assert sources(ours / WIDTH) == [WIDTH]
    assert title_of(WIDTH) == "03 Bump width"


def test_an_untouched_copy_follows_ours_and_a_changed_one_stays_and_is_named(folders):
    ours, work = folders
    copy_lessons(ours, work)
    write(work / WIDTH, "mine")
    assert copy_lessons(ours, work) == []
    write(ours / START, "new")
    write(ours / WIDTH, "new")
    assert copy_lessons(ours, work) == [WIDTH]
    assert copy_lessons(ours, work) == [WIDTH]
    assert sources(work / START)[1:] == ["new"]
    assert sources(work / WIDTH) == ["mine"]


def test_a_cell_that_was_run_is_no_change_and_its_output_stays(folders):
    ours, work = folders
    copy_lessons(ours, work)
    notebook = json.loads((work / START).read_text())
    notebook["cells"][1]["outputs"] = [{"output_type": "stream", "text": "seen"}]
    (work / START).write_text(json.dumps(notebook))
    copy_lessons(ours, work)
    assert "seen" in (work / START).read_text()
    write(ours / START, "new")
    assert copy_lessons(ours, work) == []
    assert sources(work / START)[1:] == ["new"]


@pytest.mark.parametrize("content", [b"", b"\xff", b"[]", b'{"cells": [{}]}', b'{"cells": "a"}'])
def test_a_copy_that_cannot_be_read_stays(folders, content):
    ours, work = folders
    work.mkdir()
    (work / START).write_bytes(content)
    assert copy_lessons(ours, work) == [START]
    assert (work / START).read_bytes() == content


def test_a_lesson_begins_anew_and_what_was_changed_is_kept_aside_however_often(folders):
    ours, work = folders
    for text in ("first", "second", "third"):
        copy_lessons(ours, work)
        write(work / START, text)
        write(work / WIDTH, "mine")
        assert copy_lessons(ours, work, fresh=["00"]) == []
        assert sources(work / START)[1:] == [START]
    kept = sorted(sources(path) for path in (work / "earlier").glob("00_start_here_*.ipynb"))
    assert kept == [["first"], ["second"], ["third"]]
    assert sources(work / WIDTH) == ["mine"]
    copy_lessons(ours, work, fresh=[""])
    assert sources(work / WIDTH)[1:] == [WIDTH]
    assert len(list((work / "earlier").iterdir())) == 4


def test_a_pupils_own_notebooks_are_left_alone(folders):
    ours, work = folders
    work.mkdir()
    write(work / "mine.ipynb", "mine")
    copy_lessons(ours, work, fresh=[""])
    assert sources(work / "mine.ipynb") == ["mine"]


@pytest.mark.parametrize("content", [b"", b"{", b"[]", b"null", b"\xff", b'{"a": "b'])
def test_without_a_sound_record_whatever_differs_counts_as_changed(folders, content):
    ours, work = folders
    copy_lessons(ours, work)
    write(work / START, "mine")
    write(ours / WIDTH, "new")
    (work / ".lessons.json").write_bytes(content)
    assert copy_lessons(ours, work) == [START, WIDTH]
    assert sources(work / START) == ["mine"]
    assert sources(work / WIDTH)[1:] == [WIDTH]
    write(ours / OWN, "new")
    assert copy_lessons(ours, work) == [START, WIDTH], "the record is sound again"
    assert sources(work / OWN) == ["new"]


@pytest.mark.parametrize("name", [".lessons.json", START])
def test_a_write_that_stops_halfway_leaves_the_file_as_it_was(folders, monkeypatch, name):
    ours, work = folders
    copy_lessons(ours, work)
    before = (work / name).read_bytes()
    write(ours / "04_new.ipynb", "new")
    whole = Path.write_text

    def write_half(path, text, **how):
        half = path.name.startswith(name)
        whole(path, text[: len(text) // 2] if half else text, **how)
        if half:
            raise OSError

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_text", write_half)
        with pytest.raises(OSError):  # noqa: PT011 (a full disk may say anything)
            copy_lessons(ours, work)
    assert (work / name).read_bytes() == before
    assert not list(work.glob("*.part"))
    assert copy_lessons(ours, work) == []
    assert sources(work / START)[0].endswith("[04 New](04_new.ipynb)")


def test_the_strip_of_every_copy_follows_new_lessons_and_nothing_else_in_it_changes(folders):
    ours, work = folders
    copy_lessons(ours, work)
    changed = json.loads((work / START).read_text())
    changed["cells"][1] |= {"source": ["mine ", "é"], "outputs": [{"text": "seen"}]}
    changed["cells"] = changed["cells"][::-1]
    (work / START).write_text(json.dumps(changed))
    write(ours / "04_new.ipynb", "new")
    assert copy_lessons(ours, work) == []
    links = "[00 Start here](00_start_here.ipynb) · **03 Bump width** · [04 New](04_new.ipynb)"
    assert sources(work / WIDTH) == [links, WIDTH]
    assert sources(work / START)[1].endswith("[04 New](04_new.ipynb)")
    changed["cells"][1]["source"] = [sources(work / START)[1]]
    assert json.loads((work / START).read_text()) == changed
    before = (work / START).stat().st_mtime_ns
    copy_lessons(ours, work)
    assert (work / START).stat().st_mtime_ns == before, "a strip of today is not written again"
