"""Ink is where the pen was, in the order in which it was there."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from dmp_teach.trajectory import Trajectory
from dmp_teach.views.scene.ribbon import MAX_DOTS, build_ribbon, find_inked_strokes
from tests.views.moves import sway

WIDTH = 0.002
points = hnp.arrays(
    float, st.tuples(st.integers(2, 12), st.just(2)), elements=st.floats(-0.25, 0.25, width=32)
)


def stroke(position, start=0.0):
    return Trajectory(start + 0.1 * np.arange(len(position)), position)


def area(line):
    a, b, c = (line.vertices[line.faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)[:, 2] / 2


@settings(deadline=None)
@given(position=points)
def test_every_dot_lies_on_the_pens_path_and_no_piece_of_it_is_left_out(position):
    line = build_ribbon([stroke(position)], WIDTH, 0.001)
    expected = np.column_stack(
        [np.interp(line.t, 0.1 * np.arange(len(position)), c) for c in position.T]
    )
    # a corner between two dots is cut by less than their distance
    way = np.linalg.norm(np.diff(position, axis=0), axis=1).sum()
    spacing = max(0.0007, way / MAX_DOTS)
    assert np.abs(line.dots - expected).max() <= spacing
    assert np.linalg.norm(line.dots[[0, -1]] - position[[0, -1]], axis=1).max() <= 1e-6 + (way == 0)
    assert np.linalg.norm(np.diff(line.dots, axis=0), axis=1).max(initial=0) <= 1.001 * spacing


@settings(deadline=None)
@given(position=points)
def test_the_ink_stays_within_half_a_width_of_the_line_and_covers_all_of_it(position):
    line = build_ribbon([stroke(position)], WIDTH, 0.001)
    some = line.vertices[:: len(line.vertices) // 400 + 1]
    far = np.linalg.norm(some[:, None, :2] - line.dots, axis=2).min(axis=1)
    assert far.max() <= WIDTH / 2 + 1e-9
    assert (line.vertices[:, 2] == 0.001).all()
    middles = (line.dots[1:] + line.dots[:-1]) / 2
    centres = line.vertices[line.faces].mean(axis=1)[:, :2]
    for point in middles[:: len(middles) // 30 + 1]:
        assert np.linalg.norm(centres - point, axis=1).min() < WIDTH


@given(time=st.floats(-1, 5))
def test_the_ink_at_a_time_is_what_was_written_before_it(time):
    strokes = [
        stroke(np.array([[0, 0], [0.02, 0.01], [0.03, 0]])),
        stroke(np.array([[0.01, 0], [0.0, 0.02]]), start=1),
    ]
    line = build_ribbon(strokes, WIDTH, 0.001)
    written = line.t <= time + 1e-9
    drawn = line.faces[: line.triangles(time)]
    near = line.vertices[np.unique(drawn)][:, None, :2] - line.dots[written]
    assert np.linalg.norm(near, axis=2).min(axis=1, initial=1).max(initial=0) <= WIDTH / 2 + 1e-9
    assert (len(drawn) > 0) == written.any()
    assert (np.diff(line.t) >= 0).all()


def test_nothing_joins_two_strokes():
    line = build_ribbon(
        [stroke(np.array([[0, 0], [0.01, 0]])), stroke(np.array([[0.1, 0], [0.11, 0]]), 1)],
        WIDTH,
        0.001,
    )
    x = line.vertices[line.faces][..., 0]
    assert np.ptp(x, axis=1).max() < 0.004, "no triangle reaches from one stroke to the other"


def test_a_dot_of_an_i_is_one_dot():
    line = build_ribbon([stroke(np.zeros((3, 2)))], WIDTH, 0.001)
    assert len(line.dots) == 1
    assert area(line).sum() == pytest.approx(np.pi * (WIDTH / 2) ** 2, rel=0.11)


def test_no_stroke_is_no_ink():
    line = build_ribbon([], WIDTH, 0.001)
    assert (len(line.t), len(line.faces), line.triangles(9.0)) == (0, 0, 0)


def test_a_long_text_does_not_make_a_large_mesh():
    long = [stroke(np.array([[0, 0], [10.0, 0]]))]
    assert len(build_ribbon(long, WIDTH, 0.001).dots) <= 3002


def test_the_pen_writes_only_while_it_is_down():
    motion = sway()
    strokes = find_inked_strokes(motion)
    assert len(strokes) == 2
    assert sum(map(len, strokes)) == motion.pen_down.sum()
    for stroke_ in strokes:
        rows = np.searchsorted(motion.t, stroke_.t)
        assert motion.pen_down[rows].all()
        np.testing.assert_allclose(stroke_.position, motion.page.to_page(motion.tip)[rows, :2])
