"""Figures of letters that were made: of one writer's strokes, by every transformation, and the words they write."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.errors import LetterError
from dmp_teach.ink import alphabets, recording_of
from dmp_teach.letters import Shelf, make_letter, needed, recipes
from dmp_teach.trajectory import Trajectory
from dmp_teach.views.figures.figure_style import (
    CHILD,
    COLOURS,
    LINES,
    QUIET,
    ROBOT,
    paper,
    same_view,
    sheet,
)

FORMS = (("star", "DMP*"), ("similarity", "similarity"))


def letters_made(
    character: str = "P", source: str = "D", recordings: Iterable[Any] | None = None
) -> Figure:
    """What each writer's letter becomes: a row a writer, the letter as shown and what is made of it, in one scale.

    Args:
        character: The letter that is made.
        source: The letter that it is made of.
        recordings: Recordings of `source`, others are left out; our own alphabets' unless given.

    Raises:
        LetterError: No recording of `source`, or no recipe that needs nothing else.
    """
    given = (
        [recording_of(source, name) for name in alphabets()]
        if recordings is None
        else list(recordings)
    )
    shown = [recording for recording in given if recording.character == source]
    how = next((how for _, how in recipes(character) if needed(how) == (source,)), None)
    if not shown or how is None:
        what = (
            f"recipe that makes {character!r} of {source!r} alone"
            if shown
            else f"recording of {source!r}"
        )
        raise LetterError(
            f"There is no {what}, so there is nothing to draw; the recipes are in letters/recipes.py."
        )
    figure, panels = sheet(
        len(shown), 1 + len(FORMS), 2.5 * (1 + len(FORMS)), 2.8 * len(shown) + 0.3
    )
    for row, recording in zip(panels, shown, strict=True):
        shelf = Shelf.of([recording])
        strokes = recording.strokes()
        drawn = [make_letter(character, shelf, form, how).write() for form, _ in FORMS]
        for stroke in strokes:
            row[0].plot(*(1e3 * stroke.position).T, color=CHILD, linestyle=":", linewidth=2.2)
        paper(row[0], f"{source}, {recording.writer or 'somebody'}, as shown")
        for panel, made, (_, name) in zip(row[1:], drawn, FORMS, strict=True):
            _ink(panel, made)
            paper(panel, f"{character} by {name}")
        same_view(
            row, 1e3 * np.concatenate([s.position for each in (strokes, *drawn) for s in each])
        )
    _millimetres(panels)
    return figure


def recipes_drawn(shelf: Shelf, transform: str = "star") -> Figure:
    """Every letter that a writer's strokes make, each with the letters that they come from.

    Args:
        shelf: Strokes of one writer.
        transform: What leads strokes to other ends, "star" or "similarity".

    Raises:
        LetterError: No recipe whose letters are all on the shelf.
    """
    lines = [(made, how) for made, how in recipes() if set(needed(how)) <= set(shelf.letters)]
    if not lines:
        raise LetterError(
            f"No recipe can be made of {', '.join(shelf.letters)} alone; put more letters on the shelf."
        )
    columns = min(8, len(lines))
    rows = -(-len(lines) // columns)
    figure, panels = sheet(rows, columns, 1.45 * columns, 1.9 * rows)
    for panel in panels.flat:
        panel.axis("off")
    for panel, (character, how) in zip(panels.flat, lines, strict=False):
        strokes = make_letter(character, shelf, transform, how).write()
        _ink(panel, strokes)
        panel.set_aspect("equal")
        panel.set_title(f"{character} of {', '.join(needed(how))}", fontsize=9, color=QUIET)
        same_view([panel], 1e3 * np.concatenate([stroke.position for stroke in strokes]))
    return figure


def written_text(
    strokes: Sequence[Trajectory], width: float | None = None, height: float | None = None
) -> Figure:
    """A word or lines as ink on paper.

    Args:
        strokes: From `write_word` or `write_lines`.
        width: Of the sheet, whose middle is the origin [m]; None: as wide as the ink.
        height: Of the sheet [m].
    """
    ink = 1e3 * np.concatenate([stroke.position for stroke in strokes])
    corners = np.stack([ink.min(axis=0), ink.max(axis=0)])
    if width is not None and height is not None:
        corners = 500 * np.array([[-width, -height], [width, height]])
    wide, tall = np.ptp(corners, axis=0)
    figure, panels = sheet(1, 1, 9.0, min(12.0, 9.0 * tall / wide + 0.6))
    panel = paper(panels[0, 0])
    for stroke in strokes:
        panel.plot(*(1e3 * stroke.position).T, color=ROBOT, linewidth=1.8, solid_capstyle="round")
    same_view([panel], corners)
    _millimetres(panels)
    return figure


def _ink(panel: Axes, strokes: Iterable[Trajectory]) -> None:
    """Strokes [mm], each in a colour and line of its own."""
    for stroke, colour, line in zip(strokes, COLOURS * 3, LINES * 3, strict=False):
        panel.plot(*(1e3 * stroke.position).T, color=colour, linestyle=line, linewidth=2.0)


def _millimetres(panels: np.ndarray) -> None:
    """Axes in mm, named once: at the left and at the bottom."""
    for panel in panels[:, 0]:
        panel.set_ylabel("y, up the page [mm]", fontsize=9)
    for panel in panels[-1]:
        panel.set_xlabel("x, to the right [mm]", fontsize=9)
