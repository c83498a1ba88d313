"""A worksheet and a certificate are as large as their paper, and hold what they say."""

from io import BytesIO
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image
from scipy.spatial import cKDTree

from dmp_teach.errors import LetterError, ViewError
from dmp_teach.ink import recording_of
from dmp_teach.letters import Letter
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import read_stamp
from dmp_teach.views.figures import draw_certificate, draw_worksheet
from dmp_teach.views.figures.handouts import PAPERS


@pytest.mark.parametrize("paper", PAPERS)
def test_a_sheet_is_as_large_as_its_paper(tmp_path, paper):
    for figure in (draw_worksheet([recording_of("a")], paper), draw_certificate(recording_of("a"))):
        figure.savefig(tmp_path / "sheet.svg")
        figure.savefig(tmp_path / "sheet.pdf")
        assert (tmp_path / "sheet.pdf").read_bytes().startswith(b"%PDF")
    draw_worksheet([recording_of("a")], paper).savefig(tmp_path / "sheet.svg")
    root = ElementTree.parse(tmp_path / "sheet.svg").getroot()
    # 72 points to the inch
    size = [float(root.get(side).removesuffix("pt")) * 25.4 / 72 for side in ("width", "height")]
    np.testing.assert_allclose(size, PAPERS[paper], atol=0.1)


def test_dots_lie_on_the_letter_and_every_stroke_has_its_number():
    panel = draw_worksheet([recording_of("E")]).axes[0]
    strokes = recording_of("E").strokes()
    dots = [line.get_xydata() for line in panel.lines if line.get_marker() == "."]
    inks = [line.get_xydata() for line in panel.lines if line.get_marker() == "None"]
    assert len(dots) == 2 * len(strokes)
    ink = np.concatenate(inks[1 : 1 + len(strokes)])
    for n in range(2):
        traced = np.concatenate(dots[n * len(strokes) : (n + 1) * len(strokes)])
        moved = traced - traced.mean(axis=0)
        moved += ink.min(axis=0) - moved.min(axis=0)
        assert cKDTree(ink).query(moved)[0].max() < 0.5
    numbers = [text.get_text() for text in panel.texts if text.get_text().isdigit()]
    assert numbers == [str(n + 1) for n in range(len(strokes))]


@pytest.mark.parametrize("is_colored", [True, False])
def test_a_photo_of_a_certificate_brings_the_letter_back(is_colored):
    stream = BytesIO()
    draw_certificate(recording_of("g"), is_colored=is_colored).savefig(stream, dpi=110)
    picture = np.asarray(Image.open(stream).convert("RGB"))
    is_grey = (np.ptp(picture.astype(int), axis=2) < 40).all()
    # Words are nearly grey in either.
    assert is_grey != is_colored
    (again,), (own,) = read_stamp(picture).write(), Letter.learn(recording_of("g")).write()
    assert np.abs(again.position - own.position).max() < 5e-5


def test_what_no_sheet_holds_is_refused():
    for letters in ([], [recording_of("a")] * 6):
        with pytest.raises(ViewError, match="1 to 5 letters"):
            draw_worksheet(letters)
    for letters in (None, 5, "a", recording_of("a")):
        with pytest.raises(ViewError, match="takes a list"):
            draw_worksheet(letters)
    for letter in (None, 5, [], [None]):
        with pytest.raises(LetterError):
            draw_worksheet([letter])
    line = Trajectory(np.arange(30.0) / 30, np.arange(30.0)[:, None] / 300)
    for draw in (draw_certificate, lambda letter: draw_worksheet([letter])):
        with pytest.raises(ViewError, match="2-D"):
            draw([line])
    with pytest.raises(ViewError, match="A4, Letter"):
        draw_worksheet([recording_of("a")], [])
    with pytest.raises(ViewError, match="A4, Letter"):
        draw_certificate(recording_of("a"), "A5")
