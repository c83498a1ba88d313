"""Lesson 05: a goal that moves (the paper's figures of one and of two degrees of freedom)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import goals
from dmp_teach.lessons.drawing import draw_sheet, goal_ring, goal_slider, line, millimetres, plot
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
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
    x_least, y_least, least = goals.ASIDE, goals.UPWARDS, goals.LEAST_SHARE
    try_x, try_y = 10.5, 4.5
    question = marked("What happens when the goal moves?")
    bet_question = marked(
        "The robot learned this {letter} by the first rule that was invented. Now its goal has "
        "moved to the other side of the start. Draw the line that the robot will write, from the "
        "start to the ring."
    )
    tasks = (
        marked("Drag the ring across the start, by each rule. Which keeps the shape?"),
        marked("Take C and the first rule. Drag its ring 1 cm aside. What becomes of C?"),
        marked("Let the goal move while the pen is on its way. What does the pen do?"),
    )
    challenge = marked(
        "Lead the goal of the {letter} at least {x_least:g} cm {aside} and {y_least:g} cm {up}. At "
        "least {least:g} % of the line must go the way that the person’s went, and the pen must "
        "stop at its goal."
    )
    hints = (
        marked("One rule multiplies the letter, one turns it, one slides it. Which do you need?"),
        marked("Slide it, from the very beginning on. And look where the pen stops."),
        marked(
            "Take DMP*, let the goal move at 0.0 s, and put it {try_x:.1f} cm {aside} and "
            "{try_y:.1f} cm {up}."
        ),
    )
    praise = marked(
        "{share} % of the {letter} goes the same way, {cm:.1f} cm from its old goal. The first "
        "rule would have multiplied it by {fx} sideways."
    )

    def vary(self) -> None:
        self.letter, self.rise = self.choose(MIRRORED_LETTERS), self.choose((1, -1))
        self.start = {"goal_x": 0.0, "goal_y": 0.0, "moves_at": 0.0, "rule": "original"}
        self.start["letter"] = self.letter
        led = goals.MovedLetter(self.letter, self.start)
        offset = float(led.offsets[0][0] / goals.CM)
        self.side = -1 if offset > 0 else 1
        self.latest = int(9 * led.times[-1]) / 10
        # Across the start, where the letter is mirrored and not made wider.
        self.start["goal_x"] = self.side * min(goals.ACROSS, round(2 * abs(offset), 1))
        self.solution = self.start | {"rule": "star"}
        self.solution |= {"goal_x": self.try_x * self.side, "goal_y": self.try_y * self.rise}
        self.aside, self.up = _ways(self.side, self.rise)

    @property
    def knobs(self) -> kit.Knobs:
        rules = {"original": _("first rule"), "printed": _("DMP* as printed")}
        rules |= {"star": "DMP*", "similarity": _("similarity")}
        low, high = sorted([self.side * goals.ACROSS, -self.side * goals.AWAY])
        letters = {each: each for each in (self.letter, STEEP)}
        return {
            "goal_x": goal_slider(_("Goal to the right"), low, high),
            "goal_y": goal_slider(_("Goal upwards"), -goals.UP, goals.UP),
            "moves_at": kit.Slider(_("When the goal moves"), "t", 0.0, self.latest, 0.1, "s", 1),
            "rule": kit.OneOf(_("Rule"), rules),
            "letter": kit.OneOf(_("Letter"), letters, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        led = goals.MovedLetter(self.letter, self.start)
        u = np.linspace(0.12, 0.74, BET_POINTS)[:, None]
        places = led.primitive.start + u * led.offsets[1]
        label = _("Place {n} of the line")
        return kit.DrawnBet(self.bet_question, "sheet", places, label, axis="xy")

    def done(self, v: kit.Answer) -> Sequence[bool]:
        home = self.start["goal_x"]
        return (
            v["rule"] in ("star", "printed") and v["goal_x"] != home,
            (v["rule"], v["letter"]) == ("original", STEEP)
            and (v["goal_x"] != home and 0.5 <= abs(v["goal_x"]) <= 2),
            v["moves_at"] > 0.2 * self.latest,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        led = goals.MovedLetter(self.letter, answer)
        x, y = map(float, led.shift * (self.side, self.rise))
        return [
            kit.at_least(self.aside, x, self.x_least, "cm"),
            kit.at_least(self.up, y, self.y_least, "cm"),
            kit.at_least(_("the same way"), led.share, self.least, "%"),
            kit.at_most(_("from the goal"), led.miss, goals.MOST_MISS, "mm"),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        led = goals.MovedLetter(self.letter, answer)
        x_way, y_way = _ways(*led.shift)
        return led.facts | {"x_way": x_way, "y_way": y_way}

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        aside, up, same, from_goal = (each.is_met for each in self.conditions(answer))
        same_way = _(" {share} % of the line goes the same way.")
        if not same and answer["rule"] in ("original", "similarity"):
            rule = goals.tell_rule(goals.MovedLetter(self.letter, answer))
            yield "".join(rule) + same_way
        if not same and answer["moves_at"] > 0:
            jumps = _(
                "At {s:.1f} s a part of the {letter} is written already; then the pen runs after "
                "its goal at {hurry:.0f} cm/s."
            )
            yield jumps + same_way
        if not from_goal and answer["rule"] == "printed":
            yield _(
                "As printed, DMP* does not tell the pen how the way grows: the pen is always late, "
                "and stops {mm} mm from its goal."
            )
        if not from_goal:
            yield _("At {s:.1f} s the goal moves too late: the pen stops {mm} mm from it.")
        if not same:
            leans = _("A goal {cm:.1f} cm away slides the {letter} so far that it leans.")
            yield leans + same_way
        if not aside:
            yield _("The goal has moved {x} cm {x_way}; it is to move {x_least:g} cm {aside}.")
        if not up:
            yield _("The goal has moved {y} cm {y_way}; it is to move {y_least:g} cm {up}.")

    def tell_bet(self, bet: kit.KeptBet) -> str:
        led = goals.MovedLetter(self.letter, self.start)
        slid = goals.MovedLetter(self.letter, self.start | {"rule": "star"})
        off, off_slid = (goals.mean_distance(np.array(bet), each.path) for each in (led, slid))
        words = _(
            "On average your line is {off} mm from the robot’s. The first rule multiplies the "
            "{letter} by {fx} sideways: it is mirrored."
        )
        like = _("A newer rule keeps the shape.")
        if off < ALIKE:
            like = _("You saw that coming.")
        elif off_slid < ALIKE:
            like = _("You kept the shape, as a newer rule does.")
        return f"{words.format(off=millimetres(off), **led.facts)} {like}"

    def draw(self, state: kit.LessonState) -> kit.Picture:
        led = goals.MovedLetter(str(state.values["letter"]), state.values)
        is_hidden = state.is_hidden
        sheet = draw_sheet(
            led.strokes,
            [] if is_hidden else [led.following],
            box=led.box(self.side),
            rings=[goal_ring(led.primitive.goal, state.step == "bet")],
            **({} if state.values == self.start else {"bet": []}),
        )
        plots = self._draw_plots(led, is_hidden)
        if state.step != "bet":
            s = float(led.values["moves_at"])
            knob = {"name": "moves_at", "axis": "x", "value": s, "text": f"{s:.1f} s"}
            knob |= {"low": 0.0, "high": self.latest, "step": 0.1, "label": _("goal moves")}
            plots["position"]["thresholds"] = [knob]
        if is_hidden:
            text = _("is how far the goal has moved, to the other side of the start. ")
            number, strong = f"{abs(led.shift[0]):.1f}", _("What will the robot write?")
            return kit.Picture(kit.says(number, "cm", text, strong), sheet, plots)
        written = Trajectory(led.primitive.times, led.path)
        return kit.Picture(_say(led), sheet, plots, (written,))

    def _draw_plots(self, led: goals.MovedLetter, is_hidden: bool) -> dict[str, kit.Drawing]:
        """Draw left and right over time, and the velocity, by this rule and by another one."""
        names = {"original": _("first"), "similarity": _("similarity")}
        other = "star" if led.values["rule"] == "original" else "original"
        beside = goals.MovedLetter(led.character, led.values | {"rule": other})
        drawn = () if is_hidden else ((beside, "quiet"), (led, "robot"))
        captions = {"position": _("To the right of its start [cm]")}
        captions["velocity"] = _("Speed to the right [cm/s]")
        plots: dict[str, kit.Drawing] = {}
        for order, (name, caption) in enumerate(captions.items()):
            lines = [line(led.person_sideways(order), "child")]
            for each, kind in drawn:
                label = names.get(str(each.values["rule"]), "DMP*")
                lines.append(line(each.sideways(order), kind, label))
            x = {"low": 0.0, "high": float(led.times[-1]), "label": _("time [s]") if order else ""}
            plots[name] = plot(caption, x, led.sideways_axis(order, self.side), lines=lines)
        return plots


def _say(led: goals.MovedLetter) -> kit.Message:
    text, (strong, after) = "", goals.tell_rule(led)
    if led.values["moves_at"]:
        after += _(" The pen runs after its goal at {hurry:.0f} cm/s.")
    if not led.shift.any():
        text, strong, after = _("The goal is where it was. "), _("Drag the ring."), ""
    told = (words.format(**led.facts) for words in (text, strong, after))
    return kit.says(led.facts["share"], _("% the same way"), *told)


def _ways(x: float, y: float) -> tuple[str, str]:
    """Return the words for a way aside and one up or down."""
    aside = _("to the right") if x >= 0 else _("to the left")
    return aside, _("up") if y >= 0 else _("down")
