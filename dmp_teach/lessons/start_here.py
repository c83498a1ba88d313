"""Lesson 00: a letter from bumps and a goal, from the first slider to the robot."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.dmp import Settings
from dmp_teach.lessons import drawing
from dmp_teach.lessons.goals import CM
from dmp_teach.letters import Letter
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

FEW, ENOUGH, MANY = 5, 40, 400
LEAST_BUMPS, MOST_BUMPS = 3, 80
GOAL_REACH, BOWL_LIMIT = 4.0, 1.0
# What is made of what, and how far up the stem the bowl must then end, as a share of it.
NEW_LETTERS = (("D", "P", 0.5), ("D", "P", 0.4), ("D", "P", 0.6), ("P", "D", 0.0))
LINE_LIMITS = (0.2, 0.1, 0.15, 0.3)


def learn_with(character: str, number: int, width: float = 1.0) -> Letter:
    """Learn a letter of our alphabet with so many kernels of one width [1/N]."""
    return drawing.learn_letter(character, Settings.star(n_kernels=number, kernel_width=width))


def most_kernels(character: str) -> int:
    """Return how many kernels a letter can have at most: one for each sample of a stroke."""
    return min(map(len, drawing.lesson_letter(character).strokes()))


def error_with(character: str, number: float, width: float = 1.0) -> float:
    """Return how far a letter with its goal at home is off the dots, on average [mm]."""
    return 1000 * drawing.error_of(learn_with(character, int(number), float(width)))


class StartHere(kit.Lesson):
    """Bumps until the line sits on the dots, then a goal that makes another letter."""

    key = "00"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose what is made of what, and how near the line must be."""
        kind = NEW_LETTERS[0 if random is None else random.integers(len(NEW_LETTERS))]
        self.limit = LINE_LIMITS[0 if random is None else random.integers(len(LINE_LIMITS))]
        self.source, self.new, self.share = kind
        self.stem, bowl = drawing.paths_of(drawing.lesson_letter(self.source).strokes())
        self.end = self.stem[-1] + self.share * (self.stem[0] - self.stem[-1])
        x, y = (round(float(each), 1) for each in (self.end - bowl[-1]) / CM)
        self.start = {"letter": "a", "n_kernels": FEW, "kernel_width": 1.0}
        self.start |= {"goal_x": 0.0, "goal_y": 0.0}
        self.solution = self.start | {"letter": self.source, "n_kernels": ENOUGH}
        self.solution |= {"goal_x": x, "goal_y": y}

    @property
    def question(self) -> str:
        """The title."""
        return _("Can a robot learn your handwriting?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can set."""
        letters = {each: each for each in ("a", "e", "S", self.source)}
        goal = partial(kit.Slider, step=0.1, unit="cm", digits=1, is_drawn_here=True)
        needed = self.solution["goal_y"]
        low, high = min(-GOAL_REACH, np.floor(needed)), max(GOAL_REACH, np.ceil(needed))
        return {
            "letter": kit.OneOf(_("Letter"), letters),
            "n_kernels": kit.Slider.of("n_kernels", LEAST_BUMPS, MOST_BUMPS, icons=("one", "many")),
            "kernel_width": kit.Slider.of(
                "kernel_width", 0.25, 10.0, is_log=True, icons=("narrow", "one")
            ),
            "goal_x": goal(_("Goal, left and right"), "g", -GOAL_REACH, GOAL_REACH),
            "goal_y": goal(_("Goal, down and up"), "g", float(low), float(high)),
        }

    @property
    def bet(self) -> kit.ChosenBet:
        """How many bumps are needed."""
        question = _(
            "The dots are an a that a person wrote. The robot remembers it as {n} bumps, and its "
            "line is far off. How many bumps does it need until you see no difference?"
        )
        options = {str(n): _("about {n}").format(n=n) for n in (FEW, ENOUGH, MANY)}
        return kit.ChosenBet(question.format(n=FEW), options)

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Move “How many bumps” until the line sits on the dots."),
                lambda v: error_with(v["letter"], v["n_kernels"], v["kernel_width"]) < 0.5,
            ),
            kit.Task(
                _("Drag the ring to another place. Is it still the same letter?"),
                lambda v: np.hypot(v["goal_x"], v["goal_y"]) > 1,
            ),
            kit.Task(_("Let the robot write what you see."), by_robot=True),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "Make a {new} that nobody ever wrote. Choose {source} and bring its line within "
            "{limit:g} mm of the dots. Then drag its ring: the bowl must end within {away:g} cm of "
            "{place}."
        )
        return words.format(**self._facts)

    @property
    def _place(self) -> str:
        """Where the bowl must end."""
        if self.share == 0.5:
            return _("the middle of the stem")
        cm = self.share * np.linalg.norm(self.stem[0] - self.stem[-1]) / CM
        up = _("the point {cm:.1f} cm up the stem").format(cm=cm)
        return up if self.share else _("the foot of the stem")

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        look = _("Look at a printed {new}. Where does its bowl meet its stem?")
        drag = _("Enough bumps that just touch bring the line to the dots. Then drag the ring.")
        last = _("Take {source}, {n} bumps of width 1.0, and move the goal {y:.1f} cm {way}.")
        y = self.solution["goal_y"]
        way = {"n": ENOUGH, "y": abs(y), "way": _("up") if y > 0 else _("down")}
        return look.format(new=self.new), drag, last.format(**self._facts, **way)

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return the strokes, how near the line is, and where the bowl ends."""
        strokes = kit.exactly(_("strokes"), len(learn_with(answer["letter"], FEW).strokes), 2)
        line = kit.at_most(_("line before the ring moved"), self._error(answer), self.limit, "mm")
        if answer["letter"] != self.source:
            return [strokes, line]
        away = float(np.linalg.norm(self._miss(answer)))
        return [strokes, line, kit.at_most(_("bowl to its place"), away, BOWL_LIMIT, "cm")]

    def _error(self, answer: kit.Answer) -> float:
        """Return how far the line is off the dots, its goal at home [mm]."""
        return error_with(answer["letter"], answer["n_kernels"], answer["kernel_width"])

    def _miss(self, answer: kit.Answer) -> Array:
        """Return how far right of its place, and above it, the bowl ends, shape (2,) [cm]."""
        values = answer["letter"], answer["n_kernels"], answer["kernel_width"]
        bowl = learn_with(*values).write(goal_shifts={1: _shift(answer)})[1]
        return (bowl.position[-1] - self.end) / CM

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is wrong with the letter, the bumps or the goal."""
        if answer["letter"] != self.source:
            other = _("The {letter} has 1 stroke. A {new} has a stem and a bowl: choose {source}.")
            return [(True, other.format(letter=answer["letter"], **self._facts))]
        width, error = float(answer["kernel_width"]), self._error(answer)
        right, above = self._miss(answer)
        gaps = _(
            "At width {width:.2g} no bump is awake for {asleep:.0f} % of the time, and the pen "
            "drifts: the {source} is {mm} mm off the dots."
        )
        wide = _(
            "At width {width:.2g} each bump mixes what {width:.2g} places need: the {source} is "
            "{mm} mm off the dots."
        )
        few = _("{n} bumps are too few: the {source} is {mm} mm off the dots, and may be {limit}.")
        below = _("The bowl ends {y:.1f} cm below {place}.")
        over = _("The bowl ends {y:.1f} cm above {place}.")
        left = _("The bowl ends {x:.1f} cm to the left of {place}.")
        aside = _("The bowl ends {x:.1f} cm to the right of {place}.")
        is_off, is_away = error > self.limit, np.hypot(right, above) > BOWL_LIMIT
        found = [
            (is_off and width < 1, gaps),
            (is_off and width > 1.5, wide),
            (is_off, few),
            (is_away and abs(right) > abs(above), left if right < 0 else aside),
            (is_away, below if above < 0 else over),
        ]
        facts = {"width": width, "asleep": 100 * (1 - width), "n": answer["n_kernels"]}
        facts |= {"mm": drawing.millimetres(error / 1000), "x": abs(right), "y": abs(above)}
        return [(bool(is_made), words.format(**facts, **self._facts)) for is_made, words in found]

    @property
    def _facts(self) -> dict[str, object]:
        """What is asked for."""
        letters = {"source": self.source, "new": self.new}
        return {**letters, "limit": self.limit, "away": BOWL_LIMIT, "place": self._place}

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "A {new} made from the strokes of the person who wrote the {source}: its bowl ends "
            "{cm:.1f} cm from {place}."
        )
        return words.format(cm=np.linalg.norm(self._miss(answer)), **self._facts)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return the errors with few, with enough, and with the most bumps there can be."""
        most = most_kernels("a")
        errors = [drawing.millimetres(error_with("a", n) / 1000) for n in (FEW, ENOUGH, most)]
        words = _(
            "You said about {said}. With {few} bumps the a is {e[0]} mm off. With {enough} it is "
            "{e[1]} mm off, as thick as a hair. With {most}, the most that it can have, it is "
            "{e[2]} mm off: nobody sees that."
        )
        return words.format(said=bet, few=FEW, enough=ENOUGH, most=most, e=errors)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the letter, how far off it is, and its bumps over time."""
        is_truth = state.step == "bet" and state.is_revealed
        values = state.values | ({"n_kernels": ENOUGH} if is_truth else {})
        letter = learn_with(values["letter"], int(values["n_kernels"]), values["kernel_width"])
        last = len(letter.strokes) - 1
        to_goal = letter.responses[last]
        terms = dict(zip(drawing.GOAL_KNOBS, CM * to_goal.to_goal, strict=True))
        lines = [*drawing.paths_of(letter.write())[:last], kit.Affine(to_goal.base, terms)]
        moves = [by * CM * GOAL_REACH * term for term in to_goal.to_goal for by in (-1, 1)]
        sheet = drawing.draw_sheet(
            letter.strokes,
            lines,
            box=drawing.sheet_box(
                [*drawing.paths_of(letter.strokes), *(to_goal.base + move for move in moves)]
            ),
            rings=[drawing.goal_ring(letter.primitives[last].goal, state.step == "bet")],
            caption=_("On paper"),
            note=_("{n} bumps").format(n=values["n_kernels"]),
        )
        plots = {"errors": self._draw_errors(state), "bumps": drawing.draw_bumps(letter)}
        written = letter.write(goal_shifts={last: _shift(values)})
        return kit.Picture(self._say(values), sheet, plots, written)

    def _draw_errors(self, state: kit.LessonState) -> kit.Drawing:
        """Draw how far off this letter is, and the three of the bet once they may be seen."""
        letter, error = str(state.values["letter"]), self._error(state.values)
        most = most_kernels(letter)
        numbers = (FEW, ENOUGH, most) if state.is_revealed else ()
        dots = [{"at": [n, error_with(letter, n)], "kind": "truth", "label": ""} for n in numbers]
        dots[-1:] = [each | {"label": str(most)} for each in dots[-1:]]
        ticks = [[0.1, _("0.1 mm a hair")], [10, _("10 mm a finger")]]
        x = {"label": "", "low": LEAST_BUMPS, "high": MANY, "log": True}
        x |= {"ticks": [[n, str(n)] for n in (FEW, ENOUGH, MANY)]}
        return {
            "caption": _("How far off"),
            "x": x,
            "y": drawing.error_axis() | {"low": 0.01, "ticks": ticks},
            "dots": [*dots, {"at": [state.values["n_kernels"], error], "kind": "robot"}],
        }

    def _say(self, values: kit.Answer) -> dict[str, str]:
        """Return the number and the sentence."""
        far = float(np.hypot(values["goal_x"], values["goal_y"]))
        width, error = float(values["kernel_width"]), self._error(values)
        number, unit = drawing.millimetres(error / 1000), _("mm off the dots")
        text = _("{n} bumps of width {width:.2g}. ").format(n=values["n_kernels"], width=width)
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
        else:
            strong = _("Bends are cut short: try more bumps.")
        return {"number": number, "unit": unit, "text": text, "strong": strong, "after": ""}


def _shift(values: kit.Answer) -> Array:
    """Return how far the goal has moved, shape (2,) [m]."""
    return CM * np.array([values["goal_x"], values["goal_y"]])
