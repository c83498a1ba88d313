"""Laws of every format: what is written is read again, and what is in a file decides."""

import os
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dmp_teach.errors import PathError, RecordingError
from dmp_teach.formats.read import read_recording, read_recordings
from dmp_teach.formats.registry import known_formats
from dmp_teach.formats.write import write_recording
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.ink.pen_lifts import add_lifts
from dmp_teach.ink.recording import Recording
from dmp_teach.letters.letter import Letter
from dmp_teach.trajectory import Trajectory
from tests.formats.ink_files import d_inkml, loop, mat, uci
from tests.formats.motive_csv import Pen, bar, lab, motive

WRITTEN = [each.suffixes[0] for each in known_formats() if each.write]
README = Path(__file__).parents[2] / "README.md"
TOLERANCE = {
    ".json": (0.0, 0.0, 0.0),
    ".inkml": (1e-7, 1e-6, 1e-6),
}  # places [m], times [s], pressure
coordinate = st.floats(-0.2, 0.2).map(lambda value: round(value, 9))


@st.composite
def recordings(draw):
    """One to three strokes anywhere on a page, with pressure or without."""
    strokes, pressures, clock = [], [], draw(st.floats(0, 100))
    for _ in range(draw(st.integers(1, 3))):
        steps = draw(st.lists(st.floats(0.002, 0.1), min_size=2, max_size=8))
        xy = draw(
            st.lists(st.tuples(coordinate, coordinate), min_size=len(steps), max_size=len(steps))
        )
        strokes.append(Trajectory(clock + np.cumsum(steps), xy))
        pressures.append(
            np.array(draw(st.lists(st.floats(0, 1), min_size=len(steps), max_size=len(steps))))
        )
        clock = strokes[-1].t[-1] + draw(st.floats(0.01, 1))
    about = {"character": draw(st.none() | st.sampled_from(["a", "Ö", "&", "<", "ß", '"', "ab"]))}
    about |= {
        "writer": draw(st.sampled_from([None, "w01"])),
        "baseline": draw(st.none() | coordinate),
    }
    return add_lifts(strokes, pressures if draw(st.booleans()) else None, **about)


@pytest.mark.parametrize("suffix", TOLERANCE)
@settings(max_examples=40, deadline=None)
@given(once=recordings())
def test_strokes_times_and_pressure_come_back(tmp_path_factory, suffix, once):
    ink = np.vstack([stroke.position for stroke in once.strokes()])
    if np.ptp(ink, axis=0).max() < 0.001:
        return
    trip = tmp_path_factory.mktemp("trip") / f"a{suffix}"
    again = read_recording(write_recording(once, trip))
    places, times, force = TOLERANCE[suffix]
    assert (again.character, again.writer) == (once.character, once.writer)
    assert again.baseline == pytest.approx(once.baseline, abs=places)
    assert (again.pressure is None) == (once.pressure is None)
    begin = once.strokes()[0].t[0]
    for one, other, span, new in zip(
        once.strokes(), again.strokes(), once.given_strokes, again.given_strokes, strict=True
    ):
        assert np.allclose(one.position, other.position, rtol=0, atol=places + 1e-12)
        assert np.allclose(one.t - begin, other.t, rtol=0, atol=times + 1e-9)
        if force is not None and once.pressure is not None:
            assert np.allclose(
                once.pressure[slice(*span)], again.pressure[slice(*new)], rtol=0, atol=force
            )


@pytest.mark.parametrize("suffix", WRITTEN)
def test_a_letter_that_was_learned_is_written_like_a_recording(tmp_path, suffix):
    strokes = Letter.learn(recording_of("D")).write(goal_shifts={1: (0.02, 0.0)})
    again = read_recording(write_recording(strokes, tmp_path / f"d{suffix}"))
    assert len(again.strokes()) == 2
    for one, other in zip(strokes, again.strokes(), strict=True):
        assert np.allclose(one.position[[0, -1]], other.position[[0, -1]], atol=1e-6)
    alone = read_recording(write_recording(strokes[0], tmp_path / f"d{suffix}"))
    assert len(alone.strokes()) == 1


