"""Which marker of a take is the pen, also where Motive gave it another name in mid-take.

The markers of rigid bodies are no pens, and neither is one that stands still, though somebody bumped into it or a cell
is wrong. A marker that the cameras lose and find again may come back under another name: pieces that are never seen
together with the pen, and begin where and when it ends, or end where it begins, are joined to it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import islice

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.table import Key, Table, listed
from dmp_teach.trajectory import Array

PEN = 0.004  # a marker that stays within this much is no pen, however long it was seen [m]
BLOCK = 0.1  # a marker's way is seen in medians over this long, which no single cell can move [s]
STEP = 0.001  # from one of them to the next a pen moves more than this [m] ...
FEWEST_STEPS = 3  # ... so many times: a marker that somebody pushed moves once or twice
SHORT = 0.1  # gaps up to this long are filled without looking for other names, and nobody rests longer unseen [s]
LATEST = 0.5  # a marker that comes back later may be anything [s]
NEAR = 0.01  # so far from the place where it was lost [m] ...
FASTEST = 1.0  # ... and as far as a hand moves meanwhile [m/s] ...
SLOW = 0.2  # ... or one that is about to rest [m/s]
MOST_PIECES = 50  # names in one take
MOST_COLONS = 8  # in a marker's name
BODY_MARKER = re.compile(r"RigidBody \d+:Marker\d+")
NOT_ITS_OWN = re.compile(
    r"Unlabeled.*|.* \(\d+\)", re.DOTALL
)  # what follows a body's name, and is yet no part of it


@dataclass(frozen=True)
class Way:
    """Where a marker was seen: the frames' places in the table (K,), from 0, and its positions there (K, 3) [m]."""

    seen: np.ndarray
    points: Array


def pen_pieces(
    table: Table, t: Array, marker: str | None
) -> tuple[list[Key], list[Way], tuple[str, ...]]:
    """The marker that is the pen, the first of a list, and those that go on for it; and the names of all others.

    Args:
        table: The file.
        t: The times of its frames (T,) [s].
        marker: The marker's name; None takes, of all that are free and move most like a pen, the one seen most.

    Raises:
        RecordingError: No such marker, or two that could go on for it.
    """
    free = {key: j for key, j in table.markers.items() if not _is_of_a_body(key[0], table.bodies)}
    named = {key: j for key, j in table.markers.items() if key[0] == marker}
    pool = free if marker is None else named
    if not pool:
        names = listed(label for label, _ in (free or table.markers))
        wanted = "no marker that could be the pen" if marker is None else f"no marker {marker!r}"
        raise RecordingError(
            f"{table.name} has {wanted}. Markers that could be named with marker=...: {names}."
        )
    ways = _ways(table, free | pool)
    motion = {key: _motion(way, t) for key, way in ways.items()}
    chosen = max(pool, key=lambda key: (motion[key], len(ways[key].seen)))
    moving = {key for key in ways if motion[key] > 1}
    pieces = _joined(chosen, ways, moving, t, table) if motion[chosen] else [chosen]
    taken = {label for label, _ in pieces}
    others = tuple(dict.fromkeys(label for label, _ in free if label not in taken))
    return pieces, [ways[key] for key in pieces], others


def _is_of_a_body(label: str, bodies: frozenset[str]) -> bool:
    """Whether a marker is a part of a rigid body: `Robot:Marker1`, but not `Robot:Marker1 (2)`, which is another."""
    if BODY_MARKER.fullmatch(label):
        return True
    begins = [label[: colon.start()] for colon in islice(re.finditer(":", label), MOST_COLONS)]
    return any(
        body in bodies and not NOT_ITS_OWN.fullmatch(label[len(body) + 1 :]) for body in begins
    )


def _ways(table: Table, markers: dict[Key, dict[str, int]]) -> dict[Key, Way]:
    """Where each marker was seen; a cell that is no number counts as 0, for it is named if its marker is the pen."""
    columns = sorted(
        ((max(axes.values()), key, axes) for key, axes in markers.items()), key=lambda each: each[0]
    )
    seen: dict[Key, list[int]] = {key: [] for key in markers}
    points: dict[Key, list[list[float]]] = {key: [] for key in markers}
    for k, (_, row) in enumerate(table.body):
        for last, key, axes in columns:
            if last >= len(row):
                break
            if row[axes["X"]].strip():
                seen[key].append(k)
                points[key].append([_finite(row[axes[axis]]) for axis in "XYZ"])
    return {
        key: Way(np.array(seen[key], dtype=int), np.reshape(points[key], (-1, 3)) * table.scale)
        for key in markers
    }


