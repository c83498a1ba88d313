"""Which stroke is which."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError
from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.scoring.matching import Orientation, match_strokes
from dmp_teach.trajectory import Trajectory
from tests.laws import for_every
from tests.recordings import RECORDINGS, needs_recordings
from tests.scoring import faulty

LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
MIRROR, HEAD, LEFT = (True, 0), (False, 2), (False, 1)
ALIKE = {  # letters that look the same, or nearly, after it
    MIRROR: "AHIMOTUVWXYilovwx08",
    HEAD: "HINOSXZlosxz08",
    LEFT: "OXox",
}
VIEWS = ((True, 0), (False, 2), (True, 2), (False, 1), (False, 3))
HANDS = (("round", "round"), ("round", "slanted"), ("slanted", "round"))
LEAN = {"round": 0.0, "slanted": 0.28}  # of the alphabets' own verticals, as a shear


def strokes(character, alphabet=None):
    return recording_of(character, alphabet).strokes()


def backwards(stroke):
    return Trajectory(stroke.t, stroke.position[::-1])


def in_one(first, second):
    """Two strokes without a lift: the second from its end, where the first one is."""
    position = np.concatenate([first.position, second.position[::-1]])
    return Trajectory(np.arange(len(position)) / 120, position)


def as_pairs(matching):
    return [(pair.strokes, pair.others) for pair in matching.pairs]


@for_every(product("aBDPRxt45ij", alphabets()))
def test_a_letter_matches_itself_in_any_order_and_direction(character, alphabet):
    given = strokes(character, alphabet)
    other = [backwards(stroke) for stroke in given][::-1]
    found = match_strokes(other, given)
    last = len(given) - 1
    assert as_pairs(found) == [((last - k,), (k,)) for k in range(len(given))]
    assert found.order == tuple(range(len(given)))[::-1]
    assert found.extra == found.missing == ()
    assert not found.mirrored
    assert found.turn == 0
    assert set(found.reversed) == (
        {0} if character in "ij" else set(range(len(given)))
    )  # a dot has no direction


@for_every(product("BDPR", alphabets()))
def test_a_letter_in_one_stroke_is_told_as_joined_and_the_other_way_round_as_split(
    character, alphabet
):
    two = strokes(character, alphabet)
    one = (in_one(*two),)
    assert as_pairs(match_strokes(one, two)) == [((0,), (0, 1))]
    (pair,) = match_strokes(one, two).pairs
    assert (pair.strokes, pair.others) == ((0,), (0, 1))
    assert as_pairs(match_strokes(two, one)) == [((0, 1), (0,))]
    (pair,) = match_strokes(two, one).pairs
    assert (pair.strokes, pair.others) == ((0, 1), (0,))


@pytest.mark.slow
@for_every(product("BDPRxt457", alphabets(), (0, 1)))
def test_a_stroke_that_was_left_out_is_found(character, alphabet, gone):
    given = strokes(character, alphabet)
    left = [stroke for k, stroke in enumerate(given) if k != gone]
    found = match_strokes(left, given)
    assert found.missing == (gone,)
    assert found.extra == ()
    found = match_strokes(given, left)
    assert found.extra == (gone,)
    assert found.missing == ()


@for_every(product("aceglosz0M"))
def test_a_letter_drawn_twice_has_a_stroke_too_many_and_none_in_two_pieces(character):
    once = strokes(character)
    found = match_strokes([*once, *once], once)
    assert len(found.extra) == len(once)
    assert all(len(pair.strokes) == 1 for pair in found.pairs)


@for_every(product("aBDPR24", VIEWS))
def test_a_mirrored_or_turned_letter_is_seen_as_one(character, view):
    mirrored, turn = view
    given = strokes(character)
    spoiled = [
        Trajectory(stroke.t, stroke.position @ Orientation(mirrored, turn).undo())
        for stroke in given
    ]
    found = match_strokes(spoiled, given)
    if character not in "BD" or (mirrored, turn) != (True, 2):  # these look the same upside down
        assert (found.mirrored, found.turn) == (mirrored, turn)
    assert found.extra == found.missing == ()


@settings(max_examples=100, deadline=None)
@given(
    letter=st.sampled_from(
        [(each, hand) for hand in alphabets() for each in characters(hand) if each.isalnum()]
    ),
    shear=st.floats(-0.25, 0.7),
    width=st.floats(0.8, 1.25),
    turn=st.floats(-15, 15),
    seed=st.integers(0, 2**32 - 1),
)
def test_no_ordinary_lean_is_read_as_a_mirror_image(letter, shear, width, turn, seed):
    model, rng = strokes(*letter), np.random.default_rng(seed)
    leaned = faulty.linear(model, [[width, shear - LEAN[letter[1]]], [0, 1]])
    written = faulty.loose(
        faulty.scaled(faulty.turned(leaned, turn), rng.uniform(0.1, 10)), 0.03, rng
    )
    found = match_strokes(written, model)
    assert (found.mirrored, found.turn) == (False, 0)
    assert as_pairs(found) == [((k,), (k,)) for k in range(len(model))]
    assert found.reversed == ()


@pytest.mark.slow
@for_every(product("DEBCK3OHIX", HANDS))
def test_two_writers_who_lean_apart_write_the_same_letter(character, hands):
    written, model = (strokes(character, hand) for hand in hands)
    for mine, yours in ((-0.2, 0.3), (0.3, -0.2), (-0.25, 0.6), (0.6, -0.25)):
        given_apart = (
            faulty.linear(each, [[1, lean], [0, 1]])
            for each, lean in ((written, mine), (model, yours))
        )
        found = match_strokes(*given_apart)
        assert (found.mirrored, found.turn) == (False, 0)
        assert found.extra == found.missing == ()


@pytest.mark.slow
@pytest.mark.parametrize("alphabet", alphabets())
@pytest.mark.parametrize("view", [MIRROR, HEAD, LEFT])
def test_nearly_every_letter_that_can_be_mirrored_or_turned_is_seen_as_that(view, alphabet):
    """Leaning and written loosely, with its strokes in order and direction."""
    rng = np.random.default_rng(0)
    seen, asked = 0, sorted(set(LETTERS) - set(ALIKE[view]))
    for character in asked:
        model = strokes(character, alphabet)
        leaned = faulty.loose(faulty.linear(model, [[1, 0.15], [0, 1]]), 0.02, rng)
        found = match_strokes(
            [Trajectory(s.t, s.position @ Orientation(*view).undo()) for s in leaned], model
        )
        seen += (found.mirrored, found.turn) == view and not found.reversed
    assert seen >= 0.9 * len(asked)


@for_every(product("VUOMY08"))
def test_a_letter_that_is_its_own_mirror_image_is_not_called_one(character):
    model = strokes(character)
    assert not match_strokes(faulty.mirrored(model), model).mirrored


@for_every(product("AÀÁÄÅ"))
def test_an_a_whose_sides_are_one_stroke_is_joined_whatever_its_lean(character):
    slanted, upright = strokes(character, "slanted"), strokes(character, "round")
    found = match_strokes(slanted, upright)
    assert as_pairs(found)[:2] == [((0,), (0, 1)), ((1,), (2,))]
    assert found.extra == found.missing == ()
    found = match_strokes(upright, slanted)
    assert as_pairs(found)[:2] == [((0, 1), (0,)), ((2,), (1,))]
    assert found.extra == found.missing == ()


def test_place_size_and_sampling_do_not_count():
    given = strokes("R")
    other = [Trajectory(stroke.t[::5] * 9, stroke.position[::5] * 30 + 4) for stroke in given]
    assert as_pairs(match_strokes(other, given)) == [((0,), (0,)), ((1,), (1,))]


@needs_recordings
def test_every_recorded_d_has_the_strokes_of_every_other():
    found = {
        path.stem: read_recording(path).strokes()
        for path in RECORDINGS
        if path.stem.startswith("D_")
    }
    for mine in found.values():
        for yours in found.values():
            pairs = as_pairs(match_strokes(mine, yours))
            assert sorted(k for pair in pairs for k in pair[0]) == list(range(len(mine)))
            assert sorted(k for pair in pairs for k in pair[1]) == list(range(len(yours)))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ([], "strokes must be a Recording, a Letter or its strokes .* but is nothing"),
        (7, "but is an int"),
        (["ink"], "but is a str"),
        (Trajectory([0, 1], np.zeros((2, 3))), "Stroke 0 of strokes has 3 dimensions"),
        (Trajectory([0, 1], np.zeros((2, 2))), "strokes is a dot"),
    ],
)
def test_what_is_no_writing_is_refused(given, words):
    with pytest.raises(LetterError, match=words):
        match_strokes(given, strokes("a"))
