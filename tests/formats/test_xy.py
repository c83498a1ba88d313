"""Plain tables and arrays: the same D, however it is written."""

import io

import numpy as np
import pytest

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recording
from tests.formats.ink_files import d_strokes
from tests.formats.motive_csv import Pen, bar, bowl


def rows(pause=True, **scales):
    """A row t, x, y, pressure for each sample; an empty row between the strokes."""
    factor = [scales.get(name, 1.0) for name in ("t", "x", "y", "p")]
    first, second = (stroke * factor for stroke in d_strokes())
    return [*first.tolist(), *([None] if pause else []), *second.tolist()]


def text(head="t,x,y", sign=",", columns=(0, 1, 2), *, form="{:.6f}", blank="", end="\n", **scales):
    """The D as text; `blank` is the line between its strokes, or None for no line."""
    lines = [head] if head else []
    for row in rows(**scales):
        if row is not None:
            lines.append(sign.join(form.format(row[k]) for k in columns))
        elif blank is not None:
            lines.append(blank)
    return (end.join(lines) + end).encode()


def with_pen(sign=" ", up=0, head="x y pen"):
    """The D with a column that says whether the pen is down, and places where it is not."""
    air = [[0.0, 0.01 + 0.0005 * k, 0.02] for k in range(20)]
    lines = [head] if head else []
    for row in rows():
        where = [row[1:3]] if row is not None else [each[1:3] for each in air]
        state = 1 - up if row is not None else up
        lines += [sign.join([*(f"{value:.6f}" for value in each), str(state)]) for each in where]
    return "\n".join(lines).encode()


def array(pause=True):
    return np.array([[np.nan] * 3 if row is None else row[:3] for row in rows(pause)])


def npz(**arrays):
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


def npy(value):
    file = io.BytesIO()
    np.save(file, value)
    return file.getvalue()


def savetxt(**how):
    file = io.BytesIO()
    np.savetxt(file, array(), **how)
    return file.getvalue()


STROKES = [np.array(stroke)[:, :3] for stroke in d_strokes()]


def clocked():
    """Times of day, as programs log them."""
    lines = [f"2026-01-01T10:00:{t:09.6f}Z,{x:.6f},{y:.6f}" for t, x, y in np.vstack(STROKES)]
    return "\n".join(["time,x,y", *lines]).encode()


def events():
    """A word for each row, as a browser names it, and no pause that would tell a stroke."""
    lines = ["type,t,x,y"]
    for stroke in STROKES:
        for k, (t, x, y) in enumerate(stroke):
            event = "pointermove" if k else "pointerdown"
            lines.append(f"{event},{t:.6f},{x:.6f},{y:.6f}")
        lines.append(f"pointerup,{t + 0.01:.6f},{x:.6f},{y:.6f}")
    return "\n".join(lines).encode()


