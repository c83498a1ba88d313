"""What a pupil takes home, drawn in millimetres of the paper: a worksheet and a certificate.

Each is a figure of the paper's own size: `figure.savefig("sheet.pdf")`, or `.svg`, prints at 100 %.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch

from dmp_teach.arguments import checked
from dmp_teach.errors import ViewError, kind_of
from dmp_teach.letters import Letter, resample_evenly, rms_distance
from dmp_teach.scoring import LetterLike
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import (
    Array,
    Trajectory,
    all_points,
    arc_lengths,
    interpolate_points,
    path_length,
)
from dmp_teach.views.figures.figure_style import DrawStyle, PaperFigure
from dmp_teach.views.palette import GRID_COLOR, MUTED_COLOR, PERSON_COLOR, ROBOT_COLOR, TEXT_COLOR
from dmp_teach.views.stamp_code import stamp_squares

PAPERS = {"A4": (210.0, 297.0), "Letter": (215.9, 279.4)}
"""Width and height [mm]."""
PAPER_MARGIN, ROW_HEIGHT, CELLS = 15.0, 42.0, 5
MOST_ROWS = 5
INK_SHARE = 0.7
# Dots to be traced, and the disc that a stroke begins on [mm].
DOT_SPACING, DISC = 2.0, 1.9
ARROW_AT, ARROW_LENGTH = 0.22, 5.0
MM_PER_INCH = 25.4
BLACK, GREY = "#000000", "#767676"


@checked
def draw_worksheet(
    letters: Sequence[LetterLike], paper: str = "A4", is_colored: bool = True
) -> Figure:
    """Draw a sheet to practise letters on, a row for each.

    In a row stand the letter, with a number where each stroke begins and an arrow where it goes;
    what the robot made of it; the letter as dots, twice; and an empty place.

    Args:
        letters: At most 5: recordings, a pupil's own too, or strokes.
        paper: "A4" or "Letter".
        is_colored: False for a printer with black ink alone.

    Raises:
        ViewError: No letters or more than 5, or another paper.
        LetterError: What is given is no letter.
    """
    if not isinstance(letters, list | tuple):
        raise ViewError(f"A worksheet takes a list of letters, but got {kind_of(letters)}.")
    if not 0 < len(letters) <= MOST_ROWS:
        raise ViewError(f"A worksheet has 1 to {MOST_ROWS} letters, but got {len(letters)}.")
    learned = [_learned_flat(letter) for letter in letters]
    shown = [letter.strokes for letter in learned]
    figure, panel, (width, height) = _new_page(paper)
    person, robot = _colors(is_colored)
    cell = (width - 2 * PAPER_MARGIN) / CELLS
    scale = min(_fitting_scale(strokes, cell) for strokes in shown)
    panel.text(
        PAPER_MARGIN, height - 19, _("My letters"), fontsize=20, color=TEXT_COLOR, weight="bold"
    )
    for n, word in enumerate((_("shown"), _("the robot"), _("trace"), _("trace"), _("write"))):
        panel.text(PAPER_MARGIN + n * cell, height - 27, word, fontsize=9, color=MUTED_COLOR)
    for row, strokes in enumerate(shown):
        middle = height - 34 - (row + 0.5) * ROW_HEIGHT
        robots = learned[row].write()
        places = [np.array([PAPER_MARGIN + (n + 0.5) * cell, middle]) for n in range(CELLS)]
        put = _placed(strokes, scale)
        baseline = middle + put(np.zeros(2))[1]
        ends = [PAPER_MARGIN, width - PAPER_MARGIN]
        panel.plot(ends, [baseline, baseline], color=GRID_COLOR, linewidth=0.8)
        inks = [[put(s.position) + place for s in strokes] for place in places]
        _draw_ink(panel, inks[0], person)
        _mark_strokes(panel, inks[0], person)
        _draw_ink(panel, [put(s.position) + places[1] for s in robots], robot)
        for ink in inks[2:4]:
            _draw_dots(panel, ink)
    _draw_lines_to_fill(panel, width, 14.0)
    return figure


@checked
def draw_certificate(letter: LetterLike, paper: str = "A4", is_colored: bool = True) -> Figure:
    """Draw what a pupil has taught the robot: the own letter, the robot's, and its stamp.

    The stamp is a QR code that holds the robot's letter: `teach.read_stamp` brings it back. There
    is no name in the file: it is written on the paper by hand.

    Args:
        letter: The pupil's recording, or strokes.
        paper: "A4" or "Letter".
        is_colored: False for a printer with black ink alone.

    Raises:
        ViewError: Another paper.
        LetterError: What is given is no letter.
    """
    learned = _learned_flat(letter)
    strokes, robots = learned.strokes, learned.write()
    figure, panel, (width, height) = _new_page(paper)
    person, robot = _colors(is_colored)
    off = 1000 * rms_distance(strokes, robots)
    kernels = sum(len(each.weights) for each in learned.primitives)
    told = _("{kernels} bumps were enough. The robot is {off} mm off on average.")
    title = _("I taught a robot to write")
    _center(panel, (width / 2, height - 48), title, 28, TEXT_COLOR)
    told = told.format(kernels=kernels, off=f"{off:.2g}")
    _center(panel, (width / 2, height - 60), told, 13, TEXT_COLOR)
    half = (width - 2 * PAPER_MARGIN) / 2
    scale = _fitting_scale(strokes, half, half)
    put = _placed(strokes, scale)
    for side, who, word, color in (
        (-0.5, strokes, _("my letter"), person),
        (0.5, robots, _("the robot’s"), robot),
    ):
        place = np.array([width / 2 + side * half, height - 75 - half / 2])
        _draw_ink(panel, [put(s.position) + place for s in who], color, width=3.5)
        _center(panel, (place[0], height - 82 - half), word, 12, color)
    _draw_stamp(panel, learned, np.array([width - PAPER_MARGIN - 40, 40.0]), 40.0)
    note = _("This square holds the letter.\nA photo of it brings it back.")
    panel.text(
        width - PAPER_MARGIN - 44, 60, note, fontsize=10, ha="right", va="center", color=MUTED_COLOR
    )
    _draw_lines_to_fill(panel, width, 20.0)
    return figure


def _center(panel: Axes, at: tuple[float, float], words: str, size: float, color: str) -> None:
    """Write words about a place."""
    panel.text(*at, words, fontsize=size, ha="center", color=color)


def _new_page(paper: str) -> tuple[Figure, Axes, tuple[float, float]]:
    """Return a figure, its panel in millimetres from the lower left, and the paper's size."""
    if paper not in tuple(PAPERS):
        raise ViewError(f"The paper is {paper!r}, but must be one of: {', '.join(PAPERS)}.")
    width, height = PAPERS[paper]
    figure = PaperFigure(figsize=(width / MM_PER_INCH, height / MM_PER_INCH), facecolor="white")
    panel = figure.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(0, height))
    panel.set_axis_off()
    return figure, panel, (width, height)


