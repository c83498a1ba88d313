import contextlib
import re

import numpy as np
import pytest
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dmp_teach.errors import ReachError
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Trajectory
from tests.robot.ink import LETTER, law
from tests.robot.sound import assert_sound

pytest.importorskip("placo", reason="PlaCo is not on this platform")

FAR = (
    Page.table(x=1.05),
    Page.table(x=2.0),
    Page.table(y=0.9),
    Page.table(x=1.0, y=0.8, z=1.3),
    Page.board(x=1.3),
    Page.board(z=2.2),
    Page.board(x=1.2, y=0.5),
    Page.table(x=1.2, width=0.3, height=0.2),
)


def refusal(page, **options):
    with pytest.raises(ReachError) as caught:
        Fetch().write(LETTER, page, **options)
    return str(caught.value)


@pytest.mark.parametrize("page", FAR, ids=repr)
def test_out_of_reach_says_where_and_by_how_much_and_the_cure_works(page):
    message = refusal(page)
    assert re.search(
        r"The ink's (upper|lower|left|right)[a-z ]* is \d+ mm out of the arm's reach\. Try Page\.", message
    )
    cure = eval(message.partition("Try ")[2].removesuffix("."))
    assert cure.kind == page.kind
    assert (cure.width, cure.height) == (page.width, page.height)
    motion = Fetch().write(LETTER, cure)
    assert motion.notes == ()
    moved = np.linalg.norm(cure.X_world_page[:3, 3] - page.X_world_page[:3, 3])
    default = getattr(Page, page.kind)().X_world_page[:3, 3]
    assert 0 < moved <= np.linalg.norm(default - page.X_world_page[:3, 3]) + 1e-9


@law(examples=6, x=st.floats(1.3, 4))
def test_a_metre_further_out_is_a_metre_more_that_is_missing(x):
    def missing(x):
        return float(re.search(r"is (\d+) mm out", refusal(Page.board(x=x)))[1])

    assert missing(x + 1) - missing(x) == pytest.approx(1000, abs=20)


def test_only_the_ink_need_be_reached_but_a_page_that_is_not_is_mentioned():
    page = Page.table(x=0.9)
    motion = Fetch().write(LETTER, page, size=0.05, at=(0, -0.1))
    assert "the arm reaches this ink, but not all of the page" in motion.notes
    assert "out of the arm's reach" in refusal(Page.table(x=0.95), size=0.05, at=(0, 0.11))


def test_a_stretched_arm_is_warned_of():
    notes = Fetch().write(LETTER, Page.table(x=0.86)).notes
    assert any(re.search(r"nearly stretched out here.* Try Page\.table\(x=0\.\d+\)", note) for note in notes)


@pytest.mark.parametrize("page", [Page.table(x=0.1), Page.table(x=0, z=0.2), Page.board(x=0.05)], ids=repr)
def test_a_page_in_the_robots_body_is_refused(page):
    message = refusal(page)
    assert message.startswith("The page would go through the robot's body. Try Page.")


def test_a_page_where_the_arm_would_touch_the_robot_is_refused():
    assert re.match(r"The arm (would touch the robot: its|cannot get|'s)", refusal(Page.board(x=0.45)))


@law(examples=12, turn=st.tuples(*[st.floats(-3.1, 3.1)] * 3), x=st.floats(0.5, 0.9), z=st.floats(0.5, 1.3))
def test_however_a_page_lies_the_letter_is_written_well_or_refused(turn, x, z):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = Rotation.from_rotvec(turn).as_matrix(), (x, 0, z)
    with contextlib.suppress(ReachError):
        assert_sound(Fetch().write(LETTER, Page(X)))


def test_a_page_too_large_for_any_arm_can_still_be_written_in_its_middle():
    motion = Fetch().write(LETTER, Page.board(width=2.0, height=1.5))
    assert "the arm reaches this ink, but not all of the page" in motion.notes
    long = Trajectory(np.linspace(0, 20, 500), np.column_stack([np.linspace(0, 1.9, 500), np.zeros(500)]))
    with pytest.raises(ReachError, match=r"Try smaller ink in the middle of Page\.board\(width=2, height=1\.5\)"):
        Fetch().write(long, Page.board(width=2.0, height=1.5))


@pytest.mark.parametrize("z", [0.45, 0.55, 0.8, 0.9])
def test_the_height_of_the_table_hardly_matters(z):
    assert Fetch().write(LETTER, Page.table(z=z)).notes == ()
