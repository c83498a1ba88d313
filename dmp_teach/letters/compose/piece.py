"""A stroke taken off its letter, to be put somewhere else: the writer's own weights, with another start and goal.

Nothing is drawn by hand here. A stroke is moved, led to other ends, turned or scaled by what its primitive allows:
DMP* is linear in its weights, its start and its goal, so twice the weights on twice the way is twice the stroke.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.dmp import DMP, check_point
from dmp_teach.errors import LetterError
from dmp_teach.letters.compose.geometry import across, crossings, cut, middle_of, nearest, row_of
from dmp_teach.trajectory import Array, Trajectory, locked, ways

PLACES = ("start", "goal", "upper", "lower", "top", "bottom", "left", "right", "middle")
ENDS = PLACES[:4]
TRANSFORMS = ("star", "similarity")


@dataclass(frozen=True, eq=False)
class Piece:
    """A stroke of a letter that was learned.

    Args:
        primitive: Its movement; the start is where the piece begins.
        shown: The demonstration it was learned from [m].
        character: Which letter it comes from, or "?".
        number: Which stroke of that letter, counted from 1; with a small letter after it where it is a part: "1b".
        writer: Whose hand, or None.
        led_to: The goal that the primitive is led to, shape (2,); None: its own [m].
    """

    primitive: DMP
    shown: Trajectory
    character: str = "?"
    number: str = "1"
    writer: str | None = None
    led_to: Array | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        """Lock the goal."""
        if self.led_to is not None:
            object.__setattr__(self, "led_to", locked(self.led_to))

    @property
    def name(self) -> str:
        """Such as "D.2": the second stroke of a D."""
        return f"{self.character}.{self.number}"

    @cached_property
    def drawn(self) -> Trajectory:
        """The stroke where it is now, on the clock of its recording."""
        return self.primitive.rollout(goal=self.led_to)

    def at(self, place: float | str) -> Array:
        """A point of the stroke, shape (2,) [m].

        Args:
            place: A part of the way along it, 0 at the start and 1 at the goal; or the ends "start", "goal", "upper",
                "lower"; or the outermost points "top", "bottom", "left", "right"; or "middle", half of the way along.

        Raises:
            LetterError: No such place.
        """
        path, place = self.drawn.position, 0.5 if place == "middle" else place
        if isinstance(place, str):
            return path[self._row(place)].copy()
        if isinstance(place, bool) or not isinstance(place, int | float) or not 0 <= place <= 1:
            raise LetterError(
                f"There is no place {place!r} on a stroke; give a part from 0 to 1, or {_list(PLACES)}."
            )
        way = ways(path)
        return np.array([np.interp(place * way[-1], way, axis) for axis in path.T])

    def height(self, part: float) -> Array:
        """The point of the stroke at a part of its height, 0 at the bottom and 1 at the top, shape (2,) [m].

        Of several the last in the order of writing: of an l with a loop the stem.

        Raises:
            LetterError: No such height.
        """
        if isinstance(part, bool) or not isinstance(part, int | float) or not 0 <= part <= 1:
            raise LetterError(
                f"There is no height {part!r} on {self.name}; give a part from 0 (bottom) to 1 (top)."
            )
        low, high = self.at("bottom")[1], self.at("top")[1]
        y = min(low + part * (high - low), high)
        return np.array([crossings(self.drawn.position, y)[-1], y])

    def moved(self, by: ArrayLike) -> Self:
        """The stroke as it is, elsewhere.

        Args:
            by: To the right and up, shape (2,) [m].
        """
        step = check_point("by", by, 2)
        own = replace(
            self.primitive, start=self.primitive.start + step, goal=self.primitive.goal + step
        )
        return replace(
            self, primitive=own, led_to=None if self.led_to is None else self.led_to + step
        )

    def led(self, **ends: ArrayLike) -> Self:
        """The stroke drawn to other ends by its primitive: the paper's way to a new letter.

        Args:
            ends: Where its "start", "goal", "upper" or "lower" end comes to lie, each shape (2,) [m]; the others stay.
                It ends there to a thousandth of a millimetre, for which the goal lies a little beside it.

        Raises:
            LetterError: No such end, or one end twice.
            SettingError: A similarity is to lead a closed stroke.
        """
        sent: dict[int, Array] = {}
        for name, where in ends.items():
            if name not in ENDS:
                raise LetterError(f"A stroke has no end {name!r}; it can be led by {_list(ENDS)}.")
            row = self._row(name)
            if row in sent:
                raise LetterError(
                    f"{' and '.join(ends)} are the same end of {self.name}; lead it once."
                )
            sent[row] = check_point(name, where, 2)
        goal = sent.get(-1, self.at("goal"))
        aimed = self.led_to if self.led_to is not None else self.primitive.goal
        piece = self._from(sent[0]) if 0 in sent else self
        for _ in range(4):
            miss = goal - piece.at("goal")
            if np.abs(miss).max() < 1e-9:
                break
            aimed = aimed + miss
            piece = replace(piece, led_to=aimed)
        return piece

    def touching(self, other: Piece, end: str = "goal", at: float | str | None = None) -> Self:
        """The stroke led so that one of its ends lies on another stroke.

        Args:
            other: The stroke that it touches.
            end: Which end: "start", "goal", "upper" or "lower".
            at: Which place of `other`, as in `at`; None: the one nearest to where that end is now.

        Raises:
            LetterError: No such end or place, or `other` is no piece.
        """
        if end not in ENDS:
            raise LetterError(f"A stroke has no end {end!r}; it can be led by {_list(ENDS)}.")
        _must_be_piece(other)
        where = nearest(other.drawn.position, self.at(end)) if at is None else other.at(at)
        return self.led(**{end: where})

    def put(self, place: float | str, where: ArrayLike) -> Self:
        """The stroke as it is, moved so that `place` (as in `at`) comes to lie at the point `where` (2,) [m]."""
        return self.moved(check_point("where", where, 2) - self.at(place))

    def slid(self, place: float | str, other: Piece) -> Self:
        """The stroke moved level, until `place` (as in `at`) lies on another stroke.

        Raises:
            LetterError: The other stroke is nowhere near that height, or it is no piece.
        """
        _must_be_piece(other)
        here = self.at(place)
        return self.moved((_across(other, here[1]) - here[0], 0))

    def meeting(self, where: ArrayLike) -> Self:
        """The stroke moved level, until it passes through the point `where`, shape (2,) [m].

        Raises:
            LetterError: The stroke is nowhere near that height.
        """
        spot = check_point("where", where, 2)
        return self.moved((spot[0] - _across(self, spot[1]), 0))

    def scaled(self, factor: float) -> Self:
        """The stroke larger or smaller, its lowest point where it was; refused beyond 0.001 to 1000 times."""
        if (
            isinstance(factor, bool)
            or not isinstance(factor, int | float)
            or not 1e-3 <= factor <= 1e3
        ):
            raise LetterError(f"factor is {factor!r}, but a stroke can be scaled by 0.001 to 1000.")
        return self._by(factor * np.eye(2)).put("bottom", self.at("bottom"))

    def turned(self, degrees: float) -> Self:
        """The stroke turned to the left round the middle of its box; refused beyond a whole turn either way."""
        if (
            isinstance(degrees, bool)
            or not isinstance(degrees, int | float)
            or not abs(degrees) <= 360
        ):
            raise LetterError(f"degrees is {degrees!r}, but a stroke can be turned by -360 to 360.")
        turn = np.exp(1j * np.radians(degrees))
        turned = self._by(np.array([[turn.real, -turn.imag], [turn.imag, turn.real]]))
        return turned.moved(middle_of(self.drawn.position) - middle_of(turned.drawn.position))

    def using(self, transform: str) -> Self:
        """The same weights, led to other ends by another transformation.

        Args:
            transform: "star" (DMP*, the paper's) or "similarity" (turned and scaled, Ginesi 2019): their weights mean
                the same, so that a stroke learned with one can be led by the other.

        Raises:
            LetterError: Another transformation, or a stroke learned with the original form.
        """
        if transform not in TRANSFORMS:
            raise LetterError(
                f"transform is {transform!r}, but strokes are led by {_list(TRANSFORMS)}."
            )
        self._must_not_be_original("led by another transformation")
        settings = replace(self.primitive.settings, transform=transform)
        return replace(self, primitive=replace(self.primitive, settings=settings))

    def backwards(self) -> Self:
        """The stroke as it is now, written from its other end, and learned again."""
        return self._learned(Trajectory(self.drawn.t, self.drawn.position[::-1]), self.number)

    def part(self, first: int, last: int) -> Self:
        """The samples `first:last` of the stroke as it was shown, learned again; itself where these are all."""
        if (first, last) == (0, len(self.shown)):
            return replace(self, led_to=None)
        shown = Trajectory(self.shown.t[first:last], self.shown.position[first:last])
        return self._learned(shown, f"{self.number}b")

    def cut(self) -> tuple[Self, ...]:
        """The stroke as it was shown, in parts, cut at its corners and learned again; itself where there is none."""
        parts = cut(self.shown)
        if len(parts) == 1:
            return (replace(self, led_to=None),)
        return tuple(
            self._learned(part, f"{self.number}{chr(97 + k)}") for k, part in enumerate(parts)
        )

    def _learned(self, shown: Trajectory, number: str) -> Self:
        """Another demonstration, learned as finely as this one."""
        own, share = self.primitive.settings, shown.duration / self.primitive.duration
        settings = replace(
            own, n_kernels=min(max(round(own.n_kernels * share), 1), len(shown) - 1), alpha=None
        )
        return type(self)(DMP.imitate(shown, settings), shown, self.character, number, self.writer)

    def follows(self, before: Piece) -> bool:
        """Whether this was written next after `before`, in the same letter by the same hand."""
        if (before.character, before.writer) != (self.character, self.writer):
            return False
        (stroke, part), (last, last_part) = _counted(self.number), _counted(before.number)
        return part == last_part + 1 if stroke == last else stroke == last + 1

    def __repr__(self) -> str:
        """In one line."""
        writer = "" if self.writer is None else f" by {self.writer}"
        return f"Piece({self.name}{writer}, {len(self.primitive.weights)} kernels)"

    def _row(self, place: str) -> int:
        """The sample of a place that has a name."""
        row = row_of(self.drawn.position, place)
        if row is None:
            raise LetterError(
                f"There is no place {place!r} on a stroke; give a part from 0 to 1, or {_list(PLACES)}."
            )
        return row

    def _from(self, start: Array) -> Self:
        """Another start, the goal where it was."""
        own, goal = self.primitive, self.led_to if self.led_to is not None else self.primitive.goal
        return replace(
            self,
            primitive=replace(own, start=start, goal=own.goal + start - own.start),
            led_to=goal,
        )

    def _by(self, matrix: Array) -> Self:
        """The stroke mapped by a matrix (2, 2), seen from its start: weights, way and velocity alike."""
        self._must_not_be_original("turned or scaled")
        own = self.primitive
        mapped = replace(
            own,
            weights=own.weights @ matrix.T,
            biases=None if own.biases is None else own.biases @ matrix.T,
            goal=own.start + matrix @ (own.goal - own.start),
            start_velocity=matrix @ own.start_velocity,
        )
        goal = None if self.led_to is None else own.start + matrix @ (self.led_to - own.start)
        return replace(self, primitive=mapped, led_to=goal)

    def _must_not_be_original(self, done: str) -> None:
        if self.primitive.settings.transform == "original":
            raise LetterError(
                f"{self.name} was learned with the original form, whose weights belong to one way from start to goal, "
                f"so it cannot be {done}; learn it with Settings.star()."
            )


def _must_be_piece(other: object) -> None:
    """Raise a LetterError for what is no stroke of a shelf."""
    if not isinstance(other, Piece):
        raise LetterError(
            f"The other stroke must be a Piece, such as shelf['D.1'], but is {other!r}."
        )


def _across(piece: Piece, height: float) -> float:
    """Where a stroke is at a height, or at its end if that is a little higher or lower [m]."""
    found = across(piece.drawn.position, height)
    if found is None:
        low, high = (1000 * piece.at(end)[1] for end in ("bottom", "top"))
        raise LetterError(
            f"{piece.name} is from {low:.0f} to {high:.0f} mm high, and nothing can be slid to it at "
            f"{1000 * height:.0f} mm: put it there first."
        )
    return found


def _counted(number: str) -> tuple[int, int]:
    """Stroke and part of it: (1, 2) for "1b", (1, 0) for "1"."""
    digits = number.rstrip("abcdefghijklmnopqrstuvwxyz")
    return int(digits), sum(ord(letter) - 96 for letter in number[len(digits) :])


def _list(names: tuple[str, ...]) -> str:
    """Names in quotation marks."""
    return ", ".join(f"{name!r}" for name in names[:-1]) + f" or {names[-1]!r}"