FIELDS = np.array([tuple(row) for row in array()], [("time", float), ("x", float), ("y", float)])
MM = {"x": 1000.0, "y": 1000.0}
TIMED = {
    "a header": text(),
    "no header": text(None),
    "semicolons": text(sign=";", head="t;x;y"),
    "tabs": text("time\tpos_x\tpos_y", sign="\t"),
    "spaces": text("# t x y", sign="   "),
    "bars": text("| t | x | y |", sign=" | "),
    "decimal commas": text("t;x;y", sign=";").replace(b".", b","),
    "decimal commas and spaces": text(None, sign="  ").replace(b".", b","),
    "units": text("time (ms),x [mm],y [mm]", t=1000.0, **MM),
    "units in names": text("time_ms,x_mm,y_mm", t=1000.0, **MM),
    "a row of units": text("Time,X,Y\ns,mm,mm", **MM),
    "microseconds": text("timestamp_us,x_cm,y_cm", t=1e6, x=100.0, y=100.0),
    "milliseconds unsaid": text("time,x,y", t=1000.0),
    "another order": text("y,x,pressure,t", columns=(2, 1, 3, 0)),
    "time last": text(None, columns=(1, 2, 0)),
    "quotation marks": text('"t","x","y"', form='"{:.6f}"', sign=","),
    "UTF-16": text().decode().encode("utf-16"),
    "Windows ends": text(end="\r\n"),
    "old ends": text(end="\r"),
    "NaN": text(blank="nan,nan,nan"),
    "empty cells": text(blank=",,"),
    "a pause": text(blank=None),
    "a word": text(blank="pen up"),
    "comments": b"% made by a script\n% for a test\n" + text("%t,x,y"),
    "more columns": text("t,x,y,pressure,frame", columns=(0, 1, 2, 3, 0)),
    "savetxt": savetxt(),
    "savetxt with a head": savetxt(header="t x y", delimiter="\t"),
    "a frame number": text("Frame,Time,X,Y", columns=(0, 0, 1, 2)),
    "poses": text("%time,field.seq,pose.position.x,pose.position.y", columns=(0, 0, 1, 2)),
    "npy": npy(array()),
    "npy lying": npy(array().T),
    "npy of fields": npy(FIELDS),
    "npz of one": npz(demo=array()),
    "npz of names": npz(**dict(zip("txy", array().T, strict=True))),
    "npz of places and speeds": npz(
        time=array()[:, 0], pos=array()[:, 1:], vel=array()[:, 1:], rates=np.arange(7.0)
    ),
    "times of day": clocked(),
    "events": events(),
    "German names": text("Zeit,X-Koordinate [mm],Y-Koordinate [mm]", **MM),
    "npz of places": npz(time=array()[:, 0], pos=array()[:, 1:]),
}
UNTIMED = {
    "x y": text("x y", sign=" ", columns=(1, 2)),
    "x y without names": text(None, sign=" ", columns=(1, 2)),
    "pen down": with_pen(),
    "pen down without names": with_pen(head=None),
    "pen up": with_pen(up=1, head="x y pen_up"),
    "stroke numbers": "\n".join(
        ["stroke x y", *(f"{k} {x} {y}" for k in (0, 1) for _, x, y in STROKES[k].tolist())]
    ).encode(),
}


def good_files(_):
    """For the tests of damaged files."""
    names = {"a.csv": "a header", "a.txt": "spaces", "a.tsv": "tabs", "a.npy": "npy"}
    names |= {"a.npz": "npz of names"}
    return {f"xy_{name}": TIMED[kind] for name, kind in names.items()}


def read(tmp_path, data, name="D_w07.csv", **how):
    (tmp_path / name).write_bytes(data)
    return read_recording(tmp_path / name, **how)


@pytest.mark.parametrize("kind", TIMED)
def test_a_table_with_times_is_read_as_it_is(tmp_path, kind):
    recording = read(tmp_path, TIMED[kind])
    assert (recording.character, recording.writer) == ("D", "w07")
    assert recording.notes
    for stroke, wanted in zip(recording.strokes(), d_strokes(), strict=True):
        assert np.allclose(stroke.position, wanted[:, 1:3], atol=2e-6)
        assert np.allclose(stroke.t, wanted[:, 0], atol=2e-6)


@pytest.mark.parametrize("kind", UNTIMED)
def test_a_table_without_times_gets_a_hands_pace_and_a_note(tmp_path, kind):
    recording = read(tmp_path, UNTIMED[kind])
    assert "The file says no times" in recording.notes[-1]
    for stroke, wanted in zip(recording.strokes(), d_strokes(), strict=True):
        box = np.stack([stroke.position.min(axis=0), stroke.position.max(axis=0)])
        assert np.allclose(box, [wanted[:, 1:3].min(axis=0), wanted[:, 1:3].max(axis=0)], atol=1e-3)


