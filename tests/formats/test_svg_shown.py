"""SVG as a browser shows it: what is hidden is no ink, and ink is where one sees it."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from tests.formats.test_fuzz import QUIET, letters_or_a_sentence
from tests.formats.test_svg import L, check_hook, read, svg

Z = 'd="M0 0 H90 V70"'
HIDDEN = {
    "visibility": f'<path visibility="hidden" {Z}/>',
    "visibility in a style": f'<path style="visibility:collapse" {Z}/>',
    "a group's visibility": f'<g visibility="hidden"><path {Z}/></g>',
    "opacity": f'<g opacity="0"><path {Z}/></g>',
    "opacity in per cent": f'<path style="opacity: 0%" {Z}/>',
    "what a group says": f'<g style="stroke:none;fill:transparent"><path {Z}/></g>',
    "no width": f'<path fill="none" stroke="red" stroke-width="0px" {Z}/>',
    "see-through": f'<path fill="none" stroke="red" stroke-opacity="0" {Z}/>',
    "a class": f'<style>.h, .k {{ display : none }}</style><path class="a h" {Z}/>',
    "a class and an element": f"<style>path.h{{stroke:none;fill:none}} path{{fill:red}}</style>"
    f'<a><path class="a h" {Z}/></a>',
    "an id": f'<style><![CDATA[#h{{opacity:0}} path{{opacity:1}}]]></style><path id="h" {Z}/>',
    "a frame of a drawing program": '<rect width="100" height="80" style="fill:none;stroke:none"/>',
    "no size": '<circle cx="3" r="0"/><rect x="3" y="9" width="4"/><ellipse rx="0" ry="5"/>',
    "what a browser does not know": '<switch><foreignObject requiredExtensions="x"/></switch>',
}


@pytest.mark.parametrize("kind", HIDDEN)
def test_what_is_hidden_is_no_ink(tmp_path, kind):
    check_hook(read(tmp_path, svg(HIDDEN[kind] + L)))
    with pytest.raises(RecordingError, match="draws nothing"):
        read(tmp_path, svg(HIDDEN[kind]))


UNSEEN = {
    "beside the page": '<path d="M120 10V70"/>',
    "painted in the colour of what is below": '<path stroke="hsl(0 0% 99%)" d="M70 10V70"/>'
    '<g opacity=".5"><path stroke-opacity="10%" d="M80 10V70"/></g>',
    "painted over": '<path d="M70 10V70"/><path d="M80 10V70"/><rect x="65" width="9" height="80" '
    'fill="#fff" stroke="none"/><path stroke="white" stroke-width="6" d="M80 5V75"/>',
    "cut away by a clip": '<clipPath id="c"><rect width="50" height="80"/></clipPath>'
    '<g style="clip-path:url(#c)"><path d="M70 10V70"/><circle cx="80" cy="9" r="2"/></g>',
    "a drawing within the drawing": '<svg width="60" height="80"><path d="M70 10V70"/></svg>',
}


@pytest.mark.parametrize("why", UNSEEN)
def test_what_one_does_not_see_is_left_out_and_told(tmp_path, why):
    recording = read(tmp_path, svg(UNSEEN[why] + L))
    check_hook(recording)
    assert why in " ".join(recording.notes)
    with pytest.raises(RecordingError, match=f"lines that one does not see: .*{why}"):
        read(tmp_path, svg(UNSEEN[why]))


BAR = '<path d="M10 40H90"/>'
LEFT = '<clipPath id="c"><rect id="r" width="50" height="80"/></clipPath>'
HALVED = {
    "a clip": f'{LEFT}<g clip-path="url(#c)">{BAR}</g>',
    "a class, a moved clip, and a clone in it": "<style>.k{clip-path:url('#d')}</style>"
    '<g class="k" transform="translate(-20 0)"><path d="M30 40H110"/></g>'
    f'{LEFT}<clipPath id="d" transform="translate(20 0)"><use href="#r"/></clipPath>',
    "two clips": '<clipPath id="c"><path d="M0 0H50V80H0Z"/></clipPath><clipPath id="d"><circle '
    f'r="200"/></clipPath><g clip-path="url(#c)"><g clip-path="url(#d)">{BAR}</g></g>',
    "a drawing within": f'<svg width="50" height="80">{BAR}</svg>',
    "the page": '<path d="M60 40H140"/>',
    "a white card": f'{BAR}<path stroke="none" fill="white" d="M50 0H100V80H50z"/>',
    "a rubber": f'{BAR}<path d="M60 40H99" stroke="#fff" stroke-width="20"/>',
}


@pytest.mark.parametrize("by", HALVED)
def test_a_line_ends_where_it_is_cut(tmp_path, by):
    recording = read(tmp_path, svg(HALVED[by]))
    (stroke,) = recording.strokes()
    assert np.ptp(stroke.position[:, 0]) == pytest.approx(0.04, abs=2e-4)
    assert "one does not see" in recording.notes[0]


TOLD = {
    "narrow area, as the outline": '<path fill="none" d="M40 10H46V70H40Z"/>',
    "as the outline of a letter": '<g fill="none"><circle cx="40" cy="40" r="30"/>'
    '<circle cx="40" cy="40" r="24"/></g>',
    "lines of 2 colours": L + '<path stroke="#cde" d="M0 50H90"/>',
    "area of a colour": f'{L}<path stroke="none" d="M50 30L60 20L52 31Z"/>',
    "text is no line": L + '<text stroke="black">a</text>',
    "image is no line": L + '<image href="a.png"/>',
    "the pen is lifted": '<line x1="10" y1="10" x2="30" y2="60"/><path d="M30 60L50 10"/>',
}


@pytest.mark.parametrize("what", TOLD)
def test_a_doubt_is_told(tmp_path, what):
    assert what in " ".join(read(tmp_path, svg(TOLD[what])).notes)
    assert what not in " ".join(read(tmp_path, svg(L)).notes)


def test_pixels_are_told(tmp_path):
    assert "96 to the inch" in read(tmp_path, svg(L, 'width="378" height="302px"')).notes[0]


STYLED = {
    "a comment": '<path style="/*display:none*/stroke:red" d="M10 20 V60 H40"/>',
    "a comment that does not end": '<path style="stroke:red;/*display:none" d="M10 20 V60 H40"/>',
    "shown in what is hidden": '<g visibility="hidden"><path visibility="visible" '
    'd="M10 20 V60 H40"/></g>',
    "drawn in what is not": '<g fill="none" stroke="none"><path stroke="#000" d="M10 '
    '20 V60 H40"/></g>',
    "a class of a drawing program": '<style type="text/css">.st0{fill:none;stroke:#000;}</style>'
    '<path class="st0" d="M10 20 V60 H40"/>',
    "a class that others have": '<style>.h{display:none}</style><path class="hh" d="M10 20 '
    'V60 H40"/>',
    "its own style is stronger": '<style>path{display:none}</style><path style="display:inline" '
    'd="M10 20 V60 H40"/>',
    "a style is stronger than an attribute": '<path display="none" style="display:inline" '
    'd="M10 20 V60 H40"/>',
    "inherited": '<g stroke="red" fill="none"><path stroke="inherit" d="M10 20 V60 H40"/></g>',
    "an import": '<style>@import url("x.css"); @font-face{font-family:x} .a{fill:none}</style>' + L,
    "a transform in a style": '<path style="transform: scale(2) translate(1px, 2px)" d="M4 '
    '8 V28 H19"/>',
    "a transform in a sheet": "<style>.a{transform:rotate(90deg) scale(1,-1)}</style>"
    '<path class="a" d="M20 10 H60 V40"/>',
    "important": '<style>path{display:inline !important}</style><path style="display:none" d="M10 '
    '20 V60 H40"/>',
    "a switch": f'<switch><foreignObject requiredExtensions="x"/><g>{L}</g></switch>',
    "beside an area": f'<path stroke="none" {Z}/>{L}',
}


@pytest.mark.parametrize("kind", STYLED)
def test_what_is_shown_is_ink_where_it_is_shown(tmp_path, kind):
    check_hook(read(tmp_path, svg(STYLED[kind])))


def unsaid(body):
    """A drawing that says of no shape how it looks."""
    return svg(body).replace('stroke="black" ', "", 1)


def test_an_open_path_without_any_style_is_a_line_and_a_closed_one_an_area(tmp_path):
    check_hook(read(tmp_path, unsaid(L)))
    check_hook(read(tmp_path, unsaid('<polyline points="10 20 10 60 40 60"/>')))
    check_hook(
        read(tmp_path, unsaid('<path d="M5 5H90V70z"/><rect x="50" width="50" height="9"/>' + L))
    )
    for look in ('fill="red"', 'style="stroke:none"', 'visibility="hidden"'):
        check_hook(read(tmp_path, unsaid(f"{L}<path {look} {Z}/>")))
    with pytest.raises(RecordingError, match="only areas of a colour"):
        read(tmp_path, unsaid(f'<path {Z[:-1]}z"/>'))


STEM = '<path fill="none" stroke="black" d="M10 30V60"/>'
DISC = 'cx="10" cy="15" fill="black" stroke="none"'


DOTS = ['circle r="3"', 'ellipse rx="2" ry="4"']
DOTS += ['rect x="8" y="13" width="4" height="4"', 'path d="M8 15a2 2 0 1 0 4 0a2 2 0 1 0-4 0z"']


@pytest.mark.parametrize("size", DOTS)
def test_a_small_filled_disc_beside_a_line_is_a_dot(tmp_path, size):
    stem, dot = read(tmp_path, svg(f"{STEM}<{size} {DISC}/>")).strokes()
    assert np.ptp(stem.position, axis=0) == pytest.approx((0, 0.03), abs=1e-6)
    assert np.allclose(dot.position, [0, 0.045], rtol=0, atol=1e-5)
    first, _ = read(tmp_path, unsaid(f"<{size} cx='10' cy='15'/>{STEM}")).strokes()
    assert np.allclose(first.position, [0, 0.045], rtol=0, atol=1e-5)


ROUND = "a2 2 0 1 0 4 0a2 2 0 1 0-4 0z"
AREAS = {
    f"M8 15{ROUND}M18 15{ROUND}": 2,
    f"M8 15{ROUND}M9 15a1 1 0 1 0 2 0a1 1 0 1 0-2 0z": 0,
    "M60 60h8v2h-6l6-8v-3h-8v2h5l-6 7z": 0,
}


@pytest.mark.parametrize("way", AREAS)
def test_two_dots_may_be_one_path_and_a_filled_ring_or_sign_is_none(tmp_path, way):
    area = f'<path stroke="none" fill-rule="evenodd" d="{way}"/>'
    recording = read(tmp_path, svg(STEM + area))
    assert len(recording.strokes()) == 1 + AREAS[way]
    assert bool(AREAS[way]) != ("area of a colour" in " ".join(recording.notes))


def test_a_large_filled_disc_or_one_without_a_line_is_no_dot(tmp_path):
    check_hook(read(tmp_path, svg(f'<circle r="40" {DISC}/>{L}'.replace("black", "pink"))))
    with pytest.raises(RecordingError, match="only areas of a colour"):
        read(tmp_path, svg(f'<circle r="3" {DISC}/>'))


@pytest.mark.parametrize("turn", ['rx="20"', 'ry="20"', 'rx="90" ry="20"'])
def test_rectangles_have_round_corners(tmp_path, turn):
    box = (
        read(tmp_path, svg(f'<rect x="10" y="10" width="40" height="40" {turn}/>'))
        .strokes()[0]
        .position
    )
    assert np.abs(np.linalg.norm(box - 0.02, axis=1) - 0.02).max() < 1e-4, "a circle"


NOT_FOLLOWED = {
    "style clip-path": f'<g clip-path="url(#c)">{L}</g>',
    "style mask": f'<style>.a{{mask:url(#m)}}</style><g class="a">{L}</g>',
    "style mask-image": f'<g style="mask-image:url(#m)">{L}</g>',
    "colour 'var(--page)'": '<path d="M0 0L9 9" stroke="var(--page)"/>',
    "style rotate": '<path style="rotate:9deg" d="M0 0L9 9"/>',
    "style transform-origin": f'<g transform="scale(2)" transform-origin="5 5">{L}</g>',
    "style transform-box": f'<g style="transform-box:fill-box">{L}</g>',
    "style rule 'g > .h'": "<style>g > .h{display:none}</style>" + L,
    "style rule 'g path'": "<style>g path{transform:scale(2)}</style>" + L,
    "style rule 'path:hover'": "<style>path:hover{opacity:0}</style>" + L,
    "style rule 'path.h.k'": "<style>path.h.k{opacity:0}</style>" + L,
    "style rules inside others": "<style>@media print{path{display:none}}</style>" + L,
}


@pytest.mark.parametrize("name", NOT_FOLLOWED)
def test_what_is_not_followed_is_refused_by_name(tmp_path, name):
    sentence = rf"has (a |the |){re.escape(name)}, which (is|are) not followed here; "
    with pytest.raises(RecordingError, match=sentence):
        read(tmp_path, svg(NOT_FOLLOWED[name]))


def test_what_is_hidden_may_have_what_is_not_followed(tmp_path):
    check_hook(read(tmp_path, svg(f'<g display="none"><g mask="url(#m)">{L}</g></g>{L}')))


@QUIET
@given(
    sheet=st.text("a.#*{}:;,>/@!display nonetrkfil0m-<", max_size=60),
    style=st.text("/*;:!%display nonetrkfil0m-", max_size=40),
)
def test_styles_of_any_signs(tmp_path, sheet, style):
    sheet, style = (text.replace("<", "&lt;") for text in (sheet, style))
    body = (
        f'<svg><style>{sheet}</style><g class="a"><path id="a" style="{style}" d="M0 0L9 9"/>'
        f"</g></svg>"
    )
    letters_or_a_sentence(tmp_path / "a.svg", body.encode())
