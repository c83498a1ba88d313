"""Style as numbers: what the letters of several writers share, and the ways in which they differ."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp import Settings, check_point
from dmp_teach.errors import LetterError
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.styles_basis import as_letter, learned_alike, letter_of, path_of, row_of
from dmp_teach.trajectory import Array, locked

FARTHEST = 3.0
"""How far along a principal style a slider goes [standard deviations]."""

BOLDEST = 10.0
"""How many times a letter can be exaggerated: larger shares of a writer draw no letter."""


@dataclass(frozen=True, eq=False)
class Style:
    """How some people write one letter, as a Gaussian over letters: a mean, and principal styles about it.

    Every letter is a row of numbers x (the weights of its primitives, its starts, goals and clock), learned on the same
    kernels and samples, and what it draws is linear in x. So blending letters is blending rows, and

        x = mean + sum z_k way_k,    z ~ N(centre, covariance)

    is a probabilistic movement primitive (Paraschos 2013) whose basis functions are the responses of the DMP. The ways
    are the principal components of what is *drawn*: z_1 changes the ink most, and z = 1 is one standard deviation.

    Made by `Style.of`.

    Args:
        letters: W letters, learned alike.
        writers: Their W pseudonyms.
        mean_row: The mean of their rows, shape (P,).
        ways: The principal styles, shape (K, P), K = W - 1 at most.
        coordinates: Where each letter lies along them, shape (W, K) [standard deviations].
        spread: How much ink one standard deviation moves, root mean square, decreasing, shape (K,) [m].
        centre: Where the middle of the style is, shape (K,); 0 unless it was led through a point.
        covariance: About it, shape (K, K).
    """

    letters: tuple[Letter, ...]
    writers: tuple[str, ...]
    mean_row: Array
    ways: Array
    coordinates: Array
    spread: Array
    centre: Array
    covariance: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        for name in ("mean_row", "ways", "coordinates", "spread", "centre", "covariance"):
            object.__setattr__(self, name, locked(getattr(self, name)))

    @classmethod
    def of(
        cls, letters: Iterable[Any], settings: Settings | None = None, same_size: bool = True
    ) -> Self:
        """Learn a style.

        Args:
            letters: Two or more `Recording`s, `Letter`s or strokes of the same letter, by different writers or by one.
                Order and direction of the strokes may differ; their number may not.
            settings: `Settings.star()` unless given; not the original transformation.
            same_size: Whether all letters are made equally large first; else size is a part of the style.

        Raises:
            LetterError: Fewer than two letters, recordings that say they are different letters, or letters that are
                not made of the same strokes.
            SettingError: The original transformation.
        """
        if not isinstance(letters, Iterable):
            raise LetterError(
                f"A style is learned from letters, but got {letters!r}; give a list of recordings."
            )
        given = list(letters)
        characters = dict.fromkeys(
            repr(each.character) for each in given if getattr(each, "character", None)
        )
        if len(characters) > 1:
            raise LetterError(
                f"A style is of one letter, but these are {', '.join(characters)}; give one character's."
            )
        writers = tuple(
            getattr(each, "writer", None) or str(n) for n, each in enumerate(given, start=1)
        )
        if len(set(writers)) < len(writers):
            writers = tuple(f"{writer}.{n}" for n, writer in enumerate(writers, start=1))
        alike = learned_alike([as_letter(each) for each in given], settings, same_size)
        rows = np.array([row_of(letter) for letter in alike])
        paths = np.array([path_of(letter) for letter in alike])
        count, points = paths.shape[:2]
        mean = rows.mean(axis=0)
        left, sizes, _ = np.linalg.svd(
            (paths - paths.mean(axis=0)).reshape(count, -1), full_matrices=False
        )
        kept = sizes > 1e-9 * max(sizes[0], 1e-12)
        z = np.sqrt(count - 1) * left[:, kept]
        ways = z.T @ (rows - mean) / (count - 1)
        spread = sizes[kept] / np.sqrt((count - 1) * points)
        return cls(
            tuple(alike), writers, mean, ways, z, spread, np.zeros(kept.sum()), np.eye(kept.sum())
        )

    @property
    def mean(self) -> Letter:
        """The letter in the middle of the style."""
        return self._drawn(self.centre)

    @property
    def shares(self) -> Array:
        """Which part of all difference in ink each principal style explains, shape (K,); their sum is 1."""
        return self.spread**2 / max(float((self.spread**2).sum()), 1e-30)

    def blend(self, shares: Mapping[str, float]) -> Letter:
        """A letter between writers.

        Args:
            shares: How much of each writer, by pseudonym; their sum is 1, such as {"w01": 0.7, "w02": 0.3}. A share
                below 0 or above 1 exaggerates.

        Raises:
            LetterError: No such writer, a share larger than `BOLDEST`, or shares whose sum is not 1.
        """
        if not isinstance(shares, Mapping):
            raise LetterError(
                f"shares is {shares!r}, but must be a dictionary, writer: share, such as {{'w01': 1.0}}."
            )
        weights = np.zeros(len(self.writers))
        for writer, share in shares.items():
            weights[self._number(writer)] += _within(
                f"The share of {writer}", share, (-BOLDEST, BOLDEST)
            )
        if not abs(weights.sum() - 1) < 1e-6:
            raise LetterError(
                f"The shares add up to {weights.sum():g}, but must add up to 1, such as 0.7 and 0.3."
            )
        return self._drawn(weights @ self.coordinates)

    def morph(self, one: str, other: str, part: float) -> Letter:
        """The letter on the way from one writer's (part 0) to another's (part 1), or beyond them.

        Raises:
            LetterError: No such writer, or a part larger than `BOLDEST`.
        """
        part = _within("part", part, (-BOLDEST, BOLDEST))
        here, there = self.coordinates[self._number(one)], self.coordinates[self._number(other)]
        return self._drawn(here + part * (there - here))

    def letter(self, coordinates: ArrayLike) -> Letter:
        """The letter at a place along the principal styles.

        Args:
            coordinates: Standard deviations from the mean, at most K of them, the first ones first; the others are 0.

        Raises:
            LetterError: More coordinates than there are styles, or farther out than `FARTHEST`.
        """
        z = np.atleast_1d(_within("coordinates", coordinates, (-FARTHEST, FARTHEST)))
        if z.ndim > 1 or len(z) > len(self.spread):
            raise LetterError(
                f"coordinates has shape {z.shape}, but there are {len(self.spread)} principal styles."
            )
        return self._drawn(np.pad(z, (0, len(self.spread) - len(z))))

    def sample(self, rng: np.random.Generator) -> Letter:
        """A new letter in this style, by chance; the same state of `rng` gives the same letter.

        Raises:
            LetterError: Not a generator of NumPy's.
        """
        if not isinstance(rng, np.random.Generator):
            raise LetterError(
                f"rng is {rng!r}, but must be a generator, such as np.random.default_rng(1)."
            )
        return self._drawn(rng.multivariate_normal(self.centre, self.covariance, method="eigh"))

    def through(self, stroke: int, part: float, point: ArrayLike, near: float = 5e-4) -> Self:
        """The same style, for letters that pass through a point (conditioning, Paraschos 2013, section 2.2).

        Args:
            stroke: Its number, from 0.
            part: When, as a part of the stroke's duration, 0 to 1.
            point: Shape (2,) [m].
            near: How exactly, as a standard deviation, 1 um to 1 m [m].

        Raises:
            LetterError: No such stroke or moment.
            TrajectoryError: A point that is not one.
        """
        if stroke not in range(len(self.letters[0].primitives)):
            last = len(self.letters[0].primitives) - 1
            raise LetterError(f"stroke is {stroke!r}, but strokes are numbered from 0 to {last}.")
        part, near = float(_within("part", part, (0, 1))), float(_within("near", near, (1e-6, 1)))
        place = check_point("point", point, 2)
        middle = self._place(np.zeros_like(self.centre), stroke, part)
        H = np.array(
            [self._place(unit, stroke, part) - middle for unit in np.eye(len(self.centre))]
        ).T
        gain = (
            self.covariance @ H.T @ np.linalg.inv(H @ self.covariance @ H.T + near**2 * np.eye(2))
        )
        centre = self.centre + gain @ (place - middle - H @ self.centre)
        return replace(self, centre=centre, covariance=self.covariance - gain @ H @ self.covariance)

    def __repr__(self) -> str:
        """In one line, without the numbers."""
        first = f", the first explains {100 * self.shares[0]:.0f} %" if len(self.spread) else ""
        count = len(self.spread)
        return f"Style({len(self.letters)} letters, {count} principal style{'s' * (count != 1)}{first})"

    def _number(self, writer: str) -> int:
        """Which letter is this writer's."""
        if writer not in self.writers:
            raise LetterError(
                f"There is no letter by {writer!r} in this style; there are: {', '.join(self.writers)}."
            )
        return self.writers.index(writer)

    def _drawn(self, z: Array) -> Letter:
        """The letter at z (K,)."""
        return letter_of(self.mean_row + z @ self.ways, self.letters[0])

    def _place(self, z: Array, stroke: int, part: float) -> Array:
        """Where the pen of the letter at z (K,) is at a moment, shape (2,) [m]."""
        path = self._drawn(z).strokes[stroke].position
        clock = np.linspace(0, 1, len(path))
        return np.array([np.interp(part, clock, axis) for axis in path.T])


def _within(name: str, value: ArrayLike, ends: tuple[float, float]) -> Array:
    """Numbers between two others, as an array, or a sentence."""
    try:
        found = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        found = np.array(np.nan)
    if not ((found >= ends[0]) & (found <= ends[1])).all():
        what = "each must be" if found.ndim else "must be a number"
        raise LetterError(f"{name} is {value!r}, but {what} between {ends[0]:g} and {ends[1]:g}.")
    return found
