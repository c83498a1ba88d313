"""Lesson 10: claims of the paper, and what many writers say of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.drawing import draw_sheet, paths_of, sheet_box
from dmp_teach.lessons.many_writers import find_writers
from dmp_teach.lessons.tested_claims import (
    COUNTER_TEST,
    GOAL_WAYS,
    NO_MORE_THAN,
    OPEN,
    PAPERS_WAY,
    RATIO_LIMITS,
    TOO_FEW,
    WriterRatios,
    claim_words,
    find_truth,
    line_words,
    measure,
    ratio_words,
    tell_ratio,
    tell_ratios,
    verdict_words,
    way_words,
    why_not,
)
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

TESTED_LETTERS = "aeuhS3"
CLAIM_PLACES = ("1", "2", "3")
VERDICTS = tuple(f"verdict_{place}" for place in CLAIM_PLACES)
FEW_WRITERS = (2, 3, 4)


class BeAScientist(kit.Lesson):
    """One example is no proof: count writers, see the spread, change one thing at a time."""

    key = "10"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, the claims and their order, and the one with few writers."""
        letter, self.few, self.few_number = "a", "gaps", 3
        self.claims = ["rule", "level", "gaps"]
        if random is not None:
            letter = str(random.choice(list(TESTED_LETTERS)))
            others = random.choice(["gaps", "goal", "level", "cut"], 2, replace=False).tolist()
            self.claims = random.permutation(["rule", *others]).tolist()
            self.few = str(random.choice(["", *(each for each in others if each != "goal")]))
            self.few_number = int(random.choice(FEW_WRITERS))
        self.writers = find_writers(letter)
        truth = [find_truth(each, self._number(each), self.writers) for each in self.claims]
        seen = {"claim": str(1 + self.claims.index("rule")), "writers": 1, "how": PAPERS_WAY}
        self.start = seen | dict.fromkeys(VERDICTS, OPEN)
        self.solution = seen | dict(zip(VERDICTS, truth, strict=True))

    def _number(self, claim: str) -> int:
        """Return how many writers there are for a claim."""
        most = len(self.writers.strokes)
        return min(most, self.few_number) if claim == self.few else most

    @property
    def question(self) -> str:
        """The title."""
        return _("How do you know that it is true?")

    @property
    def knobs(self) -> kit.Knobs:
        """What one looks at; and the table of verdicts, which alone is the answer."""
        ways = {PAPERS_WAY: _("the paper’s way"), COUNTER_TEST: _("counter-test")}
        options, most = verdict_words(), len(self.writers.strokes)
        words = [f"{n} {claim_words()[claim]}" for n, claim in enumerate(self.claims, start=1)]
        number = kit.Slider(_("How many writers"), "n", 1, most, is_view=True)
        return {
            "claim": kit.OneOf(_("Look at claim"), {n: n for n in CLAIM_PLACES}, is_view=True),
            "how": kit.OneOf(_("Measured"), ways, is_view=True),
            "writers": number,
            **{name: kit.OneOf(said, options) for name, said in zip(VERDICTS, words, strict=True)},
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The smallest and the largest ratio."""
        question = _(
            "One writer wrote this {letter}. The paper says that DMP*, the newer rule, is more "
            "accurate than the first one. For {n} writers: how many times larger is the first "
            "rule’s error? Pull the left dot to the smallest number, the right one to the largest."
        )
        if not self.writers.are_real:
            question += " " + _("(They are hands that we made, all relatives.)")
        most = len(self.writers.strokes)
        places = np.array([[1.0, 2.0], [float(most), 2.0]])
        labels = [_("The smallest number"), _("The largest number")]
        asked = question.format(letter=self.writers.character, n=most)
        return kit.DrawnBet(
            asked, "ratios", places, labels, step=0.05, unit=_("times"), low=0.1, high=200.0
        )

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Ask one writer after the other. From how many on is it no luck?"),
                lambda v: v["writers"] >= 5,
            ),
            kit.Task(
                _("Do the counter-test of claim {n}. What is left of its number?").format(
                    n=self.start["claim"]
                ),
                lambda v: v["how"] == COUNTER_TEST and v["claim"] == self.start["claim"],
            ),
            kit.Task(
                _("Look at the other claims, each in both ways and with all its writers."),
                lambda v: (
                    (v["claim"] != self.start["claim"] and v["how"] == COUNTER_TEST)
                    and v["writers"] >= self._number(self.claims[int(v["claim"]) - 1])
                ),
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        return _(
            "Fill the table. A claim holds if it holds in the paper’s way and in the counter-test. "
            "If not, is it unfair, since more than one thing was changed, or true in one setting "
            "only? If a coin does as much more than once in 20 times, there are too few writers."
        )

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        words = verdict_words()
        table = [f"{n} {words[self.solution[v]]}" for n, v in enumerate(VERDICTS, start=1)]
        return (
            _("Take all writers, then go from the paper’s way to the counter-test and back."),
            _("Three heads in a row come once in 8, five once in 32. Count the writers first."),
            _("The table is: {table}.").format(table="; ".join(table)),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how many claims are judged; whether rightly, the check alone tells."""
        judged = sum(answer[name] != OPEN for name in VERDICTS)
        return [kit.at_least(_("claims judged"), judged, len(VERDICTS))]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return whether each verdict goes against the numbers, and the open ones last."""
        found = []
        right = sum(answer[name] == self.solution[name] for name in VERDICTS)
        stand = _(" Verdicts that stand so far: {right}.").format(right=right)
        for place, (name, claim) in enumerate(zip(VERDICTS, self.claims, strict=True), start=1):
            said, truth = str(answer[name]), str(self.solution[name])
            facts = self._facts(claim) | {"place": place, "said": verdict_words()[said]}
            words = _("Claim {place}, “{said}”: ") + why_not(said, truth)
            found.append((said not in (OPEN, truth), words.format(**facts) + stand))
        still = [str(n) for n, name in enumerate(VERDICTS, start=1) if answer[name] == OPEN]
        words = _("Not judged yet: {still}.").format(still=", ".join(still))
        found.append((bool(still), words + stand))
        return found

    def _measured(self, claim: str, how: str) -> WriterRatios:
        """Return a claim on all writers that there are for it."""
        return measure(claim, how, self.writers).first(self._number(claim))

    def _facts(self, claim: str) -> dict[str, object]:
        """Return the numbers of a claim for its sentences."""
        paper, counter = (self._measured(claim, how) for how in GOAL_WAYS)
        return {
            "n": paper.number,
            "once": f"{1 / paper.luck:.0f}",
            "for_paper": paper.for_it,
            "for_counter": counter.for_it,
            "paper": tell_ratio(float(np.median(paper.ratios))),
            "counter": tell_ratio(float(np.median(counter.ratios))),
            "paper_way": way_words(claim, PAPERS_WAY),
            "counter_way": way_words(claim, COUNTER_TEST),
        }

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        said = [self.solution[name] for name in VERDICTS]
        found = [f"{words} {said.count(each)}" for each, words in verdict_words().items()]
        table = ", ".join(found[1:])
        if TOO_FEW in said:
            table += f" (n = {self._number(self.few)})"
        words = _("Your table: {table}. One example would have made you believe all three.")
        return words.format(table=table)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return the bet beside the truth."""
        ratios = self._measured("rule", PAPERS_WAY).ratios
        low, high = sorted(float(y) for _x, y in bet)
        facts = {"n": len(ratios), "low": tell_ratio(low), "high": tell_ratio(high)}
        facts |= {"least": tell_ratio(ratios.min()), "most": tell_ratio(ratios.max())}
        words = _(
            "You bet from {low} to {high} times. With {n} writers it is from {least} to {most}. "
            "Is it the rule that does this? The counter-test tells."
        )
        return words.format(**facts)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the newest writer's letter, and the ratio of each writer."""
        claim = self.claims[int(state.values["claim"]) - 1]
        measured = self._measured(claim, str(state.values["how"]))
        number = min(int(state.values["writers"]), measured.number)
        last = number - 1
        is_hidden = state.step == "bet" and not state.is_revealed
        if state.step == "bet" and state.is_revealed:
            number = measured.number
        stroke = self.writers.strokes[last]
        sheet = draw_sheet(
            [stroke],
            [measured.paths[last]],
            box=sheet_box([*paths_of(self.writers.strokes), *measured.paths]),
            extras=[{"points": each, "kind": ""} for each in measured.beside[last : last + 1]],
            caption=line_words(measured, None if is_hidden else last),
            note=_("dotted: writer {k} of {n}").format(k=last + 1, n=measured.number),
        )
        shown = measured.first(0 if is_hidden else number)
        says = (
            self._ask()
            if is_hidden
            else tell_ratios(shown, str(state.values["how"]), self.writers.are_real)
        )
        # The bet is on the rule: it is drawn on that plot alone.
        name = "ratios" if claim == "rule" else "others"
        strokes = (Trajectory(stroke.t, measured.paths[last]),)
        plots, highs = {name: self._draw_ratios(shown, state)}, {"writers": float(measured.number)}
        return kit.Picture(says, sheet, plots, strokes, highs=highs)

    def _draw_ratios(self, measured: WriterRatios, state: kit.LessonState) -> kit.Drawing:
        """Draw the ratio of each writer, and the line that the claim must pass."""
        most = len(self.writers.strokes)
        ratios = measured.ratios
        if state.step == "bet":
            ratios = np.sort(ratios)
        limit = RATIO_LIMITS[measured.claim]
        word = (
            _("for it: below {limit:g}")
            if measured.claim in NO_MORE_THAN
            else _("for it: above {limit:g}")
        )
        ticks = [[value, f"{value:g}"] for value in (0.1, 1, 10, 100)]
        x = _("writers, in order") if state.step == "bet" else _("writers")
        line = np.array([[0.5, limit], [most + 0.5, limit]])
        lines = [] if state.step == "bet" else [{"points": line, "kind": "quiet"}]
        return {
            "caption": ratio_words(measured.claim),
            "note": word.format(limit=limit) if lines else "",
            "x": {"label": x, "low": 0.5, "high": most + 0.5, "ticks": _even_ticks(most)},
            "y": {"label": "", "low": 0.05, "high": 300.0, "log": True, "ticks": ticks},
            "lines": lines,
            "dots": [{"at": [n, y], "kind": "robot"} for n, y in enumerate(ratios, start=1)],
        }

    def _ask(self) -> dict[str, str]:
        """Return what is said before the truth is seen."""
        strong = _("What will the others say?")
        unit = _("writer asked so far")
        return {"number": "1", "unit": unit, "text": "", "strong": strong, "after": ""}


def _even_ticks(most: int) -> list[list[object]]:
    """Return ticks at every second whole number."""
    return [[float(n), str(n)] for n in range(1, most + 1) if n % 2 or most < 8]