def _learned_flat(letter: LetterLike) -> Letter:
    """Return a letter of 2-D strokes as the robot has learned it."""
    learned = Letter.learn(letter)
    if any(stroke.dimensions != 2 for stroke in learned.strokes):
        raise ViewError("A sheet of paper holds strokes in 2-D: right and up [m].")
    return learned


def _colors(is_colored: bool) -> tuple[str, str]:
    """Return the colours of the person and of the robot."""
    return (PERSON_COLOR, ROBOT_COLOR) if is_colored else (BLACK, GREY)


def _fitting_scale(
    strokes: Sequence[Trajectory], width: float, height: float = ROW_HEIGHT
) -> float:
    """Return how many mm of paper a metre of ink takes, so that it fits a cell [mm]."""
    size = np.ptp(all_points(strokes), axis=0)
    return INK_SHARE * min(width / max(size[0], 1e-6), height / max(size[1], 1e-6))


def _placed(about: Sequence[Trajectory], scale: float) -> Callable[[Array], Array]:
    """Return what brings points [m] to the middle of a cell [mm]."""
    points = all_points(about)
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    return lambda path: scale * (path - center)


def _draw_ink(panel: Axes, paths: Sequence[Array], color: str, width: float = 2.4) -> None:
    """Draw strokes as a pen does."""
    for path in paths:
        panel.plot(*path.T, color=color, linewidth=width, solid_capstyle="round")


def _draw_dots(panel: Axes, paths: Sequence[Array]) -> None:
    """Draw strokes as dots to be traced, with a ring where each begins."""
    for path in paths:
        dots, _rows = resample_evenly(path, max(2, round(path_length(path) / DOT_SPACING) + 1))
        panel.plot(*dots.T, ".", color=MUTED_COLOR, markersize=3)
        panel.add_patch(
            Circle((path[0, 0], path[0, 1]), DISC, fill=False, color=MUTED_COLOR, linewidth=1)
        )


def _mark_strokes(panel: Axes, paths: Sequence[Array], color: str) -> None:
    """Draw where each stroke begins, its number, and which way it goes."""
    discs: list[Array] = []
    for number, path in enumerate(paths, start=1):
        way, disc = arc_lengths(path), path[0]
        # Two strokes from one point have their numbers beside each other.
        while any(np.linalg.norm(disc - other) < 2 * DISC for other in discs):
            disc = disc + np.array([2 * DISC, 0.0])
        discs.append(disc)
        panel.add_patch(Circle((disc[0], disc[1]), DISC, color=color, zorder=4))
        look: DrawStyle = {"color": "white", "fontsize": 6.5, "weight": "bold", "zorder": 5}
        look |= {"ha": "center", "va": "center_baseline"}
        panel.text(disc[0], disc[1], str(number), **look)
        if way[-1] > 2 * ARROW_LENGTH:
            at = ARROW_AT * way[-1] + np.array([0.0, ARROW_LENGTH])
            begin, end = interpolate_points(at, way, path).tolist()
            look = {"arrowstyle": "-|>", "mutation_scale": 13, "color": TEXT_COLOR, "linewidth": 0}
            panel.add_patch(FancyArrowPatch(begin, end, shrinkA=0, shrinkB=0, zorder=3, **look))


def _draw_stamp(panel: Axes, letter: Letter, corner: Array, size: float) -> None:
    """Draw the QR code of a letter, its lower left corner and its size in mm."""
    squares = stamp_squares(letter)
    x, y = corner
    panel.imshow(
        squares, cmap="gray", vmin=0, vmax=255, extent=(x, x + size, y, y + size),
        interpolation="none", aspect="auto", zorder=2,
    )  # fmt: skip


def _draw_lines_to_fill(panel: Axes, width: float, height: float) -> None:
    """Draw where name and date are written by hand."""
    middle = 0.62 * width
    for begin, end, word in (
        (PAPER_MARGIN, middle - 6, _("Name")),
        (middle, width - PAPER_MARGIN, _("Date")),
    ):
        panel.text(begin, height, word, fontsize=10, color=MUTED_COLOR)
        panel.plot([begin + 14, end], [height, height], color=MUTED_COLOR, linewidth=0.8)
