"""The role of a stroke in its letter, found by shape: bar, bowl, arms, whoever drew them first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from dmp_teach.errors import LetterError
from dmp_teach.letters.compose.geometry import find_bar_and_bowl, is_upright, straightness
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.trajectory import path_length

# A bar or an arm is straighter than this.
BAR_STRAIGHTNESS = 0.9
# Beside a bowl a bar is straighter than this, and straighter than the bowl by this margin.
BAR_STRAIGHTNESS_BESIDE_BOWL = 0.8
BOWL_MARGIN = 0.1
FEWEST_SAMPLES_DOWN = 4

Pieces = tuple[Piece, ...]


def _down(strokes: Pieces) -> Pieces:
    stem = max(strokes, key=_length)
    path = stem.shown.position
    top = int(np.argmax(path[:, 1]))
    bottom = top + int(np.argmin(path[top:, 1]))
    return (stem.part(top, bottom + 1),) if bottom - top >= FEWEST_SAMPLES_DOWN else ()


ROLES: dict[str, tuple[Callable[[Pieces], Pieces], str]] = {
    "all": (lambda strokes: strokes, "every stroke"),
    "stem": (
        lambda strokes: (max(strokes, key=_length),),
        "the longest stroke: an i without its dot",
    ),
    "down": (
        _down,
        "what leads down from the top of the longest stroke: an l without its loop and its hook",
    ),
    "dot": (
        lambda strokes: (min(strokes, key=_length),) if len(strokes) > 1 else (),
        "the shortest of several strokes",
    ),
    "bar": (
        lambda strokes: _bar_then_bowl(strokes)[:1],
        "a straight stroke that leads up or down, alone or beside a bowl",
    ),
    "bowl": (lambda strokes: _bar_then_bowl(strokes)[1:], "the bowl beside a bar"),
    "left": (
        lambda strokes: _sideways(strokes)[:1],
        "the left one of parts that meet in a corner: the stem of an n",
    ),
    "right": (
        lambda strokes: _sideways(strokes)[-1:],
        "the right one of parts that meet in a corner: the hump of an n",
    ),
    "upper": (
        lambda strokes: _bows(strokes)[-1:],
        "the upper one of two bows that meet in a corner",
    ),
    "lower": (
        lambda strokes: _bows(strokes)[:1],
        "the lower one of two bows that meet in a corner",
    ),
    "top": (lambda strokes: _arms(strokes)[-1:], "the highest level arm"),
    "middle": (lambda strokes: _arms(strokes)[-2:-1], "the arm under the highest"),
    "bottom": (
        lambda strokes: _arms(strokes)[:1] if len(_arms(strokes)) > 1 else (),
        "the lowest of several level arms",
    ),
}
"""The words for strokes: how each is found, and what it means."""


def strokes_in_role(role: str, strokes: Sequence[Piece]) -> Pieces:
    """Return the strokes, or parts of strokes, that play a role in a letter.

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
            f"This {name}, drawn {drawn}, has no {role!r}: {meaning}. It may have been drawn "
            "without a corner or lift there; take another recording of it."
        )
    return found


def _parts(strokes: Pieces) -> Pieces:
    """Return all strokes, cut at their corners."""
    return tuple(part for stroke in strokes for part in stroke.cut())


def _bar_then_bowl(strokes: Pieces) -> Pieces:
    """Return a bar and a bowl, of the strokes or of their parts; the bar alone; or nothing."""
    parts = _parts(strokes)
    for among in (strokes, parts):
        if len(among) > 1:
            bar, bowl = (among[k] for k in find_bar_and_bowl([piece.drawn for piece in among]))
            path, margin = bar.drawn.position, straightness(bowl.drawn.position) + BOWL_MARGIN
            if is_upright(path) and straightness(path) > max(margin, BAR_STRAIGHTNESS_BESIDE_BOWL):
                return bar, bowl
    upright = [part for part in parts if _is_straight(part) and is_upright(part.drawn.position)]
    return tuple(sorted(upright, key=_length)[-1:])


def _sideways(strokes: Pieces) -> Pieces:
    """Return the parts from left to right; nothing where there is only one."""
    parts = sorted(_parts(strokes), key=lambda piece: float(np.mean(piece.drawn.position[:, 0])))
    return tuple(parts) if len(parts) > 1 else ()


def _bows(strokes: Pieces) -> Pieces:
    """Return the parts that are not straight, the lowest first; nothing where there is one."""
    bows = [part for part in _parts(strokes) if not _is_straight(part)]
    return tuple(sorted(bows, key=_mean_height)) if len(bows) > 1 else ()


def _arms(strokes: Pieces) -> Pieces:
    """Return the straight parts that lie level, the lowest first."""
    straight = [part for part in _parts(strokes) if _is_straight(part)]
    arms = [part for part in straight if not is_upright(part.drawn.position)]
    return tuple(sorted(arms, key=_mean_height))


def _is_straight(piece: Piece) -> bool:
    return straightness(piece.drawn.position) > BAR_STRAIGHTNESS


def _length(piece: Piece) -> float:
    return path_length(piece.drawn.position)


def _mean_height(piece: Piece) -> float:
    return float(np.mean(piece.drawn.position[:, 1]))
