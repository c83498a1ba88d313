"""Style as numbers: what the letters of several writers share, and how they differ."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers, checked
from dmp_teach.dmp import Settings, check_point
from dmp_teach.errors import LetterError, shown
from dmp_teach.files import Saved
from dmp_teach.letters.letter import Letter
from dmp_teach.letters.style_json import style_parts, style_to_json
from dmp_teach.letters.styles_basis import learn_alike, letter_from_row, letter_to_row
from dmp_teach.scoring import LetterLike
from dmp_teach.trajectory import Array, all_points
from dmp_teach.values import Value

# Along a principal style [standard deviations].
FARTHEST_COORDINATE = 3.0
# Larger shares of a writer draw no letter.
LARGEST_SHARE = 10.0


@dataclass(frozen=True, eq=False, repr=False)
class Style(Saved, Value):
    """A Gaussian over letters of one class: a mean, and principal styles about it.

    Every letter is a row of numbers x (the weights of its primitives, its starts, goals and clock),
    learned on the same kernels and samples, and its rollout is linear in x. So blending letters is
    blending rows, and

        x = mean + sum z_k way_k,    z ~ N(centre, covariance)

    is a probabilistic movement primitive (Paraschos 2013) whose basis functions are the responses
    of the DMP. The ways are the principal components of what is *drawn*: z_1 changes the ink most,
    and z = 1 is one standard deviation.

    Made by `Style.of`.

    Args:
        letters: W letters, learned alike.
        writers: Their W pseudonyms.
        mean_row: The mean of their rows, shape (P,).
        ways: The principal styles, shape (K, P), K = W - 1 at most.
        coordinates: Of each letter along them, shape (W, K) [standard deviations].
        spread: How much ink one standard deviation moves, rms, decreasing, shape (K,) [m].
        centre: The middle of the style, shape (K,); 0 unless it was led through a point.
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

    file_kind = "style"

    @classmethod
    @checked
    def of(
        cls, letters: Iterable[LetterLike], settings: Settings | None = None, same_size: bool = True
    ) -> Self:
        """Learn a style.

        Args:
            letters: Two or more `Recording`s, `Letter`s or strokes of the same letter. Order and
                direction of the strokes may differ; their number may not.
            settings: `Settings.star()` unless given; not the original transformation.
            same_size: Whether letters are scaled to one size first; else size is a part of style.

        Raises:
            LetterError: Fewer than two letters, recordings of different letters, or letters that
                are not made of the same strokes.
            SettingError: The original transformation.
        """
        if not isinstance(letters, Iterable):
            raise LetterError(
                f"A style is learned from letters, but got {shown(letters)}; give a list of "
                "recordings."
            )
        given = list(letters)
        named = [getattr(each, "character", None) for each in given]
        characters = dict.fromkeys(repr(name) for name in named if name)
        if len(characters) > 1:
            raise LetterError(
                f"A style is of one letter, but these are {', '.join(characters)}; give one "
                "character's."
            )
        writers = tuple(
            getattr(each, "writer", None) or str(n) for n, each in enumerate(given, start=1)
        )
        if len(set(writers)) < len(writers):
            writers = tuple(f"{writer}.{n}" for n, writer in enumerate(writers, start=1))
        learned = [each if isinstance(each, Letter) else Letter.learn(each) for each in given]
        alike = learn_alike(learned, settings, same_size)
        rows = np.array([letter_to_row(letter) for letter in alike])
        paths = np.array([all_points(letter.write()) for letter in alike])
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
        """The share of all variance in ink that each principal style explains, shape (K,)."""
        return self.spread**2 / max(float((self.spread**2).sum()), 1e-30)

    def blend(self, shares: Mapping[str, float]) -> Letter:
        """Return a letter between writers.

        Args:
            shares: How much of each writer, by pseudonym; their sum is 1, such as
                {"w01": 0.7, "w02": 0.3}. A share below 0 or above 1 exaggerates.

        Raises:
            LetterError: No such writer, a share larger than 10, or shares whose sum is not 1.
        """
        if not isinstance(shares, Mapping):
            raise LetterError(
                f"shares is {shown(shares)}, but must be a dictionary, writer: share, such as "
                "{'w01': 1.0}."
            )
        weights = np.zeros(len(self.writers))
        for writer, share in shares.items():
            name = f"The share of {writer}"
            weights[self._number(writer)] += _check_within(name, share, LARGEST_SHARE)
        if not abs(weights.sum() - 1) < 1e-6:
            raise LetterError(
                f"The shares add up to {weights.sum():g}, but must add up to 1, such as 0.7 and "
                "0.3."
            )
        return self._drawn(weights @ self.coordinates)

    @checked
    def morph(self, one: str, other: str, part: float) -> Letter:
        """Return the letter between one writer's (part 0) and another's (part 1), or beyond.

        Raises:
            LetterError: No such writer, or a part larger than 10.
        """
        share = _check_within("part", part, LARGEST_SHARE)
        here, there = (self.coordinates[self._number(writer)] for writer in (one, other))
        return self._drawn(here + share * (there - here))

    @checked
    def letter(self, coordinates: ArrayLike) -> Letter:
        """Return the letter at a place along the principal styles.

        Args:
            coordinates: Standard deviations from the mean along the first styles, at most K; along
                the others they are 0.

        Raises:
            LetterError: More coordinates than there are styles, or one beyond 3.
        """
        z = np.atleast_1d(_check_within("coordinates", coordinates, FARTHEST_COORDINATE))
        if z.ndim > 1 or len(z) > len(self.spread):
            raise LetterError(
                f"coordinates has shape {z.shape}, but there are {len(self.spread)} principal "
                "styles."
            )
        return self._drawn(np.pad(z, (0, len(self.spread) - len(z))))

    def sample(self, rng: np.random.Generator) -> Letter:
        """Draw a letter from the style; the same state of `rng` gives the same letter.

        Raises:
            LetterError: Not a generator of NumPy's.
        """
        if not isinstance(rng, np.random.Generator):
            raise LetterError(
                f"rng is {shown(rng)}, but must be a generator, such as np.random.default_rng(1)."
            )
        return self._drawn(rng.multivariate_normal(self.centre, self.covariance, method="eigh"))

    @checked
    def through(self, stroke: int, part: float, point: ArrayLike, near: float = 5e-4) -> Self:
        """Return the style conditioned to pass through a point (Paraschos 2013, section 2.2).

        Args:
            stroke: Its number, from 0.
            part: When, as a share of the stroke's duration, 0 to 1.
            point: Shape (2,) [m].
            near: How exactly, as a standard deviation, 1 um to 1 m [m].

        Raises:
            LetterError: No such stroke or moment.
            TrajectoryError: A point that is not one.
        """
        if stroke not in range(len(self.letters[0].primitives)):
            last = len(self.letters[0].primitives) - 1
            raise LetterError(
                f"stroke is {shown(stroke)}, but strokes are numbered from 0 to {last}."
            )
        part, near = (
            float(_check_within(name, value, 1, low))
            for name, value, low in (("part", part, 0.0), ("near", near, 1e-6))
        )
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
        first = f", the first explains {100 * self.shares[0]:.0f} %" if len(self.spread) else ""
        styles = f"{len(self.spread)} principal style{'s' * (len(self.spread) != 1)}"
        return f"Style({len(self.letters)} letters, {styles}{first})"

    # Any: what JSON holds.
    def _to_json(self) -> dict[str, Any]:
        return style_to_json(self)

    @classmethod
    def _from_json(cls, content: dict[str, Any]) -> Self:
        return cls(**style_parts(content))

    def _number(self, writer: str) -> int:
        """Return the number of this writer's letter."""
        if writer not in self.writers:
            raise LetterError(
                f"There is no letter by {shown(writer)} in this style; there are: "
                f"{', '.join(self.writers)}."
            )
        return self.writers.index(writer)

    def _drawn(self, z: Array) -> Letter:
        """Return the letter at z (K,)."""
        return letter_from_row(self.mean_row + z @ self.ways, self.letters[0])

    def _place(self, z: Array, stroke: int, part: float) -> Array:
        """Return where the pen of the letter at z (K,) is at a moment, shape (2,) [m]."""
        path = self._drawn(z).strokes[stroke].position
        clock = np.linspace(0, 1, len(path))
        return np.array([np.interp(part, clock, axis) for axis in path.T])


def _check_within(name: str, value: ArrayLike, high: float, low: float | None = None) -> Array:
    """Return numbers from `low` (-high unless given) to `high` as an array."""
    low = -high if low is None else low
    try:
        found = as_numbers(value)
    except ValueError:
        found = np.array(np.nan)
    if not ((found >= low) & (found <= high)).all():
        what = "each must be" if found.ndim else "must be a number"
        raise LetterError(f"{name} is {shown(value)}, but {what} between {low:g} and {high:g}.")
    return found
