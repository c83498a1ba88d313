"""Read what a writing looks like, where it does not look like the letter that was wanted."""

from __future__ import annotations

from functools import cache
from unicodedata import normalize

import numpy as np

from dmp_teach.ink import alphabets, characters, recording_of, signs
from dmp_teach.scoring.arguments import LetterLike
from dmp_teach.scoring.distances import Compared, compared, distances_from

# So near, in `letter_distance`, every writing of a letter is: loose, leaning, wide and narrow ones
# of our alphabets lie within 0.19 of their own letter, scribbles beyond 0.21 of any.
FARTHEST_OWN = 0.22
# Another letter is read only if it is nearer than the wanted one by this factor.
LARGEST_READ_SHARE = 0.6
# Letters this much farther than the nearest may be what was meant, as o and O.
ABOUT_AS_NEAR = 1.2


def read_letter(letter: LetterLike, wanted: str) -> str | None:
    """Read a writing that was to be one of our letters.

    Returns:
        Another letter that it clearly looks like, "" where it looks like none at all, or None
        where it may well be the wanted one.

    Raises:
        LetterError: It is nothing, or all in one place.
    """
    own = float(distances_from(letter, _hands(wanted)).min())
    if own <= FARTHEST_OWN:
        return None
    known, cloud = _alphabet()
    distances = distances_from(letter, cloud).reshape(len(alphabets()), -1).min(axis=0)
    nearest = float(distances.min())
    if nearest < LARGEST_READ_SHARE * own:
        meant = [known[k] for k in np.flatnonzero(distances <= ABOUT_AS_NEAR * nearest)]
        alike = [each for each in meant if _kind(each) == _kind(wanted)]
        best = min(alike or meant, key=lambda each: distances[known.index(each)])
        return None if best == normalize("NFD", wanted)[0] else best
    return "" if nearest > FARTHEST_OWN else None


def _kind(character: str) -> tuple[bool, bool]:
    """Return whether it is a digit, and whether it is a capital."""
    return character.isdigit(), character.isupper()


@cache
def _alphabet() -> tuple[tuple[str, ...], Compared]:
    """Return the letters without accents, and all of them of every hand, to be compared."""
    known = tuple(each for each in characters() if each.isascii())
    return known, compared([recording_of(each, hand) for hand in alphabets() for each in known])


@cache
def _hands(character: str) -> Compared:
    """Return a letter of every hand that has it, to be compared."""
    letter = normalize("NFC", character)
    hands = [hand for hand in alphabets() if letter in (*characters(hand), *signs(hand))]
    return compared([recording_of(letter, hand) for hand in hands])
