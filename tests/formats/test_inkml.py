"""InkML: channels as they are declared, and every quirk of tablets, forms and offices."""

import re

import numpy as np
import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recording, read_recordings
from tests.formats.ink_files import FORCED, PLAIN, TIMED, d_inkml, d_strokes, inkml, trace

BODY = "".join(trace(stroke) for stroke in d_strokes())


def good_files(_):
    """For the tests of damaged files: labelled groups, abbreviated points, views."""
    short = [trace(stroke[::8]) for stroke in d_strokes()]
    label = '<annotation type="truth">D</annotation>'
    groups = "".join(f"<traceGroup>{label}{each}</traceGroup>" for each in short)
    points = "<trace>10 20 0 100, 11'1\"2 7, * * * ?, 12 2 9 #1F</trace>"
    held = f'<traceGroup xml:id="g" contextRef="#c">{"".join(short)}</traceGroup>'
    shown = f'<definitions>{held}</definitions><context brushRef="#b"/>'
    shown += '<traceView traceDataRef="#g"/>'
    return {
        "a.inkml": inkml(groups).encode(),
        "b.inkml": inkml(points + short[0]).encode(),
        "c.inkml": inkml(shown).encode(),
    }


def read(tmp_path, text, encoding="utf-8", **which):
    path = tmp_path / "d.inkml"
    path.write_bytes(text.encode(encoding))
    return read_recording(path, **which)


def check_d(recording, within=1e-6, times=1e-6, pressure=True):
    """The D upright, of its size, its lower left corner at the origin, its clock from 0."""
    strokes = recording.strokes()
    assert len(strokes) == 2
    for stroke, wanted in zip(strokes, d_strokes(), strict=True):
        assert np.allclose(stroke.position, wanted[:, 1:3], atol=within)
        assert np.allclose(stroke.t, wanted[:, 0], atol=times)
    assert not recording.position[slice(*recording.given_strokes[0]), 2].any()
    lift = slice(recording.given_strokes[0][1], recording.given_strokes[1][0])
    assert 0.015 < recording.position[lift, 2].max() < 0.025
    if pressure:
        wanted = np.concatenate([stroke[:, 3] for stroke in d_strokes()])
        got = np.concatenate([recording.pressure[slice(*span)] for span in recording.given_strokes])
        assert np.allclose(got, wanted, atol=0.001)


def d_in(form, channels, extra=""):
    return inkml("".join(trace(stroke, form) for stroke in d_strokes()), channels, extra=extra)


def source(*properties, more=""):
    found = "".join(
        f'<channelProperty channel="{c}" name="resolution" value="{v}" units="{u}"/>'
        for c, v, u in properties
    )
    return f'<inkSource xml:id="s">{more}<channelProperties>{found}</channelProperties></inkSource>'


def channel(name, unit, kind="decimal", more=""):
    return f'<channel name="{name}" type="{kind}" units="{unit}"{more}/>'


UNITS = {
    "mm": 1,
    "cm": 0.1,
    "m": 0.001,
    "in": 1 / 25.4,
    "himetric": 100,
    "pt": 72 / 25.4,
    "um": 1000,
    "px": 96 / 25.4,
}


@pytest.mark.parametrize("unit", UNITS)
def test_every_unit_of_length_is_known(tmp_path, unit):
    strokes = [stroke.copy() for stroke in d_strokes()]
    for stroke in strokes:
        stroke[:, 1:3] *= UNITS[unit]
    form = FORCED.replace('units="mm"', f'units="{unit}"')
    letter = read(
        tmp_path, inkml("".join(trace(s, "{x:.9f} {y:.9f} {t:.3f} {f:.0f}") for s in strokes), form)
    )
    check_d(letter)
    assert any("96 to the inch" in note for note in letter.notes) == (unit == "px")


@pytest.mark.parametrize(("unit", "share"), [("ms", 1), ("s", 0.001), ("us", 1000)])
def test_every_unit_of_time_is_known(tmp_path, unit, share):
    form = FORCED.replace('units="ms"', f'units="{unit}"')
    strokes = [stroke.copy() for stroke in d_strokes()]
    for stroke in strokes:
        stroke[:, 0] *= share
    check_d(
        read(
            tmp_path,
            inkml("".join(trace(s, "{x:.4f} {y:.4f} {t:.9f} {f:.0f}") for s in strokes), form),
        )
    )