@pytest.mark.parametrize("suffix", [".inkml", ".svg"])
def test_what_is_written_is_well_formed_and_says_nothing_of_people(tmp_path, suffix):
    odd = Recording(np.arange(3.0) + 1.7e9, np.eye(3) / 10, "<\0&\ud800\"'>", "w01", 0.0, ((0, 3),))
    text = write_recording(odd, tmp_path / f"a{suffix}").read_text(encoding="utf-8")
    ElementTree.fromstring(text)
    assert "17000" not in text, "no clock is kept"
    assert read_recording(tmp_path / f"a{suffix}").writer == "w01"


LABELS = [
    "by",
    "a by w02",
    " ",
    "",
    "a\u0308",
    "\u200d",
    "x" * 50,
    "two words",
    "\tx\r\n",
    "]]>&lt;\"'",
    "\U0001f600",
    None,
]
text = st.text(
    st.characters(exclude_categories=["Cs"], min_codepoint=0x20, exclude_characters="\ufffe\uffff")
)


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(label=st.sampled_from(LABELS) | text, writer=st.sampled_from(["w01", "b_2", None]))
def test_every_label_comes_back_as_it_was(tmp_path, label, writer):
    once = replace(recording_of("l"), character=label, writer=writer)
    for suffix in WRITTEN:
        again = read_recording(write_recording(once, tmp_path / f"l{suffix}"))
        assert (again.character, again.writer) == (label, writer)


def test_a_label_loses_only_what_no_xml_can_hold(tmp_path):
    for suffix in (".inkml", ".svg"):
        path = write_recording(
            replace(recording_of("l"), character="\0a\ud800\x1f\ufffe"), tmp_path / f"l{suffix}"
        )
        assert read_recording(path).character == "?a???"


@pytest.mark.parametrize("suffix", [".inkml", ".svg"])
def test_ink_that_no_reader_takes_for_a_letter_is_not_written(tmp_path, suffix):
    once = recording_of("l")
    dot = replace(once, position=np.zeros_like(once.position), given_strokes=((0, len(once.t)),))
    sentence = rf"cannot be written as {suffix}: the ink is 0 m large.*A \.json file keeps any"
    with pytest.raises(RecordingError, match=sentence):
        write_recording(dot, tmp_path / f"l{suffix}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", [".inkml", ".svg"])
def test_ink_stays_where_it_is_however_far(tmp_path, suffix):
    once = recording_of("l")
    far = replace(once, position=once.position + np.array([100.0, 0.0, 0.0]))
    again = read_recording(write_recording(far, tmp_path / f"l{suffix}"))
    assert np.allclose(again.position[0, :2], far.strokes()[0].position[0], atol=2e-6)


@pytest.mark.parametrize("suffix", WRITTEN)
@pytest.mark.parametrize("began", [41_000.25, 1.7e9])  # seconds since midnight, and since 1970
def test_no_time_of_day_is_written(tmp_path, suffix, began):
    D = recording_of("D")
    late = replace(D, t=D.t + began)
    path = write_recording(late, tmp_path / f"d{suffix}")
    same = write_recording(D, tmp_path / f"same{suffix}")
    assert max(map(float, re.findall(r"\d+\.?\d*(?!\w)", path.read_text()))) < 1e4
    if suffix == ".svg":
        assert path.read_bytes() == same.read_bytes()


def test_what_is_in_a_file_decides_and_not_its_name(tmp_path):
    t, page = Pen().rest(0.5).draw(bar()).fly((0.2, 0.0), 0.1, 0.5).sampled()
    files = {
        "inkml": d_inkml().encode(),
        "mat": mat(uci([loop()], labels=(1,))),
        "csv": motive(tmp_path / "x", t, lab(page)).read_bytes(),
    }
    for suffix in ("json", "svg"):
        files[suffix] = write_recording(recording_of("l"), tmp_path / f"l.{suffix}").read_bytes()
    for kind, data in files.items():
        for name in (
            "a",
            "a.txt",
            "a.csv",
            *(() if kind == "csv" else ("a.json", "a.mat", "a.svg")),
        ):
            (tmp_path / name).write_bytes(data)
            assert len(read_recordings(tmp_path / name)) == 1


