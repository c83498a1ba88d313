"""Lesson 08: from paper to joints: reach, speed and force (the paper's figure 1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dmp_teach import classroom as kit
from dmp_teach.errors import ReachError
from dmp_teach.lessons import page_plan as plan
from dmp_teach.lessons import writing_setup as writing
from dmp_teach.lessons.goals import CM
from dmp_teach.lessons.writing_pictures import DEEPEST, FASTEST, draw_force, draw_joints
from dmp_teach.lessons.writing_setup import WritingSetup
from dmp_teach.robot import USUAL_PAGES, Page, Run, known_reach
from dmp_teach.texts import gettext as _
from dmp_teach.texts import marked
from dmp_teach.trajectory import Trajectory

_LETTERS, _SIDES, _LEAST_ASIDE, _LEAST_SPEEDS = "aDeSM", (-1, 1), (20, 30, 40, 50), (35, 40, 45)
_BET_POINTS = 9


class RobotWrites(kit.Lesson):
    """A page lies where all of it is in reach, and a spring in the pen gives way."""

    key = "08"
    question = marked("Where can the robot write?")
    bet_question = marked(
        "This is the robot, seen from above, and its page on a table. The page is too far away: "
        "the pen does not get to all of it. Draw the border: how far out can the middle of the "
        "page be?"
    )
    tasks = (
        marked("Let the robot write. It cannot: take its advice."),
        marked("Move the page to 100 cm ahead: table or board?"),
        marked("Physics with real motors: let the robot write. Which pen breaks?"),
    )
    by_robot = (0, 2)
    challenge = marked(
        "Put the page on a {where}, its middle at least {aside} cm to the {side}. All of it must "
        "be in reach, the pen well pressed, and no joint in a hurry at {speed} cm/s or more."
    )
    hints = (
        marked(
            "Find the blue part of the map that is not pale. Then look at the two curves: if you "
            "see the robot there, press “How it works”."
        ),
        marked("In the middle of the blue, joints have time. And only a spring gives way."),
        marked(
            "The {where}, {solution[ahead]} cm ahead, {aside} cm to the {side}; the pen with a "
            "spring, pressed in 5 mm; {speed} cm/s."
        ),
    )
    praise = marked(
        "All of the page is in reach, the pen presses with {n} N, and the busiest joint needs "
        "{percent} % of its fastest turn. Let the robot write."
    )

    def vary(self) -> None:
        choices = _LETTERS, tuple(USUAL_PAGES), _SIDES, _LEAST_ASIDE, _LEAST_SPEEDS
        chosen = "a", "board", -1, 30, 40
        if self.random is not None:
            chosen = tuple(map(self.choose, choices))  # type: ignore[assignment]
        self.letter, self.kind, self.way, self.aside, self.speed = chosen
        self.start = {"where": "table", "ahead": plan.LAST_AHEAD, "right": 0, "pen": "rigid"}
        self.start |= {"press": 1, "speed": 50, "physics": "off"}
        reach = known_reach(self.kind)
        row, _column = plan.place_on_map(self.way * self.aside, plan.FIRST_AHEAD)
        is_reached = 1000 * reach.residual[row] <= writing.MOST_MISSING
        effort = np.where(is_reached, reach.effort[row], np.inf)
        ahead = plan.FIRST_AHEAD + plan.MAP_STEP * int(effort.argmin())
        self.solution = self.start | {"where": self.kind, "right": self.way * self.aside}
        self.solution |= {"ahead": ahead, "pen": "sprung", "press": 5, "speed": self.speed}
        self.where, self.side = writing.kinds()[self.kind], _side(self.way)

    @property
    def knobs(self) -> kit.Knobs:
        def place(label: str, term: str, low: float, high: float) -> kit.Slider:
            return kit.Slider(label, term, low, high, plan.MAP_STEP, "cm", is_drawn_here=True)

        physics = {"off": _("off"), "ideal": _("perfect motors"), "real": _("real motors")}
        pens = {"sprung": _("with a spring"), "rigid": _("rigid")}
        most = plan.MOST_ASIDE
        return {
            "where": kit.OneOf(_("The page is on a"), writing.kinds()),
            "pen": kit.OneOf(_("Pen"), pens),
            "ahead": place(_("Page ahead"), "x", plan.FIRST_AHEAD, plan.LAST_AHEAD),
            "right": place(_("Page to the right"), "−y", -most, most),
            "press": kit.Slider(_("Pen pressed in"), "Δz", 0, DEEPEST, 1, "mm"),
            "speed": kit.Slider(_("Speed of the pen"), "v", 10, FASTEST, 5, "cm/s"),
            "physics": kit.OneOf(_("Physics"), physics, is_view=True),
        }

    @property
    def bet(self) -> kit.DrawnBet:
        angles = np.radians(np.linspace(170, 10, _BET_POINTS))
        places = 0.5 * np.column_stack([np.cos(angles), np.sin(angles)])
        label, step = _("Place {n} of the border"), plan.MAP_STEP * CM
        return kit.DrawnBet(self.bet_question, "sheet", places, label, axis="xy", step=step)

    def done(self, v: kit.Answer) -> Sequence[bool]:
        return (
            True,
            v["where"] == "board" and v["ahead"] == 100,
            v["physics"] == "real" and v["pen"] == "rigid",
        )

    def conditions(self, answer: kit.Answer) -> Sequence[kit.Condition]:
        setup, busy = WritingSetup(answer), writing.MOST_BUSY
        return [
            kit.at_least(self.side, self.way * setup.right, self.aside, "cm"),
            kit.between(_("force"), setup.force, writing.LEAST_FORCE, writing.MOST_FORCE, "N"),
            kit.holds(_("all corners in reach"), setup.is_reached),
            *([kit.at_most(_("joint"), setup.percent, busy, "%")] if setup.is_reached else []),
            kit.at_least(_("pen"), setup.speed, self.speed, "cm/s"),
        ]

    def measure(self, answer: kit.Answer) -> kit.Answer:
        setup = WritingSetup(answer)
        return setup.facts | {"cm": abs(setup.right), "is_side": _side(setup.right or self.way)}

    def mistakes(self, answer: kit.Answer) -> Iterator[str]:
        setup = WritingSetup(answer)
        if not setup.is_reached:
            yield setup.tell_cause()
        if setup.where != self.kind:
            yield _("The page is on a {is_on}, {ahead} cm ahead. It is to be on a {where}.")
        if self.way * setup.right < self.aside:
            yield _(
                "The middle of the page is {cm:g} cm to the {is_side}. {aside} cm to the {side} "
                "are needed."
            )
        yield from setup.tell_pen()
        if setup.percent > writing.MOST_BUSY:
            yield _(
                "With {v} cm/s, somewhere on this page a joint needs {percent} % of its fastest "
                "turn. Above {busy} % the robot slows down by itself."
            )
        if setup.speed < self.speed:
            yield _("{v} cm/s is too slow: it is to be {speed} cm/s or more.")

    def tell_bet(self, bet: kit.KeptBet) -> str:
        said, true, off = plan.compare_borders(np.array(bet), plan.border_of("table"))
        return _(
            "You drew the border {said:.0f} cm ahead; it is {true:.0f} cm ahead. On average your "
            "line is {off:.0f} cm from it. All four corners must be in reach, and the pen must "
            "stand upright on the paper. Nearer than 30 cm nobody looked: so the map is cut off "
            "there."
        ).format(said=said, true=true, off=off)

    def values_on(self, page: Page, values: kit.Answer) -> kit.Answer:
        x, y = page.X_world_page[:2, 3]
        right, ahead = plan.nearest_at_ease(known_reach(str(values["where"])), -y, x)
        return values | {"right": right, "ahead": ahead}

    def tell_refusal(self, values: kit.Answer, error: ReachError) -> str:
        setup, there = WritingSetup(values), WritingSetup(self.values_on(error.cure, values))
        advice = _("A place where it can write: {place}.")
        return f"{setup.tell_cause().format(**setup.facts)} {advice.format(**there.facts)}"

    def tell_run(self, run: Run) -> str:
        return writing.tell_push(run.greatest_force, run.pen)

    def draw(self, state: kit.LessonState) -> kit.Picture:
        setup, is_hidden = WritingSetup(state.values), state.is_hidden
        known = [] if is_hidden else plan.draw_reached(setup.where)
        sheet: kit.Drawing = {
            "box": plan.FLOOR,
            "title": _("The robot and its page, seen from above."),
            "caption": _("From above"),
            "note": "" if is_hidden else _("blue: its middle can be here; pale: joints hurry"),
            "dots": [{"at": np.zeros((1, 2)), "kind": "child", "label": _("robot")}],
            "extras": [*known, *plan.draw_robot(), *plan.draw_page(setup.where)],
            "rings": [plan.page_ring(is_fixed=state.step == "bet")],
        }
        if setup.where != "table":
            sheet["bet"] = []
        says = setup.say()
        if is_hidden:
            text = _("is how far ahead the middle of this page is: too far. ")
            says = kit.says(f"{setup.ahead:g}", "cm", text, _("How far would do?"))
        plots = {"force": draw_force(setup), "joints": draw_joints(setup)}
        strokes, physics = writing.write_letter(self.letter, setup.speed), state.values["physics"]
        return kit.Picture(says, sheet, plots, strokes, setup.page, setup.physics(physics))

    @property
    def strokes(self) -> tuple[Trajectory, ...]:
        """What the robot writes in the challenge."""
        return writing.write_letter(self.letter, self.speed)

    @property
    def page(self) -> Page:
        """A page that meets the challenge."""
        return WritingSetup(self.solution).page


def _side(right: float) -> str:
    return _("left") if right < 0 else _("right")
