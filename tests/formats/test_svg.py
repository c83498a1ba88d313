"""SVG: a drawing becomes the way of a pen, and letters become drawings that others read."""

import re
import shutil
import subprocess
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from svgelements import SVG, Path

from dmp_teach.errors import RecordingError
from dmp_teach.formats.hand_pace import at_hand_pace
from dmp_teach.formats.read import read_recording
from dmp_teach.formats.write import write_recording
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.trajectory import Trajectory

SPACE = 'xmlns="http://www.w3.org/2000/svg"'
HOOK = np.array([[0.0, 0.04], [0.0, 0.0], [0.03, 0.0]])  # an L, right and up [m]


def svg(body, head='width="100mm" height="80mm" viewBox="0 0 100 80"'):
    """A drawing whose shapes are lines unless they say otherwise."""
    return f'<svg {SPACE} stroke="black" {head}>{body}</svg>'


def read(tmp_path, text, **which):
    (tmp_path / "a.svg").write_text(text, encoding="utf-8")
    return read_recording(tmp_path / "a.svg", **which)


def corners(recording):
    """Where each stroke begins, ends and how large it is [m]."""
    return [
        (*s.position[0], *s.position[-1], *np.ptp(s.position, axis=0)) for s in recording.strokes()
    ]


def check_hook(recording):
    assert len(recording.strokes()) == 1
    assert corners(recording)[0] == pytest.approx((0.0, 0.04, 0.03, 0.0, 0.03, 0.04), abs=1e-6)
    path = recording.strokes()[0].position
    assert np.minimum(np.abs(path[:, 0]), np.abs(path[:, 1])).max() < 1e-6, (
        "the ink stays where it was drawn"
    )


def good_files(_):
    """For the tests of damaged files: shapes, then styles and views."""
    way = "M1 2c3 4 5 6 7 8s9 9 1 1q1 2 3 4t5 6a7 8 9 0 1 5 5z"
    body = f'<title>a by w01</title><g transform="rotate(9) scale(2)"><path d="{way}"/></g>'
    body += '<circle r="4"/><rect width="9" height="3"/><polyline points="1 2 3,4"/>'
    body += '<line x2="3" id="l"/><use href="#l" x="4"/>'
    drawn = "<style>/* a */.h, #i{display:none} path.k{fill:none}</style>"
    drawn += '<rect width="100%" height="100%" stroke="none"/><g class="h"><path d="M1 1L3 9"/></g>'
    drawn += '<circle r="9"/>'
    drawn += '<g style="stroke:red" transform="rotate(9 5 5)"><path d="M0 0h9v9"/></g>'
    return {
        "a.svg": svg(body, 'width="9cm" viewBox="0 0 90 60"').encode(),
        "b.svg": svg(drawn, 'viewBox="0 0 90 60" data-character="ab" data-writer="w01"').encode(),
    }


