"""Align one line with another, point by point: from which end, and in which order of its pieces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import permutations, product

import numpy as np

from dmp_teach.scoring.resampling import POINTS_TO_ALIGN, resample_path
from dmp_teach.trajectory import Array, path_length
from dmp_teach.values import Value

# Another alignment than as given is taken only if it is nearer by this much [radii of the line].
CLEARLY_NEARER = 0.15
# Up to this number of pieces every order and direction is tried.
MOST_PERMUTED_PIECES = 3
# A line whose ends are nearer than this part of its length is a loop.
LOOP_GAP = 0.1


@dataclass(frozen=True, eq=False, repr=False)
class Alignment(Value):
    """Two lines, point by point.

    Args:
        points: The one line at equal arc length, shape (32, 2) [m].
        others: The point of the other line that belongs to each, shape (32, 2) [m].
        backwards: Whether one line, in one piece like the other, was drawn from the other end.
        begins: Where both are loops, how far round the other the one begins, from 0 to 1.
        loop: Whether both are loops.
    """

    points: Array = field(repr=False)
    others: Array = field(repr=False)
    backwards: bool
    begins: float
    loop: bool

    @property
    def goes_round(self) -> bool:
        """Whether a line that is backwards goes round: it begins where the other begins."""
        start = self.points[-1]
        return self.loop or bool(
            np.linalg.norm(start - self.others[0]) < np.linalg.norm(start - self.others[-1])
        )

    @property
    def lines(self) -> tuple[Array, Array]:
        """The one line and the other."""
        return self.points, self.others


def align(pieces: Sequence[Array], others: Sequence[Array]) -> Alignment:
    """Align a line in one or more pieces, each of shape (T, 2), with another.

    The side with more pieces is put in the order and the directions that fit best. Loops may
    begin anywhere.
    """
    loop = len(pieces) == len(others) == 1 and _is_loop(pieces[0]) and _is_loop(others[0])
    more, fewer = (pieces, others) if len(pieces) >= len(others) else (others, pieces)
    fixed = _resample_pieces(fewer)
    tried = [(_resample_pieces(line), flipped, 0.0) for line, flipped in _arrangements(more)]
    if loop:
        tried = [
            (np.roll(line, -shift, axis=0), flipped, shift / POINTS_TO_ALIGN)
            for line, flipped, _ in tried
            for shift in range(POINTS_TO_ALIGN)
        ]
    lines = np.stack([line for line, _, _ in tried])
    apart = np.sqrt(((_normalize(lines) - _normalize(fixed[None])) ** 2).sum(axis=2).mean(axis=1))
    best = int(np.argmin(apart))
    if apart[best] >= apart[0] - CLEARLY_NEARER and not (loop and not tried[best][1]):
        best = 0
    line, flipped, begins = tried[best]
    mine, yours = (line, fixed) if more is pieces else (fixed, line)
    return Alignment(mine, yours, flipped, begins, loop)


def _arrangements(pieces: Sequence[Array]) -> Iterator[tuple[list[Array], bool]]:
    """Yield the pieces as given, then in every order and direction; True if one is flipped."""
    if len(pieces) > MOST_PERMUTED_PIECES:
        yield list(pieces), False
        yield [piece[::-1] for piece in reversed(pieces)], False
        return
    for order in permutations(pieces):
        for flips in product((False, True), repeat=len(pieces)):
            line = [
                piece[::-1] if flip else piece for piece, flip in zip(order, flips, strict=True)
            ]
            yield line, len(pieces) == 1 and flips[0]


def _resample_pieces(pieces: Sequence[Array]) -> Array:
    """Return points at equal arc length along pieces, without the gaps between them, (32, 2)."""
    if len(pieces) == 1:
        return resample_path(pieces[0], POINTS_TO_ALIGN)[0]
    ends = np.cumsum([path_length(piece) for piece in pieces])
    last = np.round(POINTS_TO_ALIGN * ends / ends[-1]).astype(int)
    shares = np.diff(np.concatenate([[0], last]))
    found = [resample_path(path, n)[0] for path, n in zip(pieces, shares, strict=True) if n]
    return np.concatenate(found)


def _normalize(lines: Array) -> Array:
    """Return lines (L, P, 2), each centred and scaled to an rms radius of 1."""
    centred = lines - lines.mean(axis=1, keepdims=True)
    radius = np.sqrt((centred**2).sum(axis=2).mean(axis=1))[:, None, None]
    return np.divide(centred, radius, out=np.zeros_like(centred), where=radius > 0)


def _is_loop(path: Array) -> bool:
    """Return whether a path ends where it begins."""
    return bool(np.linalg.norm(path[-1] - path[0]) < LOOP_GAP * path_length(path))
