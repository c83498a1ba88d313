"""Strokes learned finely enough: what was written in a moment has as many bends as what took a second."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach.dmp import DMP, Settings
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Trajectory

NEAR = (
    0.02  # a letter that is drawn within this share of its size looks like the one that was shown
)
FINEST = 60.0  # [Hz]: nothing that a hand does is faster
DOUBLED = 4  # times


def imitated(strokes: Sequence[Trajectory], settings: Settings | None = None) -> tuple[DMP, ...]:
    """One primitive for each stroke.

    Args:
        strokes: What was shown.
        settings: As they are given. None takes `Settings.star()`, whose 12 kernels a second and whose idea of what is
            trembling suit the paper's writers; a stroke that they draw farther off than 2 % of the letter's size, as
            of a hand that wrote an a in 0.4 s, is learned with twice as many kernels, and twice the frequency, until
            it is near.
    """
    if settings is not None:
        return tuple(DMP.imitate(stroke, settings) for stroke in strokes)
    near = NEAR * size_of(strokes)
    return tuple(_finely(stroke, near) for stroke in strokes)


def _finely(stroke: Trajectory, near: float) -> DMP:
    """The stroke with as many kernels as it takes to be so near [m], if that can be."""
    tried = [DMP.imitate(stroke)]
    while _off(tried[-1], stroke) > near and len(tried) <= DOUBLED:
        last = tried[-1].settings
        finer = Settings.star(
            n_kernels=min(2 * last.n_kernels, len(stroke) - 1),
            smoothing=min(2 * last.smoothing, FINEST),
        )
        if (finer.n_kernels, finer.smoothing) == (last.n_kernels, last.smoothing):
            break
        tried.append(DMP.imitate(stroke, finer))
    return min(tried, key=lambda primitive: _off(primitive, stroke))


def _off(primitive: DMP, stroke: Trajectory) -> float:
    """Root mean square distance of what it draws from what was shown [m]."""
    return float(
        np.sqrt(((primitive.rollout().position - stroke.position) ** 2).sum(axis=1).mean())
    )
