"""The paper's claims about goals, by each reading of the paper; as in `kernels`."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from dmp_teach.studies.readings import Reading
from dmp_teach.studies.verdicts.claim import Found, as_times, claim_by_reading, mm, per_cent
from dmp_teach.studies.verdicts.evidence import Evidence

# A form that is farther off its own demonstrations, in parts of their size, keeps no shape.
BARELY_DRAWN = 0.05


@claim_by_reading(
    "goal changes",
    "DMP* keeps the shape when the goal moves by 0.01 m and 0.1 m; the original mirrors letters.",
    "How far DMP* gets from the demonstration at most (and how often it turns over), and how often "
    "the original mirrors (and how far it gets)",
)
def goal_changes(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether DMP* keeps the shape and the original does not, for both shifts of the goal.

    DMP* keeps it if it turns no coordinate over and stays within the shift of the demonstration
    (root mean square, and a tenth more), everywhere: a reading that does not draw the stroke with
    its own goal does not, either. The original loses it if it turns one over or gets farther than
    twice the shift.
    """
    cases, words = {}, []
    for shift in (0.01, 0.1):
        changes = evidence.shifts(reading, shift)
        star, distance = changes.values("star"), changes.values("distance")
        farthest = changes.values("original_farthest").max(initial=0.0)
        kept = (star <= 1.1 * distance).all() and not changes.turned_over
        far = farthest > 2 * distance.max(initial=0.0)
        mirrored = changes.values("original_turned_over").sum()
        cases[f"goals moved by {shift:g} m"] = bool(kept and (mirrored or far))
        words.append(
            f"{mm(star.max(initial=0.0))} ({changes.turned_over}) and {mirrored} of "
            f"{len(changes.cases)} ({mm(farthest)})"
        )
    figure = " at 0.01 m, ".join(words) + " at 0.1 m"
    own = float(np.median(evidence.errors(reading.star)))
    if own > BARELY_DRAWN:
        figure += f", where it draws the strokes themselves {per_cent(own)} of their size off"
    return Found(
        cases, figure, len(evidence.open_strokes), evidence.strokes_open, warning=evidence.borrowed
    )


@claim_by_reading(
    "goal on the start",
    "With goal equal to start, the original system stays at x_0 all the time.",
    "How many strokes stay, and how far the others get, with a start velocity that grows with the "
    "way to the goal (all stay by construction), and with that of the demonstration",
)
def goal_on_start(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether the original form stays at x_0 where its goal is its start.

    No stroke that it can learn gets 0.001 mm away. The paper gives the start velocity to the
    system beside the goal and does not say what becomes of it: two cases. One that grows with the
    way is 0 here, so that all is 0 by construction, as the figure says.
    """
    usual = reading.original.start_velocity
    grows = "measured" if usual == "kept" else usual
    cases, words = {}, []
    for name, velocity in (("a velocity that grows with the way", grows), ("one kept", "kept")):
        far = evidence.strays(replace(reading.original, start_velocity=velocity))
        stay = int((far <= 1e-6).sum())
        cases[name] = stay == len(far)
        words.append(f"{stay} of {len(far)} ({mm(far.max(initial=0.0))})")
    return Found(
        cases,
        ", ".join(words),
        len(evidence.open_strokes),
        evidence.strokes_open,
        warning=evidence.borrowed,
    )


@claim_by_reading(
    "huge accelerations",
    "With the original form and g close to x_0, a small change of g causes accelerations that "
    "break robot limits.",
    "How many times larger the acceleration gets with the original form, and how many strokes pass "
    "a joint's limit, by the goal's distance from the start; and the same with DMP*",
)
def huge_accelerations(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether near x_0 a small change of g breaks the robot's limits, and not with DMP*.

    Of the strokes that the Fetch's joints can follow as a form draws them, at least half can no
    longer once the goal, 5 or 0.5 mm from the start, moves by 10 mm; with DMP* all still can. A
    case for each distance.
    """
    near = evidence.closeness(reading)
    cases, words = {}, []
    for way, growth, broken in zip(near.ways, near.growth, near.broken, strict=True):
        cases[f"g {mm(way)} from the start"] = bool(broken[0] >= 0.5 and broken[1] == 0)
        words.append(f"{as_times(growth[0])}, {per_cent(broken[0])} at {mm(way)}")
    star = f"{as_times(near.growth[:, 1].max())}, {per_cent(near.broken[:, 1].max())} with DMP*"
    n = len(evidence.open_strokes)
    return Found(
        cases, ", ".join([*words, star]), n, evidence.strokes_open, warning=evidence.borrowed
    )


@claim_by_reading(
    "decay term",
    "The decay term -K (g - y0) s avoids jumps at the beginning of the movement.",
    "What a moved goal adds to the acceleration of the first sample without the term, and with it "
    "(0 by construction, if the goal is not fed forward)",
)
def decay_term(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether the decay term avoids jumps at the beginning.

    It leaves at most a tenth of what a moved goal adds to the first acceleration, with the change
    of the goal fed forward as the reading has it. As the paper has it, it leaves K o (1 - s) for a
    change o of the goal, which is 0 at s = 1 by construction, whatever the stroke is.
    """
    first = evidence.first(reading)
    left = first.fed if reading.star.feed_goal else first.with_term
    worst = (left / first.without).max()
    figure = (
        f"{np.median(first.without):.2g} and {np.median(left):.2g} m/s2, at most {per_cent(worst)}"
    )
    fed = ", the goal fed forward" * reading.star.feed_goal
    return Found(bool(worst <= 0.1), figure + fed, len(left), evidence.strokes)
