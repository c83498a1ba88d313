"""Lesson 09: who teaches learns. The robot is the pupil; it learns, asks, forgets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from dmp_teach.classroom import (
    Answer,
    Condition,
    Drawing,
    DrawnBet,
    KeptBet,
    Knobs,
    LessonState,
    OneOf,
    Picture,
    PupilTraits,
    RobotPupil,
    Slider,
    Task,
    TeachingLesson,
    TeachingSession,
    at_most,
    forecast,
    known_pupils,
)
from dmp_teach.ink import recording_of
from dmp_teach.lessons.drawing import millimetres, paths_of, tell_number
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

TURNS = 6
MIXED_LETTERS = "bdpq"
# What part of the first distance the line may be away from the dots.
RECORD_LIMIT = 0.05
STEP = 5
SHEET_ROOM = 0.03


class TeachTheRobot(TeachingLesson):
    """A pupil is known by how its letter comes nearer, and by what it forgets."""

    key = "09"
    slug = "teach_the_robot"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, when the pupil forgets, and who is in the record."""
        self.letter, self.seed, found = "b", 3, ("Mia", 60, 40)
        if random is not None:
            self.letter = str(random.choice(list(MIXED_LETTERS)))
            self.seed = int(random.integers(1000))
            pace, forgetting = (STEP * int(random.integers(6, 15)) for _half in range(2))
            found = str(random.choice(known_pupils())), pace, forgetting
        self.solution = dict(zip(("pupil", "pace", "forgetting"), found, strict=True))
        names = known_pupils()
        other = names[(names.index(found[0]) + 2) % len(names)]
        self.start = {"pupil": other, "pace": 90 if found[1] < 60 else 30, "forgetting": 0}
        self.record = self._forecast(self.solution)
        self.limit = math.ceil(10 * RECORD_LIMIT * self.record[0]) / 10

    def traits_of(self, values: Answer) -> PupilTraits:
        """Return the pupil that is set, which forgets when all pupils of this lesson do."""
        traits = PupilTraits.load(values["pupil"])
        shares = {name: round(values[name]) / 100 for name in ("pace", "forgetting")}
        return replace(traits, **shares, seed=self.seed)

    def _forecast(self, values: Answer) -> Array:
        """Return how far off the pupil that is set is as it comes to each turn [mm]."""
        return self._forecast_with(self.traits_of(values))

    def _forecast_with(self, traits: PupilTraits) -> Array:
        """Return how far off a pupil is as it comes to each turn, shape (7,) [mm]."""
        return np.array([1000 * far for _memory, far in forecast(traits, self.letter, TURNS)])

    def _first(self, values: Answer) -> RobotPupil:
        """Return the pupil that is set, before it has learned anything."""
        return _load(values["pupil"], self.letter)

    @property
    def _lapse(self) -> int:
        """After which turn something is forgotten for the first time."""
        traits = self.traits_of(self.solution)
        return next(turn for turn in range(1, TURNS) if traits.forgets_after(turn))

    @property
    def question(self) -> str:
        """The title."""
        return _("Can you teach a robot that forgets?")

    @property
    def knobs(self) -> Knobs:
        """What a teacher can set: who the pupil is, its pace, its forgetting."""
        pupils = OneOf(_("Pupil"), {name: name for name in known_pupils()})
        percent = {"low": STEP, "high": 95, "step": STEP, "unit": "%"}
        forgets = percent | {"low": 0, "high": 90}
        return {
            "pupil": pupils,
            "pace": Slider(_("Learns of a difference"), _("pace"), **percent),  # type: ignore[arg-type]
            "forgetting": Slider(_("Forgets of what it knew"), "", **forgets),  # type: ignore[arg-type]
        }

    @property
    def bet(self) -> DrawnBet:
        """How far off the letter is, as often as it was shown."""
        words = _(
            "This is how {pupil} the robot writes {letter}. It is shown the letter six times, and "
            "each time {pace} % of the difference is gone. But it forgets. Draw how far off it is "
            "each time it comes back."
        )
        handles = np.array([[turn, 0.7 * self.record[0]] for turn in range(1, TURNS + 1)])
        labels = [_("how far off, after turn {n}").format(n=n) for n in range(1, TURNS + 1)]
        asked = words.format(letter=self.letter, **self.solution)
        top = self._axis_top
        return DrawnBet(asked, "far", handles, labels, step=0.5, unit="mm", low=0.0, high=top)

    @property
    def tasks(self) -> Sequence[Task]:
        """What to try: show, answer, and show again."""
        session = self.session
        turns = session.turns if session else ()
        show = _("Write a good {letter} on the sheet and press “Show it”. Does its line move?")
        return (
            Task(show.format(letter=self.letter), lambda _v: bool(turns)),
            Task(
                _("It asks you something. Answer: it then forgets only half as much."),
                lambda _v: any(each.answer is not None for each in turns),
            ),
            Task(
                _("Show it again and again. One day it has forgotten: teach it once more."),
                lambda _v: session is not None and session.is_taught_again,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "Another teacher showed a robot the {letter} six times and answered no question. The "
            "dots are the record. **Which pupil was it, how fast did it learn, how much did it "
            "forget?** Bring your line within {limit:g} mm of the dots."
        )
        return words.format(letter=self.letter, limit=self.limit)

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        return (
            _(
                "Look at the dots on the sheet, the first letter of the record. Which pupil writes "
                "like that?"
            ),
            _(
                "The first step down tells the pace: what part of the first distance is gone? The "
                "step up after turn {turn} tells how much was forgotten."
            ).format(turn=self._lapse),
            _("Try {pupil}: it learns {pace} %, and forgets {forgetting} %.").format(
                **self.solution
            ),
        )

    def _apart(self, answer: Answer) -> Array:
        """Return how much farther off than the record the pupil that is set is, shape (7,) [mm]."""
        return self._forecast(answer) - self.record

    def conditions(self, answer: Answer) -> Sequence[Condition]:
        """Return how far the line is from the dots."""
        apart = float(np.sqrt(np.mean(self._apart(answer) ** 2)))
        return [at_most(_("your line to the dots"), apart, self.limit, "mm")]

    def mistakes(self, answer: Answer) -> Sequence[tuple[bool, str]]:
        """Return whether it is another pupil, another pace, or another forgetting."""
        apart, mine = self._apart(answer), self._forecast(answer)
        missed = not all(each.is_met for each in self.conditions(answer))
        lapse = self._lapse
        facts = {"letter": self.letter, **answer, "turn": lapse}
        facts |= {"first": tell_number(mine[0]), "was": tell_number(self.record[0])}
        facts |= {"one": tell_number(mine[1]), "one_was": tell_number(self.record[1])}
        facts |= {"then": tell_number(mine[lapse]), "then_was": tell_number(self.record[lapse])}
        other = answer["pupil"] != self.solution["pupil"]
        told = {"mine": "", "theirs": ""}
        if other:
            pupils = (self._first(answer), self._first(self.solution))
            told = dict(zip(told, (pupil.score().sentence for pupil in pupils), strict=True))
        who = _(
            "{pupil} begins {first} mm off, the record {was} mm. {pupil}’s {letter}: {mine} The "
            "one in the record: {theirs}"
        )
        fast = _(
            "At {pace} % a turn {pupil} is {one} mm off after one turn, the record still "
            "{one_was} mm: it learned more slowly."
        )
        slow = _(
            "At {pace} % a turn {pupil} is still {one} mm off after one turn, the record only "
            "{one_was} mm: it learned faster."
        )
        much = _(
            "{pupil} forgets {forgetting} % and is {then} mm off after turn {turn}, the record "
            "only {then_was} mm: it forgot less."
        )
        little = _(
            "{pupil} forgets {forgetting} % and is {then} mm off after turn {turn}, the record "
            "{then_was} mm: it forgot more."
        )
        is_pace = missed and abs(apart[1]) > self.limit / 2
        found = [
            (other, who),
            (is_pace and apart[1] < 0, fast),
            (is_pace, slow),
            (missed and apart[lapse] > 0, much),
            (missed, little),
        ]
        return [(bool(is_made), words.format(**facts, **told)) for is_made, words in found]

    def praise(self, answer: Answer) -> str:
        """Return what was found."""
        words = _(
            "It was {pupil}. Each time {pace} % of the difference went. After turn {turn} it lost "
            "{forgetting} % of what it knew, and the next time half as much: what is taught twice "
            "stays."
        )
        return words.format(turn=self._lapse, **answer)

    def tell_bet(self, bet: KeptBet) -> str:
        """Return how far the drawn line is from the truth, and where it rose."""
        drawn = np.array(bet)[:, 1]
        off = float(np.mean(np.abs(drawn - self.record[1:])))
        lapse = self._lapse
        words = _(
            "After one turn it was {one} mm off. After turn {turn} it had forgotten {forgetting} % "
            "and came back {then} mm off. Each forgetting after that takes half as much. Your "
            "line is {off} mm away, on average."
        )
        facts = {"one": tell_number(self.record[1]), "then": tell_number(self.record[lapse])}
        return words.format(turn=lapse, off=tell_number(off), **facts, **self.solution)

    def draw(self, state: LessonState) -> Picture:
        """Draw its letter beside the shown one, and how far off it is turn by turn."""
        if state.step == "try":
            return self._draw_session(self.session_with(state.values))
        is_bet = state.step == "bet"
        values = self.solution if is_bet else state.values
        pupil, record = self._first(values), self._first(self.solution)
        model = recording_of(self.letter).strokes() if is_bet else record.strokes
        captions = (_("As it writes"), _("dots: as in the book"))
        if not is_bet:
            captions = (
                _("The first letter"),
                _("dots: of the record; line: of {pupil}").format(**values),
            )
        sheet = self._draw_sheet(pupil, paths_of(model), *captions)
        line = self._forecast(values)
        lines = [_line(line, "robot", "")] if not is_bet or state.is_revealed else []
        dots: list[Drawing] = [
            {"at": [turn, far], "kind": "truth", "label": ""}
            for turn, far in enumerate(self.record[: 1 if is_bet else None])
        ]
        says = self._say(line[0], pupil)
        return Picture(says, sheet, {"far": self._draw_far(lines, dots)}, pupil.written.write())

    def _draw_session(self, session: TeachingSession) -> Picture:
        """Draw the pupil as it is now, what is on the sheet, and how far off it was each turn."""
        pupil, far = session.met[-1], list(session.far)
        question = ""
        if session.asks:
            # What it forgets shows after the answer.
            pupil, far[-1] = session.shown[-1], session.learned[-1]
            question = str(pupil.question)
        now = 1000 * np.array(far)
        dots: list[Drawing] = [
            {"at": [turn, each], "kind": "robot", "label": ""} for turn, each in enumerate(now)
        ]
        traits = session.traits
        lines = [_line(self._forecast_with(traits), "child", _("by the book"))]
        lines += [_line(now, "robot", traits.name)] if len(now) > 1 else []
        note = _("dots: yours; line: {name}’s").format(name=traits.name)
        sheet = self._draw_sheet(pupil, paths_of(self.ink), _("Write here"), note)
        says = {"number": millimetres(far[-1]), "unit": _("mm off"), "text": f"{pupil.says} "}
        says |= {"strong": question, "after": ""}
        return Picture(says, sheet, {"far": self._draw_far(lines, dots)}, pupil.written.write())

    def _say(self, far: float, pupil: RobotPupil) -> dict[str, str]:
        """Return the number, and what the score says of the pupil's letter."""
        said = _("{name}’s {letter} beside the book’s: ").format(
            letter=self.letter, name=pupil.memory.traits.name
        )
        words = {"text": said, "strong": pupil.score().sentence, "after": ""}
        return {"number": millimetres(far / 1000), "unit": _("mm off"), **words}

    def _draw_sheet(
        self, pupil: RobotPupil, dots: Sequence[Array], caption: str, note: str
    ) -> Drawing:
        """Draw a sheet that has room for the largest pupil's letter."""
        points = np.concatenate(paths_of(recording_of(self.letter).strokes()))
        box = [*(points.min(axis=0) - SHEET_ROOM), *(points.max(axis=0) + SHEET_ROOM)]
        box[0], box[2] = box[0] - SHEET_ROOM, box[2] + SHEET_ROOM
        title = _("The robot’s letter as a line, and over it another one as dots.")
        return {
            "box": [float(side) for side in box],
            "title": title,
            "caption": caption,
            "note": note,
            "demo": list(dots),
            "robot": paths_of(pupil.strokes),
        }

    @property
    def _axis_top(self) -> float:
        """Where the axis of distances ends [mm]."""
        return 5.0 * math.ceil(1.15 * max(30.0, *self.record) / 5)

    def _draw_far(self, lines: Sequence[Drawing], dots: Sequence[Drawing]) -> Drawing:
        """Draw distances over turns."""
        turns = max([TURNS, *(dot["at"][0] for dot in dots)])  # type: ignore[index]
        return {
            "caption": _("How far off it is"),
            "note": _("as it comes to each turn"),
            "x": {"label": _("times it was shown"), "low": 0.0, "high": float(turns)},
            "y": {"label": "mm", "low": 0.0, "high": self._axis_top},
            "lines": list(lines),
            "dots": list(dots),
        }


# A slider asks for the first letter at every move.
@lru_cache(maxsize=64)
def _load(pupil: str, letter: str) -> RobotPupil:
    """Return a pupil before it has learned anything: its pace does not show yet."""
    return RobotPupil.load(pupil, letter)


def _line(far: Array, kind: str, label: str) -> Drawing:
    """Draw distances [mm] turn by turn."""
    points = np.column_stack([np.arange(len(far)), far]).astype(float)
    return {"points": points, "kind": kind, "label": label}
