"""What lesson 09 draws: a pupil's letter on its sheet, and how far off it was turn by turn."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from dmp_teach.classroom import (
    Drawing,
    Message,
    RobotPupil,
    TeachingSession,
    known_pupils,
    says,
)
from dmp_teach.lessons.drawing import axis, line, millimetres, paths_of, plot
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array

TURNS = 6
SHEET_ROOM = 0.015
# Where the axis of distances ends [mm].
MOST_FAR = 35.0


# A slider asks for the first letter at every move.
@lru_cache(maxsize=64)
def meet_pupil(pupil: str, letter: str) -> RobotPupil:
    """Return one of our pupils before it has learned anything: its pace does not show yet."""
    return RobotPupil.load(pupil, letter)


@lru_cache(maxsize=64)
def _sheet_of(letter: str) -> tuple[float, ...]:
    """Return a sheet on which every pupil's letter has room: left, bottom, right, top [m]."""
    pupils = [meet_pupil(name, letter) for name in known_pupils()]
    points = np.concatenate([path for pupil in pupils for path in paths_of(pupil.strokes)])
    low, high = points.min(axis=0) - SHEET_ROOM, points.max(axis=0) + SHEET_ROOM
    return tuple(float(side) for side in (*low, *high))


def draw_pupil(pupil: RobotPupil, dots: Sequence[Array], caption: str, note: str) -> Drawing:
    """Draw a pupil's letter as a line, and others as dots, with room for all pupils'."""
    return {
        "box": list(_sheet_of(pupil.letter)),
        "title": _("The robot’s letter as a line, and over it another one as dots."),
        "caption": caption,
        "note": note,
        "demo": list(dots),
        "robot": paths_of(pupil.strokes),
    }


def draw_distances(
    lines: Sequence[Drawing], dots: Sequence[Drawing], note: str, hides_bet: bool = False
) -> Drawing:
    """Draw distances over turns, without the bet where it was on another pupil."""
    turns = max(TURNS, len(dots) - 1)
    x, y = axis(0, turns, _("times it was shown")), axis(0, MOST_FAR, "mm")
    marks = {"lines": list(lines), "dots": list(dots), "hides_bet": hides_bet}
    return plot(_("How far off it is"), x, y, note, **marks)


def distance_line(far: Array, kind: str) -> Drawing:
    """Draw distances [mm] turn by turn."""
    return line(np.column_stack([np.arange(len(far)), far]).astype(float), kind)


def say_of_pupil(far: float, pupil: RobotPupil) -> Message:
    """Return a distance [mm], and what the score says of a pupil's letter."""
    name = pupil.memory.traits.name
    text = _("{name}’s {letter} beside the book’s: ").format(letter=pupil.letter, name=name)
    return says(millimetres(far / 1000), _("mm off"), text, pupil.score().sentence)


def say_of_session(session: TeachingSession) -> Message:
    """Return how far off a pupil is as it comes to the next turn, what it says and what it asks."""
    pupil, question = session.met[-1], ""
    told = pupil.says
    if session.asks:
        last = session.shown[-1]
        was = _("You brought me to {mm} mm.").format(mm=millimetres(session.learned[-1]))
        told = f"{was} {told}" if pupil.memory.lost else last.says
        question = str(last.question)
    return says(millimetres(session.far[-1]), _("mm off"), f"{told} ", question)
