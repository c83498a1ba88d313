"""The reference sets in MATLAB's files are letters, and no claim of a file is believed."""

import io
import struct
import zlib

import numpy as np
import pytest
import scipy.io

from dmp_teach.errors import RecordingError
from dmp_teach.formats.mat import parser as matfile
from dmp_teach.formats.mat.parser import parse_mat
from dmp_teach.formats.read import read_recording, read_recordings
from tests.formats.ink_files import cells, lasa, loop, mat, uci


def good_files(_):
    """For the tests of damaged files."""
    small = [loop(1.0, 40), loop(1.2, 50)]
    letters = uci(small, labels=(1, 2), pad=(1, 2))
    return {
        "a.mat": mat(letters, compressed=False),
        "b.mat": mat(lasa(small), compressed=True),
        "c.mat": mat(VALUES | {"mixout": uci(small)["mixout"]}, compressed=False),
    }


PATHS = [loop(1.0, 160), loop(1.5, 200, 2.0), loop(0.75, 140)]


def saved(tmp_path, variables, name="a.mat", **how):
    (tmp_path / name).write_bytes(mat(variables, **how))
    return tmp_path / name


@pytest.mark.parametrize("compressed", [True, False])
@pytest.mark.parametrize("force", ["rate", "force"])
def test_character_trajectories_are_summed_up(tmp_path, compressed, force):
    letters = read_recordings(saved(tmp_path, uci(PATHS, force=force), compressed=compressed))
    assert [letter.character for letter in letters] == ["a", "d", "a"]
    heights = [np.ptp(path[:, 1]) for path in PATHS]
    scale = 0.05 / np.median(heights)
    for letter, path in zip(letters, PATHS, strict=True):
        (stroke,) = letter.strokes()
        assert len(stroke) == len(path) - 1, "zeros before and after are padding"
        np.testing.assert_allclose(np.diff(stroke.t), 1 / 200, atol=1e-12)
        moved = path[1:] - path[1:].min(axis=0)
        np.testing.assert_allclose(stroke.position, moved * scale, atol=1e-9)
        press = np.sin(np.linspace(0.1, np.pi - 0.1, len(path)))[1:]
        assert np.corrcoef(letter.pressure, press)[0, 1] > 0.999
        assert letter.pressure.max() == 1


def test_a_set_without_labels_is_read_without_them(tmp_path):
    path = saved(tmp_path, {"mixout": uci(PATHS)["mixout"]})
    assert [letter.character for letter in read_recordings(path)] == [None] * 3
    with pytest.raises(RecordingError, match=r"a\.mat holds 3 letters; .* without a label \(3\)\."):
        read_recording(path)
    assert read_recording(path, number=1).duration == pytest.approx(198 / 200)


@pytest.mark.parametrize("compressed", [True, False])
def test_lasa_is_in_millimetres_and_seconds(tmp_path, compressed):
    letters = read_recordings(
        saved(tmp_path, lasa([0.05 * path for path in PATHS]), "GShape.mat", compressed=compressed)
    )
    assert [letter.character for letter in letters] == ["G"] * 3
    for letter, path in zip(letters, PATHS, strict=True):
        (stroke,) = letter.strokes()
        np.testing.assert_allclose(stroke.position, 0.05 * (path - path.min(axis=0)), atol=1e-9)
        np.testing.assert_allclose(stroke.t, np.arange(len(path)) * 0.004, atol=1e-12)
        assert letter.pressure is None


def test_demonstrations_may_stand_upright_and_alone_and_arrays_in_a_struct(tmp_path):
    path = 50 * PATHS[0]
    upright = saved(tmp_path, {"demos": cells([path])}, "A.mat")
    letter = read_recording(upright)
    assert letter.character == "A"
    size = np.ptp(letter.strokes()[0].position, axis=0)
    np.testing.assert_allclose(size, np.ptp(path, axis=0) / 1000, rtol=0.01)
    t = np.arange(len(path)) * 0.01
    struct = {"take": {"t": t, "x": path[:, 0], "y": path[:, 1]}, "gains": np.ones(3)}
    assert read_recording(saved(tmp_path, struct)).duration == pytest.approx(t[-1])


def test_a_lasa_shape_that_is_no_letter_has_no_label_and_a_step_will_do_for_times(tmp_path):
    variables = lasa([0.05 * PATHS[0]])
    for demo in variables["demos"][0]:
        del demo["t"]
    recording = read_recording(saved(tmp_path, variables, "Angle.mat"))
    assert recording.character is None
    assert recording.duration == pytest.approx(159 * 0.004)
    assert read_recording(saved(tmp_path, variables, "2_C_slow.mat")).character == "C"
    for demo in variables["demos"][0]:
        del demo["dt"]
    assert read_recording(saved(tmp_path, variables, "Angle.mat")).duration == pytest.approx(
        159 * 0.004
    )
    del variables["dt"]
    by_hand = read_recording(saved(tmp_path, variables, "Angle.mat"))
    assert 0.3 < by_hand.duration < 3.0, "a hand's pace where nothing says a time"
    assert np.ptp(by_hand.position, axis=0)[:2] == pytest.approx(
        np.ptp(recording.position, axis=0)[:2], abs=1e-4
    )


