import numpy as np
import pytest
from hypothesis import assume
from hypothesis import strategies as st

from dmp_teach.errors import PageError, TrajectoryError
from dmp_teach.robot.layout import PAGE_MARGIN, lay_out
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Trajectory
from tests.robot import ink
from tests.robot.ink import law

PAGE = Page.table()


def box(strokes):
    points = np.concatenate([stroke.position for stroke in strokes])
    return points.min(axis=0), points.max(axis=0)


def line(*points, seconds=1.0):
    return Trajectory(np.linspace(0, seconds, len(points)), np.array(points, dtype=float))


@law(
    letter=ink.letters(),
    x=st.floats(-0.01, 0.01),
    y=st.floats(-0.01, 0.01),
    size=st.floats(0.01, 0.1),
)
def test_the_middle_of_the_ink_is_where_it_was_asked_for_and_its_height_too(letter, x, y, size):
    low, high = box(lay_out(letter, PAGE, at=(x, y), size=size))
    np.testing.assert_allclose((low + high) / 2, (x, y), atol=1e-12)
    assert high[1] - low[1] == pytest.approx(size)


@law(letter=ink.letters(), right=st.floats(-5, 5), up=st.floats(-5, 5))
def test_where_the_ink_was_recorded_does_not_matter(letter, right, up):
    shifted = tuple(Trajectory(s.t, s.position + np.array([right, up])) for s in letter)
    for one, other in zip(lay_out(letter, PAGE), lay_out(shifted, PAGE), strict=True):
        np.testing.assert_allclose(one.position, other.position, atol=1e-12)


@law(letter=ink.letters())
def test_as_written_nothing_changes_but_the_place(letter):
    placed = lay_out(letter, PAGE)
    shift = placed[0].position[0] - letter[0].position[0]
    for before, after in zip(letter, placed, strict=True):
        np.testing.assert_array_equal(before.t, after.t)
        np.testing.assert_allclose(
            after.position - before.position, np.broadcast_to(shift, after.position.shape)
        )


def test_one_trajectory_is_one_stroke():
    assert len(lay_out(ink.LETTER[0], PAGE)) == 1


@law(letter=ink.letters(), size=st.floats(0.3, 2))
def test_too_large_says_both_sizes_and_what_is_said_to_fit_fits(letter, size):
    with pytest.raises(
        PageError, match=r"would be \d+ x \d+ mm, but the page is 210 x 297 mm"
    ) as caught:
        lay_out(letter, PAGE, size=size)
    largest = float(str(caught.value).rpartition("size=")[2].rstrip("."))
    low, high = box(lay_out(letter, PAGE, size=largest))
    assert (high - low <= PAGE.size - 2 * PAGE_MARGIN + 1e-9).all()
    with pytest.raises(PageError):
        lay_out(letter, PAGE, size=largest + 0.0011)


def test_as_written_and_too_large_says_which_size_to_give():
    with pytest.raises(
        PageError,
        match=r"room for 200 x 287 mm inside its margin. The largest that fits is size=0.287",
    ):
        lay_out(line((0, 0), (0.1, 0.4), seconds=3), PAGE)


def test_a_level_line_too_wide_says_how_wide_it_may_be():
    with pytest.raises(PageError, match="The largest that fits is a stroke 200 mm wide"):
        lay_out(line((0, 0), (0.3, 0), seconds=3), PAGE)


@law(letter=ink.letters())
def test_over_the_edge_says_where_the_middle_may_be_and_there_it_may_be(letter):
    with pytest.raises(
        PageError, match=r"With at=\(0.2, 0\) the ink of \d+ x \d+ mm would run over"
    ) as caught:
        lay_out(letter, PAGE, at=(0.2, 0))
    x = float(str(caught.value).partition("x must be between -")[2].partition(" ")[0])
    y = float(str(caught.value).partition("y between -")[2].partition(" ")[0])
    for spot in ((x, y), (-x, -y)):
        lay_out(letter, PAGE, at=spot)


@pytest.mark.parametrize("at", [0.1, (1, 2, 3), "middle", (np.nan, 0), [[0, 0]], ("a", "b")])
def test_a_spot_is_two_numbers(at):
    with pytest.raises(PageError, match="must be two numbers: right and up from the page's centre"):
        lay_out(ink.LETTER, PAGE, at=at)


