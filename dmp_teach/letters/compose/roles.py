"""Which stroke of a letter is which: its bar, its bowl, its arms, found by shape, whoever drew them first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from dmp_teach.errors import LetterError
from dmp_teach.letters.compose.geometry import bar_and_bowl, is_upright, straightness
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.trajectory import length

STRAIGHT = 0.9
"""A stroke is a bar or an arm if its ends are as far apart as this part of its length."""

CROOKED = 0.8  # not even beside a bowl is it a bar if it is not straighter than this ...
CLEARLY = 0.1  # ... and straighter than the bowl by this
FEWEST = 4  # samples of what leads down

Pieces = tuple[Piece, ...]


def _all(strokes: Pieces) -> Pieces:
    return strokes


def _stem(strokes: Pieces) -> Pieces:
    return (max(strokes, key=_length),)


def _down(strokes: Pieces) -> Pieces:
    (stem,) = _stem(strokes)
    path = stem.shown.position
    top = int(np.argmax(path[:, 1]))
    bottom = top + int(np.argmin(path[top:, 1]))
    return (stem.part(top, bottom + 1),) if bottom - top >= FEWEST else ()


def _dot(strokes: Pieces) -> Pieces:
    return (min(strokes, key=_length),) if len(strokes) > 1 else ()


def _bar(strokes: Pieces) -> Pieces:
    return _bar_then_bowl(strokes)[:1]


def _bowl(strokes: Pieces) -> Pieces:
    return _bar_then_bowl(strokes)[1:]


def _left(strokes: Pieces) -> Pieces:
    return _sideways(strokes)[:1]


def _right(strokes: Pieces) -> Pieces:
    return _sideways(strokes)[-1:]


def _upper(strokes: Pieces) -> Pieces:
    return _bows(strokes)[-1:]


def _lower(strokes: Pieces) -> Pieces:
    return _bows(strokes)[:1]


def _top(strokes: Pieces) -> Pieces:
    return _arms(strokes)[-1:]


def _middle(strokes: Pieces) -> Pieces:
    return _arms(strokes)[-2:-1]


def _bottom(strokes: Pieces) -> Pieces:
    arms = _arms(strokes)
    return arms[:1] if len(arms) > 1 else ()


ROLES: dict[str, tuple[Callable[[Pieces], Pieces], str]] = {
    "all": (_all, "every stroke"),
    "stem": (_stem, "the longest stroke: an i without its dot"),
    "down": (
        _down,
        "what leads down from the top of the longest stroke: an l without its loop and its hook",
    ),
    "dot": (_dot, "the shortest of several strokes"),
    "bar": (_bar, "a straight stroke that leads up or down, alone or beside a bowl"),
    "bowl": (_bowl, "the bowl beside a bar"),
    "left": (_left, "the left one of parts that meet in a corner: the stem of an n"),
    "right": (_right, "the right one of parts that meet in a corner: the hump of an n"),
    "upper": (_upper, "the upper one of two bows that meet in a corner"),
    "lower": (_lower, "the lower one of two bows that meet in a corner"),
    "top": (_top, "the highest level arm"),
    "middle": (_middle, "the arm under the highest"),
    "bottom": (_bottom, "the lowest of several level arms"),
}
"""The words for strokes: how each is found, and what it means."""


def strokes_in_role(role: str, strokes: Sequence[Piece]) -> Pieces:
    """The strokes, or parts of strokes, that play a role in a letter.

    Args:
        role: One of `ROLES`.
        strokes: All strokes of one letter.

    Raises:
        LetterError: No such role, or nothing in this letter that could play it.
    """
    if role not in ROLES:
        raise LetterError(f"There is no role {role!r} for a stroke; there are {', '.join(ROLES)}.")
    find, meaning = ROLES[role]
    found = find(tuple(strokes))
    if not found:
        name, count = strokes[0].character, len(strokes)
        drawn = "in one stroke" if count == 1 else f"in {count} strokes"
        raise LetterError(
            f"This {name}, drawn {drawn}, has no {role!r}: {meaning}. It may have been drawn without a corner or lift "
            "there; take another recording of it."
        )
    return found


def _length(piece: Piece) -> float:
    return length(piece.drawn.position)


def _parts(strokes: Pieces) -> Pieces:
    """All strokes, cut at their corners."""
    return tuple(part for stroke in strokes for part in stroke.cut())


def _bar_then_bowl(strokes: Pieces) -> Pieces:
    """A bar and a bowl: two of the strokes, or of their parts where none of them is a bar; nothing where none is."""
    for among in (strokes, _parts(strokes)):
        if len(among) > 1:
            bar, bowl = (among[k] for k in bar_and_bowl([piece.drawn for piece in among]))
            path, clear = bar.drawn.position, straightness(bowl.drawn.position) + CLEARLY
            if is_upright(path) and straightness(path) > max(clear, CROOKED):
                return bar, bowl
    upright = [
        piece
        for piece in _parts(strokes)
        if _is_straight(piece) and is_upright(piece.drawn.position)
    ]
    return tuple(sorted(upright, key=_length)[-1:])


def _sideways(strokes: Pieces) -> Pieces:
    """The parts from left to right; nothing where there is only one."""
    parts = sorted(_parts(strokes), key=lambda piece: float(np.mean(piece.drawn.position[:, 0])))
    return tuple(parts) if len(parts) > 1 else ()


def _bows(strokes: Pieces) -> Pieces:
    """The parts that are not straight, from the lowest to the highest; nothing where there is only one."""
    bows = [piece for piece in _parts(strokes) if not _is_straight(piece)]
    return tuple(sorted(bows, key=_mean_height)) if len(bows) > 1 else ()


def _arms(strokes: Pieces) -> Pieces:
    """The straight parts that lie level, from the lowest to the highest."""
    arms = [
        piece
        for piece in _parts(strokes)
        if _is_straight(piece) and not is_upright(piece.drawn.position)
    ]
    return tuple(sorted(arms, key=_mean_height))


def _is_straight(piece: Piece) -> bool:
    return straightness(piece.drawn.position) > STRAIGHT


def _mean_height(piece: Piece) -> float:
    return float(np.mean(piece.drawn.position[:, 1]))
