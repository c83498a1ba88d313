"""Lesson 10: claims of the paper, and what many writers say of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import tested_claims as tested
from dmp_teach.lessons.drawing import axis, draw_sheet, line, mark, paths_of, plot, sheet_box
from dmp_teach.lessons.many_writers import find_writers
from dmp_teach.lessons.tested_claims import COUNTER_TEST, OPEN, PAPERS_WAY, tell_ratio
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

TESTED_LETTERS = "aeuhS3"
CLAIM_PLACES = ("1", "2", "3")
VERDICTS = tuple(f"verdict_{place}" for place in CLAIM_PLACES)
FEW_WRITERS = (2, 3, 4)


class BeAScientist(kit.Lesson):
    """One example is no proof: count writers, see the spread, change one thing at a time."""

    key = "10"
    question = marked("How do you know that it is true?")
    bet_question = marked(
        "One writer wrote this {letter}. The paper says that DMP*, the newer rule, is more "
        "accurate than the first one. For {most} writers: how many times larger is the first "
        "rule’s error? Pull the left dot to the smallest number, the right one to the "
        "largest.{made}"
    )
    tasks = (
        marked("Ask one writer after the other. From how many on is it no luck?"),
        marked("Do the counter-test of claim {first}. What is left of its number?"),
        marked("Look at the other claims, each in both ways and with all its writers."),
    )
    challenge = marked(
        "Fill the table. A claim holds if it holds in the paper’s way and in the counter-test. If "
        "not, is it unfair, since more than one thing was changed, or true in one setting only? If "
        "a coin does as much more than once in 20 times, there are too few writers."
    )
    hints = (
        marked("Take all writers, then go from the paper’s way to the counter-test and back."),
        marked("Three heads in a row come once in 8, five once in 32. Count the writers first."),
        marked("The table is: {table}."),
    )
    praise = marked("Your table: {found}. One example would have made you believe all three.")

    def vary(self) -> None:
        letter, self.few, few_number = "a", "gaps", 3
        self.claims = ["rule", "level", "gaps"]
        if self.random is not None:
            letter = self.choose(TESTED_LETTERS)
            others = self.random.choice(["gaps", "goal", "level", "cut"], 2, replace=False).tolist()
            self.claims = self.random.permutation(["rule", *others]).tolist()
            self.few = self.choose(["", *(each for each in others if each != "goal")])
            few_number = self.choose(FEW_WRITERS)
        self.writers = find_writers(letter)
        self.letter, self.most = self.writers.character, len(self.writers.strokes)
        made = _("(They are hands that we made, all relatives.)")
        self.made = "" if self.writers.are_real else f" {made}"
        self.numbers = dict.fromkeys(self.claims, self.most)
        self.numbers[self.few] = min(self.most, few_number)
        truth = [tested.find_truth(each, self.numbers[each], self.writers) for each in self.claims]
        seen = {"claim": str(1 + self.claims.index("rule")), "writers": 1, "how": PAPERS_WAY}
        self.start = seen | dict.fromkeys(VERDICTS, OPEN)
        self.solution = seen | dict(zip(VERDICTS, truth, strict=True))
        words = tested.verdict_words()
        self.table = "; ".join(
            f"{place} {words[each]}" for place, each in enumerate(truth, start=1)
        )
        self.found = ", ".join(f"{words[each]} {truth.count(each)}" for each in list(words)[1:])
        if tested.TOO_FEW in truth:
            self.found += f" (n = {self.numbers[self.few]})"
        self.first = seen["claim"]

    @property
    def knobs(self) -> kit.Knobs:
        ways = {PAPERS_WAY: _("the paper’s way"), COUNTER_TEST: _("counter-test")}
        options, claims = tested.verdict_words(), tested.claim_words()
        words = [f"{n} {claims[claim]}" for n, claim in enumerate(self.claims, start=1)]
        return {
            "claim": kit.OneOf(_("Look at claim"), {n: n for n in CLAIM_PLACES}, is_view=True),
            "how": kit.OneOf(_("Measured"), ways, is_view=True),
            "writers": kit.Slider(_("How many writers"), "n", 1, self.most, is_view=True),
            **{name: kit.OneOf(said, options) for name, said in zip(VERDICTS, words, strict=True)},
        }

    @property
    def bet(self) -> kit.DrawnBet:
        places = np.array([[1.0, 2.0], [float(self.most), 2.0]])
        labels, how = [_("The smallest number"), _("The largest number")], ("y", 0.05, _("times"))
        return kit.DrawnBet(self.bet_question, "ratios", places, labels, *how, 0.1, 200.0)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["writers"] >= 5,
            (v["how"], v["claim"]) == (COUNTER_TEST, self.first),
            (v["claim"] != self.first and v["how"] == COUNTER_TEST)
            and v["writers"] >= self.numbers[self.claims[int(v["claim"]) - 1]],
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        # Whether rightly, the check alone tells.
        judged = sum(answer[name] != OPEN for name in VERDICTS)
        return [kit.at_least(_("claims judged"), judged, len(VERDICTS))]

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        right = sum(answer[name] == self.solution[name] for name in VERDICTS)
        stand = _(" Verdicts that stand so far: {right}.").format(right=right)
        for place, (name, claim) in enumerate(zip(VERDICTS, self.claims, strict=True), start=1):
            said, truth = str(answer[name]), str(self.solution[name])
            if said not in (OPEN, truth):
                facts = self._facts(claim) | {"place": place, "said": tested.verdict_words()[said]}
                words = _("Claim {place}, “{said}”: ") + tested.why_not(said, truth)
                yield words.format(**facts) + stand
        still = [str(n) for n, name in enumerate(VERDICTS, start=1) if answer[name] == OPEN]
        if still:
            yield _("Not judged yet: {still}.").format(still=", ".join(still)) + stand

    def _measured(self, claim: str, how: str) -> tested.WriterRatios:
        """Return a claim on all writers that there are for it."""
        return tested.measure(claim, how, self.writers).first(self.numbers[claim])

    def _facts(self, claim: str) -> kit.Answer:
        """Return the numbers of a claim for its sentences."""
        facts: kit.Answer = {}
        for name, how in (("paper", PAPERS_WAY), ("counter", COUNTER_TEST)):
            measured = self._measured(claim, how)
            facts |= {"n": measured.number, f"for_{name}": measured.for_it}
            facts.setdefault("once", f"{1 / measured.luck:.0f}")
            facts[name] = tell_ratio(float(np.median(measured.ratios)))
        return facts

    def tell_bet(self, bet: kit.KeptBet) -> str:
        ratios = self._measured("rule", PAPERS_WAY).ratios
        low, high = sorted(float(y) for _x, y in bet)
        facts = {"low": low, "high": high, "least": ratios.min(), "most": ratios.max()}
        words = _(
            "You bet from {low} to {high} times. With {n} writers it is from {least} to {most}. "
            "Is it the rule that does this? The counter-test tells."
        )
        told = {name: tell_ratio(value) for name, value in facts.items()}
        return words.format(n=len(ratios), **told)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        claim = self.claims[int(state.values["claim"]) - 1]
        measured = self._measured(claim, str(state.values["how"]))
        number = min(int(state.values["writers"]), measured.number)
        last = number - 1
        is_hidden = state.is_hidden
        if state.step == "bet":
            number = measured.number * state.is_revealed
        stroke = self.writers.strokes[last]
        sheet = draw_sheet(
            [stroke],
            [measured.paths[last]],
            box=sheet_box([*paths_of(self.writers.strokes), *measured.paths]),
            extras=[{"points": each, "kind": ""} for each in measured.beside[last : last + 1]],
            caption=tested.line_words(measured, None if is_hidden else last),
            note=_("dotted: writer {k} of {n}").format(k=last + 1, n=measured.number),
        )
        shown = measured.first(number)
        if is_hidden:
            says = kit.says("1", _("writer asked so far"), strong=_("What will the others say?"))
        else:
            says = tested.tell_ratios(shown, str(state.values["how"]), self.writers.are_real)
        # The bet is on the rule: it is drawn on that plot alone.
        plots = {"ratios" if claim == "rule" else "others": self._draw_ratios(shown, state)}
        strokes, highs = (Trajectory(stroke.t, measured.paths[last]),), float(measured.number)
        return kit.Picture(says, sheet, plots, strokes, highs={"writers": highs})

    def _draw_ratios(self, measured: tested.WriterRatios, state: kit.LessonState) -> kit.Drawing:
        """Draw the ratio of each writer, and the line that the claim must pass."""
        claim, most, is_bet = measured.claim, self.most, state.step == "bet"
        ratios = np.sort(measured.ratios) if is_bet else measured.ratios
        limit = tested.RATIO_LIMITS[claim]
        word = _("for it: above {limit:g}")
        if claim in tested.NO_MORE_THAN:
            word = _("for it: below {limit:g}")
        ticks = [[float(n), str(n)] for n in range(1, most + 1) if n % 2 or most < 8]
        tens = [[value, f"{value:g}"] for value in (0.1, 1, 10, 100)]
        limits = [line(np.array([[0.5, limit], [most + 0.5, limit]]), "quiet")]
        return plot(
            tested.ratio_words(claim),
            axis(0.5, most + 0.5, _("writers, in order") if is_bet else _("writers"), ticks=ticks),
            axis(0.05, 300, log=True, ticks=tens),
            "" if is_bet else word.format(limit=limit),
            lines=[] if is_bet else limits,
            dots=[mark([n, ratio], "robot") for n, ratio in enumerate(ratios, start=1)],
        )
