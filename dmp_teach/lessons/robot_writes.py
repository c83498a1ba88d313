"""Lesson 08: from paper to joints: reach, speed and force (the paper's figure 1)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.errors import ReachError
from dmp_teach.lessons.goals import CM
from dmp_teach.lessons.page_plan import (
    FIRST_AHEAD,
    FLOOR,
    LAST_AHEAD,
    MAP_STEP,
    MOST_ASIDE,
    border_of,
    compare_borders,
    draw_page,
    draw_reached,
    draw_robot,
    nearest_at_ease,
    page_ring,
    place_on_map,
)
from dmp_teach.lessons.pen_pressing import LEAST_FORCE, MOST_FORCE, SPRING_TRAVEL
from dmp_teach.lessons.writing_pictures import DEEPEST, FASTEST, draw_force, draw_joints
from dmp_teach.lessons.writing_setup import (
    MOST_BUSY,
    MOST_MISSING,
    WritingSetup,
    causes,
    kinds,
    tell_push,
    write_letter,
)
from dmp_teach.robot import USUAL_PAGES, Page, Run, known_reach
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

_LETTERS, _SIDES, _LEAST_ASIDE, _LEAST_SPEEDS = "aDeSM", (-1, 1), (20, 30, 40, 50), (35, 40, 45)
_BET_POINTS = 9


class RobotWrites(kit.Lesson):
    """A page lies where all of it is in reach, and a spring in the pen gives way."""

    key = "08"

    def vary(self, random: np.random.Generator | None) -> None:
        """Choose the letter, where the page must be, and how fast the pen."""
        choices = _LETTERS, tuple(USUAL_PAGES), _SIDES, _LEAST_ASIDE, _LEAST_SPEEDS
        chosen = "a", "board", -1, 30, 40
        if random is not None:
            chosen = tuple(each[random.integers(len(each))] for each in choices)  # type: ignore[assignment]
        self.letter, self.where, self.side, self.aside, self.speed = chosen
        self.start = {"where": "table", "ahead": LAST_AHEAD, "right": 0, "pen": "rigid", "press": 1}
        self.start |= {"speed": 50, "physics": "off"}
        reach = known_reach(self.where)
        row, _column = place_on_map(self.side * self.aside, FIRST_AHEAD)
        effort = np.where(1000 * reach.residual[row] <= MOST_MISSING, reach.effort[row], np.inf)
        self.solution = self.start | {"where": self.where, "right": self.side * self.aside}
        self.solution |= {"ahead": FIRST_AHEAD + MAP_STEP * int(effort.argmin())}
        self.solution |= {"pen": "sprung", "press": 5, "speed": self.speed}

    @property
    def question(self) -> str:
        """The title."""
        return _("Where can the robot write?")

    @property
    def knobs(self) -> kit.Knobs:
        """What a pupil can set."""
        here = {"unit": "cm", "is_drawn_here": True}
        physics = {"off": _("off"), "ideal": _("perfect motors"), "real": _("real motors")}
        pens = {"sprung": _("with a spring"), "rigid": _("rigid")}
        ahead = kit.Slider(_("Page ahead"), "x", FIRST_AHEAD, LAST_AHEAD, MAP_STEP, **here)  # type: ignore[arg-type]
        right = kit.Slider(_("Page to the right"), "−y", -MOST_ASIDE, MOST_ASIDE, MAP_STEP, **here)  # type: ignore[arg-type]
        return {
            "where": kit.OneOf(_("The page is on a"), kinds()),
            "pen": kit.OneOf(_("Pen"), pens),
            "ahead": ahead,
            "right": right,
            "press": kit.Slider(_("Pen pressed in"), "Δz", 0, DEEPEST, 1, "mm"),
            "speed": kit.Slider(_("Speed of the pen"), "v", 10, FASTEST, 5, "cm/s"),
            "physics": kit.OneOf(_("Physics"), physics, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        """The border of reach."""
        question = _(
            "This is the robot, seen from above, and its page on a table. The page is too far "
            "away: the pen does not get to all of it. Draw the border: how far out can the middle "
            "of the page be?"
        )
        angles = np.radians(np.linspace(170, 10, _BET_POINTS))
        places = 0.5 * np.column_stack([np.cos(angles), np.sin(angles)])
        labels = [_("Place {n} of the border").format(n=n + 1) for n in range(_BET_POINTS)]
        return kit.DrawnBet(question, "sheet", places, labels, axis="xy", step=MAP_STEP * CM)

    @property
    def tasks(self) -> Sequence[kit.Task]:
        """What to try."""
        return (
            kit.Task(_("Let the robot write. It cannot: take its advice."), by_robot=True),
            kit.Task(
                _("Move the page to 100 cm ahead: table or board?"),
                lambda v: v["where"] == "board" and v["ahead"] == 100,
            ),
            kit.Task(
                _("Physics with real motors: let the robot write. Which pen breaks?"),
                lambda v: v["physics"] == "real" and v["pen"] == "rigid",
                by_robot=True,
            ),
        )

    @property
    def challenge(self) -> str:
        """What is checked."""
        words = _(
            "Put the page on a {where}, its middle at least {aside} cm to the {side}. All of it "
            "must be in reach, the pen well pressed, and no joint in a hurry at {speed} cm/s or "
            "more."
        )
        return words.format(**self._wanted)

    @property
    def _wanted(self) -> dict[str, object]:
        """Where the page is to be, and how fast the pen."""
        side = _("left") if self.side < 0 else _("right")
        where = {"where": kinds()[self.where], "aside": self.aside, "side": side}
        return where | {"speed": self.speed}

    @property
    def hints(self) -> tuple[str, str, str]:
        """Each more direct."""
        last = _(
            "The {where}, {ahead} cm ahead, {aside} cm to the {side}; the pen with a spring, "
            "pressed in {press} mm; {speed} cm/s."
        )
        solved = {name: self.solution[name] for name in ("ahead", "press")}
        return (
            _(
                "Find the blue part of the map that is not pale. Then look at the two curves: if "
                "you see the robot there, press “How it works”."
            ),
            _("In the middle of the blue, joints have time. And only a spring gives way."),
            last.format(**self._wanted, **solved),
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        """Return where the page is, whether it is reached, and what joints and pen do."""
        setup = WritingSetup(answer)
        side = _("left") if self.side < 0 else _("right")
        return [
            kit.at_least(side, self.side * setup.right, self.aside, "cm"),
            kit.between(_("force"), setup.force, LEAST_FORCE, MOST_FORCE, "N"),
            kit.holds(_("all corners in reach"), setup.is_reached),
            *([kit.at_most(_("joint"), setup.percent, MOST_BUSY, "%")] if setup.is_reached else []),
            kit.at_least(_("pen"), setup.speed, self.speed, "cm/s"),
        ]

    def mistakes(self, answer: kit.Answer) -> Sequence[tuple[bool, str]]:
        """Return what is wrong with the place, the pen or the speed."""
        setup, words = WritingSetup(answer), causes()
        is_rigid, force = setup.pen == "rigid", setup.force
        found = [
            (setup.residual > MOST_MISSING, "far"),
            (not setup.is_reached, "own way"),
            (setup.where != self.where, "where"),
            (self.side * setup.right < self.aside, "side"),
            (is_rigid and force == 0, "no ink"),
            (is_rigid, "rigid"),
            (force < LEAST_FORCE, "soft"),
            (force > MOST_FORCE and setup.press > SPRING_TRAVEL, "at its end"),
            (force > MOST_FORCE, "hard"),
            (setup.percent > MOST_BUSY, "hurry"),
            (setup.speed < self.speed, "slow"),
        ]
        is_side = _("left") if (setup.right or self.side) < 0 else _("right")
        facts = setup.facts | self._wanted | {"cm": abs(setup.right), "is_side": is_side}
        return [(is_made, words[name].format(**facts)) for is_made, name in found]

    def praise(self, answer: kit.Answer) -> str:
        """Return what was found."""
        words = _(
            "All of the page is in reach, the pen presses with {n} N, and the busiest joint needs "
            "{percent} % of its fastest turn. Let the robot write."
        )
        return words.format(**WritingSetup(answer).facts)

    def tell_bet(self, bet: kit.KeptBet) -> str:
        """Return how far the drawn border is from the true one."""
        words = _(
            "You drew the border {said:.0f} cm ahead; it is {true:.0f} cm ahead. On average your "
            "line is {off:.0f} cm from it. All four corners must be in reach, and the pen must "
            "stand upright on the paper. Nearer than 30 cm nobody looked: so the map is cut off "
            "there."
        )
        said, true, off = compare_borders(np.array(bet), border_of("table"))
        return words.format(said=said, true=true, off=off)

    def values_on(self, page: Page, values: kit.Answer) -> kit.Answer:
        """Return the place of the map that is nearest to a page that cures a fault."""
        x, y = page.X_world_page[:2, 3]
        right, ahead = nearest_at_ease(known_reach(str(values["where"])), -y, x)
        return values | {"right": right, "ahead": ahead}

    def tell_refusal(self, values: kit.Answer, error: ReachError) -> str:
        """Return what is wrong with the page, and where the robot would write."""
        setup, there = WritingSetup(values), WritingSetup(self.values_on(error.cure, values))
        cause = causes()["own way" if setup.residual <= MOST_MISSING else "far"]
        if setup.is_reached:
            cause = _("{place} on a {is_on}, the arm does not get through the whole letter.")
        advice = _("A place where it can write: {place}.")
        return f"{cause.format(**setup.facts)} {advice.format(**there.facts)}"

    def tell_run(self, run: Run) -> str:
        """Return how hard the pen was pushed, and what became of it."""
        return tell_push(run.greatest_force, run.pen)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        """Draw the page over the map of reach, and what pen and joints do."""
        setup, is_bet = WritingSetup(state.values), state.step == "bet"
        is_hidden = is_bet and not state.is_revealed
        known = [] if is_hidden else draw_reached(setup.where)
        sheet: kit.Drawing = {
            "box": FLOOR,
            "title": _("The robot and its page, seen from above."),
            "caption": _("From above"),
            "note": "" if is_hidden else _("blue: its middle can be here; pale: joints hurry"),
            "dots": [{"at": np.zeros((1, 2)), "kind": "child", "label": _("robot")}],
            "extras": [*known, *draw_robot(), *draw_page(setup.where)],
            "rings": [page_ring(is_fixed=is_bet)],
        }
        if setup.where != "table":
            sheet["bet"] = []
        plots = {"force": draw_force(setup), "joints": draw_joints(setup)}
        says = _ask(setup) if is_hidden else setup.say()
        physics = setup.physics(state.values["physics"])
        strokes = write_letter(self.letter, setup.speed)
        return kit.Picture(says, sheet, plots, strokes, setup.page, physics)

    @property
    def strokes(self) -> tuple[Trajectory, ...]:
        """What the robot writes in the challenge."""
        return write_letter(self.letter, self.speed)

    @property
    def page(self) -> Page:
        """A page that meets the challenge."""
        return WritingSetup(self.solution).page


def _ask(setup: WritingSetup) -> dict[str, str]:
    """Return what is said before the truth is seen."""
    text = _("is how far ahead the middle of this page is: too far. ")
    says = {"number": f"{setup.ahead:g}", "unit": "cm", "text": text}
    return says | {"strong": _("How far would do?"), "after": ""}