def test_times_without_a_unit_are_milliseconds_unless_no_pen_could_be_so_fast(tmp_path):
    form = FORCED.replace(' units="ms"', "")
    check_d(read(tmp_path, d_inkml(channels=form)))
    seconds = [stroke * [0.001, 1, 1, 1] for stroke in d_strokes()]
    check_d(
        read(
            tmp_path,
            inkml("".join(trace(s, "{x:.4f} {y:.4f} {t:.6f} {f:.0f}") for s in seconds), form),
        )
    )


def test_an_office_counts_in_steps_of_its_screen(tmp_path):
    """Whole numbers, the unit cm, a resolution that says what a step is; differences."""
    form = "".join(channel(name, "cm", "integer") for name in "XY") + channel("T", "dev", "integer")
    steps = source(("X", 1000, "1/cm"), ("Y", 1000, "1/cm"), ("T", 1000, "1/s"))
    body = ""
    for stroke in d_strokes():
        points = np.round(
            np.column_stack(
                [1e5 * stroke[:, 1] + 700, 9000 - 1e5 * stroke[:, 2], 1000 * stroke[:, 0]]
            )
        )
        once, twice = np.diff(points, axis=0).astype(int), np.diff(points, 2, axis=0).astype(int)
        begin = " ".join(f"{v:.0f}" for v in points[0]) + ", " + "".join(f"'{v}" for v in once[0])
        body += f"<trace>{begin}, " + ", ".join("".join(f'"{v}' for v in row) for row in twice[:1])
        body += ", " + ", ".join(" ".join(map(str, row)) for row in twice[1:]) + "</trace>"
    check_d(read(tmp_path, inkml(body, form, extra=steps)), within=2e-5, times=1e-3, pressure=False)


def test_steps_of_the_device_are_those_of_its_resolution(tmp_path):
    form = "".join(channel(name, "dev", "integer") for name in "XY") + TIMED.split("/>")[2] + "/>"
    steps = source(("X", 2540, "1/in"), ("Y", 2540, "1/in"))
    fine = [stroke * [1, 100, 100, 1] for stroke in d_strokes()]
    body = "".join(trace(s, "{x:.0f} {y:.0f} {t:.3f}") for s in fine)
    check_d(read(tmp_path, inkml(body, form, extra=steps)), within=2e-5, pressure=False)


def test_y_points_down_unless_the_file_says_otherwise(tmp_path):
    up = [stroke * [1, 1, -1, 1] for stroke in d_strokes()]
    form = FORCED.replace('name="Y"', 'name="Y" orientation="-ve"')
    check_d(read(tmp_path, inkml("".join(trace(stroke) for stroke in up), form)))
    left = [stroke * [1, -1, 1, 1] for stroke in d_strokes()]
    form = FORCED.replace('name="X"', 'name="X" orientation="-ve"')
    check_d(read(tmp_path, inkml("".join(trace(stroke) for stroke in left), form)))


def test_channels_are_taken_by_name_in_any_order_and_others_are_left(tmp_path):
    names = (
        '<channel name="F" max="1000"/><channel name="OTx" type="integer"/>'
        + TIMED.split("/>")[2]
        + "/>"
    )
    names += (
        "<intermittentChannels>" + '<channel name="B1" type="boolean"/>' + "</intermittentChannels>"
    )
    form = names.replace("<inter", PLAIN + "<inter")
    body = "".join(trace(s, "{f:.0f} -30 {t:.3f} {x:.4f} {y:.4f}") for s in d_strokes())
    check_d(read(tmp_path, inkml(body, form)))
    body = body.replace(", ", " T, ", 40)
    check_d(read(tmp_path, inkml(body, form)))


FORCES = {
    "max": (' max="1000"', "{f:.0f}", 1),
    "min and max": (' min="-100" max="900"', "{f:.0f}", None),
    "a share": ("", "{f:.6f}", 1000),
}


@pytest.mark.parametrize("kind", FORCES)
def test_force_becomes_a_share_of_the_hardest_press(tmp_path, kind):
    said, form, divisor = FORCES[kind]
    strokes = [stroke.copy() for stroke in d_strokes()]
    for stroke in strokes:
        stroke[:, 3] = stroke[:, 3] / divisor if divisor else stroke[:, 3] - 0.1
    channels = TIMED + f'<channel name="F"{said}/>'
    check_d(
        read(
            tmp_path,
            inkml("".join(trace(s, "{x:.4f} {y:.4f} {t:.3f} " + form) for s in strokes), channels),
        ),
        within=2e-6,
    )


