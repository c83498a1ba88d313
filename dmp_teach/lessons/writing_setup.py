"""A page, a pen and a speed, and what the robot can do with them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, lru_cache

import numpy as np

from dmp_teach.classroom import Answer, Message, says, tell_number
from dmp_teach.dmp import Settings
from dmp_teach.lessons.drawing import learn_letter
from dmp_teach.lessons.goals import CM
from dmp_teach.lessons.page_plan import place_on_map
from dmp_teach.robot import (
    BREAKING_FORCE,
    FORCE_BAND,
    SWIFT_WRITING,
    USUAL_PAGES,
    Page,
    known_reach,
)
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Trajectory

# No corner may be further out of reach [mm], and of its fastest turn a joint does no more [%].
MOST_MISSING, MOST_BUSY = 0.1, 90
LEAST_FORCE, MOST_FORCE = FORCE_BAND
# A sprung pen pushes with so much more for each millimetre [N/mm]; pressed in further than its
# travel [mm] the arm pushes [N/mm]. What slides in the pen weighs so much [N].
SPRING, SPRING_TRAVEL, _AT_ITS_END, _PEN_WEIGHT = 0.1, 12.0, 6.0, 0.127
# What a rigid pen does with real motors, within a half; perfect ones push far harder [N/mm].
RIGID = 12.0
# So far `simulate` presses each pen in, on a page that lies as planned [mm].
PRESSED_AS_PLANNED = {"sprung": 4.0, "rigid": 0.5}


def weight_on(where: str) -> float:
    """Return what the pen's own weight adds on a usual page: none on a board [N]."""
    return _PEN_WEIGHT * max(float(USUAL_PAGES[where].normal[2]), 0.0)


def force_of(pen: str, press: float, where: str) -> float:
    """Return with how much a pen presses that is pressed in by so many mm on a usual page [N].

    As `simulate` gives it, within 0.05 N as long as a spring has a way to go.
    """
    if pen == "rigid":
        return RIGID * press
    further = max(press - SPRING_TRAVEL, 0.0)
    return SPRING * min(press, SPRING_TRAVEL) + _AT_ITS_END * further + weight_on(where)


def busiest_joint(effort: float, speed: float) -> float:
    """Return how much of its fastest turn the busiest joint needs on a page at a speed [cm/s].

    The effort is the page's, from a `ReachMap`: in its worst place, in the worst direction [%].
    """
    return effort * speed / SWIFT_WRITING


def kinds() -> dict[str, str]:
    """Return what a page can be on, in words."""
    return {"table": _("table"), "desk": _("slanted desk"), "board": _("board")}


@lru_cache(maxsize=32)
def write_letter(letter: str, speed: float) -> tuple[Trajectory, ...]:
    """Return a letter of our alphabet as the robot learned it, at most so fast [cm/s]."""
    strokes = learn_letter(letter, Settings.star()).write()
    ways = (np.linalg.norm(np.diff(each.position, axis=0), axis=1) for each in strokes)
    fastest = max((way / np.diff(s.t)).max() for way, s in zip(ways, strokes, strict=True))
    longer = float(fastest) / (CM * speed)
    return tuple(Trajectory(stroke.t * longer, stroke.position) for stroke in strokes)


