import gc
import itertools
import re
import threading

import numpy as np
import pytest
from hypothesis import strategies as st

import dmp_teach as teach
from dmp_teach.errors import ReachError
from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.page import Page
from dmp_teach.robot.pen_path import MOTION_RATE
from dmp_teach.robot.slices import run_through
from dmp_teach.robot.smoothing import connect_smoothly
from dmp_teach.robot.solvers import build_solver, get_solver
from dmp_teach.trajectory import Trajectory
from tests.recordings import RECORDINGS, needs_recordings
from tests.robot import ink
from tests.robot.ink import LETTER, law
from tests.robot.sound import LIMITS, assert_sound

SHEETS = (
    Page.table(),
    Page.board(),
    Page.table(width=0.297, height=0.21),
    Page.board(width=0.297, height=0.21),
)


@pytest.mark.usefixtures("each_solver")
@law(examples=12, letter=ink.letters(), page=st.sampled_from(SHEETS))
def test_the_tip_follows_the_letter_and_no_limit_is_broken(letter, page):
    assert_sound(Fetch().write(letter, page))


@pytest.mark.usefixtures("each_solver")
# Samples so dense that fast and large ink has no jump between two.
@law(examples=8, letter=ink.letters((240,)), faster=st.floats(2, 8), page=st.sampled_from(SHEETS))
def test_too_fast_is_slowed_and_said(letter, faster, page):
    hasty = tuple(Trajectory(s.t / faster, s.position) for s in letter)
    motion = Fetch().write(hasty, page, size=ink.fitting(hasty, page))
    assert_sound(motion)
    hurried = motion.duration > connect_smoothly(motion.strokes).plan().t[-1]
    assert hurried == any(note.startswith("slowed from ") for note in motion.notes)
    if hurried:
        assert f"to {motion.duration:.2f} s: " in motion.notes[0]
        assert motion.notes[0].rpartition(": ")[2].split(", ")[0] in JOINTS


def test_a_hasty_large_letter_is_slowed():
    hasty = tuple(Trajectory(s.t / 6, s.position) for s in LETTER)
    motion = Fetch().write(hasty, Page.table(), size=0.2)
    words = re.match(r"slowed from (\d\.\d\d) s to (\d\.\d\d) s: (\w+)", motion.notes[0])
    assert float(words[1]) < float(words[2]) == pytest.approx(motion.duration, abs=0.006)
    assert words[3] in JOINTS


@pytest.mark.parametrize("page", SHEETS, ids=repr)
@pytest.mark.parametrize("corner", list(itertools.product((-1, 1), (-1, 1))))
def test_every_corner_of_a_default_page_can_be_written_on(page, corner):
    at = np.multiply(corner, page.size / 2 - 0.005 - 0.015)
    motion = Fetch().write(
        (Trajectory([0, 0.5, 1], [[0, 0], [0.03, 0.03], [0, 0.03]]),), page, at=at
    )
    assert_sound(motion)
    assert not [note for note in motion.notes if "reach" in note]


@pytest.mark.parametrize("page", SHEETS, ids=repr)
def test_a_letter_of_200_mm_uses_less_than_its_joints_can_do(page):
    slow = tuple(Trajectory(2 * s.t, s.position) for s in LETTER)
    motion = Fetch().write(slow, page, size=min(0.2, page.height - 0.01))
    assert_sound(motion)
    assert motion.notes == ()


def test_the_pen_is_on_the_paper_exactly_while_it_is_down():
    motion = Fetch().write(LETTER, Page.board())
    height = motion.page.to_page(motion.target)[:, 2]
    np.testing.assert_allclose(height[motion.pen_down], 0, atol=1e-12)
    assert height[~motion.pen_down].min() > 0
    start = motion.page.to_page(motion.target[np.argmax(motion.pen_down)])[:2]
    np.testing.assert_allclose(start, motion.strokes[0].position[0], atol=1e-12)


def test_the_arm_starts_and_ends_at_rest():
    motion = Fetch().write(LETTER, Page.table())
    speed = np.abs(np.diff(motion.q, axis=0)) * MOTION_RATE / [joint.velocity for joint in LIMITS]
    assert speed[[0, -1]].max() < 0.02


@pytest.mark.usefixtures("each_solver")
def test_the_torso_stays():
    motion = Fetch().write(LETTER, Page.table())
    assert np.ptp(motion.q[:, JOINTS.index("torso_lift_joint")]) == 0


def test_the_same_input_gives_the_same_motion_whatever_was_written_before():
    fetch = Fetch()
    first = fetch.write(LETTER, Page.table(), size=0.12)
    with pytest.raises(ReachError):
        fetch.write(LETTER, Page.table(x=2.0))
    fetch.write(LETTER, Page.board(), size=0.18)
    get_solver().verdicts.clear()
    again = Fetch().write(LETTER, Page.table(), size=0.12)
    np.testing.assert_array_equal(first.q, again.q)
    np.testing.assert_array_equal(first.tip, again.tip)


