"""The paper's claims about kernels, each computed from a study. Thresholds are said in each docstring.

Each takes recordings (or files, or strokes; None for our own alphabets; or `Evidence`) and gives a `Claim`. Errors are
medians over strokes unless said otherwise. `TOLERANCE` is how much two medians may differ and still be called equal.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from dmp_teach.dmp import KERNELS_PER_SECOND
from dmp_teach.studies.experiments.error_curves import ErrorCurves
from dmp_teach.studies.experiments.variants import WIDTH_VARIANTS
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Claim,
    judged,
    mm,
    per_cent,
    times,
)
from dmp_teach.studies.verdicts.evidence import evidence_of

TOLERANCE = 0.05


def _at(curves: ErrorCurves, x: float) -> np.ndarray:
    """The median error of each variant at one x, shape (V,) [m]."""
    return np.median(curves.at(x), axis=1)


def _of(curves: ErrorCurves, variant: str, x: float) -> np.ndarray:
    """The errors of one variant at one x, shape (S,) [m]."""
    return curves.at(x)[curves.variants.index(variant)]


def _gaussian(curves: ErrorCurves) -> tuple[str, ...]:
    """The variants whose kernels without ends are full Gaussians."""
    kinds = {name: variant.settings for name, variant in WIDTH_VARIANTS.items()}
    return tuple(name for name in curves.variants if math.isfinite(kinds[name].kernel_sigma))


def _names(curves: ErrorCurves, chosen: np.ndarray) -> str:
    """The names of some variants."""
    return "; ".join(v for v, one in zip(curves.variants, chosen, strict=True) if one) or "none"


def narrow_kernels(recordings: Any = None) -> Claim:
    """Error is large below width 1/N and falls to it: twice that of 1/N up to 0.8/N, and falling, in every variant."""
    evidence = evidence_of(recordings)
    curves, below = evidence.widths, evidence.widths.x <= 1
    cases, ratios = {}, []
    for variant, error in zip(curves.variants, curves.median, strict=True):
        falling = np.diff(error[below]) <= TOLERANCE * error[below][:-1]
        large = error[curves.x <= 0.8] >= 2 * error[curves.x == 1]
        cases[variant] = bool(falling.all() and large.all())
        ratios.append(error[curves.x <= 0.8] / error[curves.x == 1])
    least, most = np.min(ratios), np.max(ratios)
    verdict, why = judged(cases)
    figure = (
        f"From width 0.2/N to 0.8/N the error is {times(least)} to {times(most)} that of 1/N: "
        f"{mm(_at(curves, 0.2).min())} to {mm(_at(curves, 0.2).max())} at 0.2/N, {mm(_at(curves, 1).min())} to "
        f"{mm(_at(curves, 1).max())} at 1/N."
    )
    said = "The error is large below kernel width 1/N and falls as the width grows to 1/N."
    return Claim(
        "narrow kernels", said, verdict, figure, why, _call("narrow_kernels", evidence.argument)
    )


def best_width(recordings: Any = None) -> Claim:
    """The minimum lies between 1/N and 4/N: no width has less error, and 1, 2, 3, 4/N have at most twice as much.

    HOLDS if both hold in every variant, DOES NOT HOLD if the first holds in none, else it DEPENDS ON the variant.
    """
    evidence = evidence_of(recordings)
    curves = evidence.widths
    whole, between = np.isin(curves.x, (1, 2, 3, 4)), (curves.x >= 1) & (curves.x <= 4)
    least = np.nanmin(curves.median, axis=1, keepdims=True)
    inside = (curves.median[:, between] <= least).any(axis=1)
    level = inside & (curves.median[:, whole] <= 2 * least).all(axis=1)
    verdict = HOLDS if level.all() else DEPENDS if inside.any() else FAILS
    best = [
        f"{curves.x[k]:.3g}/N ({v})"
        for v, k in zip(curves.variants, np.nanargmin(curves.median, 1), strict=True)
    ]
    worse = _at(curves, 4) / _at(curves, 1)
    gap = times(_at(curves, 1.5)[0] / _at(curves, 1)[0])
    figure = (
        f"Least error at {', '.join(best)}. The error of 4/N is {times(worse.min())} to {times(worse.max())} that of "
        f"1/N; between whole multiples, 1.5/N has {gap} that of 1/N with the first."
    )
    why = f"least error inside for: {_names(curves, inside)}; all of 1, 2, 3, 4/N near it for: {_names(curves, level)}"
    said = "The error is least for kernel widths between 1/N and 4/N."
    return Claim("best width", said, verdict, figure, why, _call("best_width", evidence.argument))


def wide_kernels(recordings: Any = None) -> Claim:
    """Error rises above 4/N (20/N at least 1.1 times 4/N) and is flat from 20/N (28, 40/N and full within a tenth)."""
    evidence = evidence_of(recordings)
    curves = evidence.widths
    rise = _at(curves, 20) / _at(curves, 4)
    wider = np.stack([_at(curves, x) for x in (28, 40, np.inf)]) / _at(curves, 20)
    flat = np.nanmax(np.abs(wider - 1), axis=0)
    cases = {
        v: bool(r >= 1.1 and f <= 0.1) for v, r, f in zip(curves.variants, rise, flat, strict=True)
    }
    verdict, why = judged(cases)
    words = [
        f"{times(r)}, then {w:.2g} ({v})"
        for v, r, w in zip(curves.variants, rise, wider[1], strict=True)
    ]
    figure = f"The error grows so many times from 4/N to 20/N, and from there to 40/N: {', '.join(words)}."
    said = "The error rises above kernel width 4/N and is stable from 20/N on."
    return Claim(
        "wide kernels", said, verdict, figure, why, _call("wide_kernels", evidence.argument)
    )


def truncation(recordings: Any = None) -> Claim:
    """Truncated Gaussians (the best of 1 to 4/N) beat full ones: half of their error or less, with each fit.

    The paper's reason is that kernels learn together; so the fit decides.
    """
    evidence = evidence_of(recordings)
    curves, cut = evidence.widths, np.isin(evidence.widths.x, (1, 2, 3, 4))
    cases, words = {}, []
    for variant, error in zip(curves.variants, curves.median, strict=True):
        if variant in _gaussian(curves):
            ratio = error[np.isinf(curves.x)][0] / error[cut].min()
            cases[variant] = bool(ratio >= 2)
            words.append(f"{times(ratio)} ({variant})")
    verdict, why = judged(cases)
    figure = (
        f"Full Gaussians have so many times the error of the best cut ones: {', '.join(words)}."
    )
    said = (
        "Truncated kernels are more accurate than full Gaussians, since each is fitted by itself."
    )
    return Claim("truncation", said, verdict, figure, why, _call("truncation", evidence.argument))


def gaps_between_kernels(recordings: Any = None) -> Claim:
    """2/3N is the worst of 1/N, 2/3N, 10/N and full Gaussians: in nine of ten strokes, for each fit of Gaussians."""
    evidence = evidence_of(recordings)
    names = _gaussian(evidence.widths)
    gaps, *others = (
        np.stack([_of(evidence.widths, v, x) for v in names]) for x in (2 / 3, 1, 10, np.inf)
    )
    worst = (gaps >= np.max(others, axis=0)).mean(axis=1)
    cases = {v: bool(share >= 0.9) for v, share in zip(names, worst, strict=True)}
    verdict, why = judged(cases)
    words = ", ".join(f"{per_cent(share)} ({v})" for v, share in zip(names, worst, strict=True))
    figure = f"Gaps cost {mm(gaps.min())} to {mm(gaps.max())}; they are the worst of the four in {words} of the strokes."
    said = "Kernels of width 2/3N, which leave gaps, are the worst of 1/N, 2/3N, 10/N and full Gaussians."
    return Claim(
        "gaps between kernels",
        said,
        verdict,
        figure,
        why,
        _call("gaps_between_kernels", evidence.argument),
    )


def number_of_kernels(recordings: Any = None) -> Claim:
    """Error is level from N = Num/10: five times as many kernels do not halve it.

    A case for each variant on the samples as they are, and on every fourth sample.
    """
    evidence = evidence_of(recordings)
    cases, words = {}, []
    for curves, samples in (
        (evidence.numbers, "every sample"),
        (evidence.fewer_samples, "every fourth sample"),
    ):
        for variant, error in zip(curves.variants, curves.median, strict=True):
            tenth, half = error[np.argmin(np.abs(curves.x - 0.1))], error[-1]
            cases[f"{variant}, {samples}"] = bool(half >= tenth / 2)
            words.append(f"{mm(tenth)} and {mm(half)} ({variant}, {samples})")
    verdict, why = judged(cases)
    figure = f"The errors of Num/10 and of Num/2 kernels are {', '.join(words)}."
    why += f". What counts is kernels in a second: Num/10 is {KERNELS_PER_SECOND} of them at 120 samples, and 3 at 30"
    said = "The error is stable and low from N = Num/10 kernels on."
    return Claim(
        "number of kernels",
        said,
        verdict,
        figure,
        why,
        _call("number_of_kernels", evidence.argument),
    )


def four_widths_on_a(recordings: Any = None) -> Claim:
    """On 'a', 1/N is best, then 10/N, then full Gaussians, then 2/3N: medians in that order, for each fit of Gaussians.

    All strokes are taken where no 'a' was recorded.
    """
    evidence = evidence_of(recordings)
    curves = evidence.widths
    of_a = np.array([letter == "a" for letter in curves.characters])
    of_a = of_a if of_a.any() else np.ones(len(of_a), dtype=bool)
    cases, words = {}, []
    for variant in _gaussian(curves):
        order = [float(np.median(_of(curves, variant, x)[of_a])) for x in (1, 10, np.inf, 2 / 3)]
        cases[variant] = bool((np.diff(order) > 0).all())
        words.append(f"{', '.join(map(mm, order))} ({variant})")
    verdict, why = judged(cases)
    figure = (
        f"The errors of 1/N, 10/N, full and 2/3N over {of_a.sum()} strokes: {'; '.join(words)}."
    )
    said = "On the letter a, width 1/N is best, 10/N worse but better than full Gaussians, and 2/3N the worst."
    return Claim(
        "four widths on a", said, verdict, figure, why, _call("four_widths_on_a", evidence.argument)
    )


def _call(name: str, argument: str) -> str:
    """The line that makes a figure again."""
    return f"teach.studies.{name}({argument}).figure"
