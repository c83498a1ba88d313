"""InkML that points: views of traces and groups, contexts that inherit, what is refused by name."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from tests.formats.ink_files import FORCED, d_strokes, inkml, trace
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
    "each once": labelled(of("g") + of("t1") + of("t0")),
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


SAID = f"<context><traceFormat>{FORCED}</traceFormat></context>"
INHERITED = {
    "a brush after the format": SAID + '<context brushRef="#b"/>',
    "many brushes": SAID + "<context><brush/></context>" * 40,
    "a source after the format": SAID
    + '<context><inkSource><sampleRate value="9"/></inkSource></context>',
    "a loose format": f'<traceFormat>{FORCED}</traceFormat><context xml:id="x" brushRef="#b"/>',
    "what leads nowhere does not matter": '<context contextRef="#gone"/>' + SAID,
    "a format further down": f"<x/><inkSource><traceFormat>{FORCED}</traceFormat></inkSource>",
}


@pytest.mark.parametrize("how", INHERITED)
def test_what_a_context_does_not_say_the_one_before_it_says(tmp_path, how):
    check_d(read(tmp_path, SPACE.format(INHERITED[how] + BODY)))


DEFAULT = {
    "no context": ("", ""),
    "a brush": ('<context xml:id="x"><brush/></context>', "#x"),
    "nothing in it": ("<context/>", ""),
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


def mapped(kind, inside="<affine>2 0 7, 0 2 -9</affine>"):
    """The D on a canvas of its own."""
    mapping = f"<canvasTransform><mapping type='{kind}'>{inside}</mapping></canvasTransform>"
    return inkml(BODY, extra=mapping)


def test_a_mapping_that_changes_nothing_does_no_harm(tmp_path):
    check_d(read(tmp_path, mapped("identity")))
    check_d(read(tmp_path, inkml(BODY, extra="<canvasTransform/>")))


@pytest.mark.parametrize("times", [1e3, 1e4])
def test_microseconds_without_a_unit_are_asked_for_it(tmp_path, times):
    body = "".join(trace(s * np.array([times, 1, 1, 1])) for s in d_strokes())
    with pytest.raises(
        RecordingError, match=r"trace 0 has points 1e\+0[45] apart in channel T.*such as units='us'"
    ):
        read(tmp_path, inkml(body, FORCED.replace(' units="ms"', "")))


def test_a_trace_that_continues_another_is_one_stroke_with_it(tmp_path):
    continued = VIEWED.replace('"t1"', '"t1" continuation="end" priorRef="#t0"')
    (stroke,) = read(tmp_path, inkml(continued)).strokes()
    assert stroke.t[-1] == pytest.approx(2.0)
    wanted = np.vstack(d_strokes())[:, 1:3]
    assert np.allclose(stroke.position, wanted, atol=1e-4)


LOOKUP = FORCED.replace('"mm"/>', '"mm"><mapping type="lookup"/></channel>', 1)
PART = "has a view of a part (from, to), which is"
NOT_FOLLOWED = {
    "some points": (GROUP + labelled(of("t0", ' from="11" to="40"')), PART),
    "the end of a group": (GROUP + labelled(of("g", ' from="2:3"')), PART),
}


@pytest.mark.parametrize("what", NOT_FOLLOWED)
def test_what_is_not_followed_is_refused_by_name(tmp_path, what):
    body, sentence = NOT_FOLLOWED[what]
    with pytest.raises(RecordingError, match=re.escape(sentence) + " not followed here; "):
        read(tmp_path, inkml(body))


def test_mappings_are_refused_by_name(tmp_path):
    said = {mapped("affine"): "its canvasTransform", inkml(BODY, LOOKUP): "channel 'X'"}
    for text, name in said.items():
        sentence = rf"d\.inkml: trace 0 has a mapping for {name}, which is not followed here; save"
        with pytest.raises(RecordingError, match=sentence):
            read(tmp_path, text)


BROKEN = {
    "a view of itself": (
        BODY + '<traceView xml:id="v" traceDataRef="#v"/>',
        "views that are more than 60 deep",
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


@pytest.mark.slow
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
