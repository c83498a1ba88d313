"""Slow the pen where a joint would exceed a limit, and only there.

The path stays and the clock changes: path and speed along it are found apart, and the most hurried
joint limits the speed at each place (Bobrow, Dubowsky and Gibson 1985). Between limited and
unlimited places the clock changes its rate smoothly; how it does is ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import scipy

from dmp_teach.robot.pen_path import MOTION_RATE, PenPath
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

SPEED_SHARE = 0.9
"""No joint goes faster than this part of its limit; where one would, the pen is slowed."""

EASING = 0.1
"""The clock needs so long, on the unhurried plan, to change its rate, and as long before [s]."""

# The part of what is allowed that is aimed at: the joints are solved anew on the new clock.
_SPARE = 0.995


class TimeScaling:
    """When each sample of an unhurried plan is due.

    Wherever the path rests there stays a sample, so that a stroke still begins and ends on one.
    """

    def __init__(self, path: PenPath, joint_names: Sequence[str]) -> None:
        self._path = path
        self._names = joint_names
        self._needed = np.ones((path.rests[-1] + 1, len(joint_names)))
        self.samples = np.arange(path.rests[-1] + 1.0)
        """Which sample of the unhurried plan is due at each sample, in fractions too, (T,)."""

    def slow_down(self, longer: Array) -> bool:
        """Slow the clock where a joint cannot follow; return whether there was such a place.

        `longer` (T - 1, J) is how much longer each joint must take from each of the present samples
        to the next, as a part of what it takes now; where that is at most 1 it takes no longer.
        """
        rows, joints = np.nonzero(longer > 1)
        if not len(rows):
            return False
        before, after = self.samples[rows], self.samples[rows + 1]
        wanted = longer[rows, joints] / (after - before) / _SPARE
        for beside in (np.floor(before), np.ceil(after)):
            np.maximum.at(self._needed, (beside.astype(int), joints), wanted)
        needed = self._needed.max(axis=1)
        rests = self._path.rests
        parts = [
            start + find_due_samples(compute_lateness(needed[start : stop + 1]))
            for start, stop in pairwise(rests)
        ]
        self.samples = np.concatenate([*(part[:-1] for part in parts), parts[-1][-1:]])
        return True

    @property
    def notes(self) -> tuple[str, ...]:
        """From what to what the plan was slowed, and by which joints: one sentence, or none."""
        worst = self._needed.max(axis=0)
        names = ", ".join(self._names[joint] for joint in np.argsort(-worst) if worst[joint] > 1)
        before, after = self._path.rests[-1] / MOTION_RATE, (len(self.samples) - 1) / MOTION_RATE
        note = _("slowed from {before:.2f} s to {after:.2f} s: {joints}")
        return (note.format(before=before, after=after, joints=names),) if names else ()


def compute_lateness(needed: Array) -> Array:
    """Return how much longer than usual each sample lasts, at least `needed` - 1, shape (n,).

    The clock's rate is the least of 1 / needed within `EASING` of each sample of a segment,
    averaged over as much (a Hann window): nowhere more than 1 / needed, and smooth. The time lost
    in each slowed place is rounded up to whole samples, so that those after it stay as they were.
    """
    reach = round(EASING * MOTION_RATE)
    window = np.hanning(2 * reach + 3)[1:-1]
    rate = scipy.ndimage.minimum_filter1d(1 / needed, 2 * reach + 1, mode="nearest")
    rate = scipy.ndimage.convolve1d(rate, window / window.sum(), mode="nearest")
    late = np.where(rate > 1 - 1e-9, 0.0, 1 / rate - 1)
    weights = np.r_[0.5, np.ones(len(late) - 2), 0.5]
    for (run,) in scipy.ndimage.find_objects(scipy.ndimage.label(late > 0)[0]):
        lost = (weights * late)[run].sum()
        late[run] *= np.ceil(lost) / lost
    return late


def find_due_samples(late: Array) -> Array:
    """Return which sample is due at each whole time when sample i lasts 1 + late[i], shape (m,)."""
    times = np.append(0, np.cumsum(1 + (late[1:] + late[:-1]) / 2))
    samples = scipy.interpolate.CubicHermiteSpline(times, np.arange(len(late)), 1 / (1 + late))(
        np.arange(round(times[-1]) + 1)
    )
    whole = np.round(samples)
    return np.where(np.abs(samples - whole) < 1e-6, whole, samples)