def test_force_in_unknown_units_is_a_share_of_the_hardest_in_the_file(tmp_path):
    recording = read(tmp_path, inkml(BODY, TIMED + '<channel name="F" type="integer"/>'))
    assert recording.pressure.max() == 1
    assert recording.pressure[recording.given_strokes[0][0]] == pytest.approx(0.2 / 0.9, abs=0.002)


def test_ink_without_times_is_written_at_the_sample_rate_or_as_a_hand_would(tmp_path):
    form, body = PLAIN, "".join(trace(s, "{x:.4f} {y:.4f}") for s in d_strokes())
    rated = read(
        tmp_path,
        inkml(body, form, extra='<inkSource><sampleRate uniform="true" value="100"/></inkSource>'),
    )
    assert [stroke.duration for stroke in rated.strokes()] == pytest.approx([0.8, 0.8])
    by_hand = read(tmp_path, inkml(body, form))
    for stroke, wanted in zip(by_hand.strokes(), d_strokes(), strict=True):
        speed = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1) * 120
        assert max(speed[0], speed[-1]) < 0.001
        assert 0.3 < stroke.duration < 2.0
        assert np.allclose(stroke.position[[0, -1]], wanted[[0, -1], 1:3], atol=1e-6)


def test_a_trace_that_begins_when_the_last_one_ran_begins_after_it(tmp_path):
    """Some devices start the clock anew for each trace; others count from an epoch."""
    anew = [stroke - [stroke[0, 0], 0, 0, 0] for stroke in d_strokes()]
    recording = read(tmp_path, inkml("".join(map(trace, anew))))
    first, second = recording.strokes()
    assert second.t[0] - first.t[-1] == pytest.approx(0.4)
    epoch = [stroke + np.array([1.7e9, 0, 0, 0]) for stroke in d_strokes()]
    check_d(read(tmp_path, inkml("".join(map(trace, epoch)))), times=1e-3)
    anew = "".join(
        trace(s, attributes=f' timeOffset="{1000 * k * 1.2}"') for k, s in enumerate(anew)
    )
    check_d(read(tmp_path, inkml(anew)))


def test_points_at_the_same_time_count_once_and_unknown_points_not_at_all(tmp_path):
    body = BODY.replace(", ", ", ? 55 1 7, ", 1)
    check_d(read(tmp_path, inkml(body)))
    rows = BODY.split(", ")
    body = ", ".join(rows[:30] + [rows[29]] * 3 + rows[30:])
    check_d(read(tmp_path, inkml(body)))


def test_a_channel_that_no_point_has_is_none(tmp_path):
    """Declared and left out, as some programs save a force."""
    body = "".join(trace(s, "{x:.4f} {y:.4f} {t:.3f}") for s in d_strokes())
    recording = read(tmp_path, inkml(body))
    check_d(recording, pressure=False)
    assert recording.pressure is None


def test_values_without_a_channel_and_traces_without_a_label_are_left_out_and_told(tmp_path):
    more = "".join(trace(s, "{x:.4f} {y:.4f} {t:.3f} {f:.0f} 7 8") for s in d_strokes())
    for text, what in {
        inkml(more): "values of points for which there is no channel",
        inkml(BODY + "<trace>1 2 3 4, one 3 5 4</trace>"): "trace 2 has 'one 3 5 4' where",
        inkml(labelled_body("D", BODY) + BODY): "2 traces that are in no letter with a label",
    }.items():
        recording = read(tmp_path, text)
        check_d(recording)
        assert what in recording.notes[-1]


def test_a_full_stop_is_a_dot_on_the_page_of_others(tmp_path):
    """A letter of one point, beside one without a unit, which stays 50 mm high."""
    body = labelled_body("D", BODY) + labelled_body(".", "<trace>99 -9 9000 400</trace>")
    text = inkml(body, FORCED.replace(' units="mm"', ""))
    dot = read(tmp_path, text, which=".").strokes()
    assert np.ptp(dot[0].position, axis=0).max() == 0
    letter = read(tmp_path, text, which="D").strokes()
    assert np.ptp(np.vstack([s.position for s in letter])[:, 1]) == pytest.approx(0.05)


