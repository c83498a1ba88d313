"""Add pen lifts between strokes of flat ink, as a hand makes them: up, over and down again."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.errors import RecordingError
from dmp_teach.ink.recording import About, Recording
from dmp_teach.trajectory import Array, Trajectory

# How high a pen goes between two strokes [m], and how long it takes to get there [s].
LIFT_HEIGHT = 0.02
LIFT_RISE = 0.25
# However long a lift was, it gets no more samples than this.
MOST_LIFT_SAMPLES = 6000


def add_lifts(
    strokes: Sequence[Trajectory],
    pressures: Sequence[ArrayLike] | None = None,
    **about: Unpack[About],
) -> Recording:
    """Make a recording of strokes from a flat pad, which saw nothing of the pen in the air.

    On the paper the height is 0. Between two strokes, where there is time, the pen goes over with
    minimum jerk (Flash and Hogan 1985), up to 20 mm high; its samples are as far apart as those of
    the strokes.

    Args:
        strokes: 2-D, on one clock, each after the one before [m].
        pressures: How hard the pen was pressed, 0 to 1, shape (T,) for each stroke; None where
            unknown.
        **about: The recording's `character`, `writer` and `baseline`.

    Returns:
        A recording that keeps the strokes as they are given; the pressure of a lift is 0.

    Raises:
        RecordingError: No stroke, one that is not 2-D, strokes that overlap in time, or a pressure
            that cannot be.
    """
    _check(strokes)
    step = float(np.median(np.concatenate([np.diff(stroke.t) for stroke in strokes])))
    pieces: list[Array] = []
    force: list[ArrayLike] = []
    spans: list[tuple[int, int]] = []
    count = 0
    for k, stroke in enumerate(strokes):
        if k:
            lift = _lift(strokes[k - 1], stroke, step)
            pieces.append(lift)
            force.append(np.zeros(len(lift)))
            count += len(lift)
        pieces.append(np.column_stack([stroke.t, stroke.position, np.zeros(len(stroke))]))
        force.append(np.zeros(0) if pressures is None else pressures[k])
        spans.append((count, count + len(stroke)))
        count += len(stroke)
    samples = np.concatenate(pieces)
    pressure = None if pressures is None else np.concatenate(force)
    return Recording(
        samples[:, 0], samples[:, 1:], given_strokes=tuple(spans), pressure=pressure, **about
    )


def _lift(before: Trajectory, after: Trajectory, step: float) -> Array:
    """Return the samples (K, 4), t x y z, between two strokes; none where there is no time."""
    begin, end = before.t[-1], after.t[0]
    count = round(min((end - begin) / step, MOST_LIFT_SAMPLES)) - 1
    t = np.linspace(begin, end, max(count, 0) + 2)[1:-1]
    share = (t - begin) / (end - begin)
    rise = min(LIFT_RISE, (end - begin) / 2)
    xy = before.position[-1] + _eased(share)[:, None] * (after.position[0] - before.position[-1])
    height = LIFT_HEIGHT * _eased(np.minimum(np.minimum(t - begin, end - t) / rise, 1.0))
    return np.column_stack([t, xy, height])


def _eased(share: Array) -> Array:
    """Return shares of a minimum-jerk movement from 0 to 1."""
    return share**3 * (10 - 15 * share + 6 * share**2)


def _check(strokes: Sequence[Trajectory]) -> None:
    """Raise a RecordingError that names the stroke that breaks a rule."""
    if not len(strokes):
        raise RecordingError("There is no stroke, but a letter has at least one.")
    for number, stroke in enumerate(strokes):
        if not isinstance(stroke, Trajectory) or stroke.dimensions != 2:
            raise RecordingError(
                f"Stroke {number} is {stroke!r}, but must be a 2-D Trajectory: right and up [m]."
            )
    for number, (before, after) in enumerate(pairwise(strokes), start=1):
        if after.t[0] <= before.t[-1]:
            raise RecordingError(
                f"Stroke {number} begins at {after.t[0]} s, but stroke {number - 1} ends at "
                f"{before.t[-1]} s; strokes must follow each other on one clock."
            )
