import contextlib
import re

import numpy as np
import pytest
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dmp_teach.errors import ReachError, ReachWarning
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.page import Page
from dmp_teach.trajectory import Trajectory
from tests.robot.ink import LETTER, law
from tests.robot.sound import assert_sound

GOOD = (
    "Page.table()",
    "Page.board()",
    "Page.table(tilt=0.2)",
    "Page.table(tilt=0.35, turn=0.3)",
    "Page.table(x=0.75, z=0.8, tilt=0.6, turn=-0.4)",
    "Page.table(x=0.8, z=0.9, tilt=1.0)",
    "Page.table(tilt=-0.15)",
    "Page.table(x=0.55, y=0.35, yaw=0.5)",
    "Page.table(x=0.55, y=-0.35, yaw=-0.5, tilt=0.3)",
    "Page.table(turn=1.570796, width=0.148, height=0.21)",
    "Page.table(width=0.297, height=0.21)",
    "Page.table(x=0.65, width=0.297, height=0.42)",
    "Page.table(x=0.65, width=0.42, height=0.297)",
    "Page.table(width=0.2159, height=0.2794)",
    "Page.table(width=0.5, height=0.15)",
    "Page.table(x=0.65, width=0.1, height=0.4)",
    "Page.table(z=0.45)",
    "Page.table(z=1.1)",
    "Page.board(tilt=-0.25)",
    "Page.board(x=0.7, y=0.45, yaw=0.6)",
    "Page.board(turn=0.5, width=0.297, height=0.21)",
    "Page.board(width=0.42, height=0.594)",
    "Page.board(z=0.8, width=0.148, height=0.21)",
    "Page.board(z=1.3)",
    "Page.board(width=0.8, height=0.15)",
)

FAR = (
    Page.table(x=1.05),
    Page.table(x=1.1),
    Page.table(x=2.0),
    Page.table(y=0.9),
    Page.table(x=1.0, y=0.8, z=1.3),
    Page.board(x=1.3),
    Page.board(z=2.2),
    Page.board(x=1.2, y=0.5),
    Page.table(x=1.2, width=0.3, height=0.2),
)

BAD = (
    (
        "Page.table(x=1.3, tilt=0.35, turn=0.5)",
        "The ink's upper right corner is [0-9]+ mm out of the arm's reach",
    ),
    (
        "Page.board(y=0.9, yaw=0.6)",
        "The ink's upper left corner is [0-9]+ mm out of the arm's reach",
    ),
    ("Page.board(x=1.4, tilt=-0.4, width=0.148, height=0.21)", "out of the arm's reach"),
    ("Page.table(x=1.1, turn=0.7, width=0.15, height=0.9)", "out of the arm's reach"),
    (
        "Page.table(x=1.3, tilt=3.1)",
        "The page lies with its face to the floor. The ink's .* out of the arm's reach",
    ),
    (
        "Page.board(yaw=3.141593)",
        "The page shows the robot its back. The ink's .* out of the arm's reach",
    ),
    (
        "Page.table(tilt=-1.2)",
        "The page shows the robot its back. The ink's .* out of the arm's reach",
    ),
    ("Page.table(x=-0.7)", "The page is behind the robot. The ink's .* out of the arm's reach"),
    ("Page.table(z=-0.1)", "^The page would go 100 mm into the floor"),
    ("Page.table(width=2.0, height=2.0)", "^The page would go through the robot's body"),
    (
        "Page.table(x=0.0, y=0.8, width=2.0, height=0.2)",
        "^The page would go through the robot's body",
    ),
    ("Page.board(x=1.4, width=2.0, height=1.2)", "out of the arm's reach"),
)


def refusal(page, **options):
    with pytest.raises(ReachError) as caught:
        Fetch().write(LETTER, page, **options)
    return str(caught.value)


