"""What studies take: recordings, their files, strokes; nothing means our own letters."""

from dataclasses import replace

import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.ink.recording_json import write_json
from dmp_teach.studies.inputs import list_letters, list_recordings, named_strokes
from tests.dmp.ink import letter


def test_recordings_files_and_strokes_are_all_letters(tmp_path):
    d = recording_of("D")
    write_json(d, tmp_path / "d.json")
    for given in ([d], d, [tmp_path / "d.json"], str(tmp_path / "d.json"), [d.strokes()]):
        (found,) = list_letters(given)
        assert [len(stroke) for stroke in found.strokes] == [len(stroke) for stroke in d.strokes()]
    assert list_letters(d)[0].name == f"D {d.writer}"
    letters = list_letters(d)
    assert list_letters(letters) == letters


def test_strokes_are_named_by_letter_writer_and_number():
    assert [each.name for each in named_strokes([recording_of("D")])] == [
        "D writer-1 1",
        "D writer-1 2",
    ]
    assert [each.name for each in named_strokes([letter()])] == ["? 1"]


def test_without_recordings_our_alphabets_are_taken():
    found = list_letters()
    assert {each.writer for each in found} == {"writer-1", "writer-2"}
    assert {"a", "b", "e", "m", "D"} <= {each.character for each in found}


def test_what_is_no_recording_is_named():
    with pytest.raises(RecordingError, match=r"recordings\[0\] is an int, but must be a recording"):
        list_letters([3])
    with pytest.raises(RecordingError, match="recordings is an int, but must be recordings"):
        list_letters(3)
    with pytest.raises(RecordingError, match="recordings is empty; give at least one"):
        list_letters([])


def test_a_folder_without_files_and_one_that_is_not_there_are_told_apart(tmp_path):
    (tmp_path / ".hidden").write_text("of the system")
    for labels in (None, "(?P<writer>q)"):
        with pytest.raises(RecordingError, match=r"The folder .* has no files"):
            list_recordings(tmp_path, labels)
        with pytest.raises(RecordingError, match="No such file"):
            list_recordings(tmp_path / "nowhere", labels)


def test_a_folder_is_labelled_by_the_pattern_of_its_names(tmp_path):
    bare = replace(recording_of("a"), character=None, writer=None)
    for name in ("aa_Kim", "D3_w07", "notes"):
        write_json(bare, tmp_path / f"{name}.json")
    found = list_recordings(tmp_path, r"^(?P<character>\w)\w*_(?P<writer>\w+)$")
    assert [(each.character, each.writer) for each in found] == [("D", "w07"), ("a", "writer-1")]
    assert len(list_recordings(tmp_path)) == 3
    with pytest.raises(RecordingError, match=r"labels is .* which notes\.json does not match"):
        list_recordings(tmp_path / "notes.json", "(?P<writer>q)")
    with pytest.raises(RecordingError, match=r"which D3_w07\.json, aa_Kim\.json.* does not match"):
        list_recordings(tmp_path, "(?P<writer>q)")
    (tmp_path / "README.md").write_text("Recorded on Monday.")
    with pytest.warns(UserWarning, match=r"Left out, as there is no ink in them: README\.md\."):
        assert len(list_recordings(tmp_path)) == 3
    for pattern in ("(", "a", "(?P<who>a)", 3):
        with pytest.raises(RecordingError, match="labels is "):
            list_recordings(tmp_path, pattern)
