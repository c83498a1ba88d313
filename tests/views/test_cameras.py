"""The letter can be read, whatever the page."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import SettingError
from dmp_teach.robot.page import Page
from dmp_teach.views.scene.cameras import (
    CAMERA_NAMES,
    FITTED_ASPECT,
    check_camera_name,
    fit_cameras,
)
from dmp_teach.views.scene.shapes import build_surroundings
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


ROBOT = np.stack([np.vstack([shape.vertices[::40] for shape in Stage().robot(0.0)])])


@settings(max_examples=20, deadline=None)
@given(page=tables | boards, aspect=st.floats(0.6, 2.0))
def test_every_camera_has_the_page_in_its_picture_and_sees_its_face(page, aspect):
    corners = corners_of(page, page.width, page.height)
    table = table_of(page)
    letter = page.to_world(np.zeros((1, 2)))
    for name, camera in fit_cameras(page, ROBOT, letter, table).items():
        nearer = (corners + 3 * letter) / 4 if name == "over the shoulder" else corners
        places, distance = picture_of(camera, nearer, aspect)
        assert np.abs(places).max() < 1
        assert distance.min() > 0.1
        assert (np.array(camera.eye) - page.X_world_page[:3, 3]) @ page.normal > 0, (
            "the page's face is seen"
        )
        assert camera.eye[2] > 0, "above the floor"


@settings(max_examples=10, deadline=None)
@given(page=tables | boards)
def test_the_whole_robot_is_seen_by_the_first_camera(page):
    table = table_of(page)
    camera = fit_cameras(page, ROBOT, page.to_world(np.zeros((1, 2))), table)["whole robot"]
    places, _ = picture_of(camera, np.vstack([ROBOT.reshape(-1, 3), table]))
    assert np.abs(places).max() < 1


@settings(max_examples=10, deadline=None)
@given(page=tables | boards)
def test_over_the_shoulder_the_page_fills_a_good_part_of_the_picture(page):
    corners = corners_of(page, page.width, page.height)
    table = table_of(page)
    camera = fit_cameras(page, ROBOT, page.to_world(np.zeros((1, 2))), table)["over the shoulder"]
    places, _ = picture_of(camera, corners)
    assert np.ptp(places, axis=0).max() > 1.5


@settings(max_examples=20, deadline=None)
@given(page=tables | boards, height=st.floats(0.02, 0.15), slim=st.floats(0.2, 1.5))
def test_over_the_shoulder_the_letter_is_large_upright_and_in_the_middle(page, height, slim):
    corners = corners_of(page, height * slim, height)
    table = table_of(page)
    camera = fit_cameras(page, ROBOT, corners, table)["over the shoulder"]
    middle = corners.mean(axis=0)
    line = middle + np.array([[-0.001], [0.001]]) * page.X_world_page[:3, 1]
    (up_from, up_to), _ = picture_of(camera, line)
    assert abs(up_to[0] - up_from[0]) * FITTED_ASPECT < 0.4 * (up_to[1] - up_from[1]), "up is up"
    places, _ = picture_of(camera, corners)
    assert np.abs(places.mean(axis=0)).max() < 0.25, "in the middle"
    assert np.ptp(places, axis=0).max() > 0.2 + 2 * height, "large, the more so the larger it is"


def test_the_camera_goes_round_an_arm_that_would_hide_the_letter():
    page = Page.table()
    letter = page.to_world(np.random.default_rng(0).uniform(-0.03, 0.03, (40, 2)))
    table = table_of(page)
    free = fit_cameras(page, np.zeros((1, 0, 3)), letter, table)["over the shoulder"]
    line = np.linspace(0.1, 0.6, 200)[:, None]
    thick = np.random.default_rng(1).uniform(-0.04, 0.04, (200, 3))
    arm = page.X_world_page[:3, 3] + line * (np.array(free.eye) - page.X_world_page[:3, 3]) + thick
    other = fit_cameras(page, arm[None], letter, table)["over the shoulder"]
    assert np.linalg.norm(np.array(other.eye) - free.eye) > 0.1


def test_an_arm_that_hides_the_letter_from_everywhere_is_drawn_faintly_and_one_beside_it_is_not():
    page = Page.table()
    letter = page.to_world(np.random.default_rng(0).uniform(-0.03, 0.03, (40, 2)))
    table = table_of(page)
    ways = np.random.default_rng(1).normal(size=(20_000, 3))
    ways[:, 2] = np.abs(ways[:, 2])
    roof = page.X_world_page[:3, 3] + 0.06 * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    aside = np.add(roof, (0.0, 0.5, 0.0))
    for moments, faint in (([aside, roof, aside], True), ([aside, aside], False)):
        seen = fit_cameras(page, np.stack(moments), letter, table)
        assert seen["over the shoulder"].see_through is faint
        assert seen["page from above"].see_through
        assert not seen["whole robot"].see_through


def test_an_unknown_camera_is_answered_with_those_that_there_are():
    assert check_camera_name("Whole Robot") == "whole robot"
    with pytest.raises(
        SettingError, match="camera is 'behind', but must be one of: 'whole robot', 'over the shoul"
    ):
        check_camera_name("behind")
    assert len(CAMERA_NAMES) == 3
