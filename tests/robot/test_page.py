import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dmp_teach.errors import PageError
from dmp_teach.robot.page import A4, Page

PAGES = (
    Page.table(),
    Page.board(),
    Page.table(x=0.65, z=0.5, width=0.297, height=0.21),
    Page.board(y=0.1),
)
coordinates = st.floats(-1, 1).map(lambda value: round(value, 4))


@pytest.mark.parametrize("page", PAGES, ids=repr)
@given(x=coordinates, y=coordinates, z=coordinates)
def test_to_the_world_and_back_is_nothing(page, x, y, z):
    np.testing.assert_allclose(page.to_page(page.to_world((x, y, z))), (x, y, z), atol=1e-12)


@pytest.mark.parametrize("page", PAGES, ids=repr)
def test_the_normal_points_out_of_the_paper(page):
    np.testing.assert_allclose(
        page.to_world((0, 0, 0.1)) - page.to_world((0, 0)), 0.1 * page.normal, atol=1e-15
    )


def test_on_the_table_right_is_the_worlds_minus_y_and_up_is_plus_x():
    page = Page.table(x=0.7, z=0.72)
    np.testing.assert_allclose(page.to_world((0.1, 0.2)), (0.9, -0.1, 0.72))
    np.testing.assert_allclose(page.normal, (0, 0, 1))


def test_on_the_board_up_is_plus_z_and_the_normal_points_at_the_robot():
    page = Page.board(x=0.9, z=1.1)
    np.testing.assert_allclose(page.to_world((0.1, 0.2)), (0.9, -0.1, 1.3))
    np.testing.assert_allclose(page.normal, (-1, 0, 0))


def test_a_sheet_is_an_upright_a4_unless_told_otherwise():
    assert tuple(Page.table().size) == tuple(Page.board().size) == A4
    assert A4[0] < A4[1]


@given(x=coordinates, y=coordinates, z=coordinates, kind=st.sampled_from(["table", "board"]))
def test_what_a_page_says_of_itself_makes_it_again(x, y, z, kind):
    page = getattr(Page, kind)(x=x, y=y, z=z)
    again = eval(repr(page))
    np.testing.assert_allclose(again.X_world_page, page.X_world_page, atol=1e-4)
    assert page.kind == again.kind == kind


@given(rotation=st.integers(0, 10**6), x=coordinates, y=coordinates, z=coordinates)
def test_every_page_can_be_typed(rotation, x, y, z):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = (
        Rotation.random(rng=np.random.default_rng(rotation)).as_matrix(),
        (x, y, z),
    )
    page = Page(X, 0.148, 0.21)
    again = eval(repr(page))
    np.testing.assert_allclose(again.X_world_page, page.X_world_page, atol=2e-6)
    assert (again.width, again.height) == (0.148, 0.21)
    assert re.match(r"Page\.(table|board)\(", repr(page))


@pytest.mark.parametrize(
    "typed",
    [
        "Page.table(tilt=0.3)",
        "Page.table(tilt=-0.3)",
        "Page.table(turn=-0.5)",
        "Page.table(turn=3.14)",
        "Page.table(tilt=0.35, turn=0.2, yaw=-0.5)",
        "Page.board(tilt=-0.2, yaw=0.7)",
        "Page.board(turn=1.570796)",
        "Page.board(yaw=3.14)",
        "Page.board(tilt=1.570796)",
        "Page.table(x=0.6, width=0.297, height=0.21)",
    ],
)
def test_a_page_is_shown_as_it_was_typed(typed):
    assert repr(eval(typed)) == typed


