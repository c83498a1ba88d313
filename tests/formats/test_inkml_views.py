"""InkML that points: views of traces and groups, contexts that inherit, mappings, and what is refused by name."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recordings
from tests.formats.ink_files import FORCED, PLAIN, d_strokes, inkml, trace
from tests.formats.test_fuzz import QUIET, letters_or_a_sentence
from tests.formats.test_inkml import BODY, SPACE, check_d, read

VIEWED = "".join(trace(s, attributes=f' xml:id="t{k}"') for k, s in enumerate(d_strokes()))
GROUP = f'<traceGroup xml:id="g">{VIEWED}</traceGroup>'


def labelled(inside, label="D", kind="traceView"):
    return f'<{kind}><annotation type="truth">{label}</annotation>{inside}</{kind}>'


def of(name, more=""):
    return f'<traceView traceDataRef="#{name}"{more}/>'


SHOWN = {
    "traces": labelled(of("t0") + of("t1")),
    "a group": labelled(of("g")),
    "a group in a group": labelled(of("g"), kind="traceGroup"),
    "a view of a view": f'<traceView xml:id="v">{of("t0")}{of("t1")}</traceView>'
    + labelled(of("v")),
    "each once": labelled(of("g") + of("t1") + of("t0", ' from="3"')),
    "the traces of a group": labelled(of("g", ' from="1" to="1"') + of("g", ' from="2"')),
    "points of a group": labelled(of("g", ' from="1:1" to="2:81"')),
    "all points": labelled(of("t0", ' to="81"') + of("t1", ' from="1"')),
}


@pytest.mark.parametrize("how", SHOWN)
@pytest.mark.parametrize("place", ["{}", "<definitions>{}</definitions>"])
def test_views_show_traces_groups_and_views(tmp_path, how, place):
    """With the traces on the page, or in the definitions, which show nothing themselves."""
    text = inkml(place.format(GROUP) + SHOWN[how]).replace(
        "<traceGroup xml", '<traceGroup contextRef="#c" xml'
    )
    recording = read(tmp_path, text)
    check_d(recording)
    assert recording.character == "D"


def test_definitions_are_shown_only_where_a_view_shows_them(tmp_path):
    hidden = f"<definitions>{trace(d_strokes()[0] * 3)}<trace>nonsense</trace></definitions>"
    check_d(read(tmp_path, inkml(hidden + BODY)))
    check_d(read(tmp_path, inkml(f"<definitions>{GROUP}</definitions>" + of("t0") + of("t1"))))


def test_labels_of_views_are_letters(tmp_path):
    later = [s + np.array([3, 0.1, 0, 0]) for s in d_strokes()]
    later = "".join(trace(s, attributes=f' xml:id="u{k}"') for k, s in enumerate(later))
    text = inkml(
        VIEWED + later + labelled(of("t0") + of("t1")) + labelled(of("u0") + of("u1"), "E")
    )
    assert [read(tmp_path, text, number=k).character for k in range(2)] == ["D", "E"]
    for k in range(2):
        check_d(read(tmp_path, text, number=k))


def test_a_word_that_views_its_letters_is_no_letter_itself(tmp_path):
    inner = labelled(VIEWED, kind="traceGroup").replace("<traceGroup>", '<traceGroup xml:id="d">')
    assert read(tmp_path, inkml(inner + labelled(of("d"), "Dd"))).character == "D"


def test_a_view_may_show_a_part_of_a_trace(tmp_path):
    views = labelled(of("t0", ' from="11" to="40"'), "i") + labelled(of("g", ' from="2:3"'), "j")
    (tmp_path / "d.inkml").write_text(inkml(GROUP + views))
    bar, bowl = d_strokes()
    for letter, wanted in zip(
        read_recordings(tmp_path / "d.inkml"), (bar[10:40], bowl[2:]), strict=True
    ):
        (stroke,) = letter.strokes()
        assert np.allclose(stroke.t, wanted[:, 0] - wanted[0, 0], atol=1e-6)
        assert np.allclose(stroke.position, wanted[:, 1:3] - wanted[:, 1:3].min(axis=0), atol=1e-6)


SAID = f"<context><traceFormat>{FORCED}</traceFormat></context>"
INHERITED = {
    "a brush after the format": SAID + '<context brushRef="#b"/>',
    "many brushes": SAID + "<context><brush/></context>" * 40,
    "a source after the format": SAID
    + '<context><inkSource><sampleRate value="9"/></inkSource></context>',
    "a loose format": f'<traceFormat>{FORCED}</traceFormat><context xml:id="x" brushRef="#b"/>',
    "what leads nowhere does not matter": '<context contextRef="#gone"/>' + SAID,
}


@pytest.mark.parametrize("how", INHERITED)
def test_what_a_context_does_not_say_the_one_before_it_says(tmp_path, how):
    check_d(read(tmp_path, SPACE.format(INHERITED[how] + BODY)))


DEFAULT = {
    "no context": ("", ""),
    "its own name": ("", "#DefaultContext"),
    "its format's name": ('<context xml:id="x" traceFormatRef="#DefaultTraceFormat"/>', "#x"),
    "a brush": ('<context xml:id="x"><brush/></context>', "#x"),
    "nothing in it": ("<context/>", ""),
    "beside another": (SAID, "#DefaultContext"),
    "all of its names": (
        '<context xml:id="x" inkSourceRef="#DefaultInkSource" canvasRef="#DefaultCanvas" '
        'canvasTransformRef="#DefaultCanvasTransform" brushRef="#DefaultBrush"/>',
        "#x",
    ),
}


@pytest.mark.parametrize("how", DEFAULT)
def test_where_a_file_says_nothing_there_are_x_and_y(tmp_path, how):
    context, name = DEFAULT[how]
    body = "".join(
        trace(s, "{x:.4f} {y:.4f}", f' contextRef="{name}"' if name else "") for s in d_strokes()
    )
    ink = np.vstack(
        [stroke.position for stroke in read(tmp_path, SPACE.format(context + body)).strokes()]
    )
    assert np.ptp(ink, axis=0) == pytest.approx((0.05 * 0.035 / 0.06, 0.05), rel=1e-3)


def mapped(matrix, before=None, more="", kind="affine"):
    """The D as it was before a mapping, and the mapping, as a file."""
    before = np.eye(2) if before is None else before
    tablet = [s[:, 1:3] * [1, -1] @ np.transpose(before) * [1, -1] for s in d_strokes()]
    strokes = [
        np.column_stack([s[:, 0], xy, s[:, 3]]) for s, xy in zip(d_strokes(), tablet, strict=True)
    ]
    body = "".join(trace(s, left=0.0, top=0.0) for s in strokes)
    mapping = f"<mapping type='{kind}'><affine>{matrix}</affine></mapping>"
    return inkml(body, extra=f"{more}<canvasTransform>{mapping}</canvasTransform>")


AFFINE = {
    "larger": ("2 0 7, 0 2 -9", np.eye(2) / 2),
    "turned over": ("1 0 0, 0 -1 0,", np.diag([1.0, -1.0])),
    "turned": ("0 -1 5, 1 0 0", np.array([[0.0, 1.0], [-1.0, 0.0]])),
    "without a last column": ("4 0, 0 4", np.eye(2) / 4),
}


@pytest.mark.parametrize("how", AFFINE)
def test_a_canvas_is_where_the_file_says(tmp_path, how):
    check_d(read(tmp_path, mapped(*AFFINE[how])))


def test_a_canvas_may_have_units_of_its_own_and_stand_elsewhere(tmp_path):
    canvas = "<canvas><traceFormat>" + PLAIN.replace("mm", "cm") + "</traceFormat></canvas>"
    check_d(read(tmp_path, mapped("0.1 0 0, 0 0.1 0", more=canvas)))
    check_d(read(tmp_path, mapped("nonsense", kind="identity")))
    apart = mapped("2 0 0, 0 2 0", np.eye(2) / 2).replace(
        "<canvasTransform>", '<canvasTransform xml:id="m">'
    )
    begin, end = (
        apart.index("<canvasTransform"),
        apart.index("</canvasTransform>") + len("</canvasTransform>"),
    )
    form = f'<definitions>{apart[begin:end]}</definitions><context canvasTransformRef="#m">'
    check_d(read(tmp_path, (apart[:begin] + apart[end:]).replace('<context xml:id="c">', form)))


def test_a_channel_may_be_a_line_of_what_the_device_counts(tmp_path):
    line = '"mm"><mapping type="affine"><affine>0.1 3</affine></mapping></channel>'
    tenfold = [s * np.array([1, 10, 10, 1]) for s in d_strokes()]
    check_d(read(tmp_path, inkml("".join(map(trace, tenfold)), FORCED.replace('"mm"/>', line))))
    late = FORCED.replace('"ms"/>', '"ms"><mapping mappingRef="#m"/></channel>')
    apart = '<definitions><mapping xml:id="m" type="affine">1000 -50</mapping></definitions>'
    seconds = [s * np.array([0.001, 1, 1, 1]) for s in d_strokes()]
    body = "".join(trace(s, "{x:.4f} {y:.4f} {t:.6f} {f:.0f}") for s in seconds)
    check_d(read(tmp_path, inkml(apart + body, late)))


@pytest.mark.parametrize("times", [1e3, 1e4])
def test_microseconds_without_a_unit_are_asked_for_it(tmp_path, times):
    body = "".join(trace(s * np.array([times, 1, 1, 1])) for s in d_strokes())
    with pytest.raises(
        RecordingError, match=r"trace 0 has points 1e\+0[45] apart in channel T.*such as units='us'"
    ):
        read(tmp_path, inkml(body, FORCED.replace(' units="ms"', "")))


PART = f'<traceView xml:id="v" traceDataRef="#t0" from="2"/>{labelled(of("v", " to=" + repr("9")))}'
CONTINUED = VIEWED.replace('"t1"', '"t1" continuation="end" priorRef="#t0"')
BROKEN = {
    "a view of a brush": (
        BODY + '<brush xml:id="b"/>' + of("b"),
        "view of '#b', which is no trace and no group",
    ),
    "a view of itself": (
        BODY + '<traceView xml:id="v" traceDataRef="#v"/>',
        "views that are more than 60 deep",
    ),
    "no points": (
        GROUP + labelled(of("t0", ' from="9" to="99"')),
        "view of the points 9 to 99 of a trace of 81",
    ),
    "no such trace": (
        GROUP + labelled(of("g", ' from="2" to="5"')),
        "the traces 2 to 5 in a group of 2; mend",
    ),
    "no number": (
        GROUP + labelled(of("t0", ' from="-1"')),
        "view from '-1', which must be whole numbers with :",
    ),
    "nought": (GROUP + labelled(of("t0", ' to="0"')), "view to '0', but points are counted from 1"),
    "a part of a point": (GROUP + labelled(of("t0", ' to="3:1"')), "view of a part of a point"),
    "a part of a part": (GROUP + PART, "view of a part of a view that shows a part"),
    "a part of a whole": (
        CONTINUED + labelled(of("t1", ' from="2"')),
        "a trace that is continued by another one; v",
    ),
    "elsewhere": (
        BODY + of("http://example.org/a.inkml"),
        "refers to '#http://.*nothing is fetched from elsewhere",
    ),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_views_that_cannot_be_shown_say_why(tmp_path, fault):
    body, sentence = BROKEN[fault]
    with pytest.raises(RecordingError, match=rf"d\.inkml: .*{sentence}") as caught:
        read(tmp_path, inkml(body))
    assert len(str(caught.value)) < 400


LOOKUP = FORCED.replace('"mm"/>', '"mm"><mapping type="lookup"/></channel>', 1)
BINDS = '1 0 0, 0 1 0</affine><bind source="Y"/><bind source="X"/><affine>'
UNMAPPED = {
    "a lookup": (
        inkml(BODY, LOOKUP),
        "'lookup' for channel 'X', but only affine ones of X are followed; save the ink",
    ),
    "a formula": (
        mapped("1 0 0, 0 1 0", kind="mathml"),
        "'mathml' for its canvasTransform, but only affine ones",
    ),
    "a matrix of text": (
        mapped("1 0 x, 0 1 0"),
        "mapping '1 0 x, 0 1 0' for its canvasTransform, but it must",
    ),
    "a matrix too small": (
        mapped("1 0 0"),
        "must have 2 x 3 numbers, with commas between its rows",
    ),
    "axes in another order": (mapped(BINDS), "kind 'affine of Y, X' for its canvasTransform"),
}


@pytest.mark.parametrize("fault", UNMAPPED)
def test_mappings_that_are_not_followed_are_refused_by_name(tmp_path, fault):
    text, sentence = UNMAPPED[fault]
    with pytest.raises(RecordingError, match=rf"d\.inkml: trace 0 has .*{sentence}") as caught:
        read(tmp_path, text)
    assert len(str(caught.value)) < 400


def test_views_of_views_never_take_long(tmp_path):
    """Each shows the one before it ten times."""
    views = "".join(
        f'<traceView xml:id="v{k + 1}">{of(f"v{k}") * 10}</traceView>' for k in range(12)
    )
    with pytest.raises(RecordingError, match="or show more than 1000000 traces; view traces"):
        read(tmp_path, inkml(VIEWED + f'<traceView xml:id="v0">{of("t0")}</traceView>' + views))


names = st.sampled_from(["#t0", "#t1", "#g", "#v", "#w", "#c", "#DefaultContext", "t0", "#", "x"])
places = st.text("0123456789:-", max_size=5)


@QUIET
@given(
    refs=st.lists(names, min_size=3, max_size=3),
    parts=st.lists(places, min_size=4, max_size=4),
    kinds=st.integers(0, 3),
)
def test_views_of_any_kind(tmp_path, refs, parts, kinds):
    first = f'<traceView xml:id="v" traceDataRef="{refs[0]}" from="{parts[0]}" to="{parts[1]}"/>'
    second = (
        f'<traceView xml:id="w" contextRef="{refs[2]}" traceDataRef="{refs[1]}" to="{parts[2]}"/>'
    )
    body = [GROUP, f"<definitions>{GROUP}</definitions>"][kinds % 2] + labelled(
        first + second, "a" if kinds > 1 else ""
    )
    letters_or_a_sentence(tmp_path / "a.inkml", inkml(body).encode())


@QUIET
@given(matrix=st.text("0123456789.-, e", max_size=30), line=st.text("0123456789.- e", max_size=12))
def test_mappings_of_any_kind(tmp_path, matrix, line):
    form = FORCED.replace('"mm"/>', f'"mm"><mapping type="affine">{line}</mapping></channel>', 1)
    letters_or_a_sentence(tmp_path / "a.inkml", mapped(matrix).encode())
    letters_or_a_sentence(tmp_path / "a.inkml", inkml(BODY, form).encode())