def test_other_ways_of_saving_the_same_do_no_harm(tmp_path):
    whole = uci(PATHS)
    whole["consts"]["key"] = "ad"
    whole["consts"]["charlabels"] = np.array([[1], [2], [1]], dtype=np.uint8)
    whole["mixout"] = whole["mixout"].T
    assert [letter.character for letter in read_recordings(saved(tmp_path, whole))] == [
        "a",
        "d",
        "a",
    ]
    flat = uci(PATHS)
    flat["mixout"] = cells([cell[:2] for cell in flat["mixout"][0]])
    assert read_recordings(saved(tmp_path, flat))[0].pressure is None
    demos = np.array(
        [(d["pos"], d["t"]) for d in lasa([0.05 * p for p in PATHS])["demos"][0]],
        dtype=[("pos", "O"), ("t", "O")],
    )
    assert len(read_recordings(saved(tmp_path, {"demos": demos}))) == 3


VALUES = {
    "numbers": np.arange(24.0).reshape(2, 3, 4),
    "small": np.arange(-3, 3, dtype=np.int8),
    "long": np.array([[2**40]], dtype=np.int64),
    "single": np.array([[0.5]], dtype=np.float32),
    "flags": np.array([[True, False]]),
    "text": "Grüße",
    "nothing": np.empty((0, 0)),
    "cells": cells([1.0, "a", cells([np.eye(2)])]),
    "struct": {"x": 1.0, "inner": {"y": "z"}},
}


@pytest.mark.parametrize("compressed", [True, False])
def test_values_are_those_that_scipy_reads(compressed):
    data = mat(VALUES, compressed)
    ours, theirs = parse_mat(data), scipy.io.loadmat(io.BytesIO(data))
    for name in ("numbers", "small", "long", "single", "flags", "nothing"):
        np.testing.assert_array_equal(ours[name], theirs[name])
    assert ours["text"] == theirs["text"][0] == "Grüße"
    assert ours["cells"][1] == "a"
    np.testing.assert_array_equal(ours["cells"][2][0], np.eye(2))
    assert ours["struct"]["inner"] == {"y": "z"}


def test_a_big_endian_file_is_read():
    """As MATLAB wrote on the workstations of its time; put together by hand."""
    body = struct.pack(">IIII", 6, 8, 6, 0) + struct.pack(">IIii", 5, 8, 1, 2)
    body += struct.pack(">HH4s", 1, 1, b"v\0\0\0") + struct.pack(">IIdd", 9, 16, 1.5, -2.5)
    data = (
        b"MATLAB 5.0".ljust(124)
        + struct.pack(">H", 0x0100)
        + b"MI"
        + struct.pack(">II", 14, len(body))
        + body
    )
    np.testing.assert_array_equal(parse_mat(data)["v"], [[1.5, -2.5]])


def head(*elements):
    return b"MATLAB 5.0".ljust(124) + b"\0\1IM" + b"".join(elements)


def element(kind, content, size=None):
    content += b"\0" * (-len(content) % 8)
    return struct.pack("<II", kind, len(content) if size is None else size) + content


def array(kind, shape, *parts):
    dims = element(5, struct.pack(f"<{len(shape)}i", *shape), 4 * len(shape))
    return element(
        14, element(6, struct.pack("<II", kind, 0)) + dims + element(1, b"v", 1) + b"".join(parts)
    )


def nested(depth):
    inner = array(6, (1, 1), element(9, bytes(8)))
    for _ in range(depth):
        inner = array(1, (1, 1), inner)
    return inner


