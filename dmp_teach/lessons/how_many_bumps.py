"""Lesson 04: how many kernels are enough (the paper's figure on their number, and N = Num/10)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _

FEWEST, MOST = 2, 80
BET_NUMBERS = (2, 5, 10, 20, 40, 80)
CURVE_NUMBERS = sorted({round(n) for n in np.geomspace(FEWEST, MOST, 36)})
LETTERS = "aegmbdhnS"
LIMITS = (0.4, 0.5, 0.6, 0.8, 1.0)
RATES = ("60", "120", "240")
PAPER_RATE = "120"
# With more of the limit left unused [%], fewer kernels would do.
MOST_UNUSED = 20.0


def learn_with_number(character: str, number: int, rate: str = PAPER_RATE) -> Letter:
    """Learn a letter, sampled so often a second, with so many touching kernels."""
    return drawing.learn_letter(
        character, Settings.star(n_kernels=number, sharpen=False), int(rate)
    )


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

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, and how near is near enough."""
        self.letter = "a" if random is None else str(random.choice(list(LETTERS)))
        self.limit = 0.5 if random is None else float(random.choice(LIMITS))
        self.smallest = find_smallest(self.letter, self.limit)
        self.duration = learn_with_number(self.letter, FEWEST).strokes[0].duration
        self.start = {"n_kernels": 5, "rate": PAPER_RATE}
        self.solution = {"n_kernels": self.smallest, "rate": PAPER_RATE}

    @property
    def question(self) -> str:
        """The title."""
        return _("How many bumps are enough?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can turn; how often the pen was seen is no part of the answer."""
        rates = {rate: _("{n} a second").format(n=rate) for rate in RATES}
        return {
            "n_kernels": kit.Slider.of("n_kernels", FEWEST, MOST, icons=("one", "many")),
            "rate": kit.OneOf(_("The pen was seen"), rates, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The curve of errors."""
        question = _(
            "Five bumps for a whole {letter} are too few. How far off will the robot be with more "
            "of them? Pull the dots to where you think."
        )
        places = np.array([[number, 10.0] for number in BET_NUMBERS])
        labels = [_("How far off with {n} bumps").format(n=number) for number in BET_NUMBERS]
        asked = question.format(letter=self.letter)
        return kit.DrawnBet(
            asked, "curve", places, labels, step=0.1, unit="mm", low=0.1, high=100.0
        )

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Take 10 bumps, then twice as many: 20. How much of the error is left?"),
                lambda v: v["n_kernels"] == 20,
            ),
            kit.Task(
                _("Add bumps until more of them change nothing that you can see. Stop there."),
                lambda v: 24 <= v["n_kernels"] <= 45,
            ),
            kit.Task(
                _("See the pen twice as often, 240 times a second. Are more bumps needed?"),
                lambda v: v["rate"] == "240",
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        return _(
            "Every bump must be stored and learned. Keep {letter} within {limit} mm with as few as "
            "you can: at most {unused:g} % of the limit may be left unused."
        ).format(letter=self.letter, limit=self.limit, unused=MOST_UNUSED)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        return (
            _("Go up until the number is under the limit. Then go back one by one."),
            _("Twice as many bumps leave about a third to a quarter of the error."),
            _("Try {n}.").format(n=self.smallest),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return the error, and how much of the limit it leaves unused."""
        error, unused = self._measure(answer)
        return [
            kit.at_most(self.letter, error, self.limit, "mm"),
            kit.at_most(_("left unused"), unused, MOST_UNUSED, "%"),
        ]

    def _measure(self, answer: kit.Answer) -> tuple[float, float]:
        """Return the error [mm], and how far it is under the limit [% of it], not below 0."""
        error = error_with_number(self.letter, answer["n_kernels"])
        return error, max(0.0, 100 * (1 - error / self.limit))

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return whether there are too few or too many."""
        number = int(answer["n_kernels"])
        error, unused = self._measure(answer)
        each = self.duration / number
        facts = {"n": number, "letter": self.letter, "limit": self.limit, "each": f"{each:.2f}"}
        facts |= {"error": drawing.millimetres(error / 1000, self.limit)}
        few = _(
            "{n} bumps: each one holds the same push for {each} s, so bends are cut short. "
            "{letter} is {error} mm off; the limit is {limit}."
        )
        many = _(
            "{n} bumps bring {letter} to {error} mm, and {limit} would be near enough. Fewer will "
            "do."
        )
        found = [(error > self.limit, few), (unused > MOST_UNUSED, many)]
        return [(is_made, words.format(**facts)) for is_made, words in found]

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found, as bumps a second."""
        words = _("{n} bumps are {rate:.0f} a second of writing: {letter} is {error} mm off.")
        number = int(answer["n_kernels"])
        error = drawing.millimetres(error_with_number(self.letter, number) / 1000, self.limit)
        rate = number / self.duration
        return words.format(n=number, rate=rate, letter=self.letter, error=error)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return where the bet was furthest off, and the law."""
        truth = [error_with_number(self.letter, number) for number, _y in bet]
        off = [abs(np.log(y / true)) for (_x, y), true in zip(bet, truth, strict=True)]
        far = int(np.argmax(off))
        words = _(
            "The surprise is at {n:g} bumps: you said {said} mm, it is {true}. From 10 bumps to 80 "
            "each doubling leaves about {left:.0f} % of the error."
        )
        at_10, at_80 = (error_with_number(self.letter, number) for number in (10, 80))
        said, true = drawing.millimetres(bet[far][1] / 1000), drawing.millimetres(truth[far] / 1000)
        left = 100 * (at_80 / at_10) ** (1 / 3)
        return words.format(n=bet[far][0], said=said, true=true, left=left)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the letter, and the curve with the paper's rule."""
        number, rate = int(state.values["n_kernels"]), str(state.values["rate"])
        letter = learn_with_number(self.letter, number, rate)
        written = letter.write()
        note = _("{n} bumps").format(n=number)
        caption = {"caption": _("On paper"), "note": note}
        sheet = drawing.draw_sheet(letter.strokes, drawing.paths_of(written), **caption)
        curve = self._draw_curve(state, 1000 * drawing.error_of(letter))
        return kit.Picture(self._say(number, rate), sheet, {"curve": curve}, written)

    def _draw_curve(self, state: kit.LessonState, error: float) -> kit.Drawing:
        """Draw the errors that were tried, or all; and where the paper's N = Num/10 is."""
        number, rate = int(state.values["n_kernels"]), str(state.values["rate"])
        numbers = sorted({int(each["n_kernels"]) for each in state.tried})
        kind = {"kind": "quiet"}
        if state.is_revealed:
            numbers, kind = CURVE_NUMBERS, {"kind": "truth", "label": _("the robot")}
        points = np.array([[n, error_with_number(self.letter, n, rate)] for n in numbers])
        rule = self.duration * int(rate) / 10
        ticks = [[2, "2"], [5, "5"], [10, "10"], [20, "20"], [40, "40"], [80, "80"]]
        x = {"label": _("how many bumps"), "low": FEWEST, "high": MOST, "log": True}
        curve: kit.Drawing = {
            "caption": _("How far off"),
            "note": _("your bet, and the truth") if state.is_revealed else "",
            "x": {**x, "ticks": ticks},
            "y": drawing.error_axis(),
            "lines": [{"points": points, **kind}] if len(points) > 1 else [],
            "dots": [{"at": [number, error], "kind": "robot"}],
        }
        if state.step != "bet":
            band = {"from": 0.97 * rule, "to": 1.03 * rule, "label": _("samples / 10")}
            curve["bands"] = [band]
        return curve

    def _say(self, number: int, rate: str) -> dict[str, str]:
        """Return the number and the sentence."""
        error = error_with_number(self.letter, number, rate) / 1000
        a_second = _("{rate:.1f} bumps for each second of writing. ")
        text = a_second.format(rate=number / self.duration)
        if error > 0.001:
            strong = _("Bends are cut short: more bumps can tell more places apart.")
        elif error > 0.0003:
            strong = _("The line is within its own thickness.")
        else:
            strong = _("Nobody can see what more bumps would change.")
        off = {"number": drawing.millimetres(error), "unit": _("mm off on average")}
        return {**off, "text": text, "strong": strong, "after": ""}
