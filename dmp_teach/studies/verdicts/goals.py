"""The paper's claims about goals, each computed from a study; as in `kernels`."""

from __future__ import annotations

import numpy as np

from dmp_teach.dmp import DMP
from dmp_teach.errors import SettingError
from dmp_teach.studies.inputs import named_strokes
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Judgement,
    as_times,
    claim,
    mm,
    per_cent,
)
from dmp_teach.studies.verdicts.evidence import Evidence


@claim(
    "goal changes",
    "DMP* keeps the shape when the goal moves by 0.01 m and 0.1 m; the original mirrors letters.",
)
def goal_changes(evidence: Evidence) -> Judgement:
    """Judge whether DMP* keeps the shape and the original does not, for both shifts of the goal.

    DMP* keeps it if it turns no coordinate over and stays within the shift of the demonstration
    (root mean square, and a tenth more), everywhere. The original loses it if it turns one over or
    gets farther than twice the shift.
    """
    cases, words = {}, []
    for changes, shift in ((evidence.small_shifts, "0.01 m"), (evidence.large_shifts, "0.1 m")):
        star, distance = changes.values("star"), changes.values("distance")
        farthest = changes.values("original_farthest").max(initial=0.0)
        kept = (star <= 1.1 * distance).all() and not changes.turned_over
        far = farthest > 2 * distance.max(initial=0.0)
        lost = changes.values("original_turned_over").any() or far
        cases[f"goals moved by {shift}"] = bool(kept and lost)
        words.append(
            f"{shift}: DMP* at most {mm(star.max(initial=0.0))} off and {changes.turned_over} "
            f"turned over, the original mirrors {changes.mirrored} of {len(changes.cases)} and "
            f"gets {mm(farthest)} away"
        )
    return cases, f"{'; '.join(words)}.", evidence.borrowed


@claim(
    "goal on the start", "With goal equal to start, the original system stays at x_0 all the time."
)
def goal_on_start(evidence: Evidence) -> Judgement:
    """Judge whether the original form stays at x_0 where its goal is its start.

    No stroke that it can learn gets 0.001 mm away.
    """
    farthest = []
    for stroke in named_strokes(evidence.open_letters):
        try:
            learned = DMP.imitate(stroke.path, evidence.original)
        except SettingError:
            # It ends where it began in some coordinate, so there is nothing to divide by.
            continue
        drawn = learned.rollout(goal=learned.start).position
        farthest.append(float(np.linalg.norm(drawn - learned.start, axis=1).max()))
    stay = sum(f <= 1e-6 for f in farthest)
    verdict = HOLDS if stay == len(farthest) else DEPENDS if stay else FAILS
    figure = (
        f"{stay} of {len(farthest)} strokes stay; the farthest gets "
        f"{mm(max(farthest, default=0.0))} away."
    )
    why = "the form and its settings"
    if verdict == HOLDS:
        why = "every stroke that the original form can learn"
    return verdict, figure, why + evidence.borrowed


@claim(
    "huge accelerations",
    "With the original form and g close to x_0, a small change of g causes accelerations that "
    "break robot limits.",
)
def huge_accelerations(evidence: Evidence) -> Judgement:
    """Judge whether near x_0 a small change of g breaks the robot's limits, and not with DMP*.

    Of the strokes that the Fetch's joints can follow as shown, at least half can no longer once the
    goal, 5, 2, 1 or 0.5 mm from the start, moves by 10 mm; with DMP* all still can. A case for each
    distance.
    """
    near = evidence.closeness
    cases, words = {}, []
    for way, growth, broken in zip(near.ways, near.growth, near.broken, strict=True):
        if way < near.shift / 1.5:
            cases[f"g {mm(way)} from the start"] = bool(broken[0] >= 0.5 and broken[1] == 0)
        words.append(f"{mm(way)}: {as_times(growth[0])}, {per_cent(broken[0])}")
    figure = (
        "By the goal's distance, how many times larger the acceleration gets with the original "
        f"form and how many strokes pass a joint's limit: {', '.join(words)}. DMP*: "
        f"{as_times(near.growth[:, 1].max())}, {per_cent(near.broken[:, 1].max())}."
    )
    return cases, figure, evidence.borrowed


@claim("decay term", "The decay term -K (g - y0) s avoids jumps at the beginning of the movement.")
def decay_term(evidence: Evidence) -> Judgement:
    """Judge whether the decay term avoids jumps at the beginning.

    It leaves at most a tenth of what a moved goal adds to the first acceleration. A case as
    printed; another with the change of the goal fed forward, as our `star` does.
    """
    first = evidence.first
    printed = (first.with_term / first.without).max()
    fed = (first.fed / first.without).max()
    cases = {"as printed": bool(printed <= 0.1), "goal fed forward": bool(fed <= 0.1)}
    figure = (
        f"A goal that moves by {mm(first.shift)} adds {np.median(first.without):.2g} m/s2 to the "
        f"first sample without the term, {np.median(first.with_term):.2g} with it, "
        f"{np.median(first.fed):.2g} with the goal fed forward (at most {per_cent(printed)} and "
        f"{per_cent(fed)} of that without)."
    )
    return cases, figure, ""
