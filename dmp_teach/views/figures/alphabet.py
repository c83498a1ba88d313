"""A sheet of letters to hang up: each on its writing line, with the order of its strokes."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import cycle

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import RecordingError, kind_of
from dmp_teach.ink import Recording, characters, recording_of
from dmp_teach.letters import resample_evenly
from dmp_teach.trajectory import Array, path_length
from dmp_teach.views.figures.figure_style import DrawStyle, new_figure
from dmp_teach.views.palette import GRID_COLOR, MUTED_COLOR, STROKE_COLORS, TEXT_COLOR

# Half of a to z.
LETTERS_PER_LINE = 13
# All lengths are on the sheet [inch]; the largest letter sets the scale of all.
LARGEST_LETTER = 1.35
LETTER_GAP = 0.22
NUMBER_OFFSET = 0.062
NUMBER_ROOM = 0.05
ARROW_SPACING = 0.7
# A shorter stroke is a dot, and has no arrow.
MAX_DOT_INK = 0.12
ARROW_STYLE = "-|>,head_width=0.22,head_length=0.45"


@checked
def draw_contact_sheet(
    alphabet: str | None = None, recordings: Iterable[Recording] | None = None, numbers: bool = True
) -> Figure:
    """Draw letters in rows on their writing lines, all in one scale.

    Strokes differ by number, colour and arrows.

    Args:
        alphabet: One of `alphabets()`; None is the first.
        recordings: These letters, in this order, instead of an alphabet.
        numbers: Whether each stroke has its number and its arrows; else it is ink alone.

    Raises:
        RecordingError: No such alphabet, both an alphabet and recordings, or no recording.
    """
    chosen = _choose_recordings(alphabet, recordings)
    placed = [_place_on_line(recording) for recording in chosen]
    # In one scale, the largest as large as the sheet has room for [inch].
    largest = max(np.ptp(np.concatenate(letter), axis=0).max() for letter in placed)
    scale = LARGEST_LETTER / max(largest, 1e-9)
    letters = [[scale * stroke for stroke in letter] for letter in placed]
    boxes = np.array([[ink.min(axis=0), ink.max(axis=0)] for ink in map(np.concatenate, letters)])
    width = np.ptp(boxes[:, :, 0], axis=1).max() + LETTER_GAP
    top = boxes[:, 1, 1].max() + LETTER_GAP / 2
    height = top - min(0.0, boxes[:, 0, 1].min()) + LETTER_GAP / 2
    columns = min(LETTERS_PER_LINE, len(letters))
    rows = -(-len(letters) // columns)
    figure, ((panel,),) = new_figure(1, 1, width * columns, height * rows)
    panel.set(xlim=(0, width * columns), ylim=(-height * rows, 0), aspect="equal")
    panel.set_axis_off()
    x_heights = [
        box[1, 1] for box, each in zip(boxes, chosen, strict=True) if each.character == "x"
    ]
    for row in range(rows):
        for level, color in zip([0.0, *x_heights], (MUTED_COLOR, GRID_COLOR), strict=False):
            panel.axhline(level - row * height - top, color=color, linewidth=0.8, zorder=0)
    for place, (letter, box) in enumerate(zip(letters, boxes, strict=True)):
        row, column = divmod(place, columns)
        origin = np.array([(column + 0.5) * width - box[:, 0].mean(), -row * height - top])
        _plot_letter(panel, [stroke + origin for stroke in letter], numbers)
    return figure


def _choose_recordings(
    alphabet: str | None, recordings: Iterable[Recording] | None
) -> tuple[Recording, ...]:
    """Return the recordings to be drawn, or raise a RecordingError."""
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


def _place_on_line(recording: Recording) -> list[Array]:
    """Return strokes over their writing line, (T, 2) each [m]; without one the lowest point."""
    strokes = [stroke.position for stroke in recording.strokes()]
    line = recording.baseline
    if line is None:
        line = min(stroke[:, 1].min() for stroke in strokes)
    return [stroke - (0.0, line) for stroke in strokes]


def _plot_letter(panel: Axes, strokes: list[Array], numbers: bool) -> None:
    """Plot strokes, (T, 2) each [inch]; what is written first lies below."""
    ink = np.concatenate(strokes)
    taken = ink[:: max(1, len(ink) // 300)]
    round_ends: DrawStyle = {"solid_capstyle": "round", "solid_joinstyle": "round"}
    for number, (path, color) in enumerate(zip(strokes, cycle(STROKE_COLORS), strict=False), 1):
        hue = color if numbers else TEXT_COLOR
        panel.plot(*path.T, color=hue, linewidth=2.2, zorder=number, **round_ends)
        if numbers:
            place = _find_number_place(path, taken)
            taken = np.vstack([taken, place])
            panel.plot(*path[0], marker="o", markersize=4.2, color=color, zorder=29)
            look: DrawStyle = {"fontsize": 8, "weight": "bold", "ha": "center", "va": "center"}
            panel.text(place[0], place[1], str(number), color=color, **look)
            _plot_arrows(panel, path, color)


def _find_number_place(path: Array, taken: Array) -> Array:
    """Return where the number of a stroke has room, before its start if it can (2,) [inch]."""
    apart = np.linalg.norm(path - path[0], axis=1)
    ahead = path[np.argmax(apart > MAX_DOT_INK / 3)] - path[0]
    turns = np.arctan2(-ahead[1], -ahead[0]) + np.radians([0, 45, -45, 90, -90, 135, -135])
    places = path[0] + NUMBER_OFFSET * np.column_stack([np.cos(turns), np.sin(turns)])
    room = np.linalg.norm(places[:, None] - taken, axis=2).min(axis=1)
    return places[np.argmax(np.minimum(room, NUMBER_ROOM))]


def _plot_arrows(panel: Axes, path: Array, color: str) -> None:
    """Plot heads of arrows along a stroke (T, 2) [inch], where it runs straight."""
    length = path_length(path)
    if length < MAX_DOT_INK:
        return
    even = resample_evenly(path, 201)[0]
    chords = even[12:] - even[:-12]
    # The bend at even[12:-12].
    bend = np.linalg.norm(chords[12:] - chords[:-12], axis=1) / (0.06 * length)
    count = max(1, round(length / ARROW_SPACING))
    look = {"arrowstyle": ARROW_STYLE, "color": color, "shrinkA": 0, "shrinkB": 0}
    look["mutation_scale"] = 10 * min(1.0, max(0.7, length / ARROW_SPACING))
    for middle in 200 * (np.arange(count) + 0.5) / count:
        around = np.arange(round(middle - 45 / count), round(middle + 45 / count) + 1)
        near = np.clip(around, 12, 188)
        k = near[np.argmin(np.round(bend[near - 12], 1) + 1e-3 * np.abs(near - middle))]
        panel.annotate("", xy=even[k + 2], xytext=even[k - 2], arrowprops=look, zorder=28)
