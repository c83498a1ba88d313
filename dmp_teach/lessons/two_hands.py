"""A new letter from the strokes of two hands: drawn, blended, joined, and given to a writer."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from dmp_teach.classroom import Affine, Answer
from dmp_teach.dmp import DMP
from dmp_teach.ink import recording_of
from dmp_teach.lessons.goals import CM
from dmp_teach.letters import Letter, Style, cut_at_corners, resample_evenly
from dmp_teach.studies import ink_directions
from dmp_teach.trajectory import Array, Trajectory

# Our upright alphabet, and our slanted one.
HANDS = "round", "slanted"
# The pen is in the air for so long between strokes [s].
LIFT = 0.4
# Where strokes are joined it goes back up in that time, and the third begins before the end [s].
OVERLAPS = -LIFT, 0.15
STEM, BOWL, THIRD = range(3)
MOVED = {"goal_x": (BOWL, 0), "goal_y": (BOWL, 1), "third_x": (THIRD, 0), "third_y": (THIRD, 1)}
"""The stroke whose goal a knob moves [cm], and the axis."""


@lru_cache
def learn_hands(character: str = "D") -> Style:
    """Return a letter by both hands, learned alike and equally large."""
    letters = [recording_of(character, hand).strokes() for hand in HANDS]
    if character == "n":
        letters = [cut_at_corners(strokes[0])[-1:] for strokes in letters]
    return Style.of(letters)


@lru_cache
def arrange_strokes(third: str) -> tuple[Letter, Letter]:
    """Return the D of both hands with a third stroke from the shelf, all on one clock.

    On one clock, what is drawn is affine in the share of each hand and in every goal.
    """
    shelf = {"stem": ("D", STEM), "bowl": ("D", BOWL), "hump": ("n", 0), "ring": ("o", 0)}
    wanted = [("D", STEM), ("D", BOWL), *([shelf[third]] if third in shelf else [])]
    both: list[list[DMP]] = [[], []]
    begin = 0.0
    for character, stroke in wanted:
        pair = [letter.primitives[stroke] for letter in learn_hands(character).letters]
        duration = float(np.mean([each.duration for each in pair]))
        for own, primitive in zip(both, pair, strict=True):
            own.append(_on_clock(primitive, begin, duration))
        begin += duration + LIFT
    one, two = (Letter(tuple(p.rollout() for p in own), tuple(own)) for own in both)
    return one, two


def _on_clock(primitive: DMP, begin: float, duration: float) -> DMP:
    """Return the same stroke written in another time."""
    times = begin + np.linspace(0, duration, len(primitive.times))
    velocity = primitive.start_velocity * primitive.duration / duration
    return replace(primitive, times=times, duration=duration, start_velocity=velocity)


def _lead(letter: Letter, values: Answer) -> tuple[dict[int, Array], dict[int, Array]]:
    """Return where strokes begin and end: the third begins where the bowl ends [m].

    Its goal stays where it was in the letter that it comes from, but for what the knobs add.
    """
    goals = {n: p.goal.copy() for n, p in enumerate(letter.primitives) if n}
    starts = {}
    for name, (stroke, axis) in MOVED.items():
        if stroke in goals:
            goals[stroke][axis] += CM * values.get(name, 0)
    if THIRD in goals:
        starts[THIRD] = letter.write(goals)[BOWL].position[-1]
    return starts, goals


def _draw(letter: Letter, way: str, values: Answer) -> list[Array]:
    """Return the paths of one hand's letter, then its goals, each shape (N, 2) [m]."""
    starts, goals = _lead(letter, values)
    if way == "joined":
        strokes: tuple[Trajectory, ...] = (letter.chain(OVERLAPS, goals, starts),)
    else:
        strokes = letter.write(goals, starts)
    return [each.position for each in strokes] + [goals[n][None] for n in sorted(goals)]


@lru_cache(maxsize=32)
def follow(third: str, way: str) -> list[Affine]:
    """Return the paths of a letter, then its goals, as they follow every knob."""
    one, two = arrange_strokes(third)
    base, other = _draw(one, way, {}), _draw(two, way, {})
    moved = {name: _draw(one, way, {name: 1.0}) for name in MOVED}
    return [
        Affine(
            points,
            {name: each[n] - points for name, each in moved.items()}
            | {"share": (other[n] - points) / 100},
        )
        for n, points in enumerate(base)
    ]


def ink_difference(path: Array, other: Array) -> float:
    """Return how differently two lines are directed, on average over their ways [degrees]."""
    apart = float(np.linalg.norm(ink_directions(path) - ink_directions(other)))
    return float(np.degrees(2 * np.arcsin(min(apart / 2, 1.0))))


