"""The letter can be read, whatever the page."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import SettingError
from dmp_teach.ink import recording_of
from dmp_teach.letters import write_word
from dmp_teach.robot import Fetch
from dmp_teach.robot.page import Page
from dmp_teach.views.scene.cameras import (
    ARM_LINKS,
    CAMERA_NAMES,
    FITTED_ASPECT,
    SMALL_PAGE_CORNER,
    check_camera_name,
    fit_cameras,
)
from dmp_teach.views.scene.shapes import build_surroundings
from dmp_teach.views.scene.sight import MovingBoxes
from dmp_teach.views.scene.stage import Stage

tables = st.builds(
    Page.table, x=st.floats(0.5, 0.9), y=st.floats(-0.3, 0.3), z=st.floats(0.45, 0.95)
)
boards = st.builds(Page.board, x=st.floats(0.6, 1.1), y=st.floats(-0.3, 0.3), z=st.floats(0.8, 1.4))


def picture_of(camera, points, aspect=FITTED_ASPECT):
    """Where points are in the picture, from -1 to 1 if they are in it, and their distance."""
    eye, target, up = (np.array(v) for v in (camera.eye, camera.target, camera.up))
    back = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross(up, back) / np.linalg.norm(np.cross(up, back))
    seen = (points - eye) @ np.column_stack([right, np.cross(back, right), -back])
    slope = camera.slope(aspect)
    return seen[:, :2] / seen[:, 2:] / (slope * aspect, slope), seen[:, 2]


def corners_of(page, width, height):
    return page.to_world([(x * width / 2, y * height / 2) for x in (-1, 1) for y in (-1, 1)])


def table_of(page):
    return np.vstack([shape.vertices for shape in build_surroundings(page)])


def boxes_of(stage, t=(0.0,)):
    """A box round every piece of the robot, at times."""
    pieces = stage.model.visuals
    poses = stage.model.link_poses([stage.joints(moment) for moment in t], stage.joint_names)
    own = [
        piece.vertices @ piece.X_link_visual[:3, :3].T + piece.X_link_visual[:3, 3]
        for piece in pieces
    ]
    return MovingBoxes(
        tuple(piece.link for piece in pieces),
        np.array([points.min(axis=0) for points in own]),
        np.array([points.max(axis=0) for points in own]),
        np.stack([np.broadcast_to(poses[piece.link], (len(t), 4, 4)) for piece in pieces], 1),
    )


ROBOT = boxes_of(Stage())


def covered(eye, triangles, points):
    """Whether triangles (F, 3, 3) lie between an eye and each point (P, 3), by triple products."""
    a, b, c = np.moveaxis(triangles - eye, 1, 0)
    sides = np.stack([np.cross(*pair) @ (points - eye).T for pair in ((a, b), (b, c), (c, a))])
    inside = (sides > 0).all(axis=0) | (sides < 0).all(axis=0)
    volume = np.sum(a * np.cross(b, c), axis=1)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        way = volume / sides.sum(axis=0)
    return (inside & (way > 0) & (way < 0.995)).any(axis=0)


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 1000))
def test_a_box_hides_what_its_twelve_triangles_hide(seed):
    rng = np.random.default_rng(seed)
    pose = np.eye(4)
    pose[:3, :3] = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    pose[:3, 3] = rng.normal(size=3)
    low = -rng.uniform(0.1, 1, 3)
    box = MovingBoxes(("box",), low[None], -low[None], pose[None, None])
    corners = box.corners[0, 0]
    sides = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    faces = [each for a, b, c, d in sides for each in ((a, b, c), (a, c, d))]
    eye, points = 4 * rng.normal(size=3), 3 * rng.normal(size=(200, 3))
    hidden = box.hide(eye, points)[0, 0]
    through = covered(eye, corners[faces], points)
    inside = (np.abs((points - pose[:3, 3]) @ pose[:3, :3]) < -low).all(axis=1)
    assert (hidden == through)[~inside].all()


@settings(max_examples=20, deadline=None)
@given(page=tables | boards, aspect=st.floats(0.6, 4.0))
def test_every_camera_has_the_page_in_its_picture_and_sees_its_face(page, aspect):
    corners = corners_of(page, page.width, page.height)
    table = table_of(page)
    letter = page.to_world(np.zeros((1, 2)))
    for name, camera in fit_cameras(page, ROBOT, letter, table).items():
        nearer = (corners + letter) / 2 if name == "over the shoulder" else corners
        places, distance = picture_of(camera, nearer, aspect)
        assert np.abs(places).max() < 1
        assert distance.min() > 0.1
        assert (np.array(camera.eye) - page.X_world_page[:3, 3]) @ page.normal > 0, (
            "the page's face is seen"
        )
        assert camera.eye[2] > 0, "above the floor"
        assert camera.pen_only == (name == "page from above")


@settings(max_examples=10, deadline=None)
@given(page=tables | boards)
def test_the_whole_robot_is_seen_by_the_first_camera(page):
    table = table_of(page)
    camera = fit_cameras(page, ROBOT, page.to_world(np.zeros((1, 2))), table)["whole robot"]
    places, _ = picture_of(camera, np.vstack([ROBOT.corners.reshape(-1, 3), table]))
    assert np.abs(places).max() < 1


WRITTEN = {
    "a": (recording_of("a"), Page.table(), None),
    "D of two strokes": (recording_of("D"), Page.table(), None),
    "small e": (recording_of("e"), Page.table(), 0.02),
    "large M": (recording_of("M"), Page.table(), 0.15),
    "table on the left": (recording_of("a"), Page.table(0.6, 0.35, 0.75), None),
    "table on the right": (recording_of("b"), Page.table(0.6, -0.35, 0.75), None),
    "low table": (recording_of("m"), Page.table(z=0.6), None),
    "turned desk": (recording_of("g"), Page.table(yaw=0.35), None),
    "turned sheet": (recording_of("R"), Page.table(turn=0.4), None),
    "tilted desk": (recording_of("B"), Page.table(tilt=0.4), None),
    "board": (recording_of("a"), Page.board(), None),
    "board on the left": (recording_of("R"), Page.board(y=0.25), 0.08),
    "board that leans back": (recording_of("B"), Page.board(0.8, z=1.0, tilt=-0.5), 0.06),
    "word": (write_word("robot"), Page.table(), None),
    "long word": (write_word("handwriting"), Page.table(), None),
    "word on a board": (write_word("abc", x_height=0.03), Page.board(), None),
}


@pytest.mark.parametrize("name", WRITTEN)
def test_over_the_shoulder_the_arm_is_seen_and_the_letter_is_read_while_it_writes(name):
    written, page, size = WRITTEN[name]
    strokes = written if isinstance(written, tuple) else written.strokes()
    stage = Stage(Fetch().write(strokes, page, size=size))
    camera = stage.cameras["over the shoulder"]
    eye = np.array(camera.eye)
    letter = page.to_world(stage.ink.dots[:: len(stage.ink.dots) // 30 + 1])
    moments = [*np.linspace(stage.ink.t[0], stage.ink.t[-1], 6), stage.duration]
    read = [1 - covered(eye, triangles_of(stage, t), letter).mean() for t in moments]
    grid = points_in(camera)
    arm = [covered(eye, triangles_of(stage, t, True), grid).mean() for t in moments[1::2]]
    body = [covered(eye, triangles_of(stage, t, False), grid).mean() for t in moments[1::2]]
    assert read[-1] >= 0.9, "it is read in the end"
    assert np.mean(read) >= 0.7, "and while the robot writes"
    assert min(arm) > 0.08, "a robot is seen"
    assert max(arm) < 0.5
    assert max(body) < 0.25, "no wall before it"

    places, _ = picture_of(camera, letter)
    assert np.ptp(places[:, 1]) / 2 > 0.7 * np.ptp(stage.ink.dots[:, 1]), "large enough"
    right, below = SMALL_PAGE_CORNER
    assert not ((places[:, 0] > right) & (places[:, 1] < below)).any(), "not under the small page"
    line = letter.mean(axis=0) + np.array([[-0.001], [0.001]]) * page.X_world_page[:3, 1]
    (low, high), _ = picture_of(camera, line)
    assert high[1] - low[1] > abs(high[0] - low[0]) * FITTED_ASPECT * 0.5, "up is about up"


def triangles_of(stage, t, arm=None):
    """Corners of the robot's triangles (F, 3, 3), of the arm or the rest alone if wished."""
    pieces = [
        piece
        for piece in stage.robot(t)
        if arm is None or (piece.name.rpartition(" ")[0] in ARM_LINKS) is arm
    ]
    return np.vstack([piece.vertices[piece.faces] for piece in pieces])


def points_in(camera, distance=10.0):
    """Points far away, evenly over the picture."""
    eye, target, up = (np.array(v) for v in (camera.eye, camera.target, camera.up))
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, up) / np.linalg.norm(np.cross(ahead, up))
    high = camera.slope(FITTED_ASPECT)
    across, upwards = np.meshgrid(np.linspace(-1, 1, 12), np.linspace(-1, 1, 8))
    ways = np.outer(across * high * FITTED_ASPECT, right) + np.outer(
        upwards * high, np.cross(right, ahead)
    )
    return eye + distance * (ahead + ways)


def test_an_unknown_camera_is_answered_with_those_that_there_are():
    assert check_camera_name("Whole Robot") == "whole robot"
    with pytest.raises(
        SettingError, match="camera is 'behind', but must be one of: 'whole robot', 'over the shoul"
    ):
        check_camera_name("behind")
    assert len(CAMERA_NAMES) == 3
