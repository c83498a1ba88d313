"""Movements joined: one pen, no stop, no jump."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.chaining import chain
from dmp_teach.dmp.primitive import DMP
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import TrajectoryError
from dmp_teach.trajectory import Trajectory
from tests.dmp.ink import in_all_its_steps, letter, letters, rms

few = settings(max_examples=15, deadline=None)
PRESETS = [Settings.star, Settings.joint, Settings.plus]
presets = st.sampled_from(PRESETS)


def speeds(drawn):
    return np.diff(drawn.position, axis=0) / np.diff(drawn.t)[:, None]


def beside(demo, way):
    return Trajectory(demo.t, demo.position + np.array(way))


@few
@given(letters(), presets, st.floats(-0.1, 0.1))
def test_a_movement_joined_with_nothing_is_its_rollout(demo, preset, shift):
    p = DMP.imitate(demo, preset())
    alone = chain([p], goals={0: p.goal + shift})
    drawn = in_all_its_steps(p, p.goal + shift)
    assert np.abs(alone.position - drawn).max() <= 1e-12 * max(1, np.abs(drawn).max())
    assert alone.t[0] == demo.t[0]
    assert alone.duration == pytest.approx(demo.duration)


@few
@given(presets, st.integers(0, 99), st.floats(0.05, 0.3), st.integers(80, 200))
def test_two_halves_of_a_letter_join_to_the_letter(preset, seed, overlap, cut):
    whole = letter(301, 2.5, seed=seed)
    more = round(overlap * 120)
    halves = [slice(0, cut + more + 1), slice(cut, None)]
    parts = [
        DMP.imitate(Trajectory(whole.t[each], whole.position[each]), preset()) for each in halves
    ]
    drawn = chain(parts, overlap=more / 120)
    at = np.column_stack(
        [np.interp(whole.t, drawn.t, drawn.position[:, axis]) for axis in range(2)]
    )
    assert drawn.duration == pytest.approx(2.5)
    alone = max(
        rms(p.rollout().position, whole.position[each])
        for p, each in zip(parts, halves, strict=True)
    )
    assert rms(at, whole.position) < 0.3 + 1.5 * alone


@few
@given(presets, st.integers(0, 99), st.sampled_from([0.0, 0.05, 0.2, -0.3]))
def test_nothing_jumps_at_a_joint(preset, seed, overlap):
    """Halving all steps halves the change of the velocity from one to the next."""
    pieces = [letter(150, 1.2, seed=seed), letter(200, 1.5, seed=seed + 1)]
    pieces[1] = beside(pieces[1], pieces[0].position[-1] - pieces[1].position[0] + 0.005)
    change = []
    for finer in (1, 4):
        fine = [
            Trajectory(
                np.linspace(0, each.duration, finer * (len(each) - 1) + 1),
                np.column_stack(
                    [
                        np.interp(
                            np.linspace(0, each.duration, finer * (len(each) - 1) + 1),
                            each.t,
                            column,
                        )
                        for column in each.position.T
                    ]
                ),
            )
            for each in pieces
        ]
        drawn = chain(
            [DMP.imitate(each, preset(alpha=40.0, n_kernels=12)) for each in fine], overlap
        )
        change.append(np.abs(np.diff(speeds(drawn), axis=0)).max())
    assert change[1] < 0.5 * change[0]


@pytest.mark.parametrize("overlap", [0.3, 0.6])
def test_at_a_joint_the_pen_passes_from_one_path_to_the_other_by_their_shares(overlap):
    """Two springs alike: what the moving goal needs is given, so that the pen does not trail."""
    settings = Settings.star(alpha=30.0, n_kernels=20, integrator="exact", smoothing=None)
    t = np.linspace(0, 1.5, 1201)
    lines = [
        Trajectory(t, np.outer(t, way)) for way in ((0.2, 0.1), (-0.1, 0.2))
    ]  # at full speed at both ends
    one, two = (DMP.imitate(each, settings) for each in lines)
    drawn = chain([one, two], overlap)
    t = np.linspace(1.5 - overlap, 1.5, 200)
    at = np.column_stack([np.interp(t, drawn.t, column) for column in drawn.position.T])
    p = ((t - t[0]) / overlap)[:, None]
    share = p**3 * (10 - 15 * p + 6 * p**2)
    y, y_2 = (
        np.column_stack(
            [np.interp(t - begin, each.times, column) for column in each.rollout().position.T]
        )
        for each, begin in ((one, 0.0), (two, 1.5 - overlap))
    )
    assert np.abs(at - y - share * (y_2 - y)).max() < 0.002 * np.abs(y_2 - y).max()


@pytest.mark.parametrize("preset", PRESETS)
def test_the_pen_does_not_stop_between_two_strokes_that_overlap(preset):
    one, two = letter(200, 1.6, seed=1), letter(200, 1.6, seed=5)
    two = beside(two, one.position[-1] - two.position[0])
    parts = [DMP.imitate(one, preset()), DMP.imitate(two, preset())]
    slowest = []
    for overlap in (0.0, 0.4):
        drawn = chain(parts, overlap)
        middle = (drawn.t[1:] > 1.0) & (drawn.t[1:] < 2.0)
        slowest.append(np.linalg.norm(speeds(drawn), axis=1)[middle].min())
    assert slowest[0] < 0.01
    assert slowest[1] > 3 * slowest[0]
    assert slowest[1] > 0.02


@pytest.mark.parametrize("preset", [*PRESETS, Settings.as_fixed])
@pytest.mark.parametrize("phase", ["linear", "sigmoid"])
def test_letters_side_by_side_are_joined_on_the_way_and_keep_their_shapes(preset, phase):
    """A negative overlap is a time for the way, in which the goal moves to the next start."""
    one, two = letter(200, 1.6, seed=1), beside(letter(240, 2.0, seed=2), (0.3, 0.0))
    parts = [DMP.imitate(each, preset(phase=phase)) for each in (one, two)]
    drawn = chain(parts, overlap=-0.5)
    assert drawn.duration == pytest.approx(1.6 + 0.5 + 2.0)
    for p, begin in ((parts[0], 0.0), (parts[1], 2.1)):
        alone = p.rollout()
        at = np.column_stack(
            [np.interp(p.times + begin, drawn.t, column) for column in drawn.position.T]
        )
        assert rms(at, alone.position) < 3.0
    way = (drawn.t > 1.6) & (drawn.t < 2.1)
    ends = np.array([parts[0].goal, parts[1].start])
    assert np.all(drawn.position[way] > ends.min(axis=0) - 0.01)
    assert np.all(drawn.position[way] < ends.max(axis=0) + 0.01)


def test_starts_and_goals_may_move():
    p = DMP.imitate(letter(200, 1.6))
    drawn = chain([p, p], 0.1, starts={1: p.start + 0.1}, goals={0: p.goal + 0.1, 1: p.goal + 0.05})
    assert drawn.position[0] == pytest.approx(p.start)
    assert drawn.position[-1] == pytest.approx(p.goal + 0.05, abs=1e-3)


@pytest.mark.parametrize(
    ("ask", "answer"),
    [
        (lambda p: chain([]), "Primitives are joined .DMP.imitate makes them., but got nothing"),
        (
            lambda p: chain([p, 3]),
            "Primitives are joined .DMP.imitate makes them., but got an int",
        ),
        (
            lambda p: chain([p, DMP.imitate(letter(dimensions=3))]),
            "Movements of 2 and 3 dimensions cannot be joined: give all of them the same",
        ),
        (
            lambda p: chain([p, p], overlap=1.3),
            "overlap is 1.3, but it must be between -5 s and 1.25 s, half of the sh",
        ),
        (lambda p: chain([p, p], overlap="long"), "overlap is 'long', but it must be between"),
        (
            lambda p: chain([p, p], goals={2: (0, 0)}),
            "There is no movement 2 .* counted from 0 to 1",
        ),
        (
            lambda p: chain([p, p], starts={1: (0, 0, 0)}),
            r"start has shape \(3,\), but this movement has 2 dimensions",
        ),
    ],
)
def test_what_cannot_be_joined_is_said_in_a_sentence(ask, answer):
    with pytest.raises(TrajectoryError, match=answer):
        ask(DMP.imitate(letter()))


@few
@given(presets, st.floats(-0.3, 0.2), st.floats(-0.3, 0.2))
def test_each_joint_may_have_its_own_overlap(preset, first, second):
    parts = [DMP.imitate(letter(121, 1.0, seed=n), preset()) for n in range(3)]
    drawn = chain(parts, overlap=[first, second])
    assert drawn.duration == pytest.approx(3.0 - first - second)
    begun = drawn.t <= drawn.t[0] + 2.0 - first - max(second, 0)
    before = chain(parts[:2], overlap=first)
    assert np.abs(drawn.position[begun] - before.position[: begun.sum()]).max() < 1e-9


def test_an_overlap_for_every_joint_is_needed():
    parts = [DMP.imitate(letter(121, 1.0, seed=n)) for n in range(3)]
    with pytest.raises(TrajectoryError, match="one for each joint"):
        chain(parts, overlap=[0.1])
