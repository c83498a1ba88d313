"""The commands for meshcat's viewer: complete, small, and sent to nobody."""

import gzip
import re
import socket
import uuid

import numpy as np
import pytest
import umsgpack

from dmp_teach.errors import PathError, SettingError, ViewError, kind_of
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.page import Page
from dmp_teach.views.scene.commands import record_robot, record_stage
from dmp_teach.views.scene.packing import PackedMesh
from dmp_teach.views.scene.stage import Stage
from dmp_teach.views.scene.view import SceneView, view
from tests.views.moves import sway, unpack_commands


def commands(packed):
    return [umsgpack.unpackb(command) for command in packed]


def typed(packed, dtype):
    return np.frombuffer(packed.data, dtype)


@pytest.fixture(scope="module")
def run(motion):
    return commands(record_stage(Stage(motion)))


def test_no_socket_is_opened(monkeypatch, tmp_path):
    def refuse(*_, **__):
        raise AssertionError("a socket was opened")

    for name in ("bind", "listen", "connect"):
        monkeypatch.setattr(socket.socket, name, refuse)
    record_robot()
    view(sway(seconds=0.5)).html(tmp_path / "a.html")


def test_every_piece_of_the_shell_hangs_on_its_link():
    sent = commands(record_robot())
    pieces = [
        command
        for command in sent
        if command["type"] == "set_object" and "/robot/" in command["path"]
    ]
    links = [command["path"].split("/")[-2] for command in pieces]
    assert links == [piece.link for piece in Model.load().visuals]


def test_a_packed_shell_is_the_models_shell_to_a_fiftieth_of_a_millimetre():
    for piece in Model.load().visuals:
        mesh = PackedMesh(piece.vertices, piece.normals, piece.faces)
        back = mesh.vertices * mesh.X[0, 0] + mesh.X[:3, 3]
        assert np.abs(back - piece.vertices).max() < 2e-5
        assert np.abs(mesh.normals / 127 - piece.normals).max() < 0.005
        assert (mesh.faces == piece.faces).all()


def test_the_animation_comes_last_and_moves_exactly_the_joints_that_move(run, motion):
    assert [command["type"] for command in run].index("set_animation") == len(run) - 1
    animated = {clip["path"].split("/")[-1] for clip in run[-1]["animations"]}
    model = Model.load()
    assert animated == {model.joint(name).child for name in motion.joint_names} | {"<object>"}
    assert run[-1]["options"]["play"] is False


def test_the_ink_track_counts_whole_triangles_of_what_is_written_forwards_and_backwards(
    run, motion
):
    track = next(c for c in run[-1]["animations"] if c["path"].endswith("ink/<object>"))["clip"][
        "tracks"
    ][0]
    assert (track["name"], track["interpolation"]) == (".drawRange[count]", 2300)
    times, counts = (typed(track[key], np.float32) for key in ("times", "values"))
    ink = Stage(motion).ink
    for t in [*np.linspace(0, motion.duration, 50), *np.linspace(motion.duration, 0, 50)]:
        shown = counts[np.searchsorted(times, t + 1e-4, side="right") - 1]
        assert shown in (3 * ink.triangles(t), 3 * ink.triangles(t + 2e-4))
    assert counts[0] == 0
    assert counts[-1] == 3 * len(ink.faces)


def test_the_ink_lies_where_the_tip_was_while_the_pen_was_down(run, motion):
    command = next(c for c in run if c["type"] == "set_object" and c["path"] == "/meshcat/ink")
    X = np.array(command["object"]["object"]["matrix"]).reshape(4, 4).T
    packed = command["object"]["geometries"][0]["data"]["attributes"]["position"]["array"]
    vertices = typed(packed, np.int16).reshape(-1, 3) @ X[:3, :3].T + X[:3, 3]
    tips = motion.page.to_page(motion.tip[motion.pen_down])[:, :2]
    off = np.linalg.norm(vertices[:, None, :2] - tips[None, ::3], axis=2).min(axis=1)
    assert off.max() < 0.004
    assert vertices[:, 2] == pytest.approx(0.0006, abs=3e-5)


def test_nothing_of_the_machine_is_in_the_commands():
    machine = uuid.getnode().to_bytes(6, "big").hex().encode()
    for packed in (*record_robot(), *record_stage(Stage(sway(seconds=0.5)))):
        assert machine not in packed
        assert not re.search(rb"[0-9a-f]{8}-[0-9a-f]{4}-", packed)
    assert record_stage(Stage(sway(seconds=0.5))) == record_stage(Stage(sway(seconds=0.5)))