@pytest.mark.parametrize("page", FAR, ids=repr)
def test_out_of_reach_says_where_and_by_how_much_and_the_cure_works(page):
    message = refusal(page)
    assert re.search(
        r"The ink's (upper|lower|left|right)[a-z ]* is \d+ mm out of the arm's reach\. Try Page\.",
        message,
    )
    cure = eval(message.partition("Try ")[2].removesuffix("."))
    assert cure.kind == page.kind
    assert re.fullmatch(
        r"Page\.(table|board)\(([xyz]=-?\d\.?\d{0,2}(, )?)*(width=.*)?\)", repr(cure)
    )
    assert (cure.width, cure.height) == (page.width, page.height)
    motion = Fetch().write(LETTER, cure)
    assert motion.notes == ()
    moved = np.linalg.norm(cure.X_world_page[:3, 3] - page.X_world_page[:3, 3])
    default = getattr(Page, page.kind)().X_world_page[:3, 3]
    assert 0 < moved <= np.linalg.norm(default - page.X_world_page[:3, 3]) + 1e-9


@law(examples=3, x=st.floats(1.3, 4))
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
    with pytest.warns(ReachWarning, match="nearly stretched out here, where its joints") as seen:
        notes = Fetch().write(LETTER, Page.table(x=0.88)).notes
    assert seen[0].filename == __file__
    note = str(seen[0].message)
    assert note.partition(" Try ")[0] in notes
    away, x = re.search(
        r"; (\d+) mm from here it is at ease\. Try Page\.table\(x=(0\.\d+)\)\.$", note
    ).groups()
    assert float(away) == pytest.approx(1000 * (0.88 - float(x)), abs=0.5)


def test_an_arm_stretches_for_the_ink_only_not_for_the_rest_of_the_page():
    page = Page.board(x=0.385543, y=0.92, z=0.59, tilt=-0.29441, turn=2.011493, yaw=1.30895)
    motion = Fetch().write(LETTER, page, size=0.08)
    assert_sound(motion)
    assert not [note for note in motion.notes if "stretched" in note]


@pytest.mark.parametrize(
    ("page", "part", "deep"),
    [
        (Page.table(x=0.2), "torso", 40),
        (Page.table(x=0, z=0.2), "base", 180),
        (Page.board(x=0.05), "torso", 40),
        (Page.table(x=0.42, z=0.3, tilt=0.3), "base", 10),
    ],
    ids=repr,
)
def test_a_page_in_the_robots_body_is_refused_with_pair_moment_depth_and_a_page_that_works(
    page, part, deep
):
    message = refusal(page)
    found = re.match(
        r"The page would go through the robot's body: from 0\.00 s on, it and the robot's "
        r"(torso|base) would overlap by (\d+) mm\. Try Page\.",
        message,
    )
    assert found[1] == part
    assert float(found[2]) == pytest.approx(deep, abs=5)
    assert_sound(Fetch().write(LETTER, eval(message.partition("Try ")[2].removesuffix("."))))


@pytest.mark.parametrize("typed", GOOD)
def test_pages_as_people_lay_them_are_written_on_well(typed):
    motion = Fetch().write(LETTER, eval(typed))
    assert_sound(motion)
    assert motion.notes == ()


@pytest.mark.parametrize(("typed", "words"), BAD)
def test_a_page_that_cannot_be_is_answered_with_one_that_can(typed, words):
    page = eval(typed)
    with pytest.raises(ReachError, match=words) as caught:
        Fetch().write(LETTER, page)
    cure = caught.value.cure
    assert str(caught.value).endswith(f" Try {cure!r}.")
    assert_sound(Fetch().write(LETTER, eval(repr(cure))))
    if (
        max(page.size) < 2
        and "back" not in words
        and "floor" not in words
        and "behind" not in words
    ):
        np.testing.assert_allclose(cure.angles, page.angles, atol=1e-5)
        assert (cure.width, cure.height) == (page.width, page.height)


