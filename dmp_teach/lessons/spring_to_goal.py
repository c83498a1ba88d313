"""Lesson 01: a damped spring always arrives (equation 1 of the paper, without its forcing term)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory

DURATION = 2.0
BET_TIMES = (0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0)
START = np.array([-0.06, -0.03])
MOST_PAST, MOST_AWAY = 1.0, 2.0
# Less past the ring [% of the way] is not called a swing.
STILL = 0.05
BEAD_EVERY = 0.1


def share_left(t: Array, alpha: float, beta: float) -> Array:
    """Return which share of the way to the goal is left at times t [s]; below 0 it is past it.

    Equation 1 without f, y'' = alpha (beta (g - y) - y'), from rest, solved by its two roots.
    """
    swing = np.sqrt(complex(alpha**2 / 4 - alpha * beta))
    if abs(swing) < 1e-6 * alpha:
        return (1 + alpha / 2 * t) * np.exp(-alpha / 2 * t)
    fast, slow = -alpha / 2 - swing, -alpha / 2 + swing
    paths = (fast * np.exp(slow * t) - slow * np.exp(fast * t)) / (fast - slow)
    return paths.real


class SpringToGoal(kit.Lesson):
    """A pull and a brake: the pen arrives wherever the goal is."""

    key = "01"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the time in which the pen must arrive, and where the ring is."""
        tenths = 9 if random is None else int(random.integers(6, 15))
        self.time = tenths / 10
        goal = (6.0, 3.0) if random is None else random.integers([3, -1], [9, 6])
        # Two figures, as the sliders have.
        alpha = float(f"{13 / self.time:.2g}")
        ends = {"goal_x": float(goal[0]), "goal_y": float(goal[1])}
        self.start = {"alpha": 3.0, "beta": 12.0, **ends}
        self.solution = {"alpha": alpha, "beta": float(f"{alpha / 4:.2g}"), **ends}

    @property
    def question(self) -> str:
        """The title."""
        return _("Why does the pen always arrive?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can turn; where the ring is does not matter to the answer."""
        return {
            "alpha": self._factor(_("How hard it brakes"), "α", 2.0, 60.0),
            "beta": self._factor(_("How hard it pulls"), "β", 0.5, 30.0),
            "goal_x": self._goal_slider(_("Goal, left and right"), "x"),
            "goal_y": self._goal_slider(_("Goal, down and up"), "y"),
        }

    @staticmethod
    def _factor(label: str, term: str, low: float, high: float) -> kit.Slider:
        """Return a slider of a factor of the spring."""
        return kit.Slider(label, term, low, high, is_log=True, digits=None, unit="/s")

    @staticmethod
    def _goal_slider(label: str, term: str) -> kit.Slider:
        """Return a slider of the ring, which is drawn in the browser."""
        return kit.Slider(label, term, -8.0, 8.0, 0.1, "cm", 1, is_drawn_here=True, is_view=True)

    @property
    def bet(self) -> kit.DrawnBet:
        """How far the pen is from the ring as time goes by."""
        question = _(
            "A spring pulls the pen to the ring, its goal, and a brake slows it. The brake is "
            "weak. How much of the way is left after each moment? Below the line it has gone past "
            "the ring."
        )
        places = np.array([[t, 100 * (1 - t / DURATION)] for t in BET_TIMES])
        labels = [_("Way left after {t:g} s").format(t=t) for t in BET_TIMES]
        return kit.DrawnBet(
            question, "time", places, labels, step=5.0, unit="%", low=-100.0, high=100.0
        )

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        start = self.start
        return (
            kit.Task(
                _("Drag the ring. Does the pen arrive wherever it is?"),
                lambda v: abs(v["goal_x"] - start["goal_x"]) > 2,
            ),
            kit.Task(
                _("Take the strongest brake and the weakest pull. Does it swing, or creep?"),
                lambda v: v["alpha"] > 40 and v["beta"] < 0.8,
            ),
            kit.Task(
                _("Pull hard and brake little. How often does it go past the ring?"),
                lambda v: v["beta"] > 20 and v["alpha"] < 6,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        return _(
            "After {time} s at most {away:g} % of the way may be left, and the pen must never go "
            "past the ring by more than {past:g} % of the way."
        ).format(time=self.time, away=MOST_AWAY, past=MOST_PAST)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        words = _("At β = α/4 it just does not swing. Try α = {alpha:g} and β = {beta:g}.")
        return (
            _("Does it swing, or does it creep? Against swinging brake more, or pull less."),
            _("There is a pull for every brake at which it just does not swing: a quarter of it."),
            words.format(**self.solution),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how far past the ring the pen goes, and how much of the way is left."""
        past, left = self._measure(answer)
        after = _("most left from {time} s on").format(time=self.time)
        return [
            kit.at_most(after, left, MOST_AWAY, "%"),
            kit.at_most(_("past the ring"), past, MOST_PAST, "%"),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return whether it swings, creeps, or is weak in all."""
        past, left = self._measure(answer)
        facts = {"alpha": f"{answer['alpha']:.2g}", "beta": f"{answer['beta']:.2g}"}
        facts |= {
            "past": kit.tell_number(past, MOST_PAST, 0),
            "left": kit.tell_number(left, MOST_AWAY, 0),
        }
        swings = _(
            "With a brake of {alpha} and a pull of {beta} the pen swings: it goes past the ring by "
            "{past} % of the way."
        )
        creeps = _(
            "The brake of {alpha} is so strong for a pull of {beta} that the pen creeps: after "
            "{time} s {left} % of the way is left."
        )
        weak = _(
            "Brake {alpha} and pull {beta} are both weak: after {time} s {left} % of the way is "
            "left."
        )
        late = left > MOST_AWAY
        found = [
            (past > MOST_PAST, swings),
            (late and answer["alpha"] > 6 * answer["beta"], creeps),
            (late, weak),
        ]
        return [(is_made, words.format(time=self.time, **facts)) for is_made, words in found]

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        past, left = self._measure(answer)
        words = _(
            "It goes past the ring by {past} % of the way, and from {time} s on it is at most "
            "{left} % away."
        )
        if past < STILL:
            words = _(
                "It does not swing, and from {time} s on at most {left} % of the way is left."
            )
        facts = {"past": kit.tell_number(past, MOST_PAST), "left": kit.tell_number(left, MOST_AWAY)}
        return words.format(time=self.time, **facts)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return where the bet was furthest off, and how far the pen went past the ring."""
        t = np.array(bet)[:, 0]
        truth = 100 * share_left(t, self.start["alpha"], self.start["beta"])
        said = np.array(bet)[:, 1]
        far = int(np.argmax(np.abs(said - truth)))
        words = _(
            "The pen swings past the ring by {past:.0f} % of the way before it comes to rest. At "
            "{t:g} s you said {said} %, and {true} % is left."
        )
        past, _left = self._measure(self.start)
        there, true = (kit.tell_number(each[far], digits=0) for each in (said, truth))
        return words.format(past=past, t=t[far], said=there, true=true)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the way to the ring, and how much of it is left over time."""
        values = state.values
        t = np.linspace(0, DURATION, 161)
        left = share_left(t, values["alpha"], values["beta"])
        is_seen = state.is_revealed or state.step != "bet"
        one = np.eye(2)[:, None] / 100
        goal = kit.Affine(np.zeros((1, 2)), {"goal_x": one[0], "goal_y": one[1]})
        path = self._follow(left if is_seen else np.ones(2))
        beads = self._follow(left[:: round(BEAD_EVERY / t[1])]) if is_seen else path
        sheet: kit.Drawing = {
            "caption": _("On paper"),
            "note": _("a bead every 0.1 s"),
            "title": _("The way of the pen to the ring."),
            "box": [-0.09, -0.06, 0.09, 0.07],
            "dots": [{"at": START[None], "kind": "start", "label": _("start")}],
            "robot": [path],
            "beads": beads,
            "rings": [self._ring(goal)],
        }
        plot: kit.Drawing = {
            "caption": _("How much of the way is left"),
            "note": _("below the line: past the ring"),
            "x": {"label": _("time [s]"), "low": 0.0, "high": DURATION},
            "y": {"label": "%", "low": -100.0, "high": 100.0},
        }
        zero = {"points": np.array([[0.0, 0.0], [DURATION, 0.0]]), "kind": "quiet"}
        plot["lines"] = [zero]
        if is_seen:
            truth = {"points": np.column_stack([t, 100 * left]), "kind": "truth"}
            plot["lines"] = [zero, truth | {"label": _("the pen")}]
            plot["bands"] = [{"from": self.time, "to": DURATION, "label": ""}]
        end = START + (1 - left[:, None]) * (self._goal(values) - START)
        return kit.Picture(self._say(values, is_seen), sheet, {"time": plot}, (Trajectory(t, end),))

    def _goal(self, values: kit.Answer) -> Array:
        """Return the place of the ring [m]."""
        return np.array([values["goal_x"], values["goal_y"]]) / 100

    def _follow(self, left: Array) -> kit.Affine:
        """Return the way of the pen, which follows the ring in the browser."""
        gone = (1 - left[:, None]) * np.eye(2)[:, None] / 100
        return kit.Affine(left[:, None] * START, {"goal_x": gone[0], "goal_y": gone[1]})

    def _ring(self, goal: kit.Affine) -> dict[str, object]:
        """Return the ring that is dragged."""
        name = _("The goal. Arrow keys move it.")
        return {
            "home": [self.start["goal_x"] / 100, self.start["goal_y"] / 100],
            "zero": [0, 0],
            "at": goal,
            "knobs": ["goal_x", "goal_y"],
            "scale": 0.01,
            "label": name,
        }

    def _measure(self, answer: kit.Answer) -> tuple[float, float]:
        """Return how far the pen goes past the goal, and what is left at the time [% of the way].

        Left is the most of all later moments, so that a pen that swings by is not called there.
        """
        t = np.linspace(0, 8, 4001)
        left = 100 * share_left(t, answer["alpha"], answer["beta"])
        return max(0.0, float(-left.min())), float(np.abs(left[t >= self.time - 1e-9]).max())

    def _say(self, values: kit.Answer, is_seen: bool) -> dict[str, str]:
        """Return the number and the sentence; before the bet is made neither."""
        if not is_seen:
            text, strong = _("The pen waits at its start. "), _("Bet first: pull the dots.")
            return {"number": "", "unit": "", "text": text, "strong": strong, "after": ""}
        past, left = self._measure(values)
        if past > MOST_PAST:
            text = _("The brake is weak for such a pull. ")
            strong = _("The pen swings past the ring, and arrives in the end.")
        else:
            text = _("It does not swing. ") if past < STILL else _("It hardly swings. ")
            strong = _("It is there in time.")
            if left > MOST_AWAY:
                strong = _("It creeps to the ring.")
        number = {"number": kit.tell_number(past, MOST_PAST, 0), "unit": _("% past the ring")}
        return {**number, "text": text, "strong": strong, "after": ""}
