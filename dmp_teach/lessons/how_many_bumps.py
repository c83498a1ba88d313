"""Lesson 04: how many kernels are enough (the paper's figure on their number, and N = Num/10)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

FEWEST, MOST = 2, 80
BET_NUMBERS = (2, 5, 10, 20, 40, 80)
CURVE_NUMBERS = sorted({round(n) for n in np.geomspace(FEWEST, MOST, 36)})
LETTERS = "aegmbdhnS"
LIMITS = (0.4, 0.5, 0.6, 0.8, 1.0)
RATES = ("60", "120", "240")
PAPER_RATE = "120"


def learn_with_number(character: str, number: int, rate: str = PAPER_RATE) -> Letter:
    """Learn a letter, sampled so often a second, with so many touching kernels."""
    settings = Settings.star(n_kernels=number, sharpen=False)
    return drawing.learn_letter(character, settings, int(rate))


def error_with_number(character: str, number: float, rate: str = PAPER_RATE) -> float:
    """Return how far off a letter is with so many kernels, on average [mm]."""
    return 1000 * drawing.error_of(learn_with_number(character, int(number), rate))


@lru_cache(maxsize=64)
def find_smallest(character: str, limit: float) -> int:
    """Return the smallest number of kernels with which a letter is within a limit [mm]."""
    return next(n for n in range(FEWEST, MOST + 1) if error_with_number(character, n) <= limit)


class HowManyBumps(kit.Lesson):
    """Each doubling leaves a third to a quarter of the error; what counts is kernels a second."""

    key = "04"
    draws_tried = True
    # With more of the limit left unused [%], fewer kernels would do.
    most_unused = 20.0
    question = marked("How many bumps are enough?")
    bet_question = marked(
        "Five bumps for a whole {letter} are too few. How far off will the robot be with more of "
        "them? Pull the dots to where you think."
    )
    tasks = (
        marked("Take 10 bumps, then twice as many: 20. How much of the error is left?"),
        marked("Add bumps until more of them change nothing that you can see. Stop there."),
        marked("See the pen twice as often, 240 times a second. Are more bumps needed?"),
    )
    challenge = marked(
        "Every bump must be stored and learned. Keep {letter} within {limit} mm with as few as you "
        "can: at most {most_unused:g} % of the limit may be left unused."
    )
    hints = (
        marked("Go up until the number is under the limit. Then go back one by one."),
        marked("Twice as many bumps leave about a third to a quarter of the error."),
        marked("Try {smallest}."),
    )
    praise = marked("{n} bumps are {rate:.0f} a second of writing: {letter} is {error} mm off.")

    def vary(self) -> None:
        self.letter = self.choose(LETTERS)
        self.limit = 0.5 if self.random is None else self.choose(LIMITS)
        self.smallest = find_smallest(self.letter, self.limit)
        self.duration = learn_with_number(self.letter, FEWEST).strokes[0].duration
        self.start = {"n_kernels": 5, "rate": PAPER_RATE}
        self.solution = {"n_kernels": self.smallest, "rate": PAPER_RATE}

    @property
    def knobs(self) -> kit.Knobs:
        rates = {rate: _("{n} a second").format(n=rate) for rate in RATES}
        return {
            "n_kernels": kit.Slider.of("n_kernels", FEWEST, MOST, icons=("one", "many")),
            "rate": kit.OneOf(_("The pen was seen"), rates, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        label = _("How far off with {x:g} bumps")
        return drawing.bet_on_errors(self.bet_question, BET_NUMBERS, 10.0, label)

    @property
    def curve(self) -> drawing.ErrorCurve:
        """How far off the letter is with each number of bumps."""
        ticks = [[n, str(n)] for n in BET_NUMBERS]
        x = drawing.axis(FEWEST, MOST, _("how many bumps"), log=True, ticks=ticks)
        return drawing.ErrorCurve("n_kernels", self._error, x, CURVE_NUMBERS)

    def _error(self, values: kit.Answer) -> float:
        """Return how far off the letter is with what is set [mm]."""
        return error_with_number(self.letter, values["n_kernels"], str(values["rate"]))

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return v["n_kernels"] == 20, 24 <= v["n_kernels"] <= 45, v["rate"] == "240"

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        error = error_with_number(self.letter, answer["n_kernels"])
        unused = 100 * (1 - error / self.limit) if error <= self.limit else math.nan
        return [
            kit.at_most(self.letter, error, self.limit, "mm"),
            kit.at_most(_("left unused"), unused, self.most_unused, "%"),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        n = int(answer["n_kernels"])
        error = drawing.millimetres(error_with_number(self.letter, n) / 1000, self.limit)
        each = f"{self.duration / n:.2f}"
        return {"n": n, "error": error, "each": each, "rate": n / self.duration}

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        is_near, is_used = (each.is_met for each in self.conditions(answer))
        if not is_near:
            yield _(
                "{n} bumps: each one holds the same push for {each} s, so bends are cut short. "
                "{letter} is {error} mm off; the limit is {limit}."
            )
        if not is_used:
            yield _(
                "{n} bumps bring {letter} to {error} mm, and {limit} would be near enough. Fewer "
                "will do."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        words = _(
            "The surprise is at {n:g} bumps: you said {said} mm, it is {true}. From 10 bumps to 80 "
            "each doubling leaves about {left:.0f} % of the error."
        )
        *_others, (n, said, true) = self.curve.rank(bet, self.start)
        at_10, at_80 = (error_with_number(self.letter, n) for n in (10, 80))
        left = 100 * (at_80 / at_10) ** (1 / 3)
        return words.format(n=n, said=said, true=true, left=left)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        number, rate = int(state.values["n_kernels"]), str(state.values["rate"])
        letter = learn_with_number(self.letter, number, rate)
        written, note = letter.write(), _("{n} bumps").format(n=number)
        sheet = drawing.draw_sheet(letter.strokes, drawing.paths_of(written), note=note)
        error = drawing.error_of(letter)
        curve = self.curve.draw(state)
        if state.step != "bet":
            rule = self.duration * int(rate) / 10
            curve["bands"] = [{"from": 0.97 * rule, "to": 1.03 * rule, "label": _("samples / 10")}]
        text = _("{rate:.1f} bumps for each second of writing. ")
        strong = _("Nobody can see what more bumps would change.")
        if error > 0.001:
            strong = _("Bends are cut short: more bumps can tell more places apart.")
        elif error > 0.0003:
            strong = _("The line is within its own thickness.")
        off = drawing.millimetres(error), _("mm off on average")
        return kit.Picture(
            kit.says(*off, text.format(rate=number / self.duration), strong),
            sheet,
            {"curve": curve},
            written,
        )
