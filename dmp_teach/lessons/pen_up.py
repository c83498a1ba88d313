"""Lesson 06: two thresholds find the strokes (the paper's equations 12 and 13, and its 'D')."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.errors import RecordingError
from dmp_teach.lessons.pen_up_pictures import draw_over_time, draw_path, draw_strokes
from dmp_teach.lessons.unsteady_pen import TREMBLE, Times, disturb
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

# Both strokes are known, and the longer one is long enough for a hand to tilt slowly.
TWO_STROKE_LETTERS = "DPBMQN"
LIFT_HEIGHTS = (14, 16, 18, 20)


class PenUp(kit.Lesson):
    """A lift is fast and high: what trembles or is knocked is low, what tilts is slow."""

    key = "06"
    most_ms = 50
    question = marked("When does the pen leave the paper?")
    bet_question = marked(
        "Seen from above, the pen that wrote this {letter} never stops. But once it was in the "
        "air. Draw its way through the air: where did it leave the paper, where did it land?"
    )
    tasks = (
        marked("Pull both lines down to the bottom. What does the robot take for a lift?"),
        marked("Leave θ low and raise σ alone. Can height tell the lift from the slow hill?"),
        marked("Leave σ low and raise θ alone. Can speed tell the lift from the short peak?"),
    )
    challenge = marked(
        "Set both lines so that the robot finds the two strokes of {letter}, and every end of a "
        "stroke is within {most_ms} ms (thousandths of a second) of where it really is."
    )
    hints = (
        marked("A lift is fast and high. What is only fast, and what is only high?"),
        marked("Put θ above the slow hill’s speed, and σ above the short peak’s height."),
        marked("Try θ = {solution[theta]} and σ = {solution[sigma]:g}."),
    )
    praise = marked(
        "Two strokes: up at {up:.2f} s, down at {down:.2f} s. Only a lift is faster than {theta} "
        "mm/s and higher than {sigma} mm."
    )

    def vary(self) -> None:
        self.letter = self.choose(TWO_STROKE_LETTERS)
        height = 16 if self.random is None else self.choose(LIFT_HEIGHTS)
        random = self.random or np.random.default_rng(23)
        self.pen = pen = disturb(self.letter, height / 1000, random)
        self.recording, self.truth = pen.recording, pen.recording.strokes()
        between = (pen.fastest(pen.tilt) + pen.fastest(pen.lift)) / 2
        above = (pen.highest(pen.knock) + pen.highest(pen.lift)) / 2
        self.start = {"theta": 15, "sigma": 1.5}
        self.solution = {"theta": 5 * round(200 * between), "sigma": round(2000 * above) / 2}

    @property
    def knobs(self) -> kit.Knobs:
        return {
            "theta": kit.Slider(_("Lift: faster than"), "θ", 5, 200, 5, "mm/s"),
            "sigma": kit.Slider(_("Lift: higher than"), "σ", 0.5, 25.0, 0.5, "mm", 1),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        box = np.array(draw_path(self.recording)["box"]).reshape(2, 2)
        places = box[0] + [[0.97, 0.3], [0.97, 0.6]] * (box[1] - box[0])
        labels = [_("Where the pen left the paper"), _("Where the pen landed")]
        return kit.DrawnBet(self.bet_question, "sheet", places, labels, axis="xy")

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["theta"] <= 5 and v["sigma"] <= 0.5,
            v["theta"] <= 20 and v["sigma"] >= 10,
            v["sigma"] <= 2 and v["theta"] >= 60,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        strokes = self.find(answer)
        return [
            kit.exactly(_("strokes"), len(strokes), 2),
            kit.at_most(_("ends off by"), self._milliseconds_off(strokes), self.most_ms, "ms"),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        pen, strokes = self.pen, self.find(answer)
        facts: kit.Answer = {name: f"{value:.3g}" for name, value in answer.items()}
        facts["ms"] = kit.tell_number(self._milliseconds_off(strokes), self.most_ms, 0)
        facts["n"], (facts["up"], facts["down"]) = len(strokes), next(_gaps(strokes), pen.lift)
        for name, times in (("lift", pen.lift), ("knock", pen.knock), ("tilt", pen.tilt)):
            facts[f"{name}_mm"] = kit.tell_number(1000 * pen.highest(times), answer["sigma"], 0)
            # A lift is looked for backwards in time, too: a fall counts as a rise.
            rate = 1000 * pen.fastest(times, falls=name == "tilt")
            facts[f"{name}_rate"] = kit.tell_number(rate, answer["theta"], 0)
        return facts

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        pen, gaps = self.pen, list(_gaps(self.find(answer)))
        others = [gap for gap in gaps if not _is_middle_in(pen.lift, gap)]
        is_knock = any(_is_middle_in(gap, pen.knock) for gap in others)
        is_tilt = any(_is_middle_in(gap, pen.tilt) for gap in others)
        if len(others) == len(gaps) and answer["theta"] >= 1000 * pen.fastest(pen.lift):
            yield _(
                "At its fastest the lift rises by {lift_rate} mm/s. θ = {theta} asks for more, so "
                "the lift counts as writing."
            )
        if len(others) == len(gaps):
            yield _(
                "The lift is {lift_mm} mm high. σ = {sigma} mm asks for about as much or more, so "
                "the lift counts as writing."
            )
        if answer["sigma"] <= 2000 * TREMBLE and len(others) > 2:
            yield _(
                "The hand trembles all the time, by less than a millimetre. θ = {theta} and "
                "σ = {sigma} let that count as lifts, too: {n} strokes."
            )
        if is_knock and is_tilt:
            yield _(
                "θ = {theta} is below the {tilt_rate} mm/s of the slow hill, and σ = {sigma} below "
                "the {knock_mm} mm of the short peak. Both count as lifts: {n} strokes."
            )
        if is_knock:
            yield _(
                "Somebody knocked at the table: the pen jumped by {knock_mm} mm, as fast as in a "
                "lift. σ = {sigma} mm lets that count: {n} strokes."
            )
        if is_tilt:
            yield _(
                "The hand tilted while it wrote: the pen rose by {tilt_mm} mm and fell again, "
                "but slowly, by {tilt_rate} mm/s at most. θ = {theta} lets that count: {n} strokes."
            )
        if self._milliseconds_off(self.find(answer)) > self.most_ms:
            yield _(
                "There are {n} strokes, but one end is {ms} ms off: so low a θ as {theta} takes "
                "what comes before a lift for a part of it."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        first, second = self.truth
        ends = np.array([first.position[-1], second.position[0]])
        left, landed = 1000 * np.linalg.norm(np.array(bet) - ends, axis=1)
        up, down = self.pen.lift
        return _(
            "You let it leave the paper {left:.0f} mm from where it did, and land {landed:.0f} mm "
            "from where it did. It was in the air from {up:.2f} s to {down:.2f} s. Its height "
            "shows that, but not every hill there is a lift."
        ).format(left=left, landed=landed, up=up, down=down)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        is_bet = state.step == "bet"
        if state.is_hidden:
            strong = _("Bet first.") if state.bet is None else ""
            says = kit.says(text=_("Height is not seen from above. "), strong=strong)
            plots = draw_over_time(self.pen, None)
            return kit.Picture(says, draw_path(self.recording), plots, self.truth)
        strokes = self.truth if is_bet else self.find(state.values)
        plots = draw_over_time(self.pen, strokes)
        if not is_bet:
            for name, knob in (("height", "sigma"), ("rise", "theta")):
                plots[name]["thresholds"] = [self._threshold(knob, state.values[knob])]
        says = self._say(strokes, is_bet)
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
        found, true = (np.array([s.t[[0, -1]] for s in all_]) for all_ in (strokes, self.truth))
        apart = np.abs(found[:, None] - true)
        return float(1000 * max(apart.min(axis=0).max(), apart.min(axis=1).max()))

    def _say(self, strokes: Sequence[Trajectory], is_truth: bool) -> kit.Message:
        text = _("Where the pen rises faster than θ and more than σ, the robot sees a lift. ")
        strong = _("Here it finds two strokes.")
        if is_truth:
            text = _("The pen was on the paper where it is green. ")
            strong = _("How can a robot find that out from two curves?")
        elif len(strokes) > 2:
            strong = _("Here it sees lifts where there are none.")
        elif len(strokes) < 2:
            strong = _("Here it takes the lift for writing.")
        elif self._milliseconds_off(strokes) > self.most_ms:
            strong = _("Two strokes, but cut at the wrong place.")
        unit = _("stroke") if len(strokes) == 1 else _("strokes")
        return kit.says(str(len(strokes)), unit, text, strong)


def _gaps(strokes: Sequence[Trajectory]) -> Iterator[Times]:
    """Return when the pen is in the air between strokes [s]."""
    return ((float(a.t[-1]), float(b.t[0])) for a, b in pairwise(strokes))


def _is_middle_in(times: Times, span: Times) -> bool:
    """Return whether the moment in the middle of two lies in a span."""
    return span[0] <= (times[0] + times[1]) / 2 <= span[1]
