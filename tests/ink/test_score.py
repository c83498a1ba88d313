"""How near a writing is to its model."""

import pytest

from dmp_teach import recording_of, score


@pytest.mark.parametrize("character", list("aDMxi07"))
def test_a_letter_is_the_same_as_itself(character):
    given = recording_of(character)
    found = score(given, given)
    assert found.sentence == "It looks the same as the model."
    assert [(part.level, part.word, part.reason) for part in found.parts] == [(3, "the same", "")] * 3
    assert found.distance == pytest.approx(0, abs=1e-9)
