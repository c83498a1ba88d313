"""A panel as a page of its own: it loads nothing, escapes everything, and holds no pupil's data."""

import gzip
import json
import re
from base64 import b64decode

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.classroom.lesson.bets import DrawnBet, LessonState
from dmp_teach.classroom.lesson.packing import pack
from dmp_teach.errors import PathError, RecordingError
from dmp_teach.lessons import lessons
from tests.classroom.browser import send


def page_of(panel, folder):
    return panel.html(folder / "page.html").read_text(encoding="utf-8")


def state_of(page):
    packed = re.search(r'id="state">([^<]+)<', page).group(1)
    return json.loads(gzip.decompress(b64decode(packed)))


@pytest.mark.parametrize("make", [teach.explore, lambda: teach.lesson("05").panel()])
def test_a_page_loads_nothing_and_evaluates_nothing(make, tmp_path):
    page = page_of(make(), tmp_path)
    assert len(page) < 400_000
    assert "default-src 'none'" in page
    assert "unsafe-eval" not in page
    assert set(re.findall(r"\w+://[^\s\"'`)]*", page)) <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"\b(eval|Function|fetch|XMLHttpRequest|WebSocket)\(", page)
    assert page.count("</script>") == 2, "the state and the script"


def test_every_text_of_a_page_is_escaped(tmp_path):
    panel = teach.explore()
    panel.title = trap = '"></title><script>alert(1)</script>'
    page = page_of(panel, tmp_path)
    assert trap not in page
    assert state_of(page)["title"] == trap


@pytest.mark.parametrize("key", lessons())
def test_of_a_pupil_the_page_of_a_lesson_holds_nothing(key, tmp_path):
    fresh = teach.lesson(key, pupil="w07").panel()
    before = state_of(page_of(fresh, tmp_path))
    assert "w07" not in json.dumps(before).split('"')
    bet = fresh.lesson.bet
    fresh.bet(
        list(bet.options)[-1] if hasattr(bet, "options") else np.add(bet.handles, 0.1).tolist()
    )
    fresh.reveal()
    fresh.go("try")
    fresh.values = fresh.values | fresh.lesson.solution
    fresh.check()
    assert state_of(page_of(fresh, tmp_path)) == before
    assert before["progress"]["bet"] is None


@pytest.mark.parametrize("key", lessons())
def test_the_truth_is_drawn_alike_whatever_line_was_drawn_as_a_bet(key):
    """A page has it before there is a bet, which the browser draws."""
    lesson = teach.lesson(key)
    bet = lesson.bet
    if not isinstance(bet, DrawnBet):
        return
    others = [np.add(bet.handles, i).tolist() for i in (0, 1)]
    drawn = [lesson.draw(LessonState(lesson.start, "bet", each, True)) for each in others]
    assert len({str(pack([each.sheet, each.plots])) for each in drawn}) == 1


def test_a_recording_that_was_opened_in_the_browser_is_written_nowhere(tmp_path):
    teach.write_recording(teach.recording_of("e"), tmp_path / "e.json")
    chosen = teach.explore(tmp_path / "e.json")
    assert state_of(page_of(chosen, tmp_path))["demo"], "a teacher's own choice"
    content = (tmp_path / "e.json").read_bytes()
    chosen.letter = "a"
    send(chosen, {"kind": "file", "name": "e.json"}, content)
    path = tmp_path / "own.html"
    with pytest.raises(RecordingError, match=r"explore\(recording\)"):
        chosen.html(path)
    assert not path.exists()
    chosen.letter = "a"
    chosen.html(path)


def test_a_path_that_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(PathError, match="must end with"):
        teach.explore().html(tmp_path / "a.txt")
    with pytest.raises(PathError, match="null"):
        teach.explore().html(tmp_path / "\0.html")
    assert not list(tmp_path.iterdir())
