"""Letters and pieces of them as JSON: strokes, settings and weights; no names of people.

Strokes are rows t [s], x, y [m], or as many numbers as they have; of each there is its primitive,
the fields of `DMP` and the path of its rollout.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dmp_teach.arguments import as_numbers
from dmp_teach.dmp import DMP, clock_to_forget, primitive_from_json, primitive_to_json
from dmp_teach.errors import LetterError, shown
from dmp_teach.files import array_from_json, must, pseudonyms
from dmp_teach.letters.compose.piece import Piece
from dmp_teach.trajectory import Trajectory

PIECE_NUMBER = re.compile(r"[1-9][0-9]{0,3}[a-z]?")


# Any: a Letter, whose module imports this one; and what JSON holds, here and below.
def letter_to_json(letter: Any) -> dict[str, Any]:
    """Return a `Letter`; a clock of more than an hour begins at 0."""
    begin = clock_to_forget(letter.strokes[0].t[0])
    return {
        "units": _units(letter.strokes[0].dimensions),
        "strokes": [_rows(stroke, begin) for stroke in letter.strokes],
        "primitives": [primitive_to_json(each, begin) for each in letter.primitives],
        "led_to": {str(number): goal.tolist() for number, goal in letter.led_to.items()},
        "made_of": list(letter.made_of),
    }


def letter_parts(content: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of `Letter`; any error says that this is none."""
    strokes = tuple(map(_stroke, content["strokes"]))
    if any(content["units"] != _units(stroke.dimensions) for stroke in strokes):
        raise LetterError(
            f"its units are {shown(content['units'])}, but must be those of its rows."
        )
    if not 0 < len(strokes) == len(content["primitives"]):
        raise LetterError("it must have strokes, and a primitive for each.")
    primitives = tuple(primitive_from_json(DMP, each) for each in content["primitives"])
    if any(len(a) != len(b.times) for a, b in zip(strokes, primitives, strict=True)):
        raise LetterError("each primitive must have the times of its stroke.")
    made_of = tuple(content["made_of"])
    must(all(isinstance(name, str) for name in made_of), "made_of", made_of, "names of strokes")
    return {
        "strokes": strokes,
        "primitives": primitives,
        "led_to": {int(n): np.array(goal, float) for n, goal in content["led_to"].items()},
        "made_of": made_of,
    }


def pieces_to_json(pieces: tuple[Piece, ...]) -> list[dict[str, Any]]:
    """Return pieces; those of one letter keep their clock, from 0 where it is over an hour."""
    begins: dict[tuple[str, str | None], float] = {}
    names = pseudonyms(piece.writer for piece in pieces)
    found = []
    for piece in pieces:
        letter = piece.character, piece.writer
        begin = begins.setdefault(letter, clock_to_forget(piece.shown.t[0]))
        told = {
            "primitive": primitive_to_json(piece.primitive, begin),
            "shown": _rows(piece.shown, begin),
            "character": piece.character,
            "number": piece.number,
            "writer": names[piece.writer],
            "led_to": None if piece.led_to is None else piece.led_to.tolist(),
        }
        found.append(told)
    return found


def piece_from_json(content: dict[str, Any]) -> Piece:
    """Return the piece of what `pieces_to_json` gave; any error says that it is none."""
    content["shown"] = _stroke(content["shown"])
    content["primitive"] = primitive_from_json(DMP, content["primitive"])
    if content["led_to"] is not None:
        content["led_to"] = array_from_json("led_to", content["led_to"], (2,))
    character, number, writer = (content[name] for name in ("character", "number", "writer"))
    must(isinstance(character, str) and len(character) == 1, "character", character, "one letter")
    must(bool(PIECE_NUMBER.fullmatch(number)), "number", number, "such as '1' or '1b'")
    must(pseudonyms([writer])[writer] == writer, "writer", writer, "a pseudonym, or null")
    return Piece(**content)


def _rows(stroke: Trajectory, begin: float) -> list[list[float]]:
    return np.column_stack([stroke.t - begin, stroke.position]).tolist()


def _stroke(rows: ArrayLike) -> Trajectory:
    numbers = as_numbers(rows)
    return Trajectory(numbers[:, 0], numbers[:, 1:])


def _units(dimensions: int) -> dict[str, str]:
    """Return the unit of each number in a row."""
    axes = "xyz" if dimensions <= 3 else [f"x{n}" for n in range(1, dimensions + 1)]
    return {"t": "s"} | dict.fromkeys(axes[:dimensions], "m")
