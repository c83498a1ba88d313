"""Where no kernel is active, in a sentence."""

from __future__ import annotations

import numpy as np

from dmp_teach.arguments import warn_caller
from dmp_teach.dmp.kernels import KERNELS, Cells, Overlap
from dmp_teach.dmp.settings import Settings
from dmp_teach.errors import SettingWarning

# Gaps that are named one by one.
NAMED_GAPS = 3


def note_gaps(kernels: Cells | Overlap, settings: Settings, duration: float) -> tuple[str, ...]:
    """Note, and warn of (`SettingWarning`), when f is 0 for want of a kernel, and the cure."""
    if isinstance(kernels, Cells) and kernels.psi is None:
        # Touching boxes.
        return ()
    bare = kernels.inactive
    if not bare.any():
        return ()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], bare, [False]]).astype(int)))
    gaps = edges.reshape(-1, 2) * duration / len(bare)
    times = ", ".join(f"{begin:.3f} to {end:.3f} s" for begin, end in gaps[:NAMED_GAPS])
    more = f" and {len(gaps) - NAMED_GAPS} more times" if len(gaps) > NAMED_GAPS else ""
    note = (
        f"Kernels leave gaps: f is 0 in {100 * bare.mean():.3g} % of the movement, at "
        f"{times}{more} from its start. "
        f"{KERNELS[settings.kernel].cure_for_gaps(settings.kernel_width)}"
    )
    warn_caller(note, SettingWarning, calls=2)
    return (note,)
