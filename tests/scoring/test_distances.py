"""How far apart two shapes are."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dmp_teach.errors import LetterError
from dmp_teach.formats.read import read_recording
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.scoring.distances import letter_distance, letter_distances
from dmp_teach.trajectory import Trajectory
from tests.recordings import RECORDINGS, needs_recordings

LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
TWINS = [
    set("0oOQU"),
    set("1lI"),
    *({letter, letter.upper()} for letter in "cpsuvwxz"),
]  # the same but for their size


def strokes(character, alphabet=None):
    return recording_of(character, alphabet).strokes()


def changed(given, *, factor, shift, turn, tempo, every):
    """A letter of another size, in another place, turned [degrees], slower, with fewer samples."""
    angle = np.radians(turn)
    turned = factor * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return [Trajectory(tempo * s.t[::every], s.position[::every] @ turned.T + shift) for s in given]


@settings(max_examples=25, deadline=None)
@given(
    character=st.sampled_from("aDBgi4"),
    change=st.fixed_dictionaries(
        {
            "factor": st.floats(0.05, 20),
            "shift": st.floats(-1, 1),
            "turn": st.floats(-10, 10),
            "tempo": st.floats(0.2, 5),
            "every": st.integers(1, 4),
        }
    ),
)
def test_size_place_tempo_rate_and_a_small_turn_do_not_make_another_letter(character, change):
    given_letter = strokes(character)
    assert letter_distance(changed(given_letter, **change), given_letter) < 0.16
    assert letter_distance(changed(given_letter, **change | {"turn": 0.0}), given_letter) < 0.05


@pytest.mark.parametrize("character", list("aDBxE5"))
def test_order_direction_and_number_of_strokes_do_not_count(character):
    given_letter = strokes(character)
    other = [Trajectory(stroke.t, stroke.position[::-1]) for stroke in given_letter][::-1]
    other = [
        Trajectory(s.t[a:b], s.position[a:b])
        for s in other
        for a, b in ((0, len(s) // 3), (len(s) // 3 - 1, None))
    ]
    assert (
        letter_distance(other, given_letter) < 0.1
    )  # other points of the same ink: up to half their spacing


def test_the_distance_is_the_same_from_both_sides_and_nothing_from_itself():
    some = [strokes(character, alphabet) for character in "aDgx0" for alphabet in alphabets()]
    found = letter_distances(some, some)
    np.testing.assert_allclose(found, found.T, atol=1e-4)
    assert found.diagonal().max() < 2e-3
    assert found[0, 3] == pytest.approx(letter_distance(some[0], some[3]), abs=1e-5)


def test_a_mirrored_letter_is_another_letter():
    d = strokes("D")
    mirrored = [Trajectory(stroke.t, stroke.position * [-1, 1]) for stroke in d]
    assert letter_distance(mirrored, d) > 0.3


@pytest.mark.slow
def test_a_letter_of_one_hand_is_nearest_to_the_same_letter_of_the_other():
    one, other = ([strokes(letter, alphabet) for letter in LETTERS] for alphabet in alphabets()[:2])
    found = letter_distances(one, other)
    for nearest in (found.argmin(axis=1), found.argmin(axis=0)):
        wrong = [(LETTERS[k], LETTERS[near]) for k, near in enumerate(nearest) if k != near]
        strange = [pair for pair in wrong if not any(set(pair) <= twins for twins in TWINS)]
        assert len(wrong) <= 16, wrong  # nothing of size counts: p and P, o and 0 are twins
        assert len(strange) <= 6, strange


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "most"), [(str.islower, 3), (str.isupper, 8)])
def test_letters_with_accents_are_read_across_hands_as_those_without(kind, most):
    """Small letters, then capitals; a U of one hand and an O of the other look alike."""
    every = [letter for letter in characters() if kind(letter)]
    one, other = ([strokes(letter, alphabet) for letter in every] for alphabet in alphabets())
    found = letter_distances(one, other)
    for nearest in (found.argmin(axis=1), found.argmin(axis=0)):
        wrong = [(every[k], every[near]) for k, near in enumerate(nearest) if k != near]
        assert len(wrong) <= most, wrong


@pytest.mark.slow
@needs_recordings
def test_every_a_is_nearer_to_every_a_than_to_any_d_and_every_d_to_every_d():
    a, d = (
        [read_recording(path) for path in RECORDINGS if path.stem.startswith(f"{letter}_")]
        for letter in ("a", "D")
    )
    for upright in (True, False):
        same, others = letter_distances(a, a, upright), letter_distances(a, d, upright)
        assert (same.max(axis=1) < others.min(axis=1)).all()
        assert same.max() * 1.2 < others.min()
    same, others = letter_distances(d, d), letter_distances(d, a)
    assert (same.max(axis=1) < others.min(axis=1)).all()


@pytest.mark.parametrize("alphabet", alphabets())
def test_spoiled_a_is_still_nearer_to_a_than_to_any_d(alphabet):
    """What the recordings show, on our own letters: bent, leaned and shaken ones of both hands."""
    spoiled = {}
    for letter in "aD":
        spoiled[letter] = [
            [
                Trajectory(
                    s.t,
                    s.position @ [[width, 0], [lean, 1]] + bend * np.sin(60 * s.position[:, ::-1]),
                )
                for s in own
            ]
            for own in (strokes(letter, each) for each in alphabets())
            for width, lean, bend in (
                (1, 0, 0),
                (1.2, 0.1, 0.002),
                (0.85, 0.2, 0.002),
                (1.1, -0.1, 0.003),
            )
        ]
    for letter, other in ("aD", "Da"):
        mine = [strokes(letter, alphabet)]
        own, strange = (
            letter_distances(mine, spoiled[letter]),
            letter_distances(mine, spoiled[other]),
        )
        assert own.max() < strange.min()


@pytest.mark.parametrize(
    ("given_letter", "words"), [([], "nothing"), (None, "None"), ([1.0], "a float")]
)
def test_what_is_no_letter_has_no_distance(given_letter, words):
    with pytest.raises(
        LetterError, match=f"letter must be a Recording, a Letter or its strokes .* but is {words}"
    ):
        letter_distance(given_letter, strokes("a"))
