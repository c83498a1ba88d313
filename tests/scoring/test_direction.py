"""Which way the pen went, where the ink is the same."""

from itertools import product

import numpy as np

from dmp_teach import score
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from tests.laws import for_every
from tests.scoring import faulty

PLAIN = [each for each in characters() if each.isascii()]
# Letters with a bowl or a loop of more than a fifth of a stroke, in both hands.
BOWLS = set("abdegopqOQ0689")


def strokes(character, alphabet):
    return list(recording_of(character, alphabet).strokes())


def loops():
    """Yield every loop of every letter: its stroke and where it begins and ends along that."""
    for alphabet, character in product(alphabets(), PLAIN):
        for number, stroke in enumerate(strokes(character, alphabet)):
            for begin, end in faulty.loops(stroke):
                yield alphabet, character, number, begin, end


@for_every(loops())
def test_a_loop_that_goes_round_the_other_way_is_named_and_changes_no_shape(
    alphabet, character, number, begin, end
):
    model, rng = strokes(character, alphabet), np.random.default_rng(0)
    written = faulty.loose(faulty.turned_back(model, number, begin, end), 0.015, rng)
    found = score(written, model)
    assert found.sentence.endswith("goes round the other way."), found.sentence
    way = found.parts[3]
    assert (way.name, way.word) == ("Way of writing", "not far")
    assert [part.word for part in found.parts[:3]] == ["the same"] * 3


def test_every_letter_with_a_bowl_has_a_loop():
    found = list(loops())
    for alphabet in alphabets():
        assert {letter for hand, letter, *_ in found if hand == alphabet} >= BOWLS


@for_every(product(PLAIN, alphabets()))
def test_who_goes_the_models_way_is_never_told_otherwise(character, alphabet):
    model, rng = strokes(character, alphabet), np.random.default_rng(ord(character))
    loose = faulty.loose(faulty.leaned(faulty.widened(model, 1.2), 10), 0.02, rng)
    for written in (loose, faulty.bent(model, 0.04)):
        names = {fault.name for fault in score(written, model).faults}
        assert not names & {"round", "reversed"}, names
    names = {fault.name for fault in score(faulty.gone_over(model, 0, 0.6), model).faults}
    assert "round" not in names
