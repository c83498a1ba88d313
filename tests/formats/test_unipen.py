"""UNIPEN: components are strokes, segments are letters, and what cannot be is named by its row."""

import numpy as np
import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recording, read_recordings
from tests.formats.ink_files import d_strokes

HEAD = ".VERSION 1.0\n.COORD X Y\n.X_POINTS_PER_MM 100\n.POINTS_PER_SECOND 100\n"


def d_unipen(head=HEAD, form="{x:.0f} {y:.0f}", segments=""):
    """The D in hundredths of a millimetre, its lift of 40 points at 100 Hz."""
    down = [
        "\n".join(form.format(t=1000 * t, x=1e5 * x, y=1e5 * y) for t, x, y, _ in stroke)
        for stroke in d_strokes()
    ]
    up = "\n".join([form.format(t=900, x=0, y=0)] * 39)
    body = f".PEN_DOWN\n{down[0]}\n.PEN_UP\n{up}\n.PEN_DOWN\n{down[1]}\n.PEN_UP\n"
    return head + segments + body


def good_files(_):
    """For the tests of damaged files."""
    return {"a.dat": d_unipen(segments='.SEGMENT CHARACTER 0-2 OK "D"\n').encode()}


def read(tmp_path, text, **which):
    (tmp_path / "d.dat").write_text(text)
    return read_recording(tmp_path / "d.dat", **which)


def check_d(recording, times=1e-6):
    for stroke, wanted in zip(recording.strokes(), d_strokes(), strict=True):
        assert np.allclose(stroke.position, wanted[:, 1:3], atol=1e-5)
        assert np.allclose(stroke.t, wanted[:, 0], atol=times)


def test_times_are_those_of_the_file_or_of_its_rate(tmp_path):
    check_d(read(tmp_path, d_unipen()))
    timed = HEAD.replace("X Y", "X Y T").replace(".POINTS_PER_SECOND 100\n", "")
    check_d(read(tmp_path, d_unipen(timed, "{x:.0f} {y:.0f} {t:.3f}")))


def test_ink_without_a_unit_is_50_mm_high(tmp_path):
    ink = read(tmp_path, d_unipen(".COORD X Y\n")).strokes()
    assert np.ptp(np.vstack([stroke.position for stroke in ink])[:, 1]) == pytest.approx(0.05)


def test_characters_are_letters_and_words_are_not(tmp_path):
    segments = '.SEGMENT WORD 0-3 OK "lc"\n.SEGMENT CHARACTER 0 OK "l"\n'
    segments += '.SEGMENT CHARACTER 2 OK "c"\n'
    (tmp_path / "d.dat").write_text(d_unipen(segments=segments))
    letters = read_recordings(tmp_path / "d.dat")
    assert [(each.character, len(each.strokes())) for each in letters] == [("l", 1), ("c", 1)]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
def test_a_label_is_read_however_its_signs_are_written(tmp_path, encoding):
    text = d_unipen(segments='.SEGMENT CHARACTER 0-2 OK "Ö"\n')
    (tmp_path / "d.dat").write_bytes(text.encode(encoding))
    assert read_recording(tmp_path / "d.dat").character == "Ö"


def test_a_letter_may_be_a_part_of_its_components(tmp_path):
    """From point 3 of one to point 10 of another, both within."""
    whole = read(tmp_path, d_unipen()).strokes()
    text = d_unipen(segments='.SEGMENT CHARACTER 0:3-2:10 OK "D"\n.SEGMENT CHARACTER 2:5-2:9 OK\n')
    first, second = read(tmp_path, text, which="D").strokes()
    assert (len(first), len(second)) == (len(whole[0]) - 3, 11)
    assert len(read(tmp_path, text, number=1).strokes()[0]) == 5


def test_height_has_a_scale_of_its_own(tmp_path):
    ink = read(tmp_path, d_unipen(HEAD + ".Y_POINTS_PER_MM 50\n")).strokes()
    assert np.ptp(np.vstack([stroke.position for stroke in ink])[:, 1]) == pytest.approx(0.12)


def test_a_letter_with_a_row_that_is_no_point_is_left_out_and_told(tmp_path):
    segments = '.SEGMENT CHARACTER 0 OK "l"\n.SEGMENT CHARACTER 2 OK "c"\n'
    text = d_unipen(segments=segments).replace(".PEN_DOWN\n", ".PEN_DOWN\none 2\n", 1)
    letter = read(tmp_path, text)
    assert letter.character == "c"
    assert "row 8 is 'one 2'" in letter.notes[-1]


BROKEN = {
    "a word": (HEAD + ".PEN_DOWN\n1 2\none 2\n", "row 7 is 'one 2', but a point must have 2"),
    "no Y": (".COORD X\n.PEN_DOWN\n1\n", "has the columns X, but must have X and Y"),
    "no ink": (HEAD, "has no stroke of a pen that was down"),
    "far away": (
        d_unipen(segments='.SEGMENT CHARACTER 9 OK "l"\n'),
        "must be of components, from 0 to 3",
    ),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_cannot_be_read_says_where(tmp_path, fault):
    text, sentence = BROKEN[fault]
    with pytest.raises(RecordingError, match=rf"d\.dat: .*{sentence}"):
        read(tmp_path, text)
