"""Writers drawn by lot, who write any letter of our alphabet as often as asked, never twice alike.

What makes a writer: lean, width, size, pace, and habits, a smooth bending of the page that is the
same in all his letters; each letter has a little of its own, and each take a little more. The hand
model of our alphabets writes.
"""

import sys

import numpy as np

from dmp_teach.files.writing import ASSETS
from dmp_teach.studies.inputs import Written
from dmp_teach.trajectory import Trajectory

sys.path.insert(0, str(ASSETS))

from letter_hand import Hand, write
from shapes_digits import DIGITS
from shapes_round import ROUND

SHAPES = ROUND | DIGITS


class Pupil:
    """A writer.

    Args:
        seed: Which one; the same seed is the same person.
    """

    def __init__(self, seed):
        chance = np.random.default_rng(seed)
        self.seed, self.name = seed, f"w{seed}"
        self.size, self.width = (
            0.07 * np.exp(0.2 * chance.normal()),
            0.9 * np.exp(0.15 * chance.normal()),
        )
        self.slant, self.pace = 0.1 + 0.12 * chance.normal(), 0.12 * np.exp(0.25 * chance.normal())
        self.habit = bending(chance, 0.03)

    def writes(self, character, take=0, name=None):
        """One take of a letter."""
        own = np.random.default_rng([self.seed, ord(character)])
        now = np.random.default_rng([self.seed, ord(character), take, 7])
        width = self.width * np.exp(0.06 * own.normal() + 0.04 * now.normal())
        slant = self.slant + 0.04 * own.normal() + 0.03 * now.normal()
        pace = self.pace * np.exp(0.08 * now.normal())
        hand = Hand(f"{self.name} {take}", self.size, width, slant, pace, 1.2, 0.034, 0.0015, 0.022)
        samples, spans = write(character, SHAPES[character], hand)
        bent = (self.habit, bending(own, 0.03), bending(now, 0.015))
        strokes = []
        for begin, end in spans:
            there = (samples[:, 0] >= begin) & (samples[:, 0] <= end)
            place = samples[there, 1:3] / self.size
            place = place + sum(bend(place) for bend in bent)
            strokes.append(Trajectory(samples[there, 0], place * self.size))
        return Written(character, name or self.name, tuple(strokes))


def bending(chance, size):
    """A smooth field over the page, in letter units."""
    waves, phases = 2 * chance.normal(size=(6, 2)), chance.uniform(0, 2 * np.pi, (6, 1))
    strength = chance.normal(size=(6, 2)) * size / np.sqrt(3)
    return lambda place: np.sin(place @ waves.T + phases.T) @ strength
