"""Claims of the paper, each measured on many writers in the paper's way and in a counter-test."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from dmp_teach.classroom import Message, says
from dmp_teach.dmp import DMP, Settings
from dmp_teach.lessons.drawing import millimetres
from dmp_teach.lessons.many_writers import Writers
from dmp_teach.studies import redraw_letters
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, rms

PAPERS_WAY, COUNTER_TEST = "paper", "counter"
OPEN, STANDS, UNFAIR, ONE_SETTING, TOO_FEW = "open", "holds", "unfair", "one_setting", "too_few"
# What a coin does oftener than this is called luck.
MOST_LUCK = 1 / 20
GOAL_WAYS = {PAPERS_WAY: 0.01, COUNTER_TEST: 0.1}
COMPARED_SETTINGS: dict[str, dict[str, tuple[Settings, Settings]]] = {
    "rule": {
        PAPERS_WAY: (Settings.original(), Settings.star()),
        COUNTER_TEST: (Settings.star(transform="original"), Settings.star()),
    },
    "level": {
        PAPERS_WAY: (
            Settings.as_coded(),
            Settings.as_coded(samples_per_kernel=2),
        ),
        COUNTER_TEST: (Settings.as_fixed(), Settings.as_fixed(samples_per_kernel=2)),
    },
    "cut": {
        PAPERS_WAY: (Settings.as_fixed(kernel_width=math.inf), Settings.as_fixed()),
        COUNTER_TEST: (Settings.joint(), Settings.joint(kernel_width=2.0)),
    },
    "gaps": {
        PAPERS_WAY: (Settings.as_fixed(kernel_width=2 / 3), Settings.as_fixed()),
        COUNTER_TEST: (Settings.joint(kernel_width=2 / 3), Settings.joint(kernel_width=1.0)),
    },
}
"""What is divided by what: the errors of the first settings by those of the second."""

RATIO_LIMITS = {"rule": 1.5, "level": 2.0, "cut": 1.5, "gaps": 1.5, "goal": 1.1}
# A claim that says "no more than": it is borne out below its limit.
NO_MORE_THAN = ("level", "goal")


@dataclass(frozen=True, eq=False)
class WriterRatios:
    """A claim on each writer.

    Args:
        claim: Its name.
        ratios: One for each of W writers, shape (W,).
        paths: What the second settings drew, or DMP* to the moved goal, each shape (N, 2) [m].
        beside: What the first settings drew, each shape (N, 2) [m].
        errors: Of the first and the second settings, each shape (W,) [m].
    """

    claim: str
    ratios: Array
    paths: tuple[Array, ...]
    beside: tuple[Array, ...] = ()
    errors: tuple[Array, ...] = ()

    def first(self, number: int) -> WriterRatios:
        """Return it on the first writers alone."""
        return replace(self, ratios=self.ratios[:number])

    @property
    def number(self) -> int:
        """How many writers there are."""
        return len(self.ratios)

    @property
    def for_it(self) -> int:
        """How many writers bear the claim out."""
        limit, is_below = RATIO_LIMITS[self.claim], self.claim in NO_MORE_THAN
        return int(np.sum(self.ratios <= limit if is_below else self.ratios >= limit))

    @property
    def luck(self) -> float:
        """How often a coin falls as one-sidedly, or more so, to the side of the more writers."""
        most = max(self.for_it, self.number - self.for_it)
        ways = sum(math.comb(self.number, k) for k in range(most, self.number + 1))
        return float(ways / 2**self.number)

    @property
    def verdict(self) -> bool | None:
        """Whether it is borne out; None where it may be luck."""
        return None if self.luck > MOST_LUCK else 2 * self.for_it > self.number


@lru_cache(maxsize=64)
def measure(claim: str, how: str, writers: Writers) -> WriterRatios:
    """Measure a claim on every writer."""
    if claim == "goal":
        return _measure_goal(GOAL_WAYS[how], writers)
    first, second = COMPARED_SETTINGS[claim][how]
    items = redraw_letters(writers.strokes, settings={"first": first, "second": second}).items
    errors = np.array([item.error for item in items])
    above, below = errors[::2], errors[1::2]
    drawn = [item.drawn[0].position for item in items if item.drawn]
    paths, beside = tuple(drawn[1::2]), tuple(drawn[::2])
    return WriterRatios(claim, above / below, paths, beside, (above, below))


def _measure_goal(way: float, writers: Writers) -> WriterRatios:
    """Measure how far DMP* moves a letter whose goal moves to the right [m]."""
    ratios, paths = [], []
    for stroke in writers.strokes:
        primitive = DMP.imitate(stroke, Settings.star())
        path = primitive.rollout(goal=primitive.goal + np.array([way, 0.0])).position
        ratios.append(rms(path - stroke.position) / way)
        paths.append(path)
    return WriterRatios("goal", np.array(ratios), tuple(paths))


def find_truth(claim: str, number: int, writers: Writers) -> str:
    """Return what so many writers say of a claim: whether it holds, or why not."""
    found = [measure(claim, how, writers).first(number).verdict for how in GOAL_WAYS]
    if None in found:
        return TOO_FEW
    if all(found):
        return STANDS
    return UNFAIR if claim == "rule" else ONE_SETTING


def claim_words() -> dict[str, str]:
    """Return what the paper says."""
    return {
        "rule": _("DMP* is more accurate than the first rule"),
        "level": _("More than N = samples / 10 bumps do not help"),
        "cut": _("Bumps with ends are better than bumps without"),
        "gaps": _("Bumps that leave gaps are worse than bumps that touch"),
        "goal": _("DMP* moves a letter no farther than its goal moves"),
    }


def ratio_words(claim: str) -> str:
    """Return what is divided by what."""
    if claim == "goal":
        return _("Way of the letter / of its goal")
    above, below = _compared()[claim]
    return _("Error: {above} / {below}").format(above=above, below=below)


def line_words(measured: WriterRatios, writer: int | None) -> str:
    """Return which line on the sheet is whose, and how far off a writer's lines are, if any."""
    if not measured.errors:
        return _("On paper")
    above, below = _compared()[measured.claim]
    if writer is None:
        return _("Thin: {above}. Thick: {below}.").format(above=above, below=below)
    one, other = (millimetres(float(each[writer])) for each in measured.errors)
    words = _("Thin: {above} {one} mm. Thick: {below} {other} mm.")
    return words.format(above=above, below=below, one=one, other=other)


