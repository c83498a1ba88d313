"""A school's own letters, in the place of ours."""

import numpy as np
import pytest

from dmp_teach import (
    RecordingError,
    pad,
    recording_of,
    score,
    use_script,
    write_recording,
)
from dmp_teach.classroom.panels.kept import forget
from dmp_teach.ink import alphabets, characters
from dmp_teach.scoring import read_letter

SHEET = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">'
    '<g id="l"><path d="M10 5V30" fill="none" stroke="black"/></g><g id="notes"/>'
    '<g id="g1" stroke="black" fill="none"><title>t</title>'
    '<path d="M30 5V30"/><path d="M35 12H25"/></g></svg>'
)


@pytest.fixture(autouse=True)
def ours_again():
    yield
    use_script(None)
    forget("pad")


def test_letters_of_the_pad_become_the_schools_and_the_last_one_counts(tmp_path):
    folder, ours = tmp_path / "school", recording_of("b")
    folder.mkdir()
    for name, letter in (("a_w01", "o"), ("a_w01_2", "a"), ("b_w01", "b")):
        taught = recording_of(letter, "slanted")
        write_recording(taught, folder / f"{name}.json")
    (folder / "a_w01.json").write_text(
        (folder / "a_w01.json").read_text().replace('"character": "o"', '"character": "a"')
    )
    (folder / "readme.txt").write_text("no letter")
    assert use_script(folder) == ("a", "b")
    assert alphabets()[0] == "school"
    assert score(recording_of("a"), recording_of("a", "slanted")).shape < 0.005
    assert score(recording_of("b"), ours).shape > 0.005
    assert np.array_equal(recording_of("c").position, recording_of("c", "round").position)
    assert set(characters()) == set(characters("round"))
    assert read_letter(recording_of("a"), "a") is None
    use_script(None)
    assert np.array_equal(recording_of("b").position, ours.position)


def test_a_drawing_with_a_group_for_each_letter_is_a_script_that_the_pad_teaches(tmp_path):
    file = tmp_path / "round.svg"
    file.write_text(SHEET)
    assert use_script(file) == ("l", "t")
    strokes = recording_of("t").strokes()
    assert len(strokes) == 2
    assert strokes[1].position[0, 0] > strokes[1].position[-1, 0]
    ink = np.concatenate([stroke.position for stroke in strokes])
    assert ink[:, 1].min() == pytest.approx(0, abs=0.005)
    assert 0.09 < np.ptp(ink[:, 1]) < 0.15
    panel = pad("t")
    for stroke in strokes:
        even = np.column_stack([stroke.t - strokes[0].t[0], stroke.position, np.ones(len(stroke))])
        panel.add_stroke(even)
        assert panel.lift["missed"] is None
    assert "looks the same" in panel.message["strong"]


def test_a_script_without_letters_says_how_they_are_named_and_ours_stay(tmp_path):
    file = tmp_path / "mine.svg"
    file.write_text(SHEET.replace('id="l"', 'id="left"').replace("<title>t</title>", ""))
    with pytest.raises(RecordingError, match=r"no letter in mine\.svg: name files or groups"):
        use_script(file)
    assert alphabets()[0] == "round"