def _finite(cell: str) -> float:
    """The number in a cell; 0 where there is none."""
    try:
        value = float(cell)
    except ValueError:
        return 0.0
    return value if abs(value) < 1e100 else 0.0


def _motion(way: Way, t: Array) -> int:
    """How much a marker moves like a pen.

    3: in several steps, seen in medians over short blocks of time; 2: in fewer, as a marker does that somebody pushed,
    or a very quick pen; 1: only in single samples, as where a cell is wrong; 0: not at all.
    """
    if not len(way.seen) or not (np.ptp(way.points, axis=0) > PEN).any():
        return 0
    block = np.floor((t[way.seen] - t[way.seen[0]]) / BLOCK)
    starts = np.flatnonzero(np.diff(block, prepend=-1))
    medians = np.array([np.median(part, axis=0) for part in np.split(way.points, starts[1:])])
    if not (np.ptp(medians, axis=0) > PEN).any():
        return 1
    steps = np.linalg.norm(np.diff(medians, axis=0), axis=1)
    return 3 if np.count_nonzero(steps > STEP) >= FEWEST_STEPS else 2


def _joined(
    chosen: Key, ways: dict[Key, Way], moving: set[Key], t: Array, table: Table
) -> list[Key]:
    """The pen's marker and all that go on for it, under other names; raise where two could."""
    pieces, whole = [chosen], ways[chosen]
    rest = sorted(
        (key for key, way in ways.items() if key != chosen and len(way.seen)),
        key=lambda k: k not in moving,
    )
    while len(pieces) < MOST_PIECES:
        fitting = [key for key in rest if _goes_on(whole, ways[key], key in moving, t)]
        if not fitting:
            break
        best = fitting[0]
        for rival in fitting[1:]:
            if (rival in moving) == (best in moving) and _meet(ways[best], ways[rival]):
                row, cells = table.body[max(ways[best].seen[0], ways[rival].seen[0])]
                raise RecordingError(
                    f"{table.name}, frame {cells[0]} (row {row}): {best[0]!r} and {rival[0]!r} could both be "
                    f"{chosen[0]!r} under another name; give the pen one name in Motive, or record again."
                )
        pieces.append(best)
        rest.remove(best)
        whole = _both(whole, ways[best])
    return pieces


def _goes_on(pen: Way, other: Way, moves: bool, t: Array) -> bool:
    """Whether a marker is the pen under another name.

    It is seen where the pen is not, all of it in one gap or at one end, and at an end of its own it is where the pen
    was or will be: exactly there, for one that stands still.
    """
    first, last = int(other.seen[0]), int(other.seen[-1])
    place = int(np.searchsorted(pen.seen, first))
    if place < len(pen.seen) and pen.seen[place] <= last:
        return False
    links = []
    if place > 0:
        links.append((t[first] - t[pen.seen[place - 1]], other.points[0] - pen.points[place - 1]))
    if place < len(pen.seen):
        links.append((t[pen.seen[place]] - t[last], pen.points[place] - other.points[-1]))
    if len(links) == 2 and t[pen.seen[place]] - t[pen.seen[place - 1]] <= SHORT:
        return False
    latest, fastest = (LATEST, FASTEST) if moves else (SHORT, SLOW)
    near = [
        np.linalg.norm(way) <= NEAR + fastest * seconds
        for seconds, way in links
        if seconds <= latest
    ]
    return bool(near) and all(near)


def _meet(one: Way, other: Way) -> bool:
    """Whether there is a time at which both are seen, or one between two sights of the other."""
    return bool(one.seen[0] <= other.seen[-1] and other.seen[0] <= one.seen[-1])


def _both(one: Way, other: Way) -> Way:
    """Two ways as one."""
    seen = np.concatenate([one.seen, other.seen])
    order = np.argsort(seen)
    return Way(seen[order], np.concatenate([one.points, other.points])[order])
