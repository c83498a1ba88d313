"""Which marker is the pen, also where it changes its name, and what else a table may say."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.take import read_take
from dmp_teach.formats.read import read_recording
from tests.formats.motive_csv import Pen, bar, lab, motive
from tests.formats.test_reader import check_d, d_file, edited

NOISE = np.random.default_rng(0).normal(0, 0.0004, (10_000, 3))


def good_files(folder):
    """For the tests of damaged files: a bar, and one whose marker has two names."""
    t, page = Pen().rest(0.3).draw(bar()).fly((0.2, 0.0), 0.1, 0.5).sampled(60)
    world = lab(page)
    ghosts = [("Unlabeled:5003", only(world, 42, len(t)))]
    before, robot = only(world, 0, 40), ("Robot", (0.1, 0.2, 0.3))
    return {
        "a.csv": motive(folder / "x.csv", t, world).read_bytes(),
        "b.csv": motive(folder / "y.csv", t, before, ghosts=ghosts, body=robot).read_bytes(),
    }


def only(world, start, end):
    """A marker that is seen in the frames `start:end` only."""
    part = np.full_like(world, np.nan)
    part[start:end] = world[start:end]
    return part


def hand(seconds=1.5):
    """The D of all tests, at rest before and after, as the cameras see it."""
    t, page = (
        Pen().rest(seconds).draw(bar()).hop((0.0, 0.0)).draw(bowl_of_d()).rest(seconds).sampled()
    )
    return t, lab(page)


def bowl_of_d():
    angle = np.radians(np.linspace(90, -90, 40))
    return np.column_stack([0.07 * np.cos(angle), 0.06 * np.sin(angle) - 0.06])


def circling(t):
    """A hand far from the pen that moves all the time."""
    return np.column_stack([0.3 + 0.02 * np.sin(3 * t), 0.05 + 0 * t, 0.2 + 0.03 * np.cos(2 * t)])


def spans(recording):
    return np.array([(stroke.t[0], stroke.t[-1]) for stroke in recording.strokes()])


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    cuts=st.lists(st.integers(30, 590), min_size=1, max_size=3, unique=True).map(sorted),
    gap=st.integers(0, 4),
)
def test_a_marker_that_changes_its_name_is_followed(tmp_path, cuts, gap):
    t, world = hand()
    whole = read_recording(motive(tmp_path / "D_w01.csv", t, world))
    edges = [0, *cuts, len(t)]
    pieces = [
        (f"Unlabeled:{5000 + k}", only(world, edges[k] + gap * (k > 0), edges[k + 1]))
        for k in range(len(cuts) + 1)
    ]
    swapped = read_recording(
        motive(tmp_path / "D_w07.csv", t, pieces[0][1], pen=pieces[0][0], ghosts=pieces[1:])
    )
    assert np.abs(spans(swapped) - spans(whole)).max() < 0.05
    assert np.allclose(swapped.position.max(axis=0), whole.position.max(axis=0), atol=0.002)


def test_two_names_that_take_turns_are_one_pen(tmp_path):
    t, world = hand()
    first, second = world.copy(), np.full(world.shape, np.nan)
    for a, b in [(60, 100), (150, 151), (200, 340), (352, 400)]:
        first[a:b], second[a:b] = np.nan, world[a:b]
    path = motive(tmp_path / "D_w07.csv", t, first, ghosts=[("Unlabeled:5001", second)])
    recording = read_recording(path)
    check_d(recording, Pen(touches=touches()))
    assert recording.marker == "Unlabeled:5000, then Unlabeled:5001"


def test_a_name_for_a_while_is_followed_and_ghosts_far_away_are_not(tmp_path):
    """Motive may find the old name again; a ghost that begins in that frame is elsewhere."""
    t, world = hand()
    first = world.copy()
    first[250:350] = np.nan
    ghosts = [
        ("Unlabeled:5001", only(world, 250, 350)),
        ("Unlabeled:5002", only(circling(t), 250, 300)),
    ]
    whole = read_recording(motive(tmp_path / "D_w01.csv", t, world))
    again = read_recording(motive(tmp_path / "D_w07.csv", t, first, ghosts=ghosts))
    assert np.array_equal(again.position, whole.position)


def test_of_two_that_could_be_the_lost_marker_the_nearer_one_is_taken(tmp_path):
    t, world = hand()
    ghosts = [(f"Unlabeled:{5001 + k}", only(world + 0.004 * k, 220, len(t))) for k in (1, 0)]
    path = motive(tmp_path / "D_w07.csv", t, only(world, 0, 220), ghosts=ghosts)
    check_d(read_recording(path, "Unlabeled:5000"), Pen(touches=touches()))


@pytest.mark.parametrize("front", [True, False])
def test_of_several_that_move_the_one_at_the_paper_is_the_pen(tmp_path, front):
    """As of a marker on the pen and one on the back of the hand; the note names both."""
    t, world = hand()
    back = world[:, [0, 1, 2]] * [0.7, 0.7, 0.7] + [0.1, 0.08, 0.05]
    markers = [("Unlabeled:5001", back), ("Unlabeled:5000", world)]
    first, last = markers if front else markers[::-1]
    path = motive(tmp_path / "D_w07.csv", t, last[1], pen=last[0], ghosts=[first])
    recording = read_recording(path)
    check_d(recording, Pen(touches=touches()))
    (note,) = recording.notes
    assert "for the pen is 'Unlabeled:5000'" in note
    assert note.endswith("marker=...: 'Unlabeled:5001'.")
    assert np.ptp(read_recording(path, marker="Unlabeled:5001").position[:, 1]) < 0.1


def test_a_pen_that_is_a_rigid_body_is_read(tmp_path):
    """Beside a marker that somebody left on the table."""
    t, world = hand()
    left = [("Unlabeled:5001", np.array([0.1, 0.05, 0.3]) + NOISE[: len(t)])]
    path = motive(tmp_path / "D_w07.csv", t, world, pen="Pen", ghosts=left)
    bodies = ["Rigid Body"] * 3
    edited(
        path, lambda lines: [*lines[:2], ",".join([*lines[2].split(",")[:-3], *bodies]), *lines[3:]]
    )
    check_d(read_recording(path), Pen(touches=touches()))
    check_d(read_recording(path, marker="Pen"), Pen(touches=touches()))


def test_a_pen_that_is_a_body_is_named_beside_a_hand_that_moves(tmp_path):
    t, world = hand()
    path = motive(tmp_path / "D_w07.csv", t, world, pen="Pen", ghosts=[("Hand", world + 0.05)])
    kinds = ["Marker"] * 3 + ["Rigid Body"] * 3
    edited(
        path, lambda lines: [*lines[:2], ",".join([*lines[2].split(",")[:-6], *kinds]), *lines[3:]]
    )
    (note,) = read_recording(path).notes
    assert note.endswith("could be named with marker=...: 'Pen'.")
    pen = read_recording(path, marker="Pen")
    check_d(pen, Pen(touches=touches()))
    assert (pen.marker, pen.notes) == ("Pen", ())


def test_a_marker_may_have_the_name_of_a_body_without_a_place(tmp_path):
    t, world = hand()
    path = motive(tmp_path / "D_w07.csv", t, world, pen="Pen", body=("Pen", circling(t)))
    check_d(read_recording(path), Pen(touches=touches()))


@pytest.mark.parametrize("cut", [215, 240, 350, 380, 420])
def test_a_marker_that_is_lost_for_good_in_a_stroke_is_noted(tmp_path, cut):
    t, world = hand()
    stroke = 0 if cut < 300 else 1
    notes = read_recording(motive(tmp_path / "D_w07.csv", t, only(world, 0, cut))).notes
    assert f"is lost for good after frame {cut - 1} (row {cut + 7}), inside stroke {stroke}" in str(
        notes
    )


@pytest.mark.parametrize("cut", [200, 240, 360, 400])
def test_a_marker_that_is_first_seen_in_a_stroke_is_noted(tmp_path, cut):
    t, world = hand()
    notes = read_recording(motive(tmp_path / "D_w07.csv", t, only(world, cut, len(t)))).notes
    assert f"is first seen at frame {cut} (row {cut + 8}), inside stroke 0, of which" in str(notes)


def test_a_marker_that_is_lost_at_rest_or_in_the_air_does_no_harm(tmp_path):
    t, world = hand()
    check_d(
        read_recording(motive(tmp_path / "D_w07.csv", t, only(world, 100, len(t) - 100))),
        Pen(touches=touches()),
    )
    pen = (
        Pen()
        .rest(0.5)
        .draw(bar())
        .hop((0.0, 0.0))
        .draw(bowl_of_d())
        .fly((0.2, 0.0), 0.1, 0.5)
        .rest(1.0)
    )
    t, page = pen.sampled()
    for later in (0.1, 0.2, 0.3):
        path = motive(
            tmp_path / "D_w07.csv", t, only(lab(page), 0, int((pen.touches[1][1] + later) * 120))
        )
        check_d(read_recording(path), pen)


def touches():
    return Pen().rest(1.5).draw(bar()).hop((0.0, 0.0)).draw(bowl_of_d()).touches


@pytest.mark.parametrize("name", ["RigidBody 1", "Robot", "Rigid Body 001", "a:b", "Stift"])
def test_a_rigid_body_that_moves_is_not_the_pen_whatever_its_name(tmp_path, name):
    t, world = hand()
    world[170:174] = np.nan
    recording = read_recording(motive(tmp_path / "D_w07.csv", t, world, body=(name, circling(t))))
    check_d(recording, Pen(touches=touches()))
    assert recording.marker == "Unlabeled:5000"


@pytest.mark.parametrize("pen", ["traj:FKA-RigidBody 1:Marker2 (2)", "finger:Unlabeled:5286"])
@pytest.mark.parametrize("body", ["RigidBody 1", "traj", "traj:FKA-RigidBody 1", "finger"])
def test_a_name_that_begins_like_a_body_may_be_the_pen(tmp_path, pen, body):
    t, world = hand()
    check_d(
        read_recording(motive(tmp_path / "D_w07.csv", t, world, pen=pen, body=(body, circling(t)))),
        Pen(touches=touches()),
    )


def test_of_very_many_names_some_are_listed(tmp_path):
    t = np.arange(30) / 120
    ghosts = [(f"Unlabeled:{k}" + "x" * 100 * (k == 3), np.ones((30, 3))) for k in range(60)]
    with pytest.raises(
        RecordingError,
        match=r"'Unlabeled:2', 'Unlabeled:3x{49} \.\.\.', .*'Unlabeled:19', \.\.\.\.$",
    ):
        read_recording(
            motive(tmp_path / "a_w01.csv", t, np.ones((30, 3)), ghosts=ghosts), marker="pen"
        )


def test_a_body_can_still_be_named(tmp_path):
    t, world = hand()
    path = motive(tmp_path / "D_w07.csv", t, circling(t), body=("Robot", world))
    check_d(read_recording(path, marker="Robot:Marker1"), Pen(touches=touches()))


GHOSTS = {
    "one wrong cell": (7, 8, 0.5),
    "pushed once": (250, None, 0.006),
    "pushed far": (250, None, 0.1),
}


@pytest.mark.parametrize("kind", GHOSTS)
def test_a_ghost_that_was_pushed_or_has_a_wrong_cell_is_not_the_pen(tmp_path, kind):
    start, end, by = GHOSTS[kind]
    t, world = hand()
    world[170:175] = np.nan
    still = np.array([0.1, 0.05, 0.3]) + NOISE[: len(t)]
    still[start:end, 0] += by
    check_d(
        read_recording(
            motive(tmp_path / "D_w07.csv", t, world, ghosts=[("Unlabeled:4999", still)])
        ),
        Pen(touches=touches()),
    )


@pytest.mark.parametrize("size", [0.006, 0.02])
def test_a_quick_small_pen_is_not_taken_for_a_ghost(tmp_path, size):
    t, page = Pen(speed=0.5).rest(1.0).draw(np.array([(0.0, -size)])).rest(1.0).sampled()
    world = lab(page)
    world[20:40] = np.nan
    still = np.array([0.1, 0.05, 0.3]) + NOISE[: len(t)]
    path = motive(tmp_path / "i_w07.csv", t, world, ghosts=[("Unlabeled:4999", still)])
    out = np.array([0.0, 1.0, 0.0])
    assert read_take(path.read_bytes(), None, out).pen.name == "Unlabeled:5000"


@pytest.mark.parametrize("sign", [";", "\t"])
def test_other_signs_between_columns_and_decimal_commas_are_read(tmp_path, sign):
    """As a German office saves a table."""
    path = edited(
        d_file(tmp_path / "D_w07.csv", quoted=False),
        lambda lines: [line.replace(",", sign).replace(".", ",") for line in lines],
    )
    check_d(read_recording(path))


UNITS = {
    "mm": 1e3,
    "Millimetres": 1e3,
    "MILLIMETERS": 1e3,
    "cm": 1e2,
    "m": 1,
    "Metre": 1,
    "cm.": 1e2,
}


@pytest.mark.parametrize("unit", UNITS)
def test_units_have_many_names(tmp_path, unit):
    check_d(read_recording(d_file(tmp_path / "D_w07.csv", units=unit, scale=UNITS[unit])))


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig"])
def test_a_table_from_an_office_is_text_too(tmp_path, encoding):
    path = d_file(tmp_path / "D_w07.csv", pen="Zeigefinger ä")
    path.write_bytes(path.read_bytes().decode().encode(encoding))
    check_d(read_recording(path))


def test_rounded_times_that_repeat_want_more_decimals(tmp_path):
    t, world = hand()
    path = motive(tmp_path / "D_w07.csv", t, world, times="{:.2f}", empty_last=False)
    with pytest.raises(RecordingError, match=r"column 2 \(Time\): .* must increase .*re decimals"):
        read_recording(path)


@pytest.mark.parametrize(
    ("name", "character"), [("a\u0308_w01.csv", "ä"), ("é_w01.csv", "é"), ("e\u0301_w01.csv", "é")]
)
def test_a_file_name_as_macos_writes_it_keeps_its_letter(tmp_path, name, character):
    recording = read_recording(d_file(tmp_path / name))
    assert (recording.character, recording.writer) == (character, "w01")
