"""A style as a sheet of letters: its writers, a morph, its principal styles, and new letters."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from dmp_teach.arguments import LARGEST_SEED, check_whole, checked
from dmp_teach.letters import Letter, Style
from dmp_teach.trajectory import Array
from dmp_teach.views.figures.figure_style import new_figure, plot_path, set_same_view, style_paper
from dmp_teach.views.palette import MUTED_COLOR, PERSON_COLOR, ROBOT_COLOR, TEXT_COLOR

LETTERS_PER_ROW = 5
PRINCIPAL_STYLES_DRAWN = 2


@checked
def draw_style_sheet(style: Style, seed: int = 0) -> Figure:
    """Draw what several writers' letters share, and how they differ.

    Five letters in each row: the first writers as they wrote (made equally large, if the style
    is); the way from the first writer to the last; the first principal styles from -2 to 2
    standard deviations; and random letters.

    Args:
        style: From `Style.of`.
        seed: Of the random letters; the same seed gives the same letters.
    """
    check_whole("seed", seed, 0, LARGEST_SEED)
    rows = _collect_rows(style, np.random.default_rng(seed))
    size = (2.1 * LETTERS_PER_ROW, 2.4 * len(rows))
    figure, panels = new_figure(len(rows), LETTERS_PER_ROW, *size, sharex=True, sharey=True)
    layout = ConstrainedLayoutEngine(rect=(0, 0, 1, 1 - 0.15 / len(rows)), h_pad=0.12)
    figure.set_layout_engine(layout)
    points = []
    for line, (title, letters) in zip(panels, rows.items(), strict=True):
        for panel in line:
            style_paper(panel).set_axis_off()
        look = {"color": TEXT_COLOR, "fontsize": 11.5, "fontweight": "bold"}
        # The title is wider than its column, so the layout must not see it.
        line[0].text(0, 1.16, title, transform=line[0].transAxes, **look).set_in_layout(False)
        for panel, (name, letter) in zip(line, letters, strict=False):
            color = PERSON_COLOR if title == "as they wrote" else ROBOT_COLOR
            points.append(_plot_letter(panel, letter, color))
            panel.set_title(name, color=MUTED_COLOR, fontsize=10)
    set_same_view(panels.flat, 1e3 * np.concatenate(points))
    return figure


def _collect_rows(style: Style, rng: np.random.Generator) -> dict[str, list[tuple[str, Letter]]]:
    """Return the title of each row, and its letters with their names."""
    first = style.writers[0]
    last = style.writers[-1]
    shares = np.linspace(0, 1, LETTERS_PER_ROW)
    scores = np.linspace(-2, 2, LETTERS_PER_ROW)
    morphs = [(f"{100 * share:.0f} %", style.morph(first, last, share)) for share in shares]
    rows = {
        "as they wrote": list(zip(style.writers, style.letters, strict=True))[:LETTERS_PER_ROW],
        f"from {first} to {last}": morphs,
    }
    for k, share in enumerate(style.shares[:PRINCIPAL_STYLES_DRAWN]):
        title = f"principal style {k + 1}: {100 * share:.0f} % of all differences"
        letters = [style.letter([0.0] * k + [score]) for score in scores]
        rows[title] = list(zip(map(_format_score, scores), letters, strict=True))
    rows["new letters, by chance"] = [("", style.sample(rng)) for _ in range(LETTERS_PER_ROW)]
    return rows


def _format_score(score: float) -> str:
    """Return a place along a principal style in words."""
    return f"{score:+.0f} deviations".replace("-", "\N{MINUS SIGN}") if score else "the mean"


def _plot_letter(panel: Axes, letter: Letter, color: str) -> Array:
    """Plot strokes with a dot at each start; return all points, shape (T, 2) [m]."""
    paths = [stroke.position for stroke in letter.write()]
    for path in paths:
        plot_path(panel, path, color=color, linewidth=2.2, solid_capstyle="round")
        plot_path(panel, path[:1], marker="o", linestyle="", color=TEXT_COLOR, markersize=3.5)
    return np.concatenate(paths)