@dataclass(frozen=True)
class NewLetter:
    """A letter that nobody has shown, and what is measured on it.

    Args:
        values: What is set.
    """

    values: Answer

    @property
    def third(self) -> str:
        """The third stroke."""
        return str(self.values["third"])

    def paths(self, way: str = "lifted") -> list[Array]:
        """Return the paths of the strokes and then the goals, each shape (N, 2) [m]."""
        return [
            each.base + sum(self.values[name] * term for name, term in each.terms.items())
            for each in follow(self.third, way)
        ]

    @cached_property
    def lifted(self) -> list[Array]:
        """The same, the pen lifted between strokes."""
        return self.paths()

    @cached_property
    def strokes(self) -> tuple[Trajectory, ...]:
        """What the robot writes."""
        letter = arrange_strokes(self.third)[0]
        if self.values["way"] == "joined":
            starts, goals = _lead(letter, {})
            clocks = [letter.chain(OVERLAPS, goals, starts).t]
        else:
            clocks = [each.times for each in letter.primitives]
        return tuple(
            Trajectory(t, path)
            for t, path in zip(clocks, self.paths(self.values["way"]), strict=False)
        )

    @property
    def foot(self) -> Array:
        """Where the stem ends, shape (2,) [m]."""
        return self.lifted[STEM][-1]

    @property
    def lean(self) -> float:
        """How far the stem leans to the right [degrees]."""
        x, y = self.lifted[STEM][0] - self.foot
        return float(np.degrees(np.arctan2(x, y)))

    @cached_property
    def meeting(self) -> tuple[Array, float]:
        """The way from the stem to the bowl's end (2,) [m], and how far up that is, 0 to 1."""
        stem, end = resample_evenly(self.lifted[STEM], 601)[0], self.lifted[BOWL][-1]
        nearest = int(np.argmin(np.linalg.norm(stem - end, axis=1)))
        return end - stem[nearest], 1 - nearest / 600

    @property
    def gap(self) -> float:
        """How far the bowl's end is from the stem [mm]."""
        return float(1000 * np.linalg.norm(self.meeting[0]))

    @property
    def wanted_end(self) -> Array:
        """Where a third stroke ends: an R's leg under its bowl, else at the foot, (2,) [m]."""
        right = float(self.lifted[BOWL][:, 0].max())
        return np.array([right, self.foot[1]]) if self.third == "stem" else self.foot

    @property
    def third_miss(self) -> Array:
        """How far right and up of its place the third stroke ends, shape (2,) [m]."""
        return self.lifted[THIRD][-1] - self.wanted_end

    @cached_property
    def turned(self) -> Array:
        """The bowl led to the same goal by turning and scaling it, shape (N, 2) [m]."""
        style = learn_hands()
        one, two = style.writers
        bowl = style.morph(one, two, self.values["share"] / 100).primitives[BOWL]
        alike = replace(bowl, settings=replace(bowl.settings, transform="similarity"))
        goal = self.lifted[-1 if self.third == "none" else -2][0]
        return alike.rollout(goal=goal).position

    @cached_property
    def differences(self) -> dict[str, list[float]]:
        """How far the bowl is from the D's of each hand, by what led it [degrees]."""
        bowls = [letter.strokes[BOWL].position for letter in learn_hands().letters]
        made = {"DMP*": self.lifted[BOWL], "similarity": self.turned}
        return {rule: [ink_difference(path, each) for each in bowls] for rule, path in made.items()}

    @property
    def nearest(self) -> dict[str, int]:
        """Which hand is nearest, 1 or 2, by what led the bowl."""
        return {rule: 1 + int(np.argmin(apart)) for rule, apart in self.differences.items()}


def find_goals(values: Answer) -> Answer:
    """Return the same with goals that make a P of it, an R or a B."""
    made = NewLetter(values)
    middle = resample_evenly(made.lifted[STEM], 3)[0][1]
    values = values | _in_steps("goal", middle - made.lifted[BOWL][-1], 0.1)
    if made.third == "none":
        return values
    return values | _in_steps("third", -NewLetter(values).third_miss, 0.5)


def _in_steps(knob: str, way: Array, step: float) -> Answer:
    """Return a way (2,) [m] as two knobs have it, in steps [cm]."""
    x, y = (round(step * round(float(each) / step), 1) + 0.0 for each in way / CM)
    return {f"{knob}_x": x, f"{knob}_y": y}


def speed_of(strokes: tuple[Trajectory, ...]) -> Array:
    """Return the speed of the pen on paper over time, shape (N, 2) [s, cm/s]; NaN in the air."""
    parts: list[Array] = []
    for stroke in strokes:
        speed = np.linalg.norm(np.gradient(stroke.position, stroke.t, axis=0), axis=1) / CM
        parts += [np.column_stack([stroke.t, speed]), np.full((1, 2), np.nan)]
    return np.concatenate(parts[:-1])