def test_progress_is_told_in_three_steps_and_often():
    told = []
    motion = Fetch().write(
        LETTER, Page.table(), progress=lambda step, part: told.append((step, part))
    )
    assert list(dict.fromkeys(step for step, _ in told)) == ["reach", "plan", "joints"]
    assert all(0 <= part <= 1 for _, part in told)
    assert len(told) > 4 * motion.duration


@pytest.mark.parametrize("when", range(0, 16, 5))
def test_progress_may_stop_the_planning_and_the_next_letter_is_the_same(when):
    class StoppedError(Exception):
        pass

    count = itertools.count()

    def stop(step, part):
        if next(count) == when:
            raise StoppedError

    expected = Fetch().write(LETTER, Page.table())
    with pytest.raises(StoppedError):
        Fetch().write(LETTER, Page.board(), progress=stop)
    np.testing.assert_array_equal(Fetch().write(LETTER, Page.table()).q, expected.q)


def test_a_robot_that_is_let_go_of_takes_nothing_with_it():
    fetch = Fetch()
    del fetch
    gc.collect()
    assert_sound(Fetch().write(LETTER, Page.table()))


def test_two_threads_write_at_once_and_do_not_mix():
    alone = {page: Fetch().write(LETTER, page).q for page in SHEETS[:2]}
    found = {}
    threads = [
        threading.Thread(
            target=lambda page=page: found.__setitem__(page, Fetch().write(LETTER, page).q)
        )
        for page in SHEETS[:2]
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for page, q in alone.items():
        np.testing.assert_array_equal(found[page], q)


def test_a_solver_is_built_once_in_a_thread():
    assert Fetch() is not Fetch()
    assert get_solver() is get_solver()


def test_nothing_is_printed(capfd):
    solver = build_solver()  # not this thread's own, which has been built
    solver.stand(np.zeros(8), np.array([0.0, 0, 1]), torso=True)
    solver.approach(np.array([3.0, 0, 0]))
    solver.proximity.touching(solver.joints()[None])
    Fetch().write(LETTER, Page.table())
    del solver
    gc.collect()
    assert capfd.readouterr() == ("", "")


@pytest.mark.usefixtures("each_solver")
@pytest.mark.parametrize("sign", [1, -1])
def test_a_pen_that_already_stands_upright_or_upside_down_is_no_trouble(sign):
    solver = get_solver()
    posture = (0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82)
    solver.stand(posture, np.array([0.0, 0, 1]), torso=True)
    X = solver.pen()
    solver.stand(posture, sign * X[:3, 2], torso=True)
    solver.go(X[:3, 3], 50)
    assert np.isfinite(solver.joints()).all()
    assert np.isfinite(solver.pen()).all()


@pytest.mark.usefixtures("each_solver")
def test_the_posture_comes_to_rest():
    solver = get_solver()
    target = np.array([0.7, 0, 0.72])
    solver.stand(
        (0.386, -0.11, -0.45, -0.37, 1.53, -1.39, -0.88, 0.82), np.array([0.0, 0, 1]), torso=True
    )
    solver.approach(target)
    solver.settle(target)
    before = solver.pen()[:3, 3].copy(), solver.joints()
    solver.go(target, 200)
    assert np.linalg.norm(solver.pen()[:3, 3] - before[0]) < 2e-6
    assert np.abs(solver.joints() - before[1]).max() < 5e-3


@pytest.mark.usefixtures("each_solver")
def test_joints_that_turn_for_ever_do_not_jump_at_half_a_turn():
    solver, roll = get_solver(), JOINTS.index("forearm_roll_joint")
    start = (0.386, -0.11, -0.45, -0.37, 1.53, -3.1, 0.9, 0.8)
    solver.stand(start, np.array([0.0, 0, 1]), torso=False)
    X = solver.pen().copy()
    path = X[:3, 3] + np.linspace(0, 1, 240)[:, None] * [0, -0.1, 0]
    q = run_through(solver.follow(start, -X[:3, 2], path))
    assert q[:, roll].min() < -np.pi < q[:, roll].max()
    assert np.abs(np.diff(q, axis=0)).max() < 0.05


@needs_recordings
@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_every_recorded_letter_is_written(path):
    strokes = teach.read_recording(path).strokes()
    as_written = np.ptp(np.concatenate([stroke.position for stroke in strokes])[:, 1])
    for page in SHEETS[:2]:
        assert_sound(Fetch().write(strokes, page, size=ink.fitting(strokes, page, as_written)))
