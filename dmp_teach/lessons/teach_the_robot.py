"""Lesson 09: who teaches learns. The robot is the pupil; it learns, asks, forgets."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.ink import recording_of
from dmp_teach.lessons import teaching_pictures as pictures
from dmp_teach.lessons.drawing import mark, paths_of
from dmp_teach.lessons.teaching_pictures import TURNS, draw_distances, draw_pupil
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Array

# Whom the bet is on, and who is taught first.
FIRST_PUPIL: kit.Answer = {"pupil": "Mia", "pace": 60, "forgetting": 50}
MIXED_LETTERS = "bdpq"
# What part of the first distance the line may be away from the dots.
RECORD_LIMIT = 0.05
STEP = 5


class TeachTheRobot(kit.TeachingLesson):
    """A pupil is known by how its letter comes nearer, and by what it forgets."""

    key = "09"
    first = FIRST_PUPIL
    question = marked("Can you teach a robot that forgets?")
    bet_question = marked(
        "This is how {first[pupil]} the robot writes {letter}. It is shown the letter six times. "
        "The mirror image turns round at once; of the rest {first[pace]} % is gone each time. But "
        "it forgets. Draw how far off it is each time it comes back."
    )
    challenge = marked(
        "Another teacher showed a robot the {letter} six times and answered no question. The dots "
        "are the record. Which pupil was it, how fast did it learn, how much did it forget? Bring "
        "your line within {limit:g} mm of the dots."
    )
    hints = (
        marked(
            "Look at the dots on the sheet, the first letter of the record. Which pupil writes "
            "like that?"
        ),
        marked(
            "The first step down tells the pace: what part of the first distance is gone? The step "
            "up after turn {turn} tells how much was forgotten."
        ),
        marked(
            "Try {solution[pupil]}: it learns {solution[pace]} %, and forgets "
            "{solution[forgetting]} %."
        ),
    )
    praise = marked(
        "It was {solution[pupil]}. Each time {solution[pace]} % of the difference went. After turn "
        "{turn} it lost {solution[forgetting]} % of what it knew, and the next time half as much: "
        "what is taught twice stays.{near}"
    )

    def vary(self) -> None:
        self.letter, self.seed, found = "b", 3, ("Leo", 45, 60)
        if self.random is not None:
            self.letter, self.seed = self.choose(MIXED_LETTERS), int(self.random.integers(1000))
            pace, forgetting = (STEP * int(self.random.integers(6, 15)) for _half in range(2))
            others = [name for name in kit.known_pupils() if name != FIRST_PUPIL["pupil"]]
            found = self.choose(others), pace, forgetting
        self.start = dict(FIRST_PUPIL)
        self.solution = dict(zip(FIRST_PUPIL, found, strict=True))
        self.record = self._forecast(self.solution)
        self.limit = math.ceil(10 * RECORD_LIMIT * self.record[0]) / 10
        # After which turn something is forgotten for the first time.
        traits = self.traits_of(self.solution)
        self.turn = next(turn for turn in range(1, TURNS) if traits.forgets_after(turn))

    def traits_of(self, values: kit.Answer) -> kit.PupilTraits:
        """Return the pupil that is set, which forgets when all pupils of this lesson do."""
        traits = self.pupil_named(values["pupil"])
        shares = {name: round(values[name]) / 100 for name in ("pace", "forgetting")}
        return replace(traits, **shares, seed=self.seed)

    def _forecast(self, values: kit.Answer) -> Array:
        """Return how far off the pupil that is set is as it comes to each turn [mm]."""
        found = kit.forecast(self.traits_of(values), self.letter, TURNS)
        return np.array([1000 * far for _memory, far in found])

    def _first(self, values: kit.Answer) -> kit.RobotPupil:
        """Return the pupil that is set, before it has learned anything."""
        if values["pupil"] == self.echo.name:
            return kit.RobotPupil.load(self.echo, self.letter)
        return pictures.meet_pupil(values["pupil"], self.letter)

    @property
    def knobs(self) -> kit.Knobs:
        names = {name: name for name in kit.known_pupils()}
        names[self.echo.name] = self.echo.name if self.has_guest else _("like you")
        pace, forgetting = kit.HABITS["pace"], kit.HABITS["forgetting"]
        return {
            "pupil": kit.OneOf(_("Pupil"), names),
            "pace": kit.Slider(_("Learns in one turn"), _("pace"), *pace, STEP, "%"),
            "forgetting": kit.Slider(_("Forgets on a bad day"), "", *forgetting, STEP, "%"),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        first, turns = self._forecast(FIRST_PUPIL)[0], range(1, TURNS + 1)
        handles = np.array([[turn, 0.7 * first] for turn in turns])
        label, ends = _("how far off, after turn {n}"), (0.0, pictures.MOST_FAR)
        return kit.DrawnBet(self.bet_question, "far", handles, label, "y", 0.5, "mm", *ends)

    @property
    def tasks(self) -> Sequence[str]:
        show = marked("Write a good {letter} on the sheet and press “Show it”. Does its line move?")
        if not self.takes_ink:
            show = marked(
                "Writing needs a notebook: open the lesson there to show the robot a {letter}."
            )
        return (
            show,
            marked("It asks you something. Answer: then it will forget less."),
            marked("Show it again and again. One day it has forgotten: teach it once more."),
        )

    def done(self, v: kit.Answer) -> Sequence[bool]:
        session = self.session
        if session is None or session.is_doubted:
            return False, False, False
        is_answered = any(each.answer is not None for each in session.turns)
        return bool(session.turns), is_answered, session.is_taught_again

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        apart = float(np.sqrt(np.mean((self._forecast(answer) - self.record) ** 2)))
        return [kit.at_most(_("your line to the dots"), apart, self.limit, "mm")]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        mine, record = self._forecast(answer), self.record
        near = _(" You said {pace:g} % and {forgetting:g} %, which is near enough.")
        facts = answer | {"near": near.format(**answer) if answer != self.solution else ""}
        facts |= {"mine": self._first(answer).score().sentence}
        facts |= {"theirs": self._first(self.solution).score().sentence}
        for name, turn in (("first", 0), ("one", 1), ("then", self.turn)):
            facts |= {
                name: kit.tell_number(mine[turn]),
                f"{name}_was": kit.tell_number(record[turn]),
            }
        return facts

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        apart, is_met = self._forecast(answer) - self.record, self.conditions(answer)[0].is_met
        if answer["pupil"] != self.solution["pupil"]:
            yield _(
                "{pupil} begins {first} mm off, the record {first_was} mm. {pupil}’s {letter}: "
                "{mine} The one in the record: {theirs}"
            )
        elif not is_met and apart[1] < -self.limit / 2:
            yield _(
                "At {pace} % a turn {pupil} is {one} mm off after one turn, the record still "
                "{one_was} mm: it learned more slowly."
            )
        elif not is_met and apart[1] > self.limit / 2:
            yield _(
                "At {pace} % a turn {pupil} is still {one} mm off after one turn, the record only "
                "{one_was} mm: it learned faster."
            )
        elif not is_met and apart[self.turn] > 0:
            yield _(
                "{pupil} forgets {forgetting} % and is {then} mm off after turn {turn}, the record "
                "only {then_was} mm: it forgot less."
            )
        elif not is_met:
            yield _(
                "{pupil} forgets {forgetting} % and is {then} mm off after turn {turn}, the record "
                "{then_was} mm: it forgot more."
            )

    def tell_bet(self, bet: kit.KeptBet) -> str:
        truth = self._forecast(FIRST_PUPIL)
        off = float(np.mean(np.abs(np.array(bet)[:, 1] - truth[1:])))
        words = marked(
            "Your bet on {pupil}: after one turn it was {one} mm off, for the mirror image had "
            "turned round at once. After turn {turn} it had forgotten {forgetting} % and came back "
            "{then} mm off, mirrored again. Each forgetting after that takes half as much. Your "
            "line is {off} mm away, on average."
        )
        told = {"one": truth[1], "then": truth[self.turn], "off": off}
        told = {name: kit.tell_number(value) for name, value in told.items()}
        return self.tell(words, **told, **FIRST_PUPIL)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        if state.step == "try":
            return self._draw_session(state.values)
        values = FIRST_PUPIL if state.step == "bet" else state.values
        pupil, line = self._first(values), self._forecast(values)
        lines = [pictures.distance_line(line, "robot")]
        if state.step == "bet":
            shown, caption = recording_of(self.letter).strokes(), _("As it writes")
            note, told = _("dots: the book’s; line: {pupil}’s"), _("as it comes to each turn")
            dots, lines = [mark([0, line[0]], "robot")], lines[: state.is_revealed]
        else:
            shown, caption = self._first(self.solution).strokes, _("The first letter")
            note, told = (
                _("dots: the record’s; line: {pupil}’s"),
                _("dots: the record; line: yours"),
            )
            dots = [mark([turn, far], "truth") for turn, far in enumerate(self.record)]
        sheet = draw_pupil(pupil, paths_of(shown), caption, note.format(**values))
        plot = draw_distances(lines, dots, told, hides_bet=state.step != "bet")
        says = pictures.say_of_pupil(line[0], pupil)
        return kit.Picture(says, sheet, {"far": plot}, pupil.written.write())

    def _draw_session(self, values: kit.Answer) -> kit.Picture:
        """Draw the pupil as it is now, what is on the sheet, and how far off it was each turn."""
        session = self.session_with(values)
        pupil, now = session.met[-1], 1000 * np.array(session.far)
        dots = [mark([turn, each], "robot") for turn, each in enumerate(now)]
        lines = [pictures.distance_line(self._forecast(values), "child")]
        lines += [pictures.distance_line(now, "robot")] if len(now) > 1 else []
        note = _("dots: yours; line: {pupil}’s").format(pupil=session.traits.name)
        caption = _("Write here") if self.takes_ink else _("Writing needs a notebook")
        # What was shown stays until somebody writes again.
        sheet = draw_pupil(pupil, paths_of(self.ink or session.placed), caption, note)
        told = _("solid: as you taught it; dotted: by the book")
        plot = draw_distances(lines, dots, told, values["pupil"] != FIRST_PUPIL["pupil"])
        says = pictures.say_of_session(session)
        return kit.Picture(says, sheet, {"far": plot}, pupil.written.write())
