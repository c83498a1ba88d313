"""Five ways to learn one letter from takes of it, and what becomes of each when its goal moves."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from dmp_teach.classroom import Affine, Drawing, Message, says, tell_number
from dmp_teach.lessons.drawing import axis, lesson_letter, line, mark, plot, sheet_box
from dmp_teach.lessons.goals import CM
from dmp_teach.studies import (
    WAYS,
    GaussianWay,
    Way,
    WayTried,
    draw_takes,
    even_path,
    lead_way,
)
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, rms

WAY_KEYS = dict(zip(("dmp", "mixture", "states", "cost", "spread"), WAYS.values(), strict=True))
TAKES_AT_HAND = 8
# The fewest letters that a challenge may need, and how far from enough one fewer is.
LEAST_NEEDED, GAP = 3, 0.85
# Of places for ways beside one another.
COLUMNS = 3
# So near to the ring a pen has arrived [mm].
NEAR_RING = 1.0
# Where their goals move [cm]: a line that stays where it was must turn round to get there.
LED_LETTERS = {
    "S": (6.0, 3.0),
    "2": (-6.0, 3.0),
    "3": (6.0, 3.0),
    "6": (6.0, -3.0),
    "9": (-6.0, 3.0),
    "C": (-6.0, -3.0),
    "e": (-6.0, -3.0),
}


def ways_here() -> dict[str, type[Way]]:
    """Return the ways whose library is installed, by what a pupil sets."""
    return {key: way for key, way in WAY_KEYS.items() if way.can_learn()}


@lru_cache(maxsize=32)
def takes_of(character: str, hand: int) -> tuple[Trajectory, ...]:
    """Return takes of a letter of one stroke, as a hand writes it again and again."""
    return draw_takes(lesson_letter(character).strokes()[0], TAKES_AT_HAND, hand)


@lru_cache(maxsize=16)
def meant_by(character: str) -> Array:
    """Return the letter that takes are tries of, at equal parts of its duration [m]."""
    return even_path(lesson_letter(character).strokes()[0])


@lru_cache(maxsize=512)
def learn_in(key: str, character: str, hand: int, shown: int) -> Way:
    """Learn a letter in one way from the first takes of a hand."""
    return WAY_KEYS[key].learn(takes_of(character, hand)[:shown])


def find_hand(character: str, random: np.random.Generator) -> tuple[int, int, float]:
    """Find a hand that needs several takes until a learned cost has what it means.

    Returns:
        Whose hand; how many takes it needs; and a limit that no fewer of them meet [mm].
    """
    while True:
        hand = int(random.integers(100_000))
        paths = np.array([even_path(take) for take in takes_of(character, hand)])
        count = np.arange(1, TAKES_AT_HAND + 1)
        means = np.cumsum(paths, axis=0) / count[:, None, None]
        errors = np.array([rms(mean - meant_by(character)) for mean in means])
        best = np.minimum.accumulate(errors)
        enough = np.flatnonzero(errors[1:] < GAP * best[:-1]) + 2
        for needed in enough[(enough >= LEAST_NEEDED) & (enough < TAKES_AT_HAND)]:
            limit = math.floor(1e4 * np.sqrt(errors[needed - 1] * best[needed - 2])) / 10
            fewer = int(np.argmin(errors[: needed - 1])) + 1
            less, more = (
                Led(character, hand, "cost", shown, (0.0, 0.0)).error for shown in (fewer, needed)
            )
            if more < 0.97 * limit and less > 1.03 * limit:
                return hand, int(needed), limit


@dataclass(frozen=True)
class Led:
    """The letter of a pupil, learned in one way, with a goal that was moved.

    Args:
        character: The letter.
        hand: Whose takes.
        key: The way.
        shown: How many takes were shown.
        shift: How far the goal moved [cm].
    """

    character: str
    hand: int
    key: str
    shown: int
    shift: tuple[float, float]

    @property
    def tried(self) -> WayTried:
        """What was written, with its figures."""
        return _tried(self)

    @property
    def line(self) -> Affine | Array:
        """The robot's line; where a path follows its goal evenly, as the browser draws it [m]."""
        way = self.tried.way
        if not isinstance(way, GaussianWay) and self.key != "dmp":
            return self.tried.moved.position
        home = meant_by(self.character)[-1]
        base = way.write(home).position
        x, y = (way.write(home + CM * axis).position - base for axis in np.eye(2))
        return Affine(base, {"goal_x": x, "goal_y": y})

    @property
    def error(self) -> float:
        """How far the letter to its own goal is from what was meant [mm]."""
        return 1000 * self.tried.error

    @property
    def miss(self) -> float:
        """How far from its new goal the pen ends [mm]."""
        return 1000 * self.tried.miss

    @property
    def share(self) -> float:
        """How much of the moved letter goes the way of the one that did not move [%]."""
        return 100 * self.tried.same_way

    @property
    def facts(self) -> dict[str, object]:
        """What sentences name."""
        miss = tell_number(self.miss, NEAR_RING, 0 if self.miss > 9.5 else 1)
        return {
            **{"way": way_names()[self.key], "shown": self.shown, "share": f"{self.share:.0f}"},
            **{"miss": miss, "numbers": self.tried.way.numbers_stored},
        }


@lru_cache(maxsize=1024)
def _tried(led: Led) -> WayTried:
    """Return what a way writes, with its figures."""
    way, shift = learn_in(led.key, led.character, led.hand, led.shown), CM * np.array(led.shift)
    takes = takes_of(led.character, led.hand)[: led.shown]
    return lead_way(way, takes, meant_by(led.character), shift)