@pytest.mark.parametrize("size", [0, -0.1])
def test_a_size_is_more_than_nothing(size):
    with pytest.raises(PageError, match="must be more than 0"):
        lay_out(ink.LETTER, PAGE, size=size)


@pytest.mark.parametrize("size", ["big", np.nan, np.inf, (1, 2)])
def test_a_size_is_one_number(size):
    with pytest.raises(PageError, match="must be a height in metres"):
        lay_out(ink.LETTER, PAGE, size=size)


def test_a_dot_can_be_placed_but_not_enlarged():
    dot = line((0.02, 0.02), (0.02, 0.02))
    np.testing.assert_allclose(lay_out(dot, PAGE)[0].position, 0)
    with pytest.raises(PageError, match="has no height"):
        lay_out(dot, PAGE, size=0.1)


def test_millimetres_are_recognised():
    large = tuple(Trajectory(s.t, 1000 * s.position) for s in ink.LETTER)
    with pytest.raises(PageError, match=r"if yours are in millimetres, divide them by 1000"):
        lay_out(large, PAGE, size=0.1)


@pytest.mark.parametrize("strokes", [(), []])
def test_no_strokes_are_refused(strokes):
    with pytest.raises(TrajectoryError, match="no strokes to write"):
        lay_out(strokes, PAGE)


@pytest.mark.parametrize(("strokes", "kind"), [(3, "an int"), (None, "None")])
def test_what_cannot_be_strokes_is_refused(strokes, kind):
    with pytest.raises(
        TrajectoryError, match=f"strokes is {kind}, but must be a tuple of Trajectory"
    ):
        lay_out(strokes, PAGE)


@pytest.mark.parametrize("page", [None, 5, "table", Page.table])
def test_what_is_no_page_is_refused(page):
    with pytest.raises(PageError, match=r"page is .* must be a Page, such as Page\.table\(\)"):
        lay_out(ink.LETTER, page)


def test_a_recording_is_answered_with_its_strokes():
    with pytest.raises(TrajectoryError, match=r"strokes is an object.*recording\.strokes\(\)"):
        lay_out(object(), PAGE)


def test_what_is_no_stroke_is_named_by_its_number():
    with pytest.raises(TrajectoryError, match="Stroke 1 is an ndarray, but must be a Trajectory"):
        lay_out((ink.LETTER[0], np.zeros((5, 2))), PAGE)


def test_three_dimensions_are_refused_with_the_cure():
    deep = Trajectory([0, 1], [[0, 0, 0], [0.1, 0, 0]])
    with pytest.raises(
        TrajectoryError, match=r"3 dimensions, but ink has 2: Trajectory\(stroke.t, stroke.position"
    ):
        lay_out(deep, PAGE)


@law(letter=ink.letters(), share=st.floats(0.05, 0.95), way=st.floats(0, 6.28))
def test_a_jump_inside_a_stroke_is_named(letter, share, way):
    stroke = letter[-1]
    row = max(2, int(share * len(stroke)) - 1)
    dt = stroke.t[1] - stroke.t[0]
    speed = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1).max()
    jump = 2 * speed + 1.1 * max(0.005, 50 * dt**2)
    position = stroke.position.copy()
    position[row:] += jump * np.array([np.cos(way), np.sin(way)])
    with pytest.raises(
        TrajectoryError,
        match=rf"Stroke {len(letter) - 1} jumps by .* mm in .* ms at sample {row} \(t =",
    ):
        lay_out((*letter[:-1], Trajectory(stroke.t, position)), PAGE)


@law(letter=ink.letters())
def test_fast_writing_is_no_jump(letter):
    # In so little time no hand makes a step 3 mm longer than the next.
    steps = [np.linalg.norm(np.diff(s.position, axis=0), axis=1) for s in letter]
    assume(all(np.abs(np.diff(each)).max(initial=0) < 0.003 for each in steps))
    faster = tuple(Trajectory(s.t / 3, s.position) for s in letter)
    assert len(lay_out(faster, PAGE)) == len(letter)


def test_few_far_points_with_time_between_them_are_no_jump():
    assert lay_out(line((0, 0), (0.001, 0), (0.1, 0), (0.1, 0.1), seconds=4), PAGE)
