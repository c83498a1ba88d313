"""The teacher's overview: what a folder of pupils' files says, whoever wrote them."""

import json
import os
import random
import time

import pytest

import dmp_teach as teach
from dmp_teach.errors import PathError, SettingError
from tests.test_hostile_text import TRAP, Dangers

STEPS = ("bet", "try", "challenge")
BETS = {"00": "5 40 400", "01": 7, "02": "lit all end back", "03": 7, "04": 6, "05": 9, "06": 2}
BETS |= {"07": "1 2 none", "08": 9, "09": 6, "10": 2, "11": "push step", "12": "spread-dmp"}


def lesson_work(bet, step="challenge", misses=0, passed=None):
    progress = {"step": step, "bet": bet, "revealed": True, "done": [], "hints": misses // 3}
    progress |= {"misses": misses, "verdict": None, "passed": passed, "saved_as": None}
    return {"variant": "", "values": {}, "progress": progress}


def save_work(folder, pupil, works, name=None):
    folder.mkdir(parents=True, exist_ok=True)
    content = {"format": "dmp_teach work", "version": 1, "pupil": pupil, "lessons": works}
    path = folder / (name or f"work_{pupil}.json")
    path.write_text(json.dumps(content))
    return path


def save_ink(folder, letter, writer, written=None, name=None):
    recording = teach.recording_of(written or letter)
    path = folder / (name or f"{letter}_{writer}.json")
    teach.write_recording(recording, path)
    path.write_text(
        json.dumps(json.loads(path.read_text()) | {"writer": writer, "character": letter})
    )
    return path


def bet_on(key, luck):
    """A bet: one of the options, or so many places."""
    if isinstance(BETS[key], str):
        return luck.choice(BETS[key].split())
    return [[x / 50, luck.uniform(0, 0.1)] for x in range(BETS[key])]


def fill_class(folder, n_pupils):
    """Write the work of pupils in all lessons; later lessons are harder."""
    luck = random.Random(3)
    for n in range(1, n_pupils + 1):
        works, reached = {}, luck.randint(4, 13)
        for key in list(BETS)[:reached]:
            step = "challenge" if int(key) < reached - 1 else luck.choice(STEPS)
            misses = luck.randint(0, int(key) + 1) if step == "challenge" else 0
            passed = {"a": 1} if step == "challenge" and luck.random() < 0.9 else None
            works[key] = lesson_work(bet_on(key, luck), step, misses, passed)
        save_work(folder, f"w{n:02d}", works)


def test_what_a_panel_saves_is_seen(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    panel = teach.lesson("01", pupil="w07").panel()
    panel.forget()
    panel.bet(panel.lesson.bet.handles.tolist())
    panel.go("challenge")
    panel.check()
    panel.values = panel.values | panel.lesson.solution
    assert panel.check().done
    panel.save()
    [record] = teach.class_overview(tmp_path).records("01")
    assert (record.step, record.misses, record.is_passed) == ("challenge", 1, True)
    assert record.bet == panel.progress["bet"]


def test_a_class_of_thirty_takes_seconds_and_says_who_is_where(tmp_path):
    fill_class(tmp_path, 30)
    begun = time.process_time()
    overview = teach.class_overview(tmp_path)
    text = overview.html(tmp_path / "class.html").read_text(encoding="utf-8")
    assert time.process_time() - begun < 5
    assert repr(overview) == "ClassOverview(30 pupils, 13 lessons, 0 notes)"
    assert [text.count(f">w{n:02d}<") for n in (1, 30)] == [1, 1]
    assert text.count("<section>") == 13
    page = Dangers(text)
    assert (page.scripts, page.found) == (0, [])
    assert "default-src 'none'" in page.policy


def test_letters_are_in_order_of_how_far_the_newest_tries_are(tmp_path):
    for writer in ("w01", "w02"):
        save_ink(tmp_path, "D", writer)
        save_ink(tmp_path, "a", writer)
        save_ink(tmp_path, "a", writer, written="o", name=f"a_{writer}_2.json")
    page = teach.class_overview(tmp_path)._repr_html_()
    letters = page[page.index("Which letters are hard") :]
    assert letters.index(">a<") < letters.index(">D<") < letters.index("0.0 mm")
    assert letters.index(">4<") < letters.index(">D<")


def test_checks_are_in_order_of_how_often_they_were_missed(tmp_path):
    works = {"01": lesson_work(None, misses=1), "03": lesson_work(None, misses=7)}
    save_work(tmp_path, "w01", works | {"05": lesson_work(None, "try")})
    save_work(tmp_path, "w02", {"03": lesson_work(None, misses=1, passed={})})
    page = teach.class_overview(tmp_path)._repr_html_()
    hard = page[page.index("Which checks") :]
    assert hard.index(">03<") < hard.index(">01<")
    assert ">05<" not in hard
    assert ">4.0<" in hard


def test_hostile_files_are_listed_and_neither_run_nor_show_markup(tmp_path):
    bad = lesson_work(None, misses=0)
    save_work(tmp_path, "w01", {"01": lesson_work(TRAP), TRAP: bad, "02": TRAP, "03": [[[]]]})
    save_work(tmp_path, "w02", {"03": lesson_work([[1e400, TRAP]] * 7), "00": lesson_work({})})
    save_work(tmp_path, TRAP, {}, name="work_<img src=x onerror=alert(1)>.json")
    save_work(tmp_path, "w03", TRAP)
    save_work(tmp_path, "w04", {"01": bad | {"progress": bad["progress"] | {"misses": -(10**9)}}})
    (tmp_path / "work_w05.json").write_text("[" * 100_000)
    (tmp_path / "work_w06.json").write_bytes(b"\xff\x00")
    with (tmp_path / "work_w07.json").open("wb") as file:
        file.truncate(10**10)
    outside = save_work(tmp_path.parent / "outside", "w08", {"01": bad})
    (tmp_path / "work_w08.json").symlink_to(outside)
    (tmp_path / "w09").symlink_to(outside.parent)
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "work_w10.json")
    (tmp_path / "a_w11.json").write_text('{"format": "dmp_teach recording"}')
    save_ink(tmp_path, TRAP, "w12", written="a", name="b_w12.json")
    overview = teach.class_overview(tmp_path)
    assert {each.name for each in overview.pupils} <= {"w01", "w02", "w04", "w12"}
    told = "\n".join(overview.notes)
    for name in ("w03", "<img src", "w04", "w05", "w06", "w07", "w08", "w11"):
        assert name in told
    # Nobody's faults crowd out those of the others.
    assert sum("work_w01" in note for note in overview.notes) == 1
    page = overview._repr_html_()
    assert "<img" not in page
    assert (Dangers(page).scripts, Dangers(page).found) == (0, [])


def test_a_hub_and_a_stick_have_a_folder_for_each_pupil(tmp_path):
    for home in ("w07", "w08"):
        save_work(tmp_path / home / "lessons", "w01", {"01": lesson_work(None, "bet")})
    save_work(tmp_path / "w07" / "lessons" / ".ipynb_checkpoints", "w02", {})
    for home in ("bag", "box"):
        save_work(tmp_path / home, "w02", {"01": lesson_work(None, "try")})
    overview = teach.class_overview(str(tmp_path))
    assert [each.name for each in overview.pupils] == ["w02", "w02 (2)", "w07", "w08"]
    assert "bag, box" in "".join(overview.notes)


def test_forgetting_a_pupil_leaves_no_byte(tmp_path):
    fill_class(tmp_path, 4)
    copies = tmp_path / ".ipynb_checkpoints"
    save_work(copies, "w03", {}, name="work_w03-checkpoint.json")
    save_work(tmp_path, "w03", {}, name="work_of_w03 (1).json")
    for name in ("a_w03.json", "a_w03_2.json", ".ipynb_checkpoints/a_w03-checkpoint.json"):
        save_ink(tmp_path, "a", "w03", name=name)
    others = {path for path in tmp_path.glob("*.json") if "w03" not in path.name}
    overview = teach.class_overview(tmp_path).forget("w03")
    assert [each.name for each in overview.pupils] == ["w01", "w02", "w04"]
    assert {path for path in tmp_path.rglob("*") if path.is_file()} == others
    assert ">w03<" not in overview._repr_html_()
    with pytest.raises(SettingError, match="w01, w02, w04"):
        overview.forget("w03")


def test_a_folder_that_is_none_is_told(tmp_path):
    for none in (tmp_path / "none", 3, None, "a" * 5000, "\0", "~nobody_of_that_name"):
        with pytest.raises(PathError, match="no folder"):
            teach.class_overview(none)
    assert "0 pupils" in repr(teach.class_overview(tmp_path))
    assert "0 pupils" in teach.class_overview(tmp_path)._repr_html_()
