"""Lesson 00: a letter from bumps and a goal, from the first slider to the robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.lessons.goals import CM
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array

FEW, ENOUGH, MANY = 5, 40, 400
LEAST_BUMPS, MOST_BUMPS = 3, 80
GOAL_REACH = 4.0
# What is made of what, and how far up the stem the bowl must then end, as a share of it.
NEW_LETTERS = (("D", "P", 0.5), ("D", "P", 0.4), ("D", "P", 0.6), ("P", "D", 0.0))
LINE_LIMITS = (0.2, 0.1, 0.15, 0.3)


def learn_with(character: str, number: float, width: float = 1.0) -> Letter:
    """Learn a letter of our alphabet with so many kernels of one width [1/N]."""
    settings = Settings.star(n_kernels=int(number), kernel_width=float(width))
    return drawing.learn_letter(character, settings)


def most_kernels(character: str) -> int:
    """Return how many kernels a letter can have at most: one for each sample of a stroke."""
    return min(map(len, drawing.lesson_letter(character).strokes()))


def error_with(character: str, number: float, width: float = 1.0) -> float:
    """Return how far a letter with its goal at home is off the dots, on average [mm]."""
    return 1000 * drawing.error_of(learn_with(character, number, width))


class StartHere(kit.Lesson):
    """Bumps until the line sits on the dots, then a goal that makes another letter."""

    key = "00"
    away, few, enough = 1.0, FEW, ENOUGH
    question = marked("Can a robot learn your handwriting?")
    bet_question = marked(
        "The dots are an a that a person wrote. The robot remembers it as {few} bumps, and its "
        "line is far off. How many bumps does it need until you see no difference?"
    )
    tasks = (
        marked("Move “How many bumps” until the line sits on the dots."),
        marked("Drag the ring to another place. Is it still the same letter?"),
        marked("Let the robot write what you see."),
    )
    by_robot = (2,)
    challenge = marked(
        "Make a {new} that nobody ever wrote. Choose {source} and bring its line within {limit:g} "
        "mm of the dots. Then drag its ring: the bowl must end within {away:g} cm of {place}."
    )
    hints = (
        marked("Look at a printed {new}. Where does its bowl meet its stem?"),
        marked("Enough bumps that just touch bring the line to the dots. Then drag the ring."),
        marked("Take {source}, {enough} bumps of width 1.0, and move the goal {up:.1f} cm {way}."),
    )
    praise = marked(
        "A {new} made from the strokes of the person who wrote the {source}: its bowl ends "
        "{cm:.1f} cm from {place}."
    )

    def vary(self) -> None:
        self.source, self.new, share = self.choose(NEW_LETTERS)
        self.limit = self.choose(LINE_LIMITS)
        stem, bowl = drawing.paths_of(drawing.lesson_letter(self.source).strokes())
        self.end = stem[-1] + share * (stem[0] - stem[-1])
        x, y = (round(float(each), 1) for each in (self.end - bowl[-1]) / CM)
        self.start = {"letter": "a", "n_kernels": FEW, "kernel_width": 1.0}
        self.start |= {"goal_x": 0.0, "goal_y": 0.0}
        self.solution = self.start | {"letter": self.source, "n_kernels": ENOUGH}
        self.solution |= {"goal_x": x, "goal_y": y}
        place = _("the point {cm:.1f} cm up the stem") if share else _("the foot of the stem")
        place = _("the middle of the stem") if share == 0.5 else place
        self.place = place.format(cm=share * np.linalg.norm(stem[0] - stem[-1]) / CM)
        self.up, self.way = abs(y), _("up") if y > 0 else _("down")

    @property
    def knobs(self) -> kit.Knobs:
        letters = {each: each for each in ("a", "e", "S", self.source)}
        many, width = {"icons": ("one", "many")}, {"is_log": True, "icons": ("narrow", "one")}
        needed, reach = self.solution["goal_y"], GOAL_REACH
        low, high = min(-reach, np.floor(needed)), max(reach, np.ceil(needed))
        return {
            "letter": kit.OneOf(_("Letter"), letters),
            "n_kernels": kit.Slider.of("n_kernels", LEAST_BUMPS, MOST_BUMPS, **many),
            "kernel_width": kit.Slider.of("kernel_width", 0.25, 10.0, **width),
            "goal_x": drawing.goal_slider(_("Goal, left and right"), -reach, reach),
            "goal_y": drawing.goal_slider(_("Goal, down and up"), float(low), float(high)),
        }

    @property
    def bet(self) -> kit.ChosenBet:
        options = {str(n): _("about {n}").format(n=n) for n in (FEW, ENOUGH, MANY)}
        return kit.ChosenBet(self.bet_question, options)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            error_with(v["letter"], v["n_kernels"], v["kernel_width"]) < 0.5,
            np.hypot(v["goal_x"], v["goal_y"]) > 1,
            True,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        strokes = len(learn_with(answer["letter"], FEW).strokes)
        line = _("line before the ring moved")
        asked = [
            kit.exactly(_("strokes"), strokes, 2),
            kit.at_most(line, _error(answer), self.limit, "mm"),
        ]
        if answer["letter"] == self.source:
            away = float(np.linalg.norm(self._miss(answer)))
            asked.append(kit.at_most(_("bowl to its place"), away, self.away, "cm"))
        return asked

    def _miss(self, answer: kit.Answer) -> Array:
        """Return how far right of its place, and above it, the last stroke ends (2,) [cm]."""
        letter = learn_with(answer["letter"], answer["n_kernels"], answer["kernel_width"])
        last = len(letter.strokes) - 1
        bowl = letter.write(goal_shifts={last: _shift(answer)})[last]
        return (bowl.position[-1] - self.end) / CM

    def measure(self, answer: kit.Answer) -> kit.Answer:
        width, (x, y) = float(answer["kernel_width"]), map(abs, self._miss(answer))
        return {
            **{"letter": answer["letter"], "n": answer["n_kernels"], "width": width},
            **{"asleep": 100 * (1 - width), "mm": drawing.millimetres(_error(answer) / 1000)},
            **{"x": x, "y": y, "cm": np.hypot(x, y)},
        }

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        width, (right, above) = answer["kernel_width"], self._miss(answer)
        is_away = np.hypot(right, above) > self.away
        if answer["letter"] != self.source:
            yield _("The {letter} has 1 stroke. A {new} has a stem and a bowl: choose {source}.")
        elif _error(answer) > self.limit and width < 1:
            yield _(
                "At width {width:.2g} no bump is awake for {asleep:.0f} % of the time, and the pen "
                "drifts: the {source} is {mm} mm off the dots."
            )
        elif _error(answer) > self.limit and width > 1.5:
            yield _(
                "At width {width:.2g} each bump mixes what {width:.2g} places need: the {source} "
                "is {mm} mm off the dots."
            )
        elif _error(answer) > self.limit:
            yield _(
                "{n} bumps are too few: the {source} is {mm} mm off the dots, and may be {limit}."
            )
        elif is_away and abs(right) > abs(above):
            left = _("The bowl ends {x:.1f} cm to the left of {place}.")
            yield left if right < 0 else _("The bowl ends {x:.1f} cm to the right of {place}.")
        elif is_away:
            below = _("The bowl ends {y:.1f} cm below {place}.")
            yield below if above < 0 else _("The bowl ends {y:.1f} cm above {place}.")

    def tell_bet(self, bet: kit.KeptBet) -> str:
        most = most_kernels("a")
        errors = [drawing.millimetres(error_with("a", n) / 1000) for n in (FEW, ENOUGH, most)]
        return _(
            "You said about {said}. With {few} bumps the a is {e[0]} mm off. With {enough} it is "
            "{e[1]} mm off, as thick as a hair. With {most}, the most that it can have, it is "
            "{e[2]} mm off: nobody sees that."
        ).format(said=bet, few=FEW, enough=ENOUGH, most=most, e=errors)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        is_truth = state.step == "bet" and state.is_revealed
        values = state.values | ({"n_kernels": ENOUGH} if is_truth else {})
        letter = learn_with(values["letter"], values["n_kernels"], values["kernel_width"])
        last = len(letter.strokes) - 1
        to_goal = letter.responses[last]
        terms = dict(zip(drawing.GOAL_KNOBS, CM * to_goal.to_goal, strict=True))
        moves = [by * CM * GOAL_REACH * term for term in to_goal.to_goal for by in (-1, 1)]
        paths = [*drawing.paths_of(letter.strokes), *(to_goal.base + move for move in moves)]
        sheet = drawing.draw_sheet(
            letter.strokes,
            [*drawing.paths_of(letter.write())[:last], kit.Affine(to_goal.base, terms)],
            box=drawing.sheet_box(paths),
            rings=[drawing.goal_ring(letter.primitives[last].goal, state.step == "bet")],
            note=_("{n} bumps").format(n=values["n_kernels"]),
        )
        plots = {"errors": _draw_errors(state), "bumps": drawing.draw_bumps(letter)}
        written = letter.write(goal_shifts={last: _shift(values)})
        return kit.Picture(_say(values), sheet, plots, written)


def _error(values: kit.Answer) -> float:
    """Return how far the line is off the dots, its goal at home [mm]."""
    return error_with(values["letter"], values["n_kernels"], values["kernel_width"])


def _shift(values: kit.Answer) -> Array:
    """Return how far the goal has moved, shape (2,) [m]."""
    return CM * np.array([values["goal_x"], values["goal_y"]])


def _draw_errors(state: kit.LessonState) -> kit.Drawing:
    """Draw how far off this letter is, and the three of the bet once they may be seen."""
    letter = str(state.values["letter"])
    most = most_kernels(letter)
    numbers = {FEW: "", ENOUGH: "", most: str(most)} if state.is_revealed else {}
    dots = [drawing.mark([n, error_with(letter, n)], "truth", word) for n, word in numbers.items()]
    dots.append(drawing.mark([state.values["n_kernels"], _error(state.values)], "robot"))
    x = drawing.axis(LEAST_BUMPS, MANY, log=True, ticks=[[n, str(n)] for n in (FEW, ENOUGH, MANY)])
    ticks = [[0.1, _("0.1 mm a hair")], [10, _("10 mm a finger")]]
    y = drawing.error_axis() | {"low": 0.01, "ticks": ticks}
    return drawing.plot(_("How far off"), x, y, dots=dots)


def _say(values: kit.Answer) -> kit.Message:
    """Return the number and the sentence."""
    far, width, error = np.linalg.norm(_shift(values)) / CM, values["kernel_width"], _error(values)
    number, unit = drawing.millimetres(error / 1000), _("mm off the dots")
    text = _("{n} bumps of width {width:.2g}. ").format(n=values["n_kernels"], width=width)
    strong = _("Bends are cut short: try more bumps.")
    if far > 0.05:
        number, unit = f"{far:.1f}", "cm"
        text = _("is how far the goal has moved. ")
        strong = _("The spring pulls the pen there; the bumps push as before.")
    elif error < 0.5:
        strong = _("The line sits on the dots.")
    elif width < 1:
        strong = _("There are gaps between the bumps: the pen drifts.")
    elif width > 1.5:
        strong = _("Wide bumps mix with their neighbours.")
    return kit.says(number, unit, text, strong)
