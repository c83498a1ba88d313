"""One line laid along another, point by point: from which end, and in which order if it is in pieces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np

from dmp_teach.scoring.resampling import evenly, length
from dmp_teach.trajectory import Array, locked

POINTS = 32
SURELY = 0.15  # another way of laying is taken only if it is this much nearer [radii of the line]
PIECES = 3  # of so many pieces every order and direction is tried
CLOSED = 0.1  # a line whose ends are nearer than this part of its length is a loop


@dataclass(frozen=True, eq=False)
class Laid:
    """Two lines, point by point.

    Args:
        points: The one line at equal ways along it, shape (32, 2) [m].
        others: The point of the other that belongs to each, shape (32, 2) [m].
        backwards: Whether the one line, being in one piece like the other, was drawn from the other end.
        begins: Where both are loops, how far round the other the one begins, from 0 to 1.
        loop: Whether both are loops.
    """

    points: Array
    others: Array
    backwards: bool
    begins: float
    loop: bool

    def __post_init__(self) -> None:
        """Copy and lock."""
        object.__setattr__(self, "points", locked(self.points))
        object.__setattr__(self, "others", locked(self.others))

    @property
    def lines(self) -> tuple[Array, Array]:
        """The one line and the other."""
        return self.points, self.others


def laid(pieces: Sequence[Array], others: Sequence[Array]) -> Laid:
    """Lay a line in one or more pieces, each of shape (T, 2), along another, each centred and of one size.

    The side with more pieces is put in the order and the directions that fit best. Loops may begin anywhere.
    """
    loop = len(pieces) == len(others) == 1 and all(map(_closed, (pieces[0], others[0])))
    more, fewer = (pieces, others) if len(pieces) >= len(others) else (others, pieces)
    still = _points(fewer)
    ways_to_lie = [(_points(line), flipped, 0.0) for line, flipped in _orders(more)]
    if loop:
        ways_to_lie = [
            (np.roll(line, -shift, axis=0), flipped, shift / POINTS)
            for line, flipped, _ in ways_to_lie
            for shift in range(POINTS)
        ]
    lines = np.stack([line for line, _, _ in ways_to_lie])
    apart = np.sqrt(((_shape(lines) - _shape(still[None])) ** 2).sum(axis=2).mean(axis=1))
    best = int(np.argmin(apart))
    best = best if apart[best] < apart[0] - SURELY or (loop and not ways_to_lie[best][1]) else 0
    line, flipped, begins = ways_to_lie[best]
    mine, yours = (line, still) if more is pieces else (still, line)
    return Laid(mine, yours, flipped, begins, loop)


def _orders(pieces: Sequence[Array]) -> Iterator[tuple[list[Array], bool]]:
    """The pieces as given, then in every order and direction; and whether one piece alone is flipped."""
    if len(pieces) > PIECES:
        yield list(pieces), False
        yield [piece[::-1] for piece in reversed(pieces)], False
        return
    for order in permutations(pieces):
        for flips in product((False, True), repeat=len(pieces)):
            line = [
                piece[::-1] if flip else piece for piece, flip in zip(order, flips, strict=True)
            ]
            yield line, len(pieces) == 1 and flips[0]


def _points(pieces: Sequence[Array]) -> Array:
    """Points at equal ways along pieces, the gaps between them left out, shape (POINTS, 2)."""
    if len(pieces) == 1:
        return evenly(pieces[0], POINTS)[0]
    ends = np.cumsum([length(piece) for piece in pieces])
    shares = np.diff(np.concatenate([[0], np.round(POINTS * ends / ends[-1]).astype(int)]))
    return np.concatenate(
        [evenly(piece, share)[0] for piece, share in zip(pieces, shares, strict=True) if share]
    )


def _shape(lines: Array) -> Array:
    """Lines (L, P, 2), each centred and scaled to an rms radius of 1."""
    centred = lines - lines.mean(axis=1, keepdims=True)
    radius = np.sqrt((centred**2).sum(axis=2).mean(axis=1))[:, None, None]
    return np.divide(centred, radius, out=np.zeros_like(centred), where=radius > 0)


def _closed(path: Array) -> bool:
    """Whether a path ends where it begins."""
    return bool(np.linalg.norm(path[-1] - path[0]) < CLOSED * length(path))
