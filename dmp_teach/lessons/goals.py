"""A letter whose goal was moved, by one of the rules for it, and figures of what became of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from dmp_teach.classroom import Affine, Answer, Drawing, tell_number
from dmp_teach.dmp import DMP, Settings, Stepper
from dmp_teach.ink import DEFAULT_ALPHABET, recording_of
from dmp_teach.studies import share_of_same_way
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array, Trajectory, arc_lengths, interpolate_points

CM = 0.01
ACROSS, AWAY, UP = 12.0, 4.0, 6.0
"""How far a goal may be moved across its start, to the other side, and up or down [cm]."""
ASIDE, UPWARDS, LEAST_SHARE, MOST_MISS = 10.0, 4.0, 85.0, 1.0
"""What the challenge asks for: how far a goal is to move [cm], `share` [%], and `miss` [mm].

DMP* adds the same velocity all the way, so that the slow beginning and end of a letter lean: 89 to
97 % go the same way, and at most 79 % if the goal moves late.
"""
# All else is the same, so that they draw the same letter to its old goal.
GOAL_RULES = {
    "original": Settings.star(transform="original"),
    "printed": Settings.star(feed_goal=False),
    "star": Settings.star(),
    "similarity": Settings.star(transform="similarity"),
}


@lru_cache(maxsize=16)
def strokes_of(character: str) -> tuple[Trajectory, ...]:
    """Return the person's letter."""
    # Lessons on goals are about where these letters begin and end.
    return recording_of(character, DEFAULT_ALPHABET).strokes()


@lru_cache(maxsize=64)
def learn(character: str, rule: str) -> DMP:
    """Learn the one stroke of a letter, with one of the rules for its goal."""
    return DMP.imitate(strokes_of(character)[0], GOAL_RULES[rule])


def draw_moved(primitive: DMP, goal: Array, step: int) -> Array:
    """Return the path (T, D) [m] of a pen whose goal moves after so many steps of the spring.

    `Stepper.led` does the same, one step after the other.
    """
    before, after = Stepper.begin(primitive).plan, Stepper.begin(primitive, goal=goal).plan
    inputs = np.vstack([before.inputs[:step], after.inputs[step:]])
    velocity = (before if step else after).start_velocity
    path = before.spring.follow(inputs, velocity)
    return primitive.start + primitive.at_sample_times(path)


@lru_cache(maxsize=1024)
def responses(character: str, rule: str, moves_at: float) -> tuple[Array, Array]:
    """Return the path to the old goal (T, 2), and what 1 cm of x and y adds (2, T, 2) [m].

    A goal that moves at a moment [s] keeps the path affine in it, by every rule.
    """
    primitive = learn(character, rule)
    step = round(min(moves_at / primitive.duration, 1) * primitive.steps)
    base = draw_moved(primitive, primitive.goal, 0)
    moved = [draw_moved(primitive, primitive.goal + CM * axis, step) for axis in np.eye(2)]
    return base, np.array(moved) - base


