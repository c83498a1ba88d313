"""How one ink is laid on another."""

from dataclasses import replace
from itertools import product

import numpy as np

from dmp_teach import score
from dmp_teach.ink.alphabet import alphabets, characters, recording_of
from dmp_teach.scoring.overlay import lay_on, rms_apart
from dmp_teach.scoring.resampling import resample
from tests.laws import for_every
from tests.scoring import faulty

PLAIN = [each for each in characters() if each.isascii()]


def strokes(character, alphabet=None):
    return list(recording_of(character, alphabet).strokes())


@for_every(product(PLAIN, alphabets()))
def test_how_often_a_place_is_gone_over_moves_no_letter_and_makes_no_distance(character, alphabet):
    model = strokes(character, alphabet)
    rng = np.random.default_rng(ord(character))
    number, part = int(rng.integers(len(model))), rng.uniform(0.2, 1.0)
    found = score(faulty.gone_over(model, number, part), model)
    assert found.distance < 0.006 * faulty.size_of(model)
    assert np.linalg.norm(found.shift) < 0.006 * faulty.size_of(model)


@for_every(product("aDgk4S", "aDgk4S"))
def test_at_no_other_place_are_two_inks_nearer(character, other):
    ink, model = (
        resample(strokes(*each), 96)
        for each in ((character, alphabets()[0]), (other, alphabets()[1]))
    )
    shift, size = lay_on(ink, model), np.ptp(model.points, axis=0).max()
    steps = np.array([*product(np.linspace(-0.3, 0.3, 7), repeat=2)]) * size
    around = [rms_apart(replace(ink, points=ink.points + shift + step), model) for step in steps]
    least = rms_apart(replace(ink, points=ink.points + shift), model)
    assert least <= 1.05 * min(around), (least, min(around))
