"""Error against kernel width and against the number of kernels (the paper's figures 3 and 5) as data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any

import numpy as np

from dmp_teach.errors import SettingError
from dmp_teach.studies.experiments.variants import (
    NUMBER_VARIANTS,
    WIDTH_VARIANTS,
    Variant,
    has_ends,
    rms_error,
)
from dmp_teach.studies.inputs import strokes_of
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Rows, Tabled
from dmp_teach.trajectory import Array, Trajectory, locked

WIDTHS = (
    0.2,
    0.3,
    0.4,
    0.5,
    2 / 3,
    0.8,
    0.9,
    1.0,
    1.5,
    2.0,
    3.0,
    4.0,
    5.0,
    7.0,
    10.0,
    14.0,
    20.0,
    28.0,
    40.0,
    np.inf,
)
"""Kernel widths [1/N]: from gaps to every kernel awake all the time."""

FEWEST = 5
MOST = 0.5  # of the samples


@dataclass(frozen=True, eq=False)
class ErrorCurves(Tabled):
    """The error of each stroke in each variant over one setting.

    Args:
        x: What was varied, shape (K,): kernel widths [1/N], or kernels as a share of the samples.
        x_name: Its name, with its unit.
        variants: V names.
        strokes: S names, such as "D w01 2".
        characters: The letter of each stroke, S of them.
        samples: How many samples each stroke has, shape (S,).
        error: Root mean square distance from the demonstration, shape (V, S, K) [m]; NaN where a kernel cannot be so.
        numbers: How many kernels there were, shape (V, S, K).
    """

    x: Array
    x_name: str
    variants: tuple[str, ...]
    strokes: tuple[str, ...]
    characters: tuple[str, ...]
    samples: Array
    error: Array
    numbers: Array

    def __post_init__(self) -> None:
        """Lock the arrays."""
        object.__setattr__(self, "x", locked(self.x))
        object.__setattr__(self, "error", locked(self.error))
        for name in ("samples", "numbers"):
            object.__setattr__(self, name, locked(getattr(self, name), dtype=int))

    def of(self, variant: str) -> Array:
        """The errors of one variant, shape (S, K) [m].

        Raises:
            SettingError: No such variant; names those that there are.
        """
        if variant not in self.variants:
            raise SettingError(
                f"There is no variant {variant!r}; there are: {', '.join(self.variants)}."
            )
        return self.error[self.variants.index(variant)]

    def at(self, x: float) -> Array:
        """The errors at one value of `x` (the nearest that was tried), shape (V, S) [m]."""
        if np.isinf(x):
            return self.error[:, :, int(np.argmax(self.x))]
        return self.error[:, :, int(np.argmin(np.abs(self.x - x)))]

    @property
    def median(self) -> Array:
        """The median over strokes, shape (V, K) [m]."""
        return np.median(self.error, axis=1)

    def rows(self) -> Rows:
        """The medians over strokes in mm, a row for each x."""
        return tuple(
            {
                self.x_name: float(x),
                **{f"{v} [mm]": float(1e3 * e) for v, e in zip(self.variants, row, strict=True)},
            }
            for x, row in zip(self.x, self.median.T, strict=True)
        )


def sweep_kernel_width(
    recordings: Any = None,
    widths: Sequence[float] = WIDTHS,
    variants: Mapping[str, Variant] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ErrorCurves:
    """The error of every stroke against kernel width, for each kernel kind and fit.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        widths: Kernel widths [1/N].
        variants: Name: `Variant`; `WIDTH_VARIANTS` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke.
        progress: Called as `progress(done, total)`.
    """
    variants, strokes = dict(variants or WIDTH_VARIANTS), strokes_of(recordings)
    pieces = [(stroke.path, tuple(variants.values()), tuple(widths)) for stroke in strokes]
    found = run(_over_widths, pieces, executor, progress)
    return _curves(widths, "width [1/N]", variants, strokes, found)


def sweep_kernel_number(
    recordings: Any = None,
    shares: Sequence[float] | None = None,
    variants: Mapping[str, Variant] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ErrorCurves:
    """The error of every stroke against the number of kernels, from 5 to half its samples, touching kernels.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shares: Numbers of kernels as shares of a stroke's samples; None: 16 of them, from 5 kernels on the longest
            stroke to half the samples, with 0.1 (the paper's Num/10) and 0.2 among them. Never fewer than 5 kernels.
        variants: Name: `Variant`; `NUMBER_VARIANTS` unless given.
        executor: Any `concurrent.futures.Executor`; a piece of work is one stroke.
        progress: Called as `progress(done, total)`.
    """
    variants, strokes = dict(variants or NUMBER_VARIANTS), strokes_of(recordings)
    if shares is None:
        least = min(FEWEST / max(len(stroke.path) for stroke in strokes), 0.05)
        shares = np.unique(
            np.round(
                [*np.geomspace(least, 0.1, 9), *np.geomspace(0.1, 0.2, 4), 0.27, 0.36, MOST], 6
            )
        )
    pieces = [(stroke.path, tuple(variants.values()), tuple(shares)) for stroke in strokes]
    found = run(_over_numbers, pieces, executor, progress)
    return _curves(shares, "kernels per sample", variants, strokes, found)


def _curves(
    x: Sequence, name: str, variants: Mapping[str, Variant], strokes: Sequence, found: list
) -> ErrorCurves:
    """The pieces put together."""
    both = np.stack(found, axis=2)
    names, letters = tuple(each.name for each in strokes), tuple(each.character for each in strokes)
    samples = [len(each.path) for each in strokes]
    return ErrorCurves(
        np.asarray(x), name, tuple(variants), names, letters, samples, both[0], both[1]
    )


def _over_widths(piece: tuple[Trajectory, tuple[Variant, ...], tuple[float, ...]]) -> Array:
    """Errors and numbers of one stroke, shape (2, V, K)."""
    path, variants, widths = piece
    rows = [[w if has_ends(variant.settings, w) else None for w in widths] for variant in variants]
    settings = [
        [None if w is None else variant.on(path, kernel_width=float(w)) for w in row]
        for variant, row in zip(variants, rows, strict=True)
    ]
    return _tried(path, settings)


def _over_numbers(piece: tuple[Trajectory, tuple[Variant, ...], tuple[float, ...]]) -> Array:
    """Errors and numbers of one stroke, shape (2, V, K)."""
    path, variants, shares = piece
    numbers = [min(len(path), max(FEWEST, round(share * len(path)))) for share in shares]
    return _tried(
        path, [[variant.on(path, n_kernels=number) for number in numbers] for variant in variants]
    )


def _tried(path: Trajectory, settings: list) -> Array:
    """Errors [m] and numbers of kernels for rows of settings, shape (2, V, K)."""
    errors = [
        [np.nan if each is None else rms_error(path, each) for each in row] for row in settings
    ]
    numbers = [[0 if each is None else each.n_kernels or 0 for each in row] for row in settings]
    return np.array([errors, numbers], dtype=float)
