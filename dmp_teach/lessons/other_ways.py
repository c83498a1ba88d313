"""Lesson 12: the other ways to learn that the paper names, beside DMP*."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import five_ways
from dmp_teach.lessons.drawing import draw_sheet, goal_ring, goal_slider
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

REACH = 7.0


class OtherWays(kit.Lesson):
    """One demonstration or many, a moved goal, and how much must be stored: no way wins all."""

    key = "12"
    # Numbers that may be stored; and so many takes of the letter are several.
    most, several = 100, 5
    question = marked("Are there other ways to learn?")
    bet_question = marked(
        "Five ways to learn have seen one {letter}. Now its goal moves to the ring. Which way can "
        "still write the whole {letter} and end there? And which cannot go there yet, until it has "
        "seen several?"
    )
    tasks = (
        marked("Go through the five ways. Which take the whole letter along, which only its end?"),
        marked("Take spread. How many letters must it see until it reaches the ring?"),
        marked("Show more letters to DMP*, then to cost. Which of them gets nearer?"),
    )
    challenge = marked(
        "A hand slips a little in each {letter}. The goal is at home again. Let the robot write "
        "the {letter} that was meant, within {limit} mm, with as few letters shown as will do, and "
        "store at most {most} numbers."
    )
    hints = (
        marked(
            "One letter has its slips. Which ways take the mean of several, and which does not?"
        ),
        marked("Of those that do, only one stores few numbers. Then show fewer letters."),
        marked("Take cost, and show {needed} letters."),
    )
    praise = marked(
        "With the goal at home, cost found the {letter} that was meant from {shown}, within "
        "{error} mm, in {numbers} numbers; DMP* is {off} mm off, in {others}. With the goal moved, "
        "{kept} % of the shape is kept by DMP*, {share} % by cost: no way is best."
    )

    def vary(self) -> None:
        self.letter = self.choose(tuple(five_ways.LED_LETTERS))
        random = self.random or np.random.default_rng(2)
        self.hand, self.needed, self.limit = five_ways.find_hand(self.letter, random)
        self.shift = five_ways.LED_LETTERS[self.letter]
        self.start = {"way": "dmp", "shown": 1, "goal_x": self.shift[0], "goal_y": self.shift[1]}
        self.solution = self.start | {"way": "cost", "shown": self.needed}

    @property
    def knobs(self) -> kit.Knobs:
        # Where the goal is, is no part of the answer.
        names = five_ways.way_names()
        options = {key: names[key] for key in five_ways.ways_here()}
        return {
            "way": kit.OneOf(_("Way to learn"), options),
            "shown": kit.Slider(_("Letters shown"), "n", 1, five_ways.TAKES_AT_HAND),
            "goal_x": goal_slider(
                _("Goal to the right"), -REACH, REACH, is_view=True, is_for_try=True
            ),
            "goal_y": goal_slider(_("Goal upwards"), -REACH, REACH, is_view=True, is_for_try=True),
        }

    @property
    def bet(self) -> kit.ChosenBet:
        options = {
            "spread-dmp": _("spread can, DMP* not yet"),
            "dmp-spread": _("DMP* can, spread not yet"),
            "cost-mixture": _("cost can, mixture not yet"),
            "mixture-states": _("mixture can, states not yet"),
        }
        return kit.ChosenBet(self.bet_question, options)

    def _led(self, values: kit.Answer) -> five_ways.Led:
        """Return what is written by a way, with the goal that is set or that of the bet."""
        values = self.start | values
        shift = float(values["goal_x"]), float(values["goal_y"])
        way, shown = str(values["way"]), int(values["shown"])
        return five_ways.Led(self.letter, self.hand, way, shown, shift)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["way"] in ("states", "cost"),
            v["way"] == "spread" and v["shown"] >= self.several,
            v["way"] == "cost" and v["shown"] >= self.several,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        led = self._led(answer)
        return [
            kit.at_most(_("off what was meant"), led.error, self.limit, "mm"),
            kit.at_most(_("numbers stored"), led.tried.way.numbers_stored, self.most),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        led = self._led(answer)
        star = replace(led, key="dmp")
        return led.facts | {
            **{"others": star.tried.way.numbers_stored, "kept": f"{star.share:.0f}"},
            "error": kit.tell_number(led.error, self.limit),
            "off": kit.tell_number(star.error, self.limit),
        }

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        is_near, is_small = (each.is_met for each in self.conditions(answer))
        if not is_small:
            yield _(
                "With {shown} shown, {way} is {error} mm off, and it stores {numbers} numbers; "
                "{most} are allowed."
            )
        if not is_near and answer["way"] == "dmp":
            yield _(
                "DMP* was shown {shown}, and learned the first alone, with its slips: {error} mm "
                "off; the limit is {limit}."
            )
        if not is_near:
            yield _(
                "The mean of {shown} still has some of their slips: {error} mm off; the limit is "
                "{limit}."
            )
        if answer["shown"] > self.needed:
            yield _(
                "With {shown} shown it is {error} mm off. That will do, but fewer will do, too."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        words = marked(
            "DMP* took the whole {letter} along: {dmp:.0f} % kept its shape. With cost only the "
            "end follows: {cost:.0f} % did. Spread stays {miss:.0f} mm away; shown {several}, it "
            "gets there, and bends the {letter}. "
        )
        said = _("You said: {bet}.").format(bet=self.bet.options[bet])
        said = _("Just as you said.") if bet == "dmp-spread" else said
        dmp, cost, spread = (
            self._led(self.start | {"way": way}) for way in ("dmp", "cost", "spread")
        )
        facts = {"dmp": dmp.share, "cost": cost.share, "miss": spread.miss}
        return self.tell(words, **facts) + said

    def draw(self, state: kit.LessonState) -> kit.Picture:
        is_hidden, is_home = state.is_hidden, state.step == "challenge"
        led, home = self._led(state.values), five_ways.meant_by(self.letter)[-1]
        takes = five_ways.takes_of(self.letter, self.hand)[: led.shown]
        ring = goal_ring(home, state.step != "try") | ({"at": home[None]} if is_home else {})
        extras = [{"points": each.position, "kind": "hand"} for each in takes[1:]]
        note = _("{n} shown, dotted")
        if state.step == "try":
            extras.append({"points": led.tried.letter.position, "kind": "quiet"})
            note = _("{n} shown; faint: goal at home")
        sheet = draw_sheet(
            takes[:1],
            [led.tried.letter.position if is_home else led.line][: not is_hidden],
            box=five_ways.box_around(self._led(self.start), REACH),
            rings=[ring],
            note=note.format(n=led.shown),
            extras=extras,
        )
        strokes = (led.tried.letter if is_home else led.tried.moved,)[: not is_hidden]
        says = five_ways.say_way(led, is_home)
        if is_hidden:
            text, unit = _("Each way has seen the dotted letter, once."), _("cm the goal moved")
            says = kit.says(f"{np.hypot(*self.shift):.1f}", unit, text)
            plots = {"ways": five_ways.list_ways()}
        elif is_home:
            tried = {(str(each["way"]), int(each["shown"])) for each in state.tried}
            letters = [self._led({"way": way, "shown": n}) for way, n in tried]
            plots = {"error": five_ways.draw_errors([*letters, led], self.limit)}
        else:
            plots = {"ways": five_ways.draw_side_by_side(led)}
        return kit.Picture(says, sheet, plots, strokes)
