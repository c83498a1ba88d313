"""The paper's claims about kernels, each computed from a study.

Each takes recordings (or files, or strokes; None for our own alphabets; or `Evidence`) and returns
a `Claim`; thresholds stand in the docstrings. Errors are medians over strokes unless said
otherwise.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from dmp_teach.dmp import KERNELS_PER_SECOND
from dmp_teach.studies.experiments.error_curves import ErrorCurves
from dmp_teach.studies.experiments.variants import WIDTH_VARIANTS
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Found,
    as_times,
    claim,
    mm,
    per_cent,
)
from dmp_teach.studies.verdicts.evidence import Evidence
from dmp_teach.trajectory import Array

# Two medians may differ by this share and still be called equal.
EQUAL_MEDIANS = 0.05
# The paper's N = Num/10 as a share of the samples, and what is called a low error there.
TENTH = 0.1
LOW_ERROR = 0.02


def _median_at(curves: ErrorCurves, x: float) -> Array:
    """Return the median error of each variant at one x, shape (V,) [m]."""
    return np.median(curves.at(x), axis=1)


def _errors(curves: ErrorCurves, variant: str, x: float) -> Array:
    """Return the errors of one variant at one x, shape (S,) [m]."""
    return curves.at(x)[curves.variants.index(variant)]


def _gaussian(curves: ErrorCurves) -> tuple[str, ...]:
    """Return the variants whose kernels without ends are full Gaussians."""
    kinds = {name: variant.settings for name, variant in WIDTH_VARIANTS.items()}
    return tuple(
        name
        for name in curves.variants
        if math.isfinite(kinds[name].kernel_sigma) or kinds[name].kernel_spread is not None
    )


def _names(curves: ErrorCurves, chosen: NDArray[np.bool_]) -> str:
    """Return the names of some variants."""
    return "; ".join(v for v, one in zip(curves.variants, chosen, strict=True) if one) or "none"


@claim(
    "narrow kernels",
    "The error is large below kernel width 1/N and falls as the width grows to 1/N.",
)
def narrow_kernels(evidence: Evidence) -> Found:
    """Judge whether the error is large below width 1/N and falls to it.

    Twice that of 1/N up to 0.8/N, and falling, in every variant.
    """
    curves, below = evidence.widths(), evidence.widths().x <= 1
    cases, ratios = {}, []
    for variant, error in zip(curves.variants, curves.median, strict=True):
        falling = np.diff(error[below]) <= EQUAL_MEDIANS * error[below][:-1]
        large = error[curves.x <= 0.8] >= 2 * error[curves.x == 1]
        cases[variant] = bool(falling.all() and large.all())
        ratios.append(error[curves.x <= 0.8] / error[curves.x == 1])
    narrow, touching = _median_at(curves, 0.2), _median_at(curves, 1)
    figure = (
        f"From width 0.2/N to 0.8/N the error is {as_times(np.min(ratios))} to "
        f"{as_times(np.max(ratios))} that of 1/N: {mm(narrow.min())} to {mm(narrow.max())} at "
        f"0.2/N, {mm(touching.min())} to {mm(touching.max())} at 1/N"
    )
    return Found(cases, figure, len(curves.strokes), evidence.strokes)


@claim("best width", "The error is least for kernel widths between 1/N and 4/N.")
def best_width(evidence: Evidence) -> Found:
    """Judge whether the minimum lies between 1/N and 4/N.

    No width has less error, and 1, 2, 3, 4/N have at most twice as much. HOLDS if both hold in
    every variant, DOES NOT HOLD if the first holds in none, else it DEPENDS ON the variant.
    """
    curves = evidence.widths()
    whole, between = np.isin(curves.x, (1, 2, 3, 4)), (curves.x >= 1) & (curves.x <= 4)
    least = np.nanmin(curves.median, axis=1, keepdims=True)
    inside = (curves.median[:, between] <= least).any(axis=1)
    level = inside & (curves.median[:, whole] <= 2 * least).all(axis=1)
    verdict = HOLDS if level.all() else DEPENDS if inside.any() else FAILS
    best = [
        f"{f'{curves.x[k]:.3g}/N' if np.isfinite(curves.x[k]) else 'no ends'} ({v})"
        for v, k in zip(curves.variants, np.nanargmin(curves.median, 1), strict=True)
    ]
    worse = _median_at(curves, 4) / _median_at(curves, 1)
    gap = as_times(_median_at(curves, 1.5)[0] / _median_at(curves, 1)[0])
    figure = (
        f"Least error at {', '.join(best)}. The error of 4/N is {as_times(worse.min())} to "
        f"{as_times(worse.max())} that of 1/N; between whole multiples, 1.5/N has {gap} that of "
        "1/N with the first"
    )
    why = (
        f"least error inside for: {_names(curves, inside)}; all of 1, 2, 3, 4/N near it for: "
        f"{_names(curves, level)}"
    )
    return Found(verdict, figure, len(curves.strokes), evidence.strokes, why)


@claim("wide kernels", "The error rises above kernel width 4/N and is stable from 20/N on.")
def wide_kernels(evidence: Evidence) -> Found:
    """Judge whether the error rises above 4/N and is flat from 20/N.

    20/N at least 1.1 times 4/N; 40/N and no ends within a tenth of 20/N.
    """
    curves = evidence.widths()
    rise = _median_at(curves, 20) / _median_at(curves, 4)
    wider = np.stack([_median_at(curves, x) for x in (40, np.inf)]) / _median_at(curves, 20)
    flat = np.nanmax(np.abs(wider - 1), axis=0)
    rising = zip(curves.variants, rise, flat, strict=True)
    cases = {v: bool(r >= 1.1 and f <= 0.1) for v, r, f in rising}
    words = [
        f"{as_times(r)}, then {w:.2g} ({v})"
        for v, r, w in zip(curves.variants, rise, wider[0], strict=True)
    ]
    figure = (
        "The error grows so many times from 4/N to 20/N, and from there to 40/N: "
        f"{', '.join(words)}"
    )
    return Found(cases, figure, len(curves.strokes), evidence.strokes)


@claim(
    "truncation",
    "Truncated kernels are more accurate than full Gaussians, since each is fitted by itself.",
)
def truncation(evidence: Evidence) -> Found:
    """Judge whether truncated Gaussians (the best of 1 to 4/N) beat full ones, with each fit.

    Half of their error or less. The paper's reason is that kernels learn together; so the fit
    decides.
    """
    curves, cut = evidence.widths(), np.isin(evidence.widths().x, (1, 2, 3, 4))
    cases, words = {}, []
    for variant, error in zip(curves.variants, curves.median, strict=True):
        if variant in _gaussian(curves):
            ratio = error[np.isinf(curves.x)][0] / error[cut].min()
            cases[variant] = bool(ratio >= 2)
            words.append(f"{as_times(ratio)} ({variant})")
    figure = f"Full Gaussians have so many times the error of the best cut ones: {', '.join(words)}"
    return Found(cases, figure, len(curves.strokes), evidence.strokes)


@claim(
    "gaps between kernels",
    "Kernels of width 2/3N, which leave gaps, are the worst of 1/N, 2/3N, 10/N and full Gaussians.",
)
def gaps_between_kernels(evidence: Evidence) -> Found:
    """Judge whether 2/3N is the worst of 1/N, 2/3N, 10/N and full Gaussians.

    In nine of ten strokes, for each fit of Gaussians.
    """
    curves = evidence.widths()
    names = _gaussian(curves)
    gaps, *others = (
        np.stack([_errors(curves, v, x) for v in names]) for x in (2 / 3, 1, 10, np.inf)
    )
    worst = (gaps >= np.max(others, axis=0)).mean(axis=1)
    cases = {v: bool(share >= 0.9) for v, share in zip(names, worst, strict=True)}
    words = ", ".join(f"{per_cent(share)} ({v})" for v, share in zip(names, worst, strict=True))
    figure = (
        f"Gaps cost {mm(gaps.min())} to {mm(gaps.max())}; they are the worst of the four in "
        f"{words} of the strokes"
    )
    return Found(cases, figure, len(curves.strokes), evidence.strokes)


@claim("fewer kernels", "The error falls as the number of kernels grows from zero to N = Num/10.")
def fewer_kernels(evidence: Evidence) -> Found:
    """Judge whether the error falls up to Num/10: never rising (5 %), to half or less.

    A case for each variant, from the smallest number that was tried.
    """
    curves = evidence.numbers()
    below = curves.x <= TENTH
    cases, words = {}, []
    for variant, error in zip(curves.variants, curves.median, strict=True):
        falling = np.diff(error[below]) <= EQUAL_MEDIANS * error[below][:-1]
        few, tenth = error[below][0], error[below][-1]
        cases[variant] = bool(falling.all() and tenth <= few / 2)
        words.append(f"{mm(few)} to {mm(tenth)} ({variant})")
    figure = f"From {curves.x[0]:g} Num to Num/10 kernels the error goes from {', '.join(words)}"
    return Found(cases, figure, len(curves.strokes), evidence.strokes)


@claim("number of kernels", "The error is stable and low from N = Num/10 kernels on.")
def number_of_kernels(evidence: Evidence) -> Found:
    """Judge whether the error is stable and low from N = Num/10.

    Stable: five times as many kernels do not halve it. Low: at Num/10 at most 2 % of the letters'
    median size. A case for each variant on the samples as they are, and on every fourth sample.
    """
    cases, words = {}, []
    for curves, samples in (
        (evidence.numbers(), "every sample"),
        (evidence.fewer_samples(), "every fourth sample"),
    ):
        for variant, error in zip(curves.variants, curves.median, strict=True):
            tenth, half = error[np.argmin(np.abs(curves.x - TENTH))], error[-1]
            low = tenth <= LOW_ERROR * evidence.size
            cases[f"{variant}, {samples}"] = bool(half >= tenth / 2 and low)
            words.append(f"{mm(tenth)} and {mm(half)} ({variant}, {samples})")
    figure = (
        f"The errors of Num/10 and of Num/2 kernels are {', '.join(words)}; "
        f"{per_cent(LOW_ERROR)} of the size are {mm(LOW_ERROR * evidence.size)}"
    )
    why = (
        f". What counts is kernels in a second: Num/10 is {KERNELS_PER_SECOND} of them at 120 "
        "samples, and 3 at 30"
    )
    return Found(cases, figure, len(evidence.numbers().strokes), evidence.strokes, why)


@claim(
    "four widths on a",
    "On the letter a, width 1/N is best, 10/N worse but better than full Gaussians, and 2/3N the "
    "worst.",
)
def four_widths_on_a(evidence: Evidence) -> Found:
    """Judge whether on 'a' 1/N is best, then 10/N, then full Gaussians, then 2/3N.

    Medians in that order, for each fit of Gaussians. All strokes are taken where no 'a' was
    recorded.
    """
    curves = evidence.widths()
    of_a = np.array([letter == "a" for letter in curves.characters])
    of_a = of_a if of_a.any() else np.ones(len(of_a), dtype=bool)
    warning = evidence.missing("a", "all letters that were recorded were taken")
    cases, words = {}, []
    for variant in _gaussian(curves):
        errors = [_errors(curves, variant, x)[of_a] for x in (1, 10, np.inf, 2 / 3)]
        order = [float(np.median(error)) for error in errors]
        cases[variant] = bool((np.diff(order) > 0).all())
        words.append(f"{', '.join(map(mm, order))} ({variant})")
    figure = f"The errors of 1/N, 10/N, full and 2/3N over {of_a.sum()} strokes: {'; '.join(words)}"
    strokes = evidence.strokes if of_a.all() else "strokes of a"
    return Found(cases, figure, int(of_a.sum()), strokes, warning=warning)
