"""A style as a sheet of letters: the writers, a morph between two of them, the principal styles, and new letters."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.letters import Letter, Style
from dmp_teach.views.figures.figure_style import CHILD, INK, QUIET, ROBOT, paper, same_view, sheet

COLUMNS = 5
STYLES = 2  # as many principal styles are drawn


def style_sheet(style: Style, seed: int = 0) -> Figure:
    """What several writers' letters share, and how they differ.

    Five letters in each row: the first writers as they wrote (made equally large, if the style is); the way from the
    first writer to the last; the first principal styles from -2 to 2 standard deviations; and letters by chance.

    Args:
        style: From `Style.of`.
        seed: Of the letters by chance; the same seed gives the same letters.
    """
    rows = _rows(style, np.random.default_rng(seed))
    figure, panels = sheet(
        len(rows), COLUMNS, 2.1 * COLUMNS, 2.4 * len(rows), sharex=True, sharey=True
    )
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - 0.15 / len(rows)), h_pad=0.12)
    everything = []
    for line, (title, letters) in zip(panels, rows.items(), strict=True):
        for panel in line:
            paper(panel).set_axis_off()
        about = {
            "transform": line[0].transAxes,
            "color": INK,
            "fontsize": 11.5,
            "fontweight": "bold",
        }
        line[0].text(0, 1.16, title, **about).set_in_layout(False)  # it is wider than its column
        for panel, (name, letter) in zip(line, letters, strict=False):
            everything.append(_drawn(panel, letter, CHILD if title == "as they wrote" else ROBOT))
            panel.set_title(name, color=QUIET, fontsize=10)
    same_view(panels.flat, np.concatenate(everything))
    return figure


def _rows(style: Style, rng: np.random.Generator) -> dict[str, list[tuple[str, Letter]]]:
    """The letters of each row, each with its name."""
    one, other = style.writers[0], style.writers[-1]
    parts, turns = np.linspace(0, 1, COLUMNS), np.linspace(-2, 2, COLUMNS)
    rows = {
        "as they wrote": list(zip(style.writers, style.letters, strict=True))[:COLUMNS],
        f"from {one} to {other}": [
            (f"{100 * part:.0f} %", style.morph(one, other, part)) for part in parts
        ],
    }
    for k, share in enumerate(style.shares[:STYLES]):
        title = f"principal style {k + 1}: {100 * share:.0f} % of all differences"
        rows[title] = [(_deviations(turn), style.letter([0.0] * k + [turn])) for turn in turns]
    return rows | {"new letters, by chance": [("", style.sample(rng)) for _ in range(COLUMNS)]}


def _deviations(turn: float) -> str:
    """A place along a principal style, in words."""
    return f"{turn:+.0f} deviations".replace("-", "\N{MINUS SIGN}") if turn else "the mean"


def _drawn(panel: Axes, letter: Letter, colour: str) -> np.ndarray:
    """The ink of a letter on a panel, each stroke with its start; all its points, shape (T, 2) [mm]."""
    strokes = [1e3 * stroke.position for stroke in letter.write()]
    for stroke in strokes:
        panel.plot(*stroke.T, color=colour, linewidth=2.2, solid_capstyle="round")
        panel.plot(*stroke[0], "o", color=INK, markersize=3.5)
    return np.concatenate(strokes)
