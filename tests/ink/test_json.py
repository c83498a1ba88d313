"""Our JSON keeps what it was given, or refuses it in a sentence."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.errors import PathError, RecordingError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.ink.recording import Recording
from dmp_teach.ink.recording_json import (
    read_json,
    recording_from_json,
    recording_to_json,
    write_json,
)

FILES = Path(__file__).parent / "files"
numbers = st.floats(-1e6, 1e6, allow_nan=False)
texts = st.none() | st.text(max_size=5)
pseudonyms = st.none() | st.sampled_from(["w01", "writer-1", "W7", "b_2", "pupil12345"])


@given(
    steps=st.lists(st.floats(1e-3, 1e6), min_size=1, max_size=8),
    begin=st.integers(0, 10**6),
    about=st.tuples(texts, pseudonyms, st.none() | numbers),
    data=st.data(),
)
def test_what_is_written_is_read_again_bit_for_bit(steps, begin, about, data):
    t = np.concatenate([[0.0], np.cumsum(np.round(steps, 3))])
    position = np.reshape(
        data.draw(st.lists(numbers, min_size=3 * len(t), max_size=3 * len(t))), (-1, 3)
    )
    strokes, force = (((0, len(t)),), t / t[-1]) if data.draw(st.booleans()) else (None, None)
    again = recording_from_json(
        recording_to_json(Recording(t, position, *about, strokes, force)).encode()
    )
    assert np.array_equal(again.t, t)
    assert np.array_equal(again.position, position)
    assert (again.character, again.writer, again.baseline) == about
    assert again.given_strokes == strokes
    assert again.pressure is None if force is None else np.array_equal(again.pressure, force)
    later = recording_from_json(recording_to_json(Recording(t + begin, position)).encode())
    assert later.t[0] == 0.0, "no clock is kept"
    assert np.allclose(later.t, t, atol=1e-9)


def test_a_letter_of_our_alphabet_is_the_same_after_a_trip_to_the_disk(tmp_path):
    once = recording_of("q")
    write_json(once, tmp_path / "q.json")
    again = read_json(tmp_path / "q.json")
    assert np.array_equal(again.t, once.t)
    assert np.array_equal(again.position, once.position)
    assert (again.character, again.writer, again.baseline) == ("q", once.writer, once.baseline)


REAL = [
    "Anna",
    "Anna Smith",
    "anna smith",
    "AnnaSmith",
    "a@b.de",
    "W",
    "2014-05-03",
    "anna-030514",
    "wilhelmine",
    "anna1",
    "w030514",
    "x" * 21,
    "",
    "é1",
    7,
]


@pytest.mark.parametrize("writer", REAL)
def test_names_addresses_and_dates_are_not_written(tmp_path, writer):
    t = np.arange(3.0)
    with pytest.raises(
        RecordingError, match=r"writer is .*, but must be a pseudonym such as 'w01'"
    ):
        write_json(Recording(t, np.zeros((3, 3)), "a", writer), tmp_path / "a.json")
    assert list(tmp_path.iterdir()) == []


GOOD = {
    "format": "dmp_teach recording",
    "version": 2,
    "character": "l",
    "writer": "writer-1",
    "baseline": 0.0,
    "units": {"t": "s", "x": "m", "y": "m", "z": "m"},
    "strokes": [[0, 3]],
    "pressure": [0.1, 0.5, 0.2],
    "samples": [[0.0, 0.0, 0.1, 0.0], [0.1, 0.0, 0.05, 0.0], [0.2, 0.0, 0.0, 0.0]],
}
ROW = [0.0, 0.0, 0.0, 0.0]
MALFORMED = {
    "another format": ({"format": "font"}, "'format' must be 'dmp_teach recording'"),
    "newer version": (
        {"version": 3},
        "version is 3, but this program reads version 1 and 2; update dmp_teach",
    ),
    "version 0": (
        {"version": 0},
        "version is 0, but this program reads version 1 and 2; save it again",
    ),
    "version as text": (
        {"version": "1"},
        "version is '1', but this program reads version 1 and 2; save it again",
    ),
    "version true": ({"version": True}, "version is True"),
    "a clock": (
        {"samples": [[1.7e9, 0, 0, 0]] * 3},
        "the first time is 1700000000.0, but must be 0: no clock is kept",
    ),
    "a heavy press": ({"pressure": [0, 1.5, 0]}, "pressure[1] is 1.5, but must be between 0 and 1"),
    "a name": ({"name": "Kim"}, "fields too many or too few: name;"),
    "a number for a letter": ({"character": 3}, "character is 3, but must be text or null"),
    "a list for a writer": ({"writer": ["x"]}, "writer is ['x'], but must be text or null"),
    "text for a baseline": ({"baseline": "0"}, "baseline is '0', but must be a number [m] or null"),
    "true for a baseline": ({"baseline": True}, "baseline is True"),
    "other units": ({"units": {"t": "ms"}}, "units is {'t': 'ms'}, but must be"),
    "strokes not pairs": (
        {"strokes": [[0, 1, 2]]},
        "strokes is [[0, 1, 2]], but must be pairs [start, end]",
    ),
    "strokes not whole": ({"strokes": [[0, 1.5]]}, "strokes is [[0, 1.5]], but must be pairs"),
    "strokes too long": ({"strokes": [[0, 9]]}, "given_strokes is ((0, 9),)"),
    "no strokes": ({"strokes": []}, "given_strokes is empty"),
    "pressure too short": (
        {"pressure": [0.1]},
        "pressure is [0.1], but must be null or one number for every sample",
    ),
    "pressure as text": ({"pressure": "hard"}, "pressure is 'hard'"),
    "samples no list": ({"samples": 7}, "samples is 7, but must be rows [t, x, y, z]"),
    "no samples": (
        {"samples": [], "pressure": None, "strokes": None},
        "A recording needs a clean path",
    ),
    "one sample": (
        {"samples": [ROW], "pressure": None, "strokes": None},
        "needs at least 2 samples",
    ),
    "a short row": (
        {"samples": [[0.0, 1.0]]},
        "samples[0] is [0.0, 1.0], but must be four finite numbers",
    ),
    "text in a row": (
        {"samples": [ROW, [0.4, "1", 0, 0]]},
        "samples[1] is [0.4, '1', 0, 0], but must be four",
    ),
    "null in a row": (
        {"samples": [ROW, [0.4, None, 0, 0]]},
        "samples[1] is [0.4, None, 0, 0], but must be four",
    ),
    "an endless number": (
        {"samples": [ROW, [10**400, 0, 0, 0]]},
        "but must be four finite numbers",
    ),
    "another planet": (
        {"samples": [ROW, [1, 0, 2e6, 0]]},
        "samples[1] is [1, 0, 2000000.0, 0], but must be at most 1",
    ),
    "time standing still": ({"samples": [ROW] * 3}, "times must increase"),
}


@pytest.mark.parametrize(("change", "sentence"), MALFORMED.values(), ids=MALFORMED)
def test_a_malformed_field_is_named(tmp_path, change, sentence):
    path = tmp_path / "l.json"
    path.write_text(json.dumps(GOOD | change))
    with pytest.raises(RecordingError) as caught:
        read_json(path)
    assert str(caught.value).startswith("l.json: ")
    assert sentence in str(caught.value)


@pytest.mark.parametrize("field", [name for name in GOOD if name not in ("format", "version")])
def test_a_missing_field_is_named(tmp_path, field):
    path = tmp_path / "l.json"
    path.write_text(json.dumps({name: value for name, value in GOOD.items() if name != field}))
    with pytest.raises(RecordingError, match=f"too few: {field};"):
        read_json(path)


@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize("writer", [name for name in REAL if isinstance(name, str)])
def test_names_addresses_and_dates_are_not_read(version, writer):
    content = GOOD | {"writer": writer, "version": version}
    recording = recording_from_json(json.dumps(content).encode())
    assert recording.writer is None
    assert writer not in repr(recording) or not writer


def test_a_good_file_is_read(tmp_path):
    path = tmp_path / "l.json"
    path.write_text(json.dumps(GOOD))
    recording = read_json(str(path))
    assert recording.given_strokes == ((0, 3),)
    assert recording.position.shape == (3, 3)
    assert recording.pressure.tolist() == [0.1, 0.5, 0.2]
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(GOOD, indent=4).replace("\n", "\r\n").encode())
    assert np.array_equal(read_json(path).position, recording.position), (
        "an editor's mark and line ends do no harm"
    )


def test_version_1_is_read_for_ever():
    """By the first program that wrote any; it began where it liked, its pressure meant nothing."""
    recording = read_json(FILES / "version_1.json")
    assert (recording.character, recording.writer, recording.baseline) == ("l", "writer-1", -0.01)
    assert recording.t.tolist() == [0.5, 0.6, 0.7]
    assert recording.position.tolist() == [
        [0.0, 0.1, 0.0],
        [0.001, 0.05, -0.0001],
        [0.0, 0.0, 0.002],
    ]
    assert recording.given_strokes == ((0, 3),)
    assert recording.pressure is None


def test_version_2_is_read_for_ever():
    recording = read_json(FILES / "version_2.json")
    assert (recording.character, recording.writer, recording.baseline) == ("i", "w01", 0.0)
    assert recording.t.tolist() == [0.0, 0.1, 0.2, 0.3, 0.4]
    assert recording.given_strokes == ((0, 2), (3, 5))
    assert recording.pressure.tolist() == [0.25, 0.5, 0.0, 1.0, 0.75]


NOT_JSON = {
    "text": (b"hello", "is not plain JSON"),
    "empty": (b"", "is empty"),
    "twice the same": (
        b'{"format": "x", "format": "dmp_teach recording"}',
        "a name occurs twice in one object",
    ),
    "UTF-16": (json.dumps(GOOD).encode("utf-16"), "is not plain JSON"),
    "NUL": (json.dumps(GOOD).encode() + b"\0", "is not plain JSON"),
    "an integer of 5000 digits": (b'{"format": ' + b"1" * 5000 + b"}", "is not plain JSON"),
    "half": (b'{"format": "dmp', "is not plain JSON"),
    "bytes": (b"\x80\x04\x95", "is not plain JSON"),
    "deep": (b"[" * 100_000, "is not plain JSON: more than 100 brackets"),
    "deep behind strings": (b'["\\"]]",' * 101, "more than 100 brackets"),
    "brackets in a string": (json.dumps("[" * 101).encode(), "'format' must be"),
    "nan": (json.dumps(GOOD | {"baseline": float("nan")}).encode(), "NaN is not a number"),
    "infinity": (
        json.dumps(GOOD | {"baseline": float("inf")}).encode(),
        "Infinity is not a number",
    ),
    "too large": (
        json.dumps(GOOD).replace('"baseline": 0.0', '"baseline": 1e999').encode(),
        "baseline is inf",
    ),
    "a list": (b"[]", "'format' must be 'dmp_teach recording'"),
}


@pytest.mark.parametrize(("content", "sentence"), NOT_JSON.values(), ids=NOT_JSON)
def test_a_file_of_another_kind_is_refused_in_a_sentence(tmp_path, content, sentence):
    path = tmp_path / "l.json"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=r"l\.json") as caught:
        read_json(path)
    assert sentence in str(caught.value)


@pytest.mark.parametrize("path", [3, None, b"a.json", ["a.json"]])
def test_a_path_must_be_a_path(path):
    with pytest.raises(RecordingError, match="must be the name of a file"):
        read_json(path)
    with pytest.raises(PathError, match="must be the name of a file"):
        write_json(recording_of("a"), path)


def test_places_that_could_not_be_read_again_are_not_written(tmp_path):
    with pytest.raises(
        RecordingError,
        match=r"the farthest place is 2000000\.0, but must be at most 1000000 m away",
    ):
        write_json(Recording([0.0, 1.0], [[0, 0, 0], [0, 2e6, 0]]), tmp_path / "a.json")


def test_only_a_recording_is_written(tmp_path):
    with pytest.raises(RecordingError, match="A dict cannot be written as ink; give a Recording"):
        write_json({}, tmp_path / "a.json")
