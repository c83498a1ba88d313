"""Error against kernel width and against the number of kernels (the paper's figures 4 and 6)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dmp_teach.arguments import checked
from dmp_teach.dmp import Settings
from dmp_teach.errors import SettingError, shown
from dmp_teach.studies.experiments.variants import (
    NUMBER_VARIANTS,
    WIDTH_VARIANTS,
    Variant,
    both_errors,
    has_ends,
)
from dmp_teach.studies.inputs import RecordingsLike, Stroke, named_strokes
from dmp_teach.studies.parallel import Progress, run
from dmp_teach.studies.tables import Columns, Tabled
from dmp_teach.trajectory import Array, Trajectory

SWEPT_WIDTHS = (
    *(0.2, 0.3, 0.4, 0.5, 2 / 3, 0.8, 0.9, 1.0, 1.5, 2.0),
    *(3.0, 4.0, 5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0, np.inf),
)
"""Kernel widths [1/N]: from gaps to every kernel active all the time."""

StrokeJob = tuple[Trajectory, list[list[Settings | None]]]

FEWEST_KERNELS = 5
MOST_KERNELS_PER_SAMPLE = 0.5


@dataclass(frozen=True, eq=False, repr=False)
class ErrorCurves(Tabled):
    """The error of each stroke in each variant over one setting.

    Args:
        x: What was varied, shape (K,): kernel widths [1/N], or kernels as a share of the samples.
        x_name: Its name, with its unit.
        variants: V names.
        strokes: S names, such as "D w01 2".
        characters: The letter of each stroke, S of them.
        samples: How many samples each stroke has, shape (S,).
        error: Root mean square distance from the demonstration, shape (V, S, K) [m]; NaN where a
            kernel cannot be so.
        numbers: How many kernels there were, shape (V, S, K).
        euclidean: The paper's Euclidean error, the sum of the distances of all samples, shape
            (V, S, K) [m]; it grows with the number of samples.
    """

    x: Array
    x_name: str
    variants: tuple[str, ...]
    strokes: tuple[str, ...]
    characters: tuple[str, ...]
    samples: NDArray[np.int_]
    error: Array
    numbers: NDArray[np.int_]
    euclidean: Array

    @checked
    def of(self, variant: str, error: str = "error") -> Array:
        """Return the errors of one variant, or its "euclidean" ones, shape (S, K) [m].

        Raises:
            SettingError: No such variant; names those that there are.
        """
        if variant not in self.variants:
            raise SettingError(
                f"There is no variant {variant!r}; there are: {', '.join(self.variants)}."
            )
        kinds = "error", "euclidean"
        if error not in kinds:
            raise SettingError(f"error is {shown(error)}, but must be one of: {', '.join(kinds)}.")
        found: Array = getattr(self, error)[self.variants.index(variant)]
        return found

    @checked
    def at(self, x: float) -> Array:
        """Return the errors at one value of `x` (the nearest that was tried), shape (V, S) [m]."""
        nearest = np.argmax(self.x) if np.isinf(x) else np.argmin(np.abs(self.x - x))
        return self.error[:, :, int(nearest)]

    @property
    def median(self) -> Array:
        """The median over strokes, shape (V, K) [m]."""
        return np.median(self.error, axis=1)

    @property
    def columns(self) -> Columns:
        """The medians over strokes, a row for each x."""
        errors = zip(self.variants, self.median, strict=True)
        sums = zip(self.variants, np.median(self.euclidean, axis=1), strict=True)
        return {
            self.x_name: self.x,
            **{f"{name} [mm]": 1e3 * error for name, error in errors},
            **{f"{name}, sum [m]": error for name, error in sums},
        }


@checked
def sweep_kernel_width(
    recordings: RecordingsLike = None,
    widths: Sequence[float] | None = None,
    variants: Mapping[str, Variant] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ErrorCurves:
    """Compute the error of every stroke against kernel width, for each kernel kind and fit.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        widths: Kernel widths [1/N]; `SWEPT_WIDTHS` unless given.
        variants: Name: `Variant`; `WIDTH_VARIANTS` unless given.
        executor: As in `claims`; a piece of work is one stroke.
        progress: As in `claims`.
    """

    def settings(variant: Variant, path: Trajectory, width: float) -> Settings | None:
        possible = has_ends(variant.settings, width)
        return variant.on(path, kernel_width=float(width)) if possible else None

    named, strokes = dict(variants or WIDTH_VARIANTS), named_strokes(recordings)
    widths = SWEPT_WIDTHS if widths is None else widths
    found = run(_errors, _pieces(widths, named, strokes, settings), executor, progress)
    return _curves("width [1/N]", widths, named, strokes, found)


@checked
def sweep_kernel_number(
    recordings: RecordingsLike = None,
    shares: Sequence[float] | None = None,
    variants: Mapping[str, Variant] | None = None,
    *,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> ErrorCurves:
    """Compute the error of every stroke against the number of kernels, which touch.

    Args:
        recordings: Recordings, files or strokes; None takes our own alphabets.
        shares: Numbers of kernels as shares of a stroke's samples; None: 16 of them, from 5 kernels
            on the longest stroke to half the samples, with 0.1 (the paper's Num/10) and 0.2 among
            them. Never fewer than 5 kernels.
        variants: Name: `Variant`; `NUMBER_VARIANTS` unless given.
        executor: As in `claims`; a piece of work is one stroke.
        progress: As in `claims`.
    """

    def settings(variant: Variant, path: Trajectory, share: float) -> Settings:
        number = min(len(path), max(FEWEST_KERNELS, round(share * len(path))))
        return variant.on(path, n_kernels=number)

    named, strokes = dict(variants or NUMBER_VARIANTS), named_strokes(recordings)
    if shares is None:
        least = min(FEWEST_KERNELS / max(len(stroke.path) for stroke in strokes), 0.05)
        some = [*np.geomspace(least, 0.1, 9), *np.geomspace(0.1, 0.2, 4), 0.27, 0.36]
        shares = np.unique(np.round([*some, MOST_KERNELS_PER_SAMPLE], 6)).tolist()
    found = run(_errors, _pieces(shares, named, strokes, settings), executor, progress)
    return _curves("kernels per sample", shares, named, strokes, found)


def _pieces(
    x: Sequence[float],
    variants: Mapping[str, Variant],
    strokes: Sequence[Stroke],
    settings: Callable[[Variant, Trajectory, float], Settings | None],
) -> list[StrokeJob]:
    """Return every stroke with the settings of each variant at each `x`."""
    return [
        (each.path, [[settings(v, each.path, value) for value in x] for v in variants.values()])
        for each in strokes
    ]


def _curves(
    name: str,
    x: Sequence[float],
    variants: Mapping[str, Variant],
    strokes: Sequence[Stroke],
    found: Sequence[Array],
) -> ErrorCurves:
    """Return the curves from what was found for each stroke."""
    error, euclidean, numbers = np.stack(found, axis=2)
    return ErrorCurves(
        np.array(x, dtype=float),
        name,
        tuple(variants),
        tuple(stroke.name for stroke in strokes),
        tuple(stroke.character for stroke in strokes),
        np.array([len(stroke.path) for stroke in strokes]),
        error,
        numbers.astype(int),
        euclidean,
    )


def _errors(piece: StrokeJob) -> Array:
    """Return both errors [m] and numbers of kernels of one stroke, shape (3, V, K)."""
    path, rows = piece
    found = [
        [
            (np.nan, np.nan, 0) if each is None else (*both_errors(path, each), each.n_kernels)
            for each in row
        ]
        for row in rows
    ]
    return np.moveaxis(np.array(found, dtype=float), 2, 0)
