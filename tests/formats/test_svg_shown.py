"""SVG as a browser shows it: what is hidden is no ink, and what is moved or a share is where one sees it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.formats.svg.style import Styles
from tests.formats.test_fuzz import QUIET, letters_or_a_sentence
from tests.formats.test_svg import L, check_hook, corners, read, svg

Z = 'd="M0 0 H90 V70"'
HIDDEN = {
    "visibility": f'<path visibility="hidden" {Z}/>',
    "visibility in a style": f'<path style="visibility:collapse" {Z}/>',
    "a group's visibility": f'<g visibility="hidden"><path {Z}/></g>',
    "opacity": f'<g opacity="0"><path {Z}/></g>',
    "opacity in per cent": f'<path style="opacity: 0%" {Z}/>',
    "neither stroke nor fill": f'<path stroke="none" fill="none" {Z}/>',
    "what a group says": f'<g style="stroke:none;fill:transparent"><path {Z}/></g>',
    "no width": f'<path fill="none" stroke="red" stroke-width="0px" {Z}/>',
    "see-through": f'<path fill="none" stroke="red" stroke-opacity="0" {Z}/>',
    "a class": f'<style>.h, .k {{ display : none }}</style><path class="a h" {Z}/>',
    "a class and an element": f"<style>path.h.a{{stroke:none;fill:none}} path{{fill:red}}</style>"
    f'<a><path class="a h" {Z}/></a>',
    "an id": f'<style><![CDATA[#h{{opacity:0}} path{{opacity:1}}]]></style><path id="h" {Z}/>',
    "everything that is important": f"<style>*{{stroke:red}} .h{{display:none!important}}</style>"
    f'<path class="h" style="display:inline" {Z}/>',
    "a screen": f"<style>/* a */ @media screen {{ .h {{visibility:hidden}} }}</style><path class='h' {Z}/>",
    "paper": '<rect width="100%" height="100%" fill="white"/>',
    "paper in units": '<rect x="-5" y="-5" width="110" height="90" style="fill:#fff;stroke:none"/>',
    "paper as a path": '<path fill="#eee" d="M0 0H100V80H0z"/>',
    "no size": '<circle cx="3" r="0"/><rect x="3" y="9" width="4"/><ellipse rx="0" ry="5"/>',
    "another language": f'<switch><path systemLanguage="xx" {Z}/><foreignObject requiredExtensions="x"/><g/></switch>',
}


@pytest.mark.parametrize("kind", HIDDEN)
def test_what_is_hidden_is_no_ink(tmp_path, kind):
    check_hook(read(tmp_path, svg(HIDDEN[kind] + L)))
    with pytest.raises(RecordingError, match="draws nothing"):
        read(tmp_path, svg(HIDDEN[kind]))


STYLED = {
    "a comment": '<path style="/*display:none*/stroke:red" d="M10 20 V60 H40"/>',
    "a comment that does not end": '<path style="stroke:red;/*display:none" d="M10 20 V60 H40"/>',
    "shown in what is hidden": '<g visibility="hidden"><path visibility="visible" d="M10 20 V60 H40"/></g>',
    "drawn in what is not": '<g fill="none" stroke="none"><path stroke="#000" d="M10 20 V60 H40"/></g>',
    "no colour said": '<path fill="none" d="M10 20 V60 H40"/>',
    "only filled": '<path stroke="none" fill="black" d="M10 20 V60 H40"/>',
    "a class of a drawing program": '<style type="text/css">.st0{fill:none;stroke:#000;}</style>'
    '<path class="st0" d="M10 20 V60 H40"/>',
    "a class that others have": '<style>.h{display:none}</style><path class="hh" d="M10 20 V60 H40"/>',
    "a mouse over it": "<style>path:hover{opacity:0} @media print{path{display:none}}</style>" + L,
    "its own style is stronger": '<style>path{display:none}</style><path style="display:inline" d="M10 20 V60 H40"/>',
    "a style is stronger than an attribute": '<path display="none" style="display:inline" d="M10 20 V60 H40"/>',
    "inherited": '<g stroke="red" fill="none"><path stroke="inherit" d="M10 20 V60 H40"/></g>',
    "another sheet": '<style type="text/x">path{display:none}</style>' + L,
    "an import": '<style>@import url("x.css"); @font-face{font-family:x} .a{fill:none}</style>' + L,
    "a transform in a style": '<path style="transform: scale(2) translate(1px, 2px)" d="M4 8 V28 H19"/>',
    "a transform in a sheet": "<style>.a{transform:rotate(90deg) scale(1,-1)}</style>"
    '<path class="a" d="M20 10 H60 V40"/>',
    "about a point": '<g transform="rotate(90)" transform-origin="10 20"><path d="M10 20 H50 V-10"/></g>',
    "about a share": '<g style="transform:rotate(.5turn);transform-origin:50% center"><path d="M90 60 V20 H60"/></g>',
    "about a corner": '<g style="transform:scale(-1,1);transform-origin:bottom right"><path d="M90 20 V60 H60"/></g>',
    "shares": '<line x1="10%" y1="25%" x2="10%" y2="75%" visibility="hidden"/>' + L,
    "a switch": f"<switch><g>{L}</g><g><path {Z}/></g></switch>",
    "a view at half size": '<svg width="50%" height="50%" viewBox="0 0 10 8"><path d="M2 4 V12 H8"/></svg>',
    "a view that is not wide": '<svg width="100" height="40" viewBox="0 0 40 40"><path d="M-20 20 V60 H10"/></svg>',
    "a view at the left": '<svg width="100" height="40" viewBox="0 0 40 40" preserveAspectRatio="xMinYMax">'
    + L
    + "</svg>",
    "a view that is filled": '<svg width="40" height="80" viewBox="0 0 40 40" preserveAspectRatio="xMaxYMid slice">'
    '<path d="M25 10 V30 H40"/></svg>',
}


@pytest.mark.parametrize("kind", STYLED)
def test_what_is_shown_is_ink_where_it_is_shown(tmp_path, kind):
    check_hook(read(tmp_path, svg(STYLED[kind])))


def test_views_and_origins_are_where_one_sees_them(tmp_path):
    """Each bar ends where the L has its corner, at (10, 60)."""
    for bar in (
        '<svg width="100" height="40" viewBox="0 0 40 40"><path d="M-20 20 V60"/></svg>',
        '<svg width="100" height="40" viewBox="0 0 40 40" preserveAspectRatio="xMaxYMid"><path d="M-50 20 V60"/></svg>',
        '<svg width="40" height="80" viewBox="0 0 40 40" preserveAspectRatio="xMidYMin slice">'
        '<path d="M15 10V30"/></svg>',
        '<svg x="10%" y="25%" width="50%" height="50%"><line y2="100%"/></svg>',
        '<g style="transform:scale(-1);transform-origin:50% center"><path d="M90 60 V20"/></g>',
        '<g style="transform:scale(-1,1);transform-origin:right top"><path d="M190 20 V60"/></g>',
        '<g transform="rotate(90)" transform-origin="10 20"><path d="M10 20 H50"/></g>',
    ):
        stem, foot = read(tmp_path, svg(bar + '<path d="M10 60 H40"/>')).strokes()
        assert np.allclose(stem.position[[0, -1]], [(0, 0.04), (0, 0)], atol=1e-6), bar
        assert np.allclose(foot.position[[0, -1]], [(0, 0), (0.03, 0)], atol=1e-6), bar


def test_shares_are_those_of_the_view(tmp_path):
    ring, box = corners(
        read(tmp_path, svg('<circle cx="50%" cy="50%" r="10%"/><rect width="50%" height="25%"/>'))
    )
    assert ring[4] == pytest.approx(0.2 * np.hypot(0.1, 0.08) / np.sqrt(2), abs=5e-5)
    assert box[4:] == pytest.approx((0.05, 0.02), abs=2e-5)
    box = corners(
        read(tmp_path, svg('<rect width="50%" height="100%"/>', 'width="60mm" height="40mm"'))
    )[0]
    assert box[4:] == pytest.approx((0.03, 0.04), abs=2e-5)


@pytest.mark.parametrize("turn", ['rx="20"', 'ry="20"', 'rx="90" ry="20"', 'style="rx:20px"'])
def test_rectangles_have_round_corners(tmp_path, turn):
    box = (
        read(tmp_path, svg(f'<rect x="10" y="10" width="40" height="40" {turn}/>'))
        .strokes()[0]
        .position
    )
    assert np.abs(np.linalg.norm(box - 0.02, axis=1) - 0.02).max() < 1e-4, "a circle"


def test_a_frame_or_a_letter_as_large_as_the_page_is_ink(tmp_path):
    for body in (
        '<rect width="100" height="80"/>',
        '<rect width="100" height="80" fill="white" stroke="black"/>',
        '<rect width="99%" height="90%" fill="white"/>',
        '<path fill="black" d="M50 0 L100 80 L0 80 z"/>',
    ):
        assert len(read(tmp_path, svg(body)).strokes()) == 1


BROKEN = {
    "a rule in a rule's place": (
        svg("<style>g > .h{display:none}</style>" + L),
        "style rule 'g > .h', which is not fol",
    ),
    "a rule that moves": (
        svg("<style>g path{transform:scale(2)}</style>" + L),
        "style rule 'g path'.*styles themselves",
    ),
    "one transform alone": (
        svg('<path style="rotate:9deg" d="M0 0L9 9"/>'),
        "has the style rotate, which is not follow",
    ),
    "a way in a style": (
        svg("<path style=\"d:path('M0 0')\"/>"),
        "has the style d, which is not followed",
    ),
    "in depth": (
        svg('<path style="transform:rotate3d(1,1,1,9deg)" d="M0 0"/>'),
        "transform is 'rotate3d.*cannot be read",
    ),
    "a box of its own": (
        svg('<g style="transform:scale(2);transform-box:fill-box"/>'),
        "transform-box 'fill-box', which",
    ),
    "a share of nothing": (
        svg('<circle r="5%"/>', ""),
        "r is '5%', a share of a drawing that says neither its viewBox",
    ),
    "an odd origin": (
        svg('<g transform="scale(2)" transform-origin="here"/>'),
        "transform-origin is 'here', but must be",
    ),
    "an empty view": (
        svg(f'<svg width="0">{L}</svg>'),
        "width is '0', but must be more than 0; delete what is empty",
    ),
    "many rules": (
        svg(f"<style>{'.a,' * 20_001}b{{fill:red}}</style>" + L),
        "more than 20000 style rules; give its",
    ),
    "heavy sheets": (
        svg(
            "<style>" + ".a{fill:red}" * 3000 + "</style>" + '<path class="a" d="M0 0L9 9"/>' * 1000
        ),
        "style sheets that take more than 2000000 steps",
    ),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_is_not_followed_is_refused_by_name(tmp_path, fault):
    text, sentence = BROKEN[fault]
    with pytest.raises(RecordingError, match=rf"a\.svg: .*{sentence}") as caught:
        read(tmp_path, text)
    assert len(str(caught.value)) < 400


@QUIET
@given(
    sheet=st.text("a.#*{}:;,>/@!display nonetrkfil0m-<", max_size=60),
    style=st.text("/*;:!%display nonetrkfil0m-", max_size=40),
)
def test_styles_of_any_signs(tmp_path, sheet, style):
    sheet, style = (text.replace("<", "&lt;") for text in (sheet, style))
    body = f'<svg><style>{sheet}</style><g class="a"><path id="a" style="{style}" d="M0 0L9 9"/></g></svg>'
    letters_or_a_sentence(tmp_path / "a.svg", body.encode())


@QUIET
@given(
    box=st.text("0123456789.%- ", max_size=12),
    size=st.text("0123456789.%-pxm", max_size=6),
    aspect=st.text("xMinYdMaxsliceno ", max_size=16),
    origin=st.text("0123456789.% lefttopcn", max_size=12),
)
def test_views_of_any_signs(tmp_path, box, size, aspect, origin):
    view = f'<svg viewBox="{box}" width="{size}" preserveAspectRatio="{aspect}"><circle cx="{size}" r="{size}"/></svg>'
    turned = f'<g transform="scale(2)" transform-origin="{origin}"><path d="M0 0L9 9"/></g>'
    body = f'<svg viewBox="0 0 9 9">{view}{turned}</svg>'
    letters_or_a_sentence(tmp_path / "a.svg", body.encode())


@settings(max_examples=30, deadline=None)
@given(st.text("/* {}a", max_size=30))
def test_comments_of_any_kind_end_somewhere(text):
    from xml.etree.ElementTree import Element  # noqa: PLC0415

    sheet = Element("style")
    sheet.text = text
    Styles(sheet)