L = '<path d="M10 20 V60 H40"/>'
SAME = {
    "as it is": svg(L),
    "centimetres": svg(L, 'width="10cm" height="8cm" viewBox="0 0 100 80"'),
    "inches": svg(L, f'width="{100 / 25.4}in" height="{80 / 25.4}in" viewBox="0 0 100 80"'),
    "one length": svg(L, 'width="100mm" viewBox="0 0 100 80"'),
    "a share of the window": svg(L, 'width="100%" height="80mm" viewBox="0 0 100 80"'),
    "letterboxed": svg(L, 'width="200mm" height="80mm" viewBox="0 0 100 80"'),
    "stretched": svg(
        '<path d="M5 20 V60 H20"/>',
        'width="100mm" height="80mm" viewBox="0 0 50 80" preserveAspectRatio="none"',
    ),
    "a view elsewhere": svg(L, 'width="100mm" height="80mm" viewBox="-50, -10, 100, 80"'),
    "pixels": svg(f'<g transform="scale({96 / 25.4})">{L}</g>', ""),
    "pixels said": svg(
        f'<path transform="scale({96 / 25.4})" d="M10 20 V60 H40"/>', 'width="900px" height="700"'
    ),
    "relative": svg('<path d="m10,20 0,40 30,0"/>'),
    "polyline": svg('<polyline points="10,20 10,60, 40 60"/>'),
    "transforms": svg(
        '<g transform="translate(10 20)"><g transform="rotate(90) scale(1,-1)">'
        '<path d="M0 0 H40 V30"/></g></g>'
    ),
    "matrix": svg('<path transform="matrix(2 0 0 2 -3 -9)" d="M10 20 v20 h15"/>'),
    "an editor's": svg(
        f'<title>x</title><defs><path d="M0 0 L9 9"/></defs><metadata/><g id="layer1">{L}</g>'
    ),
    "a declaration": '<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD '
    'SVG 1.1//EN" "http://www.w3.org/s.dtd">' + svg(L),
    "no namespace": svg(L).replace(SPACE, ""),
    "curves that are straight": svg('<path d="M10 20 C10 30 10 50 10 60 Q25 60 40 60"/>'),
    "a clone": svg(
        '<defs><g id="l"><path id="m" d="M0 0 V40 H30"/></g></defs>'
        '<g transform="translate(3 0)"><use href="#l" x="7" y="20"/></g>'
    ),
    "a clone by an old name": svg(
        '<symbol><path id="m" d="M0 0 V40 H30"/></symbol>'
        '<use xmlns:xlink="http://www.w3.org/1999/xlink" xlink:href="#m" transform="translate(10 '
        '20)"/>'
    ),
    "drawn twice": svg(L + '<polyline points="10,20 10,60 40,60" stroke="red"/>'),
    "drawn there and back": svg(L + '<path d="M40 60H10V20"/>'),
    "sketched twice": svg(L + '<path d="M10.4 20.3 V60.3 L39.6 60.1"/>'),
    "a symbol": svg(
        '<symbol id="s" viewBox="0 0 20 16"><path d="M2 4V12H8"/></symbol>'
        '<use href="#s" width="100" height="80"/>'
    ),
    "a drawing within": svg(
        '<svg x="10" y="20" width="30" height="40" viewBox="0 0 3 4"><path d="M0 0V4H3"/></svg>'
    ),
    "in the view of a program": svg(
        f'<g clip-path="url(#c)"><rect width="100%" height="80" fill="white" stroke="none"/>{L}</g>'
        '<defs><clipPath id="c"><rect width="100" height="80"/></clipPath></defs>'
    ),
    "on no paper": svg(f"<style>svg{{background:none}}</style>{L}"),
    "on paper of a light and a dark look": svg(
        '<rect width="100%" height="80" stroke="none" style="fill:light-dark(#fff, var(--a))"/>'
        + L.replace("<path", '<path style="stroke:light-dark(rgb(0, 0, 0), rgb(255, 255, 255))"')
    ),
    "on squared paper": svg('<rect width="100%" height="80" stroke="none" fill="url(#p)"/>' + L),
    "on a blackboard": svg(
        '<rect width="100" height="80" fill="#021" stroke="none"/>'
        '<path stroke="#fff" d="M70 10V70"/><rect width="99" height="79" fill="#021"/>'
        + L.replace("<path", '<path stroke="rgb(255 255 255 / 90%)"')
    ),
    "under a card that is cut away": svg(
        f'{L}<clipPath id="c"><rect width="9" height="9"/></clipPath><g clip-path="url(#c)">'
        '<path stroke="none" fill="#fff" d="M0 0H90V70H0z"/></g>'
    ),
    "for a printer": svg(f'<style media="print">path{{display:none}}</style>{L}'),
    "with a halo": svg(L.replace("<path", '<path stroke="white" stroke-width="5"') + L),
    "a switch of languages": svg(f'<switch>{L}<path d="M70 10V70"/></switch>'),
    "an empty path": svg('<path d=""/><path/><path d="M 3 4"/>' + L),
}


@pytest.mark.parametrize("how", SAME)
def test_the_same_drawing_is_the_same_letter(tmp_path, how):
    check_hook(read(tmp_path, SAME[how]))


def curve(pieces):
    """A wave with one bend, in so many pieces."""
    x = np.linspace(5, 95, pieces + 1)
    y = np.where(x < 50, 40 + 20 * np.sin(x / 9), 20 + np.abs(x - 80))
    return [
        f"M{a:.2f} {b:.2f}L{c:.2f} {d:.2f}" for (a, b), (c, d) in pairwise(zip(x, y, strict=True))
    ]


@pytest.mark.parametrize("pieces", [39, 1500])
def test_pieces_that_continue_each_other_are_one_stroke(tmp_path, pieces):
    body = "".join(
        f'<path stroke-width="{1 + k % 3}" d="{d}"/>' for k, d in enumerate(curve(pieces))
    )
    (stroke,) = read(tmp_path, svg(body)).strokes()
    assert np.ptp(stroke.position[:, 0]) == pytest.approx(0.09, abs=1e-4)


