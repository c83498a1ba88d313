"""Laws of reading: every quirk of a Motive file, and a sentence for what cannot be read."""

import re

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.formats.read import read_recording
from tests.formats.motive_csv import Pen, bar, bowl, lab, letter_a, motive
from tests.recordings import RECORDINGS, needs_recordings

GRID = [(0.10, s) for s in (0.003, 0.006, 0.009, 0.012)] + [
    (0.08, s) for s in (0.003, 0.006, 0.008, 0.010)
]
COUNTS = {
    "B_w00": 2,
    "D_w00": 1,
    "D_w01": 2,
    "D_w02": 2,
    "D_w03": 2,
    "D_w04": 1,
    "D_w05": 2,
    "D_w06": 2,
    "M_w00": 1,
}
"""Strokes in the recordings at hand, counted by eye; every a and e is one."""


def writer_of_d(**hand):
    return Pen(**hand).rest(1.0).draw(bar()).hop((0.0, 0.0)).draw(bowl()).rest(1.0)


def d_file(path, hand=None, *, tilt=0.0, up="+y", right="-x", rate=120.0, holes=(), **quirks):
    t, page = (hand or writer_of_d()).sampled(rate)
    world = lab(page, up, right, tilt=tilt)
    for hole in holes:
        world[hole] = np.nan
    return motive(path, t, world, **quirks)


def check_d(recording, pen=None, within=0.08):
    """Two strokes where the pen made them, upright, the right way round, of the right size."""
    strokes, touches = recording.strokes(), (pen or writer_of_d()).touches
    assert len(strokes) == 2
    for stroke, (down, up) in zip(strokes, touches, strict=True):
        assert abs(stroke.t[0] - down) < within
        assert abs(stroke.t[-1] - up) < within
    ink = np.vstack([s.position for s in strokes])
    assert np.allclose(ink.min(axis=0), 0.0, atol=0.001)
    assert np.allclose(ink.max(axis=0), (0.07, 0.12), atol=0.003)
    assert strokes[0].position[0, 1] > 0.11, "the bar begins at its top"
    down = np.concatenate([recording.position[np.isin(recording.t, s.t), 2] for s in strokes])
    assert abs(np.median(down)) < 0.001
    assert np.abs(down).max() < 0.005


QUIRKS = {
    "as exported": {},
    "re-exported": {
        "crlf": False,
        "quoted": False,
        "commas": True,
        "whole": True,
        "empty_last": False,
    },
    "small axes": {"head": "frame,time,x,y,z,w,x,y,z,x,y,z"},
}


@pytest.mark.parametrize("quirk", QUIRKS)
def test_every_header_is_read(tmp_path, quirk):
    check_d(read_recording(d_file(tmp_path / "D_w07.csv", **QUIRKS[quirk])))


@pytest.mark.parametrize("tilt", [-29.0, -5.0, 2.0, 29.0])
@pytest.mark.parametrize("height", [0.016, 0.085])
def test_the_page_is_found_whatever_its_tilt_and_the_markers_height(tmp_path, tilt, height):
    pen = writer_of_d(height=height)
    check_d(read_recording(d_file(tmp_path / "D_w07.csv", pen, tilt=tilt)))


@pytest.mark.parametrize(("up", "right"), [("+z", "+x"), ("+y", "+z"), ("-x", "+y"), ("+x", "-z")])
def test_any_axes_of_the_cameras_will_do(tmp_path, up, right):
    check_d(read_recording(d_file(tmp_path / "D_w07.csv", up=up, right=right), up=up, right=right))


def test_a_single_bar_is_taken_for_level(tmp_path):
    pen = Pen().rest(0.5).draw(bar()).fly((0.2, 0.0), 0.1, 0.5)
    recording = read_recording(d_file(tmp_path / "I_w07.csv", pen))
    assert len(recording.strokes()) == 1
    assert np.abs(recording.position[:, 2]).max() < 0.005


