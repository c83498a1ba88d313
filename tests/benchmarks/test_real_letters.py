"""Letters of a UNIPEN folder are read and studied as its files say; this folder is our own."""

import numpy as np
import pytest

from tests.benchmarks.real_letters import components, letters, main
from tests.studies.pupils import Pupil


@pytest.fixture
def folder(tmp_path):
    """Three writers, each with two takes of D and P, as the collection has them."""
    for kind, where in (("1b", "data/1b/aga"), ("", "include/aga/data")):
        (tmp_path / where).mkdir(parents=True)
        for seed in range(3):
            drawn = [Pupil(seed).writes(character, take) for character in "DP" for take in (0, 1)]
            text, labels, count = (
                [".COMMENT our own", ".X_POINTS_PER_INCH 500", ".Y_POINTS_PER_INCH 1000"],
                [],
                1,
            )
            text += [".POINTS_PER_SECOND 200", ".PEN_DOWN", "7 7", ".PEN_UP"]
            for letter in drawn:
                last = count + len(letter.strokes) - 1
                labels.append(f'.SEGMENT CHARACTER {count}-{last} ? "{letter.character}"')
                for stroke in letter.strokes:
                    points = np.rint(stroke.position / 0.0254 * [500, 1000]).astype(int)
                    text += [".PEN_DOWN", *(f" {x} {y}" for x, y in points), ".PEN_UP"]
                    count += 1
            lines = [".VERSION 1.0", *labels, '.SEGMENT CHARACTER 0 BAD "D"'] if kind else text
            (tmp_path / where / f"name{seed}.dat").write_text("\n".join(lines) + "\n")
    return tmp_path


def test_letters_are_read_with_their_scale_and_writers_are_numbers(folder):
    found = letters(folder, "aga")
    assert len(found) == 3 * 4
    assert {each.writer for each in found} == {"u00", "u01", "u02"}
    truth = Pupil(1).writes("P", 1)
    read = found[1 * 4 + 3]
    assert read.character == "P"
    for a, b in zip(read.strokes, truth.strokes, strict=True):
        np.testing.assert_allclose(a.position, b.position, atol=0.0254 / 500)
        assert a.t[1] - a.t[0] == pytest.approx(1 / 200)
    assert components(folder / "include/aga/data/name0.dat")[0] is None


def test_every_study_is_printed(folder, capsys):
    main([str(folder)])
    said = capsys.readouterr().out
    assert said.startswith("12 letters by 3 writers")
    for words in ("other takes", "DMP*, varied, less the mean"):
        assert words in said


def test_a_folder_without_letters_is_named(tmp_path, capsys):
    with pytest.raises(SystemExit):
        main([str(tmp_path)])
    assert "holds no letters by 'aga'" in capsys.readouterr().err
