import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dmp_teach.errors import PageError
from dmp_teach.robot.page import A4, Page

PAGES = (Page.table(), Page.board(), Page.table(x=0.65, z=0.5, width=0.297, height=0.21), Page.board(y=0.1))
coordinates = st.floats(-1, 1).map(lambda value: round(value, 4))


@pytest.mark.parametrize("page", PAGES, ids=repr)
@given(x=coordinates, y=coordinates, z=coordinates)
def test_to_the_world_and_back_is_nothing(page, x, y, z):
    np.testing.assert_allclose(page.to_page(page.to_world((x, y, z))), (x, y, z), atol=1e-12)


@pytest.mark.parametrize("page", PAGES, ids=repr)
def test_the_normal_points_out_of_the_paper(page):
    np.testing.assert_allclose(page.to_world((0, 0, 0.1)) - page.to_world((0, 0)), 0.1 * page.normal, atol=1e-15)


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


def test_a_tilted_page_is_neither_table_nor_board_and_can_still_be_typed():
    X = np.eye(4)
    X[:3, :3] = np.array([[0, 0.6, 0.8], [-1, 0, 0], [0, -0.8, 0.6]])
    page = Page(X, 0.2, 0.2)
    assert page.kind is None
    np.testing.assert_allclose(eval(repr(page)).X_world_page, X)


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


@pytest.mark.parametrize(("width", "height"), [(0, 0.3), (0.2, -1), (np.nan, 0.3), (210, 297)])
def test_a_sheet_has_a_size_in_metres(width, height):
    with pytest.raises(PageError, match=r"must be between 0\.01 and 2 m"):
        Page.table(width=width, height=height)


def test_a_page_given_in_millimetres_is_told_so():
    with pytest.raises(PageError, match="is that in millimetres"):
        Page.table(x=700)
