"""Letters composed of other letters' strokes: what must hold for any of them."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import LetterError, TrajectoryError
from dmp_teach.ink.alphabet import recording_of
from dmp_teach.letters.compose.geometry import cut_at_corners, find_corners
from dmp_teach.letters.compose.recipes import make_letter
from dmp_teach.letters.compose.roles import strokes_in_role
from dmp_teach.letters.compose.shelf import Shelf
from dmp_teach.letters.letter import Letter
from dmp_teach.trajectory import Trajectory

SHELF = Shelf.of(recording_of(character) for character in "BDlonmi4")
BAR, BOWL = SHELF["D"]
SPOTS = st.tuples(*2 * [st.floats(-0.1, 0.1)]).map(np.array)
FORMS = st.sampled_from(("star", "similarity"))


@pytest.mark.parametrize("character", "BDlonmi4")
@pytest.mark.parametrize("transform", [None, "star", "similarity"])
def test_a_letter_of_its_own_strokes_where_they_were_is_the_letter_itself(character, transform):
    letter = Letter.learn(recording_of(character))
    same = Letter.compose(SHELF[character], transform)
    for before, after in zip(letter.write(), same.write(), strict=True):
        np.testing.assert_allclose(after.t, before.t, rtol=0, atol=1e-12)
        np.testing.assert_allclose(after.position, before.position, rtol=0, atol=1e-12)


@settings(max_examples=20, deadline=None)
@given(SPOTS, SPOTS, FORMS)
def test_moving_every_stroke_moves_the_letter(by, goal, transform):
    pieces = [BAR.using(transform), BOWL.using(transform).led(lower=BAR.at("lower") + 0.5 * goal)]
    here, there = Letter.compose(pieces), Letter.compose([piece.moved(by) for piece in pieces])
    for one, other in zip(here.write(), there.write(), strict=True):
        np.testing.assert_allclose(other.position, one.position + by, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(other.t, one.t)


@settings(max_examples=30, deadline=None)
@given(st.sampled_from(tuple(SHELF)), SPOTS, SPOTS, FORMS)
def test_ends_lie_where_they_were_led(piece, start, goal, transform):
    led = piece.using("star").led(start=start, goal=start + (0.06, 0.02) + 0.4 * goal)
    np.testing.assert_allclose(
        led.drawn.position[[0, -1]], [start, start + (0.06, 0.02) + 0.4 * goal], atol=1e-6
    )
    bowl = BOWL.using(transform).led(goal=goal)
    np.testing.assert_allclose(bowl.at("goal"), goal, atol=1e-6)
    np.testing.assert_allclose(bowl.at("start"), BOWL.at("start"), atol=1e-12)


@settings(max_examples=20, deadline=None)
@given(st.floats(0.2, 4), st.floats(-360, 360), SPOTS)
def test_twice_the_weights_are_twice_the_stroke_and_turned_weights_the_stroke_turned(
    factor, degrees, goal
):
    led = BOWL.led(goal=goal)
    way = led.drawn.position - led.drawn.position[0]
    larger, turned = led.scaled(factor).drawn.position, led.turned(degrees).drawn.position
    np.testing.assert_allclose(larger - larger[0], factor * way, atol=1e-9)
    assert larger[:, 1].min() == pytest.approx(led.drawn.position[:, 1].min(), abs=1e-9)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    np.testing.assert_allclose(turned - turned[0], way @ np.array([[c, s], [-s, c]]), atol=1e-9)
    middle, was = ((path.min(0) + path.max(0)) / 2 for path in (turned, led.drawn.position))
    np.testing.assert_allclose(middle, was, atol=1e-9)


def test_weights_stay_the_writers_own():
    p = Letter.compose([BAR, BOWL.led(lower=BAR.at("middle"))])
    for made, learned in zip(p.primitives, Letter.learn(recording_of("D")).primitives, strict=True):
        np.testing.assert_array_equal(made.weights, learned.weights)
    assert p.made_of == ("D.1", "D.2")
    assert re.fullmatch(r"Letter\(2 strokes, \d+ kernels, made of D.1, D.2\)", repr(p))


def test_a_composed_letter_is_written_moved_and_joined_as_any_other():
    p = Letter.compose([BAR, BOWL.led(lower=BAR.at("middle"))])
    assert p.error == 0
    shifted = p.write(goal_shifts={1: (0.01, 0)})[1].position[-1] - p.write()[1].position[-1]
    assert shifted == pytest.approx((0.01, 0), abs=2e-4)
    assert p.write(goals={1: (0.05, 0.05)})[1].position[-1] == pytest.approx((0.05, 0.05), abs=1e-3)
    assert p.write(duration=9)[-1].t[-1] - p.write(duration=9)[0].t[0] == pytest.approx(9)
    assert p.chain(-0.3).position[-1] == pytest.approx(p.write()[1].position[-1], abs=2e-3)


@settings(max_examples=20, deadline=None)
@given(st.lists(st.sampled_from(tuple(SHELF)), min_size=2, max_size=5))
def test_strokes_come_one_after_the_other_with_the_time_of_a_lift(pieces):
    strokes = Letter.compose(pieces).write()
    for (before, after), (one, other) in zip(pairwise(strokes), pairwise(pieces), strict=True):
        pause = after.t[0] - before.t[-1]
        own = other.primitive.times[0] - one.primitive.times[-1]
        over = 0.36 + np.linalg.norm(other.at("start") - one.at("goal"))  # and it flies 1 m/s
        assert pause == pytest.approx(own if other.follows(one) else min(over, 0.6))


def test_a_letter_that_comes_again_by_the_same_hand_takes_the_place_of_the_first():
    first, again = (Letter.learn(recording_of("D", hand)) for hand in ("round", "slanted"))
    shelf = Shelf.of(
        [
            recording_of("D"),
            recording_of("o"),
            replace(recording_of("D", "slanted"), writer="writer-1"),
        ]
    )
    assert len(shelf) == len(first.strokes) + 1
    np.testing.assert_array_equal(shelf["D.1"].drawn.position, again.write()[0].position)


CUTS = [("n", 2), ("m", 3), ("a", 2), ("s", 1), ("u", 2)]
LOOPED = [("o", 1, "round"), ("l", 1, "round")]  # the slanted hand draws a loop there


@pytest.mark.parametrize(
    ("character", "count", "alphabet"),
    [(*each, hand) for each in CUTS for hand in ("round", "slanted")] + LOOPED,
)
def test_strokes_are_cut_where_they_turn_sharply(character, count, alphabet):
    (stroke,) = recording_of(character, alphabet).strokes()
    parts = cut_at_corners(stroke)
    assert len(parts) == count
    np.testing.assert_array_equal(
        np.concatenate([part.position[k > 0 :] for k, part in enumerate(parts)]), stroke.position
    )


def test_size_place_and_pace_do_not_move_a_corner():
    (stroke,) = recording_of("n").strokes()
    assert (
        find_corners(stroke)
        == find_corners(Trajectory(3 * stroke.t + 5, 7 * stroke.position - 2))
        != ()
    )


def test_a_d_in_one_stroke_is_taken_apart_at_its_corner():
    bar, bowl = (piece.drawn for piece in SHELF["D"])
    t = np.concatenate([bar.t, bar.t[-1] + 0.02 + bowl.t - bowl.t[0]])
    up = Trajectory(t, np.concatenate([bar.position, bowl.position[::-1]]))
    shelf = Shelf.of({"D": Letter.learn([up])})
    assert len(shelf) == 1
    assert strokes_in_role("bar", shelf["D"])[0].name == "D.1a"
    assert strokes_in_role("bowl", shelf["D"])[0].name == "D.1b"
    p = make_letter("P", shelf)
    bar = strokes_in_role("bar", shelf["D"])[0].drawn.position
    assert np.linalg.norm(bar - p.write()[1].position[0], axis=1).min() < 1e-3


def test_a_d_whose_bowl_comes_first_is_still_a_d():
    bar, bowl = Letter.learn(recording_of("D")).strokes
    early = Trajectory(bowl.t - bowl.t[0], bowl.position)
    late = Trajectory(bar.t + early.t[-1] + 0.4, bar.position)
    back = Trajectory(early.t, early.position[::-1])
    p = make_letter("P", Shelf.of({"D": Letter.learn([back, late])}))
    usual = make_letter("P", SHELF)
    np.testing.assert_allclose(p.write()[0].position, usual.write()[0].position, atol=1e-6)
    assert p.made_of == ("D.2", "D.1")


def test_a_d_without_a_corner_is_refused_in_a_sentence():
    s = np.linspace(0, 2 * np.pi, 200)
    ring = Trajectory(s / 3, 0.05 * np.column_stack([np.cos(s), np.sin(s)]))
    with pytest.raises(
        LetterError,
        match=r"^This D, drawn in one stroke, has no 'bar': .*take another recording of it\.$",
    ):
        make_letter("P", Shelf.of({"D": Letter.learn([ring])}))


def test_a_shelf_is_read_by_name():
    assert SHELF["D.1"] is SHELF["D"][0]
    assert [part.name for part in SHELF["n.1"].cut()] == ["n.1a", SHELF["n.1b"].name]
    assert SHELF.letters == tuple("BDlonmi4")
    assert [name in SHELF for name in ("D", "D.2", "D.3", "d", 4)] == [
        True,
        True,
        False,
        False,
        False,
    ]
    assert len(SHELF) == len(list(SHELF)) == sum(len(SHELF[c]) for c in SHELF.letters)
    assert re.fullmatch(r"Shelf\(B.1, B.2, D.1, D.2, l.1, .*; by writer-1\)", repr(SHELF))
    assert repr(SHELF["D.1"]).startswith("Piece(D.1 by writer-1, ")


def test_several_writers_stand_on_one_shelf_and_are_asked_for_by_name():
    both = Shelf.of(recording_of("D", alphabet) for alphabet in ("round", "slanted"))
    assert both.writers == ("writer-1", "writer-2")
    assert both.by("writer-2").writers == ("writer-2",)
    with pytest.raises(
        LetterError,
        match=r"'D' was written by writer-1, writer-2; ask shelf\.by\(writer\)\['D.1'\]\.",
    ):
        both["D.1"]
    with pytest.raises(
        LetterError,
        match=r"no stroke by 'w9' on this shelf; it has strokes by writer-1, writer-2\.",
    ):
        both.by("w9")


@pytest.mark.parametrize(
    ("wrong", "answer"),
    [
        (lambda: SHELF["D.3"], r"There is no 'D\.3' on this shelf\. The nearest are D\.1, D\.2\."),
        (lambda: SHELF["d"], r"There is no 'd' on this shelf\. The nearest are D\.1, D\.2\."),
        (lambda: SHELF[3], r"There is no '3' on this shelf\. It has B\.1, "),
        (lambda: Shelf.of([]), r"A shelf is made of letters, but got none"),
        (
            lambda: Shelf.of("abc"),
            r"A shelf is made of recordings, or of \{'D': letter\}, but got a str\.",
        ),
        (
            lambda: Shelf.of([Letter.learn(recording_of("D"))]),
            r"does not say which character it is; give it by name",
        ),
        (
            lambda: Letter.compose([]),
            r"composed of strokes from a shelf \(Piece\), but got nothing",
        ),
        (lambda: Letter.compose([BAR.drawn]), r"but got a Trajectory"),
        (
            lambda: Letter.compose([BAR], "original"),
            r"transform is 'original', but strokes are led by 'star' or",
        ),
        (
            lambda: BAR.at("side"),
            r"There is no place 'side' on a stroke; give a part from 0 to 1, or 'start'",
        ),
        (lambda: BAR.at(2), r"There is no place 2 on a stroke"),
        (
            lambda: BAR.height(3),
            r"There is no height 3 on D\.1; give a part from 0 \(bottom\) to 1 \(top\)",
        ),
        (lambda: BAR.height("top"), r"There is no height 'top' on D\.1"),
        (lambda: BAR.slid("top", 2), r"must be a Piece, .* but is 2\."),
        (lambda: Letter.compose(3), r"composed of strokes from a shelf \(Piece\), but got an int"),
        (
            lambda: BAR.led(side=(0, 0)),
            r"A stroke has no end 'side'; it can be led by 'start', 'goal', 'upper' or",
        ),
        (
            lambda: BAR.led(start=(0, 0), upper=(0, 0)),
            r"start and upper are the same end of D\.1; lead it once",
        ),
        (lambda: BAR.scaled(0), r"factor is 0, but a stroke can be scaled by 0\.001 to 1000"),
        (
            lambda: BAR.turned("round"),
            r"degrees is 'round', but a stroke can be turned by -360 to 360",
        ),
        (
            lambda: BAR.moved((0, 1)).slid("top", BOWL),
            r"D\.2 is from .* mm high, and nothing can be slid to it at",
        ),
        (
            lambda: BAR.meeting((0, -3)),
            r"D\.1 is from .* to .* mm high, and nothing can be slid to it at -3000 mm",
        ),
        (
            lambda: strokes_in_role("hat", SHELF["D"]),
            r"There is no role 'hat' for a stroke; there are all, stem",
        ),
    ],
)
def test_what_cannot_be_is_said_in_a_sentence(wrong, answer):
    with pytest.raises(LetterError, match=answer):
        wrong()


def test_points_that_are_none_are_refused():
    for wrong in (
        lambda: BAR.moved(3),
        lambda: BAR.led(goal=(np.nan, 0)),
        lambda: BAR.put("top", "high"),
    ):
        with pytest.raises(TrajectoryError):
            wrong()


def test_strokes_of_the_original_form_can_be_moved_but_not_turned():
    bar, bowl = Shelf.of([recording_of("D")], Settings.original())["D"]
    moved = Letter.compose([bar, bowl.moved((0.01, 0))]).write()[1].position
    np.testing.assert_allclose(moved, bowl.drawn.position + np.array([0.01, 0]), atol=1e-12)
    for change in (lambda: bar.turned(9), lambda: bar.scaled(2), lambda: bar.using("star")):
        with pytest.raises(
            LetterError, match=r"D\.1 was learned with the original form, .*Settings\.star\(\)"
        ):
            change()


@pytest.mark.parametrize("preset", ["star", "joint", "plus"])
def test_every_preset_can_be_scaled_and_led(preset):
    bar, bowl = Shelf.of([recording_of("D")], getattr(Settings, preset)())["D"]
    small = bowl.scaled(0.5).led(goal=bar.at(0.5))
    assert np.linalg.norm(small.at("goal") - bar.at(0.5)) < 1e-6
    part = Shelf.of([recording_of("n")], getattr(Settings, preset)())["n.1b"]
    assert np.abs(part.drawn.position - part.shown.position).max() < 3e-3
