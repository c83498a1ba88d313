"""Pictures without a browser."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from dmp_teach.errors import MissingPartError
from dmp_teach.robot.simulation import bullet as physics
from dmp_teach.views.scene.view import SceneView, view
from tests.views.moves import sway

ROOT = Path(__file__).parents[2]


def blue(path):
    """How many pixels have the colour of ink."""
    r, g, b = np.asarray(Image.open(path)).astype(int).transpose(2, 0, 1)
    return int(((b > r + 60) & (g > r + 20) & (b < 230)).sum())


def picture(shown, folder, **options):
    return shown.png(folder / "a.png", width=360, height=240, **options)


@pytest.fixture(scope="module", autouse=True)
def needs_pybullet():
    pytest.importorskip("pybullet")


@pytest.fixture(scope="module")
def shown():
    return view(sway())


def test_a_picture_shows_robot_page_and_sky(shown, tmp_path):
    pixels = np.asarray(Image.open(picture(shown, tmp_path, camera="whole robot")))
    assert pixels.shape == (240, 360, 3)
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 200
    assert pixels[5, 5].min() > 200, "sky"
    assert (pixels.max(axis=2) < 80).sum() > 200, "the dark base and hand"


def test_the_letter_grows_with_time(shown, tmp_path):
    amounts = [
        blue(picture(shown, tmp_path, camera="page from above", time=t)) for t in (0.0, 1.0, 2.4)
    ]
    assert amounts[0] + 20 < amounts[1] < amounts[2] - 20


def test_from_above_the_pen_is_seen_without_the_arm_that_would_hide_the_letter(shown, tmp_path):
    """Between two moments only pen and ink change."""
    early, late = (
        np.asarray(Image.open(picture(shown, tmp_path, camera="page from above", time=t)))
        for t in (0.3, 2.3)
    )
    changed = np.abs(early.astype(int) - late).max(axis=2) > 20
    assert 0.001 < changed.mean() < 0.05


def test_without_a_motion_the_page_is_empty(tmp_path):
    empty = picture(SceneView(), tmp_path, camera="page from above")
    assert blue(empty) < 300, "nothing but the pen"


def test_the_end_is_shown_unless_a_time_is_given(shown, tmp_path):
    end = np.asarray(Image.open(picture(shown, tmp_path)))
    again = np.asarray(Image.open(picture(shown, tmp_path, time=2.4)))
    assert (end == again).all()


def test_every_client_is_closed(shown, tmp_path):
    pybullet = pytest.importorskip("pybullet")
    picture(shown, tmp_path)
    with pytest.raises(ValueError, match="never"), physics.open_world() as (_, number):
        raise ValueError("never")
    assert not pybullet.isConnected(number)


def test_without_pybullet_it_says_what_still_works(shown, tmp_path, without_pybullet):
    with pytest.raises(MissingPartError, match=r"need pybullet.*\.html\(path\) work without it"):
        picture(shown, tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_picture_prints_nothing(tmp_path):
    draw = "from tests.views.moves import sway; from dmp_teach.views.scene.view import view; "
    draw += "import sys; "
    draw += "view(sway(seconds=0.5)).png(sys.argv[1], width=64, height=64)"
    done = subprocess.run(
        [sys.executable, "-c", draw, tmp_path / "a.png"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert (done.stdout, done.stderr) == ("", "")