def _compared() -> dict[str, tuple[str, str]]:
    """Return the names of the two settings of each claim."""
    return {
        "rule": (_("first rule"), _("DMP*")),
        "level": (_("N bumps"), _("5 N bumps")),
        "cut": (_("without ends"), _("with ends")),
        "gaps": (_("with gaps"), _("touching")),
    }


def way_words(claim: str, how: str) -> str:
    """Return how a claim is measured."""
    alone, together = _("Each bump learns alone."), _("All bumps learn together.")
    words = {
        "rule": (
            _("Each rule has bumps, spring and clock of its own."),
            _("The same bumps, spring and clock: the rule alone differs."),
        ),
        "level": (
            _("With the soft spring of the authors’ program."),
            _("With a spring that is stiffer the more bumps there are."),
        ),
        "cut": (alone, together),
        "gaps": (alone, together),
        "goal": (_("The goal moves 1 cm."), _("The goal moves 10 cm.")),
    }
    return words[claim][how == COUNTER_TEST]


def verdict_words() -> dict[str, str]:
    """Return the words of each verdict."""
    return {
        OPEN: "?",
        STANDS: _("holds"),
        UNFAIR: _("unfair"),
        ONE_SETTING: _("one setting"),
        TOO_FEW: _("too few"),
    }


def why_not(said: str, truth: str) -> str:
    """Return what the numbers say against a verdict, with places for them."""
    if truth == TOO_FEW:
        return _(
            "but there are {n} writers only. {n} coins fall the same way once in {once}: that may "
            "be luck."
        )
    if truth == STANDS:
        return _(
            "but {for_paper} of {n} writers are for it in the paper’s way ({paper} times), and "
            "{for_counter} of {n} in the counter-test ({counter} times)."
        )
    if said in (STANDS, TOO_FEW):
        return _(
            "but of {n} writers {for_paper} are for it in the paper’s way ({paper} times) and "
            "{for_counter} in the counter-test ({counter} times)."
        )
    if truth == UNFAIR:
        return _(
            "it does not hold, but it is no matter of the setting. {paper} times came from bumps, "
            "spring and clock that were changed, too; the rule alone gives {counter} times."
        )
    return _(
        "it does not hold, but one thing alone was changed each time. It is {paper} times in one "
        "setting and {counter} times in the other."
    )


def tell_ratio(ratio: float) -> str:
    """Return a ratio with two or three figures: "0.58", "1.00", "15"."""
    return f"{ratio:.{2 if ratio < 1.995 else 1 if ratio < 9.95 else 0}f}"


def tell_ratios(measured: WriterRatios, how: str, are_real: bool) -> Message:
    """Return the middle of the ratios with n (writers, or hands), the spread, and the luck."""
    ratios, n = measured.ratios, measured.number
    facts = {"n": n, "for_it": measured.for_it, "once": f"{1 / measured.luck:.0f}"}
    facts |= {"least": tell_ratio(ratios.min()), "most": tell_ratio(ratios.max())}
    strong = _("{for_it} of {n} are for it: a coin does so once in {once}.")
    if measured.verdict is None:
        strong = _("{for_it} of {n} are for it. That may be luck: once in {once}.")
    if np.abs(ratios - 1).max() < 0.005:
        strong = _("All alike, both lines are the same: nothing to count.")
    unit = _("times, n = {n}") if are_real else _("times, n = {n} made hands")
    text = _("From {least} to {most}. ") if n > 1 else _("One writer is no proof. ")
    after = " " + way_words(measured.claim, how)
    middle, text = tell_ratio(float(np.median(ratios))), text.format(**facts)
    return says(middle, unit.format(n=n), text, strong.format(**facts), after)
