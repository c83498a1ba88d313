"""Lesson 05: a goal that moves (the paper's figures of one and of two degrees of freedom)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import goals
from dmp_teach.lessons.drawing import draw_sheet, goal_ring, millimetres
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

MIRRORED_LETTERS = ("S", "2", "6", "G", "e")
# Its goal is nearly straight below its start, 1 mm beside it.
STEEP = "C"
BET_POINTS = 9
# A line that is nearer to another on average [m] is like it.
ALIKE = 0.02


class MoveGoal(kit.Lesson):
    """A rule that keeps the shape, beside one that mirrors it and one that turns it."""

    key = "05"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, and whether its goal is to go up or down."""
        self.letter, self.up = MIRRORED_LETTERS[0], 1
        if random is not None:
            self.letter = MIRRORED_LETTERS[random.integers(len(MIRRORED_LETTERS))]
            self.up = (1, -1)[random.integers(2)]
        self.start = {"goal_x": 0.0, "goal_y": 0.0, "moves_at": 0.0, "rule": "original"}
        self.start["letter"] = self.letter
        led = goals.MovedLetter(self.letter, self.start)
        offset = float(led.offsets[0][0] / goals.CM)
        self.side = -1 if offset > 0 else 1
        self.latest = int(9 * led.times[-1]) / 10
        # Across the start, where the letter is mirrored and not made wider.
        self.start["goal_x"] = self.side * min(goals.ACROSS, round(2 * abs(offset), 1))
        self.solution = self.start | {"rule": "star"}
        self.solution |= {"goal_x": 10.5 * self.side, "goal_y": 4.5 * self.up}

    @property
    def question(self) -> str:
        """The title."""
        return _("What happens when the goal moves?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can set."""
        rules = {"original": _("first rule"), "printed": _("DMP* as printed")}
        rules |= {"star": "DMP*", "similarity": _("similarity")}
        low, high = sorted([self.side * goals.ACROSS, -self.side * goals.AWAY])
        x = kit.Slider(_("Goal to the right"), "g", low, high, 0.1, "cm", 1, is_drawn_here=True)
        y = kit.Slider(
            _("Goal upwards"), "g", -goals.UP, goals.UP, 0.1, "cm", 1, is_drawn_here=True
        )
        letters = {each: each for each in (self.letter, STEEP)}
        return {
            "goal_x": x,
            "goal_y": y,
            "moves_at": kit.Slider(_("When the goal moves"), "t", 0.0, self.latest, 0.1, "s", 1),
            "rule": kit.OneOf(_("Rule"), rules),
            "letter": kit.OneOf(_("Letter"), letters, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The line that the robot will write."""
        question = _(
            "The robot learned this {letter} by the first rule that was invented. Now its goal has "
            "moved to the other side of the start. Draw the line that the robot will write, from "
            "the start to the ring."
        )
        led = goals.MovedLetter(self.letter, self.start)
        u = np.linspace(0.12, 0.74, BET_POINTS)[:, None]
        places = led.primitive.start + u * led.offsets[1]
        labels = [_("Place {n} of the line").format(n=n + 1) for n in range(BET_POINTS)]
        return kit.DrawnBet(question.format(letter=self.letter), "sheet", places, labels, axis="xy")

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""

        def is_aside(v: kit.Answer) -> bool:
            return v["goal_x"] != self.start["goal_x"] and 0.5 <= abs(v["goal_x"]) <= 2

        return (
            kit.Task(
                _("Drag the ring across the start, by each rule. Which keeps the shape?"),
                lambda v: v["rule"] in ("star", "printed") and v["goal_x"] != self.start["goal_x"],
            ),
            kit.Task(
                _("Take C and the first rule. Drag its ring 1 cm aside. What becomes of C?"),
                lambda v: v["rule"] == "original" and v["letter"] == STEEP and is_aside(v),
            ),
            kit.Task(
                _("Let the goal move while the pen is on its way. What does the pen do?"),
                lambda v: v["moves_at"] > 0.2 * self.latest,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "Lead the goal of the {letter} at least {x:g} cm {aside} and {y:g} cm {up}. At least "
            "{least:g} % of the line must go the way that the person’s went, and the pen must stop "
            "at its goal."
        )
        return words.format(
            x=goals.ASIDE, y=goals.UPWARDS, least=goals.LEAST_SHARE, **self._wanted()
        )

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        solution = _(
            "Take DMP*, let the goal move at 0.0 s, and put it {x:.1f} cm {aside} and {y:.1f} cm "
            "{up}."
        )
        x, y = (abs(self.solution[name]) for name in ("goal_x", "goal_y"))
        return (
            _("One rule multiplies the letter, one turns it, one slides it. Which do you need?"),
            _("Slide it, from the very beginning on. And look where the pen stops."),
            solution.format(x=x, y=y, **self._wanted()),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how far the goal moved, how much kept its way, and where the pen stops."""
        led, wanted = goals.MovedLetter(self.letter, answer), self._wanted()
        x, y = map(float, led.shift * (self.side, self.up))
        return [
            kit.at_least(wanted["aside"], x, goals.ASIDE, "cm"),
            kit.at_least(wanted["up"], y, goals.UPWARDS, "cm"),
            kit.at_least(_("the same way"), led.share, goals.LEAST_SHARE, "%"),
            kit.at_most(_("from the goal"), led.miss, goals.MOST_MISS, "mm"),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is wrong with the rule, the moment or the place."""
        led = goals.MovedLetter(self.letter, answer)
        aside, up, same, from_goal = (each.is_met for each in self.conditions(answer))
        is_multiplied_or_turned = answer["rule"] in ("original", "similarity")
        same_way = _(" {share} % of the line goes the same way.")
        jumps = _(
            "At {s:.1f} s a part of the {letter} is written already; then the pen runs after its "
            "goal at {hurry:.0f} cm/s."
        )
        lags = _(
            "As printed, DMP* does not tell the pen how the way grows: the pen is always late, and "
            "stops {mm} mm from its goal."
        )
        hasty = _("At {s:.1f} s the goal moves too late: the pen stops {mm} mm from it.")
        leans = _("A goal {cm:.1f} cm away slides the {letter} so far that it leans.")
        short = _("The goal has moved {x} cm {x_way}; it is to move {x_least:g} cm {aside}.")
        low = _("The goal has moved {y} cm {y_way}; it is to move {y_least:g} cm {up}.")
        found = [
            (not same and is_multiplied_or_turned, "".join(goals.tell_rule(led)) + same_way),
            (not same and answer["moves_at"] > 0, jumps + same_way),
            (not from_goal and answer["rule"] == "printed", lags),
            (not from_goal, hasty),
            (not same, leans + same_way),
            (not aside, short),
            (not up, low),
        ]
        facts = led.facts | {"x_least": goals.ASIDE, "y_least": goals.UPWARDS} | self._wanted()
        facts["x_way"], facts["y_way"] = _ways(*led.shift)
        return [(is_made, words.format(**facts)) for is_made, words in found]

    def _wanted(self) -> dict[str, str]:
        """Return the letter, and where its goal is to go."""
        aside, up = _ways(self.side, self.up)
        return {"letter": self.letter, "aside": aside, "up": up}

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "{share} % of the {letter} goes the same way, {cm:.1f} cm from its old goal. The "
            "first rule would have multiplied it by {fx} sideways."
        )
        return words.format(**goals.MovedLetter(self.letter, answer).facts)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return how far the drawn line is from the robot's, and whose it is like."""
        led = goals.MovedLetter(self.letter, self.start)
        slid = goals.MovedLetter(self.letter, self.start | {"rule": "star"})
        off, off_slid = (goals.mean_distance(np.array(bet), each.path) for each in (led, slid))
        words = _(
            "On average your line is {off} mm from the robot’s. The first rule multiplies the "
            "{letter} by {fx} sideways: it is mirrored."
        )
        told = words.format(off=millimetres(off), **led.facts)
        if off < ALIKE:
            return f"{told} {_('You saw that coming.')}"
        if off_slid < ALIKE:
            return f"{told} {_('You kept the shape, as a newer rule does.')}"
        return f"{told} {_('A newer rule keeps the shape.')}"

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the letter, and one coordinate of it over time by two rules."""
        led = goals.MovedLetter(str(state.values["letter"]), state.values)
        is_hidden = state.step == "bet" and not state.is_revealed
        sheet = draw_sheet(
            led.strokes,
            [] if is_hidden else [led.following],
            box=led.box(self.side),
            rings=[goal_ring(led.primitive.goal, state.step == "bet")],
            caption=_("On paper"),
            **({} if state.values == self.start else {"bet": []}),
        )
        plots = self._draw_plots(led, is_hidden, state.step != "bet")
        says = self._ask(led) if is_hidden else _say(led)
        strokes = () if is_hidden else (Trajectory(led.primitive.times, led.path),)
        return kit.Picture(says, sheet, plots, strokes)

    def _draw_plots(
        self, led: goals.MovedLetter, is_hidden: bool, has_knob: bool
    ) -> dict[str, kit.Drawing]:
        """Draw left and right over time, and the velocity, by this rule and by another one."""
        names = {"original": _("first"), "similarity": _("similarity")}
        rule = str(led.values["rule"])
        other = "star" if rule == "original" else "original"
        beside = goals.MovedLetter(led.character, led.values | {"rule": other})
        x = {"label": "", "low": 0.0, "high": float(led.times[-1])}
        plots: dict[str, kit.Drawing] = {}
        for order, name in enumerate(("position", "velocity")):
            lines: list[kit.Drawing] = [{"points": led.person_sideways(order), "kind": "child"}]
            for each, kind in () if is_hidden else ((beside, "quiet"), (led, "robot")):
                label = names.get(str(each.values["rule"]), "DMP*")
                lines.append({"points": each.sideways(order), "kind": kind, "label": label})
            plots[name] = {"x": x, "y": led.sideways_axis(order, self.side), "lines": lines}
        plots["position"] |= {"caption": _("To the right of its start [cm]")}
        plots["velocity"] |= {"caption": _("Speed to the right [cm/s]")}
        plots["velocity"]["x"] = x | {"label": _("time [s]")}
        if has_knob:
            s = float(led.values["moves_at"])
            knob = {"name": "moves_at", "axis": "x", "value": s, "text": f"{s:.1f} s"}
            knob |= {"low": 0.0, "high": self.latest, "step": 0.1, "label": _("goal moves")}
            plots["position"]["thresholds"] = [knob]
        return plots

    def _ask(self, led: goals.MovedLetter) -> dict[str, str]:
        """Return what is said before the truth is seen."""
        text = _("is how far the goal has moved, to the other side of the start. ")
        says = {"number": f"{abs(led.shift[0]):.1f}", "unit": "cm", "text": text}
        return says | {"strong": _("What will the robot write?"), "after": ""}


def _say(led: goals.MovedLetter) -> dict[str, str]:
    """Return the number and the sentence."""
    strong, after = goals.tell_rule(led)
    text = ""
    if led.values["moves_at"]:
        after += _(" The pen runs after its goal at {hurry:.0f} cm/s.")
    if not led.shift.any():
        text, strong, after = _("The goal is where it was. "), _("Drag the ring."), ""
    says = {"text": text, "strong": strong, "after": after}
    says = {name: words.format(**led.facts) for name, words in says.items()}
    return {"number": led.facts["share"], "unit": _("% the same way"), **says}


def _ways(x: float, y: float) -> tuple[str, str]:
    """Return the words for a way aside and one up or down."""
    aside = _("to the right") if x >= 0 else _("to the left")
    return aside, _("up") if y >= 0 else _("down")
