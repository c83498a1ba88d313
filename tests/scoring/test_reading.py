"""What a writing looks like."""

from itertools import product

import numpy as np
import pytest

from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.scoring.reading import read_letter
from dmp_teach.trajectory import Trajectory
from tests.laws import for_every
from tests.scoring import faulty

PLAIN = [each for each in characters() if each.isascii()]
# But for their size, or in another hand, these look the same.
ALIKE = (
    "0oOQ",
    "1lIi",
    "cC",
    "pP",
    "sS",
    "uUvV",
    "wW",
    "xX",
    "zZ2",
    "kK",
    "gq9",
    "ceG",
    "yY",
    "b6",
)


def loose(character, alphabet, seed=0):
    rng = np.random.default_rng([seed, ord(character)])
    shaped = faulty.widened(list(recording_of(character, alphabet).strokes()), 1.2)
    return faulty.loose(faulty.leaned(shaped, 8), 0.03, rng)


@for_every(product(PLAIN, alphabets()))
def test_a_loosely_written_letter_is_never_called_another(character, alphabet):
    assert read_letter(loose(character, alphabet), character) is None


def test_nearly_every_wrong_letter_is_named_and_by_its_name():
    rng, asked, named, right = np.random.default_rng(0), 0, 0, 0
    for character in PLAIN:
        for wanted in rng.choice(PLAIN, 3):
            if wanted.lower() != character.lower() and not any(
                {wanted, character} <= set(same) for same in ALIKE
            ):
                found = read_letter(loose(character, alphabets()[0]), str(wanted))
                asked += 1
                named += bool(found)
                right += found == character or any({found, character} <= set(s) for s in ALIKE)
    assert named >= 0.95 * asked
    assert right >= 0.95 * named


@pytest.mark.parametrize("wanted", list("aD4g"))
def test_a_scribble_is_hardly_ever_called_the_wanted_letter(wanted):
    rng, found = np.random.default_rng(0), []
    for _ in range(25):
        t = np.linspace(0, 1, 200)
        corners = np.cumsum(rng.normal(size=(int(rng.integers(10, 25)), 2)), axis=0)
        at = np.linspace(0, 1, len(corners))
        path = np.column_stack([np.interp(t, at, axis) for axis in corners.T])
        found.append(read_letter([Trajectory(t, 0.01 * path)], wanted))
    assert found.count("") >= 20, found
    assert found.count(None) <= 2, found


def test_a_letter_without_its_accent_is_not_another_one():
    assert read_letter(recording_of("a"), "ä") is None