@pytest.mark.parametrize("turned", ["ccc", "aca", "cac"])
def test_pieces_may_go_either_way_in_a_longer_row(tmp_path, turned):
    ends = {"a": "{0} 40H{1}", "c": "{1} 40H{0}"}
    pieces = [ends[turned[k % 3]].format(10 + 7 * k, 17 + 7 * k) for k in range(11)]
    (stroke,) = read(tmp_path, svg(f'<path d="M{" M".join(pieces)}"/>')).strokes()
    assert np.ptp(stroke.position[:, 0]) == pytest.approx(0.077, abs=1e-4)
    # Of a few, each is a stroke of a hand: an o of two bows from its top.
    bows = '<path d="M50 20A20 20 0 0 0 50 60M50 20A20 20 0 0 1 50 60"/>'
    assert len(read(tmp_path, svg(bows)).strokes()) == 2


def test_arcs_are_one_round_and_what_lies_side_by_side_stays_apart(tmp_path):
    arcs = ["70 50A20 20 0 0 1 50 70", "50 70A20 20 0 0 1 30 50", "30 50A20 20 0 0 1 50 30"]
    assert len(read(tmp_path, svg("".join(f'<path d="M{d}"/>' for d in arcs))).strokes()) == 1
    apart = '<path d="M20 40H60M20 46H60M10 9h0M14 9h0"/>'
    assert len(read(tmp_path, svg(apart)).strokes()) == 4


@pytest.mark.parametrize("between", ['"/><path d="', ""])
@pytest.mark.parametrize("letter", ["10 10L30 60 50 10", "10 60V10L50 60V10"], ids=["V", "N"])
def test_strokes_that_meet_end_to_end_stay_apart(tmp_path, letter, between):
    pen_lifted = letter.replace("30 60 50", f"30 60{between}M30 60L50")
    pen_lifted = pen_lifted.replace("V10L", f"V10{between}M10 10L")
    assert len(read(tmp_path, svg(f'<path d="M{letter}"/>')).strokes()) == 1
    assert len(read(tmp_path, svg(f'<path d="M{pen_lifted}"/>')).strokes()) == 2
    once = [[[0.0, 0.05], [0.02, 0.0]], [[0.02, 0.0], [0.04, 0.05]]]
    path = write_recording(by_hand([np.array(way) for way in once]), tmp_path / "ours.svg")
    assert len(read_recording(path).strokes()) == 2


def test_every_move_begins_a_stroke_in_the_order_of_the_file(tmp_path):
    body = (
        '<path d="M10 10 L10 50 M10 10 C40 10 40 50 10 50"/><line x1="0" y1="30" x2="20" '
        'y2="30"/><path d="M30 60 h0"/>'
    )
    recording = read(tmp_path, svg(body))
    first, second, third, dot = corners(recording)
    assert first[:4] == pytest.approx((0.01, 0.05, 0.01, 0.01), abs=1e-6)
    assert second[:4] == pytest.approx((0.01, 0.05, 0.01, 0.01), abs=1e-6)
    assert second[4] == pytest.approx(0.0225, abs=1e-5)
    assert third[:4] == pytest.approx((0.0, 0.03, 0.02, 0.03), abs=1e-6)
    assert dot == pytest.approx((0.03, 0.0, 0.03, 0.0, 0.0, 0.0), abs=1e-6)
    lifts = [b.t[0] - a.t[-1] for a, b in pairwise(recording.strokes())]
    assert lifts == pytest.approx([0.4] * 3)
    assert recording.position[:, 2].max() > 0.01


def test_shapes_are_drawn_as_svg_says(tmp_path):
    body = (
        '<circle cx="30" cy="30" r="20"/><rect x="5" y="5" width="10" height="20"/>'
        '<polygon points="0,0 9,0 9,9"/>'
    )
    body += '<ellipse cx="30" cy="30" rx="20" ry="10"/><path d="M10 30 A20 20 0 0 1 50 30"/>'
    round_, box, wedge, oval, arc = corners(read(tmp_path, svg(body)))
    assert round_[4:] == pytest.approx((0.04, 0.04), abs=2e-5)
    assert round_[:2] == pytest.approx(round_[2:4], abs=1e-6)
    assert box[4:] == pytest.approx((0.01, 0.02), abs=2e-5)
    assert wedge[4:] == pytest.approx((0.009, 0.009), abs=1e-4)
    assert oval[4:] == pytest.approx((0.04, 0.02), abs=2e-5)
    assert arc[4:] == pytest.approx((0.04, 0.02), abs=2e-5)


def test_a_title_of_one_sign_is_the_letter_and_other_titles_stay_out(tmp_path):
    for title, about in {
        "D": ("D", None),
        "D by w07": ("D", "w07"),
        "by w07": (None, "w07"),
        "a\u0308": ("ä", None),
        "Drawing by Anna": (None, None),
        "Anna": (None, None),
    }.items():
        recording = read(tmp_path, svg(f"<title>{title}</title>{L}"))
        assert (recording.character, recording.writer) == about


