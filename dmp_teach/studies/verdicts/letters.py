"""The paper's claims about goals and letters, each computed from a study. Thresholds are said in each docstring.

Each takes recordings (or files, or strokes; None for our own alphabets; or `Evidence`) and gives a `Claim`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dmp_teach.dmp import DMP
from dmp_teach.errors import SettingError
from dmp_teach.studies.authorship.answers import Answers
from dmp_teach.studies.authorship.made import question
from dmp_teach.studies.experiments.stroke_segmentation import NEAR
from dmp_teach.studies.inputs import strokes_of
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Claim,
    judged,
    mm,
    per_cent,
    times,
)
from dmp_teach.studies.verdicts.evidence import evidence_of

SURE = 0.05  # a guess that hits so often or more is this improbable at most


def goal_changes(recordings: Any = None) -> Claim:
    """DMP* keeps the shape and the original does not, for goals moved by 0.01 m and by 0.1 m.

    DMP* keeps it if it turns no coordinate over and stays within the shift of the demonstration (root mean square, and
    a tenth more), everywhere. The original loses it if it turns one over or gets farther than twice the shift.
    """
    evidence = evidence_of(recordings)
    cases, words = {}, []
    for changes, what in ((evidence.small_shifts, "0.01 m"), (evidence.large_shifts, "0.1 m")):
        kept = (
            changes.values("star") <= 1.1 * changes.values("distance")
        ).all() and not changes.turned_over
        farthest = changes.values("original_farthest").max(initial=0.0)
        lost = changes.values("original_turned_over").any() or farthest > 2 * changes.values(
            "distance"
        ).max(initial=0.0)
        cases[f"goals moved by {what}"] = bool(kept and lost)
        words.append(
            f"{what}: DMP* at most {mm(changes.values('star').max(initial=0.0))} off and {changes.turned_over} turned "
            f"over, the original mirrors {changes.mirrored} of {len(changes.cases)} and gets {mm(farthest)} away"
        )
    verdict, why = judged(cases)
    said = "DMP* keeps the shape when the goal moves by 0.01 m and 0.1 m; the original mirrors letters."
    return Claim(
        "goal changes",
        said,
        verdict,
        f"{'; '.join(words)}.",
        why + evidence.borrowed,
        _call("goal_changes", evidence),
    )


def d_becomes_p(recordings: Any = None) -> Claim:
    """D becomes P by moving the goal of its bowl, with DMP*: recognisable (`MadeLetter.recognisable`) in nine of ten.

    HOLDS if the bowl is besides within 5 % of the bar (median) of the D's own bowl turned and scaled; sheared more than
    that, it DEPENDS ON how neat a P must be. Our own D is taken where nobody wrote one in two strokes.
    """
    evidence = evidence_of(recordings)
    made = evidence.new_letters
    words = []
    for way in made.ways:
        items = made.by(way)
        good = [item for item in items if item.recognisable]
        dips = (
            f", dipping {mm(float(np.median([i.overshoot for i in good])))} under its goal"
            if good
            else ""
        )
        shear = (
            f" and {mm(float(np.median([i.shear for i in good])))} off a turned bowl"
            if good
            else ""
        )
        words.append(f"{way}: {len(good)} of {len(items)} are a P{dips}{shear}")
    star = made.by("DMP*")
    clear = np.mean([item.recognisable for item in star]) >= 0.9
    neat = bool(np.median([item.shear / item.height for item in star]) <= 0.05)
    verdict = (HOLDS if neat else DEPENDS) if clear else FAILS
    why = {
        HOLDS: "every D that was tried",
        FAILS: "P that were not built like one",
        DEPENDS: "how neat a P must be",
    }
    tail = "; our own D, since no D of two strokes was given" if made.borrowed else ""
    said = "A D becomes a P when the goal of its second stroke moves."
    return Claim(
        "D becomes P",
        said,
        verdict,
        f"{'; '.join(words)}.",
        why[verdict] + tail,
        _call("d_becomes_p", evidence),
    )


def strokes_from_height(recordings: Any = None) -> Claim:
    """Strokes are found from dz/dt and z: count and all ends right in at least 0.9 of the recordings with a lift.

    An end is right within 0.05 s of the given strokes, or of the local rule's where the source gives none. Below half
    it DOES NOT HOLD, between it DEPENDS ON the writer. Where no recording has a lift, our own alphabet is taken.
    """
    evidence = evidence_of(recordings)
    items, borrowed = evidence.lifts.items, ""
    if not items:
        items, borrowed = (
            evidence_of(None).lifts.items,
            "; our own letters, since no recording has a lift",
        )
    right, count = (
        sum(i.authors.right for i in items),
        sum(i.authors.strokes == i.strokes for i in items),
    )
    steady, literal = sum(i.steady for i in items), sum(i.printed.right for i in items)
    share = right / len(items)
    verdict = HOLDS if share >= 0.9 else FAILS if share < 0.5 else DEPENDS
    figure = (
        f"The printed rule gets the number of strokes right in {count} of {len(items)} recordings, and every end to "
        f"{NEAR} s in {right}; read to the letter in {literal}. The rule of the local foot keeps its count over all "
        f"thresholds in {steady}."
    )
    why = (
        "how the writer lands: heights wander more than the threshold, and a pen sinks before it writes"
        + borrowed
    )
    said = "Strokes are told apart by dz/dt > theta and the height over the plane."
    return Claim(
        "strokes from height", said, verdict, figure, why, _call("strokes_from_height", evidence)
    )


def goal_on_start(recordings: Any = None) -> Claim:
    """The original form with its goal on its start stays at x_0: no stroke that it can learn gets 0.001 mm away."""
    evidence = evidence_of(recordings)
    farthest = []
    for stroke in strokes_of(evidence.open_letters):
        try:
            learned = DMP.imitate(stroke.path, evidence.original)
        except SettingError:
            continue  # it ends where it began in some coordinate, so that there is nothing to divide by
        drawn = learned.rollout(goal=learned.start).position
        farthest.append(float(np.linalg.norm(drawn - learned.start, axis=1).max()))
    cases = {name: sum(f <= 1e-6 for f in farthest) for name in ("strokes",)}
    verdict = (
        HOLDS if cases["strokes"] == len(farthest) else FAILS if not cases["strokes"] else DEPENDS
    )
    figure = f"{cases['strokes']} of {len(farthest)} strokes stay; the farthest gets {mm(max(farthest, default=0.0))} away."
    said = "With goal equal to start, the original system stays at x_0 all the time."
    why = (
        "every stroke that the original form can learn"
        if verdict == HOLDS
        else "the form and its settings"
    )
    return Claim(
        "goal on the start",
        said,
        verdict,
        figure,
        why + evidence.borrowed,
        _call("goal_on_start", evidence),
    )


def huge_accelerations(recordings: Any = None) -> Claim:
    """Near x_0 a small change of g breaks the robot's limits, and not with DMP*.

    Of the strokes that the Fetch's joints can follow as shown, at least half can no longer once the goal, 5, 2, 1 or
    0.5 mm from the start, moves by 10 mm; with DMP* all still can. A case for each distance.
    """
    evidence = evidence_of(recordings)
    near = evidence.closeness
    cases = {}
    for way, (original, star) in zip(near.ways, near.broken, strict=True):
        if way < near.shift / 1.5:
            cases[f"g {mm(way)} from the start"] = bool(original >= 0.5 and star == 0)
    words = ", ".join(
        f"{mm(way)}: {times(growth[0])}, {per_cent(broken[0])}"
        for way, growth, broken in zip(near.ways, near.growth, near.broken, strict=True)
    )
    verdict, why = judged(cases)
    figure = (
        f"By the goal's distance, how many times larger the acceleration gets with the original form and how many "
        f"strokes pass a joint's limit: {words}. DMP*: {times(near.growth[:, 1].max())}, "
        f"{per_cent(near.broken[:, 1].max())}."
    )
    said = "With the original form and g close to x_0, a small change of g causes accelerations that break robot limits."
    return Claim(
        "huge accelerations",
        said,
        verdict,
        figure,
        why + evidence.borrowed,
        _call("huge_accelerations", evidence),
    )


def decay_term(recordings: Any = None) -> Claim:
    """The decay term avoids jumps at the beginning.

    It leaves at most a tenth of what a moved goal adds to the first acceleration. A case as printed; another with the
    change of the goal fed forward, as our `star` does.
    """
    evidence = evidence_of(recordings)
    first = evidence.first
    parts = {
        "as printed": first.with_term / first.without,
        "goal fed forward": first.fed / first.without,
    }
    verdict, why = judged({name: bool(part.max() <= 0.1) for name, part in parts.items()})
    figure = (
        f"A goal that moves by {mm(first.shift)} adds {np.median(first.without):.2g} m/s2 to the first sample without "
        f"the term, {np.median(first.with_term):.2g} with it, {np.median(first.fed):.2g} with the goal fed forward (at "
        f"most {per_cent(parts['as printed'].max())} and {per_cent(parts['goal fed forward'].max())} of that without)."
    )
    said = "The decay term -K (g - y0) s avoids jumps at the beginning of the movement."
    return Claim("decay term", said, verdict, figure, why, _call("decay_term", evidence))


def redrawn_letters(recordings: Any = None) -> Claim:
    """a, b, e and m are redrawn nearly identical: rms at most 1 % of the letter's size, nowhere more than 3 %.

    A case for each letter; all that were recorded where none of the four was.
    """
    evidence = evidence_of(recordings)
    cases, words = {}, []
    items = evidence.redrawn.items
    for letter in dict.fromkeys(item.letter.character for item in items):
        own = [item for item in items if item.letter.character == letter]
        mean = max(item.error / item.letter.size for item in own)
        most = max(item.largest / item.letter.size for item in own)
        cases[letter] = bool(mean <= 0.01 and most <= 0.03)
        words.append(
            f"{letter} {mm(max(i.error for i in own))} ({per_cent(mean)}), largest {per_cent(most)}"
        )
    verdict, why = judged(cases)
    figure = f"Worst of each letter, rms and in parts of its size: {'; '.join(words)}."
    said = "The letters a, b, e and m are reproduced in nearly identical shapes."
    return Claim("redrawn letters", said, verdict, figure, why, _call("redrawn_letters", evidence))


def accuracy_and_efficiency(recordings: Any = None) -> Claim:
    """Kernels well chosen improve accuracy (error at most 0.8 of the original's) and efficiency (time at most 0.9).

    Both at N = Num/10. Time is measured, once in a process.
    """
    evidence = evidence_of(recordings)
    found = evidence.against
    error = (
        float(np.median(found.error[:, 0] / found.error[:, 1])) if len(found.strokes) else np.inf
    )
    verdict, why = judged(
        {"accuracy": error <= 0.8, "time on this computer": found.time_ratio <= 0.9}
    )
    star, original = np.median(found.error, axis=0) if len(found.strokes) else (np.inf, np.inf)
    figure = (
        f"Over {len(found.strokes)} strokes DMP* makes {per_cent(error)} of the original's error ({mm(star)} against "
        f"{mm(original)}) in {per_cent(found.time_ratio)} of its time."
    )
    said = "The choice of number and shape of kernels improves both accuracy and efficiency."
    return Claim(
        "accuracy and efficiency",
        said,
        verdict,
        figure,
        why + evidence.borrowed,
        _call("accuracy_and_efficiency", evidence),
    )


def any_ink(recordings: Any = None) -> Claim:
    """Any shape, scale, strokes and ends: random ink within 2 % of its size, moved goals missed by at most 2 %.

    Medians; a case for each rate at which the pen turns. The ink is random, so recordings do not matter.
    """
    evidence = evidence_of(recordings)
    ink = evidence.shapes
    error, miss = np.median(ink.error, axis=2).max(axis=0), np.median(ink.miss, axis=2).max(axis=0)
    cases = {
        f"{rate:g} turns a second": bool(e <= 0.02 and m <= 0.02)
        for rate, e, m in zip(ink.rates, error, miss, strict=True)
    }
    verdict, why = judged(cases)
    words = ", ".join(
        f"{per_cent(e)} at {rate:g} Hz" for rate, e in zip(ink.rates, error, strict=True)
    )
    figure = f"Worst kind of ink by turns a second: {words} of its size; moved goals missed by {per_cent(miss.max())}."
    said = "Trajectories of arbitrary shape, scale, strokes, starting and ending positions are learned."
    return Claim("any shape", said, verdict, figure, why, _call("any_ink", evidence))


def writing_style(recordings: Any = None) -> Claim:
    """New letters have a similar style: bowls that DMP* led to other ends are given to their writer beyond chance.

    HOLDS if all four questions are (less than 5 % by luck): with the ends of the recipe and with varied ends, as drawn
    and less what the recipe does to everybody. DOES NOT HOLD if none hits more often than a guess would, else it
    DEPENDS ON the number of writers and on what is compared.
    """
    evidence = evidence_of(recordings)
    hands, real = evidence.hands, evidence.real_hands
    asked = [
        hands[question("DMP*", varied, less)] for less in (True, False) for varied in (False, True)
    ]
    sure = [each.luck <= SURE for each in asked]
    verdict = (
        HOLDS
        if all(sure)
        else FAILS
        if not any(each.rate > each.chance for each in asked)
        else DEPENDS
    )
    control = hands[question("original", False, True)]
    told = [
        f"{each.question} {per_cent(each.rate)} (by luck {each.luck:.2g})"
        for each in real
        if each.items
    ]
    figure = (
        f"Bowls that DMP* led, given to the right one of {len(asked[0].writers)} writers less everybody's mean: "
        f"{_rate(asked[0])}, with varied ends {_rate(asked[1])}; as drawn {_rate(asked[2])} and {_rate(asked[3])}. A "
        f"guess: {per_cent(asked[0].chance)}; the original form: {_rate(control)}. "
        f"Real letters told apart: {', '.join(told) or 'none could be asked'}."
    )
    borrowed = (
        "; our own letters, as there are no two writers' bowls to lead" if hands.borrowed else ""
    )
    why = (
        "the number of writers, and on whether what the recipe does to everybody is taken away"
        + borrowed
    )
    said = "New letters have a writing style similar to that of the demonstrations."
    return Claim("writing style", said, verdict, figure, why, _call("writing_style", evidence))


def _rate(answers: Answers) -> str:
    """A rate with its spread."""
    low, high = answers.interval
    return f"{per_cent(answers.rate)} [{100 * low:.0f}, {100 * high:.0f}]"


def _call(name: str, evidence: Any) -> str:
    """The line that makes a figure again."""
    return f"teach.studies.{name}({evidence.argument}).figure"