@pytest.mark.parametrize(
    "bad",
    [
        "<trace>1 2 3 4, one 3 5 4</trace>",
        "<trace contextRef='#nowhere'>1 2 3 4, 2 3 9 4</trace>",
        "<trace continuation='end'>1 2 3 4, 2 3 9 4</trace>",
        "<trace>1 2 3 4, 1e7 3 5 4</trace>",
        "<trace>1 2 9 4, 2 3 4 4</trace>",
        "<traceView traceDataRef='#nowhere'/>",
    ],
)
def test_a_letter_that_cannot_be_read_is_left_out_of_its_page_and_told(tmp_path, bad):
    text = inkml(labelled_body("x", bad) + labelled_body("D", BODY))
    letter = read(tmp_path, text)
    alone = read(tmp_path, inkml(labelled_body("D", BODY)))
    assert letter.character == "D"
    assert np.array_equal(letter.position, alone.position)
    (note,) = letter.notes
    assert re.match("Of this file is left out what cannot be read: ('x'|trace 0)", note)


def labelled_body(label, body):
    return f'<traceGroup><annotation type="truth">{label}</annotation>{body}</traceGroup>'


def test_only_ink_is_ink(tmp_path):
    hover = trace(d_strokes()[0] * [1, 3, 3, 1], attributes=' type="penUp"')
    check_d(read(tmp_path, inkml(hover + BODY + "<trace/><trace>\n</trace>")))


def test_a_tip_switch_cuts_a_trace(tmp_path):
    form = TIMED + '<channel name="S" type="boolean"/>'
    bar, bowl = d_strokes()
    rows = [f"{r[1] * 1000:.4f} {-r[2] * 1000:.4f} {r[0] * 1000:.3f} T" for r in bar]
    rows += ["20 -30 900 F", "30 -40 1000 F"] + [
        f"{r[1] * 1000:.4f} {-r[2] * 1000:.4f} {r[0] * 1000:.3f} T" for r in bowl
    ]
    check_d(read(tmp_path, inkml(f"<trace>{', '.join(rows)}</trace>", form)), pressure=False)


def test_a_single_point_is_a_dot(tmp_path):
    recording = read(tmp_path, inkml(BODY + "<trace>30 10 2500 400</trace>"))
    assert len(recording.strokes()) == 3
    assert np.ptp(recording.strokes()[2].position, axis=0).max() == 0


def test_namespaces_encodings_comments_and_marks_do_no_harm(tmp_path):
    check_d(read(tmp_path, d_inkml(prefix="inkml:")))
    check_d(read(tmp_path, '<?xml version="1.0" encoding="UTF-16"?>' + d_inkml(), "utf-16"))
    check_d(read(tmp_path, d_inkml(), "utf-8-sig"))
    check_d(read(tmp_path, "<!-- a tablet -->\r\n" + d_inkml().replace(", ", ",\r\n\t")))
    check_d(read(tmp_path, inkml(BODY).replace(' xmlns="http://www.w3.org/2003/InkML"', "")))


def test_references_are_followed_inside_the_file(tmp_path):
    form = (
        f'<traceFormat xml:id="f">{FORCED}</traceFormat><inkSource xml:id="s" traceFormatRef="#f"/>'
    )
    other = f'<context xml:id="o"><traceFormat>{PLAIN}</traceFormat></context><brush xml:id="b"/>'
    defined = f'<definitions>{form}<context xml:id="c" inkSourceRef="#s"/>{other}</definitions>'
    body = "".join(trace(s, attributes=' contextRef="#c" brushRef="#b"') for s in d_strokes())
    space = 'xmlns="http://www.w3.org/2003/InkML"'
    check_d(read(tmp_path, f"<ink {space}>{defined}{body}</ink>"))
    body = "".join(map(trace, d_strokes()))
    check_d(
        read(
            tmp_path, f'<ink {space}>{defined}<traceGroup contextRef="#c">{body}</traceGroup></ink>'
        )
    )
    check_d(read(tmp_path, f'<ink {space}>{defined}<context contextRef="#c"/>{body}</ink>'))
    for odd in ("#nowhere", "http://example.org/f.inkml#c"):
        with pytest.raises(
            RecordingError, match=r"d\.inkml: trace 0 refers to .*nothing is fetched from elsewhere"
        ):
            read(
                tmp_path,
                "<ink "
                f"{space}>{defined}{body.replace('<trace>', f'<trace contextRef={odd!r}>')}</ink>",
            )


