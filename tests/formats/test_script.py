"""A school's own letters, in the place of ours."""

import numpy as np
import pytest

from dmp_teach import (
    RecordingError,
    check,
    lesson,
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


DRAWING = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="50mm" viewBox="0 0 20 50">'
    '<path d="{}" fill="none" stroke="black"/></svg>'
)
BAR = DRAWING.format("M10 5V30")


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
    for name in ("readme.md", "readme.csv", "._a.svg"):
        (folder / name).write_text("no letter")
    with pytest.warns(UserWarning, match=r"Left out, as no letter: readme\.(csv|txt)"):
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
    layered = SHEET.replace('<g id="l">', '<g id="layer1"><g id="l">').replace(
        "</svg>", "</g></svg>"
    )
    file.write_text(layered)
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


def test_a_letter_that_ours_lack_is_taught_and_judged(tmp_path):
    (tmp_path / "\u0151.SVG").write_text(BAR)
    assert use_script(tmp_path) == ("\u0151",)
    panel = pad("\u0151")
    [stroke] = recording_of("\u0151").strokes()
    panel.add_stroke(np.column_stack([stroke.t, stroke.position, np.ones(len(stroke))]))
    assert "looks the same" in panel.message["strong"]
    assert read_letter(recording_of("m"), "\u0151") == "m"


def test_a_script_that_is_refused_changes_nothing(tmp_path):
    good, flat, bad = (tmp_path / name for name in ("good", "flat", "a.svg"))
    good.mkdir()
    flat.mkdir()
    (good / "a.svg").write_text(BAR)
    (flat / "a.svg").write_text(DRAWING.format("M10 5L20 5.00000000001"))
    bad.write_text('<!DOCTYPE svg [<!ENTITY e "e">]>' + BAR)
    use_script(good)
    taught, kept = recording_of("a"), check("04", lesson("04").solution)
    for path, words in (
        (flat, "m large"),
        (bad, r"a\.svg: defines the entity"),
        (tmp_path / "none", "none cannot be read"),
        (5, "path is 5"),
        ([], "path is"),
        (b"x", "path is"),
    ):
        with pytest.raises(RecordingError, match=words):
            use_script(path)
        assert recording_of("a") is taught
        assert check("04", lesson("04").solution) == kept


def test_a_lesson_keeps_our_letter_where_it_stands_on_its_strokes(tmp_path):
    for letter in "aDP":
        (tmp_path / f"{letter}.svg").write_text(DRAWING.format("M5 5V30M10 5V30M15 5V30"))
    (tmp_path / "S.svg").write_text(DRAWING.format("M10 5L15 15L10 30"))
    use_script(tmp_path)
    assert len(recording_of("D").strokes()) == len(recording_of("a").strokes()) == 3
    for key in ("00", "02", "05", "06", "10"):
        assert check(key, lesson(key).solution).done
