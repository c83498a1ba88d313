"""A letter as a QR code: small, true to a twentieth of a millimetre, and read back from a photo."""

import binascii
from contextlib import suppress
from string import ascii_letters, digits

import numpy as np
import pytest
import zxingcpp
from PIL import Image
from scipy.spatial import cKDTree

from dmp_teach.dmp import Settings
from dmp_teach.errors import LetterError, PathError
from dmp_teach.ink import recording_of
from dmp_teach.letters import Letter, Shelf, letter_from_bytes, letter_to_bytes, make_letter
from dmp_teach.trajectory import Trajectory
from dmp_teach.views import read_stamp, stamp_text, write_stamp
from tests.laws import for_every


def distance(a, b):
    """How far two letters are apart at most, at equal samples [m]."""
    pairs = zip(a.write(), b.write(), strict=True)
    return max(np.linalg.norm(p.position - q.position, axis=1).max() for p, q in pairs)


@for_every([(name, each) for name in ("round", "slanted") for each in ascii_letters + digits])
def test_every_letter_comes_back_within_a_twentieth_of_a_millimetre(name, character):
    letter = Letter.learn(recording_of(character, name))
    data = letter_to_bytes(letter)
    assert len(data) <= 140 or len(letter.strokes) > 2
    back = letter_from_bytes(data)
    assert distance(letter, back) <= 5e-5
    for stroke, again in zip(letter.write(), back.write(), strict=True):
        np.testing.assert_allclose(again.t - again.t[0], stroke.t - stroke.t[0], atol=1e-4)
    assert abs(back.duration - letter.duration) < 2e-3


def test_a_letter_that_was_made_or_led_elsewhere_comes_back():
    made = make_letter("P", Shelf.of([recording_of("D")]))
    assert distance(made, read_stamp(stamp_text(made))) <= 5e-5


def uneven(kind):
    """An a whose samples are not even: 220 of them by chance, a clock with jitter, or a pause."""
    (stroke,) = recording_of("a").strokes()
    rng, t = np.random.default_rng(2), stroke.t
    if kind == "thinned":
        kept = np.sort(rng.choice(len(t), 220, replace=False))
        return Trajectory(t[kept], stroke.position[kept])
    if kind == "jitter":
        return Trajectory(t + rng.uniform(-1e-4, 1e-4, len(t)), stroke.position)
    return Trajectory(t + (np.arange(len(t)) > 99), stroke.position)


@pytest.mark.parametrize("kind", ["thinned", "jitter", "pause"])
def test_ink_at_uneven_times_comes_back_as_the_same_line(kind):
    letter = Letter.learn([uneven(kind)])
    (back,) = read_stamp(stamp_text(letter)).write()
    (own,) = letter.write()
    assert cKDTree(back.position).query(own.position)[0].max() < 5e-4
    finest = back.position[
        np.searchsorted(back.t - back.t[0], own.t - own.t[0]).clip(max=len(back) - 1)
    ]
    assert np.abs(finest - own.position).max() < 2e-3


@pytest.mark.parametrize("kernels", [1, 2, 3])
def test_a_large_letter_of_few_kernels_is_true_or_refused(kernels):
    t = np.linspace(0, 4, 400)
    path = np.column_stack([0.6 * np.sin(np.pi * t / 4) ** 2, 0 * t])
    letter = Letter.learn([Trajectory(t, path)], Settings.star(n_kernels=kernels))
    with suppress(LetterError):
        assert distance(letter, letter_from_bytes(letter_to_bytes(letter))) <= 5e-5


def test_a_slow_letter_has_a_stamp():
    (stroke,) = recording_of("a").strokes()
    letter = Letter.learn([Trajectory(5 * stroke.t, stroke.position + 1.0)])
    assert distance(letter, read_stamp(stamp_text(letter))) <= 5e-5


def test_no_bytes_with_a_right_check_sum_end_in_another_error():
    rng = np.random.default_rng(0)
    for _ in range(60):
        data = bytes([1, 20, *rng.integers(0, 256, 40)])
        data += binascii.crc_hqx(data, 0).to_bytes(2, "big")
        with suppress(LetterError):
            letter_from_bytes(data)


def photographed(code, angle, rng):
    """A code (H, W) as a camera sees it: turned, tilted, dim, and noisy."""
    picture = Image.fromarray(code).resize((420, 420)).rotate(angle, expand=True, fillcolor=255)
    width, height = picture.size
    corners = (0, 0, 12, height, width, height - 20, width - 18, 8)
    picture = picture.transform(picture.size, Image.Transform.QUAD, corners, fillcolor=255)
    seen = 0.6 * np.asarray(picture, dtype=float) + rng.normal(40, 8, picture.size[::-1])
    return np.clip(seen, 0, 255).astype(np.uint8)


@pytest.mark.parametrize("angle", [0, 17, 90, 200])
def test_a_photo_of_a_stamp_is_read(tmp_path, angle):
    letter = Letter.learn(recording_of("B"))
    code = zxingcpp.create_barcode(stamp_text(letter), zxingcpp.BarcodeFormat.QRCode, ec_level="M")
    seen = photographed(np.array(code.to_image(scale=4)), angle, np.random.default_rng(angle))
    assert distance(letter, read_stamp(seen)) <= 5e-5
    Image.fromarray(seen).save(tmp_path / "photo.jpg", quality=80)
    assert distance(letter, read_stamp(tmp_path / "photo.jpg")) <= 5e-5


def test_the_text_may_be_typed_in_small_letters_and_lines():
    letter = Letter.learn(recording_of("a"))
    text = stamp_text(letter).lower()
    assert distance(letter, read_stamp(f"  {text[:40]}\n{text[40:]} ")) <= 5e-5


def test_a_drawing_of_the_code_is_written_whole(tmp_path):
    path = write_stamp(Letter.learn(recording_of("D")), tmp_path / "d.svg")
    assert path.read_text().startswith("<?xml")
    with pytest.raises(PathError, match=r"\.svg"):
        write_stamp(Letter.learn(recording_of("D")), tmp_path / "d.bmp")


def test_a_mistake_is_noticed_wherever_it_is():
    text = stamp_text(Letter.learn(recording_of("l")))
    for place in range(6, len(text) - 1):
        other = "B" if text[place] == "A" else "A"
        with pytest.raises(LetterError, match=r"damaged|version"):
            read_stamp(text[:place] + other + text[place + 1 :])


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("STAMP:", "damaged"),
        ("STAMP:1890", "A to Z"),
        ("STAMP:é", "A to Z"),
        (np.full((90, 90), 255, np.uint8), "no QR code"),
        (np.zeros((3, 3)), "no picture of bytes|no QR code"),
    ],
)
def test_what_is_no_stamp_is_told(source, words):
    with pytest.raises(LetterError, match=words):
        read_stamp(source)


@pytest.mark.parametrize("what", [None, "a", recording_of("a")])
def test_what_is_no_letter_has_no_stamp(what, tmp_path):
    with pytest.raises(LetterError, match="A stamp holds a Letter"):
        write_stamp(what, tmp_path / "a.svg")


def test_other_settings_are_refused_with_the_cure():
    letter = Letter.learn(recording_of("c"), Settings.original())
    with pytest.raises(LetterError, match=r"learned as Settings\.star"):
        letter_to_bytes(letter)
