"""Words to be tested, and what is measured of them."""

import numpy as np
from hypothesis import strategies as st

from dmp_teach.ink.alphabet import alphabets
from dmp_teach.letters.text.handwriting import Hand
from dmp_teach.letters.text.words import write_word


def word(text, alphabet=None, **about):
    """A word in the alphabet's own size, unless another is asked for."""
    return write_word(text, alphabet, **({"x_height": None} | about))


ALL = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
HANDS = {name: Hand.of(name, None, None) for name in alphabets()}
TEXTS = st.text(alphabet=ALL, min_size=1, max_size=5)
SMALL = st.text(alphabet="abcdefghijklmnopqrstuvwxyz", min_size=2, max_size=5)
HAND = st.sampled_from(alphabets())


def points(strokes):
    return np.concatenate([stroke.position for stroke in strokes])


def dense(strokes):
    return np.concatenate([filled(stroke.position) for stroke in strokes])


def filled(path):
    k = np.linspace(0, len(path) - 1, 8 * len(path))
    return np.column_stack([np.interp(k, np.arange(len(path)), axis) for axis in path.T])


def fastest(stroke):
    return float(
        (np.linalg.norm(np.diff(stroke.position, axis=0), axis=1) / np.diff(stroke.t)).max()
    )
