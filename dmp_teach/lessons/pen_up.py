"""Lesson 06: two thresholds find the strokes (the paper's equations 12 and 13, and its 'D')."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.errors import RecordingError
from dmp_teach.lessons.pen_up_pictures import draw_over_time, draw_path, draw_strokes
from dmp_teach.lessons.unsteady_pen import TREMBLE, Times, disturb
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

# Both strokes are known, and the longer one is long enough for a hand to tilt slowly.
TWO_STROKE_LETTERS = "DPBMQN"
LIFT_HEIGHTS = (14, 16, 18, 20)
MOST_OFF = 50
TREMBLE_MM = 1000 * TREMBLE


class PenUp(kit.Lesson):
    """A lift is fast and high: what trembles or is knocked is low, what tilts is slow."""

    key = "06"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, how high the pen is lifted, and what else happens."""
        chance = np.random.default_rng(23) if random is None else random
        self.letter = "D" if random is None else str(chance.choice(list(TWO_STROKE_LETTERS)))
        height = 16 if random is None else int(chance.choice(LIFT_HEIGHTS))
        self.pen = pen = disturb(self.letter, height / 1000, chance)
        self.recording = pen.recording
        self.truth = pen.recording.strokes()
        between = (pen.fastest(pen.tilt) + pen.fastest(pen.lift)) / 2
        above = (pen.highest(pen.knock) + pen.highest(pen.lift)) / 2
        self.start = {"theta": 15, "sigma": 1.5}
        self.solution = {"theta": 5 * round(200 * between), "sigma": round(2000 * above) / 2}

    @property
    def question(self) -> str:
        """The title."""
        return _("When does the pen leave the paper?")

    @property
    def knobs(self) -> kit.Knobs:
        """The two thresholds."""
        return {
            "theta": kit.Slider(_("Lift: faster than"), "θ", 5, 200, 5, "mm/s"),
            "sigma": kit.Slider(_("Lift: higher than"), "σ", 0.5, 25.0, 0.5, "mm", 1),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The way in the air, as it is seen from above."""
        question = _(
            "Seen from above, the pen that wrote this {letter} never stops. But once it was in the "
            "air. Draw its way through the air: where did it leave the paper, where did it land?"
        )
        box = np.array(draw_path(self.recording)["box"]).reshape(2, 2)
        places = box[0] + [[0.97, 0.3], [0.97, 0.6]] * (box[1] - box[0])
        labels = [_("Where the pen left the paper"), _("Where the pen landed")]
        return kit.DrawnBet(question.format(letter=self.letter), "sheet", places, labels, axis="xy")

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Pull both lines down to the bottom. What does the robot take for a lift?"),
                lambda v: v["theta"] <= 5 and v["sigma"] <= 0.5,
            ),
            kit.Task(
                _("Leave θ low and raise σ alone. Can height tell the lift from the slow hill?"),
                lambda v: v["theta"] <= 20 and v["sigma"] >= 10,
            ),
            kit.Task(
                _("Leave σ low and raise θ alone. Can speed tell the lift from the short peak?"),
                lambda v: v["sigma"] <= 2 and v["theta"] >= 60,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        return _(
            "Set both lines so that the robot finds the two strokes of {letter}, and every end of "
            "a stroke is within {ms} ms (thousandths of a second) of where it really is."
        ).format(letter=self.letter, ms=MOST_OFF)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        return (
            _("A lift is fast and high. What is only fast, and what is only high?"),
            _("Put θ above the slow hill’s speed, and σ above the short peak’s height."),
            _("Try θ = {theta} and σ = {sigma}.").format(**_in_words(self.solution)),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how many strokes are found, and how far off the ends are."""
        strokes = self.find(answer)
        return [
            kit.exactly(_("strokes"), len(strokes), 2),
            kit.at_most(_("ends off by"), self._milliseconds_off(strokes), MOST_OFF, "ms"),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return whether the lift is missed, or something else is taken for one."""
        pen, strokes = self.pen, self.find(answer)
        gaps = _gaps(strokes)
        others = [gap for gap in gaps if not _is_in(_middle(pen.lift), [gap])]
        knocks = [gap for gap in others if _is_in(_middle(gap), [pen.knock])]
        tilts = [gap for gap in others if _is_in(_middle(gap), [pen.tilt])]
        is_missed = len(others) == len(gaps)
        off = self._milliseconds_off(strokes)
        made = {
            "slow": is_missed and answer["theta"] >= 1000 * pen.fastest(pen.lift),
            "low": is_missed,
            "trembling": answer["sigma"] <= 2 * TREMBLE_MM and len(others) > 2,
            "both": bool(knocks and tilts),
            "knock": bool(knocks),
            "tilt": bool(tilts),
            "ends": off > MOST_OFF,
        }
        facts: kit.Answer = _in_words(answer) | {
            "n": len(strokes),
            "ms": kit.tell_number(off, MOST_OFF, 0),
        }
        for name, times in (("lift", pen.lift), ("knock", pen.knock), ("tilt", pen.tilt)):
            facts[f"{name}_mm"] = kit.tell_number(1000 * pen.highest(times), answer["sigma"], 0)
            # A lift is looked for backwards in time, too: a fall counts as a rise.
            rate = 1000 * pen.fastest(times, falls=name == "tilt")
            facts[f"{name}_rate"] = kit.tell_number(rate, answer["theta"], 0)
        words = self._causes()
        return [(is_made, words[name].format(**facts)) for name, is_made in made.items()]

    @staticmethod
    def _causes() -> dict[str, str]:
        """Return what is said of each mistake."""
        return {
            "slow": _(
                "At its fastest the lift rises by {lift_rate} mm/s. θ = {theta} asks for more, so "
                "the lift counts as writing."
            ),
            "low": _(
                "The lift is {lift_mm} mm high. σ = {sigma} mm asks for about as much or more, so "
                "the lift counts as writing."
            ),
            "trembling": _(
                "The hand trembles all the time, by less than a millimetre. θ = {theta} and "
                "σ = {sigma} let that count as lifts, too: {n} strokes."
            ),
            "both": _(
                "θ = {theta} is below the {tilt_rate} mm/s of the slow hill, and σ = {sigma} below "
                "the {knock_mm} mm of the short peak. Both count as lifts: {n} strokes."
            ),
            "knock": _(
                "Somebody knocked at the table: the pen jumped by {knock_mm} mm, as fast as in a "
                "lift. σ = {sigma} mm lets that count: {n} strokes."
            ),
            "tilt": _(
                "The hand tilted while it wrote: the pen rose by {tilt_mm} mm and fell again, "
                "but slowly, by {tilt_rate} mm/s at most. θ = {theta} lets that count: {n} strokes."
            ),
            "ends": _(
                "There are {n} strokes, but one end is {ms} ms off: so low a θ as {theta} takes "
                "what comes before a lift for a part of it."
            ),
        }

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "Two strokes: up at {up:.2f} s, down at {down:.2f} s. Only a lift is faster than "
            "{theta} mm/s and higher than {sigma} mm."
        )
        up, down = _gaps(self.find(answer))[0]
        return words.format(up=up, down=down, **_in_words(answer))

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return how far both places were from the true ones."""
        first, second = self.truth
        ends = np.array([first.position[-1], second.position[0]])
        left, landed = 1000 * np.linalg.norm(np.array(bet) - ends, axis=1)
        words = _(
            "You let it leave the paper {left:.0f} mm from where it did, and land {landed:.0f} mm "
            "from where it did. It was in the air from {up:.2f} s to {down:.2f} s. Its height "
            "shows that, but not every hill there is a lift."
        )
        up, down = self.pen.lift
        return words.format(left=left, landed=landed, up=up, down=down)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the strokes on paper, and over time the height and its speed with their lines."""
        is_bet = state.step == "bet"
        if is_bet and not state.is_revealed:
            plots = draw_over_time(self.pen, None)
            says = self._say(None, is_bet=state.bet is not None)
            return kit.Picture(says, draw_path(self.recording), plots, self.truth)
        strokes = self.truth if is_bet else self.find(state.values)
        plots = draw_over_time(self.pen, strokes)
        if not is_bet:
            for name, knob in (("height", "sigma"), ("rise", "theta")):
                plots[name]["thresholds"] = [self._threshold(knob, state.values[knob])]
        says = self._say(strokes, is_truth=is_bet)
        return kit.Picture(says, draw_strokes(self.recording, strokes), plots, tuple(strokes))

    def _threshold(self, name: str, value: float) -> kit.Drawing:
        """Return the line of a knob, to be dragged."""
        knob = self.knobs[name].described()
        ends = {each: knob[each] for each in ("low", "high", "step")}
        words = {"label": knob["term"], "text": f"{value:g} {knob['unit']}"}
        return {"name": name, "axis": "y", "value": value, **words, **ends}

    def find(self, answer: kit.Answer) -> Sequence[Trajectory]:
        """Return the strokes that the thresholds find; none where nothing is left."""
        try:
            plain = self.recording.with_strokes(None)
            return plain.strokes(answer["theta"] / 1000, answer["sigma"] / 1000)
        except RecordingError:
            return ()

    def _milliseconds_off(self, strokes: Sequence[Trajectory]) -> float:
        """Return how far an end is at most from the nearest, true from found or back [ms]."""
        if not strokes:
            return 1000 * self.recording.duration
        found, true = (
            np.array([each.t[[0, -1]] for each in all_]) for all_ in (strokes, self.truth)
        )
        apart = np.abs(found[:, None] - true)
        return float(1000 * max(apart.min(axis=0).max(), apart.min(axis=1).max()))

    def _say(
        self,
        strokes: Sequence[Trajectory] | None,
        *,
        is_bet: bool = False,
        is_truth: bool = False,
    ) -> dict[str, str]:
        """Return the number of strokes, and what it means; before the bet neither."""
        if strokes is None:
            text, strong = _("Height is not seen from above. "), "" if is_bet else _("Bet first.")
        elif is_truth:
            text = _("The pen was on the paper where it is green. ")
            strong = _("How can a robot find that out from two curves?")
        else:
            text = _("Where the pen rises faster than θ and more than σ, the robot sees a lift. ")
            if len(strokes) > 2:
                strong = _("Here it sees lifts where there are none.")
            elif len(strokes) < 2:
                strong = _("Here it takes the lift for writing.")
            elif self._milliseconds_off(strokes) > MOST_OFF:
                strong = _("Two strokes, but cut at the wrong place.")
            else:
                strong = _("Here it finds two strokes.")
        number = "" if strokes is None else str(len(strokes))
        unit = {"": "", "1": _("stroke")}.get(number, _("strokes"))
        return {"number": number, "unit": unit, "text": text, "strong": strong, "after": ""}


def _in_words(answer: kit.Answer) -> kit.Answer:
    """Return the thresholds as they are shown."""
    return {name: f"{value:.3g}" for name, value in answer.items()}


def _gaps(strokes: Sequence[Trajectory]) -> list[Times]:
    """Return when the pen is in the air between strokes [s]."""
    return [(float(a.t[-1]), float(b.t[0])) for a, b in pairwise(strokes)]


def _middle(times: Times) -> float:
    """Return the moment in the middle of two [s]."""
    return (times[0] + times[1]) / 2


def _is_in(moment: float, spans: Sequence[Times]) -> bool:
    """Return whether a moment lies in one of several spans."""
    return any(first <= moment <= last for first, last in spans)
