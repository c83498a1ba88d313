"""The still picture of a panel: it shows what is seen, and nothing that a pupil has written."""

import re
from base64 import b64decode

import pytest

import dmp_teach
from dmp_teach.errors import RecordingError


def picture(panel):
    return b64decode(re.search(r"base64,([^\"]+)", panel.draw_still().html()).group(1)).decode()


def test_the_dots_the_line_the_number_and_the_sentence_of_a_letter_are_there():
    panel = dmp_teach.explore("D")
    before = picture(panel)
    assert before.count("<polyline") == 4, "two strokes of the person, two of the robot"
    assert panel.message["number"] in panel.draw_still().html()
    assert panel.message["strong"] in panel.draw_still().html()
    panel.n_kernels = 5
    assert picture(panel) != before
    text = panel._repr_mimebundle_()[0]["text/plain"]
    assert text.startswith("The letter D")
    assert panel.message["text"] in text


def test_of_a_recording_of_ones_own_there_is_no_ink():
    panel = dmp_teach.explore(dmp_teach.recording_of("a"))
    assert "<polyline" not in picture(panel)
    panel.letter = "a"
    assert "<polyline" in picture(panel)


def test_of_what_is_written_on_the_pad_nothing_is_there():
    panel = dmp_teach.pad("e")
    before = panel.draw_still()
    for stroke in dmp_teach.recording_of("a").strokes():
        rows = zip(stroke.t, stroke.position, strict=True)
        panel.add_stroke([(t, x, y, 0.5) for t, (x, y) in rows])
    assert panel.title not in panel.draw_still().html()
    assert panel.draw_still().html() == before.html()
    assert picture(panel).count("<polyline") == 1, "the robot's own"
    assert "<polyline" not in picture(dmp_teach.pad(None))


def test_a_letter_is_opened_by_its_name_and_what_is_none_is_a_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert dmp_teach.explore("e").letter == "e"
    assert dmp_teach.explore("e\u0301").letter == "é"
    with pytest.raises(RecordingError, match="No such file"):
        dmp_teach.explore("ee")
