"""Lesson 07: a letter that nobody has shown, in whose hand (the paper's figure of D and P)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.new_letters_pictures import draw_blind, draw_letter, draw_speed, draw_whose
from dmp_teach.lessons.two_hands import BOWL, NewLetter, find_goals
from dmp_teach.texts import gettext as _

THIRD_STROKES = {"P": "none", "R": "stem", "B": "bowl"}
SHARES = (30, 50, 70, 130)
LOWEST, HIGHEST = 40, 60
MOST_GAP, MOST_LEAN_OFF, MOST_END_OFF = 2.0, 1.0, 6.0


class NewLetters(kit.Lesson):
    """A D becomes a P, an R or a B by other goals, between two hands."""

    key = "07"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter to make, its lean, and whose bowl is shown first."""
        letter, share, self.whose = "P", 50, 2
        if random is not None:
            letter = str(random.choice(list(THIRD_STROKES)))
            share = int(random.choice(SHARES))
            self.whose = int(random.integers(1, 3))
        self.letter, self.third = letter, THIRD_STROKES[letter]
        moved = dict.fromkeys(("goal_x", "goal_y", "third_x", "third_y"), 0.0)
        self.start: kit.Answer = moved | {"share": 0, "third": "none", "way": "lifted"}
        self.solution = find_goals(self.start | {"share": share, "third": self.third})
        self.lean = round(NewLetter(self.solution).lean)

    @property
    def question(self) -> str:
        """The title."""
        return _("Can a robot write a letter that nobody showed it?")

    @property
    def thirds(self) -> dict[str, str]:
        """The strokes on the shelf, in words."""
        names = {"none": _("nothing"), "stem": _("D stem"), "bowl": _("D bowl")}
        return names | {"hump": _("n hump"), "ring": "o"}

    @property
    def knobs(self) -> kit.Knobs:
        """The hands, the shelf, and where strokes end."""

        def goal(label: str, low: float, high: float) -> kit.Slider:
            return kit.Slider(label, "g", low, high, 0.1, "cm", 1, is_drawn_here=True)

        ways = {"lifted": _("lift the pen"), "joined": _("in one line")}
        return {
            "goal_x": goal(_("Bowl’s end, sideways"), -4.0, 6.0),
            "goal_y": goal(_("Bowl’s end, upwards"), -2.0, 10.0),
            "share": kit.Slider(_("How much of hand 2"), "", -50, 150, 5, "%", is_drawn_here=True),
            "third": kit.OneOf(_("From the shelf"), self.thirds),
            "third_x": goal(_("Third end, sideways"), -4.0, 14.0),
            "third_y": goal(_("Third end, upwards"), -4.0, 10.0),
            "way": kit.OneOf(_("Between strokes"), ways, is_view=True),
        }

    @property
    def bet(self) -> kit.ChosenBet:
        """Whose bowl it is."""
        question = _(
            "Two hands wrote a D. From the bowl of one of them the robot has made the bowl of a P, "
            "by moving its end. Whose bowl is it?"
        )
        hands = {"1": _("hand 1"), "2": _("hand 2"), "none": _("nobody can tell")}
        return kit.ChosenBet(question, hands)

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Drag the ring to the middle of the stem. Which letter is it now?"),
                lambda v: v["goal_y"] >= 4,
            ),
            kit.Task(
                _("Take a third stroke from the shelf, and drag its ring. Can you make an R? A B?"),
                lambda v: v["third"] != "none" and np.hypot(v["third_x"], v["third_y"]) > 1,
            ),
            kit.Task(
                _("Go from hand 1 to hand 2, and beyond 100 %. Whose bowl is it half way?"),
                lambda v: v["share"] > 100,
            ),
            kit.Task(
                _("Write it in one line. At which joint does the pen no longer stop?"),
                lambda v: v["way"] == "joined",
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        ask = {
            "P": _("Make a P whose bowl meets the stem, from {low} to {high} % of its height."),
            "R": _(
                "Make an R: its bowl meets the stem from {low} to {high} % of its height, and "
                "its leg ends on the writing line, right under the widest place of the bowl."
            ),
            "B": _(
                "Make a B: its bowl meets the stem from {low} to {high} % of its height, and a "
                "second bowl ends at the foot of the stem."
            ),
        }[self.letter]
        lean = _("The stem must lean by {lean}°, more or less one degree.")
        return f"{ask} {lean}".format(low=LOWEST, high=HIGHEST, lean=self.lean)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        first = _("Set how much of hand 2 first: when the stem leans, every goal must follow it.")
        second = _("Then put the ring of the bowl on the middle of the stem.")
        more = _(" Take “{name}” from the shelf, and see where its ring must go.")
        last = _(
            "Take {share} % of hand 2. Move the bowl’s end {x:.1f} cm right and {y:.1f} cm up."
        )
        end = _(" Take “{name}” from the shelf: its end {x3:.1f} cm right and {y3:.1f} cm up.")
        if self.third == "none":
            more = end = ""
        sign = {"x": "goal_x", "y": "goal_y", "x3": "third_x", "y3": "third_y"}
        facts = {name: self.solution[knob] for name, knob in sign.items()}
        facts |= {"share": self.solution["share"], "name": self.thirds[self.third]}
        return first, (second + more).format(**facts), (last + end).format(**facts)

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return where the bowl meets the stem, how that leans, and where the third ends."""
        made = NewLetter(answer)
        up = made.meeting[1]
        wanted, took = (2 if third == "none" else 3 for third in (self.third, made.third))
        asked = [
            kit.exactly(_("strokes"), took, wanted),
            kit.at_most(_("bowl to stem"), made.gap, MOST_GAP, "mm"),
            kit.between(_("they meet at"), 100 * up, LOWEST, HIGHEST, "%"),
            kit.between(_("lean"), made.lean, self.lean - 1, self.lean + 1, "°"),
        ]
        if self.third != "none":
            off = 1000 * self._miss(made)
            asked.append(kit.at_most(_("third end off by"), off, MOST_END_OFF, "mm"))
        return asked

    def _miss(self, made: NewLetter) -> float:
        """Return how far the third stroke ends from its place [m]; without it, all the way."""
        if made.third != self.third:
            return float(np.linalg.norm(made.lifted[BOWL][-1] - made.foot))
        return float(np.linalg.norm(made.third_miss))

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is open, too low or high, too many, or leans otherwise."""
        made = NewLetter(answer)
        _count, met, height, leans, *_end = (each.is_met for each in self.conditions(answer))
        up = made.meeting[1]
        x, y = (0, 0) if made.third == "none" else 1000 * made.third_miss
        facts = {
            "mm": kit.tell_number(made.gap, MOST_GAP),
            "where": _where(*made.meeting[0]),
            "up": kit.tell_number(100 * up, HIGHEST if up > 0.5 else LOWEST, 0),
            "letter": self.letter,
            "strokes": 2 if self.third == "none" else 3,
            "took": self.thirds[made.third],
            "wanted": self.thirds[self.third],
            "lean": kit.tell_number(made.lean, self.lean + (1 if made.lean > self.lean else -1)),
            "asked": self.lean,
            "share": answer["share"],
            "x": f"{abs(x):.0f}",
            "y": f"{abs(y):.0f}",
            "x_way": _("right") if x >= 0 else _("left"),
            "y_way": _("above") if y >= 0 else _("below"),
        }
        is_other = made.third != self.third
        made_mistakes = {
            "beside": not met,
            "low": not height and up < 0.5,
            "high": not height,
            "many": is_other and self.third == "none",
            "third": is_other,
            "lean": not leans,
            "end": self.third != "none" and self._miss(made) * 1000 > MOST_END_OFF,
        }
        words = self._causes()
        return [(is_made, words[name].format(**facts)) for name, is_made in made_mistakes.items()]

    @staticmethod
    def _causes() -> dict[str, str]:
        """Return what is said of each mistake."""
        return {
            "beside": _(
                "The bowl ends {mm} mm {where} the stem, {up} % of the way up. Its ring must lie "
                "on the stem, wherever that leans."
            ),
            "low": _("The bowl meets the stem only {up} % up: that is still nearly a D."),
            "high": _("The bowl meets the stem {up} % up: a {letter} has a larger one."),
            "third": _(
                "{letter} has {strokes} strokes; the third is “{wanted}”. You took “{took}”."
            ),
            "many": _("P has {strokes} strokes. Put back “{took}”, which you took from the shelf."),
            "lean": _(
                "With {share} % of hand 2 the stem leans by {lean}°, and {asked}° are asked for."
            ),
            "end": _(
                "The third stroke ends {x} mm {x_way} of its place and {y} mm {y_way} it: lead it "
                "there by its own ring."
            ),
        }

    def praise(self, answer: kit.Answer) -> str:
        """Return what was made, and of whom."""
        made = NewLetter(answer)
        words = _(
            "Nobody showed this {letter}: {share} % of it is by hand 2, and its bowl ends {mm} mm "
            "from the stem, {up:.0f} % up."
        )
        mm, up = kit.tell_number(made.gap, MOST_GAP), 100 * made.meeting[1]
        return words.format(letter=self.letter, share=answer["share"], mm=mm, up=up)

    @property
    def shown(self) -> NewLetter:
        """The P of one hand whose bowl is judged."""
        return NewLetter(find_goals(self.start | {"share": 100 * (self.whose - 1)}))

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return whose it is, and whom two ways of making it are given to."""
        near = self.shown.nearest
        facts = {"whose": self.whose, "taken": near["DMP*"], "alike": near["similarity"]}
        words = _("It was hand {whose}’s, and measured it looks like hand {taken}’s, too. ")
        if self.whose != near["DMP*"]:
            words = _(
                "It was hand {whose}’s. Measured, it looks more like hand {taken}’s: moving the "
                "end bent it. "
            )
        words += _("Turned and scaled instead (similarity), it looks like hand {alike}’s.")
        said = {"1": _("You said hand 1."), "2": _("You said hand 2.")}
        begin = said.get(str(bet), _("You said: nobody can tell."))
        return f"{begin} {words.format(**facts)}"

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw two hands and a bowl, or the new letter; and whose it is, or how fast the pen is."""
        if state.step == "bet":
            shown = self.shown
            is_seen = state.is_revealed
            plots = {"whose": draw_whose(shown if is_seen else None)}
            sheet = draw_blind(shown, self.whose if is_seen else None)
            return kit.Picture(_ask(is_seen, state.bet), sheet, plots, shown.strokes)
        made = NewLetter(state.values)
        is_joined = state.values["way"] == "joined"
        plots = {"speed": draw_speed(made)} if is_joined else {"whose": draw_whose(made)}
        return kit.Picture(_say(made), draw_letter(made), plots, made.strokes)


def _where(aside: float, above: float) -> str:
    """Return where a way from the stem leads, in words."""
    if abs(above) > abs(aside):
        return _("above") if above > 0 else _("below")
    return _("right of") if aside > 0 else _("left of")


def _ask(is_seen: bool, bet: kit.KeptBet | None) -> dict[str, str]:
    """Return what is said of the bowl at the beginning."""
    text = _("The two hands differ in how they lean, and in how round they are. ")
    after = _("Can a new letter show whose it is?") if is_seen else ""
    strong = _("Bet first.") if bet is None else after
    return {"number": "", "unit": "", "text": text, "strong": strong, "after": ""}


def _say(made: NewLetter) -> dict[str, str]:
    """Return how far the bowl is from the stem, and whose it is."""
    text = _("from the bowl’s end to the stem, {up:.0f} % up. ").format(up=100 * made.meeting[1])
    near = made.nearest
    if near["DMP*"] == near["similarity"]:
        strong = _("By its ink, the bowl looks like hand {n}’s.").format(n=near["DMP*"])
    else:
        strong = _("By DMP* it looks like hand {n}’s, by similarity like hand {m}’s.")
        strong = strong.format(n=near["DMP*"], m=near["similarity"])
    number = kit.tell_number(made.gap, MOST_GAP)
    return {"number": number, "unit": "mm", "text": text, "strong": strong, "after": ""}