@law(
    examples=5,
    x=st.floats(-0.5, 1.8),
    y=st.floats(-1.2, 1.2),
    z=st.floats(-0.1, 1.8),
    angles=st.tuples(st.floats(-0.6, 1.8), st.floats(-3, 3), st.floats(-1.5, 1.5)),
    size=st.sampled_from([(0.148, 0.21), (0.21, 0.297), (0.297, 0.21), (0.42, 0.297), (0.12, 0.5)]),
)
def test_whatever_is_asked_for_is_written_well_or_answered_with_a_page_that_works(
    x, y, z, angles, size
):
    tilt, turn, yaw = angles
    page = Page.table(x, y, z, *size, tilt=tilt, turn=turn, yaw=yaw)
    small = {"size": 0.08}
    try:
        assert_sound(Fetch().write(LETTER, page, **small))
    except ReachError as refused:
        assert_sound(Fetch().write(LETTER, eval(repr(refused.cure)), **small))


@pytest.mark.parametrize(
    ("z", "tilt", "turn"),
    [(1.25, 0.0, 0.0), (1.25, 0.0625, 0.0), (1.75, -0.59375, 1.5), (1.75, 1.0, 1.5)],
)
def test_the_page_that_is_proposed_has_been_planned_as_it_is_typed(z, tilt, turn):
    page = Page.table(0.0, 0.0, z, 0.148, 0.21, tilt=tilt, turn=turn)
    with pytest.raises(ReachError) as refused:
        Fetch().write(LETTER, page, size=0.08)
    assert str(refused.value).endswith(f" Try {refused.value.cure!r}.")
    assert_sound(Fetch().write(LETTER, eval(repr(refused.value.cure)), size=0.08))


def test_on_a_page_that_faces_the_floor_one_is_asked_whether_it_is_meant():
    motion = Fetch().write(LETTER, Page.table(tilt=np.pi))
    assert "the page lies with its face to the floor; was it meant so?" in motion.notes


def test_ink_at_the_edge_of_a_large_sheet_is_brought_into_reach_with_it():
    page = Page.board(width=2.0, height=1.0)
    with pytest.raises(ReachError) as caught:
        Fetch().write(LETTER, page, at=(0.9, 0.0))
    cure = caught.value.cure
    assert (cure.width, cure.height) == (2.0, 1.0)
    assert_sound(Fetch().write(LETTER, cure, at=(0.9, 0.0)))


def test_two_sheets_in_one_place_are_two_pages():
    refusal(Page.table(width=2.0, height=2.0))
    assert Fetch().write(LETTER, Page.table()).notes == ()


@pytest.mark.filterwarnings("ignore:the arm is nearly stretched out")
@law(
    examples=8,
    turn=st.tuples(*[st.floats(-3.1, 3.1)] * 3),
    x=st.floats(0.5, 0.9),
    z=st.floats(0.5, 1.3),
)
def test_however_a_page_lies_the_letter_is_written_well_or_refused(turn, x, z):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = Rotation.from_rotvec(turn).as_matrix(), (x, 0, z)
    with contextlib.suppress(ReachError):
        assert_sound(Fetch().write(LETTER, Page(X)))


def test_a_page_that_is_cured_by_turning_it_over_lies_flat_to_the_last_bit():
    X = np.eye(4)
    X[:3, :3] = Rotation.from_rotvec((2.6256845734003837, -0.21752319001220455, 0.0)).as_matrix()
    X[:3, 3] = 0.625, 0.0, 0.5
    with pytest.raises(ReachError, match=r"what the page lies on.* Try Page\.") as caught:
        Fetch().write(LETTER, Page(X))
    assert_sound(Fetch().write(LETTER, caught.value.cure))


def test_a_page_too_large_for_any_arm_can_still_be_written_in_its_middle():
    motion = Fetch().write(LETTER, Page.board(width=2.0, height=1.5))
    assert "the arm reaches this ink, but not all of the page" in motion.notes
    long = Trajectory(
        np.linspace(0, 20, 500), np.column_stack([np.linspace(0, 1.9, 500), np.zeros(500)])
    )
    with pytest.raises(
        ReachError, match=r"Try smaller ink in the middle of Page\.board\(width=2, height=1\.5\)"
    ):
        Fetch().write(long, Page.board(width=2.0, height=1.5))


@pytest.mark.parametrize("z", [0.45, 0.55, 0.8, 0.9])
def test_the_height_of_the_table_hardly_matters(z):
    assert Fetch().write(LETTER, Page.table(z=z)).notes == ()