@pytest.mark.parametrize("front", [True, False])
@pytest.mark.parametrize("tremble", [0.0, 0.0001])
def test_a_marker_that_stands_still_is_not_the_pen_however_long_it_was_seen(
    tmp_path, front, tremble
):
    t, page = writer_of_d().sampled()
    world, still = (
        lab(page),
        np.random.default_rng(0).normal((0.1, 0.05, 0.3), tremble, (len(t), 3)),
    )
    world[170:174] = np.nan
    markers = [("Unlabeled:5013", still), ("Unlabeled:5000", world)]
    first, last = markers if front else markers[::-1]
    path = motive(tmp_path / "D_w07.csv", t, last[1], pen=last[0], ghosts=[first])
    check_d(read_recording(path))
    with pytest.raises(
        RecordingError, match=r"is this marker the pen.*marker=...: 'Unlabeled:5000'\."
    ):
        read_recording(path, marker="Unlabeled:5013")


def test_spaces_after_commas_and_quotes_round_cells_do_no_harm(tmp_path):
    path = d_file(tmp_path / "D_w07.csv", quoted=False)
    check_d(
        read_recording(
            edited(path, lambda lines: [", ".join(f'"{c}"' for c in x.split(",")) for x in lines])
        )
    )


def test_a_marker_that_sinks_slowly_is_not_seen_from_below(tmp_path):
    """A finger that rolls while it rests after its letter."""
    t, page = Pen().rest(1.0).draw(letter_a()).rest(3.0).sampled()
    page[:, 2] -= 0.016 * np.clip((t - t[-1] + 2.5) / 2.0, 0, 1)
    assert len(read_recording(motive(tmp_path / "a_w07.csv", t, lab(page))).strokes()) == 1


@pytest.mark.parametrize("lift", [0.02, 0.03])
def test_a_page_from_below_never_gives_a_letter_of_a_few_samples(tmp_path, lift):
    pen = Pen(speed=0.4).rest(1.0).draw(bar()).hop((0.0, 0.0), lift=lift).draw(bowl()).rest(1.0)
    with pytest.raises(
        RecordingError, match=r"try up='\+y'|up='-y' point out of the paper|no writing"
    ):
        read_recording(d_file(tmp_path / "D_w07.csv", pen), up="-y")


@pytest.mark.parametrize("lift", [0.02, 0.04])
def test_a_dot_at_the_end_is_kept_though_only_its_lift_tells_it_from_a_rest(tmp_path, lift):
    """An a with a dot: of a bar and a dot on one line nobody knows where the page is."""
    pen = (
        Pen()
        .rest(0.5)
        .draw(letter_a())
        .hop((0.03, 0.06), lift=lift)
        .rest(0.2)
        .fly((0.1, 0.0), lift, 0.3)
        .rest(0.5)
    )
    t, page = pen.sampled()
    recording = read_recording(motive(tmp_path / "a_w07.csv", t, lab(page)))
    assert {
        len(recording.strokes(theta, sigma))
        for theta in (0.08, 0.1)
        for sigma in (0.003, 0.006, 0.01)
    } == {2}


@pytest.mark.parametrize("lift", [0.03, 0.05])
@pytest.mark.parametrize("speed", [0.2, 0.3])
def test_a_small_quick_letter_with_high_lifts_lies_on_its_page(tmp_path, lift, speed):
    """Most of its way is in the air, and never under the paper."""
    pen = Pen(speed=speed).rest(0.4).draw(bar(0.4)).hop((0.0, 0.0), lift=lift, seconds=0.5)
    pen.draw(bowl(0.4)).fly((0.2, 0.05), 0.1, 0.4)
    recording = read_recording(d_file(tmp_path / "D_w07.csv", pen))
    assert len(recording.strokes()) == 2
    assert max(
        np.ptp(stroke.position, axis=0)[1] for stroke in recording.strokes()
    ) == pytest.approx(0.048, abs=0.003)


def test_gaps_are_filled_and_never_read_as_zero(tmp_path):
    holes = (slice(0, 3), slice(150, 151), slice(200, 209), slice(330, 331))
    whole, holed = (
        read_recording(d_file(tmp_path / f"D_w0{k}.csv", holes=h))
        for k, h in enumerate([(), holes])
    )
    check_d(holed)
    assert len(whole.t) == len(holed.t)
    assert np.abs(whole.position - holed.position).max() < 0.002


def test_a_long_gap_off_the_ink_does_no_harm(tmp_path):
    lift = int(writer_of_d().touches[0][1] * 120)
    check_d(
        read_recording(
            d_file(tmp_path / "D_w07.csv", holes=[slice(lift + 15, lift + 40), slice(20, 60)])
        )
    )


