"""The places where the paper can be read in two ways, and what each reading does to a letter."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from itertools import combinations
from math import inf, sqrt
from typing import Any

from dmp_teach.classroom import Answer
from dmp_teach.dmp import Settings
from dmp_teach.lessons.drawing import error_of, learn_letter
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _

BY_TEXT, BY_PROGRAM, MENDED = "printed", "program", "mended"
# Any: the keywords of `Settings`.
PLACES: dict[str, dict[str, dict[str, Any]]] = {
    # Equations 5 and 11 without Algorithm 2, whose line for f has the factor that is missed here.
    "push": {BY_TEXT: {"divide": False}, MENDED: {}},
    "ends": {BY_TEXT: {}, MENDED: {"kernel_sides": "both"}},
    "clock": {
        BY_TEXT: {},
        BY_PROGRAM: {"phase": "counted", "phase_decay": 4.6},
        MENDED: {"phase": "linear", "phase_decay": 4.6},
    },
    "step": {BY_TEXT: {}, MENDED: {"integrator": "explicit"}},
    "stand": {
        BY_TEXT: {},
        BY_PROGRAM: {"kernel_centers": "grid"},
        MENDED: {"kernel_centers": "middles"},
    },
    "spring": {
        BY_TEXT: {},
        BY_PROGRAM: {
            **{"alpha": None, "alpha_per_second": 4.0, "damping": 1 / sqrt(8)},
            "start_velocity": "kept",
        },
        MENDED: {"alpha": None},
    },
    "width": {
        BY_TEXT: {},
        BY_PROGRAM: {
            **{"kernel_width": 2.0, "kernel_sides": "closed"},
            **{"kernel_sigma": inf, "kernel_spread": sqrt(0.5)},
        },
    },
}
"""By the place, each reading as changes of `Settings.as_printed`."""

AS_PRINTED: Answer = dict.fromkeys(PLACES, BY_TEXT)
AS_FIXED: Answer = AS_PRINTED | {name: MENDED for name, all_ in PLACES.items() if MENDED in all_}
AS_CODED: Answer = AS_FIXED | {
    name: BY_PROGRAM for name, all_ in PLACES.items() if BY_PROGRAM in all_
}
AS_CODED |= {"step": BY_TEXT}
# What is no mistake of the text: there the program alone does other than it says.
FAULTY = tuple(name for name, all_ in PLACES.items() if MENDED in all_)


def settings_of(readings: Answer) -> Settings:
    """Return the settings that follow from one reading for each place."""
    # Any: as in PLACES.
    changed_settings: dict[str, Any] = {}
    for name, reading in readings.items():
        changed_settings |= PLACES[name][str(reading)]
    return Settings.as_printed(**changed_settings)


def learn_by(character: str, readings: Answer) -> Letter:
    """Learn a letter of our alphabet by these readings."""
    return learn_letter(character, settings_of(readings))


def error_by(character: str, readings: Answer) -> float:
    """Return how far off a letter is by these readings, on average [mm]."""
    return 1000 * error_of(learn_by(character, readings))


def changed(readings: Answer) -> list[str]:
    """Return the places that are not read as printed."""
    return [name for name in PLACES if readings[name] != BY_TEXT]


@lru_cache(maxsize=64)
def find_best(character: str, number: int) -> tuple[str, ...]:
    """Return which places, so many, bring a letter nearest when they alone are mended."""
    choices = combinations(FAULTY, number)
    return min(choices, key=lambda names: error_by(character, mend(*names)))


def mend(*names: str) -> Answer:
    """Return the paper as printed with these places mended."""
    return AS_PRINTED | dict.fromkeys(names, MENDED)


def error_left(character: str, name: str) -> float:
    """Return how far off a letter is if one place is left as printed and all else mended [mm]."""
    return error_by(character, AS_FIXED | {name: BY_TEXT})


def find_costliest(character: str, readings: Answer) -> str:
    """Return the place that costs most as it is read."""
    wrong = [name for name, right in AS_FIXED.items() if readings[name] != right]
    return min(wrong, key=lambda name: error_by(character, readings | {name: AS_FIXED[name]}))


def find_idlest(character: str, readings: Answer) -> tuple[str, float]:
    """Return the change that does least, and the error when it is put back [mm]."""
    errors = {name: error_by(character, readings | {name: BY_TEXT}) for name in changed(readings)}
    name = min(errors, key=errors.__getitem__)
    return name, errors[name]


def names() -> Mapping[str, str]:
    """Return the name of each place."""
    return {
        "push": _("push"),
        "ends": _("bump ends"),
        "clock": _("clock"),
        "step": _("step"),
        "stand": _("bump places"),
        "spring": _("spring"),
        "width": _("bump width"),
    }


def formulas() -> Mapping[str, Mapping[str, str]]:
    """Return the words of each reading, by the place."""
    words: dict[str, dict[str, str]] = {
        "push": {BY_TEXT: "f", MENDED: "f ÷ K"},
        "ends": {BY_TEXT: "x − c ≤ θ", MENDED: "|x − c| ≤ θ"},
        "stand": {BY_TEXT: _("0 to 1"), BY_PROGRAM: "i/N", MENDED: "(i−½)/N"},
        "clock": {BY_TEXT: "ẋ = −x/T", BY_PROGRAM: "1 − i/n", MENDED: "x = 1 − t/T"},
        "spring": {BY_TEXT: "α = 25", BY_PROGRAM: "4/s", MENDED: "2N"},
        "step": {BY_TEXT: _("the last one"), MENDED: _("its own")},
        "width": {BY_TEXT: "1/N", BY_PROGRAM: "2/N"},
    }
    kinds = {
        BY_TEXT: _("printed: {formula}"),
        BY_PROGRAM: _("program: {formula}"),
        MENDED: _("mended: {formula}"),
    }
    return {
        name: {kind: kinds[kind].format(formula=formula) for kind, formula in each.items()}
        for name, each in words.items()
    }


def notes() -> Mapping[str, str]:
    """Return what the paper says at each place, in plain words."""
    return {
        "push": _("learned with K, then × K"),
        "ends": _("on one side only"),
        "clock": _("“linear”, yet slows down"),
        "step": _("comes one moment late"),
        "stand": _("evenly from 0 to 1"),
        "spring": _("no strength is given"),
        "width": _("no fault: the program alone differs"),
    }


def symptom_of(name: str, reading: str) -> str:
    """Return what a reading does to a letter, with places for the numbers of `facts_of`.

    The place is not named: it is to be found.
    """
    return {
        ("push", BY_TEXT): _("Something drives the pen {k} times too hard."),
        ("ends", BY_TEXT): _("Near the end all {n} bumps are still awake, and learn averages."),
        ("stand", BY_TEXT): _("At {gaps} moments no bump is awake, and nothing pushes."),
        ("stand", BY_PROGRAM): _("In the last {half:.1f} % of the time nothing pushes."),
        ("clock", BY_TEXT): _("Only 63 % of the {n} bumps ever wake up."),
        ("clock", BY_PROGRAM): _("The movement stops one moment before its end."),
        ("spring", BY_TEXT): _("What {n} bumps round off is hardly corrected."),
        ("spring", BY_PROGRAM): _("The pen swings: what holds it is soft, {alpha:.0f} only."),
        ("step", BY_TEXT): _("The pen comes {ms:.0f} thousandths of a second late."),
        ("width", BY_PROGRAM): _("Each moment gets the average of two of the {n} bumps."),
    }[name, reading]


def facts_of(character: str, readings: Answer) -> dict[str, float | str]:
    """Return the numbers behind the causes."""
    primitive = learn_by(character, readings).primitives[0]
    settings = primitive.settings
    alpha, number = float(settings.alpha or 0), int(settings.n_kernels or 1)
    stiffness = (alpha / (2 * settings.damping)) ** 2
    ms = 1000 * primitive.duration / (len(primitive.times) - 1)
    facts = {"alpha": alpha, "n": number, "gaps": number - 1, "ms": ms, "half": 50 / number}
    return facts | {"k": f"{stiffness:.0f}"}