def by_hand(strokes):
    """Ways without times as a hand would write them."""
    return [Trajectory(t, position) for t, position in at_hand_pace(strokes)]


points = st.lists(st.tuples(st.floats(-0.1, 0.1), st.floats(-0.1, 0.1)), min_size=2, max_size=12)


@settings(max_examples=30, deadline=None)
@given(strokes=st.lists(points, min_size=1, max_size=3))
def test_a_hand_starts_and_stops_at_rest_and_never_leaves_the_ink(strokes):
    strokes = [np.array(stroke) for stroke in strokes]
    size = np.ptp(np.concatenate(strokes), axis=0).max()
    if size < 1e-3:
        return
    written = by_hand(strokes)
    for stroke, points_ in zip(written, strokes, strict=True):
        assert np.allclose(stroke.position[[0, -1]], points_[[0, -1]], atol=1e-3 * size)
        step = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1) * 120
        assert max(step[0], step[-1]) < 0.02 * size
        assert step.max() < 4 * size
        assert np.abs(np.diff(step)).max() * 120 < 80 * size
        away = [distance(each, points_) for each in stroke.position[:: max(1, len(stroke) // 20)]]
        assert max(away) < 1e-6 + 1e-4 * size
    assert all(b.t[0] - a.t[-1] == pytest.approx(0.4) for a, b in pairwise(written))


def distance(point, way):
    """From a point to a polyline."""
    a, b = way[:-1], way[1:]
    along = np.clip(((point - a) * (b - a)).sum(1) / np.maximum(((b - a) ** 2).sum(1), 1e-30), 0, 1)
    return np.linalg.norm(a + along[:, None] * (b - a) - point, axis=1).min()


def test_bends_are_slow_and_a_large_letter_takes_no_longer():
    s = np.linspace(0, 2 * np.pi, 400)
    (oval,) = by_hand([np.column_stack([0.05 * np.cos(s), 0.015 * np.sin(s)])])
    speed = np.linalg.norm(np.gradient(oval.position, oval.t, axis=0), axis=1)
    middle = slice(len(speed) // 5, -len(speed) // 5)
    tip, flat = np.abs(oval.position[middle, 0]) > 0.045, np.abs(oval.position[middle, 0]) < 0.02
    assert speed[middle][tip].mean() < 0.8 * speed[middle][flat].mean()
    (large,) = by_hand([np.column_stack([0.5 * np.cos(s), 0.15 * np.sin(s)])])
    assert large.duration == pytest.approx(oval.duration, abs=0.02)


@pytest.mark.parametrize("length", [0.01, 0.06, 0.3])
def test_a_bar_is_one_bell_of_speed(length):
    (stroke,) = by_hand([np.array([[0.0, 0.0], [0.0, -length]])])
    speed = np.linalg.norm(np.gradient(stroke.position, stroke.t, axis=0), axis=1)
    peak = stroke.t[np.argmax(speed)] / stroke.duration
    assert 0.4 < peak < 0.6
    assert 0.3 < speed.mean() / speed.max() < 0.6
    assert speed[stroke.t < 0.15 * stroke.duration].max() < 0.35 * speed.max()


@pytest.mark.parametrize("letter", ["a", "D", "i", "M"])
def test_what_is_written_is_read_again_to_the_micrometre_and_by_others(tmp_path, letter):
    once = recording_of(letter)
    path = write_recording(once, tmp_path / "a.svg")
    again = read_recording(path)
    assert (again.character, again.writer, again.baseline) == (letter, once.writer, once.baseline)
    assert len(again.strokes()) == len(once.strokes())
    for one, other in zip(once.strokes(), again.strokes(), strict=True):
        assert max(distance(point, one.position) for point in other.position[::5]) < 1e-6
        assert np.allclose(one.position[[0, -1]], other.position[[0, -1]], atol=1e-6)
    drawn = [Path(each) for each in SVG.parse(str(path)).elements() if isinstance(each, Path)]
    assert len(drawn) == len(once.strokes())
    millimetre = 96 / 25.4
    for stroke, other in zip(once.strokes(), drawn, strict=True):
        box = other.bbox()
        assert (box[2] - box[0], box[3] - box[1]) == pytest.approx(
            np.ptp(stroke.position, axis=0) * 1000 * millimetre, abs=0.01
        )
    root = ElementTree.parse(path).getroot()
    assert root.get("width").endswith("mm")
    assert not re.search(r"\d{4}-\d\d|date|time", path.read_text())


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("chromium"), reason="no browser")
def test_a_browser_shows_the_ink(tmp_path):
    from PIL import Image  # noqa: PLC0415

    write_recording(recording_of("D"), tmp_path / "d.svg")
    quiet = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--no-first-run",
        "--disable-background-networking",
    ]
    shot = [
        f"--screenshot={tmp_path / 'd.png'}",
        "--window-size=400,600",
        f"--user-data-dir={tmp_path / 'user'}",
    ]
    subprocess.run(
        ["chromium", *quiet, *shot, f"file://{tmp_path / 'd.svg'}"],
        check=True,
        capture_output=True,
        timeout=120,
    )
    dark = np.argwhere(np.asarray(Image.open(tmp_path / "d.png").convert("L")) < 128)
    height = (
        np.ptp(np.vstack([s.position for s in recording_of("D").strokes()])[:, 1]) * 96 / 0.0254
    )
    assert np.ptp(dark[:, 0]) == pytest.approx(height, abs=6)


BROKEN = {
    "nothing": (svg(""), "draws nothing. Draw the middle of the letter with a line"),
    "text only": (svg("<text>a</text>"), "holds text of a font, whose letters are areas, and no"),
    "a font": (
        svg('<defs><font><glyph d="M0 9V0"/></font></defs>'),
        "is a font, and draws nothing",
    ),
    "an outline": (
        svg('<path stroke="none" d="M40 10H46V90H40Z"/>'),
        "only areas of a colour: the outline of a letter is not the way of a pen. Draw the middle",
    ),
    "an outline with an edge": (
        svg('<path fill="#000" d="M40 10H46V70H40Z"/>'),
        "only areas of a colour: the outline of a letter is not the way of a pen. Draw the middle",
    ),
    "a clone of nothing": (
        svg('<use href="#a"/>'),
        "has a clone .use. of '#a', not of a shape; unlink",
    ),
    "a bomb of clones": (
        svg('<g id="a"><use href="#a"/><use href="#a"/></g>'),
        "has more than 1000 clones .use., or clones of clones of themselves; unlink",
    ),
    "a picture": (svg('<image href="file:///etc/passwd"/>'), "holds a picture, and no line. Draw"),
    "a word in a path": (
        svg('<path d="M0 0 L nine"/>'),
        "the path 'M0 0 L nine' cannot be read: it must begin with M",
    ),
    "no move": (svg('<path d="L9 9"/>'), "it must begin with M"),
    "a number is missing": (svg('<path d="M0 0 C 1 1"/>'), "the path 'M0 0 C 1 1' cannot be read"),
    "endless": (svg('<path d="M0 0 L1e400 3"/>'), "the ink is inf m large"),
    "endless arcs": (
        svg('<path d="M0 0 a1e308 1e308 0 0 1 1e308 5"/>'),
        "(the ink is inf m large|cannot be followed)",
    ),
    "a mile": (svg('<path d="M0 0 L1e6 3"/>'), "the ink is 1000 m large, but must be"),
    "a speck": (svg('<path d="M0 0 L0.01 0"/>'), "the ink is 1e-05 m large"),
    "an odd length": (
        svg(L, 'width="wide"'),
        "width is 'wide', but must be a length such as '210mm'",
    ),
    "an odd view": (svg(L, 'viewBox="0 0 0 9"'), "viewBox is '0 0 0 9', but must be four numbers"),
    "an odd transform": (
        svg('<g transform="url(x)"><path d="M0 0L9 9"/></g>'),
        r"transform is 'url\(x\)', which cannot",
    ),
    "a transform in depth": (
        svg('<path style="transform:rotate3d(1,1,1,9deg)" d="M0 0"/>'),
        "transform is 'rotate3d.*cannot be read",
    ),
    "a flat transform": (
        svg('<g transform="scale(0)"><path d="M0 0L9 9"/></g>'),
        "the ink is 0 m large",
    ),
    "an odd place": (svg('<line x1="left" x2="9"/>'), "x1 is 'left', but must be a number"),
    "a scribble": (
        svg('<path d="M0 0' + "l9 9 l-9 -9" * 2000 + '"/>'),
        "times as long as the ink is large are no letter",
    ),
    "dust": (
        svg("".join(f'<path d="M{k / 15} {k % 70} h1"/>' for k in range(1001))),
        "1001 strokes .* are no letter",
    ),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_cannot_be_drawn_says_why(tmp_path, fault):
    text, sentence = BROKEN[fault]
    with pytest.raises(RecordingError, match=rf"a\.svg: .*{sentence}") as caught:
        read(tmp_path, text)
    assert len(str(caught.value)) < 400
