"""Lesson 03: how wide a kernel should be (the paper's figures on kernel types, width and 'a')."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

NARROWEST, WIDEST = 0.25, 20.0
BET_WIDTHS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0)
CURVE_WIDTHS = np.unique([*np.geomspace(NARROWEST, WIDEST, 40), 0.98, 1.0]).tolist()
BUMP_ICONS = ("narrow", "one")
PAIRS = (("a", "D"), ("e", "B"), ("g", "R"), ("m", "P"), ("h", "S"), ("d", "G"))


def learn_with_width(character: str, values: kit.Answer) -> Letter:
    """Learn a letter of our alphabet with kernels of the shape and width [1/N] that are set."""
    kernel, width = values["kernel"], float(values["kernel_width"])
    preset = Settings.joint if values["fit"] == "joint" else Settings.star
    settings = preset(
        kernel="mollifier" if kernel == "smooth" else "gaussian",
        kernel_width=math.inf if kernel == "bell" else width,
        kernel_sigma=max(0.2, width / 3) if kernel in ("cut", "bell") else math.inf,
        sharpen=False,
    )
    return drawing.learn_letter(character, settings)


def error_at_width(character: str, values: kit.Answer) -> float:
    """Return how far off a letter is with these settings, on average [mm]."""
    return 1000 * drawing.error_of(learn_with_width(character, values))


class BumpWidth(kit.Lesson):
    """A width that touches, between gaps and mush."""

    key = "03"
    question = marked("How wide should each bump be?")
    bet_question = marked(
        "The robot’s {first} has gone soft: its bumps are ten times too wide. How far off is it at "
        "other widths? Pull the dots to where you think."
    )
    tasks = (
        marked("Make the bumps wider and wider. What melts first?"),
        marked("Now go below 1. What happens between the bumps?"),
        marked("Learn all together, with a width from 3 to 8. Is the letter still soft?"),
    )
    challenge = marked(
        "With {shape}, learned one at a time: find one width that keeps both {first} and {second} "
        "within {limit} mm of the person’s."
    )
    hints = (
        marked("Look at the bumps in time. Do they leave gaps, just touch, or pile up?"),
        marked("Wide bumps average their neighbours. Go left, but stop before gaps open."),
        marked("At width 1 the bumps just touch. Try 1.1."),
    )
    praise = marked(
        "Width {width} keeps both: {errors}. At width 1 bumps just touch: that is enough."
    )

    def vary(self) -> None:
        self.pair, self.kernel = self.choose(PAIRS), self.choose(("box", "cut"))
        self.first, self.second = self.pair
        self.shape = _("boxes") if self.kernel == "box" else _("cut bells")
        best: kit.Answer = {"kernel_width": 1.1, "kernel": self.kernel, "fit": "lwr"}
        self.limit = math.ceil(18 * max(error_at_width(each, best) for each in self.pair)) / 10
        self.start = {**best, "kernel_width": 10.0, "letter": self.pair[0]}
        self.solution = {**best, "letter": self.pair[0]}

    @property
    def knobs(self) -> kit.Knobs:
        ends, fits = (NARROWEST, WIDEST), {"lwr": _("one bump at a time")}
        kernels = {"box": _("box"), "cut": _("cut bell"), "smooth": _("soft bell")}
        fits |= {"joint": _("all together")}
        return {
            "kernel_width": kit.Slider.of("kernel_width", *ends, is_log=True, icons=BUMP_ICONS),
            "letter": kit.OneOf(_("Letter"), {each: each for each in self.pair}, is_view=True),
            "kernel": kit.OneOf(_("Shape"), {**kernels, "bell": _("bell without ends")}),
            "fit": kit.OneOf(_("Learned"), fits),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        label = _("How far off at width {x:g}")
        return drawing.bet_on_errors(self.bet_question, BET_WIDTHS, 3.0, label)

    @property
    def curve(self) -> drawing.ErrorCurve:
        """How far off the letter that is seen is at each width."""
        ticks = [[0.25, "¼"], [1, _("1 just touching")], [4, "4"], [20, "20"]]
        x = drawing.axis(NARROWEST, WIDEST, _("how wide each bump is"), log=True, ticks=ticks)
        return drawing.ErrorCurve(
            "kernel_width", lambda v: error_at_width(v["letter"], v), x, CURVE_WIDTHS
        )

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["kernel_width"] > 12,
            v["kernel_width"] < 0.8,
            v["fit"] == "joint" and 3 <= v["kernel_width"] <= 8,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        return [
            kit.at_most(each, error_at_width(each, answer), self.limit, "mm") for each in self.pair
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        width = float(answer["kernel_width"])
        errors = self.conditions(answer)
        worst = max(errors, key=lambda each: each.number)
        return {
            # A width that leaves gaps does not look like 1.
            "width": kit.tell_number(width, 1.0, 2) if width < 1 else f"{width:.2g}",
            "errors": ", ".join(f"{each.name} {each.shown}" for each in errors),
            "letter": worst.name,
            "mm": drawing.millimetres(worst.number / 1000, self.limit),
            "share": kit.tell_number(100 * (1 - width), 0.0, 0),
        }

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        is_far = not all(each.is_met for each in self.conditions(answer))
        has_ends = answer["kernel"] != "bell"
        if is_far and has_ends and answer["kernel_width"] < 1:
            yield _(
                "Width {width} leaves gaps: for {share} % of the time no bump is awake, and the "
                "pen drifts. {letter} is {mm} mm off."
            )
        if answer["fit"] == "joint":
            yield _(
                "All together each bump is told what the others do, and at width {width} {letter} "
                "is {mm} mm off. The challenge is for bumps that learn one at a time."
            )
        if is_far and not has_ends:
            yield _(
                "A bell without ends is always awake. At width {width} it averages so many places "
                "that {letter} is {mm} mm off. The challenge is for another shape."
            )
        if not has_ends:
            yield _(
                "A bell without ends leaves no gap however narrow it is: at width {width} {letter} "
                "is {mm} mm off. The challenge is for another shape."
            )
        if answer["kernel"] != self.kernel:
            yield _("At width {width} {letter} is {mm} mm off. The challenge is for another shape.")
        if is_far:
            yield _(
                "At width {width} each bump averages what {width} places need, so bends melt. "
                "{letter} is {mm} mm off; the limit is {limit}."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        near, *_others, far = self.curve.rank(bet, self.start)
        return _(
            "You were nearest at width {near[0]:g}: you said {near[1]} mm, it is {near[2]}. The "
            "surprise is at width {far[0]:g}: you said {far[1]}, it is {far[2]} mm."
        ).format(near=near, far=far)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        values = state.values
        letter = learn_with_width(values["letter"], values)
        written, note = letter.write(), _("width {width:.2g}").format(width=values["kernel_width"])
        sheet = drawing.draw_sheet(letter.strokes, drawing.paths_of(written), note=note)
        plots = {"curve": self.curve.draw(state), "strip": drawing.draw_bumps(letter)}
        return kit.Picture(self._say(values), sheet, plots, written)

    def _say(self, values: kit.Answer) -> kit.Message:
        """Return the number and the sentence."""
        text, strong = _("The bumps just touch. "), _("The line sits on the dots.")
        width, error = float(values["kernel_width"]), error_at_width(values["letter"], values)
        is_far, is_joint = error > self.limit, values["fit"] == "joint"
        if values["kernel"] == "bell" and width < 1.2:
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
        return kit.says(drawing.millimetres(error / 1000), _("mm off on average"), text, strong)
