"""The paper's claims about letters, each computed from a study; as in `kernels`."""

from __future__ import annotations

import numpy as np

from dmp_teach.studies.authorship.answers import Answers
from dmp_teach.studies.authorship.made import question
from dmp_teach.studies.experiments.stroke_segmentation import END_TOLERANCE
from dmp_teach.studies.readings import Reading
from dmp_teach.studies.verdicts.claim import (
    DEPENDS,
    FAILS,
    HOLDS,
    Found,
    claim,
    claim_by_reading,
    mm,
    per_cent,
)
from dmp_teach.studies.verdicts.evidence import Evidence, evidence_of

# A guess hits so often or more with at most this probability.
SIGNIFICANT_LUCK = 0.05
RULES_OF_PAPER = {"printed": "as printed", "meant": "as meant", "authors": "the program"}


@claim_by_reading(
    "D becomes P",
    "A D becomes a P when the goal of its second stroke moves.",
    "How many are a P, how far the bowl dips under its goal and is off a turned and scaled bowl",
)
def d_becomes_p(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether D becomes P by moving the goal of its bowl, recognisably in nine of ten.

    HOLDS if the bowl is besides within 5 % of the bar (median) of the D's own bowl turned and
    scaled; sheared more than that, it DEPENDS ON how neat a P must be. Our own D is taken where
    nobody wrote one in two strokes.
    """
    made = evidence.new_letters()
    words = []
    # The others are compared with ours.
    ways = [reading.name, *(["original", "similarity"] if reading.name == "ours" else [])]
    for way in ways:
        items = made.by(way)
        good = [item for item in items if item.recognisable]
        quality = ""
        if good:
            dip, shear = (
                mm(float(np.median([getattr(item, name) for item in good])))
                for name in ("overshoot", "shear")
            )
            quality = f" ({dip}, {shear})"
        name = "" if way == reading.name else f"{way} "
        words.append(f"{name}{len(good)} of {len(items)}{quality}")
    items = made.by(reading.name)
    clear = np.mean([item.recognisable for item in items]) >= 0.9
    neat = bool(np.median([item.shear / item.height for item in items]) <= 0.05)
    verdict = (HOLDS if neat else DEPENDS) if clear else FAILS
    why = "how neat a P must be" if verdict == DEPENDS else ""
    warning = "no D of two strokes was recorded, so that our own were taken" * made.borrowed
    return Found(verdict, ", ".join(words), len(items), "letters", why, warning)


@claim(
    "strokes from height", "Strokes are told apart by dz/dt > theta and the height over the plane."
)
def strokes_from_height(evidence: Evidence) -> Found:
    """Judge whether dz/dt and z give the strokes: count and all ends right in 0.9 of recordings.

    A case for each reading of the rule: as printed, as its words mean it, and the authors' program.
    An end is right within 0.05 s of the strokes that the recording gives, or of those of our own
    rule where it gives none. Where no recording has a lift, our own alphabet is taken.
    """
    items, warning = evidence.lifts().items, ""
    if not items:
        items = evidence_of(None).lifts().items
        warning = "no recording has a lift, so that our own letters were taken"
    cases, words = {}, []
    for rule, name in RULES_OF_PAPER.items():
        found = [getattr(item, rule) for item in items]
        right = sum(each.right for each in found)
        count = [
            each.off for each, item in zip(found, items, strict=True)
            if each.strokes == item.strokes
        ]  # fmt: skip
        off = f" (off by {mm(float(np.median(count)))})" if count else ""
        cases[name] = right >= 0.9 * len(items)
        words.append(f"{name} {len(count)}{off}, {right}")
    known, steady = sum(item.known for item in items), sum(item.steady for item in items)
    figure = (
        f"How often the number of strokes is right, by how much the worst end is off in these "
        f"(median), and how often every end is right to {END_TOLERANCE} s: {'; '.join(words)}. "
        f"Judged by the strokes that {known} of {len(items)} recordings give, and by our own rule "
        f"in {len(items) - known}, which keeps its count over all thresholds in {steady}"
    )
    return Found(cases, figure, len(items), "recordings", warning=warning)


@claim_by_reading(
    "redrawn letters",
    "The letters a, b, e and m are reproduced in nearly identical shapes.",
    "Worst of each letter, rms, in parts of its size, and largest",
)
def redrawn_letters(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether a, b, e and m are redrawn: rms at most 1 % of their size, nowhere above 3 %.

    A case for each letter; all that were recorded where none of the four was.
    """
    cases, words = {}, []
    items = evidence.redrawn(reading).items
    for letter in dict.fromkeys(item.letter.character for item in items):
        own = [item for item in items if item.letter.character == letter]
        error = max(item.error / item.letter.size for item in own)
        largest = max(item.largest / item.letter.size for item in own)
        cases[letter] = bool(error <= 0.01 and largest <= 0.03)
        worst = mm(max(item.error for item in own))
        words.append(f"{letter} {worst} ({per_cent(error)}, {per_cent(largest)})")
    warning = evidence.missing("abem", "all letters that were recorded were taken")
    return Found(cases, ", ".join(words), len(items), "letters", warning=warning)


@claim_by_reading(
    "any shape",
    "Trajectories of arbitrary shape, strokes, starting and ending positions are learned.",
    "The error of the worst kind of random ink as a share of its size, by turns of the pen in a "
    "second, and by how much of it moved goals are missed",
)
def any_ink(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether random ink is learned within 2 % of its size, and moved goals met within 2 %.

    Medians; a case for each rate at which the pen turns. The ink is random, so recordings do not
    matter.
    """
    ink = evidence.shapes(reading)
    error, miss = (np.median(values, axis=2).max(axis=0) for values in (ink.error, ink.miss))
    cases, words = {}, []
    for rate, e, m in zip(ink.rates, error, miss, strict=True):
        cases[f"{rate:g} Hz"] = bool(e <= 0.02 and m <= 0.02)
        words.append(f"{per_cent(e)} at {rate:g} Hz")
    return Found(
        cases, f"{', '.join(words)}, {per_cent(miss.max())}", ink.error.size, "random strokes"
    )


@claim_by_reading(
    "any scale",
    "Trajectories of arbitrary scale are learned.",
    "The median error as a share of the size: as written, ten times as large and a tenth as large "
    "(the same by construction), and written three times as fast",
)
def any_scale(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether strokes of other sizes and paces are learned within 2 % of their size.

    Sizes change nothing, since the equations are linear; a pace does, at the same clock.
    """
    ways = {
        "as written": (1.0, 1.0),
        "ten times as large": (10.0, 1.0),
        "a tenth as large": (0.1, 1.0),
        "three times as fast": (1.0, 3.0),
    }
    found = {
        name: float(np.median(evidence.errors(reading.star, *way))) for name, way in ways.items()
    }
    cases = {name: error <= 0.02 for name, error in found.items()}
    words = ", ".join(map(per_cent, found.values()))
    n = len(evidence.open_strokes)
    return Found(cases, words, n, evidence.strokes_open, warning=evidence.borrowed)


@claim_by_reading(
    "writing style",
    "New letters have a writing style similar to that of the demonstrations.",
    "How often bowls that were led to other ends are given to their writer: less everybody's mean, "
    "with varied ends, both as drawn; and by a guess",
)
def writing_style(evidence: Evidence, reading: Reading) -> Found:
    """Judge whether bowls that DMP* led to other ends are given to their writer beyond chance.

    HOLDS if all four questions are (less than 5 % by luck): with the ends of the recipe and with
    varied ends, as drawn and less what the recipe does to everybody. DOES NOT HOLD if none hits
    more often than a guess would, else it DEPENDS ON the number of writers and on what is compared.
    The stroke that a bowl was led from is never among those that it is compared with.
    """
    hands = evidence.hands()
    answers = [
        hands[question(reading.name, varied, less)]
        for less in (True, False)
        for varied in (False, True)
    ]
    verdict = DEPENDS if any(each.rate > each.chance for each in answers) else FAILS
    if all(each.luck <= SIGNIFICANT_LUCK for each in answers):
        verdict = HOLDS
    figure = f"{', '.join(map(_rate_words, answers))}; {per_cent(answers[0].chance)}"
    if reading.name == "ours":
        real = [
            f"{each.question} {per_cent(each.rate)} (by luck {each.luck:.2g})"
            for each in evidence.real_hands()
            if each.items
        ]
        figure += f" (real letters told apart: {', '.join(real) or 'none could be asked'})"
    why = "the number of writers, and on what is compared" if verdict == DEPENDS else ""
    warning = "nobody's bowls can be compared with others of theirs, so that our own were taken"
    n = len({writer for writer, _ in answers[0].items})
    return Found(verdict, figure, n, "writers", why, warning * hands.borrowed)


def _rate_words(answers: Answers) -> str:
    """Return a rate with its interval."""
    low, high = answers.interval
    return f"{per_cent(answers.rate)} [{100 * low:.0f}, {100 * high:.0f}]"
