import inspect
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.errors import PageError
from dmp_teach.robot.page import Page
from dmp_teach.robot.reach.known import USUAL_PAGES, known_reach
from dmp_teach.robot.reach.map import reach_around, reach_map

FAR, LEAN = (0.3, 0.7, 0.9, 1.3), np.radians((0, 45, 90))


@pytest.fixture(scope="module")
def steps():
    return []


@pytest.fixture(scope="module")
def by_tilt(steps):
    return reach_map(FAR, LEAN, progress=lambda done, total: steps.append((done, total)))


@pytest.fixture(scope="module")
def around():
    return reach_around(x=(0.5, 0.7), y=(-1.0, 0.0, 1.0))


def test_the_usual_pages_are_reached_with_ease_and_those_at_a_metre_and_a_third_are_not(by_tilt):
    table, desk, board = by_tilt.reached
    assert not by_tilt.reached[:, FAR.index(1.3)].any()
    assert table[FAR.index(0.7)]
    assert desk[FAR.index(0.9)]
    assert board[FAR.index(0.9)]
    assert by_tilt.at_ease[:, FAR.index(0.7)].all()


def test_a_table_is_out_of_reach_where_a_board_is_not(by_tilt):
    assert list(by_tilt.reached[:, FAR.index(0.9)]) == [False, True, True]


def test_what_is_missing_grows_with_the_distance_and_is_nothing_where_only_the_arm_is_in_its_way(
    by_tilt,
):
    assert (by_tilt.residual[:, FAR.index(1.3)] > 0.1).all()
    assert by_tilt.residual[by_tilt.reached].max() < 0.0003
    near_the_board = 2, FAR.index(0.3)
    assert not by_tilt.reached[near_the_board]
    assert by_tilt.residual[near_the_board] < 0.0003


def test_effort_is_a_number_exactly_where_the_page_is_reached(by_tilt):
    np.testing.assert_array_equal(np.isfinite(by_tilt.effort), by_tilt.reached)
    assert (by_tilt.effort > 0).all()


def test_every_page_of_the_map_can_be_typed_and_written_on(by_tilt):
    page = by_tilt.pages[1][1]
    assert repr(page) == "Page.board(x=0.7, z=0.91, tilt=-0.785398)"
    strokes = teach.Letter.learn(teach.recording_of("a")).write()
    assert teach.Fetch().write(strokes, page).page is page


def test_from_above_the_page_lies_ahead_and_not_a_metre_aside(around):
    assert around.across_name == "y"
    assert list(around.reached[1]) == [True, True]
    assert not around.reached[[0, 2]].any()
    assert around.pages[2][0].X_world_page[:3, 3] == pytest.approx((0.5, 1.0, 0.72))


def test_progress_is_told_after_every_page_and_may_stop(by_tilt, steps):
    assert steps == [(done, 12) for done in range(13)]

    def stop(done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        reach_map((0.7,), (0.0,), progress=stop)


def test_it_is_the_same_on_an_executor(around):
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        again = reach_around(x=(0.5, 0.7), y=(-1.0, 0.0, 1.0), executor=executor)
    np.testing.assert_array_equal(again.effort, around.effort)
    np.testing.assert_array_equal(again.residual, around.residual)


def test_it_says_how_many_of_how_many(around):
    assert repr(around) == "ReachMap(3 y by 2 x, 2 of 6 reached)"


def test_a_map_cannot_be_changed(around):
    with pytest.raises(ValueError, match="read-only"):
        around.effort[0, 0] = 1.0


@pytest.mark.parametrize("x", [0.7, "far", (), (0.7, 0.5), (0.7, np.nan), ((0.5, 0.7),)])
def test_an_axis_is_rising_numbers(x):
    with pytest.raises(
        PageError, match=r"x is .*, but must be rising numbers, such as \[0\.5, 0\.7, 0\.9\]"
    ):
        reach_map(x)


@pytest.mark.parametrize("ask", [reach_map, reach_around])
def test_help_says_the_usual_grid_in_words(ask):
    assert "array" not in str(inspect.signature(ask))
    assert "unless given" in ask.__doc__


def test_around_what_is_no_page_there_is_no_map():
    with pytest.raises(
        PageError, match=r"page is 'table', but must be a Page, such as Page\.table\(\)"
    ):
        reach_around("table")
    assert reach_around(Page.board(), (0.9,), (0.0,)).reached.all()


@pytest.mark.parametrize("name", ["table", "desk", "board"])
def test_a_known_map_is_what_the_solver_finds(name):
    known = known_reach(name)
    rows, columns = np.random.default_rng(8).integers(known.reached.shape, size=(3, 2)).T
    for row, column in zip(rows, columns, strict=True):
        x, y = known.x[column : column + 1], known.across[row : row + 1]
        found = reach_around(USUAL_PAGES[name], x, y)
        assert repr(found.pages[0][0]) == repr(known.pages[row][column])
        assert found.effort == pytest.approx(known.effort[row, column], abs=0.006)
        assert found.residual == pytest.approx(known.residual[row, column], abs=6e-6)


def test_a_map_that_is_not_known_is_refused_by_name():
    with pytest.raises(PageError, match="'table', 'desk', 'board'"):
        known_reach("ceiling")
    with pytest.raises(PageError, match="no known map of"):
        known_reach([])