class WritingSetup:
    """What is set in the lesson."""

    def __init__(self, values: Answer):
        self.where, self.pen = str(values["where"]), str(values["pen"])
        self.ahead, self.right = float(values["ahead"]), float(values["right"])
        self.press, self.speed = float(values["press"]), float(values["speed"])

    @cached_property
    def effort(self) -> float:
        """Of the page, inf where the arm does not write on all of it."""
        return float(known_reach(self.where).effort[place_on_map(self.right, self.ahead)])

    @cached_property
    def residual(self) -> float:
        """How far the page's worst corner is out of reach [mm]."""
        return float(1000 * known_reach(self.where).residual[place_on_map(self.right, self.ahead)])

    @property
    def is_reached(self) -> bool:
        """Whether the arm writes on all of the page."""
        return bool(np.isfinite(self.effort)) and self.residual <= MOST_MISSING

    @property
    def percent(self) -> float:
        """How much of its fastest turn the busiest joint needs [%]."""
        return busiest_joint(self.effort, self.speed)

    @property
    def force(self) -> float:
        """With how much the pen presses [N]."""
        return round(force_of(self.pen, self.press, self.where), 3)

    @property
    def page(self) -> Page:
        """The page."""
        page = USUAL_PAGES[self.where]
        wanted = CM * np.array([self.ahead, -self.right])
        return page.moved(np.append(wanted - page.X_world_page[:2, 3], 0.0)).rounded()

    def physics(self, motors: str) -> dict[str, object] | None:
        """Return what `simulate` is called with; None where physics is off."""
        if motors == "off":
            return None
        error = (self.press - PRESSED_AS_PLANNED[self.pen]) / 1000
        return {"motors": motors, "pen": self.pen, "page_height_error": error}

    @property
    def facts(self) -> Answer:
        """What sentences speak of."""
        near = LEAST_FORCE if self.force < 0.5 else MOST_FORCE
        return {
            **{"is_on": kinds()[self.where], "place": self._place, "ahead": f"{self.ahead:g}"},
            **{"press": f"{self.press:g}", "v": f"{self.speed:g}"},
            "mm": tell_number(self.residual, MOST_MISSING, int(self.residual < 10)),
            "n": tell_number(self.force, near),
            "percent": tell_number(self.percent, MOST_BUSY, 0) if self.is_reached else "",
            **{"low": LEAST_FORCE, "high": MOST_FORCE, "breaks": BREAKING_FORCE},
            **{"busy": MOST_BUSY, "travel": SPRING_TRAVEL},
        }

    @property
    def _place(self) -> str:
        """Where the middle of the page is, at the beginning of a sentence."""
        words = _("{ahead:g} cm ahead")
        if self.right > 0:
            words = _("{ahead:g} cm ahead and {cm:g} cm to the right")
        elif self.right < 0:
            words = _("{ahead:g} cm ahead and {cm:g} cm to the left")
        return words.format(ahead=self.ahead, cm=abs(self.right))

    def say(self) -> Message:
        """Return the number, and the sentence."""
        number, unit = "{percent}", _("% of its fastest turn")
        text = _("is what the busiest joint needs. All of the page is in reach. ")
        strong = _("Now look at the pen: it presses with {n} N, even if it stands still.")
        if self.residual > MOST_MISSING:
            number, unit = "{mm}", _("mm out of reach")
            text, strong = _("That is the worst corner of this page. "), _("The arm is too short.")
        elif not self.is_reached:
            number, unit = "", ""
            text = _("The pen could touch each corner of this page. ")
            strong = _("But the arm is in its own way.")
        elif self.percent > MOST_BUSY:
            strong = _("The robot will write slower.")
        elif LEAST_FORCE <= self.force <= MOST_FORCE:
            strong = _("The pen presses with {n} N, as a hand does.")
        elif self.force == 0:
            strong = _("But the pen does not touch the paper.")
        number, text, strong = (each.format(**self.facts) for each in (number, text, strong))
        return says(number, unit, text, strong)

    def tell_cause(self) -> str:
        """Return why the arm does not write on this page."""
        if self.residual > MOST_MISSING:
            return _(
                "{place} on a {is_on}, a corner of the page stays {mm} mm out of the arm’s reach."
            )
        if self.is_reached:
            return _("{place} on a {is_on}, the arm does not get through the whole letter.")
        return _(
            "{place} on a {is_on}, the pen could touch each corner, but not one after the other: "
            "the arm is in its own way."
        )

    def tell_pen(self) -> Iterator[str]:
        """Yield what is wrong with the pen."""
        if self.pen == "rigid" and self.force == 0:
            yield _("Pressed in {press} mm, a rigid pen just misses the paper: no ink.")
        if self.pen == "rigid":
            yield _(
                "A rigid pen cannot give way: pressed in {press} mm, it pushes with about {n} N. "
                "{breaks:g} N break a pen, and {high:g} N are enough."
            )
        if self.force < LEAST_FORCE:
            yield _("Pressed in {press} mm, the pen pushes with {n} N. It needs {low:g} N.")
        if self.force > MOST_FORCE and self.press > SPRING_TRAVEL:
            yield _(
                "Pressed in {press} mm, the spring is at its end, which comes at {travel:g} mm: "
                "now the arm itself pushes, with about {n} N."
            )
        if self.force > MOST_FORCE:
            yield _(
                "Pressed in {press} mm, the pen pushes with {n} N. More than {high:g} N hurt the "
                "paper."
            )


def tell_push(force: float, pen: str) -> str:
    """Return how hard a pen was pushed while it wrote [N], and what became of it."""
    words = _("The pen was pushed with up to {n} N: it stays whole.")
    if force > BREAKING_FORCE:
        words = _("The pen was pushed with up to {n} N. A real one breaks at {breaks:g} N.")
        if pen == "rigid":
            words = _(
                "The pen broke: it was pushed with up to {n} N, and {breaks:g} N are enough. Now "
                "try the pen with a spring."
            )
    return words.format(n=tell_number(force, BREAKING_FORCE, 0), breaks=BREAKING_FORCE)
