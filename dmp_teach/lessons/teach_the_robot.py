"""Lesson 09: who teaches learns. The robot is the pupil; it learns, asks, forgets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.ink import recording_of
from dmp_teach.lessons.drawing import paths_of
from dmp_teach.lessons.teaching_pictures import (
    MOST_FAR,
    TURNS,
    distance_dot,
    distance_line,
    draw_distances,
    draw_pupil,
    meet_pupil,
    say_of_pupil,
    say_of_session,
)
from dmp_teach.texts import gettext as _
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

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, when the pupils forget, and who is in the record."""
        self.letter, self.seed, found = "b", 3, ("Leo", 45, 60)
        if random is not None:
            self.letter = str(random.choice(list(MIXED_LETTERS)))
            self.seed = int(random.integers(1000))
            pace, forgetting = (STEP * int(random.integers(6, 15)) for _half in range(2))
            others = [name for name in kit.known_pupils() if name != FIRST_PUPIL["pupil"]]
            found = str(random.choice(others)), pace, forgetting
        self.start = dict(FIRST_PUPIL)
        self.solution = dict(zip(FIRST_PUPIL, found, strict=True))
        self.record = self._forecast(self.solution)
        self.limit = math.ceil(10 * RECORD_LIMIT * self.record[0]) / 10

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
        return meet_pupil(values["pupil"], self.letter)

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
    def knobs(self) -> kit.Knobs:
        """What a teacher can set: who the pupil is, its pace, its forgetting."""
        names = {name: name for name in kit.known_pupils()}
        names[self.echo.name] = self.echo.name if self.has_guest else _("like you")
        pupils = kit.OneOf(_("Pupil"), names)
        return {
            "pupil": pupils,
            "pace": kit.Slider(_("Learns in one turn"), _("pace"), *kit.HABITS["pace"], STEP, "%"),
            "forgetting": kit.Slider(
                _("Forgets on a bad day"), "", *kit.HABITS["forgetting"], STEP, "%"
            ),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """How far off the letter is, as often as it was shown."""
        words = _(
            "This is how {pupil} the robot writes {letter}. It is shown the letter six times. The "
            "mirror image turns round at once; of the rest {pace} % is gone each time. But it "
            "forgets. Draw how far off it is each time it comes back."
        )
        truth = self._forecast(FIRST_PUPIL)
        handles = np.array([[turn, 0.7 * truth[0]] for turn in range(1, TURNS + 1)])
        labels = [_("how far off, after turn {n}").format(n=n) for n in range(1, TURNS + 1)]
        asked = words.format(letter=self.letter, **FIRST_PUPIL)
        return kit.DrawnBet(
            asked, "far", handles, labels, step=0.5, unit="mm", low=0.0, high=MOST_FAR
        )

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try: show, answer, and show again."""
        session = None if self.session and self.session.is_doubted else self.session
        turns = session.turns if session else ()
        show = _("Write a good {letter} on the sheet and press “Show it”. Does its line move?")
        if not self.takes_ink:
            show = _(
                "Writing needs a notebook: open the lesson there to show the robot a {letter}."
            )
        return (
            kit.Task(show.format(letter=self.letter), lambda _v: bool(turns)),
            kit.Task(
                _("It asks you something. Answer: then it will forget less."),
                lambda _v: any(each.answer is not None for each in turns),
            ),
            kit.Task(
                _("Show it again and again. One day it has forgotten: teach it once more."),
                lambda _v: session is not None and session.is_taught_again,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "Another teacher showed a robot the {letter} six times and answered no question. The "
            "dots are the record. Which pupil was it, how fast did it learn, how much did it "
            "forget? Bring your line within {limit:g} mm of the dots."
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

    def _apart(self, answer: kit.Answer) -> Array:
        """Return how much farther off than the record the pupil that is set is, shape (7,) [mm]."""
        return self._forecast(answer) - self.record

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return how far the line is from the dots."""
        apart = float(np.sqrt(np.mean(self._apart(answer) ** 2)))
        return [kit.at_most(_("your line to the dots"), apart, self.limit, "mm")]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return whether it is another pupil, another pace, or another forgetting."""
        apart, mine = self._apart(answer), self._forecast(answer)
        missed = not all(each.is_met for each in self.conditions(answer))
        lapse = self._lapse
        facts = {"letter": self.letter, **answer, "turn": lapse}
        facts |= {"first": kit.tell_number(mine[0]), "was": kit.tell_number(self.record[0])}
        facts |= {"one": kit.tell_number(mine[1]), "one_was": kit.tell_number(self.record[1])}
        facts |= {
            "then": kit.tell_number(mine[lapse]),
            "then_was": kit.tell_number(self.record[lapse]),
        }
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

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "It was {pupil}. Each time {pace} % of the difference went. After turn {turn} it lost "
            "{forgetting} % of what it knew, and the next time half as much: what is taught twice "
            "stays."
        )
        told = words.format(turn=self._lapse, **self.solution)
        if answer == self.solution:
            return told
        near = _("You said {pace:g} % and {forgetting:g} %, which is near enough.")
        return f"{told} {near.format(**answer)}"

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return how far the drawn line is from the truth, and where it rose."""
        truth, lapse = self._forecast(FIRST_PUPIL), self._lapse
        off = float(np.mean(np.abs(np.array(bet)[:, 1] - truth[1:])))
        words = _(
            "Your bet on {pupil}: after one turn it was {one} mm off, for the mirror image had "
            "turned round at once. After turn {turn} it had forgotten {forgetting} % and came back "
            "{then} mm off, mirrored again. Each forgetting after that takes half as much. Your "
            "line is {off} mm away, on average."
        )
        facts = {"one": kit.tell_number(truth[1]), "then": kit.tell_number(truth[lapse])}
        return words.format(turn=lapse, off=kit.tell_number(off), **facts, **FIRST_PUPIL)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw its letter beside the shown one, and how far off it is turn by turn."""
        if state.step == "try":
            return self._draw_session(state.values)
        if state.step == "bet":
            return self._draw_bet(state.is_revealed)
        values, mine = state.values, self._first(state.values)
        shown = paths_of(self._first(self.solution).strokes)
        note = _("dots: the record’s; line: {pupil}’s").format(**values)
        sheet = draw_pupil(mine, shown, _("The first letter"), note)
        dots = [distance_dot(turn, far, "truth") for turn, far in enumerate(self.record)]
        line = self._forecast(values)
        note = _("dots: the record; line: yours")
        plot = draw_distances([distance_line(line, "robot")], dots, note, hides_bet=True)
        return kit.Picture(say_of_pupil(line[0], mine), sheet, {"far": plot}, mine.written.write())

    def _draw_bet(self, is_revealed: bool) -> kit.Picture:
        """Draw the first pupil's letter, and how far off it then was once that may be seen."""
        pupil, truth = self._first(FIRST_PUPIL), self._forecast(FIRST_PUPIL)
        book = paths_of(recording_of(self.letter).strokes())
        note = _("dots: the book’s; line: {pupil}’s").format(**FIRST_PUPIL)
        sheet = draw_pupil(pupil, book, _("As it writes"), note)
        lines = [distance_line(truth, "robot")] if is_revealed else []
        dots = [distance_dot(0, truth[0], "robot")]
        plot = draw_distances(lines, dots, _("as it comes to each turn"))
        return kit.Picture(
            say_of_pupil(truth[0], pupil), sheet, {"far": plot}, pupil.written.write()
        )

    def _draw_session(self, values: kit.Answer) -> kit.Picture:
        """Draw the pupil as it is now, what is on the sheet, and how far off it was each turn."""
        session = self.session_with(values)
        pupil, now = session.met[-1], 1000 * np.array(session.far)
        dots = [distance_dot(turn, each, "robot") for turn, each in enumerate(now)]
        lines = [distance_line(self._forecast(values), "child")]
        lines += [distance_line(now, "robot")] if len(now) > 1 else []
        note = _("dots: yours; line: {pupil}’s").format(pupil=session.traits.name)
        caption = _("Write here") if self.takes_ink else _("Writing needs a notebook")
        # What was shown stays until somebody writes again.
        ink = self.ink or session.placed
        sheet = draw_pupil(pupil, paths_of(ink), caption, note)
        told = _("solid: as you taught it; dotted: by the book")
        plot = draw_distances(lines, dots, told, values["pupil"] != FIRST_PUPIL["pupil"])
        return kit.Picture(say_of_session(session), sheet, {"far": plot}, pupil.written.write())