@dataclass(frozen=True)
class MovedLetter:
    """A letter whose goal was moved.

    Args:
        character: The letter.
        values: `rule`, `moves_at` [s], `goal_x` and `goal_y` [cm].
    """

    character: str
    values: Answer

    @cached_property
    def primitive(self) -> DMP:
        """What was learned."""
        return learn(self.character, str(self.values["rule"]))

    @property
    def strokes(self) -> tuple[Trajectory, ...]:
        """The person's."""
        return strokes_of(self.character)

    @property
    def times(self) -> Array:
        """From 0, shape (T,) [s]."""
        return self.primitive.times - self.primitive.times[0]

    @cached_property
    def shift(self) -> Array:
        """How far its goal moved, to the right and up, shape (2,) [cm]."""
        return np.array([float(self.values["goal_x"]), float(self.values["goal_y"])])

    @property
    def following(self) -> Affine:
        """Its path as it follows the goal [m]."""
        moves_at = float(self.values["moves_at"])
        base, terms = responses(self.character, str(self.values["rule"]), moves_at)
        return Affine(base, {"goal_x": terms[0], "goal_y": terms[1]})

    @cached_property
    def path(self) -> Array:
        """The robot's line, shape (T, 2) [m]."""
        line = self.following
        return line.base + sum(
            by * term for by, term in zip(self.shift, line.terms.values(), strict=True)
        )

    @cached_property
    def offsets(self) -> tuple[Array, Array]:
        """From the start to the old goal and to the new one, shape (2,) each [m]."""
        old = self.primitive.goal - self.primitive.start
        return old, old + CM * self.shift

    @property
    def factors(self) -> Array:
        """(g' - y0) / (g - y0), sideways and upwards: what the original rule multiplies by."""
        old, new = self.offsets
        return new / old

    @property
    def turn(self) -> tuple[float, float]:
        """By how much a similarity turns it [degrees], and what it multiplies its size by."""
        (a, b), (c, d) = self.offsets
        quotient = complex(c, d) / complex(a, b)
        return abs(float(np.degrees(np.angle(quotient)))), abs(quotient)

    @property
    def miss(self) -> float:
        """How far from its goal the pen stops [mm]."""
        goal = self.primitive.goal + CM * self.shift
        return float(1000 * np.linalg.norm(self.path[-1] - goal))

    @property
    def hurry(self) -> float:
        """The greatest speed of the pen after its goal has moved [cm/s]."""
        t = self.times
        speed = np.linalg.norm(np.gradient(self.path, t, axis=0), axis=1)
        return float(speed[t >= min(float(self.values["moves_at"]), t[-2])].max() / CM)

    @cached_property
    def share(self) -> float:
        """How much of its line goes the way of the person's, to within 45 degrees [%]."""
        return 100 * share_of_same_way(self.path, self.strokes[0].position)

    @property
    def facts(self) -> Answer:
        """Return the letter and the numbers that sentences name, told apart from their limits."""
        fx, fy = (tell_number(each, digits=2) for each in self.factors)
        degrees, scale = self.turn
        x, y = map(abs, self.shift)
        return {
            **{"letter": self.character, "hurry": self.hurry, "cm": np.hypot(x, y)},
            **{"s": float(self.values["moves_at"]), "degrees": degrees, "scale": scale},
            **{"x": tell_number(x, ASIDE), "y": tell_number(y, UPWARDS), "fx": fx, "fy": fy},
            "share": tell_number(self.share, LEAST_SHARE, 0),
            "mm": tell_number(self.miss, MOST_MISS),
        }

    def box(self, side: int) -> list[float]:
        """Return a sheet for the letter and for its goal, which mostly goes to one side [m]."""
        # A letter reaches beyond its goal by 3 cm or so.
        room = CM * np.array([[side * (ACROSS + 3.0), UP], [-side * AWAY, -UP]])
        ends = self.primitive.goal + room
        points = np.vstack([self.strokes[0].position, ends])
        # Its top slides up by 2 cm at most.
        return [*(points.min(axis=0) - CM), *(points.max(axis=0) + 2 * CM)]

    def sideways(self, order: int) -> Affine:
        """Return how far right of its start it is [cm], order 0, or how fast, 1, over time."""
        line, t = self.following, self.times
        terms = {name: self._over(0 * t, term, 0.0, order) for name, term in line.terms.items()}
        return Affine(self._over(t, line.base, self.primitive.start[0], order), terms)

    def person_sideways(self, order: int) -> Array:
        """Return the same of the person's letter."""
        return self._over(self.times, self.strokes[0].position, self.primitive.start[0], order)

    def sideways_axis(self, order: int, side: int) -> Drawing:
        """Return the axis of a plot of it, with room at the side that the goal goes to."""
        values = self.person_sideways(order)[:, 1]
        room = np.full(2, 0.8 * np.abs(values).max()) if order else np.array([3.0, 8.0])[::side]
        low, high = float(values.min() - room[0]), float(values.max() + room[1])
        step = (5, 20)[order]
        ticks = range(step * math.ceil(low / step), math.floor(high) + 1, step)
        words = [[tick, str(tick).replace("-", "−")] for tick in ticks]
        return {"label": "", "low": low, "high": high, "ticks": words}

    def _over(self, t: Array, path: Array, zero: float, order: int) -> Array:
        """Return x of a path [cm], or its derivative, over `t`, shape (T, 2)."""
        x = (path[:, 0] - zero) / CM
        return np.column_stack([t, np.gradient(x, self.times) if order else x])


def mean_distance(drawn: Array, path: Array) -> float:
    """Return how far a drawn line is from a path on average, at equal parts of their ways [m]."""
    u = np.linspace(0, 1, 100)
    ways = [(arc_lengths(line), line) for line in (drawn, path)]
    a, b = (interpolate_points(u * way[-1], way, line) for way, line in ways)
    return float(np.linalg.norm(a - b, axis=1).mean())


def tell_rule(led: MovedLetter) -> tuple[str, str]:
    """Return what becomes of the letter, and what the rule does."""
    rule, is_late = led.values["rule"], bool(led.values["moves_at"])
    if rule == "similarity":
        does = _(" Similarity turns it by {degrees:.0f}° and makes it {scale:.1f} times as large.")
        if is_late:
            does = _(
                " From then on similarity turns it by {degrees:.0f}° and makes it {scale:.1f} "
                "times as large."
            )
        plain = _("The {letter} is as it was, but does not stand as it stood.")
    elif rule == "original":
        does = _(" The first rule multiplies by new way / old way: {fx} sideways, {fy} upwards.")
        if is_late:
            does = _(" From then on the first rule multiplies: {fx} sideways, {fy} upwards.")
        plain = _tell_factors(led)
    else:
        does = _(" DMP* keeps each push, and all slides along.")
        plain = _("The pen stops {mm} mm from its goal.")
        if is_late:
            does = _(" DMP* keeps each push. The pen stops {mm} mm from its goal.")
    return (_("What was written at {s:.1f} s stays.") if is_late else plain), does


def _tell_factors(led: MovedLetter) -> str:
    """Return what becomes of a letter that the first rule multiplies from its start on."""
    sideways, upwards = np.abs(led.factors) < 0.1
    if sideways:
        return _("The goal is straight above or below the start: the {letter} is thin.")
    if upwards:
        return _("Goal and start are level: the {letter} is pressed flat.")
    if led.factors.min() < 0:
        return _("The {letter} is mirrored.")
    if np.abs(led.factors - 1).max() < 0.1:
        return _("The {letter} is nearly as it was.")
    most = int(np.argmax(np.abs(np.log(led.factors))))
    if led.factors[most] > 1:
        words = _("The {letter} is stretched sideways."), _("The {letter} is stretched upwards.")
    else:
        words = _("The {letter} shrinks sideways."), _("The {letter} shrinks upwards.")
    return words[most]
