"""Figures of letters that were made of one writer's strokes, and of the words they write."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import LetterError
from dmp_teach.ink import Recording, alphabets, recording_of
from dmp_teach.letters import Shelf, letters_needed, make_letter, recipes
from dmp_teach.trajectory import Trajectory, all_points
from dmp_teach.views.figures.figure_style import (
    CURVE_LINES,
    label_millimetres,
    new_figure,
    plot_path,
    set_same_view,
    style_paper,
)
from dmp_teach.views.palette import MUTED_COLOR, PERSON_COLOR, ROBOT_COLOR, STROKE_COLORS

TRANSFORM_NAMES = {"star": "DMP*", "similarity": "similarity"}


@checked
def draw_made_letters(
    character: str = "P", source: str = "D", recordings: Iterable[Recording] | None = None
) -> Figure:
    """Draw each writer's letter in a row with what is made of it, in one scale.

    Args:
        character: The letter that is made.
        source: The letter that it is made of.
        recordings: Recordings of `source`, others are left out; our own alphabets' unless given.

    Raises:
        LetterError: No recording of `source`, or no recipe that needs nothing else.
    """
    if recordings is None:
        recordings = [recording_of(source, name) for name in alphabets()]
    shown = [
        recording for recording in recordings if getattr(recording, "character", None) == source
    ]
    how = next((how for _, how in recipes(character) if letters_needed(how) == (source,)), None)
    if not shown or how is None:
        missing = f"recording of {source!r}"
        if shown:
            missing = f"recipe that makes {character!r} of {source!r} alone"
        raise LetterError(
            f"There is no {missing}, so there is nothing to draw; "
            "the recipes are in letters/compose/recipes.py."
        )
    columns = 1 + len(TRANSFORM_NAMES)
    figure, panels = new_figure(len(shown), columns, 2.5 * columns, 2.8 * len(shown) + 0.3)
    for row, recording in zip(panels, shown, strict=True):
        shelf = Shelf.of([recording])
        strokes = list(recording.strokes())
        for stroke in strokes:
            look = {"color": PERSON_COLOR, "linestyle": ":", "linewidth": 2.2}
            plot_path(row[0], stroke.position, **look)
        style_paper(row[0], f"{source}, {recording.writer or 'somebody'}, as shown")
        for panel, (transform, name) in zip(row[1:], TRANSFORM_NAMES.items(), strict=True):
            made = make_letter(character, shelf, transform, how).write()
            _plot_strokes(panel, made)
            style_paper(panel, f"{character} by {name}")
            strokes += made
        set_same_view(row, 1e3 * all_points(strokes))
    label_millimetres(panels, fontsize=9)
    return figure


@checked
def draw_recipes(shelf: Shelf, transform: str = "star") -> Figure:
    """Draw every letter that a writer's strokes make, and name the letters that they come from.

    Args:
        shelf: Strokes of one writer.
        transform: What leads strokes to other ends, "star" or "similarity".

    Raises:
        LetterError: No recipe whose letters are all on the shelf.
    """
    makeable = [
        (made, how) for made, how in recipes() if set(letters_needed(how)) <= set(shelf.letters)
    ]
    if not makeable:
        raise LetterError(
            f"No recipe can be made of {', '.join(shelf.letters)} alone; "
            "put more letters on the shelf."
        )
    columns = min(8, len(makeable))
    rows = -(-len(makeable) // columns)
    figure, panels = new_figure(rows, columns, 1.45 * columns, 1.9 * rows)
    for panel in panels.flat:
        panel.axis("off")
    for panel, (character, how) in zip(panels.flat, makeable, strict=False):
        strokes = make_letter(character, shelf, transform, how).write()
        _plot_strokes(panel, strokes)
        panel.set_aspect("equal")
        panel.set_title(
            f"{character} of {', '.join(letters_needed(how))}", fontsize=9, color=MUTED_COLOR
        )
        set_same_view([panel], 1e3 * all_points(strokes))
    return figure


@checked
def draw_text(
    strokes: Sequence[Trajectory], width: float | None = None, height: float | None = None
) -> Figure:
    """Draw a word or lines as ink on paper.

    Args:
        strokes: From `write_word` or `write_lines`.
        width: Of the sheet, whose middle is the origin [m]; None: as wide as the ink.
        height: Of the sheet [m].
    """
    if len(strokes) == 0:
        raise LetterError("strokes is empty; give those of a text.")
    ink = 1e3 * all_points(strokes)
    corners = np.stack([ink.min(axis=0), ink.max(axis=0)])
    if width is not None and height is not None:
        corners = 500 * np.array([[-width, -height], [width, height]])
    across, tall = np.ptp(corners, axis=0)
    figure, panels = new_figure(1, 1, 9.0, min(12.0, 9.0 * tall / across + 0.6))
    panel = style_paper(panels[0, 0])
    for stroke in strokes:
        look = {"color": ROBOT_COLOR, "linewidth": 1.8, "solid_capstyle": "round"}
        plot_path(panel, stroke.position, **look)
    set_same_view([panel], corners)
    label_millimetres(panels, fontsize=9)
    return figure


def _plot_strokes(panel: Axes, strokes: Iterable[Trajectory]) -> None:
    """Plot strokes [mm], each in a colour and line of its own."""
    looks = zip(STROKE_COLORS * 3, CURVE_LINES * 3, strict=True)
    for stroke, (color, line) in zip(strokes, looks, strict=False):
        plot_path(panel, stroke.position, color=color, linestyle=line, linewidth=2.0)