def draw_side_by_side(marked: Led) -> Drawing:
    """Draw what all ways write to the moved goal, one of them marked, beside one another [cm]."""
    letters = {key: replace(marked, key=key) for key in ways_here()}
    star = replace(marked, key="dmp", shown=1).tried
    shown = star.takes[0].position / CM
    seen = np.concatenate([shown, star.moved.position / CM])
    low, size = seen.min(axis=0) - 0.3, np.ptp(seen, axis=0) + 0.6
    # The name of the way stands below.
    below = 0.25 * size[1]
    place = np.array([max(size[0], 1.25 * size[1]), size[1] + below])
    lines: list[Drawing] = []
    dots: list[Drawing] = []
    for number, (key, led) in enumerate(letters.items()):
        corner = place * (number % COLUMNS, -(number // COLUMNS))
        home = corner - low + ((place[0] - size[0]) / 2, below)
        kind = "robot" if key == marked.key else "quiet"
        pieces = _pieces_inside(led.tried.moved.position / CM, low, low + size)
        lines += [line(shown + home, "child"), *(line(piece + home, kind) for piece in pieces)]
        at = corner + np.array([0.5 * place[0], 0.5 * below])
        dots += [mark((star.goal / CM + home).tolist(), "bet")]
        dots += [mark(at.tolist(), "word", way_names()[key])]
    high = float(place[1])
    x, y = axis(0, COLUMNS * place[0], ticks=[]), axis(-high, high, ticks=[], isEqual=True)
    note = (_("{n} shown") if marked.shown > 1 else _("one shown")).format(n=marked.shown)
    return plot(_("Each way, to the ring"), x, y, note, lines=lines, dots=dots)


def list_ways() -> Drawing:
    """Write a line of how each way that is here learns."""
    words = {
        "dmp": _("a spring and pushes"),
        "mixture": _("where to go next"),
        "states": _("a row of places"),
        "cost": _("what a hand avoids"),
        "spread": _("mean and changes"),
    }
    lines = [f"{way_names()[key]}: {words[key]}" for key in ways_here()]
    dots = [mark([0.0, -k], "word", each) for k, each in enumerate(lines, start=1)]
    x, y = axis(-1, 1, ticks=[]), axis(-len(dots) - 1, 0, ticks=[])
    return plot(_("How each way learns"), x, y, dots=dots)


def _pieces_inside(path: Array, low: Array, high: Array) -> list[Array]:
    """Return the pieces of a path (T, 2) that do not cross a neighbour's place."""
    inside = np.all((path > low) & (path < high), axis=1)
    runs = np.split(np.arange(len(path)), np.flatnonzero(np.diff(inside)) + 1)
    return [path[run] for run in runs if inside[run[0]] and len(run) > 1]


def draw_errors(letters: list[Led], limit: float) -> Drawing:
    """Draw how far letters are from what was meant, over how many were shown; the last is marked.

    Args:
        letters: In any order, by any way.
        limit: How near is near enough [mm].
    """
    lines: list[Drawing] = []
    dots: list[Drawing] = []
    for key in ways_here():
        kind = "robot" if key == letters[-1].key else "quiet"
        errors = {led.shown: led.error for led in letters if led.key == key}
        dots += [mark([shown, error], kind) for shown, error in errors.items()]
        # What was not tried breaks the line.
        points = [[n, errors.get(n, np.nan)] for n in range(1, TAKES_AT_HAND + 1)]
        lines += [line(np.array(points), kind, way_names()[key])] if errors else []
    lines.append(line(np.array([[1.0, limit], [TAKES_AT_HAND, limit]]), "child", _("limit")))
    x, caption = axis(1, TAKES_AT_HAND, _("letters shown")), _("Off, with the goal at home [mm]")
    return plot(caption, x, axis(0, 12), lines=lines, dots=dots)


def say_way(led: Led, is_home: bool = False) -> Message:
    """Return the number and the sentence of what a way has written, to the ring or to its home."""
    does = {
        "dmp": _("It learns the first letter alone, and pushes alike to any goal. "),
        "mixture": _("At each place it knows which way to go, if it was shown that place. "),
        "states": _("It goes through 16 states: each a place, a speed, and how sure. "),
        "cost": _("It pays for jerks and for missed places, and writes what costs least. "),
        "spread": _("It knows the mean letter, and how the others differed from it. "),
    }
    strong = _("It ends {miss} mm from the ring; {share} % of the letter kept its shape. ")
    after = _("{numbers} numbers stored.").format(**led.facts)
    strong = "" if is_home else strong.format(**led.facts)
    off = f"{led.error:.1f}", _("mm off, with the goal at home")
    return says(*off, does[led.key], strong, after)


def way_names() -> dict[str, str]:
    """Return the ways as a pupil reads them."""
    plain = {"mixture": _("mixture"), "states": _("states"), "cost": _("cost")}
    return {"dmp": "DMP*", **plain, "spread": _("spread")}


def box_around(led: Led, reach: float) -> list[float]:
    """Return a sheet for all takes, for DMP* and for a goal that moves so far [cm]."""
    goal = meant_by(led.character)[-1]
    corners = goal + CM * reach * np.array([[-1, -1], [1, 1]])
    moved = replace(led, key="dmp", shown=1).tried.moved.position
    takes = [take.position for take in takes_of(led.character, led.hand)]
    return sheet_box([*takes, corners, moved])
