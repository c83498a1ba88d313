"""Find strokes as the paper prints it and as its authors meant it, beside the rule that we use.

Equations 12 and 13, dz/dt > theta and |z - mu_z| < sigma, tell together when a stroke has ended:
the pen rises fast, and is far from the plane. The paper does not say what mu_z is, how the two are
joined, or how large theta and sigma are. Here mu_z is the mean height, z is not smoothed.

printed: joined by *and*: a sample is off the paper where it rises fast and is *near* mu_z. So it
    ends a stroke at a fast rise only, and begins the next one in the air.
meant: the second turned round, as the sentence before it says, and joined by *or*.
authors: their own program with its fixed numbers. It does not look at the first 100 samples; a
    sample from there on is a mark where z is *far* from the paper and rises *or falls* fast. The
    first mark ends a stroke, and the next one begins where its marks end, 20 samples or more before
    another. We take all the lifts that it finds; its paper, 0.03 m up in its world, is 0 here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

import numpy as np

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.segmentation.even_clock import Spans, find_runs
from dmp_teach.segmentation.strokes import check_thresholds, find_strokes
from dmp_teach.trajectory import Array

UNSEEN_SAMPLES, SAMPLES_BETWEEN_LIFTS = 100, 20  # of the authors' program


def find_strokes_by_equations(
    t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006, *, is_printed: bool = True
) -> Spans:
    """Find strokes by the paper's two equations as printed or as meant, like `find_strokes`."""
    check_thresholds(theta, sigma)
    z = position[:, 2]
    rising, off = np.gradient(z, t) > theta, np.abs(z - z.mean())
    up = rising & (off < sigma) if is_printed else rising | (off > sigma)
    return _long_enough(find_runs(~up))


def find_strokes_by_program(
    t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006
) -> Spans:
    """Find strokes as the authors' program does, with arguments of `find_strokes`."""
    check_thresholds(theta, sigma)
    z = position[:, 2]
    marks = np.flatnonzero((np.abs(z) > sigma) & (np.abs(np.gradient(z, t)) > theta))
    marks = marks[marks >= UNSEEN_SAMPLES]
    spans, begin = [], 0
    while len(marks):
        # Its second mark is taken however far it is.
        apart = np.flatnonzero(np.diff(marks[1:]) >= SAMPLES_BETWEEN_LIFTS)
        last = min(1 + apart[0] if len(apart) else len(marks) - 1, len(marks) - 1)
        spans.append((begin, int(marks[0])))
        begin, marks = int(marks[last]), marks[last + 1 :]
    return _long_enough([*spans, (begin, len(t))])


def _long_enough(runs: Iterable[tuple[int, int]]) -> Spans:
    """Return the runs of two samples or more; there must be one."""
    spans = tuple((a, b) for a, b in runs if b - a >= 2)
    if not spans:
        raise RecordingError(
            "By this rule the pen is never on the paper; try a larger sigma, or rule='foot'."
        )
    return spans


StrokeRule = Callable[[Array, Array, float, float], Spans]

RULES: dict[str, StrokeRule] = {
    "foot": find_strokes,
    "printed": find_strokes_by_equations,
    "meant": partial(find_strokes_by_equations, is_printed=False),
    "authors": find_strokes_by_program,
}
"""Rules for strokes: of the local foot, which works, and the readings of the paper."""


def get_rule(rule: str) -> StrokeRule:
    """Return one of the `RULES`; each takes times, positions, theta and sigma like `find_strokes`.

    Raises:
        SettingError: No such rule.
    """
    if not isinstance(rule, str) or rule not in RULES:
        raise SettingError(f"rule is {rule!r}, but must be one of {', '.join(map(repr, RULES))}.")
    return RULES[rule]
