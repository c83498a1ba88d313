"""The formulations that a study compares, each by a name."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Unpack

import numpy as np

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, KERNELS, SettingChanges, Settings
from dmp_teach.trajectory import Trajectory, rms
from dmp_teach.values import Value

# The paper's N = Num/10, as a share of the samples.
PAPER_SHARE = 0.1


@dataclass(frozen=True, eq=False, repr=False)
class Variant(Value):
    """Settings whose number of kernels may follow the stroke.

    Args:
        settings: Everything but the number of kernels.
        share: Kernels for each sample, such as 0.1 for Num/10; None: as the settings say, but no
            more than samples.
    """

    settings: Settings
    share: float | None = PAPER_SHARE

    @checked
    def on(self, path: Trajectory, **changes: Unpack[SettingChanges]) -> Settings:
        """Return the settings for one stroke."""
        number = self.settings.n_kernels
        if self.share is not None:
            number = max(1, round(self.share * len(path)))
        elif number is not None:
            number = min(number, len(path))
        return replace(replace(self.settings, n_kernels=number), **changes)


AS_PRINTED_FIT: SettingChanges = {"sharpen": False, "feed_goal": False}

WIDTH_VARIANTS: Mapping[str, Variant] = {
    "the authors' 200 kernels": Variant(
        Settings.as_fixed(
            n_kernels=200, alpha=25.0, derivatives="inverse", start_velocity="fitted"
        ),
        share=None,
    ),
    "the authors' program": Variant(
        Settings.as_coded(n_kernels=200, kernel_spread=0.02, kernel_floor=1e-10), share=None
    ),
    "Gaussian, LWR": Variant(Settings.as_fixed()),
    "Gaussian, joint": Variant(Settings.joint()),
    "box, LWR": Variant(Settings.star(**AS_PRINTED_FIT)),
    "box, local bias": Variant(Settings.plus(**AS_PRINTED_FIT)),
    "box, joint": Variant(Settings.joint(kernel_sigma=math.inf)),
    "mollifier, LWR": Variant(Settings.star(kernel="mollifier", sharpen=False, feed_goal=False)),
}
"""Kernel kinds and fits for error against width; N = Num/10 except for the authors' own 200.

The first has the authors' constants (N = 200, sigma 4/N, LWR, a soft spring) in the paper's mended
formulas, the second is their program with the kernels of its class that has several widths: sigma
0.02, and 1e-10 beyond their ends. Gaussians have sigma 4/N, with the joint fit 0.65/N.
"""

NUMBER_VARIANTS: Mapping[str, Variant] = {
    "the authors' program": Variant(Settings.as_coded()),
    "soft spring": Variant(Settings.as_fixed(alpha=25.0)),
    "spring as stiff as 2 N": Variant(Settings.as_fixed()),
    "our DMP*": Variant(Settings.star()),
}
"""Formulations for error against N, with kernels of width 1/N, but 2/N in the authors' program."""


def rms_error(path: Trajectory, settings: Settings) -> float:
    """Return the rms distance of the learned stroke from its demonstration, at equal times [m]."""
    return both_errors(path, settings)[0]


def both_errors(path: Trajectory, settings: Settings) -> tuple[float, float]:
    """Return the rms distance and the sum of distances, the paper's Euclidean error [m]."""
    apart = DMP.imitate(path, settings).rollout().position - path.position
    return rms(apart), float(np.linalg.norm(apart, axis=1).sum())


def has_ends(settings: Settings, width: float) -> bool:
    """Return whether these kernels may have this width: some must end somewhere."""
    return KERNELS[settings.kernel].endless or math.isfinite(width)
