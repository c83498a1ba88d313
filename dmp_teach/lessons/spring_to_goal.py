"""Lesson 01: a damped spring always arrives (equation 1 of the paper, without its forcing term)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.drawing import axis, goal_slider, line, plot
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array, Trajectory

DURATION = 2.0
BET_TIMES = (0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0)
START = np.array([-0.06, -0.03])
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
    most_past, most_left = 1.0, 2.0
    question = marked("Why does the pen always arrive?")
    bet_question = marked(
        "A spring pulls the pen to the ring, its goal, and a brake slows it. The brake is weak. "
        "How much of the way is left after each moment? Below the line it has gone past the ring."
    )
    tasks = (
        marked("Drag the ring. Does the pen arrive wherever it is?"),
        marked("Take the strongest brake and the weakest pull. Does it swing, or creep?"),
        marked("Pull hard and brake little. How often does it go past the ring?"),
    )
    challenge = marked(
        "After {time} s at most {most_left:g} % of the way may be left, and the pen must never go "
        "past the ring by more than {most_past:g} % of the way."
    )
    hints = (
        marked("Does it swing, or does it creep? Against swinging brake more, or pull less."),
        marked("There is a pull for every brake at which it just does not swing: a quarter of it."),
        marked(
            "At β = α/4 it just does not swing. Try α = {solution[alpha]:g} and β = "
            "{solution[beta]:g}."
        ),
    )

    def vary(self) -> None:
        tenths = 9 if self.random is None else int(self.random.integers(6, 15))
        self.time = tenths / 10
        goal = (6.0, 3.0) if self.random is None else self.random.integers([3, -1], [9, 6])
        # Two figures, as the sliders have.
        alpha = float(f"{13 / self.time:.2g}")
        beta = float(f"{alpha / 4:.2g}")
        x, y = map(float, goal)
        self.start = {"alpha": 3.0, "beta": 12.0, "goal_x": x, "goal_y": y}
        self.solution = self.start | {"alpha": alpha, "beta": beta}

    @property
    def knobs(self) -> kit.Knobs:
        def factor(label: str, term: str, low: float, high: float) -> kit.Slider:
            return kit.Slider(label, term, low, high, is_log=True, digits=None, unit="/s")

        # Where the ring is does not matter to the answer.
        return {
            "alpha": factor(_("How hard it brakes"), "α", 2.0, 60.0),
            "beta": factor(_("How hard it pulls"), "β", 0.5, 30.0),
            "goal_x": goal_slider(_("Goal, left and right"), -8.0, 8.0, term="x", is_view=True),
            "goal_y": goal_slider(_("Goal, down and up"), -8.0, 8.0, term="y", is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        places = np.array([[t, 100 * (1 - t / DURATION)] for t in BET_TIMES])
        label, ends = _("Way left after {x:g} s"), (-100.0, 100.0)
        return kit.DrawnBet(self.bet_question, "time", places, label, "y", 5.0, "%", *ends)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            abs(v["goal_x"] - self.start["goal_x"]) > 2,
            v["alpha"] > 40 and v["beta"] < 0.8,
            v["beta"] > 20 and v["alpha"] < 6,
        )

    def _swing(self, answer: kit.Answer) -> tuple[float, float]:
        """Return how far the pen goes past the goal, and the most left from the time on [%]."""
        t = np.linspace(0, 8, 4001)
        left = 100 * share_left(t, answer["alpha"], answer["beta"])
        return max(0.0, float(-left.min())), float(np.abs(left[t >= self.time - 1e-9]).max())

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        past, left = self._swing(answer)
        return [
            kit.at_most(self.tell(marked("most left from {time} s on")), left, self.most_left, "%"),
            kit.at_most(_("past the ring"), past, self.most_past, "%"),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        past, left = self._swing(answer)
        facts = {"alpha": f"{answer['alpha']:.2g}", "beta": f"{answer['beta']:.2g}"}
        for name, value, most in (("past", past, self.most_past), ("left", left, self.most_left)):
            facts[name] = kit.tell_number(value, most, int(value < 10))
        return facts

    def praised(self, answer: kit.Answer) -> str:
        if self._swing(answer)[0] < STILL:
            return _("It does not swing, and from {time} s on at most {left} % of the way is left.")
        return _(
            "It goes past the ring by {past} % of the way, and from {time} s on it is at most "
            "{left} % away."
        )

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        past, left = self._swing(answer)
        if past > self.most_past:
            yield _(
                "With a brake of {alpha} and a pull of {beta} the pen swings: it goes past the "
                "ring by {past} % of the way."
            )
        if left > self.most_left and answer["alpha"] > 6 * answer["beta"]:
            yield _(
                "The brake of {alpha} is so strong for a pull of {beta} that the pen creeps: after "
                "{time} s {left} % of the way is left."
            )
        if left > self.most_left:
            yield _(
                "Brake {alpha} and pull {beta} are both weak: after {time} s {left} % of the way "
                "is left."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        t, said = np.array(bet).T
        truth = 100 * share_left(t, self.start["alpha"], self.start["beta"])
        far = int(np.argmax(np.abs(said - truth)))
        there, true = (kit.tell_number(each[far], digits=0) for each in (said, truth))
        return _(
            "The pen swings past the ring by {past:.0f} % of the way before it comes to rest. At "
            "{t:g} s you said {said} %, and {true} % is left."
        ).format(past=self._swing(self.start)[0], t=t[far], said=there, true=true)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        values = state.values
        t = np.linspace(0, DURATION, 161)
        left = share_left(t, values["alpha"], values["beta"])
        is_seen = not state.is_hidden
        path = _follow(left if is_seen else np.ones(2))
        sheet: kit.Drawing = {
            "caption": _("On paper"),
            "note": _("a bead every 0.1 s"),
            "title": _("The way of the pen to the ring."),
            "box": [-0.09, -0.06, 0.09, 0.07],
            "dots": [{"at": START[None], "kind": "start", "label": _("start")}],
            "robot": [path],
            "beads": _follow(left[:: round(BEAD_EVERY / t[1])]) if is_seen else path,
            "rings": [self._ring()],
        }
        time = plot(
            _("How much of the way is left"),
            axis(0, DURATION, _("time [s]")),
            axis(-100, 100, "%"),
            _("below the line: past the ring"),
            lines=[line(np.array([[0.0, 0.0], [DURATION, 0.0]]), "quiet")],
        )
        if is_seen:
            truth = line(np.column_stack([t, 100 * left]), "truth", _("the pen"))
            time["lines"] = [*time["lines"], truth]  # type: ignore[misc]
            time["bands"] = [{"from": self.time, "to": DURATION, "label": ""}]
        goal = np.array([values["goal_x"], values["goal_y"]]) / 100
        written = Trajectory(t, START + (1 - left[:, None]) * (goal - START))
        return kit.Picture(self._say(values, is_seen), sheet, {"time": time}, (written,))

    def _ring(self) -> kit.Drawing:
        """Return the ring that is dragged."""
        home = [self.start["goal_x"] / 100, self.start["goal_y"] / 100]
        ring = {"home": home, "zero": [0, 0], "at": _follow(np.zeros(1)), "scale": 0.01}
        return ring | {"knobs": ["goal_x", "goal_y"], "label": _("The goal. Arrow keys move it.")}

    def _say(self, values: kit.Answer, is_seen: bool) -> kit.Message:
        """Return the number and the sentence; before the bet is made neither."""
        if not is_seen:
            text = _("The pen waits at its start. ")
            return kit.says(text=text, strong=_("Bet first: pull the dots."))
        past, left = self._swing(values)
        text = _("It does not swing. ") if past < STILL else _("It hardly swings. ")
        strong = _("It creeps to the ring.") if left > self.most_left else _("It is there in time.")
        if past > self.most_past:
            text = _("The brake is weak for such a pull. ")
            strong = _("The pen swings past the ring, and arrives in the end.")
        return kit.says(
            kit.tell_number(past, self.most_past, 0), _("% past the ring"), text, strong
        )


def _follow(left: Array) -> kit.Affine:
    """Return the way of the pen, which follows the ring in the browser."""
    gone = (1 - left[:, None]) * np.eye(2)[:, None] / 100
    return kit.Affine(left[:, None] * START, {"goal_x": gone[0], "goal_y": gone[1]})