def test_pressure_lifts_the_pen_and_is_kept(tmp_path):
    table = np.vstack(
        [np.column_stack([s, np.full(len(s), f)]) for s, f in zip(STROKES, (100, 200), strict=True)]
    )
    air = np.column_stack([np.linspace(0.9, 1.1, 20), np.full((20, 2), 0.02), np.zeros(20)])
    lines = [",".join(f"{value:.6f}" for value in row) for row in [*table, *air]]
    lines.sort(key=lambda line: float(line.split(",")[0]))
    recording = read(tmp_path, "\n".join(["t,x,y,pressure", *lines]).encode())
    assert len(recording.strokes()) == 2
    assert sorted(set(recording.pressure.round(3))) == [0.0, 0.5, 1.0]


def test_pixels_go_down_the_screen_and_other_units_are_told(tmp_path):
    data = text("x [px],y [px]", columns=(1, 2), x=96 / 0.0254, y=-96 / 0.0254)
    recording = read(tmp_path, data)
    assert any("96 to the inch" in note for note in recording.notes)
    ink = np.vstack([stroke.position for stroke in recording.strokes()])
    assert np.ptp(ink[:, 1]) == pytest.approx(0.06, abs=1e-4)
    assert recording.strokes()[0].position[0, 1] > 0.05, "the bar begins at its top"
    page = read(tmp_path, text("t,pageX,pageY", x=96 / 0.0254, y=-96 / 0.0254))
    assert page.strokes()[0].position[0] == pytest.approx([0.0, 0.06], abs=1e-4)
    unsaid = read(tmp_path, text(x=5000.0, y=5000.0))
    assert any("50 mm high" in note for note in unsaid.notes)


@pytest.mark.parametrize("head", ["t,x,y,z", None])
def test_a_height_lifts_the_pen(tmp_path, head):
    pen = Pen(height=0.0).rest(0.5).draw(bar()).hop((0.0, 0.0)).draw(bowl()).rest(0.5)
    t, page = pen.sampled()
    lines = [f"{s:.6f},{x:.6f},{y:.6f},{z:.6f}" for s, (x, y, z) in zip(t, page, strict=True)]
    recording = read(tmp_path, "\n".join([*([head] if head else []), *lines]).encode())
    for stroke, (down, up) in zip(recording.strokes(), pen.touches, strict=True):
        assert abs(stroke.t[0] - down) < 0.08
        assert abs(stroke.t[-1] - up) < 0.08
    assert np.ptp(recording.position[:, 0]) == pytest.approx(0.07, abs=0.003)


FAULTS = {
    "no x": (text("t,velocity,y"), "which columns are x and y.*'velocity'"),
    "two markers": (text("t,x1,y1,x2", columns=(0, 1, 2, 1)), "two columns for x, 'x1' and 'x2'"),
    "many columns": (b"1 2 3 4 5 6\n" * 20, "which columns are x and y.*6, without names"),
    "several letters": (
        b"letter,t,x,y\n" + b"".join(b"%c,%d,%d,3\n" % (97 + k // 9, k, k) for k in range(18)),
        "holds 2 letters, as its column 'letter' says",
    ),
    "pen or deltas": (b"-1 2 0\n3 -2 0\n" * 20 + b"3 4 1\n1 1 0\n", "which columns are x and y"),
    "few rows": (b"t,x,y\n0,1,2\n", "fewer than 5 rows"),
    "rows of other lengths": (text() + b"1,2,3,4\n", "has 4 cells, but the first one 3"),
    "arrays of two lengths": (
        npz(x=np.arange(9.0), y=np.arange(8.0)),
        "different lengths: 'x', 'y'",
    ),
    "objects": (npy(np.array([None, {}])), "no array of numbers"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_what_is_no_ink_says_what_is_missing(tmp_path, fault):
    data, sentence = FAULTS[fault]
    with pytest.raises(RecordingError, match=rf"D_w07\.csv.*(?:{sentence})"):
        read(tmp_path, data)