def test_the_readme_names_every_format():
    text = README.read_text(encoding="utf-8")
    assert [each.name for each in known_formats() if f"{each}" not in text] == []


def test_a_file_is_labelled_with_what_it_does_not_say(tmp_path):
    bare = replace(recording_of("a"), character=None, writer=None)
    path = write_recording(bare, tmp_path / "take 7.json")
    read = read_recording(path, character="a", writer="w03")
    assert (read.character, read.writer) == ("a", "w03")
    said = write_recording(recording_of("l"), tmp_path / "take 8.json")
    with pytest.raises(
        RecordingError, match=r"character is 'a', but take 8\.json says 'l'.*which="
    ):
        read_recording(said, character="a")
    with pytest.raises(RecordingError, match="writer is 3, but must be text"):
        read_recording(path, writer=3)


def test_files_of_one_letter_are_chosen_from_like_any_other(tmp_path):
    path = write_recording(recording_of("l"), tmp_path / "l.json")
    assert read_recording(path, which="l", number=0).character == "l"
    with pytest.raises(RecordingError, match=r"l\.json has no 'a'; it holds 'l'\."):
        read_recording(path, which="a")
    with pytest.raises(RecordingError, match=r"number is 1, but l\.json has the letters 0 to 0"):
        read_recording(path, number=1)


def test_a_folder_that_is_not_there_cannot_be_written_to(tmp_path):
    with pytest.raises(PathError, match=r"There is no folder .*nowhere"):
        write_recording(recording_of("l"), tmp_path / "nowhere" / "l.json")


def test_home_is_where_the_user_says(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    write_recording(recording_of("l"), "~/l.json")
    assert (tmp_path / "l.json").is_file()
    assert read_recording("~/l.json").character == "l"


def test_only_ordinary_files_are_read(tmp_path):
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "loop.csv").symlink_to(tmp_path / "loop.csv")
    (tmp_path / "empty.csv").touch()
    (tmp_path / "folder.json").mkdir()
    with (tmp_path / "large.json").open("wb") as file:
        file.truncate(10**9)
    faults = {
        "pipe.csv": "is a pipe or a device, but must be an ordinary file",
        "loop.csv": "cannot be read: Too many levels of symbolic links",
        "empty.csv": "is empty",
        "folder.json": "is a folder",
        "large.json": "has 1000 MB, but ink has at most 64",
        "nowhere.inkml": "cannot be read: No such file",
        "a\0b.csv": "cannot be the name of a file: embedded null byte",
        "x" * 300: "cannot be read: File name too long",
    }
    for name, sentence in faults.items():
        with pytest.raises(RecordingError, match=sentence) as caught:
            read_recording(f"{tmp_path}/{name}")
        assert str(tmp_path) not in str(caught.value), "folders have names of people in them"
    if Path("/dev/zero").exists():
        with pytest.raises(RecordingError, match="is a pipe or a device"):
            read_recording("/dev/zero")


@pytest.mark.parametrize("path", ["a.txt", "a", "a.json.gz", 3, None, b"a.json"])
def test_only_three_formats_are_written(tmp_path, monkeypatch, path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PathError, match=r"must end with one of \.json, \.inkml, \.svg"):
        write_recording(recording_of("l"), path)


@pytest.mark.parametrize("ink", [None, 3, [], "strokes", [1, 2], {}])
def test_only_ink_is_written(tmp_path, ink):
    with pytest.raises(
        RecordingError, match="cannot be written as ink; give a Recording, or strokes"
    ):
        write_recording(ink, tmp_path / "a.svg")


@pytest.mark.parametrize("suffix", WRITTEN)
def test_names_of_people_are_not_written(tmp_path, suffix):
    once = recording_of("l")
    with pytest.raises(
        RecordingError, match="writer is 'Anna Berg', but must be a pseudonym such as 'w01'"
    ):
        write_recording(Recording(once.t, once.position, "l", "Anna Berg"), tmp_path / f"a{suffix}")
    assert list(tmp_path.iterdir()) == []
