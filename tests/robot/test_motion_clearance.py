import re

import numpy as np
import pytest
from hypothesis import strategies as st

from dmp_teach.errors import ReachError
from dmp_teach.robot import fetch
from dmp_teach.robot.arm import JOINTS, Solver
from dmp_teach.robot.clearance import (
    LEAST_CLEARANCE,
    PAGE_SURROUND,
    THIN_CLEARANCE,
    find_nearest,
)
from dmp_teach.robot.fetch import Fetch
from dmp_teach.robot.model.proximity import Near, Proximity
from dmp_teach.robot.page import Page
from dmp_teach.robot.time_scaling import TimeScaling
from tests.robot import ink
from tests.robot.ink import LETTER, law
from tests.robot.sound import LIMITS, assert_sound

LOW = np.array([max(joint.lower, -np.pi) for joint in LIMITS])
HIGH = np.array([min(joint.upper, np.pi) for joint in LIMITS])


def brute(q, page):
    """The least distance of every pair that counts, at every sample."""
    proximity = Proximity(JOINTS, page, PAGE_SURROUND)
    counts = [not (other == "page" and "pen" in link) for link, other in proximity.pairs]
    return proximity.distances(q)[:, counts]


@law(examples=15, seed=st.integers(0, 10**6), speed=st.floats(0.1, 2.0))
def test_looking_at_some_samples_finds_what_looking_at_all_of_them_finds(seed, speed):
    rng = np.random.default_rng(seed)
    start, end = rng.uniform(LOW, HIGH, (2, len(JOINTS)))
    q = start + np.linspace(0, speed / 2, 77)[:, None] * (end - start)
    page = Page.table(y=0.5)
    away = brute(q, page)
    first, closest = find_nearest(q, JOINTS, page)
    assert (closest is None) == (away.min() >= THIN_CLEARANCE)
    assert (first is None) == (away.min() >= LEAST_CLEARANCE)
    if closest is not None:
        assert closest.distance == pytest.approx(away.min(), abs=1e-6)
    if first is not None:
        assert first.row == np.argmax((away < LEAST_CLEARANCE).any(axis=1))


@law(
    examples=6,
    letter=ink.letters(),
    page=st.sampled_from([Page.table(x=0.4), Page.board(), Page.table(z=0.5)]),
)
def test_what_is_written_keeps_clear_of_the_robot_and_the_table(letter, page):
    motion = Fetch().write(letter, page)
    assert brute(motion.q[::4], page).min() >= LEAST_CLEARANCE


def refusal(page):
    with pytest.raises(ReachError) as caught:
        Fetch().write(LETTER, page)
    return caught.value


@pytest.mark.parametrize("page", [Page.board(x=0.45), Page.board(x=0.4)], ids=repr)
def test_a_page_too_near_is_refused_with_the_pair_the_moment_the_depth_and_a_page_that_works(page):
    error = refusal(page)
    assert re.match(
        r"The arm would touch the robot: after \d\.\d\d s the arm's "
        r"(wrist|gripper|forearm|elbow|upper arm) would (go into|come within \d+ mm of) "
        r"the robot's (head|torso|base|shoulder)(, \d+ mm deep|; 10 mm must .*)\. Try",
        str(error),
    )
    assert repr(error.cure) in str(error)
    motion = Fetch().write(LETTER, error.cure)
    assert brute(motion.q, error.cure).min() >= LEAST_CLEARANCE


def go_wrong(monkeypatch, what):
    """Let something go wrong on the first page that is planned, and on no other."""
    follow, slow_down, find = Solver.follow, TimeScaling.slow_down, fetch.find_nearest
    first, on_first = [], []

    def followed(solver, q, normal, path, *rest):
        first[:] = first or [path[0]]
        on_first[:] = [np.allclose(path[0], first[0])]
        wrong = 0.01 if what == "tip" and on_first[0] else 0.0
        return (yield from follow(solver, q, normal, path, *rest)) + wrong

    def slowed(scaling, speeds):
        return (what == "hurry" and on_first[0]) or slow_down(scaling, speeds)

    def found(*given):
        touching = Near(240, -0.004, "forearm_roll_link", "page")
        return (touching, touching) if what == "touch" and on_first[0] else find(*given)

    monkeypatch.setattr(Solver, "follow", followed)
    monkeypatch.setattr(TimeScaling, "slow_down", slowed)
    monkeypatch.setattr(fetch, "find_nearest", found)


@pytest.mark.parametrize(
    "page", [Page.table(), Page.board(x=0.8, y=0.1), Page.table(tilt=0.4, yaw=0.3, x=0.6)], ids=repr
)
@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("touch", r"^After 1\.00 s the arm's forearm would go into what"),
        ("tip", "^The arm loses the pen's path after"),
        ("hurry", "^However slowly the pen goes, .* would have to hurry"),
    ],
)
def test_what_the_posture_did_not_foresee_is_refused_with_a_page_for_which_the_same_ink_was_planned(
    monkeypatch, what, says, page
):
    go_wrong(monkeypatch, what)
    with pytest.raises(ReachError, match=says) as caught:
        Fetch().write(LETTER, page)
    cure = caught.value.cure
    assert str(caught.value).endswith(f". Try {cure!r}.")
    assert repr(cure) != repr(page)
    assert_sound(Fetch().write(LETTER, eval(repr(cure))))


def test_an_arm_that_would_go_into_the_table_on_its_way_is_told_when_and_where_to_move_the_page():
    page = Page.table(x=0.46, y=0.14, z=1.03, tilt=-0.08)
    with pytest.raises(
        ReachError, match=r"After \d\.\d\d s .* into what the page lies on, \d+ mm deep\. Try"
    ) as caught:
        Fetch().write(LETTER, page, size=0.05)
    assert_sound(Fetch().write(LETTER, caught.value.cure, size=0.05))


def test_where_no_page_helps_one_is_told_to_write_smaller(monkeypatch):
    touching = Near(240, -0.004, "forearm_roll_link", "page")
    monkeypatch.setattr(fetch, "find_nearest", lambda *given: (touching, touching))
    with pytest.raises(
        ReachError, match=r"4 mm deep\. Write smaller, or move the page\.$"
    ) as caught:
        Fetch().write(LETTER, Page.table())
    assert caught.value.cure is None


def test_a_thin_margin_is_noted(monkeypatch):
    monkeypatch.setattr(
        fetch,
        "find_nearest",
        lambda *given: (None, Near(120, 0.0152, "elbow_flex_link", "torso_lift_link")),
    )
    notes = Fetch().write(LETTER, Page.table()).notes
    assert notes == ("after 0.50 s the arm's elbow comes within 15 mm of the robot's torso",)
