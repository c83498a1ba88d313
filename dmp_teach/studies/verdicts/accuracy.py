"""The paper's claims that DMP* is more accurate, by each reading of the paper; as in `kernels`."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from dmp_teach.dmp import Settings
from dmp_teach.studies.experiments.variants import PAPER_SHARE
from dmp_teach.studies.readings import Reading
from dmp_teach.studies.verdicts.claim import Found, claim_by_reading, per_cent
from dmp_teach.studies.verdicts.evidence import Evidence

STATE_OF_THE_ART = {
    "the original (Ijspeert 2002)": Settings.original(),
    "DMP+ (Wang 2016, Wu 2018)": Settings.plus(),
    "DMP++ (Ginesi 2019)": Settings.star(
        transform="similarity", kernel="mollifier", kernel_width=2.0, sharpen=False
    ),
}
"""Other DMPs of the paper's time, as we have them."""


@claim_by_reading(
    "accuracy and efficiency",
    "The choice of number and shape of kernels improves both accuracy and efficiency.",
    "DMP* has so much of the error of Ijspeert's form; of that of the original form with the same "
    "kernels, spring and phase; and of the time of the same with full Gaussians",
)
def accuracy_and_efficiency(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether kernels well chosen improve accuracy and efficiency over the original form.

    Error at most 0.8 of that of `Settings.original()`, time at most 0.8 of that of full Gaussians
    with all else the same, both at N = Num/10. Time is measured, once in a process. With all else
    the same, both forms draw the same where the goal does not move: the kernels, spring and phase
    made the difference, and not the form.
    """
    star = evidence.errors(reading.star)
    usual = float(np.median(star / evidence.errors(Settings.original())))
    alike = float(np.median(star / evidence.errors(replace(reading.star, transform="original"))))
    time = evidence.time_ratio(reading)
    cases = {"accuracy": usual <= 0.8, "time on this computer": time <= 0.8}
    figure = f"{per_cent(usual)}, {per_cent(alike)}, {per_cent(time)}"
    return Found(cases, figure, len(star), evidence.strokes_open, warning=evidence.borrowed)


@claim_by_reading(
    "state of the art",
    "DMP* is a more accurate method to imitate trajectories than state-of-art DMPs.",
    "The error of DMP* as a share of that of others, and in how many strokes it is smaller",
)
def state_of_the_art(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether DMP* has less error than other DMPs of its time, in nine strokes of ten.

    N = Num/10 for all; a case for each of them.
    """
    star = evidence.errors(reading.star)
    cases, words = {}, []
    for name, settings in STATE_OF_THE_ART.items():
        ratio = star / evidence.errors(settings)
        better = float((ratio < 1).mean())
        cases[name] = better >= 0.9
        words.append(f"{per_cent(float(np.median(ratio)))} ({per_cent(better)})")
    names = ", ".join(name.split(" (")[0] for name in STATE_OF_THE_ART)
    figure = f"{', '.join(words)} of {names}"
    return Found(cases, figure, len(star), evidence.strokes_open, warning=evidence.borrowed)


@claim_by_reading(
    "linear decay",
    "A linear decay reduces the number of kernels that are needed.",
    "The error of an exponential phase with half as many kernels more, as a share of that of a "
    "linear one, with kernels at equal times and at equal phases",
)
def linear_decay(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether an exponential phase needs more kernels than a linear one.

    With 3/2 Num/10 kernels it still has more error than a linear one with Num/10; all else as in
    the reading, exp(-4.6) at the end. A case for kernels at equal times, as in Ijspeert 2002, and
    one for kernels at equal phases.
    """
    cases, words = {}, []
    for name, centers in (("equal times", "middles"), ("equal phases", "phases")):
        linear = replace(reading.star, kernel_centers=centers, phase="linear")
        slow = replace(linear, phase="exponential", phase_decay=4.6)
        more = evidence.errors(slow, share=1.5 * PAPER_SHARE)
        ratio = float(np.median(more / evidence.errors(linear)))
        cases[f"kernels at {name}"] = ratio > 1
        words.append(per_cent(ratio))
    n = len(evidence.open_strokes)
    return Found(cases, ", ".join(words), n, evidence.strokes_open, warning=evidence.borrowed)
