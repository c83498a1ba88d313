"""What a class has done, as a page to look at or to print: made of data, escaped by its tree."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path
from statistics import mean, median
from typing import Self
from xml.etree.ElementTree import Element, SubElement, tostring

import numpy as np

from dmp_teach.classroom.lesson.bets import Bet, ChosenBet, DrawnBet
from dmp_teach.classroom.lesson.class_files import LessonRecord, PupilRecord
from dmp_teach.errors import SettingError, TeachError, shown
from dmp_teach.files import join_styles, write_whole
from dmp_teach.ink import recording_of
from dmp_teach.scoring import score
from dmp_teach.texts import gettext as _
from dmp_teach.trajectory import Array
from dmp_teach.views import STYLE_TOKENS

_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>dmp_teach</title>
</head>
<body>
{body}
</body>
</html>
"""
MOST_NOTES, LONGEST_NOTE = 100, 300
_WIDE, _HIGH, _EDGE = 300, 110, 20


@dataclass(frozen=True, repr=False)
class ClassOverview:
    """A class at a glance: shown below a cell, or as a page.

    Args:
        pupils: In order.
        lessons: Title and bet of each lesson that somebody has begun, by its number.
        notes: On files that cannot be used.
    """

    pupils: tuple[PupilRecord, ...]
    lessons: Mapping[str, tuple[str, Bet]]
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Return one line."""
        counts = f"{len(self.pupils)} pupils, {len(self.lessons)} lessons"
        return f"ClassOverview({counts}, {len(self.notes)} notes)"

    def html(self, path: str | PathLike[str]) -> Path:
        """Write a page that loads nothing and runs nothing, for a browser and for A4.

        Raises:
            PathError: A name that does not end with .html, or a place that cannot be written.
        """
        return write_whole(path, _PAGE.format(body=self._repr_html_()).encode(), ".html")

    def forget(self, pupil: str) -> Self:
        """Remove every file of a pupil, and return the overview of the others.

        Pages that were written before still have the pupil: write them again.

        Raises:
            SettingError: There is no such pupil.
            OSError: A file cannot be removed.
        """
        gone = next((each for each in self.pupils if each.name == pupil), None)
        if gone is None:
            names = ", ".join(each.name for each in self.pupils)
            raise SettingError(f"There is no pupil {shown(pupil)}; there are: {names}.")
        gone.forget()
        return replace(self, pupils=tuple(each for each in self.pupils if each is not gone))

    def records(self, key: str) -> list[LessonRecord]:
        """Return what each pupil who has begun a lesson did in it."""
        return [each.lessons[key] for each in self.pupils if key in each.lessons]

    def _repr_html_(self) -> str:
        """Return the page's content, every text of a file escaped."""
        root = Element("div", {"class": "dt-panel dt-class"})
        words = _("The class: {pupils} pupils, {lessons} lessons")
        _add(root, "h1", words.format(pupils=len(self.pupils), lessons=len(self.lessons)))
        for draw in (_draw_places, _draw_checks, _draw_letters, _draw_bets, _draw_notes):
            draw(root, self)
        style = join_styles(STYLE_TOKENS, Path(__file__).with_name("overview.css"))
        return f"<style>\n{style}</style>\n{tostring(root, encoding='unicode', method='html')}"


def _add(parent: Element, tag: str, text: object = "", kind: str = "", **more: object) -> Element:
    """Return a new element; what cannot be printed of a text is not."""
    attributes = {name: str(value) for name, value in more.items()}
    child = SubElement(parent, tag, {"class": f"dt-class-{kind}"} if kind else {}, **attributes)
    child.text = "".join(
        sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in str(text)
    )
    return child


def _add_table(parent: Element, heads: Iterable[str], kind: str = "") -> Element:
    """Return a new table's body below its heads."""
    table = _add(parent, "table", kind=kind)
    row = _add(_add(table, "thead"), "tr")
    for head in heads:
        _add(row, "th", head, scope="col")
    return _add(table, "tbody")


def _add_row(body: Element, cells: Sequence[object], share: float | None = None) -> None:
    """Add a row, whose first cell is its head, with a bar at its end."""
    row = _add(body, "tr")
    _add(row, "th", cells[0], scope="row")
    for cell in cells[1:]:
        _add(row, "td", cell)
    if share is not None:
        _add(_add(row, "td", kind="bar"), "div", style=f"width: {100 * share:.0f}%")


def _draw_places(root: Element, told: ClassOverview) -> None:
    """Draw who is where."""
    _add(root, "h2", _("Who is where"))
    words = _(
        "The step of the lesson, ✓ where its check is passed; then how many checks did not pass "
        "(×), and how many hints were seen (?)."
    )
    _add(root, "p", words, "quiet")
    steps = {"bet": _("bet"), "try": _("try"), "challenge": _("check")}
    body = _add_table(root, [_("Pupil"), *told.lessons], "where")
    for pupil in told.pupils:
        row = _add(body, "tr")
        _add(row, "th", pupil.name, scope="row")
        for key in told.lessons:
            record = pupil.lessons.get(key)
            if record is None:
                _add(row, "td")
                continue
            step = "✓" if record.is_passed else steps[record.step]
            cell = _add(row, "td", step, "passed" if record.is_passed else "")
            counts = ((record.misses, "×"), (record.hints, "?"))
            if few := " ".join(f"{n}{sign}" for n, sign in counts if n):
                _add(cell, "small", few)