BOMBS = {
    "more than there is": (
        head(element(14, b"", 2**31 - 1)),
        "it is broken off: 2147483647 bytes should follow",
    ),
    "a huge array": (
        head(array(6, (2**31 - 1, 2**31 - 1), element(9, bytes(8)))),
        r"an array of shape .* has 1 numbers",
    ),
    "a huge cell": (head(array(1, (2**31 - 1, 1))), "it has more than 200000 cells"),
    "a negative size": (head(array(6, (-1, 4), element(9, bytes(8)))), "an array has no shape"),
    "cells in cells": (head(nested(200)), "cells and structs lie more than 12 deep"),
    "a packed bomb": (
        head(element(15, zlib.compress(bytes(140_000_000), 1))),
        "it is larger than 128 MB inside",
    ),
    "many small ones": (
        head(*[element(9, b"")] * 200_002),
        "it has more than 200000 elements in a row",
    ),
    "a broken pack": (head(element(15, b"no zlib here at all")), "a packed part is damaged"),
    "half a pack": (
        head(element(15, zlib.compress(bytes(9999))[:20])),
        "a packed part is damaged, or broken off",
    ),
    "no head": (head(element(14, element(9, bytes(8)))), "an array has no head"),
    "a struct of nothing": (head(array(2, (1, 1))), "a struct has no names"),
    "strange numbers": (
        head(array(6, (1, 1), element(99, bytes(8)))),
        "its numbers are of the unknown kind 99",
    ),
    "version 7.3": (
        b"MATLAB 7.3 MAT-file".ljust(512) + b"\x89HDF\r\n\x1a\n",
        "is a MATLAB file of version 7.3",
    ),
    "no order of bytes": (b"MATLAB 5.0".ljust(200), "is not a MATLAB file of version 5 to 7"),
    "empty inside": (head(), "has neither 'mixout' .* its variables: none"),
}


@pytest.mark.slow
@pytest.mark.parametrize("bomb", BOMBS)
def test_no_claim_of_a_file_is_believed(tmp_path, bomb):
    data, sentence = BOMBS[bomb]
    (tmp_path / "a.mat").write_bytes(data)
    with pytest.raises(RecordingError, match=rf"a\.mat: .*{sentence}"):
        read_recording(tmp_path / "a.mat")


def test_numbers_that_grow_when_they_are_read_are_counted(monkeypatch):
    monkeypatch.setattr(matfile, "MOST_BYTES", 5000)
    with pytest.raises(RecordingError, match="larger than 0 MB inside"):
        parse_mat(head(array(8, (1, 1000), element(1, bytes(1000)))))


def test_objects_and_functions_are_passed_over():
    assert parse_mat(head(array(3, (1, 1), element(1, b"thing")), array(17, (1, 1)))) == {"v": None}


FAULTS = {
    "neither set": (
        {"x": 1.0},
        r"neither 'mixout' \(Character Trajectories\) nor 'demos' \(LASA\), .* its variables: 'x'",
    ),
    "no cells": ({"mixout": np.eye(3)}, "mixout must be a cell array with at least one letter"),
    "text in a cell": (
        {"mixout": cells(["abc"])},
        "mixout, letter 0: its value is no matrix, but must be 3 x T",
    ),
    "the wrong way round": (
        {"mixout": cells([np.ones((9, 3))])},
        r"mixout, letter 0: its value is of shape \(9, 3\), but must be 3",
    ),
    "zeros": (
        {"mixout": cells([np.zeros((3, 99))])},
        "mixout, letter 0: moves in 0 samples, but a letter needs 5",
    ),
    "no number": (
        {"mixout": cells([np.full((3, 99), np.nan)])},
        "letter 0: its value must have 5 to 100000 samples, each of them finite",
    ),
    "a huge number": (
        {"mixout": cells([np.full((3, 99), 1e308)])},
        "letter 0: its value must have .* each of them finite and below 1e100",
    ),
    "labels too few": (
        uci(PATHS, labels=(1, 2)),
        "consts.charlabels must have a number for each of the 3 characters",
    ),
    "a label too large": (
        uci(PATHS, labels=(1, 3, 1)),
        "consts.charlabels has 3, but consts.key has 1 to 2",
    ),
    "no pos": (
        {"demos": cells([{"t": 1.0}])},
        "demos, letter 0: 'pos' is no matrix, but must be 2 x T",
    ),
    "kilometres": (lasa([1e6 * PATHS[0]]), r"the ink is .* m large, but must be"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_what_is_no_letter_is_named(tmp_path, fault):
    variables, sentence = FAULTS[fault]
    with pytest.raises(RecordingError, match=rf"a\.mat: .*{sentence}"):
        read_recordings(saved(tmp_path, variables))


def test_numbers_with_names_are_a_table(tmp_path):
    t, way = np.arange(160) / 200, 0.05 * PATHS[0]
    for variables in (
        {"t": t, "x": way[:, 0], "y": way[:, 1]},
        {"time": t[:, None], "pos": way, "about": "a loop"},
        {"ink": np.column_stack([t, way])},
    ):
        (stroke,) = read_recording(saved(tmp_path, variables)).strokes()
        np.testing.assert_allclose(stroke.position, way - way.min(axis=0), atol=1e-9)
        np.testing.assert_allclose(stroke.t, t, atol=1e-9)


def test_a_letter_that_cannot_be_read_is_left_out_of_its_set_and_told(tmp_path):
    broken = {"mixout": cells([*uci(PATHS)["mixout"][0], np.zeros((3, 99))])}
    letters = read_recordings(saved(tmp_path, broken))
    assert len(letters) == 3
    assert "mixout, letter 3: moves in 0 samples" in letters[0].notes[-1]
