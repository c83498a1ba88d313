"""Find strokes as the paper prints it and as its authors meant it, beside the rule that we use.

The paper's section on stroke segmentation has two equations, dz/dt > theta and |z - mu_z| < sigma,
and says that together they tell when a stroke has ended: the pen rises fast, and is far from the
plane. It does not say what mu_z is, how the two are joined, how large theta and sigma are, or
whether z is smoothed. In both rules here mu_z is the mean height of the whole recording, lifts and
all, and z is the raw height over the page.

printed: the two equations to the letter, joined by *and*: a sample is off the paper where it rises
    fast and is *near* mu_z. So it ends a stroke at a fast rise only, and begins the next one in
    the air.
authors: the second inequality turned round, as the sentence before it says and as we take the
    authors' own program to do it, joined by *or*: a sample is off the paper where it rises fast or
    is *far* from mu_z. Whether their program joins them so, smooths z or cuts more away is unknown
    to us.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.segmentation.even_clock import Flags, Spans, find_runs
from dmp_teach.segmentation.strokes import check_thresholds, find_strokes
from dmp_teach.trajectory import Array


def find_strokes_as_printed(
    t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006
) -> Spans:
    """Find strokes by the paper's two equations to the letter, with arguments of `find_strokes`."""
    rising, off = _rising_and_off(t, position, theta, sigma)
    return _down_spans(~(rising & (off < sigma)))


def find_strokes_as_meant(
    t: Array, position: Array, theta: float = 0.10, sigma: float = 0.006
) -> Spans:
    """Find strokes with the second inequality turned round, with arguments of `find_strokes`."""
    rising, off = _rising_and_off(t, position, theta, sigma)
    return _down_spans(~(rising | (off > sigma)))


StrokeRule = Callable[[Array, Array, float, float], Spans]

RULES: dict[str, StrokeRule] = {
    "foot": find_strokes,
    "printed": find_strokes_as_printed,
    "authors": find_strokes_as_meant,
}
"""Rules for strokes: of the local foot, which works, and the two readings of the paper."""


def get_rule(rule: str) -> StrokeRule:
    """Return one of the `RULES`; each takes times, positions, theta and sigma like `find_strokes`.

    Raises:
        SettingError: No such rule.
    """
    if not isinstance(rule, str) or rule not in RULES:
        raise SettingError(f"rule is {rule!r}, but must be one of {', '.join(map(repr, RULES))}.")
    return RULES[rule]


def _rising_and_off(t: Array, position: Array, theta: float, sigma: float) -> tuple[Flags, Array]:
    """Return where the pen rises faster than theta, and how far it is from its mean height."""
    check_thresholds(theta, sigma)
    z = position[:, 2]
    return np.gradient(z, t) > theta, np.abs(z - z.mean())


def _down_spans(down: Flags) -> Spans:
    """Return runs of samples (T,) on the paper; those of one sample are left out."""
    spans = tuple((a, b) for a, b in find_runs(down) if b - a >= 2)
    if not spans:
        raise RecordingError(
            "By this rule the pen is never on the paper; try a larger sigma, or rule='foot'."
        )
    return spans
