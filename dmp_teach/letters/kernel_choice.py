"""The number of kernels of a letter's strokes: more of them for letters written in a moment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dmp_teach.dmp import DMP, Settings
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Trajectory, rms

# A drawing within this share of the letter's size looks like the demonstration.
ACCEPTED_ERROR = 0.02
# Nothing that a hand does is faster [Hz].
HIGHEST_CUTOFF = 60.0
MOST_DOUBLINGS = 4


def imitate_strokes(
    strokes: Sequence[Trajectory], settings: Settings | None = None
) -> tuple[DMP, ...]:
    """Learn one primitive for each stroke.

    Without settings it takes `Settings.star()`, whose 12 kernels a second and smoothing suit the
    paper's writers; a stroke whose rollout is farther than 2 % of the letter's size from the
    demonstration, such as an a written in 0.4 s, gets twice as many kernels and twice the cutoff
    frequency, until it is near.
    """
    if settings is not None:
        return tuple(DMP.imitate(stroke, settings) for stroke in strokes)
    accepted = ACCEPTED_ERROR * size_of(strokes)
    return tuple(imitate_within(accepted, stroke, Settings.star()) for stroke in strokes)


def imitate_within(accepted: float, stroke: Trajectory, settings: Settings) -> DMP:
    """Return the primitive of as many kernels as it takes, or the nearest of those tried.

    Args:
        accepted: How far its rollout may be from the stroke, root mean square [m].
        stroke: The demonstration.
        settings: Those to begin with.
    """

    def error(primitive: DMP) -> float:
        return rms(primitive.rollout().position - stroke.position)

    tried = [DMP.imitate(stroke, settings)]
    while error(tried[-1]) > accepted and len(tried) <= MOST_DOUBLINGS:
        last = tried[-1].settings
        finer = replace(
            last,
            n_kernels=min(2 * (last.n_kernels or 1), len(stroke) - 1),
            alpha=None,
            smoothing=last.smoothing and min(2 * last.smoothing, HIGHEST_CUTOFF),
        )
        if (finer.n_kernels, finer.smoothing) == (last.n_kernels, last.smoothing):
            break
        tried.append(DMP.imitate(stroke, finer))
    return min(tried, key=error)
