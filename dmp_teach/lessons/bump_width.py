"""Lesson 03: how wide a kernel should be (the paper's figures on kernel types, width and 'a')."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _

NARROWEST, WIDEST = 0.25, 20.0
BET_WIDTHS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0)
CURVE_WIDTHS = np.unique([*np.geomspace(NARROWEST, WIDEST, 40), 0.98, 1.0])
PAIRS = (("a", "D"), ("e", "B"), ("g", "R"), ("m", "P"), ("h", "S"), ("d", "G"))


def learn_with_width(character: str, kernel: str, width: float, fit: str) -> Letter:
    """Learn a letter of our alphabet with kernels of one shape and width [1/N]."""
    preset = Settings.joint if fit == "joint" else Settings.star
    settings = preset(
        kernel="mollifier" if kernel == "smooth" else "gaussian",
        kernel_width=math.inf if kernel == "bell" else width,
        kernel_sigma=max(0.2, width / 3) if kernel in ("cut", "bell") else math.inf,
        sharpen=False,
    )
    return drawing.learn_letter(character, settings)


def error_at_width(character: str, answer: kit.Answer) -> float:
    """Return how far off a letter is with these settings, on average [mm]."""
    width = float(answer["kernel_width"])
    return 1000 * drawing.error_of(
        learn_with_width(character, str(answer["kernel"]), width, str(answer["fit"]))
    )


class BumpWidth(kit.Lesson):
    """A width that touches, between gaps and mush."""

    key = "03"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the two letters and the shape of the bumps."""
        self.pair = PAIRS[0] if random is None else PAIRS[random.integers(len(PAIRS))]
        self.kernel = "box" if random is None else ("box", "cut")[random.integers(2)]
        best: kit.Answer = {"kernel_width": 1.1, "kernel": self.kernel, "fit": "lwr"}
        self.limit = math.ceil(18 * max(error_at_width(each, best) for each in self.pair)) / 10
        self.start = {**best, "kernel_width": 10.0, "letter": self.pair[0]}
        self.solution = {**best, "letter": self.pair[0]}

    @property
    def question(self) -> str:
        """The title."""
        return _("How wide should each bump be?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can set."""
        kernels = {"box": _("box"), "cut": _("cut bell"), "smooth": _("soft bell")}
        return {
            "kernel_width": kit.Slider.of(
                "kernel_width", NARROWEST, WIDEST, is_log=True, icons=("narrow", "one")
            ),
            "letter": kit.OneOf(_("Letter"), {each: each for each in self.pair}, is_view=True),
            "kernel": kit.OneOf(_("Shape"), {**kernels, "bell": _("bell without ends")}),
            "fit": kit.OneOf(
                _("Learned"), {"lwr": _("one bump at a time"), "joint": _("all together")}
            ),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The curve of errors."""
        question = _(
            "The robot’s {letter} has gone soft: its bumps are ten times too wide. How far off is "
            "it at other widths? Pull the dots to where you think."
        )
        places = np.array([[width, 3.0] for width in BET_WIDTHS])
        labels = [_("How far off at width {width:g}").format(width=each) for each in BET_WIDTHS]
        asked = question.format(letter=self.pair[0])
        return kit.DrawnBet(
            asked, "curve", places, labels, step=0.1, unit="mm", low=0.1, high=100.0
        )

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Make the bumps wider and wider. What melts first?"),
                lambda v: v["kernel_width"] > 12,
            ),
            kit.Task(
                _("Now go below 1. What happens between the bumps?"),
                lambda v: v["kernel_width"] < 0.8,
            ),
            kit.Task(
                _("Learn all together, with a width from 3 to 8. Is the letter still soft?"),
                lambda v: v["fit"] == "joint" and 3 <= v["kernel_width"] <= 8,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        shape = {"box": _("boxes"), "cut": _("cut bells")}[self.kernel]
        words = _(
            "With {shape}, learned one at a time: find one width that keeps both {first} and "
            "{second} within {limit} mm of the person’s."
        )
        first, second = self.pair
        return words.format(shape=shape, first=first, second=second, limit=self.limit)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        return (
            _("Look at the bumps in time. Do they leave gaps, just touch, or pile up?"),
            _("Wide bumps average their neighbours. Go left, but stop before gaps open."),
            _("At width 1 the bumps just touch. Try 1.1."),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return the error of each letter."""
        return [
            kit.at_most(each, error_at_width(each, answer), self.limit, "mm") for each in self.pair
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is wrong with the width, the shape or the fit."""
        width, kernel = float(answer["kernel_width"]), answer["kernel"]
        errors = {each: error_at_width(each, answer) for each in self.pair}
        worst, error = max(errors.items(), key=lambda each: each[1])
        is_far, has_ends = error > self.limit, kernel != "bell"
        facts: kit.Answer = {"width": _width_words(width), "letter": worst, "limit": self.limit}
        facts["mm"] = drawing.millimetres(error / 1000, self.limit)
        facts["share"] = kit.tell_number(100 * (1 - width), 0.0, 0)
        together = _(
            "All together each bump is told what the others do, and at width {width} {letter} is "
            "{mm} mm off. The challenge is for bumps that learn one at a time."
        )
        endless = _(
            "A bell without ends leaves no gap however narrow it is: at width {width} {letter} is "
            "{mm} mm off. The challenge is for another shape."
        )
        too_wide = _(
            "A bell without ends is always awake. At width {width} it averages so many places that "
            "{letter} is {mm} mm off. The challenge is for another shape."
        )
        other = _("At width {width} {letter} is {mm} mm off. The challenge is for another shape.")
        gaps = _(
            "Width {width} leaves gaps: for {share} % of the time no bump is awake, and the pen "
            "drifts. {letter} is {mm} mm off."
        )
        piled = _(
            "At width {width} each bump averages what {width} places need, so bends melt. "
            "{letter} is {mm} mm off; the limit is {limit}."
        )
        found = [
            (is_far and has_ends and width < 1, gaps),
            (answer["fit"] == "joint", together),
            (not has_ends, too_wide if is_far else endless),
            (kernel != self.kernel, other),
            (is_far, piled),
        ]
        return [(is_made, words.format(**facts)) for is_made, words in found]

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "Width {width} keeps both: {errors}. At width 1 bumps just touch: that is enough."
        )
        errors = [f"{each.name} {each.shown}" for each in self.conditions(answer)]
        width = _width_words(float(answer["kernel_width"]))
        return words.format(width=width, errors=", ".join(errors))

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return where the bet was near, and where it was far off."""
        truth = [error_at_width(self.pair[0], self.start | {"kernel_width": x}) for x, _y in bet]
        ratios = [y / true for (_x, y), true in zip(bet, truth, strict=True)]
        far = int(np.argmax(np.abs(np.log(ratios))))
        near = int(np.argmin(np.abs(np.log(ratios))))
        words = _(
            "You were nearest at width {near[0]:g}: you said {near[1]} mm, it is {near[2]}. The "
            "surprise is at width {far[0]:g}: you said {far[1]}, it is {far[2]} mm."
        )
        facts = [
            (x, drawing.millimetres(y / 1000), drawing.millimetres(true / 1000))
            for (x, y), true in zip(bet, truth, strict=True)
        ]
        return words.format(near=facts[near], far=facts[far])

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the letter, the curve of what was tried, and the bumps over time."""
        values = state.values
        character, kernel = str(values["letter"]), str(values["kernel"])
        width, fit = float(values["kernel_width"]), str(values["fit"])
        letter = learn_with_width(character, kernel, width, fit)
        written = letter.write()
        error = error_at_width(character, values)
        sheet = drawing.draw_sheet(
            letter.strokes,
            drawing.paths_of(written),
            caption=_("On paper"),
            note=_("width {width:.2g}").format(width=width),
        )
        plots = {"curve": self._draw_curve(state, error), "strip": drawing.draw_bumps(letter)}
        return kit.Picture(self._say(error, width, fit, kernel), sheet, plots, written)

    def _draw_curve(self, state: kit.LessonState, error: float) -> dict[str, object]:
        """Draw the errors that were tried; the whole curve where the truth is revealed."""
        values = state.values
        of = {"letter": values["letter"], "kernel": values["kernel"], "fit": values["fit"]}
        tried = sorted(
            (float(each["kernel_width"]), error_at_width(self.pair[0], each))
            for each in state.tried
            if all(each.get(name) == value for name, value in of.items())
        )
        ticks = [[0.25, "¼"], [1, _("1 just touching")], [4, "4"], [20, "20"]]
        x = {"label": _("how wide each bump is"), "low": NARROWEST, "high": WIDEST}
        lines = [{"points": np.array(tried), "kind": "quiet"}] if len(tried) > 1 else []
        if state.is_revealed:
            true = [
                [each, error_at_width(str(values["letter"]), values | {"kernel_width": each})]
                for each in map(float, CURVE_WIDTHS)
            ]
            lines = [{"points": np.array(true), "kind": "truth", "label": _("the robot")}]
        dots = [{"at": [float(values["kernel_width"]), error], "kind": "robot"}]
        return {
            "caption": _("How far off"),
            "note": _("your bet, and the truth") if state.is_revealed else _("what you tried"),
            "x": x | {"log": True, "ticks": ticks},
            "y": drawing.error_axis(),
            "lines": lines,
            "dots": dots,
        }

    def _say(self, error: float, width: float, fit: str, kernel: str) -> dict[str, str]:
        """Return the number and the sentence."""
        text, strong = _("The bumps just touch. "), _("The line sits on the dots.")
        is_far, is_joint = error > self.limit, fit == "joint"
        if kernel == "bell" and width < 1.2:
            text = _("A bell without ends leaves no gap. ")
        elif width < 1 and is_far:
            text = _("Between the bumps the robot sleeps. ")
            strong = _("The pen drifts in the gaps.")
        elif width > 1.2:
            text = _("Each bump covers the places of {width:.2g}. ").format(width=width)
            if is_far and not is_joint:
                strong = _("Each part of the letter is an average of its neighbours.")
            elif is_far:
                strong = _("Even together they are too alike to tell places apart.")
            elif is_joint:
                text, strong = _("Each bump knows its neighbours. "), _("Its width hardly matters.")
        elif is_far:
            strong = _("Where soft bells meet, they hardly push.")
        number = {"number": drawing.millimetres(error / 1000), "unit": _("mm off on average")}
        return {**number, "text": text, "strong": strong, "after": ""}


def _width_words(width: float) -> str:
    """Return a width as it is shown; one that leaves gaps does not look like 1."""
    return kit.tell_number(width, 1.0, 2) if width < 1 else f"{width:.2g}"