def test_labelled_groups_are_letters(tmp_path):
    groups = "".join(
        f'<traceGroup><annotation type="truth">{letter}</annotation>{BODY}</traceGroup>'
        for letter in ("D", "p", "D")
    )
    text = inkml('<annotation type="writer">w12</annotation>' + groups)
    (tmp_path / "d.inkml").write_text(text)
    letters = read_recordings(tmp_path / "d.inkml")
    assert [letter.character for letter in letters] == ["D", "p", "D"]
    assert {letter.writer for letter in letters} == {"w12"}
    with pytest.raises(
        RecordingError,
        match=r"holds 3 letters; choose with number=0 to 2 or which=\.\.\.: 'D' \(2\), 'p'",
    ):
        read(tmp_path, text)
    assert read(tmp_path, text, which="p").character == "p"
    assert read(tmp_path, text, number=2).character == "D"
    check_d(read(tmp_path, text, number=1, which="D"))
    with pytest.raises(
        RecordingError, match=r"holds 2 letters of 'D'; choose with number=0 to 1\."
    ):
        read(tmp_path, text, which="D")
    with pytest.raises(RecordingError, match=r"has no 'q'; it holds 'D' \(2\), 'p'"):
        read(tmp_path, text, which="q")
    for odd in (3, -1, "1", True, 1.0):
        with pytest.raises(
            RecordingError, match=r"number is .*has the letters 0 to 2 to choose from"
        ):
            read(tmp_path, text, number=odd)


def test_real_names_stay_out(tmp_path):
    text = inkml(
        '<annotation type="writer">Anna Berg</annotation><annotation type="truth">D</annotation>'
        + BODY
    )
    recording = read(tmp_path, text)
    assert (recording.character, recording.writer) == ("D", None)


SPACE = "<ink xmlns='http://www.w3.org/2003/InkML'>{}</ink>"
BROKEN = {
    "no ink": (SPACE.format(""), "has no stroke of a pen that was down"),
    "hover only": (
        SPACE.format('<trace type="penUp">1 2, 3 4</trace>'),
        "has no stroke of a pen that was down",
    ),
    "not closed": ("<ink><trace>1 2", "is not well-formed XML"),
    "a word": (
        inkml("<trace>1 2 3 4, one 2 3 4</trace>"),
        "trace 0 has 'one 2 3 4' where a number should be",
    ),
    "too few values": (
        inkml("<trace>1 2 3 4, 1</trace>"),
        "trace 0 has 1 values in point 1, but its channels need 2",
    ),
    "too many values": (
        inkml("<trace>1 2 3 4 5 1 2 3 4</trace>"),
        "trace 0 has more than 4 values in a point",
    ),
    "no Y": (inkml(BODY, '<channel name="X"/>'), "has the channels X, but must have X and Y"),
    "X twice": (inkml(BODY, '<channel name="X"/>' + PLAIN), "must have X and Y, each name once"),
    "time runs back": (
        inkml("<trace>1 2 30 4, 20 30 20 4</trace>"),
        "stroke 0 has times that run back",
    ),
    "a year": (
        inkml("<trace>1 2 3 4, 20 30 3e10 4</trace>"),
        "stroke 0 takes 3e.07 s; is the unit of its times right",
    ),
    "steps that vanish on one clock": (
        inkml("<trace>1 2 3 4, 20 30 9 4</trace><trace>1 2 0 4, 9 9 1e-20 4</trace>"),
        r"t\[1\] is .* s and does not come after",
    ),
    "a dot alone": (inkml("<trace>1 2 3 4</trace>"), "the ink is 0 m large, but must be"),
    "a mile": (
        inkml("<trace>1 2 3 4, 1e6 3 5 4</trace>"),
        "the ink is 1000 m large, but must be .* is its unit right",
    ),
    "endless": (
        inkml("<trace>1 2 3 4, 1e999 3 5 4</trace>"),
        "trace 0 has '1e999 3 5 4' where a number should be",
    ),
    "an entity": (
        '<!DOCTYPE ink [<!ENTITY a "1">]><ink><trace>&a; 2</trace></ink>',
        "defines the entity 'a'",
    ),
    "deep": ("<ink>" * 70, "more than 60 inside one another"),
    "many": ("<ink>" + "<trace/>" * 100_001, "has more than 100000 elements"),
    "many points": (
        SPACE.format(f"<trace>{'1 2,' * 300_002}</trace>"),
        "has more than 300000 points",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("fault", BROKEN)
def test_what_cannot_be_read_says_where_and_why(tmp_path, fault):
    text, sentence = BROKEN[fault]
    with pytest.raises(RecordingError, match=rf"d\.inkml: .*{sentence}") as caught:
        read(tmp_path, text)
    assert len(str(caught.value)) < 400