def test_a_long_gap_in_a_stroke_is_noted_by_frame_and_row(tmp_path):
    recording = read_recording(d_file(tmp_path / "D_w07.csv", holes=[slice(150, 169)]))
    check_d(recording)
    (note,) = recording.notes
    assert re.match(r"The marker is lost for 0\.17 s after frame 149 .row 157., inside stro", note)


def test_missing_rows_in_a_stroke_are_noted_like_a_gap(tmp_path):
    path = d_file(tmp_path / "D_w07.csv")
    lines = path.read_bytes().split(b"\r\n")
    path.write_bytes(b"\r\n".join(lines[:160] + lines[185:]))
    assert "is lost for 0.22 s" in read_recording(path).notes[0]


def test_the_recording_begins_and_ends_with_its_strokes(tmp_path):
    pen = Pen().rest(4.0).hop((0.0, 0.0)).rest(0.3).draw(letter_a()).fly((0.4, -0.2), 0.15, 0.5)
    recording = read_recording(d_file(tmp_path / "a_w07.csv", pen))
    (stroke,) = recording.strokes()
    assert (recording.t[0], recording.t[-1]) == (stroke.t[0], stroke.t[-1])
    assert abs(stroke.t[0] - pen.touches[0][0]) < 0.08
    assert abs(stroke.t[-1] - pen.touches[0][1]) < 0.08


def test_samples_are_turned_and_moved_but_never_smoothed(tmp_path):
    t, page = writer_of_d(slope=(0.05, -0.03)).sampled()
    world = lab(page)
    recording = read_recording(motive(tmp_path / "D_w07.csv", t, world))
    start = int(np.argmin(np.abs(t - recording.t[0])))
    raw = world[start : start + len(recording.t)]
    between = np.linalg.norm(np.diff(raw, axis=0), axis=1)
    assert np.allclose(
        np.linalg.norm(np.diff(recording.position, axis=0), axis=1), between, atol=2e-6
    )


@pytest.mark.parametrize(
    ("name", "character", "writer"),
    [
        ("a_w01.csv", "a", "w01"),
        ("a_w00_reexport.csv", "a", "w00"),
        ("D_w12.csv", "D", "w12"),
        ("Anna.csv", None, None),
        ("take_anna.csv", None, None),
    ],
)
def test_letter_and_pseudonym_come_from_the_name_and_real_names_stay_out(
    tmp_path, name, character, writer
):
    recording = read_recording(d_file(tmp_path / name))
    assert (recording.character, recording.writer, recording.baseline) == (character, writer, None)
    assert "Anna" not in repr(recording)


@settings(
    max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    east=st.floats(-1, 1), north=st.floats(-1, 1), high=st.floats(-1, 1), later=st.floats(0, 100)
)
def test_where_the_cameras_stood_does_not_matter(tmp_path, east, north, high, later):
    t, page = writer_of_d().sampled()
    here = read_recording(motive(tmp_path / "D_w01.csv", t, lab(page)))
    there = read_recording(
        motive(tmp_path / "D_w02.csv", t + later, lab(page) + np.array([east, high, north]))
    )
    for one, two in zip(here.strokes(), there.strokes(), strict=True):
        assert abs(one.t[0] + later - two.t[0]) < 0.02
        assert abs(one.t[-1] + later - two.t[-1]) < 0.02
    assert np.allclose(here.position.max(axis=0), there.position.max(axis=0), atol=0.0005)


def edited(path, change):
    """The file with its lines changed by a function."""
    path.write_text("\n".join(change(path.read_text().splitlines())))
    return path


def cell(row, column, text):
    """A change of one cell, row and column from 1."""

    def change(lines):
        cells = lines[row - 1].split(",")
        cells[column - 1] = text
        return [*lines[: row - 1], ",".join(cells), *lines[row:]]

    return change


