"""A stroke taken off its letter, to be put somewhere else: the writer's own weights.

A stroke is moved, led to other ends, turned or scaled by its primitive: DMP* is linear in weights,
start and goal, so twice the weights on twice the goal offset is twice the stroke.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import checked
from dmp_teach.dmp import DMP, TRANSFORMATIONS, check_point
from dmp_teach.errors import LetterError
from dmp_teach.letters.compose.geometry import (
    box_middle,
    cut_at_corners,
    x_crossings,
    x_near_height,
)
from dmp_teach.letters.compose.places import (
    check_end,
    is_number_within,
    join_choices,
    point_at,
    sample_at,
)
from dmp_teach.letters.kernel_choice import ACCEPTED_ERROR, imitate_within
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Array, Trajectory
from dmp_teach.values import Value

PIECE_TRANSFORMS = tuple(
    name for name, each in TRANSFORMATIONS.items() if each.weights_fit_any_goal
)


@dataclass(frozen=True, eq=False, repr=False)
class Piece(Value):
    """A stroke of a letter that was learned.

    Args:
        primitive: Its movement; its start is where the piece begins.
        shown: The demonstration it was learned from [m].
        character: Which letter it comes from, or "?".
        number: Which stroke of that letter, from 1; "1b" is a part of it.
        writer: The pseudonym of the writer, or None.
        led_to: The goal of the rollout, shape (2,); None: the primitive's own [m].
    """

    primitive: DMP
    shown: Trajectory
    character: str = "?"
    number: str = "1"
    writer: str | None = None
    led_to: Array | None = field(default=None, repr=False)

    @property
    def name(self) -> str:
        """The name, such as "D.2" for the second stroke of a D."""
        return f"{self.character}.{self.number}"

    @cached_property
    def drawn(self) -> Trajectory:
        """The stroke where it is now, on the clock of its recording."""
        return self.primitive.rollout(goal=self.led_to)

    @checked
    def at(self, place: float | str) -> Array:
        """Return a point of the stroke, shape (2,) [m].

        Args:
            place: A share of the arc length, 0 to 1; or "start", "goal", "upper" or "lower" end;
                or the outermost "top", "bottom", "left" or "right"; or "middle", a share of 0.5.

        Raises:
            LetterError: No such place.
        """
        return point_at(self.drawn.position, place)

    def height(self, part: float) -> Array:
        """Return the point at a share of the stroke's height, 0 at its bottom, shape (2,) [m].

        Of several points the last in the order of writing: of an l with a loop the stem.

        Raises:
            LetterError: No such height.
        """
        if not is_number_within(part, 0, 1):
            raise LetterError(
                f"There is no height {part!r} on {self.name}; give a part from 0 (bottom) to 1 "
                "(top)."
            )
        low, high = self.at("bottom")[1], self.at("top")[1]
        y = min(low + part * (high - low), high)
        return np.array([x_crossings(self.drawn.position, y)[-1], y])

    @checked
    def moved(self, by: ArrayLike) -> Self:
        """Return the stroke translated by `by`, to the right and up, shape (2,) [m]."""
        step, own = check_point("by", by, 2), self.primitive
        goal = None if self.led_to is None else self.led_to + step
        moved = replace(own, start=own.start + step, goal=own.goal + step)
        return replace(self, primitive=moved, led_to=goal)

    def led(self, **ends: ArrayLike) -> Self:
        """Return the stroke drawn to other ends by its primitive: the paper's way to a new letter.

        Args:
            ends: Where its "start", "goal", "upper" or "lower" end comes to lie, each shape (2,)
                [m]; the others stay. The goal lies a little beside it, so that it ends there.

        Raises:
            LetterError: No such end, or one end twice.
            SettingError: A similarity is to lead a closed stroke.
        """
        sent: dict[int, Array] = {}
        for name, where in ends.items():
            check_end(name)
            row = sample_at(self.drawn.position, name)
            if row in sent:
                raise LetterError(
                    f"{' and '.join(ends)} are the same end of {self.name}; lead it once."
                )
            sent[row] = check_point(name, where, 2)
        goal = sent.get(-1, self.at("goal"))
        aimed = self._goal
        piece = self._from(sent[0]) if 0 in sent else self
        for _ in range(4):
            miss = goal - piece.at("goal")
            if np.abs(miss).max() < 1e-9:
                break
            aimed = aimed + miss
            piece = replace(piece, led_to=aimed)
        return piece

    @checked
    def put(self, place: float | str, where: ArrayLike) -> Self:
        """Return the stroke translated so that `place` (as in `at`) lies at `where` (2,) [m]."""
        return self.moved(check_point("where", where, 2) - self.at(place))

    def slid(self, place: float | str, other: Piece) -> Self:
        """Return the stroke moved sideways until `place` (as in `at`) lies on another stroke.

        Raises:
            LetterError: The other stroke is nowhere near that height, or it is no piece.
        """
        _check_piece(other)
        here = self.at(place)
        return self.moved((_x_at(other, here[1]) - here[0], 0))

    @checked
    def meeting(self, where: ArrayLike) -> Self:
        """Return the stroke moved sideways until it passes through `where`, shape (2,) [m].

        Raises:
            LetterError: The stroke is nowhere near that height.
        """
        spot = check_point("where", where, 2)
        return self.moved((spot[0] - _x_at(self, spot[1]), 0))

    def scaled(self, factor: float) -> Self:
        """Return the stroke scaled about its lowest point, 0.001 to 1000 times."""
        if not is_number_within(factor, 1e-3, 1e3):
            raise LetterError(f"factor is {factor!r}, but a stroke can be scaled by 0.001 to 1000.")
        return self._by(factor * np.eye(2)).put("bottom", self.at("bottom"))

    def turned(self, degrees: float) -> Self:
        """Return the stroke turned to the left round the middle of its box, -360 to 360 degrees."""
        if not is_number_within(degrees, -360, 360):
            raise LetterError(f"degrees is {degrees!r}, but a stroke can be turned by -360 to 360.")
        turn = np.exp(1j * np.radians(degrees))
        turned = self._by(np.array([[turn.real, -turn.imag], [turn.imag, turn.real]]))
        return turned.moved(box_middle(self.drawn.position) - box_middle(turned.drawn.position))

    @checked
    def using(self, transform: str) -> Self:
        """Return the same weights with another transformation to other ends.

        Args:
            transform: "star" (DMP*, the paper's) or "similarity" (turned and scaled, Ginesi 2019),
                whose weights mean the same.

        Raises:
            LetterError: Another transformation, or a stroke learned with the original form.
        """
        if transform not in PIECE_TRANSFORMS:
            names = join_choices(PIECE_TRANSFORMS)
            raise LetterError(f"transform is {transform!r}, but strokes are led by {names}.")
        self._refuse_original("led by another transformation")
        settings = replace(self.primitive.settings, transform=transform)
        return replace(self, primitive=replace(self.primitive, settings=settings))

    def backwards(self) -> Self:
        """Return the stroke as it is now, written from its other end and learned again."""
        return self._learn(Trajectory(self.drawn.t, self.drawn.position[::-1]), self.number)

    @checked
    def part(self, first: int, last: int) -> Self:
        """Return the samples `first:last` of the demonstration, learned again unless all."""
        if (first, last) == (0, len(self.shown)):
            return replace(self, led_to=None)
        shown = Trajectory(self.shown.t[first:last], self.shown.position[first:last])
        return self._learn(shown, f"{self.number}b")

    def cut(self) -> tuple[Self, ...]:
        """Return the demonstration cut at its corners, each part learned again."""
        parts = cut_at_corners(self.shown)
        if len(parts) == 1:
            return (replace(self, led_to=None),)
        named = zip("abcdefghijklmnopqrstuvwxyz", parts, strict=False)
        return tuple(self._learn(part, self.number + letter) for letter, part in named)

    @checked
    def follows(self, before: Piece) -> bool:
        """Return whether this was written next after `before`, in the same letter."""
        if (before.character, before.writer) != (self.character, self.writer):
            return False
        (stroke, part), (last, last_part) = _counted(self.number), _counted(before.number)
        return part == last_part + 1 if stroke == last else stroke == last + 1

    def __repr__(self) -> str:
        writer = "" if self.writer is None else f" by {self.writer}"
        return f"Piece({self.name}{writer}, {len(self.primitive.weights)} kernels)"

    @property
    def _goal(self) -> Array:
        return self.primitive.goal if self.led_to is None else self.led_to

    def _learn(self, shown: Trajectory, number: str) -> Self:
        """Learn another demonstration with as many kernels a second, or more to be as near."""
        own, share = self.primitive.settings, shown.duration / self.primitive.duration
        kernels = min(max(round(len(self.primitive.weights) * share), 1), len(shown) - 1)
        settings = replace(own, n_kernels=kernels, alpha=None)
        primitive = imitate_within(ACCEPTED_ERROR * size_of([self.drawn]), shown, settings)
        return type(self)(primitive, shown, self.character, number, self.writer)

    def _from(self, start: Array) -> Self:
        """Return the stroke with another start and the same goal."""
        own = self.primitive
        moved = replace(own, start=start, goal=own.goal + start - own.start)
        return replace(self, primitive=moved, led_to=self._goal)

    def _by(self, matrix: Array) -> Self:
        """Return the stroke mapped by a matrix (2, 2) about its start."""
        self._refuse_original("turned or scaled")
        own = self.primitive
        goal = None if self.led_to is None else own.start + matrix @ (self.led_to - own.start)
        return replace(self, primitive=own.mapped(matrix), led_to=goal)

    def _refuse_original(self, done: str) -> None:
        if not self.primitive.transformation.weights_fit_any_goal:
            raise LetterError(
                f"{self.name} was learned with the original form, whose weights belong to one way "
                f"from start to goal, so it cannot be {done}; learn it with Settings.star()."
            )


def _check_piece(other: object) -> None:
    if not isinstance(other, Piece):
        raise LetterError(
            f"The other stroke must be a Piece, such as shelf['D.1'], but is {other!r}."
        )


def _x_at(piece: Piece, height: float) -> float:
    """Return the x of a stroke at a height or near it [m]."""
    found = x_near_height(piece.drawn.position, height)
    if found is None:
        low, high = (1000 * piece.at(end)[1] for end in ("bottom", "top"))
        raise LetterError(
            f"{piece.name} is from {low:.0f} to {high:.0f} mm high, and nothing can be slid to it "
            f"at {1000 * height:.0f} mm: put it there first."
        )
    return found


def _counted(number: str) -> tuple[int, int]:
    """Return stroke and part of it: (1, 2) for "1b", (1, 0) for "1"."""
    digits = number.rstrip("abcdefghijklmnopqrstuvwxyz")
    return int(digits), sum(ord(letter) - 96 for letter in number[len(digits) :])
