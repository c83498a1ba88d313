"""Columns of a pen's places, whatever program wrote them: which is what, and in which unit.

A column is known by its name, such as `x`, `pos_x [mm]`, `time (ms)` or `pressure`; without names
by its place and its numbers. The pen is up where a row has no place, where a column says so, where
the pressure is 0, or where nobody looked for a while. With a height z, and nothing else that tells,
strokes are found as in a motion capture. What was guessed is told in a note.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.flat_ink import PIXELS, FlatLetter, FlatStroke, flat_recordings
from dmp_teach.formats.motive.reader import labels_in, written
from dmp_teach.formats.motive.table import LONGEST_NAME
from dmp_teach.formats.motive.take import FEWEST_FRAMES
from dmp_teach.formats.registry import CaptureOptions
from dmp_teach.formats.units import METRES, PIXEL, SECONDS
from dmp_teach.ink import Recording
from dmp_teach.segmentation import Flags, find_runs
from dmp_teach.trajectory import Array

COLUMN_UNITS = METRES | SECONDS
WITH_UNIT = re.compile(r"(.+?)(?:\s+in\s+|[\s_/|-]*[\[({<]\s*|[\s_/|-]+)([a-zµ]+)\s*[\])}>]?")
PLACE_WORDS = (
    "(?:pos|position|coord|coordinate|pen|tip|ink|point|pose|marker|p|page|client|offset|screen)*"
)
COLUMN_ROLES = {
    "t": "t|times?|timestamps?|stamp|zeit|temps|tiempo|tempo|elapsed|clock|ms|s|secs?|seconds?",
    **{
        axis: f"{PLACE_WORDS}{axis}(?:pos|position|[ck]oord|[ck]oordinate|value)?" for axis in "xyz"
    },
    "force": "(?:pen|tip|normal)?(?:p|pressure|force|f|druck|press|pression|presion)",
    "down": "(?:is)?(?:pen|tip|touch|contact|button)?"
    "(?:down|state|status|switch|onpaper|event|type|eventtype)?",
    "up": "(?:is)?(?:pen)?(?:up|lifted|inair)",
    "stroke": "(?:stroke|trace|segment|path)s?(?:id|no|nr|num|number|index)?",
}
ON_SCREEN = re.compile("page|client|offset|screen")  # such columns are in pixels
# Of `pose.position.x` and `hand_x`, but not of a speed, a turn or a force.
LAST_WORDS = {
    axis: rf"(?!.*(?:vel|speed|acc|rot|orient|quat|force|torque|ang|twist|grad)).*[\W_]{axis}"
    for axis in "xyz"
}
FEWEST_ROWS = 5
MOSTLY_DOWN = 0.5  # in a column of 0 and 1 without a name, which else may mean anything
SLOWEST_STEP = 0.5  # from row to row [s]
USUAL_SIZE = (0.005, 1.0)  # of ink that is in metres, where nothing says so [m]
LOOKED_AWAY = (0.25, 10.0)  # a pause is longer than this [s], and so many usual steps
Y_UP = "Taken is that y points up the page."
LEAST_HEIGHT = 0.002  # a height that changes less tells no lift [m]
ColumnRoles = dict[str, tuple[int, float | None]]
"""Which column is what, and what its unit is in SI, or None."""


def read_columns(
    values: Array, names: Sequence[str] | None, file: str, options: CaptureOptions
) -> tuple[Recording, ...]:
    """Return the letter of a table.

    Args:
        values: A row of numbers each, shape (N, C); NaN where there is none.
        names: Of the columns, C of them; None where the file has none.
        file: The name of the file, which may tell the letter.
        options: How a pen in three dimensions looks at its page.

    Raises:
        RecordingError: No column for x and y, or rows that cannot be ink.
    """
    with np.errstate(all="ignore"):
        notes: list[str] = []
        roles = _named_roles(names) if names else _guessed_roles(values, notes)
        if not {"x", "y"} <= set(roles):
            shown = ", ".join(map(repr, (names or [])[:20])) or f"{values.shape[1]}, without names"
            raise RecordingError(
                f"is a table, but which columns are x and y? Its columns: {shown[:300]}. Name them "
                "in its first row: t, x, y, and z, pressure or pen where there is one."
            )
        columns = {role: values[:, column] for role, (column, _) in roles.items()}
        t = _seconds(columns.get("t"), roles, notes)
        xy, scale = _on_page(columns, roles, notes)
        parts = _parts(columns, t, xy, notes)
        if sum(b - a for a, b in parts) < FEWEST_ROWS:
            raise RecordingError(
                f"has fewer than {FEWEST_ROWS} rows in which the pen is down; save all of it."
            )
        about = labels_in(file)
        if "z" in columns and t is not None and len(parts) == 1:
            part, unit = slice(*parts[0]), scale or 1.0
            points = np.column_stack([xy * unit, columns["z"] * (roles["z"][1] or unit)])[part]
            if np.isfinite(points).all() and np.ptp(points[:, 2]) > LEAST_HEIGHT:
                return (_from_height(t[part], points, options, notes, about),)
        force = columns.get("force")
        force = None if force is None else np.nan_to_num(np.maximum(force, 0.0))
        strokes = [
            FlatStroke(xy[a:b], *(None if each is None else each[a:b] for each in (t, force)))
            for a, b in parts
        ]
        return flat_recordings([FlatLetter(strokes, *about, notes=tuple(notes))], scale)


def _named_roles(names: Sequence[str]) -> ColumnRoles:
    """Return the roles of columns with names; the first of each counts."""
    roles: ColumnRoles = {}
    for rules in (COLUMN_ROLES, LAST_WORDS):
        known = set(roles)
        for k, name in enumerate(names):
            words = name.strip().lower()[:LONGEST_NAME]
            match = WITH_UNIT.fullmatch(words)
            unit = COLUMN_UNITS.get(match[2]) if match else None
            bare = match[1] if match and unit else words
            if rules is COLUMN_ROLES:
                bare = "".join(re.findall("[a-z]+", bare))
            role = next((each for each, rule in rules.items() if re.fullmatch(rule, bare)), None)
            if role in roles and role in tuple("xyz") and role not in known:
                raise RecordingError(
                    f"has two columns for {role}, {names[roles[role][0]]!r} and {name!r}; leave "
                    "those of the pen in it."
                )
            if role in ("x", "y") and ON_SCREEN.search(bare):
                unit = PIXEL
            if bare and role is not None and role not in roles:
                # A column may be called "ms" and nothing else.
                roles[role] = (k, unit or (COLUMN_UNITS.get(bare) if role == "t" else None))
    return roles


def _guessed_roles(values: Array, notes: list[str]) -> ColumnRoles:
    """Return the roles of columns without names, by their numbers; told in a note."""
    rows, order = values[np.isfinite(values).all(axis=1)], list(range(values.shape[1]))
    if len(rows) < FEWEST_ROWS or not 2 <= len(order) <= 4:
        return {}
    found: dict[str, int] = {}
    if len(order) > 2:  # time is the first or the last, whichever goes on more evenly
        steps = {k: np.diff(rows[:, k]) for k in (0, order[-1])}
        uneven = {k: s.std() / s.mean() for k, s in steps.items() if (s >= 0).all() and s.any()}
        if uneven:
            found["t"] = min(uneven, key=lambda k: uneven[k])
            order.remove(found["t"])
    found |= dict(zip("xy", order, strict=False))
    if len(order) > 2:
        last = rows[:, order[2]]
        share = np.ptp(last) / max(np.ptp(rows[:, order[:2]], axis=0).max(), 1e-300)
        is_height = 0.02 < share < 2 and (last != np.round(last)).any()
        is_state = np.isin(last, (0, 1)).all()
        if len(order) > 3 or (is_state and last.mean() < MOSTLY_DOWN):
            return {}
        found["down" if is_state else "z" if is_height else "force"] = order[2]
    told = {"down": "pen down", "force": "pressure"}
    named = ", ".join(told.get(role, role) for role in sorted(found, key=lambda role: found[role]))
    notes.append(f"Its columns have no names: taken as {named}.")
    return {role: (column, None) for role, column in found.items()}


def _seconds(times: Array | None, roles: ColumnRoles, notes: list[str]) -> Array | None:
    """Return the times [s]; None where there are none, or they only count the rows."""
    if times is None:
        return None
    unit, step = roles["t"][1], np.diff(times[np.isfinite(times)])
    if not len(step):
        notes.append("Its times are no numbers: they are left out.")
        return None
    if unit is None and (step == 1).all():
        notes.append("Its times count the rows, and say no unit: they are left out.")
        return None
    if unit is None:
        usual = float(np.median(step))
        unit = next((each for each in (1.0, 1e-3, 1e-6, 1e-9) if each * usual < SLOWEST_STEP), 1.0)
        if unit != 1:
            notes.append(f"Its times say no unit: taken as {unit:g} s.")
    return times * unit


def _on_page(
    columns: dict[str, Array], roles: ColumnRoles, notes: list[str]
) -> tuple[Array, float | None]:
    """Return the places (N, 2), y up, and the metres in their unit; None where unknown."""
    xy = np.column_stack([columns["x"], columns["y"]])
    lost = (xy == -1).all(axis=1)
    if (xy[~lost] >= 0).all():
        xy[lost] = np.nan
    scale = roles["x"][1] or roles["y"][1]
    known = xy[np.isfinite(xy).all(axis=1)]
    size = float(np.ptp(known, axis=0).max()) if len(known) else 0.0
    if scale is None and USUAL_SIZE[0] <= size <= USUAL_SIZE[1]:
        scale = 1.0
        notes.append("The file says no unit of length: taken as metres.")
    if scale == PIXEL:
        notes += [PIXELS, "Taken is that y points down the screen."]
        return xy * [1, -1], scale
    notes.append(Y_UP)
    return xy, scale


def _parts(
    columns: dict[str, Array], t: Array | None, xy: Array, notes: list[str]
) -> list[tuple[int, int]]:
    """Return the runs of rows in which the pen is down."""
    known = xy if t is None else np.column_stack([xy, t])
    down: Flags = np.logical_and.reduce(np.isfinite(known), axis=1)
    if "down" in columns and np.isfinite(columns["down"]).any():
        # It stays as it was said last.
        said = np.where(np.isfinite(columns["down"]), np.arange(len(down)), 0)
        down &= columns["down"][np.maximum.accumulate(said)] > 0
    elif "up" in columns:
        down &= ~(columns["up"] > 0)
    elif "force" in columns and (columns["force"] > 0).any():
        down &= columns["force"] > 0
    cuts = np.empty(0, dtype=int)
    if "stroke" in columns:
        cuts = np.flatnonzero(np.diff(columns["stroke"])) + 1
    elif t is not None and "z" not in columns and len(find_runs(down)) == 1:
        step = np.diff(t)
        pause = max(LOOKED_AWAY[0], LOOKED_AWAY[1] * float(np.nanmedian(step)))
        cuts = np.flatnonzero(step > pause) + 1
        if len(cuts):
            notes.append(f"Where no row is for more than {pause:.2g} s, the pen is taken to be up.")
    return [
        part
        for a, b in find_runs(down)
        for part in pairwise([a, *cuts[(cuts > a) & (cuts < b)].tolist(), b])
    ]


def _from_height(
    t: Array,
    points: Array,
    options: CaptureOptions,
    notes: list[str],
    about: tuple[str | None, str | None],
) -> Recording:
    """Return the letter of a pen in three dimensions, cut to its strokes.

    Tables mostly have z out of the paper; else the axes of the options hold.
    """
    if len(t) < FEWEST_FRAMES or not (np.diff(t) > 0).all():
        raise RecordingError(
            f"has a height, for which it needs {FEWEST_FRAMES} rows or more, and times that "
            "increase from each to the next."
        )
    up, right = axes = options.up, options.right
    if axes == ("+y", "-x"):
        up, right = "+z", "+x"
    try:
        position, _, (start, end) = written(t, points, up, right)
    except RecordingError:
        if (up, right) == axes:
            raise
        up, right = axes
        position, _, (start, end) = written(t, points, up, right)
    notes.remove(Y_UP)
    notes.append(f"Taken is that {up} is out of the paper, and {right} to the right on it.")
    return Recording(t[start:end], position[start:end], *about, notes=tuple(notes))
