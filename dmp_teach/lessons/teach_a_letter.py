"""Lesson 02: a letter is a sum of bumps (equations 2 to 5 of the paper, and its Algorithm 1)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.bumps import BUMP_NUMBER, learn_bumps
from dmp_teach.lessons.drawing import axis, draw_sheet, line, mark, millimetres, plot
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array, Trajectory

# Round ones: in an upright line a push along it is not seen.
BUMP_LETTERS = "aszSG389"
BET_BUMP, BET_CHANGE = 5, 8.0
# Not the one of the bet.
SPOILT_BUMPS = (3, 4, 6, 7, 8)
MOST_CHANGE = 10.0
# How far the spoilt weight leads the pen astray [mm], and what part of it may be left.
ASTRAY, LEFT_ASTRAY = 15.0, 0.2

Follow = Callable[[Array, Array], Array | kit.Affine]


class TeachALetter(kit.Lesson):
    """One weight is heard from its bump on, and the goal has the last word."""

    key = "02"
    n, bet_bump = BUMP_NUMBER, BET_BUMP
    question = marked("How does a robot remember a letter?")
    bet_question = marked(
        "The robot remembers this {letter} as {n} bumps, one after the other. Bump {bet_bump} is "
        "lit. Now it will push the pen up more than it learned to. What will move?"
    )
    tasks = (
        marked("Pull the weight down. What stays where it was? What moves?"),
        marked("Take the last bump and pull as hard. Why does so little happen?"),
        marked("Set the change to 0. Walk to the bump that pushes most, up or down."),
    )
    challenge = marked(
        "Somebody has changed one weight of the robot’s {letter}. Find the bump and change its "
        "weight back, until the letter is within {limit} mm."
    )
    praise = marked(
        "Bump {bump} was {by:g} cm off. One number is put right, and all that came after it is "
        "right again: {letter} is {error} mm off."
    )

    def vary(self) -> None:
        bump, sign = 6, 1
        self.letter = self.choose(BUMP_LETTERS)
        if self.random is not None:
            bump, sign = self.choose(SPOILT_BUMPS), self.choose((-1, 1))
        self.bumps = learn_bumps(self.letter)
        by = sign * round(ASTRAY / 10 / self.bumps.responses[bump - 1].max())
        self.spoilt = (bump, by / 100)
        nearly = [self._error(bump, -by * share) for share in (1 - LEFT_ASTRAY, 1 + LEFT_ASTRAY)]
        self.limit = math.ceil(10 * max(nearly)) / 10
        self.start = {"bump": BET_BUMP, "change": 0.0}
        self.solution = {"bump": bump, "change": float(-by)}
        self.by, self.back = abs(by), f"{-by}".replace("-", "−")
        self.first, self.last = bump - 1, bump + 1
        turned = marked("It is one of the bumps {first} to {last}, and its weight is too high.")
        if by < 0:
            turned = marked("It is one of the bumps {first} to {last}, and its weight is too low.")
        where = marked(
            "Set the change to 0 and follow the line from its start. Where does it first leave the "
            "dots? Light the bump that is awake there, or the one before."
        )
        self.hints = where, turned, marked("Try bump {solution[bump]} and a change of {back} cm.")

    def _error(self, bump: float, change: float) -> float:
        """Return how far off the spoilt letter is with a weight changed [mm]."""
        return 1000 * self.bumps.error(self.spoilt, (bump, change / 100))

    @property
    def knobs(self) -> kit.Knobs:
        label, low, high = _("Change of its weight"), -MOST_CHANGE, MOST_CHANGE
        change = kit.Slider(label, "Δw", low, high, 0.5, "cm", 1, is_drawn_here=True)
        return {"bump": kit.Slider(_("Which bump"), "i", 1, BUMP_NUMBER), "change": change}

    @property
    def bet(self) -> kit.ChosenBet:
        options = {"lit": _("the lit piece"), "all": _("the whole letter")}
        options |= {"end": _("the rest and the end"), "back": _("the rest, not the end")}
        return kit.ChosenBet(self.bet_question, options)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["change"] <= -5,
            v["bump"] == BUMP_NUMBER and abs(v["change"]) >= 5,
            v["change"] == 0 and v["bump"] == self.bumps.hardest,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        return [kit.at_most(self.letter, self._error(**answer), self.limit, "mm")]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        bump, change = int(answer["bump"]), f"{answer['change']:+.3g}".replace("-", "−")
        between = abs(self.bumps.wakes(bump) - self.bumps.wakes(self.spoilt[0]))
        error = kit.tell_number(self._error(**answer), self.limit)
        return {"bump": bump, "change": change, "error": error, "s": f"{between:.1f}"}

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        bump, change, wanted = answer["bump"], answer["change"], self.solution["change"]
        if change == 0:
            yield _(
                "The change of bump {bump} is 0 cm, so nothing is put right yet: {letter} is "
                "{error} mm off."
            )
        if bump < self.spoilt[0]:
            yield _(
                "Bump {bump} wakes up {s} s before the line goes astray, so {change} cm bend a "
                "piece that was good. Look for a later one."
            )
        if bump > self.spoilt[0]:
            yield _(
                "When bump {bump} wakes up, the line has been astray for {s} s, and {change} cm "
                "cannot reach back. Look for an earlier one."
            )
        if change * wanted < 0:
            yield _(
                "Bump {bump} is the one, but {change} cm is the wrong way: {letter} is now {error} "
                "mm off."
            )
        if self._error(**answer) > self.limit and abs(change) < abs(wanted):
            yield _(
                "Bump {bump} is the one, and the way is right. {change} cm is too little: {letter} "
                "is still {error} mm off; the limit is {limit}."
            )
        if self._error(**answer) > self.limit:
            yield _(
                "Bump {bump} is the one, and the way is right. {change} cm is too much: {letter} "
                "is {error} mm off on the other side; the limit is {limit}."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        bumps, awake = self.bumps, self.bumps.awake(BET_BUMP)
        moved = BET_CHANGE * 10 * np.abs(bumps.responses[BET_BUMP - 1])
        felt = bumps.t[np.flatnonzero(moved > 0.1 * moved.max())[-1]] - bumps.t[awake][-1]
        truth = _(
            "Before bump {bump} nothing moved. From there on the pen went up to {most:.0f} mm "
            "higher. It still felt the push {felt:.1f} s later, and came back: the end is where it "
            "was. "
        )
        said = {
            "lit": _("You said only the lit piece; but a pen that is pushed needs time to return."),
            "all": _("You said the whole letter; but what is written has not felt the push."),
            "end": _("You said the end, too; but at the end the spring has pulled it back."),
            "back": _("Just as you said."),
        }
        return truth.format(bump=BET_BUMP, most=moved.max(), felt=felt) + said[bet]

    def draw(self, state: kit.LessonState) -> kit.Picture:
        bumps, is_bet = self.bumps, state.step == "bet"
        bump, change = int(state.values["bump"]), float(state.values["change"])
        if is_bet:
            bump, change = BET_BUMP, BET_CHANGE * state.is_revealed
        spoilt = [self.spoilt] if state.step == "challenge" else []
        base, weights = bumps.write(*spoilt), bumps.weights.copy()
        for spoilt_bump, by in spoilt:
            weights[spoilt_bump - 1] += by

        def follow(points: Array, up: Array) -> Array | kit.Affine:
            """Let points go up with the change by so much for 1 cm; that of the bet stays."""
            way = np.column_stack([np.zeros(len(up)), up])
            return points + change * way if is_bet else kit.Affine(points, {"change": way})

        response, awake = bumps.responses[bump - 1] / 100, bumps.awake(bump)
        middle = slice((awake.start + awake.stop) // 2, (awake.start + awake.stop) // 2 + 1)
        lit = follow(base[awake], response[awake])
        sheet = draw_sheet(
            [Trajectory(bumps.t, bumps.demonstration)],
            [follow(base, response)],
            note=_("lit: where bump {bump} is awake").format(bump=bump),
            extras=[{"points": lit, "kind": f"bump-{(bump - 1) % 3}"}],
            dots=[mark(follow(base[middle], response[middle]), "lit", str(bump))],
        )
        pushes = self._draw_pushes(bump, weights, follow, has_needed=not spoilt)
        now, cm = _("weight of bump {bump}: {cm:.1f} cm"), 100 * weights[bump - 1] + change
        pushes["note"] = now.format(bump=bump, cm=cm).replace("-", "−")
        changes = (*spoilt, (bump, change / 100))
        written = Trajectory(bumps.t, bumps.write(*changes))
        says = self._say(bump, change, bumps.error(*changes))
        return kit.Picture(says, sheet, {"pushes": pushes}, (written,))

    def _draw_pushes(
        self, bump: int, weights: Array, follow: Follow, *, has_needed: bool
    ) -> kit.Drawing:
        """Draw each bump as high as it pushes, and the sum of all."""
        bumps, t = self.bumps, self.bumps.t
        fills: list[kit.Drawing] = []
        for number, (share, weight) in enumerate(zip(bumps.shares, weights, strict=True), start=1):
            awake, is_lit = bumps.awake(number), number == bump
            points = np.column_stack([t, 100 * weight * share])[awake]
            fills.append({"points": follow(points, share[awake]) if is_lit else points})
            fills[-1]["lit"] = is_lit
        push = follow(np.column_stack([t, 100 * weights @ bumps.shares]), bumps.shares[bump - 1])
        needed = line(np.column_stack([t, 100 * bumps.needed]), "child", _("need"))
        most = 5 * math.ceil((100 * np.abs(bumps.weights @ bumps.shares).max() + 4) / 5)
        begin, end = map(float, t[bumps.awake(bump)][[0, -1]])
        return plot(
            _("The bumps and their sum"),
            axis(0, t[-1], _("time [s]")),
            axis(-most, most, _("push up [cm]")),
            fills=fills,
            lines=[line(push, "robot", _("sum f")), *([needed] if has_needed else [])],
            bands=[{"from": begin, "to": end, "label": str(bump)}],
        )

    def _say(self, bump: int, by: float, error: float) -> kit.Message:
        """Return the number and the sentence."""
        t = self.bumps.t[self.bumps.awake(bump)]
        awake = _("Bump {bump} is awake from {begin:.1f} s to {end:.1f} s. ")
        strong = _("Its weight is as it was.")
        if by > 0:
            strong = _("Its weight is {cm:.3g} cm higher: it pushes further up.")
        elif by < 0:
            strong = _("Its weight is {cm:.3g} cm lower: it pushes further down.")
        text = awake.format(bump=bump, begin=t[0], end=t[-1])
        off = millimetres(error), _("mm off on average")
        return kit.says(*off, text, strong.format(cm=abs(by)))
