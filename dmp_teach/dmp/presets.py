"""Presets: how each differs from DMP*, whose settings are the defaults of `Settings`.

`as_printed` is what the text of the paper says, word for word; `as_coded` is what the authors'
program does; `as_fixed` is the paper with its contradictions mended. Where the text gives no number
the readings borrow one, as the README of this room says.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import TypedDict


class SettingChanges(TypedDict, total=False):
    """The keywords of `Settings`, for who checks types."""

    n_kernels: int | None
    samples_per_kernel: float | None
    kernel: str
    kernel_width: float
    kernel_sigma: float
    kernel_centers: str
    kernel_sides: str
    kernel_spread: float | None
    kernel_floor: float
    alpha: float | None
    alpha_per_kernel: float
    alpha_per_second: float | None
    damping: float
    phase: str
    phase_decay: float
    phase_middle: float
    transform: str
    divide: bool
    fit: str
    integrator: str
    derivatives: str
    start_velocity: str
    feed_goal: bool
    smoothing: float | None
    sharpen: bool


_FULL_GAUSSIANS: SettingChanges = {"kernel_width": inf, "kernel_sigma": 0.65}
_PAPER: SettingChanges = {
    "samples_per_kernel": 10,
    "kernel_sigma": 4.0,
    "derivatives": "central",
    "start_velocity": "measured",
    "feed_goal": False,
    "smoothing": None,
    "sharpen": False,
}

PRESETS: dict[str, SettingChanges] = {
    "star": {},
    "original": {
        **_FULL_GAUSSIANS,
        "alpha": 25.0,
        "phase": "exponential",
        "transform": "original",
        "feed_goal": False,
        "sharpen": False,
    },
    "joint": {
        **_FULL_GAUSSIANS,
        "alpha_per_kernel": 4.0,
        "fit": "joint",
        "integrator": "semi-implicit",
        "smoothing": None,
    },
    "plus": {
        "alpha_per_kernel": 3.0,
        "fit": "bias",
        "integrator": "semi-implicit",
        "smoothing": 20.0,
    },
    "as_printed": {
        **_PAPER,
        "kernel_centers": "ends",
        "kernel_sides": "one",
        "alpha": 25.0,
        "phase": "exponential",
        "phase_decay": 1.0,
        "integrator": "lagged",
    },
    # The program's 4 and 8 per second: D = 4/s, K = 32/s^2, D / (2 sqrt K) = 0.35; and its kernel
    # exp(-(x - c)^2), so that sigma^2 = 1/2.
    "as_coded": {
        **_PAPER,
        "kernel_width": 2.0,
        "kernel_sigma": inf,
        "kernel_spread": sqrt(0.5),
        "kernel_centers": "grid",
        "kernel_sides": "closed",
        "alpha_per_second": 4.0,
        "damping": 1 / sqrt(8),
        "phase": "counted",
        "integrator": "lagged",
        "start_velocity": "kept",
    },
    "as_fixed": _PAPER,
}

WHOSE_CHOICE = (
    ("choice", "the paper's", "ours, in `star`"),
    ("form", "DMP*, equation 11", "the same"),
    ("phase", "linear", "the same, as 1 - t/T"),
    ("kernels", "touching, truncated Gaussians", "touching boxes"),
    ("weights", "each kernel alone, equation 5", "the same, bends sharpened before"),
    ("N", "Num/10", "12 for each second"),
    ("alpha, beta", "not given", "2 N (at least 12), alpha/4"),
    ("demonstration", "as captured", "smoothed at 10 Hz"),
    ("start velocity", "as demonstrated", "fitted to the whole path"),
    ("a goal that moved", "as equation 11 has it", "its change fed forward"),
)
"""What of `star` is the paper's and what is ours; `Settings.as_fixed()` has the paper's alone."""


def table_of_choices() -> str:
    """Return whose choice is what as a table, for the documentation."""
    wide = [max(len(row[k]) for row in WHOSE_CHOICE) for k in range(3)]
    rows = [WHOSE_CHOICE[0], tuple("-" * n for n in wide), *WHOSE_CHOICE[1:]]
    lines = (" | ".join(word.ljust(n) for word, n in zip(row, wide, strict=True)) for row in rows)
    return "\n".join(f"| {line} |" for line in lines)
