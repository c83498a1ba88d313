"""Where no kernel is awake, in a sentence."""

from __future__ import annotations

import warnings

import numpy as np

from dmp_teach.dmp.kernels import Cells, Overlap
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingWarning

NAMED = 3  # gaps that are named one by one


def asleep(kernels: Cells | Overlap, settings: Settings, duration: float) -> tuple[str, ...]:
    """A note, and a `SettingWarning`, that say when f is 0 for want of a kernel; nothing if it never is.

    Args:
        kernels: Laid over the steps of the movement.
        settings: Where the cure is looked for.
        duration: Of the movement [s].
    """
    if isinstance(kernels, Cells) and kernels.psi is None:
        return ()  # touching boxes
    bare = kernels.asleep
    if not bare.any():
        return ()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], bare, [False]]).astype(int))).reshape(
        -1, 2
    )
    times = [
        f"{a * duration / len(bare):.3f} to {b * duration / len(bare):.3f} s"
        for a, b in edges[:NAMED]
    ]
    more = f" and {len(edges) - NAMED} more times" if len(edges) > NAMED else ""
    words = (
        f"Kernels leave gaps: f is 0 in {100 * bare.mean():.3g} % of the movement, at {', '.join(times)}{more} "
        f"from its start. {_cure(settings)}"
    )
    warnings.warn(words, SettingWarning, stacklevel=3)
    return (words,)


def _cure(settings: Settings) -> str:
    """What closes the gaps."""
    if settings.kernel == "mollifier":
        return "A mollifier is 0 at its ends: give it a kernel_width over 1, 2 for instance."
    if settings.kernel_width < 1:
        return "A kernel_width of 1 or more closes them."
    return "kernel_centers='middles' closes them."
