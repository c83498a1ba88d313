"""Lesson 12: the other ways to learn that the paper names, beside DMP*."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import five_ways
from dmp_teach.lessons.drawing import draw_sheet, goal_ring
from dmp_teach.texts import gettext as _

REACH = 7.0
NUMBERS_ALLOWED = 100
# What the bet is on: this many takes of the letter are several.
SEVERAL = 5


class OtherWays(kit.Lesson):
    """One demonstration or many, a moved goal, and how much must be stored: no way wins all."""

    key = "12"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, whose hand, and how near is near enough."""
        self.letter = "S" if random is None else str(random.choice(list(five_ways.LED_LETTERS)))
        random = random or np.random.default_rng(2)
        self.hand, self.needed, self.limit = five_ways.find_hand(self.letter, random)
        self.shift = five_ways.LED_LETTERS[self.letter]
        goal = {"goal_x": self.shift[0], "goal_y": self.shift[1]}
        self.start = {"way": "dmp", "shown": 1, **goal}
        self.solution = {"way": "cost", "shown": self.needed, **goal}

    @property
    def question(self) -> str:
        """The title."""
        return _("Are there other ways to learn?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can set; where the goal is, is no part of the answer."""
        names = five_ways.way_names()
        options = {key: names[key] for key in five_ways.ways_here()}
        x, y = (
            kit.Slider(
                label,
                "g",
                -REACH,
                REACH,
                0.1,
                "cm",
                1,
                is_drawn_here=True,
                is_view=True,
                is_for_try=True,
            )
            for label in (_("Goal to the right"), _("Goal upwards"))
        )
        return {
            "way": kit.OneOf(_("Way to learn"), options),
            "shown": kit.Slider(_("Letters shown"), "n", 1, five_ways.TAKES_AT_HAND),
            "goal_x": x,
            "goal_y": y,
        }

    @property
    def bet(self) -> kit.ChosenBet:
        """Which way needs one letter, and which needs several."""
        question = _(
            "Five ways to learn have seen one {letter}. Now its goal moves to the ring. Which way "
            "can still write the whole {letter} and end there? And which cannot go there yet, "
            "until it has seen several?"
        )
        options = {
            "spread-dmp": _("spread can, DMP* not yet"),
            "dmp-spread": _("DMP* can, spread not yet"),
            "cost-mixture": _("cost can, mixture not yet"),
            "mixture-states": _("mixture can, states not yet"),
        }
        return kit.ChosenBet(question.format(letter=self.letter), options)

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _(
                    "Go through the five ways. Which take the whole letter along, which only "
                    "its end?"
                ),
                lambda v: v["way"] in ("states", "cost"),
            ),
            kit.Task(
                _("Take spread. How many letters must it see until it reaches the ring?"),
                lambda v: v["way"] == "spread" and v["shown"] >= SEVERAL,
            ),
            kit.Task(
                _("Show more letters to DMP*, then to cost. Which of them gets nearer?"),
                lambda v: v["way"] == "cost" and v["shown"] >= SEVERAL,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "A hand slips a little in each {letter}. The goal is at home again. Let the robot "
            "write the {letter} that was meant, within {limit} mm, with as few letters shown as "
            "will do, and store at most {numbers} numbers."
        )
        return words.format(letter=self.letter, limit=self.limit, numbers=NUMBERS_ALLOWED)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        return (
            _("One letter has its slips. Which ways take the mean of several, and which does not?"),
            _("Of those that do, only one stores few numbers. Then show fewer letters."),
            _("Take cost, and show {n} letters.").format(n=self.needed),
        )

    def _led(self, answer: kit.Answer, **other: object) -> five_ways.Led:
        """Return what an answer writes, with the goal of the challenge or another one."""
        values = answer | other
        shift = (
            float(values.get("goal_x", self.shift[0])),
            float(values.get("goal_y", self.shift[1])),
        )
        return five_ways.Led(
            self.letter, self.hand, str(values["way"]), int(values["shown"]), shift
        )

    def _judged(self, answer: kit.Answer, **other: object) -> five_ways.Led:
        """Return what an answer writes to the goal of the challenge."""
        return self._led({name: answer[name] for name in ("way", "shown")}, **other)

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how near it is with its goal at home, and how much it stores."""
        led = self._judged(answer)
        return [
            kit.at_most(_("off what was meant"), led.error, self.limit, "mm"),
            kit.at_most(_("numbers stored"), led.tried.way.numbers_stored, NUMBERS_ALLOWED),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is wrong with the way, or with the number of letters."""
        led = self._judged(answer)
        is_near, is_small = (each.is_met for each in self.conditions(answer))
        facts = self._facts(led)
        large = _(
            "With {shown} shown, {way} is {error} mm off, and it stores {numbers} numbers; {most} "
            "are allowed."
        )
        slips = _(
            "DMP* was shown {shown}, and learned the first alone, with its slips: {error} mm off; "
            "the limit is {limit}."
        )
        few = _(
            "The mean of {shown} still has some of their slips: {error} mm off; the limit is "
            "{limit}."
        )
        many = _("With {shown} shown it is {error} mm off. That will do, but fewer will do, too.")
        found = [
            (not is_small, large),
            (not is_near, slips if led.key == "dmp" else few),
            (led.shown > self.needed, many),
        ]
        return [(is_made, words.format(**facts)) for is_made, words in found]

    def _facts(self, led: five_ways.Led) -> dict[str, object]:
        """Return what sentences name."""
        facts = {"letter": self.letter, "limit": self.limit, "most": NUMBERS_ALLOWED}
        return facts | led.facts | {"error": kit.tell_number(led.error, self.limit)}

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found, and what it costs."""
        led = self._judged(answer)
        words = _(
            "With the goal at home, cost found the {letter} that was meant from {shown}, within "
            "{error} mm, in {numbers} numbers; DMP* is {off} mm off, in {others}. With the goal "
            "moved, {kept} % of the shape is kept by DMP*, {share} % by cost: no way is best."
        )
        star = self._judged(answer, way="dmp")
        more = {
            **{"others": star.tried.way.numbers_stored, "kept": f"{star.share:.0f}"},
            "off": kit.tell_number(star.error, self.limit),
        }
        return words.format(**self._facts(led), **more)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return what each way wrote after one letter, and spread after several."""
        words = _(
            "DMP* took the whole {letter} along: {dmp} % kept its shape. With cost only the end "
            "follows: {cost} % did. Spread stays {miss} mm away; shown {n}, it gets "
            "there, and bends the {letter}. "
        )
        said = _("You said: {bet}.").format(bet=self.bet.options[bet])
        said = _("Just as you said.") if bet == "dmp-spread" else said
        one = {key: self._judged(self.start, way=key) for key in ("dmp", "cost", "spread")}
        shares = {key: f"{one[key].share:.0f}" for key in ("dmp", "cost")}
        miss = f"{one['spread'].miss:.0f}"
        return words.format(letter=self.letter, n=SEVERAL, miss=miss, **shares) + said

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw takes, the line to the ring and the one to its home; all ways; and the error."""
        is_hidden = state.step == "bet" and not state.is_revealed
        led = self._led(state.values)
        takes = five_ways.takes_of(self.letter, self.hand)[: led.shown]
        home = five_ways.meant_by(self.letter)[-1]
        is_home = state.step == "challenge"
        lines = [led.tried.letter.position if is_home else led.line][: not is_hidden]
        ring = goal_ring(home, state.step != "try") | ({"at": home[None]} if is_home else {})
        extras: list[kit.Drawing] = [
            {"points": each.position, "kind": "hand"} for each in takes[1:]
        ]
        note = _("{n} shown, dotted")
        if state.step == "try":
            extras.append({"points": led.tried.letter.position, "kind": "quiet"})
            note = _("{n} shown; faint: goal at home")
        sheet = draw_sheet(
            takes[:1],
            lines,
            box=five_ways.box_around(self._judged(self.start), REACH),
            rings=[ring],
            caption=_("On paper"),
            note=note.format(n=led.shown),
            extras=extras,
        )
        strokes = (led.tried.letter if is_home else led.tried.moved,)[: not is_hidden]
        plots = {"ways": self._draw_ways(led, is_hidden)}
        if is_home:
            plots = {"error": self._draw_errors(state, led)}
        return kit.Picture(
            self._ask() if is_hidden else five_ways.say_way(led, is_home), sheet, plots, strokes
        )

    def _draw_ways(self, led: five_ways.Led, is_hidden: bool) -> kit.Drawing:
        """Say how ways learn; once the bet is placed, draw what all write of so many letters."""
        if is_hidden:
            return five_ways.list_ways() | {"caption": _("How each way learns")}
        letters = {key: replace(led, key=key) for key in five_ways.ways_here()}
        note = (_("{n} shown") if led.shown > 1 else _("one shown")).format(n=led.shown)
        return five_ways.draw_side_by_side(letters, led) | {
            "caption": _("Each way, to the ring"),
            "note": note,
        }

    def _draw_errors(self, state: kit.LessonState, led: five_ways.Led) -> kit.Drawing:
        """Draw how far from what was meant each way was with each number that was tried."""
        tried = {(str(each["way"]), int(each["shown"])) for each in state.tried}
        letters = [self._judged({"way": way, "shown": n}) for way, n in tried]
        return five_ways.draw_errors([*letters, led], self.limit)

    def _ask(self) -> dict[str, str]:
        """Return what is said before the truth is seen."""
        x, y = self.shift
        number = f"{np.hypot(x, y):.1f}"
        text = _("Each way has seen the dotted letter, once.")
        says = {"number": number, "unit": _("cm the goal moved"), "text": text}
        return says | {"strong": "", "after": ""}