BROKEN = {
    "no header": (
        lambda lines: lines[:6] + lines[7:],
        "a take of Motive without its row Frame,Time",
    ),
    "no frames": (lambda lines: lines[:7], "no frames under it"),
    # "1,0,5" is 1.0 and 5 or 1 and 0.5,
    "decimal comma": (
        cell(100, 10, "0,5"),
        "row 100: there are 13 cells, but the header has 12 columns.*decimal comma",
    ),
    # all that follows is one cell,
    "no end of a quote": (cell(100, 10, '"0.5'), "is not a CSV file: unexpected end of data"),
    # the letter may be of any size,
    "unknown unit": (
        cell(1, 8, "Parsecs"),
        "row 1: 'Length Units' is 'Parsecs', but must be Meters",
    ),
    "no markers": (
        lambda lines: [line.replace("Marker", "Bone") for line in lines],
        "no marker that could be the pen.*: none; export the positions of the markers",
    ),
    "no positions": (
        lambda lines: [line.replace("Position", "Error") for line in lines],
        "no marker that could be the pen.*: none; export the positions of the markers",
    ),
    # a part of a body that rests is the table's,
    # and a tenth of a second is no letter.
    "too short": (lambda lines: lines[:20], "was seen in 13 frames, but a letter needs 20"),
    "empty": (lambda lines: [], "is empty"),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_cannot_be_read_says_where_and_what_to_do(tmp_path, fault):
    change, sentence = BROKEN[fault]
    path = edited(d_file(tmp_path / "D_w07.csv", quoted=False), change)
    with pytest.raises(RecordingError, match=rf"D_w07.csv.*{sentence}") as caught:
        read_recording(path)
    assert str(tmp_path) not in str(caught.value), "folders have names of people in them"


LEFT_OUT = {
    "text in a cell": (
        cell(100, 11, "lots"),
        r"row 100, column 11 \('Unlabeled:5000' Y\): 'lots' is not a number",
    ),
    "NaN in a cell": (cell(100, 12, "nan"), r"row 100, column 12 \('Unlabeled:5000' Z\): 'nan'"),
    "Python's underscore": (
        cell(100, 12, "0_1"),
        r"row 100, column 12 \('Unlabeled:5000' Z\): '0_1' is not a number",
    ),
    "no time": (
        cell(100, 2, ""),
        r"row 100, column 2 \(Time\): '' is not a number; .*every frame needs its time",
    ),
    "time stands still": (
        cell(101, 2, "0.766667"),
        r"row 101, column 2 \(Time\).*must increase from row to row",
    ),
    "time leaps": (cell(300, 2, "1e9"), r"row 300, column 2 \(Time\).*by at most 60 s"),
}


@pytest.mark.parametrize("fault", LEFT_OUT)
def test_a_row_or_a_cell_that_cannot_be_is_left_out_and_told(tmp_path, fault):
    change, sentence = LEFT_OUT[fault]
    path = d_file(tmp_path / "D_w07.csv", quoted=False)
    clean = read_recording(path)
    recording = read_recording(edited(path, change))
    assert any(re.search(rf"The first: .*{sentence}", note) for note in recording.notes)
    for stroke, wanted in zip(recording.strokes(), clean.strokes(), strict=True):
        assert abs(len(stroke) - len(wanted)) < 3


def test_unknown_markers_are_answered_with_those_that_could_be(tmp_path):
    with pytest.raises(
        RecordingError, match=r"D_w07.csv: there is no marker 'pen'.*: 'Unlabeled:5000'\."
    ):
        read_recording(d_file(tmp_path / "D_w07.csv"), marker="pen")


@pytest.mark.parametrize(
    ("axes", "sentence"),
    [
        ({"up": ["+y"]}, r"up is \['\+y'\], but must be one of"),
        ({"up": "y"}, "up is 'y', but must be one of '[+]x'"),
        ({"right": "+q"}, "right is '[+]q'"),
        ({"up": "+x"}, "must lie along two different axes"),
        ({"up": "+z"}, "page lies 90 degrees from level.*try up='[+]y'"),
        ({"up": "-y"}, "page lies 180 degrees from level.*try up='[+]y'"),
    ],
)
def test_wrong_axes_are_answered_with_the_right_ones(tmp_path, axes, sentence):
    pen = (
        Pen()
        .rest(0.5)
        .draw(bar())
        .hop((0.0, 0.0), lift=0.04)
        .draw(bowl())
        .fly((0.3, 0.0), 0.1, 0.5)
    )
    with pytest.raises(RecordingError, match=sentence):
        read_recording(d_file(tmp_path / "D_w07.csv", pen), **axes)


@pytest.mark.parametrize("scale", [1000.0, 100.0, 0.001])
def test_millimetres_called_metres_are_refused(tmp_path, scale):
    with pytest.raises(RecordingError, match=r"D_w07.csv: marker .* 'Length Units' in row 1 right"):
        read_recording(d_file(tmp_path / "D_w07.csv", scale=scale))


@pytest.mark.parametrize("cell", ["350.1", "-2e6", "1e99"])
def test_one_number_that_cannot_be_is_left_out_and_noted_by_its_row(tmp_path, cell):
    """A point that was lost, as where 0.3501 became 3501."""
    path = d_file(tmp_path / "D_w07.csv")
    clean = read_recording(path)
    lines = path.read_text().splitlines()
    lines[206] = ",".join([*lines[206].split(",")[:-1], cell])
    path.write_text("\n".join(lines))
    odd = read_recording(path)
    assert len(odd.strokes()) == len(clean.strokes())
    assert np.allclose(odd.position, clean.position, atol=0.002)
    assert re.search(r"farther than a hand moves, 1 times, .* \(row 207\)", odd.notes[0])


def test_where_no_other_marker_moves_one_of_a_body_is_the_pen(tmp_path):
    path = d_file(tmp_path / "D_w07.csv")
    clean = read_recording(path)
    text = path.read_text().replace("Unlabeled:5000", "RigidBody 2:Marker1")
    path.write_text(text.replace("Marker,", "Rigid Body Marker,"))
    assert np.array_equal(read_recording(path).position, clean.position)


def test_two_names_of_one_marker_may_overlap(tmp_path):
    t, page = writer_of_d().sampled()
    clean = read_recording(motive(tmp_path / "a.csv", t, lab(page)))
    early, late = lab(page), lab(page)
    early[260:], late[:250] = np.nan, np.nan
    path = motive(tmp_path / "b.csv", t, early, ghosts=[("Unlabeled:6000", late)])
    assert np.array_equal(read_recording(path).position, clean.position)


def test_markers_that_swap_their_names_are_followed(tmp_path):
    t, page = writer_of_d().sampled()
    rest = np.tile([0.3, 0.2, 0.0], (len(t), 1))
    clean = read_recording(motive(tmp_path / "a.csv", t, lab(page), ghosts=[("Cup", lab(rest))]))
    swapped = slice(180, 290)
    page[swapped], rest[swapped] = rest[swapped].copy(), page[swapped].copy()
    odd = read_recording(motive(tmp_path / "b.csv", t, lab(page), ghosts=[("Cup", lab(rest))]))
    assert np.array_equal(odd.position, clean.position)
    assert set(str(odd.marker).split(", then ")) == {"Unlabeled:5000", "Cup"}


def test_a_marker_that_was_never_seen_is_not_preferred_to_one_that_rests(tmp_path):
    t = np.arange(300) / 120
    unseen = ("Unlabeled:6000", np.full((300, 3), np.nan))
    with pytest.raises(
        RecordingError, match=r"marker 'Unlabeled:5000' moves within .*named .*: 'Unlabeled:6000'"
    ):
        read_recording(
            motive(tmp_path / "a_w07.csv", t, lab(np.full((300, 3), 0.02)), ghosts=[unseen])
        )


def test_a_pen_that_only_rests_wrote_nothing(tmp_path):
    t, noise = np.arange(300) / 120, np.random.default_rng(0).normal(0, 1e-4, (300, 3))
    with pytest.raises(RecordingError, match=r"a_w07\.csv: marker 'Unlabeled:5000' moves within"):
        read_recording(motive(tmp_path / "a_w07.csv", t, lab(noise)))


@pytest.mark.parametrize("leap", [(0.005, 0, 0), (0, -0.005, 0), (0, 0, 0.005)])
@pytest.mark.parametrize("back", [False, True])
def test_a_jump_of_5_mm_in_a_stroke_is_noted_by_frame_and_row(tmp_path, leap, back):
    t, page = writer_of_d().sampled()
    page[170 : 171 if back else None] += leap
    recording = read_recording(motive(tmp_path / "D_w07.csv", t, lab(page)))
    assert len(recording.strokes()) == 2
    assert repr(recording).endswith("s, 1 note)")
    (note,) = recording.notes
    assert re.match(r"The marker jumps by up to \d[.]\d mm inside a stroke.* frame 1[67]\d", note)


def flickers(lot, page, _):
    """By 4 to 9 mm, as in takes in which a person can see the letters."""
    page += np.where(lot.random(len(page)) < 0.05, lot.uniform(0.004, 0.009, len(page)), 0)[:, None]


def leaps_far(lot, page, _):
    """By centimetres, for some frames each time."""
    for k in lot.integers(20, len(page) - 20, 6):
        page[k : k + 4] += lot.uniform(-0.05, 0.05, 3)


def is_taken_for_the_hand(lot, page, hand):
    """And the hand for the pen, for up to a fifth of a second."""
    for k in lot.integers(20, len(page) - 20, 4):
        part = slice(k, k + lot.integers(1, 25))
        page[part], hand[part] = hand[part].copy(), page[part].copy()


def is_lost(lot, page, _):
    for k in lot.integers(80, 200, 3):
        page[k : k + 15] = np.nan


def is_lost_and_leaps(lot, page, hand):
    leaps_far(lot, page, hand)
    is_lost(lot, page, hand)


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize(
    "noise", [flickers, leaps_far, is_taken_for_the_hand, is_lost, is_lost_and_leaps]
)
def test_a_noisy_marker_leaves_the_strokes_and_a_note(tmp_path, noise, seed):
    t, page = writer_of_d().sampled()
    hand = page + np.array([0.02, -0.03, 0.05])
    noise(np.random.default_rng(seed), page, hand)
    take = motive(tmp_path / "D_w07.csv", t, lab(page), ghosts=[("Hand", lab(hand))])
    recording = read_recording(take, "Unlabeled:5000")
    assert len(recording.strokes()) == 2
    assert any("jumps by up to" in note or "is lost for" in note for note in recording.notes)
    assert "#ffd54d" in recording._repr_svg_()
    start = np.flatnonzero(np.isclose(t, recording.t[0]))[0]
    seen = ~np.isnan(page[start : start + len(recording.t), 0])
    assert recording.marker == "Unlabeled:5000"
    # As exported: steps are as long as they were, leaps and all.
    both = np.flatnonzero(seen[1:] & seen[:-1])
    steps, wanted = (
        np.linalg.norm(np.diff(each, axis=0), axis=1)[both]
        for each in (recording.position, page[start : start + len(recording.t)])
    )
    assert np.allclose(steps, wanted, atol=5e-6)


@pytest.mark.slow
@pytest.mark.parametrize("leap", [0.008, 0.02])
@pytest.mark.parametrize("sample", [150, 380])
@pytest.mark.parametrize("back", [False, True])
def test_a_leap_off_the_paper_is_noted(tmp_path, leap, sample, back):
    """A marker taken for another one, higher up: what follows may be dropped as flight."""
    t, page = writer_of_d().sampled()
    page[sample : sample + 1 if back else None, 2] += leap
    notes = read_recording(motive(tmp_path / "D_w07.csv", t, lab(page))).notes
    assert re.match(r"The marker jumps by up to \d+[.]\d mm (in|be)side a stroke", notes[-1])


@pytest.mark.parametrize("rate", [30.0, 60.0, 120.0])
def test_a_fast_hand_in_the_air_does_not_jump(tmp_path, rate):
    pen = Pen(speed=0.4).rest(0.5).draw(bar()).hop((0.0, 0.0), lift=0.06, seconds=0.35).draw(bowl())
    pen.fly((0.4, 0.1), 0.2, 0.4)
    assert len(read_recording(d_file(tmp_path / "D_w07.csv", pen, rate=rate)).strokes()) == 2


@pytest.mark.slow
@needs_recordings
@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_every_real_recording_has_the_strokes_that_one_sees(path):
    recording = read_recording(path)
    expected = COUNTS.get(path.stem, 1)
    assert (recording.character, recording.writer) == tuple(path.stem.split("_")[:2])
    for theta, sigma in GRID:
        assert len(recording.strokes(theta, sigma)) == expected, (theta, sigma)
    down = np.concatenate(
        [recording.position[np.isin(recording.t, s.t), 2] for s in recording.strokes()]
    )
    assert abs(np.median(down)) < 0.001
    assert np.abs(down).max() < 0.008


@needs_recordings
@pytest.mark.parametrize(
    "path", [p for p in RECORDINGS if p.stem.endswith("_reexport")], ids=lambda path: path.stem
)
def test_the_same_take_exported_twice_is_the_same_recording(path):
    twice, once = (
        read_recording(path),
        read_recording(path.with_name(path.name.replace("_reexport", ""))),
    )
    assert np.allclose(once.t, twice.t)
    assert np.allclose(once.position, twice.position, atol=1e-5)
