"""Figures of authorship: how often a letter's writer was found, and who was taken for whom."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from dmp_teach.arguments import checked
from dmp_teach.errors import SettingError
from dmp_teach.studies import Answers, Attributions
from dmp_teach.views.figures.figure_style import DrawStyle, add_legend_below, new_figure, style_axes
from dmp_teach.views.palette import (
    COMPARED_COLOR,
    GRID_COLOR,
    MUTED_COLOR,
    PERSON_COLOR,
    ROBOT_COLOR,
    TEXT_COLOR,
)

FORM_COLORS = {"DMP*": ROBOT_COLOR, "similarity": "#009E73", "original": COMPARED_COLOR}
SHARE_COLORS = LinearSegmentedColormap.from_list("answers", ["white", ROBOT_COLOR])
# A cell with a larger share is written on in white.
DARK_SHARE = 0.55
MAX_NUMBERED_WRITERS = 18


@checked
def draw_attribution_bars(*found: Attributions) -> Figure:
    """Draw a bar for each question: letters given to their writer, the interval, and chance.

    Args:
        found: From `classify_writers` and `attribute_made_letters`, in the order of the bars.

    Raises:
        SettingError: No question has an answer.
    """
    questions = [each for answers in found for each in answers if each.items]
    if not questions:
        raise SettingError(
            "Nothing was asked; give what classify_writers or attribute_made_letters found of "
            "several writers' letters."
        )
    figure, ((panel,),) = new_figure(1, 1, 8.2, 1.3 + 0.36 * len(questions))
    places = np.arange(len(questions))[::-1]
    _plot_bars(panel, places, questions)
    for place, each in zip(places, questions, strict=True):
        hits, count = each.right
        panel.text(
            1.02,
            place,
            f"{hits} of {count}, by luck {each.luck:.{3 if each.luck < 0.1 else 2}f}",
            transform=panel.get_yaxis_transform(),
            va="center",
            color=MUTED_COLOR,
            fontsize=9,
        )
    panel.set_yticks(places, [each.question for each in questions])
    panel.set_xlim(0, 100)
    panel.set_ylim(-0.6, len(questions) - 0.4)
    title = f"Whose letter is it? {len(questions[-1].writers)} writers"
    style_axes(panel, "given to their writer [%]", "", title)
    panel.grid(False, axis="y")
    add_legend_below(figure, panel)
    return figure


@checked
def draw_confusion(answers: Answers) -> Figure:
    """Draw a row for each writer, shaded by the share of his letters given to each writer [%].

    Args:
        answers: One question of `classify_writers` or `attribute_made_letters`.

    Raises:
        SettingError: The question has no answer.
    """
    if not answers.items:
        raise SettingError(
            f"{answers.question!r} could be asked of no letter, so there is nothing to draw."
        )
    names = answers.writers
    size = 1.8 + 0.44 * min(len(names), MAX_NUMBERED_WRITERS)
    figure, ((panel,),) = new_figure(1, 1, size + 0.6, size)
    panel.imshow(answers.confusion, cmap=SHARE_COLORS, vmin=0, vmax=1)
    if len(names) <= MAX_NUMBERED_WRITERS:
        for (row, column), share in np.ndenumerate(answers.confusion):
            if share:
                color = "white" if share > DARK_SHARE else TEXT_COLOR
                place = {"ha": "center", "va": "center"}
                panel.text(column, row, f"{100 * share:.0f}", color=color, fontsize=9, **place)
    panel.set_xticks(range(len(names)), names, rotation=90)
    panel.set_yticks(range(len(names)), names)
    style_axes(panel, "taken for", "written by", answers.question)
    _frame_cells(panel, len(names))
    return figure


def _plot_bars(panel: Axes, places: np.ndarray, questions: list[Answers]) -> None:
    """Plot the rates [%], their intervals and chance at these heights."""
    rates = 100 * np.array([each.rate for each in questions])
    intervals = 100 * np.array([each.interval for each in questions])
    chances = 100 * np.array([each.chance for each in questions])
    colors = [FORM_COLORS.get(each.question.split(",")[0], PERSON_COLOR) for each in questions]
    panel.barh(places, rates, 0.62, color=colors, alpha=0.85)
    label = "95 % interval, a writer counting as one answer"
    panel.hlines(places, *intervals.T, color=TEXT_COLOR, linewidth=1.4, label=label)
    dashes: DrawStyle = {"linestyle": (0, (2, 1.5)), "linewidth": 1.6}
    ends = (places - 0.42, places + 0.42)
    panel.vlines(chances, *ends, color=TEXT_COLOR, label="a guess", **dashes)


def _frame_cells(panel: Axes, count: int) -> None:
    """Draw thin lines between the cells, and frames round those of right answers."""
    panel.grid(False)
    for edge in np.arange(count + 1) - 0.5:
        panel.axhline(edge, color=GRID_COLOR, linewidth=0.6)
        panel.axvline(edge, color=GRID_COLOR, linewidth=0.6)
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) / 2
    for k in range(count):
        panel.plot(*(square + k).T, color=TEXT_COLOR, linewidth=1)
    panel.set_xlim(-0.5, count - 0.5)
    panel.set_ylim(count - 0.5, -0.5)
