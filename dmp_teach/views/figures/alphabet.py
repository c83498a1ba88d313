"""A sheet of letters as a teacher hangs it up: each on its writing line, with the order and way of its strokes."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import cycle

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.errors import RecordingError, kind_of
from dmp_teach.ink import Recording, characters, recording_of
from dmp_teach.trajectory import Array, ways
from dmp_teach.views.figures.figure_style import COLOURS, GRID, INK, QUIET, sheet

COLUMNS = 13  # half of a to z
HIGH = 1.35  # how large the largest letter is on the sheet, all else in one scale with it [inch]
GAP = 0.22  # between letters [inch]
BACK = 0.062  # the number of a stroke stands so far from its start [inch]
ROOM = 0.05  # as free of ink as a number needs it [inch]
EVERY = 0.7  # so much ink to an arrow [inch]
DOT = 0.12  # a shorter stroke is a dot, and has no arrow [inch]
HEAD = "-|>,head_width=0.22,head_length=0.45"


def contact_sheet(
    alphabet: str | None = None, recordings: Iterable[Recording] | None = None, numbers: bool = True
) -> Figure:
    """Letters in rows on their writing lines, all in one scale; strokes are told apart by number, colour and arrows.

    Args:
        alphabet: One of `alphabets()`; None is the first.
        recordings: These letters, in this order, instead of an alphabet.
        numbers: Whether each stroke has its number and its arrows; else it is ink alone.

    Raises:
        RecordingError: No such alphabet, both an alphabet and recordings, or no recording.
    """
    asked = _asked(alphabet, recordings)
    letters = _in_inches([_on_its_line(recording) for recording in asked])
    boxes = np.array([[ink.min(axis=0), ink.max(axis=0)] for ink in map(np.concatenate, letters)])
    wide, top = np.ptp(boxes[:, :, 0], axis=1).max() + GAP, boxes[:, 1, 1].max() + GAP / 2
    tall = top - min(0.0, boxes[:, 0, 1].min()) + GAP / 2
    columns = min(COLUMNS, len(letters))
    rows = -(-len(letters) // columns)
    figure, ((panel,),) = sheet(1, 1, wide * columns, tall * rows)
    panel.set(xlim=(0, wide * columns), ylim=(-tall * rows, 0), aspect="equal")
    panel.set_axis_off()
    heights = [
        0.0,
        *(box[1, 1] for box, each in zip(boxes, asked, strict=True) if each.character == "x"),
    ]
    for row in range(rows):
        for height, colour in zip(heights, (QUIET, GRID), strict=False):
            panel.axhline(height - row * tall - top, color=colour, linewidth=0.8, zorder=0)
    for place, (letter, box) in enumerate(zip(letters, boxes, strict=True)):
        row, column = divmod(place, columns)
        _draw(
            panel,
            letter,
            np.array([(column + 0.5) * wide - box[:, 0].mean(), -row * tall - top]),
            numbers,
        )
    return figure


def _asked(alphabet: str | None, recordings: Iterable[Recording] | None) -> tuple[Recording, ...]:
    """The letters that are to be drawn, or a sentence."""
    if recordings is None:
        return tuple(recording_of(character, alphabet) for character in characters(alphabet))
    if alphabet is not None:
        raise RecordingError(
            f"There are recordings and an alphabet, {alphabet!r}; give one of them."
        )
    given = tuple(recordings) if isinstance(recordings, Iterable) else (recordings,)
    wrong = [kind_of(each) for each in given if not isinstance(each, Recording)]
    if wrong or not given:
        raise RecordingError(
            f"A contact sheet is made of recordings, but got {wrong[0] if wrong else 'none'}."
        )
    return given


def _on_its_line(recording: Recording) -> list[Array]:
    """The strokes of a letter over its writing line, (T, 2) each [m]; without a line it stands on its lowest point."""
    strokes = [stroke.position for stroke in recording.strokes()]
    lowest = min(stroke[:, 1].min() for stroke in strokes)
    line = lowest if recording.baseline is None else recording.baseline
    return [stroke - (0.0, line) for stroke in strokes]


def _in_inches(letters: list[list[Array]]) -> list[list[Array]]:
    """Letters in one scale, in which the largest is as large as the sheet has room for, (T, 2) each [inch]."""
    largest = max(np.ptp(np.concatenate(letter), axis=0).max() for letter in letters)
    return [[HIGH / max(largest, 1e-9) * stroke for stroke in letter] for letter in letters]


def _draw(panel: Axes, letter: list[Array], at: Array, numbers: bool) -> None:
    """A letter's strokes, (T, 2) each [inch], moved by `at`; what is written first lies below."""
    ink = np.concatenate(letter) + at
    taken = ink[:: max(1, len(ink) // 300)]
    for number, (stroke, colour) in enumerate(zip(letter, cycle(COLOURS), strict=False), start=1):
        path, hue = stroke + at, colour if numbers else INK
        panel.plot(
            *path.T,
            color=hue,
            linewidth=2.2,
            solid_capstyle="round",
            solid_joinstyle="round",
            zorder=number,
        )
        if numbers:
            place = _beside(path, taken)
            taken = np.vstack([taken, place])
            panel.plot(*path[0], marker="o", markersize=4.2, color=colour, zorder=29)
            panel.text(
                *place,
                str(number),
                color=colour,
                fontsize=8,
                weight="bold",
                ha="center",
                va="center",
            )
            _arrows(panel, path, colour)


def _beside(path: Array, taken: Array) -> Array:
    """Where the number of a stroke (T, 2) stands: before its start, or where there is more room (2,) [inch]."""
    ahead = path[np.argmax(np.linalg.norm(path - path[0], axis=1) > DOT / 3)] - path[0]
    back = np.arctan2(-ahead[1], -ahead[0])
    turns = np.radians([0, 45, -45, 90, -90, 135, -135])
    places = path[0] + BACK * np.column_stack([np.cos(back + turns), np.sin(back + turns)])
    room = np.linalg.norm(places[:, None] - taken, axis=2).min(axis=1)
    return places[np.argmax(np.minimum(room, ROOM))]


def _arrows(panel: Axes, path: Array, colour: str) -> None:
    """Heads of arrows along a stroke (T, 2) [inch], where it runs straight."""
    way = ways(path)
    if way[-1] < DOT:
        return
    even = np.column_stack([np.interp(np.linspace(0, way[-1], 201), way, axis) for axis in path.T])
    chords = even[12:] - even[:-12]
    bend = np.linalg.norm(chords[12:] - chords[:-12], axis=1) / (0.06 * way[-1])  # at even[12:-12]
    arrows = max(1, round(way[-1] / EVERY))
    size = 10 * min(1.0, max(0.7, way[-1] / EVERY))
    for middle in 200 * (np.arange(arrows) + 0.5) / arrows:
        near = np.clip(
            np.arange(round(middle - 45 / arrows), round(middle + 45 / arrows) + 1), 12, 188
        )
        k = near[np.argmin(np.round(bend[near - 12], 1) + 1e-3 * np.abs(near - middle))]
        style = {
            "arrowstyle": HEAD,
            "mutation_scale": size,
            "color": colour,
            "shrinkA": 0,
            "shrinkB": 0,
        }
        panel.annotate("", xy=even[k + 2], xytext=even[k - 2], arrowprops=style, zorder=28)
