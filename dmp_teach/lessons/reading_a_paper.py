"""Lesson 11: a paper as printed, as coded and as fixed (its equations and both algorithms)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons.drawing import draw_sheet, paths_of
from dmp_teach.lessons.paper_readings import (
    AS_CODED,
    AS_FIXED,
    AS_PRINTED,
    FAULTY,
    MENDED,
    PLACES,
    changed,
    error_by,
    error_left,
    facts_of,
    find_best,
    find_costliest,
    find_idlest,
    formulas,
    learn_by,
    mend,
    names,
    notes,
    symptom_of,
)
from dmp_teach.texts import gettext as _

MISREAD_LETTERS = "abcehmrsuSG"
MOST_CHANGES = 3
# A letter that is farther off [mm] is not on the sheet.
OFF_THE_SHEET = 50.0


class ReadingAPaper(kit.Lesson):
    """A paper that is built word for word does not work, and three of its words are to blame."""

    key = "11"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter; its limit is what the best three changes reach."""
        self.letter = "a" if random is None else str(random.choice(list(MISREAD_LETTERS)))
        self.best = find_best(self.letter, MOST_CHANGES)
        self.start, self.solution = AS_PRINTED, mend(*self.best)
        self.limit = math.ceil(10 * error_by(self.letter, self.solution)) / 10

    @property
    def question(self) -> str:
        """The title."""
        return _("What if you build a paper word for word?")

    @property
    def knobs(self) -> kit.Knobs:
        """A switch for each place of the paper."""
        words, about = formulas(), notes()
        return {
            name: kit.OneOf(_upper(label), words[name], note=about[name])
            for name, label in names().items()
        }

    @property
    def bet(self) -> kit.ChosenBet:
        """The place that costs most."""
        question = _(
            "Built word for word from a paper, the robot writes this {letter}. Six places are "
            "unclear or wrong. Mend five: which one, left as printed, spoils the letter most?"
        )
        options = {name: label for name, label in names().items() if name in FAULTY}
        return kit.ChosenBet(question.format(letter=self.letter), options, notes())

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(
                _("Mend one place that brings the letter back to the sheet. Which one does?"),
                lambda v: v["push"] == MENDED,
            ),
            kit.Task(
                _(
                    "Take the authors’ program: all that is named program, and push and bump ends "
                    "mended."
                ),
                lambda v: v == AS_CODED,
            ),
            kit.Task(
                _("Mend all six. Then put one back that nobody would miss."),
                lambda v: v["width"] == "printed" and list(v.values()).count(MENDED) == 5,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        return _(
            "Which three matter? Bring the {letter} within {limit:g} mm with at most three changes "
            "of what is printed."
        ).format(letter=self.letter, limit=self.limit)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        found = _(" and ").join(f"“{names()[name]}”" for name in self.best)
        return (
            _("Mend first what costs most as things are. Then look again."),
            _("One place costs metres, one a centimetre, and one about a millimetre."),
            _("Mend {found}, and leave the rest as printed.").format(found=found),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return the error, and the number of changes."""
        number = len(changed(answer))
        return [
            kit.at_most(self.letter, error_by(self.letter, answer), self.limit, "mm"),
            kit.at_most(_("changes"), number, MOST_CHANGES),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return which change does nothing, and what still spoils the letter most."""
        error, number = error_by(self.letter, answer), len(changed(answer))
        facts = facts_of(self.letter, answer) | {"letter": self.letter, "number": number}
        facts |= {"error": tell_way(error, self.limit)}
        words = _("The {letter} is {error} off. ")
        if number >= MOST_CHANGES:
            idle, back = find_idlest(self.letter, answer)
            facts |= {"idle": names()[idle], "back": tell_way(back)}
            words = _("The {letter} is {error} off, with {number} changes. ")
            least = _("“{idle}” does least: as printed {back}. ")
            harm = _("“{idle}” does harm: as printed {back}. ")
            words += harm if back < error else least
        if error > self.limit:
            costly = find_costliest(self.letter, answer)
            words += symptom_of(costly, str(answer[costly]))
        is_wrong = error > self.limit or number > MOST_CHANGES
        return [(is_wrong, words.format(**facts).strip())]

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        left = [name for name in FAULTY if answer[name] != MENDED]
        words = _(
            "{error} off with {number} changes, where the paper as printed is {printed} off. The "
            "other {n} places save {rest} together."
        )
        error = error_by(self.letter, answer)
        return words.format(
            error=tell_way(error, self.limit),
            number=len(changed(answer)),
            printed=tell_way(error_by(self.letter, AS_PRINTED)),
            n=len(left),
            rest=tell_way(error - error_by(self.letter, AS_FIXED)),
        )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return what the place of the bet costs, and which costs most."""
        worst = max(FAULTY, key=lambda name: error_left(self.letter, name))
        facts = {"said": names()[bet], "worst": names()[worst], "letter": self.letter}
        facts |= {"cost": tell_way(error_left(self.letter, bet))}
        facts |= {"most": tell_way(error_left(self.letter, worst))}
        facts |= {"all": tell_way(error_by(self.letter, AS_FIXED))}
        words = _(
            "With “{said}” left as printed the {letter} is {cost} off; with all mended {all}. "
            "Most is spoiled by “{worst}”: {most}."
        )
        if bet == worst:
            words = _(
                "You found it: with “{said}” left as printed the {letter} is {cost} off, and with "
                "all mended {all}."
            )
        return words.format(**facts)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the letter, and beside it what each place costs, or what was tried."""
        letter = learn_by(self.letter, state.values)
        written, error = letter.write(), error_by(self.letter, state.values)
        note = _("changes: {n}").format(n=len(changed(state.values)))
        caption = {"caption": _("On paper"), "note": note}
        sheet = draw_sheet(letter.strokes, paths_of(written), **caption)
        if state.step == "bet":
            plots = {"costs": self._draw_costs(state)}
        else:
            plots = {"tried": self._draw_tried(state)}
        strokes = written if error < OFF_THE_SHEET else ()
        return kit.Picture(self._say(state.values), sheet, plots, strokes)

    def _draw_costs(self, state: kit.LessonState) -> kit.Drawing:
        """Draw a bar for each place: the error if it alone is left as printed."""
        ticks, bars = [], []
        for place, name in enumerate(reversed(FAULTY), start=1):
            ticks.append([place, names()[name]])
            cost = error_left(self.letter, name)
            low, high = place - 0.32, place + 0.32
            points = np.array([[0.1, low], [cost, low], [cost, high], [0.1, high]])
            bars.append({"points": points, "base": low, "lit": name == state.bet})
        return {
            "caption": _("One left as printed, five mended: how far off"),
            "x": _way_axis(),
            "y": {"label": "", "low": 0.5, "high": len(FAULTY) + 0.5, "ticks": ticks},
            "fills": bars if state.is_revealed else [],
        }

    def _draw_tried(self, state: kit.LessonState) -> kit.Drawing:
        """Draw each set of readings that was tried: its changes, and its error."""
        now = self._place(state.values)
        tried = {self._place(each) for each in state.tried if set(each) == set(PLACES)} - {now}
        dots = [{"at": list(place), "kind": "quiet"} for place in sorted(tried)]
        dots.append({"at": list(now), "kind": "robot", "label": _("now")})
        plot: kit.Drawing = {
            "caption": _("How far off"),
            "x": {"label": _("changes"), "low": -0.3, "high": 7.3, "ticks": _whole(len(PLACES))},
            "y": _way_axis(),
            "dots": dots,
        }
        if state.step == "challenge":
            line = np.array([[-0.3, self.limit], [MOST_CHANGES + 0.5, self.limit]])
            note = _("{mm:g} mm, at most {n} changes")
            plot["note"] = note.format(mm=self.limit, n=MOST_CHANGES)
            plot["lines"] = [{"points": line, "kind": "truth"}]
            plot["bands"] = [{"from": -0.3, "to": MOST_CHANGES + 0.5}]
        return plot

    def _place(self, readings: kit.Answer) -> tuple[float, float]:
        """Return where readings stand on the plot of what was tried."""
        return float(len(changed(readings))), error_by(self.letter, readings)

    def _say(self, readings: kit.Answer) -> dict[str, str]:
        """Return the number and the sentence."""
        error = error_by(self.letter, readings)
        number, unit = tell_way(error).split(" ")
        whole = {str(AS_PRINTED): _("This is the paper as printed. ")}
        whole |= {str(AS_CODED): _("The authors’ program writes it so. ")}
        whole |= {str(AS_FIXED): _("This is the paper with all six mended. ")}
        strong = _("The line is within its own thickness.")
        if error > OFF_THE_SHEET:
            strong = _("The pen has left the sheet.")
        elif error > 5:
            strong = _("The shape is lost.")
        elif error > 1:
            strong = _("It can be read, and you see where it is off.")
        says = {"number": number, "unit": _("{unit} off on average").format(unit=unit)}
        return says | {"text": whole.get(str(readings), ""), "strong": strong, "after": ""}


def tell_way(mm: float, limit: float = math.inf) -> str:
    """Return a length [mm] as it is read: "0.23 mm", "12 mm", "47 m"."""
    if mm >= 1000:
        return f"{kit.tell_number(mm / 1000, digits=1 if mm < 9950 else 0)} m"
    return f"{kit.tell_number(mm, limit, 2 if mm < 0.995 else 1 if mm < 9.95 else 0)} mm"


def _upper(words: str) -> str:
    """Return words with a capital."""
    return words[:1].upper() + words[1:]


def _whole(most: int) -> list[list[object]]:
    """Return ticks at whole numbers."""
    return [[float(n), str(n)] for n in range(most + 1)]


def _way_axis() -> kit.Drawing:
    """Return an axis of lengths from a hair to a field [mm]."""
    words = {0.1: "0.1 mm", 1.0: "1 mm", 10.0: "10 mm", 1000.0: "1 m", 100_000.0: "100 m"}
    ticks = [[value, word] for value, word in words.items()]
    return {"label": "", "low": 0.1, "high": 200_000.0, "log": True, "ticks": ticks}
