"""Every field of every preset, in one table, and the three readings of the paper line by line.

`as_printed` is what the text says, word for word; `as_coded` is what the authors' program does;
`as_fixed` is the paper with its contradictions mended. Where the text gives no number the readings
borrow one, and say so in `BORROWED`.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import Any

PRESET_NAMES = ("star", "original", "joint", "plus", "as_printed", "as_coded", "as_fixed")

# The program's 4 and 8 per second: D = 4/s, K = 32/s^2, D / (2 sqrt K) = 0.35.
UNDERDAMPED = 1 / sqrt(8)

# fmt: off
_OURS: dict[str, tuple[Any, ...]] = {
    #                       star        original       joint            plus
    "n_kernels":           (None,       None,          None,            None),
    "samples_per_kernel":  (None,       None,          None,            None),
    "kernel":              ("gaussian", "gaussian",    "gaussian",      "gaussian"),
    "kernel_width":        (1.0,        inf,           inf,             1.0),
    "kernel_sigma":        (inf,        0.65,          0.65,            inf),
    "kernel_centers":      ("middles",  "middles",     "middles",       "middles"),
    "kernel_sides":        ("both",     "both",        "both",          "both"),
    "alpha":               (None,       25.0,          None,            None),
    "alpha_per_kernel":    (2.0,        2.0,           4.0,             3.0),
    "alpha_per_second":    (None,       None,          None,            None),
    "damping":             (1.0,        1.0,           1.0,             1.0),
    "phase":               ("linear",   "exponential", "linear",        "linear"),
    "phase_decay":         (4.6,        4.6,           4.6,             4.6),
    "phase_middle":        (0.75,       0.75,          0.75,            0.75),
    "transform":           ("star",     "original",    "star",          "star"),
    "divide":              (True,       True,          True,            True),
    "fit":                 ("lwr",      "lwr",         "joint",         "bias"),
    "integrator":          ("explicit", "explicit",    "semi-implicit", "semi-implicit"),
    "derivatives":         ("inverse",  "inverse",     "inverse",       "inverse"),
    "start_velocity":      ("fitted",   "fitted",      "fitted",        "fitted"),
    "feed_goal":           (True,       False,         True,            True),
    "smoothing":           (10.0,       10.0,          None,            20.0),
    "sharpen":             (True,       False,         True,            True),
}
_READINGS: dict[str, tuple[Any, ...]] = {
    #                       as_printed     as_coded     as_fixed
    "n_kernels":           (None,          None,        None),
    "samples_per_kernel":  (10,            10,          10),
    "kernel":              ("gaussian",    "gaussian",  "gaussian"),
    "kernel_width":        (1.0,           2.0,         1.0),
    "kernel_sigma":        (4.0,           4.0,         4.0),
    "kernel_centers":      ("ends",        "grid",      "middles"),
    "kernel_sides":        ("one",         "both",      "both"),
    "alpha":               (25.0,          None,        None),
    "alpha_per_kernel":    (2.0,           2.0,         2.0),
    "alpha_per_second":    (None,          4.0,         None),
    "damping":             (1.0,           UNDERDAMPED, 1.0),
    "phase":               ("exponential", "linear",    "linear"),
    "phase_decay":         (1.0,           4.6,         4.6),
    "phase_middle":        (0.75,          0.75,        0.75),
    "transform":           ("star",        "star",      "star"),
    "divide":              (False,         True,        True),
    "fit":                 ("lwr",         "lwr",       "lwr"),
    "integrator":          ("lagged",      "lagged",    "explicit"),
    "derivatives":         ("central",     "central",   "central"),
    "start_velocity":      ("measured",    "measured",  "measured"),
    "feed_goal":           (False,         False,       False),
    "smoothing":           (None,          None,        None),
    "sharpen":             (False,         False,       False),
}
# fmt: on
# Any: what a setting may be, its knob knows.
TABLE: dict[str, tuple[Any, ...]] = {name: _OURS[name] + _READINGS[name] for name in _OURS}

BORROWED = {
    "as_printed": "The text gives no h, alpha or beta: kernel_sigma is the program's 4/N, alpha "
    "the textbook's 25.",
    "as_coded": "The program takes N from its caller: it is the paper's Num/10 here. Where no "
    "kernel is awake the program returns NaN, and we give 0.",
    "as_fixed": "The text gives no h, alpha or beta: kernel_sigma is the program's 4/N, alpha 2 N, "
    "beta alpha/4.",
}

SWITCHES: dict[str, dict[str, Any]] = {
    "one-sided kernels: x - c_i <= theta": {"kernel_sides": "one"},
    "xdot = -x/T, which is exponential": {
        "phase": "exponential",
        "phase_decay": 1.0,
        "kernel_centers": "phases",
    },
    "xdot = -alpha_x x in Algorithm 2": {
        "phase": "exponential",
        "phase_decay": 4.6,
        "kernel_centers": "phases",
    },
    "N centres evenly in [0, 1], both ends included": {"kernel_centers": "ends"},
    "the program's centres i/N": {"kernel_centers": "grid"},
    "the program's theta = 1/N": {"kernel_width": 2.0},
    "full Gaussians": {"kernel_width": inf},
    "the program's 4 and 8 per second": {"alpha_per_second": 4.0, "damping": UNDERDAMPED},
    "F not divided by K": {"divide": False},
    "Euler with the acceleration of the step before": {"integrator": "lagged"},
}


def preset(name: str) -> dict[str, Any]:
    """Return every field of one preset."""
    column = PRESET_NAMES.index(name)
    return {field: row[column] for field, row in TABLE.items()}