def _draw_checks(root: Element, told: ClassOverview) -> None:
    """Draw which checks are hard, the hardest first."""
    found = {}
    for key in told.lessons:
        came = [each for each in told.records(key) if each.is_passed or each.misses]
        if came:
            found[key] = (mean(each.misses for each in came), came)
    if not found:
        return
    _add(root, "h2", _("Which checks are hard"))
    words = _(
        "How many pupils have begun, checked and passed; hints seen and checks not passed are "
        "averages of those who have checked."
    )
    _add(root, "p", words, "quiet")
    heads = [
        _("Lesson"),
        "",
        _("begun"),
        _("checked"),
        _("passed"),
        _("hints seen"),
        _("not passed"),
    ]
    body = _add_table(root, [*heads, ""])
    most = max(misses for misses, _came in found.values()) or 1
    for key, (misses, came) in sorted(found.items(), key=lambda each: -each[1][0]):
        passed, hints = sum(each.is_passed for each in came), mean(each.hints for each in came)
        counts = (len(told.records(key)), len(came), passed, f"{hints:.1f}", f"{misses:.1f}")
        _add_row(body, (key, told.lessons[key][0], *counts), misses / most)


def _draw_letters(root: Element, told: ClassOverview) -> None:
    """Draw how far the newest try at each letter is from ours, the farthest first."""
    far: dict[str, list[float]] = {}
    tries: Counter[str] = Counter()
    for pupil in told.pupils:
        for letter, recording in pupil.ink.items():
            try:
                apart = 1000 * score(recording, recording_of(letter)).distance
            except TeachError:
                continue
            far.setdefault(letter, []).append(apart)
            tries[letter] += pupil.attempts[letter]
    if not far:
        return
    _add(root, "h2", _("Which letters are hard"))
    words = _("How far the newest try that was saved is from our letter: median of the class.")
    _add(root, "p", words, "quiet")
    heads = [_("Letter"), _("pupils"), _("saved tries"), _("far off")]
    body = _add_table(root, [*heads, ""])
    middles = {letter: median(apart) for letter, apart in far.items()}
    for letter in sorted(middles, key=lambda letter: -middles[letter]):
        counts = (len(far[letter]), tries[letter], f"{middles[letter]:.1f} mm")
        _add_row(body, (letter, *counts), middles[letter] / (max(middles.values()) or 1))


def _draw_bets(root: Element, told: ClassOverview) -> None:
    """Draw the spread of bets, lesson by lesson."""
    _add(root, "h2", _("What the class bets"))
    words = _("A thin line is one pupil’s, the thick one the median. Letters differ by pupil.")
    _add(root, "p", words, "quiet")
    cards = _add(root, "div", kind="bets")
    for key, (title, bet) in told.lessons.items():
        bets = []
        for record in told.records(key):
            try:
                bets.append(bet.checked(record.bet))
            except SettingError:
                continue
        if not bets:
            continue
        card = _add(cards, "section")
        _add(card, "h3", f"{key} {title}")
        _add(card, "p", bet.question, "quiet")
        if isinstance(bet, ChosenBet):
            body = _add_table(card, ())
            for option, said in bet.options.items():
                _add_row(body, (said, bets.count(option)), bets.count(option) / len(bets))
        else:
            _draw_lines(card, bet, np.array(bets))


def _draw_lines(card: Element, bet: DrawnBet, bets: Array) -> None:
    """Draw bets of shape (N, K, 2) as lines, with their median."""
    is_curve = bet.axis == "y"
    lines = bets.copy()
    if is_curve:
        lines[..., 0] = np.arange(bets.shape[1])
    # A far one does not press the others together.
    low, high = np.percentile(lines, [5, 95], axis=(0, 1))
    low, high = (lines.min((0, 1)), lines.max((0, 1))) if is_curve else (low, high)
    span = np.maximum(high - low, 1e-9)
    size = np.array([_WIDE, _HIGH]) if is_curve else np.full(2, min(_WIDE, 2 * _HIGH))
    scale = size / span if is_curve else np.full(2, (size / span.max()).min())
    places = np.clip((lines - low) * scale, -_EDGE, size + _EDGE)
    height = size[1] if is_curve else span[1] * scale[1]
    places[..., 1] = height - places[..., 1]
    box = f"{-_EDGE} {-_EDGE} {_WIDE + 2 * _EDGE} {height + 3 * _EDGE:.0f}"
    svg = _add(card, "svg", viewBox=box, role="img", **{"aria-label": _("The bets as lines")})
    middle = np.median(places, axis=0)
    for line in places:
        _add(svg, "polyline", points=_points(line))
    _add(svg, "polyline", kind="middle", points=_points(middle))
    if is_curve:
        _add(svg, "line", x1=0, x2=_WIDE, y1=height, y2=height)
        for (x, y), (_at, value), (at, _y) in zip(
            middle, np.median(bets, axis=0), bets[0], strict=True
        ):
            _add(svg, "text", f"{value:.3g}", x=f"{x:.0f}", y=f"{y - 6:.0f}")
            _add(svg, "text", f"{at:g}", x=f"{x:.0f}", y=f"{height + 16:.0f}")
        ends = {"first": bet.labels[0], "last": bet.labels[-1], "unit": bet.unit or "–"}
        _add(card, "p", _("From “{first}” to “{last}”, in {unit}.").format(**ends), "quiet")


def _points(line: Array) -> str:
    """Return places as SVG wants them."""
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in line)


def _draw_notes(root: Element, told: ClassOverview) -> None:
    """List the files that cannot be used."""
    if told.notes:
        _add(root, "h2", _("Not read"))
        items = _add(root, "ul", kind="quiet")
        for note in told.notes[:MOST_NOTES]:
            _add(items, "li", note[:LONGEST_NOTE])
        if (more := len(told.notes) - MOST_NOTES) > 0:
            _add(items, "li", _("And {more} more.").format(more=more))
