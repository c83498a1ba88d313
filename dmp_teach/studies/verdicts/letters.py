"""The paper's claims about letters, each computed from a study; as in `kernels`."""

from __future__ import annotations

import numpy as np

from dmp_teach.studies.authorship.answers import Answers
from dmp_teach.studies.authorship.made import question
from dmp_teach.studies.experiments.stroke_segmentation import END_TOLERANCE
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Judgement,
    claim,
    mm,
    per_cent,
)
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of

# A guess hits so often or more with at most this probability.
SIGNIFICANT_LUCK = 0.05


@claim("D becomes P", "A D becomes a P when the goal of its second stroke moves.")
def d_becomes_p(evidence: Evidence) -> Judgement:
    """Judge whether D becomes P by moving the goal of its bowl, recognisably in nine of ten.

    HOLDS if the bowl is besides within 5 % of the bar (median) of the D's own bowl turned and
    scaled; sheared more than that, it DEPENDS ON how neat a P must be. Our own D is taken where
    nobody wrote one in two strokes.
    """
    made = evidence.new_letters
    words = []
    for way in made.ways:
        items = made.by(way)
        good = [item for item in items if item.recognisable]
        quality = ""
        if good:
            dip, shear = (
                mm(float(np.median([getattr(item, name) for item in good])))
                for name in ("overshoot", "shear")
            )
            quality = f", dipping {dip} under its goal and {shear} off a turned bowl"
        words.append(f"{way}: {len(good)} of {len(items)} are a P{quality}")
    star = made.by("DMP*")
    clear = np.mean([item.recognisable for item in star]) >= 0.9
    neat = bool(np.median([item.shear / item.height for item in star]) <= 0.05)
    verdict = (HOLDS if neat else DEPENDS) if clear else FAILS
    why = {
        HOLDS: "every D that was tried",
        FAILS: "P that were not built like one",
        DEPENDS: "how neat a P must be",
    }[verdict]
    if made.borrowed:
        why += "; our own D, since no D of two strokes was given"
    return verdict, f"{'; '.join(words)}.", why


@claim(
    "strokes from height", "Strokes are told apart by dz/dt > theta and the height over the plane."
)
def strokes_from_height(evidence: Evidence) -> Judgement:
    """Judge whether dz/dt and z give the strokes: count and all ends right in 0.9 of recordings.

    An end is right within 0.05 s of the given strokes, or of the local rule's where the source
    gives none. Below half it DOES NOT HOLD, between it DEPENDS ON the writer. Where no recording
    has a lift, our own alphabet is taken.
    """
    items, borrowed = evidence.lifts.items, ""
    if not items:
        items = evidence_of(None).lifts.items
        borrowed = "; our own letters, since no recording has a lift"
    right = sum(i.authors.right for i in items)
    count = sum(i.authors.strokes == i.strokes for i in items)
    steady, literal = sum(i.steady for i in items), sum(i.printed.right for i in items)
    share = right / len(items)
    verdict = HOLDS if share >= 0.9 else FAILS if share < 0.5 else DEPENDS
    figure = (
        f"The printed rule gets the number of strokes right in {count} of {len(items)} "
        f"recordings, and every end to {END_TOLERANCE} s in {right}; read to the letter in "
        f"{literal}. The rule of the local foot keeps its count over all thresholds in {steady}."
    )
    why = (
        "how the writer lands: heights wander more than the threshold, and a pen sinks before it "
        "writes"
    )
    return verdict, figure, why + borrowed


@claim("redrawn letters", "The letters a, b, e and m are reproduced in nearly identical shapes.")
def redrawn_letters(evidence: Evidence) -> Judgement:
    """Judge whether a, b, e and m are redrawn: rms at most 1 % of their size, nowhere above 3 %.

    A case for each letter; all that were recorded where none of the four was.
    """
    cases, words = {}, []
    items = evidence.redrawn.items
    for letter in dict.fromkeys(item.letter.character for item in items):
        own = [item for item in items if item.letter.character == letter]
        error = max(item.error / item.letter.size for item in own)
        largest = max(item.largest / item.letter.size for item in own)
        cases[letter] = bool(error <= 0.01 and largest <= 0.03)
        worst = mm(max(item.error for item in own))
        words.append(f"{letter} {worst} ({per_cent(error)}), largest {per_cent(largest)}")
    figure = f"Worst of each letter, rms and in parts of its size: {'; '.join(words)}."
    return cases, figure, ""


