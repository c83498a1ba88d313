"""Which marker of a take is the pen, also where Motive gave it another name in mid-take.

The markers of rigid bodies are no pens, and neither is one that stands still, though somebody
bumped into it or a cell is wrong. A marker that the cameras lose and find again may come back under
another name: pieces that are never seen together with the pen, and begin where and when it ends, or
end where it begins, are joined to it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import islice

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.table import MarkerKey, Table, list_names
from dmp_teach.trajectory import Array

PEN_RANGE = 0.004  # a marker that stays within this much is no pen, however long it was seen [m]
MEDIAN_BLOCK = 0.1  # a track is judged by medians over this long, which no single cell can move [s]
MEDIAN_STEP = 0.001  # a pen moves more than this from one of them to the next ... [m]
FEWEST_STEPS = 3  # ... at least this often: a marker that was pushed moves once or twice
# Gaps up to this long are filled without looking for other names, and no pen rests longer unseen.
FILLED_GAP = 0.1  # [s]
LATEST_RETURN = 0.5  # a marker that comes back later may be anything [s]
REJOIN_RADIUS = 0.01  # a marker comes back this near to where it was lost ... [m]
HAND_SPEED = 1.0  # ... or as far as a hand moves meanwhile ... [m/s]
RESTING_SPEED = 0.2  # ... or a hand that is about to rest [m/s]
MOST_PIECES = 50  # names in one take
MOST_COLONS = 8  # in a marker's name
BODY_MARKER = re.compile(r"RigidBody \d+:Marker\d+")
# What may follow a body's name in the name of a marker that is no part of it.
NOT_ITS_OWN = re.compile(r"Unlabeled.*|.* \(\d+\)", re.DOTALL)


@dataclass(frozen=True)
class Track:
    """Where a marker was seen.

    Args:
        seen: The frames' places in the table, from 0, shape (K,).
        points: Its positions there, shape (K, 3) [m].
    """

    seen: np.ndarray
    points: Array


Tracks = dict[MarkerKey, Track]


def find_pen_tracks(
    table: Table, t: Array, marker: str | None
) -> tuple[list[MarkerKey], list[Track], tuple[str, ...]]:
    """Find the marker that is the pen, the markers that go on for it, and the names of all others.

    Args:
        table: The file.
        t: The times of its frames (T,) [s].
        marker: The marker's name; None takes, of all that are free and move most like a pen, the
            one seen most.

    Raises:
        RecordingError: No such marker, or two that could go on for it.
    """
    free = {key: j for key, j in table.markers.items() if not _is_of_a_body(key[0], table.bodies)}
    named = {key: j for key, j in table.markers.items() if key[0] == marker}
    pool = free if marker is None else named
    if not pool:
        names = list_names(label for label, _ in (free or table.markers))
        wanted = "no marker that could be the pen" if marker is None else f"no marker {marker!r}"
        raise RecordingError(
            f"{table.name} has {wanted}. Markers that could be named with marker=...: {names}."
        )
    tracks = _tracks(table, free | pool)
    motion = {key: _pen_likeness(track, t) for key, track in tracks.items()}
    chosen = max(pool, key=lambda key: (motion[key], len(tracks[key].seen)))
    moving = {key for key in tracks if motion[key] > 1}
    pieces = _join_names(chosen, tracks, moving, t, table) if motion[chosen] else [chosen]
    taken = {label for label, _ in pieces}
    others = tuple(dict.fromkeys(label for label, _ in free if label not in taken))
    return pieces, [tracks[key] for key in pieces], others


def _is_of_a_body(label: str, bodies: frozenset[str]) -> bool:
    """Tell whether a marker is a part of a rigid body: `Robot:Marker1`, not `Robot:Marker1 (2)`."""
    if BODY_MARKER.fullmatch(label):
        return True
    begins = [label[: colon.start()] for colon in islice(re.finditer(":", label), MOST_COLONS)]
    return any(
        body in bodies and not NOT_ITS_OWN.fullmatch(label[len(body) + 1 :]) for body in begins
    )


def _tracks(table: Table, markers: dict[MarkerKey, dict[str, int]]) -> Tracks:
    """Return where each marker was seen; a cell that is no number counts as 0 for now."""
    columns = sorted(
        ((max(axes.values()), key, axes) for key, axes in markers.items()), key=lambda each: each[0]
    )
    seen: dict[MarkerKey, list[int]] = {key: [] for key in markers}
    points: dict[MarkerKey, list[list[float]]] = {key: [] for key in markers}
    for k, (_, row) in enumerate(table.body):
        for last, key, axes in columns:
            if last >= len(row):
                break
            if row[axes["X"]].strip():
                seen[key].append(k)
                points[key].append([_finite(row[axes[axis]]) for axis in "XYZ"])
    return {
        key: Track(np.array(seen[key], dtype=int), np.reshape(points[key], (-1, 3)) * table.scale)
        for key in markers
    }


def _finite(cell: str) -> float:
    """Return the number in a cell; 0 where there is none."""
    try:
        value = float(cell)
    except ValueError:
        return 0.0
    return value if abs(value) < 1e100 else 0.0


def _pen_likeness(track: Track, t: Array) -> int:
    """Grade how much a marker moves like a pen, 0 to 3.

    3: in several steps, seen in medians over short blocks of time; 2: in fewer, as a marker does
    that was pushed, or a very quick pen; 1: only in single samples, as where a cell is wrong; 0:
    not at all.
    """
    if not len(track.seen) or not (np.ptp(track.points, axis=0) > PEN_RANGE).any():
        return 0
    block = np.floor((t[track.seen] - t[track.seen[0]]) / MEDIAN_BLOCK)
    starts = np.flatnonzero(np.diff(block, prepend=-1))
    medians = np.array([np.median(part, axis=0) for part in np.split(track.points, starts[1:])])
    if not (np.ptp(medians, axis=0) > PEN_RANGE).any():
        return 1
    steps = np.linalg.norm(np.diff(medians, axis=0), axis=1)
    return 3 if np.count_nonzero(steps > MEDIAN_STEP) >= FEWEST_STEPS else 2


def _join_names(
    chosen: MarkerKey,
    tracks: dict[MarkerKey, Track],
    moving: set[MarkerKey],
    t: Array,
    table: Table,
) -> list[MarkerKey]:
    """Return the pen's marker and all that go on for it; raise where two of them could."""
    pieces, whole = [chosen], tracks[chosen]
    rest = sorted(
        (key for key, track in tracks.items() if key != chosen and len(track.seen)),
        key=lambda k: k not in moving,
    )
    while len(pieces) < MOST_PIECES:
        fitting = [key for key in rest if _goes_on(whole, tracks[key], key in moving, t)]
        if not fitting:
            break
        best = fitting[0]
        for rival in fitting[1:]:
            if (rival in moving) == (best in moving) and _meet(tracks[best], tracks[rival]):
                row, cells = table.body[max(tracks[best].seen[0], tracks[rival].seen[0])]
                raise RecordingError(
                    f"{table.name}, frame {cells[0]} (row {row}): {best[0]!r} and {rival[0]!r} "
                    "could both be "
                    f"{chosen[0]!r} under another name; give the pen one name in Motive, or "
                    "record again."
                )
        pieces.append(best)
        rest.remove(best)
        whole = _joined_track(whole, tracks[best])
    return pieces


def _goes_on(pen: Track, other: Track, moves: bool, t: Array) -> bool:
    """Tell whether a marker is the pen under another name.

    It is seen where the pen is not, all of it in one gap or at one end, and at an end of its own it
    is where the pen was or will be: exactly there, for one that stands still.
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
    if len(links) == 2 and t[pen.seen[place]] - t[pen.seen[place - 1]] <= FILLED_GAP:
        return False
    latest, fastest = (LATEST_RETURN, HAND_SPEED) if moves else (FILLED_GAP, RESTING_SPEED)
    near = [
        np.linalg.norm(step) <= REJOIN_RADIUS + fastest * seconds
        for seconds, step in links
        if seconds <= latest
    ]
    return bool(near) and all(near)


def _meet(one: Track, other: Track) -> bool:
    """Tell whether both are seen at one time, or one between two sights of the other."""
    return bool(one.seen[0] <= other.seen[-1] and other.seen[0] <= one.seen[-1])


def _joined_track(one: Track, other: Track) -> Track:
    """Join two tracks into one."""
    seen = np.concatenate([one.seen, other.seen])
    order = np.argsort(seen)
    return Track(seen[order], np.concatenate([one.points, other.points])[order])
