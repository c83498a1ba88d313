"""The paper's figures of ink: letters as they were shown and as they were drawn, in mm on the page."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dmp_teach.studies import GoalPaths, MadeLetter, MadeLetters, Redrawings, Redrawn
from dmp_teach.trajectory import Array, Trajectory, ways
from dmp_teach.views.figures.figure_style import (
    CHILD,
    INK,
    OTHER,
    QUIET,
    ROBOT,
    explained_below,
    paper,
    same_view,
    sheet,
)

SHOWN = {"color": CHILD, "linestyle": "", "marker": ".", "markersize": 4.5, "zorder": 3}
SECOND = "#E69F00"  # the paper's second stroke
FAR = 3.5  # ink that gets farther than so many sizes of the letter flies off, and is cut
FORMS = (("DMP*", ROBOT, "-"), ("original", OTHER, "-."))


def four_widths_drawn(redrawings: Redrawings, letter: int = 0) -> Figure:
    """The paper's figure 4: one letter with four kernel widths.

    Args:
        redrawings: From `four_widths`.
        letter: Which letter of them, counted from 0.
    """
    names = list(dict.fromkeys(item.letter.name for item in redrawings.items))
    items = [item for item in redrawings.items if item.letter.name == names[letter]]
    widths = len({item.settings for item in items})
    items = items[:widths]
    figure, panels = sheet(1, len(items), 3.1 * len(items), 3.5, sharex=True, sharey=True)
    for panel, item in zip(panels[0], items, strict=True):
        _redrawn(panel, item)
        paper(panel, f"{item.settings}: {_shown(1e3 * item.error)} mm")
    explained_below(figure, panels[0, 0])
    return _labelled(figure, panels)


def letters_redrawn(redrawings: Redrawings, most: int = 4) -> Figure:
    """The paper's figure 8: letters as they were shown, and as DMP* drew them, all in one scale; one of each first.

    Args:
        redrawings: From `redrawn`.
        most: How many letters are drawn at most.
    """
    first = list({item.letter.character: item for item in reversed(redrawings.items)}.values())[
        ::-1
    ]
    items = (first + [item for item in redrawings.items if item not in first])[:most]
    corners = [_corners(item.letter.strokes) for item in items]
    tall = max(high[1] - low[1] for low, high in corners)
    wide = [high[0] - low[0] + 0.1 * tall for low, high in corners]
    size = max(2.6, 11 * tall / sum(wide)) if sum(wide) > 0 else 3.0
    size = min(size, 4.5)
    figure, panels = sheet(
        1, len(items), size * sum(wide) / tall + 0.9, size + 1.5, width_ratios=wide
    )
    for panel, item, (low, high) in zip(panels[0], items, corners, strict=True):
        _redrawn(panel, item)
        panel.set_xlim(low[0] - 0.05 * tall, high[0] + 0.05 * tall)
        panel.set_ylim(low[1] - 0.05 * tall, low[1] + 1.05 * tall)
        part = 100 * item.error / item.letter.size
        paper(panel, f"‘{item.letter.character}’ {_shown(1e3 * item.error)} mm, {part:.1g} %")
    explained_below(figure, panels[0, 0])
    return _labelled(figure, panels)


def goal_change_drawn(paths: GoalPaths) -> Figure:
    """The paper's figure 7: a letter whose goal moved, by DMP* and by the original form, in one scale.

    Args:
        paths: From `goal_paths`.
    """
    shown = 1e3 * paths.paths["demonstration"]
    goal = shown[-1] + 1e3 * paths.shift
    seen = [shown, goal[None], *(1e3 * paths.paths[name] for name in ("DMP*", "original"))]
    kept = np.concatenate([each for each in seen if not _flies(each, shown)])
    upright = np.ptp(kept[:, 1]) > np.ptp(kept[:, 0])
    rows, columns = (1, 2) if upright else (2, 1)
    figure, panels = sheet(
        rows, columns, 8.0 if upright else 7.0, 5.0 if upright else 6.4, sharex=True, sharey=True
    )
    ring = {"marker": "o", "markersize": 9, "markerfacecolor": "none", "linestyle": ""}
    for panel, (name, _, _) in zip(panels.flat, FORMS, strict=True):
        drawn = 1e3 * paths.paths[name]
        panel.plot(*_dots(shown).T, **SHOWN, label="demonstration")
        for each, hue, style in FORMS:  # both, so that one legend explains them
            path = drawn if each == name else np.full((1, 2), np.nan)
            panel.plot(*path.T, color=hue, linestyle=style, linewidth=2, label=each)
        panel.plot(*shown[-1], color=QUIET, label="old goal", **ring)
        panel.plot(*goal, color=INK, mew=2.2, label="new goal", **ring)
        over = [axis for axis, factor in zip("xy", paths.factor, strict=True) if factor < 0]
        said = f", mirrored in {' and '.join(over)}" if name == "original" and over else ""
        paper(panel, f"{name}{said}")
        _say_that_it_flies(panel, drawn, shown)
    same_view(panels.flat, kept)
    explained_below(figure, panels.flat[0])
    return _labelled(figure, panels)


def d_to_p(made: MadeLetters, most: int = 3) -> Figure:
    """The paper's figure 9: D as it was shown, and the P that each transformation makes of it.

    Args:
        made: From `p_from_d`.
        most: How many writers are drawn at most.
    """
    sources = [item.source for item in made.by(made.ways[0])][:most]
    figure, panels = sheet(
        len(sources), 1 + len(made.ways), 2.7 * (1 + len(made.ways)), 3.2 * len(sources) + 0.4
    )
    for number, (row, source) in enumerate(zip(panels, sources, strict=True)):
        shown = 1e3 * np.concatenate([stroke.position for stroke in source.strokes])
        for stroke in source.strokes:
            row[0].plot(*_dots(1e3 * stroke.position).T, **SHOWN)
        paper(row[0], f"{source.name}, as shown")
        kept = [shown]
        for panel, way in zip(row[1:], made.ways, strict=True):
            item = made.by(way)[number]
            _made(panel, item)
            paper(panel, f"{way}: {'a P' if item.recognisable else 'no P'}")
            if item.strokes is not None:
                drawn = 1e3 * np.concatenate([stroke.position for stroke in item.strokes])
                _say_that_it_flies(panel, drawn, shown)
                kept += [] if _flies(drawn, shown) else [drawn]
        same_view(row, np.concatenate(kept))
    return _labelled(figure, panels)


def _made(panel: Axes, item: MadeLetter) -> None:
    """A made letter: bar blue, bowl orange and dashed, its new end as a ring."""
    if item.strokes is None:
        panel.text(0.5, 0.5, "refused", transform=panel.transAxes, ha="center", color=QUIET)
        return
    looks = {item.bar: (ROBOT, "-"), item.bowl: (SECOND, (0, (6, 1.2)))}
    for number, stroke in enumerate(item.strokes):
        colour, line = looks.get(number, (ROBOT, "-"))
        panel.plot(*(1e3 * stroke.position).T, color=colour, linestyle=line, linewidth=2.2)
    panel.plot(
        *(1e3 * item.target), marker="o", markersize=9, markerfacecolor="none", color=INK, mew=1.6
    )


def _redrawn(panel: Axes, item: Redrawn) -> None:
    """Dots as shown, a line as drawn."""
    for number, shown in enumerate(item.letter.strokes):
        panel.plot(
            *_dots(1e3 * shown.position).T, **SHOWN, label="" if number else "as it was shown"
        )
    for number, drawn in enumerate(item.drawn or ()):
        panel.plot(
            *(1e3 * drawn.position).T,
            color=ROBOT,
            linewidth=1.8,
            label="" if number else "as it was drawn",
        )


def _dots(path: Array) -> Array:
    """Points of a path [mm] at equal ways, as far apart as a twentieth of its size or so: beads on a thread."""
    way = ways(path)
    number = max(2, round(way[-1] / max(np.ptp(path, axis=0).max() * 0.03, 1e-9)))
    return np.column_stack(
        [np.interp(np.linspace(0, way[-1], number), way, axis) for axis in path.T]
    )


def _corners(strokes: Sequence[Trajectory]) -> tuple[Array, Array]:
    """The lower left and the upper right corner of strokes [mm]."""
    points = 1e3 * np.concatenate([stroke.position for stroke in strokes])
    return points.min(axis=0), points.max(axis=0)


def _flies(drawn: Array, shown: Array) -> bool:
    """Whether a drawing leaves the paper: it gets farther than `FAR` sizes of the letter."""
    return float(np.abs(drawn - shown.mean(axis=0)).max()) > FAR * float(
        np.ptp(shown, axis=0).max()
    )


def _say_that_it_flies(panel: Axes, drawn: Array, shown: Array) -> None:
    """A word where the ink leaves the panel: how far it goes."""
    if _flies(drawn, shown):
        away = float(np.linalg.norm(drawn - shown.mean(axis=0), axis=1).max())
        length = f"{away / 1e3:.2g} m" if away >= 1e3 else f"{away:.0f} mm"
        panel.text(
            0.97,
            0.03,
            f"leaves the page: {length}",
            transform=panel.transAxes,
            ha="right",
            color=QUIET,
        )


def _labelled(figure: Figure, panels: Sequence) -> Figure:
    """Axes in mm, named once: at the left and at the bottom."""
    for panel in np.asarray(panels)[:, 0]:
        panel.set_ylabel("y, up the page [mm]", color=INK, fontsize=10)
    for panel in np.asarray(panels)[-1]:
        panel.set_xlabel("x, to the right [mm]", color=INK, fontsize=10)
    return figure


def _shown(millimetres: float) -> str:
    """A length in mm with two digits that count."""
    return f"{millimetres:.2g}" if millimetres < 9.95 else f"{millimetres:.0f}"