@claim(
    "accuracy and efficiency",
    "The choice of number and shape of kernels improves both accuracy and efficiency.",
)
def accuracy_and_efficiency(evidence: Evidence) -> Judgement:
    """Judge whether kernels well chosen improve accuracy and efficiency over the original form.

    Error at most 0.8 of the original's and time at most 0.9, both at N = Num/10. Time is measured,
    once in a process.
    """
    found = evidence.against
    ratio = star = original = np.inf
    if len(found.strokes):
        ratio = float(np.median(found.error[:, 0] / found.error[:, 1]))
        star, original = np.median(found.error, axis=0)
    cases = {"accuracy": ratio <= 0.8, "time on this computer": found.time_ratio <= 0.9}
    figure = (
        f"Over {len(found.strokes)} strokes DMP* makes {per_cent(ratio)} of the original's error "
        f"({mm(star)} against {mm(original)}) in {per_cent(found.time_ratio)} of its time."
    )
    return cases, figure, evidence.borrowed


@claim(
    "any shape",
    "Trajectories of arbitrary shape, scale, strokes, starting and ending positions are learned.",
)
def any_ink(evidence: Evidence) -> Judgement:
    """Judge whether random ink is learned within 2 % of its size, and moved goals met within 2 %.

    Medians; a case for each rate at which the pen turns. The ink is random, so recordings do not
    matter.
    """
    ink = evidence.shapes
    error, miss = (np.median(values, axis=2).max(axis=0) for values in (ink.error, ink.miss))
    cases, words = {}, []
    for rate, e, m in zip(ink.rates, error, miss, strict=True):
        cases[f"{rate:g} turns a second"] = bool(e <= 0.02 and m <= 0.02)
        words.append(f"{per_cent(e)} at {rate:g} Hz")
    figure = (
        f"Worst kind of ink by turns a second: {', '.join(words)} of its size; moved goals missed "
        f"by {per_cent(miss.max())}."
    )
    return cases, figure, ""


@claim("writing style", "New letters have a writing style similar to that of the demonstrations.")
def writing_style(evidence: Evidence) -> Judgement:
    """Judge whether bowls that DMP* led to other ends are given to their writer beyond chance.

    HOLDS if all four questions are (less than 5 % by luck): with the ends of the recipe and with
    varied ends, as drawn and less what the recipe does to everybody. DOES NOT HOLD if none hits
    more often than a guess would, else it DEPENDS ON the number of writers and on what is compared.
    """
    hands = evidence.hands
    answers = [
        hands[question("DMP*", varied, less)] for less in (True, False) for varied in (False, True)
    ]
    verdict = DEPENDS if any(each.rate > each.chance for each in answers) else FAILS
    if all(each.luck <= SIGNIFICANT_LUCK for each in answers):
        verdict = HOLDS
    real = [
        f"{each.question} {per_cent(each.rate)} (by luck {each.luck:.2g})"
        for each in evidence.real_hands
        if each.items
    ]
    rates = [_rate_words(each) for each in answers]
    figure = (
        f"Bowls that DMP* led, given to the right one of {len(answers[0].writers)} writers less "
        f"everybody's mean: {rates[0]}, with varied ends {rates[1]}; as drawn {rates[2]} and "
        f"{rates[3]}. A guess: {per_cent(answers[0].chance)}; the original form: "
        f"{_rate_words(hands[question('original', False, True)])}. Real letters told apart: "
        f"{', '.join(real) or 'none could be asked'}."
    )
    why = "the number of writers, and on whether what the recipe does to everybody is taken away"
    if hands.borrowed:
        why += "; our own letters, as there are no two writers' bowls to lead"
    return verdict, figure, why


def _rate_words(answers: Answers) -> str:
    """Return a rate with its interval."""
    low, high = answers.interval
    return f"{per_cent(answers.rate)} [{100 * low:.0f}, {100 * high:.0f}]"
