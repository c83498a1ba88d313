"""Lesson 11: a paper as printed, as coded and as fixed (its equations and both algorithms)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.lessons import paper_readings as readings
from dmp_teach.lessons.drawing import axis, draw_sheet, line, mark, millimetres, paths_of, plot
from dmp_teach.lessons.paper_readings import (
    AS_CODED,
    AS_FIXED,
    AS_PRINTED,
    FAULTY,
    MENDED,
    changed,
    error_by,
    error_left,
)
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked

MISREAD_LETTERS = "abcehmrsuSG"
MOST_CHANGES = 3
# A letter that is farther off [mm] is not on the sheet.
OFF_THE_SHEET = 50.0


class ReadingAPaper(kit.Lesson):
    """A paper that is built word for word does not work, and three of its words are to blame."""

    key = "11"
    question = marked("What if you build a paper word for word?")
    bet_question = marked(
        "Built word for word from a paper, the robot writes this {letter}. Six places are unclear "
        "or wrong. Mend five: which one, left as printed, spoils the letter most?"
    )
    tasks = (
        marked("Mend one place that brings the letter back to the sheet. Which one does?"),
        marked(
            "Take the authors’ program: all that is named program, and push and bump ends mended."
        ),
        marked("Mend all six. Then put one back that nobody would miss."),
    )
    challenge = marked(
        "Which three matter? Bring the {letter} within {limit:g} mm with at most three changes of "
        "what is printed."
    )
    hints = (
        marked("Mend first what costs most as things are. Then look again."),
        marked("One place costs metres, one a centimetre, and one about a millimetre."),
        marked("Mend {best}, and leave the rest as printed."),
    )
    praise = marked(
        "{error} off with {number} changes, where the paper as printed is {printed} off. The other "
        "{others} places save {rest} together."
    )

    def vary(self) -> None:
        self.letter = self.choose(MISREAD_LETTERS)
        best = readings.find_best(self.letter, MOST_CHANGES)
        self.start, self.solution = AS_PRINTED, readings.mend(*best)
        self.limit = math.ceil(10 * error_by(self.letter, self.solution)) / 10
        self.best = _(" and ").join(f"“{readings.names()[name]}”" for name in best)

    @property
    def knobs(self) -> kit.Knobs:
        words, notes = readings.formulas(), readings.notes()
        return {
            name: kit.OneOf(label[:1].upper() + label[1:], words[name], note=notes[name])
            for name, label in readings.names().items()
        }

    @property
    def bet(self) -> kit.ChosenBet:
        options = {name: label for name, label in readings.names().items() if name in FAULTY}
        return kit.ChosenBet(self.bet_question, options, readings.notes())

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            v["push"] == MENDED,
            v == AS_CODED,
            v["width"] == "printed" and list(v.values()).count(MENDED) == 5,
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        return [
            kit.at_most(self.letter, error_by(self.letter, answer), self.limit, "mm"),
            kit.at_most(_("changes"), len(changed(answer)), MOST_CHANGES),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        error = error_by(self.letter, answer)
        return readings.facts_of(self.letter, answer) | {
            "number": len(changed(answer)),
            "error": tell_way(error, self.limit),
            "printed": tell_way(error_by(self.letter, AS_PRINTED)),
            "others": sum(answer[name] != MENDED for name in FAULTY),
            "rest": tell_way(error - error_by(self.letter, AS_FIXED)),
        }

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        error, number = error_by(self.letter, answer), len(changed(answer))
        words = _("The {letter} is {error} off. ")
        if number >= MOST_CHANGES:
            idle, back = readings.find_idlest(self.letter, answer)
            words = _("The {letter} is {error} off, with {number} changes. ")
            least = _("“{idle}” does least: as printed {back}. ")
            least = _("“{idle}” does harm: as printed {back}. ") if back < error else least
            words += least.format(idle=readings.names()[idle], back=tell_way(back))
        if error > self.limit:
            costly = readings.find_costliest(self.letter, answer)
            words += readings.symptom_of(costly, str(answer[costly]))
        if error > self.limit or number > MOST_CHANGES:
            yield words.strip()

    def tell_bet(self, bet: kit.KeptBet) -> str:
        worst, names = max(FAULTY, key=lambda name: error_left(self.letter, name)), readings.names()
        words = marked(
            "With “{said}” left as printed the {letter} is {cost} off; with all mended {all}. "
            "Most is spoiled by “{worst}”: {most}."
        )
        if bet == worst:
            words = marked(
                "You found it: with “{said}” left as printed the {letter} is {cost} off, and with "
                "all mended {all}."
            )
        errors = {"cost": error_left(self.letter, bet), "most": error_left(self.letter, worst)}
        errors["all"] = error_by(self.letter, AS_FIXED)
        ways = {name: tell_way(error) for name, error in errors.items()}
        return self.tell(words, said=names[bet], worst=names[worst], **ways)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        letter = readings.learn_by(self.letter, state.values)
        written, error = letter.write(), error_by(self.letter, state.values)
        note = _("changes: {n}").format(n=len(changed(state.values)))
        sheet = draw_sheet(letter.strokes, paths_of(written), note=note)
        if state.step == "bet":
            plots = {"costs": self._draw_costs(state)}
        else:
            plots = {"tried": self._draw_tried(state)}
        strokes = written if error < OFF_THE_SHEET else ()
        return kit.Picture(_say(error, state.values), sheet, plots, strokes)

    def _draw_costs(self, state: kit.LessonState) -> kit.Drawing:
        """Draw a bar for each place: the error if it alone is left as printed."""
        ticks, bars = [], []
        for place, name in enumerate(reversed(FAULTY), start=1):
            ticks.append([place, readings.names()[name]])
            cost, low, high = error_left(self.letter, name), place - 0.32, place + 0.32
            points = np.array([[0.1, low], [cost, low], [cost, high], [0.1, high]])
            bars.append({"points": points, "base": low, "lit": name == state.bet})
        caption = _("One left as printed, five mended: how far off")
        y = axis(0.5, len(FAULTY) + 0.5, ticks=ticks)
        return plot(caption, _way_axis(), y, fills=bars if state.is_revealed else [])

    def _draw_tried(self, state: kit.LessonState) -> kit.Drawing:
        """Draw each set of readings that was tried: its changes, and its error."""
        tried = [state.values, *(each for each in state.tried if each.keys() == AS_PRINTED.keys())]
        now, *others = ((float(len(changed(each))), error_by(self.letter, each)) for each in tried)
        dots = [mark(each, "quiet") for each in sorted({*others} - {now})]
        whole = [[float(n), str(n)] for n in range(len(AS_PRINTED) + 1)]
        x = axis(-0.3, 7.3, _("changes"), ticks=whole)
        drawn = plot(_("How far off"), x, _way_axis(), dots=[*dots, mark(now, "robot", _("now"))])
        if state.step == "challenge":
            limit = np.array([[-0.3, self.limit], [MOST_CHANGES + 0.5, self.limit]])
            note = _("{mm:g} mm, at most {n} changes").format(mm=self.limit, n=MOST_CHANGES)
            bands = [{"from": -0.3, "to": MOST_CHANGES + 0.5}]
            drawn |= {"note": note, "lines": [line(limit, "truth")], "bands": bands}
        return drawn


def _say(error: float, values: kit.Answer) -> kit.Message:
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
    number, unit = tell_way(error).split(" ")
    off = _("{unit} off on average").format(unit=unit)
    return kit.says(number, off, whole.get(str(values), ""), strong)


def tell_way(mm: float, limit: float = math.inf) -> str:
    """Return a length [mm] as it is read: "0.23 mm", "12 mm", "47 m"."""
    if mm >= 1000:
        return f"{kit.tell_number(mm / 1000, digits=1 if mm < 9950 else 0)} m"
    return f"{millimetres(mm / 1000, limit)} mm"


def _way_axis() -> kit.Drawing:
    """Return an axis of lengths from a hair to a field [mm]."""
    words = {0.1: "0.1 mm", 1.0: "1 mm", 10.0: "10 mm", 1000.0: "1 m", 100_000.0: "100 m"}
    return axis(0.1, 200_000, log=True, ticks=[[value, word] for value, word in words.items()])