def test_without_a_motion_the_robot_stands_at_an_empty_page():
    shown = SceneView()
    sent = commands(unpack_commands(shown.run))
    assert sent[-1]["animations"] == []
    assert any(command["path"] == "/meshcat/around/page" for command in sent)
    assert (shown.motion, shown.playing, shown.facts["duration"]) == (None, False, 0)
    tip = Model.load().frame("pen_tip", Stage().keys[1], Stage().joint_names)[0, :3, 3]
    assert Page.table().to_page(tip)[2] > 0.02, "the pen waits over the paper"


def test_another_motion_takes_the_place_of_the_first_and_the_camera_stays(motion):
    shown = view(motion)
    before, shown.camera, shown.time = shown.run, "whole robot", 1.0
    other = sway(seconds=1.0)
    shown.show(other)
    assert shown.motion is other
    assert shown.run != before
    assert (shown.camera, shown.time, shown.playing) == ("whole robot", 0.0, True)
    assert shown.facts["duration"] == pytest.approx(1.0)


def test_show_gives_every_motion_another_name(motion):
    shown = SceneView()
    names = [shown.motion_id]
    for value in (motion, motion, None):
        shown.show(value)
        names.append(shown.motion_id)
    assert len(set(names)) == 4


def test_the_browsers_memoryviews_are_taken_for_bytes(motion):
    shown = view(motion)
    shown.set_state(
        {"time": 0.5, "playing": False, "camera": "whole robot", "run": memoryview(shown.run)}
    )
    assert isinstance(shown.run, bytes)
    assert (shown.time, shown.camera) == (0.5, "whole robot")


@pytest.mark.parametrize("wrong", [None, 3, "a.csv", [1, 2]])
def test_what_is_no_motion_is_refused_by_name(wrong):
    said = rf"{kind_of(wrong, first=True)} cannot be shown; a Motion can, .*; so can a Run, which"
    with pytest.raises(ViewError, match=said):
        view(wrong)
    with pytest.raises(TypeError):
        SceneView().show(wrong or 0)


def test_the_viewer_is_meshcats_own():
    code = gzip.decompress(SceneView().viewer)
    assert b"MeshCat" in code
    assert len(SceneView().viewer) < 250_000


def test_a_file_is_small_complete_and_asks_nobody(motion, tmp_path):
    path = view(motion).html(tmp_path / "a.html")
    text = path.read_text(encoding="utf-8")
    assert path.stat().st_size <= 800_000
    assert not re.search(r"""(?:src|href)\s*=\s*["'](?!data:)|@import|url\(\s*["']?http""", text)
    assert "default-src 'none'" in text
    assert '<html lang="en">' in text
    assert "<title>" in text
    assert list(tmp_path.iterdir()) == [path]


def test_even_a_minute_of_writing_is_a_small_file(tmp_path):
    motion = sway(seconds=60.0)
    assert view(motion).html(tmp_path / "long.html").stat().st_size <= 800_000


def test_a_place_that_cannot_be_written_is_a_sentence(motion, tmp_path):
    shown = view(motion)
    # Before the work, which asks for a camera.
    with pytest.raises(PathError, match=r"its name must end with \.png: try 'a\.png'"):
        shown.png(tmp_path / "a.html", camera="none")
    with pytest.raises(PathError, match=r"its name must end with \.html: try 'a\.html'"):
        shown.html(tmp_path / "a.txt")
    with pytest.raises(
        OSError, match=r"There is no folder '.*nowhere' for 'a\.html'; make it first"
    ):
        shown.html(tmp_path / "nowhere" / "a.html")


def test_a_moment_outside_of_the_motion_has_no_picture(motion, tmp_path):
    shown = view(motion)
    with pytest.raises(SettingError, match=r"time is 9.0 s, but must be between 0 and 2.400 s"):
        shown.png(tmp_path / "a.png", time=9.0)
    with pytest.raises(
        SettingError, match="width is 10, but must be a whole number of pixels from 64 to 4000"
    ):
        shown.png(tmp_path / "a.png", width=10)
    with pytest.raises(SettingError, match="camera is 'up'"):
        shown.png(tmp_path / "a.png", camera="up")
    assert not list(tmp_path.iterdir())