@given(tilt=st.floats(-1.5, 1.5), turn=st.floats(-3, 3), yaw=st.floats(-3, 3))
def test_tilting_raises_the_top_turning_stays_in_the_paper_and_yaw_is_about_the_vertical(
    tilt, turn, yaw
):
    flat, tilted = Page.table(), Page.table(tilt=tilt)
    assert tilted.to_world((0, 0.1))[2] - 0.72 == pytest.approx(0.1 * np.sin(tilt))
    np.testing.assert_allclose(tilted.to_world((0.1, 0)), flat.to_world((0.1, 0)), atol=1e-12)
    turned = Page.table(tilt=tilt, turn=turn)
    np.testing.assert_allclose(turned.normal, tilted.normal, atol=1e-12)
    np.testing.assert_allclose(
        turned.to_world((0.1, 0)), tilted.to_world(0.1 * np.array([np.cos(turn), np.sin(turn)]))
    )
    about = Rotation.from_euler("Z", yaw).as_matrix()
    np.testing.assert_allclose(
        Page.table(tilt=tilt, turn=turn, yaw=yaw).X_world_page[:3, :3],
        about @ turned.X_world_page[:3, :3],
        atol=1e-12,
    )


def test_a_desk_raised_upright_is_a_board():
    np.testing.assert_allclose(
        Page.table(0.9, 0, 1.1, tilt=np.pi / 2).X_world_page, Page.board().X_world_page, atol=1e-12
    )
    assert Page.table(tilt=0.7).kind == Page.board(tilt=-0.9).kind == "table"
    assert Page.table(tilt=0.9).kind == Page.board(tilt=-0.7).kind == "board"


def test_a_moved_page_is_the_same_sheet_elsewhere():
    page = Page.board(width=0.3).moved((0, 0.1, -0.2))
    assert repr(page) == "Page.board(y=0.1, z=0.9, width=0.3, height=0.297)"


def test_the_pose_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        Page.table().X_world_page[0, 3] = 1.0


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        (np.eye(3), r"shape \(3, 3\), but must be 4 by 4"),
        ([1, 2, 3], "must be 4 by 4"),
        ("here", "must be 4 by 4 numbers"),
        (np.full((4, 4), np.nan), "finite"),
        (np.diag([1, 1, -1, 1]), "rigid pose"),
        (np.diag([2, 2, 2, 1]), "rigid pose"),
    ],
)
def test_a_pose_that_is_none_is_refused(pose, message):
    with pytest.raises(PageError, match=message):
        Page(pose)


@pytest.mark.parametrize(("width", "height"), [(0, 0.3), (0.2, -1), (0.2, 3)])
def test_a_sheet_is_between_a_stamp_and_a_wall(width, height):
    with pytest.raises(PageError, match=r"must be between 0\.01 and 2 m\.$"):
        Page.table(width=width, height=height)


@pytest.mark.parametrize("width", [np.nan, np.inf, "wide", None, (0.1, 0.2)])
def test_a_width_is_one_number(width):
    with pytest.raises(PageError, match=r"width is .*, but must be a length in metres"):
        Page.board(width=width)


@pytest.mark.parametrize("options", [{"width": 210}, {"height": 297.0}])
def test_a_sheet_given_in_millimetres_is_told_so(options):
    with pytest.raises(PageError, match=r"must be between 0\.01 and 2 m. Is that in millimetres"):
        Page.table(**options)


@pytest.mark.parametrize("options", [{"x": 700}, {"z": -720}])
def test_a_page_given_in_millimetres_is_told_so(options):
    with pytest.raises(PageError, match="is that in millimetres"):
        Page.table(**options)


@pytest.mark.parametrize("name", ["x", "y", "z"])
@pytest.mark.parametrize("value", ["far", None, np.nan, (0.1, 0.2)])
def test_a_place_is_a_number(name, value):
    with pytest.raises(
        PageError, match=f"{name} is .*, but must be a place in metres, such as 0.7"
    ):
        Page.board(**{name: value})


@pytest.mark.parametrize("name", ["tilt", "turn", "yaw"])
def test_an_angle_is_a_number_in_radians(name):
    with pytest.raises(
        PageError, match=f"{name} is 'steep', but must be an angle in radians, such as 0.35"
    ):
        Page.table(**{name: "steep"})
    with pytest.raises(
        PageError, match=rf"{name} is 30 rad, more than .* If that is in degrees, write 0\.5236"
    ):
        Page.board(**{name: 30})
