"""What a user can do wrong, and what they read: a test for every row of the design's table.

Row, column and value of a file that cannot be read: see the tests of the reader.
"""

import re
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import dmp_teach as teach
from dmp_teach.errors import (
    JointError,
    MissingPartError,
    PageError,
    ReachError,
    ReachWarning,
    TrajectoryError,
)
from dmp_teach.robot.arm import JOINTS
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.model.kinematics import Model
from dmp_teach.robot.model.reduced import reduced_robot
from dmp_teach.robot.page import Page
from dmp_teach.robot.simulation.simulate import simulate
from dmp_teach.trajectory import Trajectory
from tests.robot.ink import LETTER

pytest.importorskip("placo", reason="PlaCo is not on this platform")


@pytest.fixture(scope="module")
def motion():
    return Fetch().write(LETTER, Page.table())


def test_a_page_out_of_reach_which_corner_how_many_mm_the_nearest_page_that_works():
    with pytest.raises(
        ReachError, match=r"The ink's [a-z ]+ is \d+ mm out of the arm's reach\. Try Page\."
    ) as caught:
        Fetch().write(LETTER, Page.table(x=1.1))
    assert repr(caught.value.cure) in str(caught.value)
    Fetch().write(LETTER, caught.value.cure)


def test_near_singular_a_warning_with_the_distance_to_move():
    with pytest.warns(
        ReachWarning,
        match=r"nearly stretched out here.*; \d+ mm from here it is at ease\. Try Page",
    ) as seen:
        motion = Fetch().write(LETTER, Page.table(x=0.88))
    assert str(seen[0].message) in motion.notes
    assert seen[0].filename == __file__


def test_a_letter_larger_than_the_page_both_sizes_the_largest_that_fits():
    with pytest.raises(
        PageError, match=r"would be \d+ x \d+ mm, but the page is 210 x 297 mm.*size=0\.\d+"
    ):
        Fetch().write(LETTER, Page.table(), size=0.5)


def test_too_fast_what_it_was_slowed_to_by_which_joint_and_where():
    hasty = tuple(Trajectory(s.t / 4, s.position) for s in LETTER)
    motion = Fetch().write(hasty, Page.table(), size=0.19)
    words = re.match(
        r"slowed from (\d\.\d\d) s to (\d\.\d\d) s: (\w+), .* Slower is stroke 0 from ",
        motion.notes[0],
    )
    assert float(words[1]) < float(words[2]) == pytest.approx(motion.duration, abs=0.006)
    assert words[3] in JOINTS


@pytest.mark.parametrize(
    ("t", "position", "says"),
    [
        ([0, 0.1, 0.2], [[0, 0], [0, np.nan], [0, 0]], r"position\[1\] is \[ ?0\. +nan\]"),
        ([0], [[0, 0]], "needs at least 2 samples, but has 1"),
        ([0, 0.2, 0.1], [[0, 0]] * 3, r"t\[2\] is 0\.1 s and does not come after t\[1\] = 0\.2 s"),
    ],
)
def test_numbers_that_no_movement_has_row_and_value(t, position, says):
    with pytest.raises(TrajectoryError, match=says):
        Trajectory(t, position)


def test_millimetres_instead_of_metres():
    with pytest.raises(
        PageError,
        match=r"The ink is \d+ x \d+ m\..*if yours are in millimetres, divide them by 1000",
    ):
        Fetch().write(tuple(Trajectory(s.t, 1000 * s.position) for s in LETTER), Page.table())


def test_a_5_mm_jump_inside_a_stroke_which_sample_and_how_far():
    stroke = LETTER[0]
    along = stroke.position[40] - stroke.position[39]
    position = stroke.position + 0.005 * (np.arange(len(stroke)) >= 40)[
        :, None
    ] * along / np.linalg.norm(along)
    with pytest.raises(
        TrajectoryError,
        match=r"Stroke 0 jumps by \d\.\d mm in 8\.3 ms at sample 40 \(t = 0\.733 s\)",
    ):
        Fetch().write((Trajectory(stroke.t, position),), Page.table())


def test_no_ink_how_far_from_the_paper_and_the_cure(motion):
    pytest.importorskip("pybullet", reason="pybullet is not on this platform")
    (told, *_) = simulate(motion, page_height_error=-0.006).findings
    assert re.match(
        r"No ink: the pen's tip stayed [\d.]+ to [\d.]+ mm over the paper\. Plan again", told
    )


def test_partial_ink_which_part_and_the_cure(motion):
    pytest.importorskip("pybullet", reason="pybullet is not on this platform")
    told = " ".join(simulate(motion, page_tilt=np.radians(5)).findings)
    assert re.search(
        r"of the letter has no ink, .*: there the tip is up to [\d.]+ mm over the paper\. "
        "Plan again",
        told,
    )


def test_pressed_too_hard_how_many_newtons_and_the_cure(motion):
    pytest.importorskip("pybullet", reason="pybullet is not on this platform")
    told = " ".join(simulate(motion, pen="rigid").findings)
    assert re.search(r"\d+ N", told)
    assert "sprung" in told


def test_an_unknown_joint_or_frame_the_nearest_names():
    model = Model.load()
    with pytest.raises(
        JointError, match=r"no joint called 'elbow_flex'\. The nearest names: 'elbow_flex_joint'"
    ):
        model.joint("elbow_flex")
    with pytest.raises(
        JointError, match=r"no frame called 'pen_tipp'\. The nearest names: 'pen_tip'"
    ):
        model.frame("pen_tipp", np.zeros(1), ("elbow_flex_joint",))


def test_without_placo_what_is_missing_what_still_works_how_to_get_it_and_the_rest_goes_on(
    monkeypatch, motion
):
    monkeypatch.setitem(sys.modules, "placo", None)
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    reduced_robot.cache_clear()
    with (
        ThreadPoolExecutor(1) as new_thread,
        pytest.raises(
            MissingPartError,
            match=r"PlaCo, which is not here.*work without it\..*pip install placo",
        ),
    ):
        new_thread.submit(Fetch).result()
    again = type(motion)(**{name: getattr(motion, name) for name in motion.__dataclass_fields__})
    with pytest.raises(MissingPartError, match="PlaCo"):
        _ = again.torque
    assert teach.Letter.learn(teach.recording_of("a")).write()


def test_without_pybullet_what_is_missing_what_still_works_how_to_get_it(motion, without_pybullet):
    with pytest.raises(MissingPartError, match=r"pybullet.*pip install pybullet"):
        simulate(motion)
    assert Fetch().write(LETTER, Page.table()).duration == motion.duration


def test_a_kernel_interrupted_while_simulating_its_client_closed_what_was_written_returned(
    motion, monkeypatch
):
    bullet = pytest.importorskip("pybullet", reason="pybullet is not on this platform")

    def interrupt(step, part):
        if part > 0.5:
            raise KeyboardInterrupt

    before = [number for number in range(20) if bullet.isConnected(number)]
    run = simulate(motion, progress=interrupt)
    assert run.stopped
    assert 0.4 * motion.duration < run.duration < 0.7 * motion.duration
    assert run.ink
    assert [number for number in range(20) if bullet.isConnected(number)] == before
