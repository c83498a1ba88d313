"""Whose letter is it: how often that was found, beside a guess, and who was taken for whom."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from dmp_teach.errors import SettingError
from dmp_teach.studies import Answers, Attributions
from dmp_teach.views.figures.figure_style import (
    CHILD,
    INK,
    OTHER,
    QUIET,
    ROBOT,
    dressed,
    explained_below,
    sheet,
)

COLOURS = {"DMP*": ROBOT, "similarity": "#009E73", "original": OTHER}
SHADES = LinearSegmentedColormap.from_list("answers", ["white", ROBOT])
DARK = 0.55  # a cell with more than this is written on in white
NAMED = 18  # of more writers than this the cells have no numbers


def attribution_bars(*found: Attributions) -> Figure:
    """How many letters were given to their writer: a bar for each question, its 95 % interval, and what a guess gives.

    Args:
        found: From `classify_writers` and `attribute_made_letters`, in the order in which they are drawn.

    Raises:
        SettingError: Nothing was asked.
    """
    asked = [each for answers in found for each in answers if each.items]
    if not asked:
        raise SettingError(
            "Nothing was asked; give what classify_writers or attribute_made_letters found of several writers' letters."
        )
    figure, ((panel,),) = sheet(1, 1, 8.2, 1.3 + 0.36 * len(asked))
    places = np.arange(len(asked))[::-1]
    rates = 100 * np.array([each.rate for each in asked])
    ends = 100 * np.array([each.interval for each in asked])
    panel.barh(places, rates, 0.62, color=[_colour(each) for each in asked], alpha=0.85)
    panel.hlines(
        places,
        *ends.T,
        color=INK,
        linewidth=1.4,
        label="95 % interval, a writer counting as one answer",
    )
    guesses = 100 * np.array([each.chance for each in asked])
    panel.vlines(
        guesses,
        places - 0.42,
        places + 0.42,
        color=INK,
        linestyle=(0, (2, 1.5)),
        linewidth=1.6,
        label="a guess",
    )
    for place, each in zip(places, asked, strict=True):
        hits, of = each.right
        about = {
            "transform": panel.get_yaxis_transform(),
            "va": "center",
            "color": QUIET,
            "fontsize": 9,
        }
        panel.text(1.02, place, f"{hits} of {of}, by luck {_luck(each.luck)}", **about)
    panel.set_yticks(places, [each.question for each in asked])
    panel.set_xlim(0, 100)
    panel.set_ylim(-0.6, len(asked) - 0.4)
    dressed(
        panel,
        "given to their writer [%]",
        "",
        f"Whose letter is it? {len(asked[-1].writers)} writers",
    )
    panel.grid(False, axis="y")
    explained_below(figure, panel)
    return figure


def confusion(answers: Answers) -> Figure:
    """Who wrote, and who was named: a row for each writer, shaded by the part of his letters [%].

    Args:
        answers: One question of `told_apart` or `attribution`.

    Raises:
        SettingError: Nothing was asked.
    """
    if not answers.items:
        raise SettingError(
            f"{answers.question!r} could be asked of no letter, so there is nothing to draw."
        )
    names, parts = answers.writers, answers.confusion
    size = 1.8 + 0.44 * min(len(names), NAMED)
    figure, ((panel,),) = sheet(1, 1, size + 0.6, size)
    panel.imshow(parts, cmap=SHADES, vmin=0, vmax=1)
    for row, line in enumerate(parts if len(names) <= NAMED else ()):
        for column, part in enumerate(line):
            if part:
                colour = "white" if part > DARK else INK
                panel.text(
                    column,
                    row,
                    f"{100 * part:.0f}",
                    ha="center",
                    va="center",
                    color=colour,
                    fontsize=9,
                )
    panel.set_xticks(range(len(names)), names, rotation=90)
    panel.set_yticks(range(len(names)), names)
    dressed(panel, "taken for", "written by", answers.question)
    _boxed(panel, len(names))
    return figure


def _boxed(panel: Axes, count: int) -> None:
    """Thin lines between the cells, and the cells of right answers in a frame."""
    panel.grid(False)
    for edge in np.arange(count + 1) - 0.5:
        panel.axhline(edge, color="#E6E6E6", linewidth=0.6)
        panel.axvline(edge, color="#E6E6E6", linewidth=0.6)
    for k in range(count):
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) / 2 + k
        panel.plot(*corners.T, color=INK, linewidth=1)
    panel.set_xlim(-0.5, count - 0.5)
    panel.set_ylim(count - 0.5, -0.5)


def _colour(answers: Answers) -> str:
    """By the way in which letters were made; real ones in the colour of children's ink."""
    return COLOURS.get(answers.question.split(",")[0], CHILD)


def _luck(luck: float) -> str:
    """A probability in plain numbers."""
    return f"{luck:.3f}" if luck < 0.1 else f"{luck:.2f}"
