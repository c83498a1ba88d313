"""Find strokes as the paper prints it and as its authors meant it, beside the rule that we use.

The paper's section on stroke segmentation has two equations, 12 and 13, dz/dt > theta and |z -
mu_z| < sigma, and says that together they tell when a stroke has ended: the pen rises fast, and is
far from the plane. It does not say what mu_z is, how the two are joined, how large theta and sigma
are, or whether z is smoothed. In the first two rules here mu_z is the mean height of the whole
recording, lifts and all; z is always the raw height over the page.

printed: the two equations to the letter, joined by *and*: a sample is off the paper where it rises
    fast and is *near* mu_z. So it ends a stroke at a fast rise only, and begins the next one in
    the air.
meant: the second inequality turned round, as the sentence before it says, joined by *or*: a sample
    is off the paper where it rises fast or is *far* from mu_z.
authors: their own program with its fixed numbers. It does not look at the first 100 samples; a
    sample from there on is a mark where z is *far* from the paper and rises *or falls* fast. The
    first mark ends a stroke, and the next one begins where its marks end, 20 samples or more before
    another. The program is told how many lifts there are, and we take all that it finds; its height
    of the paper, 0.03 m in the cameras' world, is 0 on our page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from dmp_teach.errors import RecordingError, SettingError
from dmp_teach.segmentation.even_clock import Flags, Spans, find_runs
from dmp_teach.segmentation.strokes import check_thresholds, find_strokes
from dmp_teach.trajectory import Array

# Of the authors' program.
UNSEEN_SAMPLES = 100
SAMPLES_BETWEEN_LIFTS = 20


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


StrokeRule = Callable[[Array, Array, float, float], Spans]

RULES: dict[str, StrokeRule] = {
    "foot": find_strokes,
    "printed": find_strokes_as_printed,
    "meant": find_strokes_as_meant,
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


def _rising_and_off(t: Array, position: Array, theta: float, sigma: float) -> tuple[Flags, Array]:
    """Return where the pen rises faster than theta, and how far it is from its mean height."""
    check_thresholds(theta, sigma)
    z = position[:, 2]
    return np.gradient(z, t) > theta, np.abs(z - z.mean())


def _down_spans(down: Flags) -> Spans:
    """Return runs of samples (T,) on the paper."""
    return _long_enough(find_runs(down))


def _long_enough(runs: Iterable[tuple[int, int]]) -> Spans:
    """Return the runs of two samples or more; there must be one."""
    spans = tuple((a, b) for a, b in runs if b - a >= 2)
    if not spans:
        raise RecordingError(
            "By this rule the pen is never on the paper; try a larger sigma, or rule='foot'."
        )
    return spans
