"""The paper's figures of ink: letters as demonstrated and as written, in mm on the page."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.arguments import check_whole, checked
from dmp_teach.letters import resample_evenly
from dmp_teach.studies import GoalPaths, MadeLetter, MadeLetters, Redrawings, Redrawn
from dmp_teach.trajectory import Array, all_points, path_length
from dmp_teach.views.figures.figure_style import (
    REFUSED,
    RING_MARKER,
    DrawStyle,
    add_legend_below,
    label_millimetres,
    new_figure,
    plot_path,
    set_same_view,
    style_paper,
)
from dmp_teach.views.palette import (
    COMPARED_COLOR,
    MUTED_COLOR,
    PERSON_COLOR,
    ROBOT_COLOR,
    TEXT_COLOR,
)

DEMO_LOOK: DrawStyle = {
    "color": PERSON_COLOR,
    "linestyle": "",
    "marker": ".",
    "markersize": 4.5,
    "zorder": 3,
}
FORM_LOOKS: dict[str, DrawStyle] = {
    "DMP*": {"color": ROBOT_COLOR, "linestyle": "-"},
    "original": {"color": COMPARED_COLOR, "linestyle": "-."},
}
BAR_LOOK: DrawStyle = {"color": ROBOT_COLOR, "linestyle": "-"}
BOWL_LOOK: DrawStyle = {"color": "#E69F00", "linestyle": (0, (6, 1.2))}
# Ink that gets farther away than this many sizes of the letter is cut.
MAX_DISTANCE_IN_SIZES = 3.5

# More letters than this are no figure.
MOST_DRAWN = 1000


@checked
def draw_four_widths(redrawings: Redrawings, letter: int = 0) -> Figure:
    """Draw the paper's figure 5: one letter with four kernel widths.

    Args:
        redrawings: From `redraw_at_widths`.
        letter: Which letter of them, counted from 0.
    """
    names = list(dict.fromkeys(item.letter.name for item in redrawings.items))
    check_whole("letter", letter, 0, len(names) - 1)
    items = [item for item in redrawings.items if item.letter.name == names[letter]]
    items = items[: len({item.settings for item in items})]
    size = (3.1 * len(items), 3.5)
    figure, panels = new_figure(1, len(items), *size, sharex=True, sharey=True)
    for panel, item in zip(panels[0], items, strict=True):
        _plot_redrawn(panel, item)
        style_paper(panel, f"{item.settings}: {_format_millimetres(item.error)} mm")
    add_legend_below(figure, panels[0, 0])
    label_millimetres(panels)
    return figure


@checked
def draw_redrawn_letters(redrawings: Redrawings, most: int = 4) -> Figure:
    """Draw the paper's figure 9: letters as demonstrated and as DMP* wrote them, in one scale.

    One of each letter comes first.

    Args:
        redrawings: From `redraw_letters`.
        most: How many letters are drawn at most.
    """
    check_whole("most", most, 1, MOST_DRAWN)
    by_character = {item.letter.character: item for item in reversed(redrawings.items)}
    first = list(by_character.values())[::-1]
    items = (first + [item for item in redrawings.items if item not in first])[:most]
    boxes = []
    for item in items:
        points = 1e3 * all_points(item.letter.strokes)
        boxes.append((points.min(axis=0), points.max(axis=0)))
    tall = max(high[1] - low[1] for low, high in boxes)
    widths = [high[0] - low[0] + 0.1 * tall for low, high in boxes]
    across = sum(widths)
    size = min(4.5, max(2.6, 11 * tall / across)) if across > 0 else 3.0
    shape = (size * across / tall + 0.9, size + 1.5)
    figure, panels = new_figure(1, len(items), *shape, width_ratios=widths)
    is_compared = len({item.settings for item in items}) > 1
    for panel, item, (low, high) in zip(panels[0], items, boxes, strict=True):
        _plot_redrawn(panel, item)
        panel.set_xlim(low[0] - 0.05 * tall, high[0] + 0.05 * tall)
        panel.set_ylim(low[1] - 0.05 * tall, low[1] + 1.05 * tall)
        share = 100 * item.error / item.letter.size
        error = f"{_format_millimetres(item.error)} mm, {share:.{0 if share >= 1 else 1}f} %"
        how = f" {item.settings}:" if is_compared else ""
        style_paper(panel, f"‘{item.letter.character}’{how} {error}")
    add_legend_below(figure, panels[0, 0])
    label_millimetres(panels)
    return figure


@checked
def draw_goal_paths(paths: GoalPaths) -> Figure:
    """Draw the paper's figure 8: a letter with a moved goal, by DMP* and by the original form.

    Args:
        paths: From `draw_goal_change`.
    """
    in_mm = {name: 1e3 * path for name, path in paths.paths.items()}
    shown = in_mm["demonstration"]
    goal = shown[-1] + 1e3 * paths.shift
    forms = {name: look for name, look in FORM_LOOKS.items() if name in in_mm}
    every = [shown, goal[None], *(in_mm[name] for name in forms)]
    kept = np.concatenate([path for path in every if not _leaves(path, shown)])
    upright = np.ptp(kept[:, 1]) > np.ptp(kept[:, 0])
    shape = (1, len(forms), 8.0, 5.0) if upright else (len(forms), 1, 7.0, 6.4)
    figure, panels = new_figure(*shape, sharex=True, sharey=True)
    ring = RING_MARKER | {"linestyle": ""}
    for panel, name in zip(panels.flat, forms, strict=True):
        panel.plot(*_space_dots(shown).T, **DEMO_LOOK, label="demonstration")
        for form, look in forms.items():
            # Both forms, so that one legend explains them.
            path = in_mm[form] if form == name else np.full((1, 2), np.nan)
            panel.plot(*path.T, **look, linewidth=2, label=form)
        panel.plot(*shown[-1], color=MUTED_COLOR, label="old goal", **ring)
        panel.plot(*goal, color=TEXT_COLOR, mew=2.2, label="new goal", **ring)
        axes = [axis for axis, factor in zip("xy", paths.factor, strict=True) if factor < 0]
        mirrored = f", mirrored in {' and '.join(axes)}" if name == "original" and axes else ""
        style_paper(panel, name + mirrored + f"\n{REFUSED}" * (len(forms) == 1))
        _mark_leaving(panel, in_mm[name], shown)
    set_same_view(panels.flat, kept)
    add_legend_below(figure, panels.flat[0])
    label_millimetres(panels)
    return figure


@checked
def draw_d_to_p(made: MadeLetters, most: int = 3) -> Figure:
    """Draw the paper's figure 10: D as demonstrated, and the P that each transformation makes.

    Args:
        made: From `make_p_from_d`.
        most: How many writers are drawn at most.
    """
    check_whole("most", most, 1, MOST_DRAWN)
    sources = [item.source for item in made.by(made.ways[0])][:most]
    columns = 1 + len(made.ways)
    figure, panels = new_figure(len(sources), columns, 2.7 * columns, 3.2 * len(sources) + 0.4)
    for number, (row, source) in enumerate(zip(panels, sources, strict=True)):
        shown = 1e3 * all_points(source.strokes)
        for stroke in source.strokes:
            row[0].plot(*_space_dots(1e3 * stroke.position).T, **DEMO_LOOK)
        style_paper(row[0], f"{source.name}, {'of ours' if made.borrowed else 'as shown'}")
        kept = [shown]
        for panel, way in zip(row[1:], made.ways, strict=True):
            item = made.by(way)[number]
            _plot_made(panel, item)
            style_paper(panel, f"{way}: {'a P' if item.recognisable else 'no P'}")
            if item.strokes is not None:
                drawn = 1e3 * all_points(item.strokes)
                _mark_leaving(panel, drawn, shown)
                kept += [] if _leaves(drawn, shown) else [drawn]
        set_same_view(row, np.concatenate(kept))
    label_millimetres(panels)
    return figure


def _plot_made(panel: Axes, item: MadeLetter) -> None:
    """Plot a made letter: bar blue, bowl orange and dashed, its new end as a ring."""
    if item.strokes is None:
        panel.text(0.5, 0.5, "refused", transform=panel.transAxes, ha="center", color=MUTED_COLOR)
        return
    for number, stroke in enumerate(item.strokes):
        look = BOWL_LOOK if number == item.bowl else BAR_LOOK
        plot_path(panel, stroke.position, linewidth=2.2, **look)
    plot_path(panel, item.target[None], color=TEXT_COLOR, mew=1.6, **RING_MARKER)


def _plot_redrawn(panel: Axes, item: Redrawn) -> None:
    """Plot dots where a letter was demonstrated, and lines where it was written."""
    for number, stroke in enumerate(item.letter.strokes):
        label = "" if number else "as it was shown"
        panel.plot(*_space_dots(1e3 * stroke.position).T, **DEMO_LOOK, label=label)
    for number, stroke in enumerate(item.drawn or ()):
        label = "" if number else "as it was drawn"
        plot_path(panel, stroke.position, color=ROBOT_COLOR, linewidth=1.8, label=label)


def _space_dots(path: Array) -> Array:
    """Return points of a path [mm] at equal arc lengths, 3 % of its size apart."""
    spacing = max(np.ptp(path, axis=0).max() * 0.03, 1e-9)
    return resample_evenly(path, max(2, round(path_length(path) / spacing)))[0]


def _leaves(path: Array, shown: Array) -> bool:
    """Return whether a path gets farther than `MAX_DISTANCE_IN_SIZES` of the letter [mm]."""
    distance = np.abs(path - shown.mean(axis=0)).max()
    return bool(distance > MAX_DISTANCE_IN_SIZES * np.ptp(shown, axis=0).max())


def _mark_leaving(panel: Axes, path: Array, shown: Array) -> None:
    """Say how far the ink goes where it leaves the panel."""
    if _leaves(path, shown):
        away = np.linalg.norm(path - shown.mean(axis=0), axis=1).max()
        length = f"{away / 1e3:.2g} m" if away >= 1e3 else f"{away:.0f} mm"
        look: DrawStyle = {"transform": panel.transAxes, "ha": "right", "color": MUTED_COLOR}
        panel.text(0.97, 0.03, f"leaves the page: {length}", **look)


def _format_millimetres(length: float) -> str:
    """Return a length [m] in mm with two digits that count."""
    mm = 1e3 * length
    return f"{mm:.2g}" if mm < 9.95 else f"{mm:.0f}"
