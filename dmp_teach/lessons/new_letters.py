"""Lesson 07: a letter that nobody has shown, in whose hand (the paper's figure of D and P)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.drawing import goal_slider
from dmp_teach.lessons.new_letters_pictures import draw_blind, draw_letter, draw_speed, draw_whose
from dmp_teach.lessons.two_hands import BOWL, NewLetter, find_goals
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

THIRD_STROKES = {"P": "none", "R": "stem", "B": "bowl"}
SHARES = (30, 50, 70, 130)
MOST_GAP, MOST_END_OFF = 2.0, 6.0


class NewLetters(kit.Lesson):
    """A D becomes a P, an R or a B by other goals, between two hands."""

    key = "07"
    low, high = 40, 60
    question = marked("Can a robot write a letter that nobody showed it?")
    bet_question = marked(
        "Two hands wrote a D. From the bowl of one of them the robot has made the bowl of a P, by "
        "moving its end. Whose bowl is it?"
    )
    tasks = (
        marked("Drag the ring to the middle of the stem. Which letter is it now?"),
        marked("Take a third stroke from the shelf, and drag its ring. Can you make an R? A B?"),
        marked("Go from hand 1 to hand 2, and beyond 100 %. Whose bowl is it half way?"),
        marked("Write it in one line. At which joint does the pen no longer stop?"),
    )
    challenge = marked("{ask} The stem must lean by {asked}°, more or less one degree.")
    hints = (
        marked("Set how much of hand 2 first: when the stem leans, every goal must follow it."),
        marked("Then put the ring of the bowl on the middle of the stem.{more}"),
        marked(
            "Take {solution[share]} % of hand 2. Move the bowl’s end {solution[goal_x]:.1f} cm "
            "right and {solution[goal_y]:.1f} cm up.{end}"
        ),
    )
    praise = marked(
        "Nobody showed this {letter}: {share} % of it is by hand 2, and its bowl ends {mm} mm from "
        "the stem, {up:.0f} % up."
    )

    def vary(self) -> None:
        share, self.whose = 50, 2
        self.letter = self.choose(tuple(THIRD_STROKES))
        if self.random is not None:
            share, self.whose = self.choose(SHARES), self.choose((1, 2))
        self.third = THIRD_STROKES[self.letter]
        moved = dict.fromkeys(("goal_x", "goal_y", "third_x", "third_y"), 0.0)
        self.start: kit.Answer = moved | {"share": 0, "third": "none", "way": "lifted"}
        self.solution = find_goals(self.start | {"share": share, "third": self.third})
        self.asked, self.wanted = round(NewLetter(self.solution).lean), _shelf()[self.third]
        self.strokes, self.more, self.end = 2 if self.third == "none" else 3, "", ""
        if self.third != "none":
            more = marked(" Take “{wanted}” from the shelf, and see where its ring must go.")
            end = marked(
                " Take “{wanted}” from the shelf: its end {solution[third_x]:.1f} cm right and "
                "{solution[third_y]:.1f} cm up."
            )
            self.more, self.end = self.tell(more), self.tell(end)
        ask = {
            "P": marked(
                "Make a P whose bowl meets the stem, from {low} to {high} % of its height."
            ),
            "R": marked(
                "Make an R: its bowl meets the stem from {low} to {high} % of its height, and "
                "its leg ends on the writing line, right under the widest place of the bowl."
            ),
            "B": marked(
                "Make a B: its bowl meets the stem from {low} to {high} % of its height, and a "
                "second bowl ends at the foot of the stem."
            ),
        }
        self.ask = self.tell(ask[self.letter])

    @property
    def knobs(self) -> kit.Knobs:
        ways = {"lifted": _("lift the pen"), "joined": _("in one line")}
        return {
            "goal_x": goal_slider(_("Bowl’s end, sideways"), -4.0, 6.0),
            "goal_y": goal_slider(_("Bowl’s end, upwards"), -2.0, 10.0),
            "share": kit.Slider(_("How much of hand 2"), "", -50, 150, 5, "%", is_drawn_here=True),
            "third": kit.OneOf(_("From the shelf"), _shelf()),
            "third_x": goal_slider(_("Third end, sideways"), -4.0, 14.0),
            "third_y": goal_slider(_("Third end, upwards"), -4.0, 10.0),
            "way": kit.OneOf(_("Between strokes"), ways, is_view=True),
        }

    @property
    def bet(self) -> kit.ChosenBet:
        hands = {"1": _("hand 1"), "2": _("hand 2"), "none": _("nobody can tell")}
        return kit.ChosenBet(self.bet_question, hands)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["goal_y"] >= 4,
            v["third"] != "none" and np.hypot(v["third_x"], v["third_y"]) > 1,
            v["share"] > 100,
            v["way"] == "joined",
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        made = NewLetter(answer)
        asked = [
            kit.exactly(_("strokes"), 2 if made.third == "none" else 3, self.strokes),
            kit.at_most(_("bowl to stem"), made.gap, MOST_GAP, "mm"),
            kit.between(_("they meet at"), 100 * made.meeting[1], self.low, self.high, "%"),
            kit.between(_("lean"), made.lean, self.asked - 1, self.asked + 1, "°"),
        ]
        if self.third != "none":
            # Without the third stroke it is all the way off.
            is_there = made.third == self.third
            way = made.third_miss if is_there else made.lifted[BOWL][-1] - made.foot
            off = 1000 * float(np.linalg.norm(way))
            asked.append(kit.at_most(_("third end off by"), off, MOST_END_OFF, "mm"))
        return asked

    def measure(self, answer: kit.Answer) -> kit.Answer:
        made, up = NewLetter(answer), 100 * NewLetter(answer).meeting[1]
        x, y = (0, 0) if made.third == "none" else 1000 * made.third_miss
        lean = kit.tell_number(made.lean, self.asked + (1 if made.lean > self.asked else -1))
        return {
            **{"mm": kit.tell_number(made.gap, MOST_GAP), "where": _where(*made.meeting[0])},
            **{"up": up, "share": answer["share"], "lean": lean, "took": _shelf()[made.third]},
            "meets": kit.tell_number(up, self.high if up > 50 else self.low, 0),
            **{"x": f"{abs(x):.0f}", "x_way": _("right") if x >= 0 else _("left")},
            **{"y": f"{abs(y):.0f}", "y_way": _("above") if y >= 0 else _("below")},
        }

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        is_other = answer["third"] != self.third
        _count, meets, height, leans, *end = (each.is_met for each in self.conditions(answer))
        if not meets:
            yield _(
                "The bowl ends {mm} mm {where} the stem, {meets} % of the way up. Its ring must "
                "lie on the stem, wherever that leans."
            )
        if not height and NewLetter(answer).meeting[1] < 0.5:
            yield _("The bowl meets the stem only {meets} % up: that is still nearly a D.")
        if not height:
            yield _("The bowl meets the stem {meets} % up: a {letter} has a larger one.")
        if is_other and self.third == "none":
            yield _("P has {strokes} strokes. Put back “{took}”, which you took from the shelf.")
        if is_other:
            yield _("{letter} has {strokes} strokes; the third is “{wanted}”. You took “{took}”.")
        if not leans:
            yield _(
                "With {share} % of hand 2 the stem leans by {lean}°, and {asked}° are asked for."
            )
        if not all(end):
            yield _(
                "The third stroke ends {x} mm {x_way} of its place and {y} mm {y_way} it: lead it "
                "there by its own ring."
            )

    @property
    def shown(self) -> NewLetter:
        """The P of one hand whose bowl is judged."""
        return NewLetter(find_goals(self.start | {"share": 100 * (self.whose - 1)}))

    def tell_bet(self, bet: kit.KeptBet) -> str:
        near = self.shown.nearest
        words = _("It was hand {whose}’s, and measured it looks like hand {taken}’s, too. ")
        if self.whose != near["DMP*"]:
            words = _(
                "It was hand {whose}’s. Measured, it looks more like hand {taken}’s: moving the "
                "end bent it. "
            )
        words += _("Turned and scaled instead (similarity), it looks like hand {alike}’s.")
        said = {"1": _("You said hand 1."), "2": _("You said hand 2.")}
        begin = said.get(str(bet), _("You said: nobody can tell."))
        facts = {"whose": self.whose, "taken": near["DMP*"], "alike": near["similarity"]}
        return f"{begin} {words.format(**facts)}"

    def draw(self, state: kit.LessonState) -> kit.Picture:
        if state.step == "bet":
            shown, is_seen = self.shown, state.is_revealed
            text = _("The two hands differ in how they lean, and in how round they are. ")
            strong = _("Can a new letter show whose it is?") if is_seen else ""
            says = kit.says(text=text, strong=_("Bet first.") if state.bet is None else strong)
            plots = {"whose": draw_whose(shown if is_seen else None)}
            sheet = draw_blind(shown, self.whose if is_seen else None)
            return kit.Picture(says, sheet, plots, shown.strokes)
        made = NewLetter(state.values)
        is_joined = state.values["way"] == "joined"
        plots = {"speed": draw_speed(made)} if is_joined else {"whose": draw_whose(made)}
        return kit.Picture(_say(made), draw_letter(made), plots, made.strokes)


def _shelf() -> dict[str, str]:
    """Return the strokes on the shelf, in words."""
    names = {"none": _("nothing"), "stem": _("D stem"), "bowl": _("D bowl")}
    return names | {"hump": _("n hump"), "ring": "o"}


def _where(aside: float, above: float) -> str:
    """Return where a way from the stem leads, in words."""
    if abs(above) > abs(aside):
        return _("above") if above > 0 else _("below")
    return _("right of") if aside > 0 else _("left of")


def _say(made: NewLetter) -> kit.Message:
    text = _("from the bowl’s end to the stem, {up:.0f} % up. ").format(up=100 * made.meeting[1])
    n, m = made.nearest["DMP*"], made.nearest["similarity"]
    strong = _("By DMP* it looks like hand {n}’s, by similarity like hand {m}’s.")
    strong = _("By its ink, the bowl looks like hand {n}’s.") if n == m else strong
    return kit.says(kit.tell_number(made.gap, MOST_GAP), "mm", text, strong.format(n=n, m=m))
