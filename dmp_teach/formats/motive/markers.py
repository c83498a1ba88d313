"""Which marker of a take is the pen, also where Motive gave it another name in mid-take.

The markers of rigid bodies are no pens, and neither is one that hardly moves. Of several that move
the one nearest to the paper is taken. Where no marker moves, a rigid body may be the pen, and then
a marker of one. A marker that the cameras lose and find again may come back under another name, and
two may swap names.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from dmp_teach.errors import RecordingError
from dmp_teach.formats.motive.table import AxisColumns, MarkerKey, Table, cell_number, list_names
from dmp_teach.trajectory import Array

FARTHEST_SAMPLE = 1e6  # farther is no farther [m]
MEDIAN_BLOCK = 0.1  # a track is judged by medians over this long, which no single cell can move [s]
MEDIAN_STEP = 0.001  # a pen moves more than this from one of them to the next [m]
FEWEST_MOVES = 3  # a marker that was pushed moves once or twice
RIVAL_SHARE = 0.5  # a marker that moves so often beside the one that moves most may be the pen
LATEST_RETURN = 0.5  # a marker that comes back later may be anything [s]
REJOIN_RADIUS = 0.01  # a marker comes back this near to where it was lost ... [m]
SAME_PLACE = 0.002  # two names of one marker may be seen at once, so near [m]
HAND_SPEED = 1.0  # ... or as far as a hand moves meanwhile [m/s]
MOST_PIECES = 200  # of a pen under changing names
LONGEST_LEAP = 0.1  # a marker that leaps farther than a hand moves is another thing [m]
MOST_LEAPS = (100, 0.1)  # in a track, and as a share of it; in others the unit is wrong
BODY = re.compile(r"RigidBody \d+")


@dataclass(frozen=True)
class Track:
    """Where a marker was seen.

    Args:
        seen: The frames' places in the table, from 0, shape (K,).
        points: Its positions there, shape (K, 3) [m].
    """

    seen: np.ndarray
    points: Array


@dataclass(frozen=True)
class Pen:
    """The pen through a take.

    Args:
        name: Of its marker, or of one after the other.
        track: Where it was seen.
        others: The names of the other markers that could be named.
        rivals: Those of them that move like a pen, too.
        left: Frames in which its marker was seen where the pen cannot be, as places in the table.
    """

    name: str
    track: Track
    others: list[str]
    rivals: list[str]
    left: np.ndarray


def find_pen(table: Table, marker: str | None, out: Array) -> Pen:
    """Find the marker that is the pen, and those that go on for it.

    Args:
        table: The file.
        marker: The marker's name, or None.
        out: The direction out of the paper, shape (3,).

    Raises:
        RecordingError: No such marker.
    """
    names = {name for name, _ in table.bodies}
    markers, bodies = (
        {key: axes for key, axes in found.items() if len(axes) == 3}
        for found in (table.markers, table.bodies)
    )
    every = markers | bodies
    free = {key: axes for key, axes in markers.items() if not _is_part(key[0], names)}
    named = {key: axes for key, axes in every.items() if key[0] == marker}
    tracks = _tracks(table, every if marker is None else free | bodies | named)
    moves = {key: _moves(track, table.t) for key, track in tracks.items()}
    pools = [free, bodies, markers] if marker is None else [named]
    brisk = (pool for pool in pools if any(moves[key] >= FEWEST_MOVES for key in pool))
    pool = next(brisk, pools[0] or pools[-1])
    if not pool:
        wanted = "no marker that could be the pen" if marker is None else f"no marker {marker!r}"
        could = list_names(label for label, _ in free or every)
        raise RecordingError(
            f"there is {wanted}. Markers that could be named with marker=...: "
            f"{could or 'none; export the positions of the markers'}."
        )
    most = max(moves[key] for key in pool)
    also = bodies if marker is None else {}
    rivals = [key for key in pool | also if moves[key] > RIVAL_SHARE * most > 0]
    chosen = max(pool, key=lambda key: len(tracks[key].seen))
    if near := [key for key in rivals if key in pool]:
        chosen = min(near, key=lambda key: float(np.median(tracks[key].points @ out)))
    followed, track = _followed(chosen, {key: tracks[key] for key in free | pool}, table.t)
    left = np.setdiff1d(tracks[chosen].seen, track.seen)
    others, moving = (
        [label for label in dict.fromkeys(label for label, _ in keys) if label not in followed]
        for keys in (free, rivals)
    )
    return Pen(", then ".join(followed), track, others, moving, left)


def _is_part(label: str, bodies: set[str]) -> bool:
    """Tell whether a marker is a part of a rigid body: `Robot:Marker1`, not `Robot:Marker1 (2)`."""
    body, _, part = label.rpartition(":")
    return not part.endswith(")") and (body in bodies or BODY.fullmatch(body) is not None)


def _tracks(table: Table, markers: dict[MarkerKey, AxisColumns]) -> dict[MarkerKey, Track]:
    """Return where each marker was seen; a cell that is no number is one of the table's faults."""
    columns = sorted(
        ((max(axes.values()), key, axes) for key, axes in markers.items()), key=lambda each: each[0]
    )
    seen: dict[MarkerKey, list[int]] = {key: [] for key in markers}
    points: dict[MarkerKey, list[list[float]]] = {key: [] for key in markers}
    for k, (place, row) in enumerate(table.body):
        for last, key, axes in columns:
            if last >= len(row):
                break
            if not row[axes["X"]].strip():
                continue
            try:
                point = [cell_number(row, axes[a], place, f"{key[0]!r} {a}") for a in "XYZ"]
            except RecordingError as error:
                table.faults.append(str(error))
                continue
            seen[key].append(k)
            points[key].append(point)
    return {
        key: Track(
            np.array(seen[key], dtype=int),
            np.clip(
                np.reshape(points[key], (-1, 3)) * table.scale, -FARTHEST_SAMPLE, FARTHEST_SAMPLE
            ),
        )
        for key in markers
    }


def _moves(track: Track, t: Array) -> int:
    """Return how often a marker moved: from one block of time to the next, seen in medians."""
    if not len(track.seen):
        return 0
    block = np.floor((t[track.seen] - t[track.seen[0]]) / MEDIAN_BLOCK)
    starts = np.flatnonzero(np.diff(block)) + 1
    medians = np.array([np.median(part, axis=0) for part in np.split(track.points, starts)])
    return int((np.linalg.norm(np.diff(medians, axis=0), axis=1) > MEDIAN_STEP).sum())


def _followed(
    chosen: MarkerKey, tracks: dict[MarkerKey, Track], t: Array
) -> tuple[list[str], Track]:
    """Return the names of the pen's marker and of those that go on for it, and the whole track."""
    whole, *rest = sorted(_unbroken(tracks[chosen], t), key=lambda part: -_moves(part, t))
    others = [(chosen, part) for part in rest]
    for key, track in tracks.items():
        if key != chosen and len(track.seen):
            others += [(key, part) for part in _unbroken(track, t)]
    pieces = {chosen}
    for _ in range(MOST_PIECES if len(whole.seen) else 0):
        found = [_nearest_part(whole, track, t) for _, track in others]
        best = min(range(len(found)), key=lambda k: found[k][0], default=None)
        if best is None or found[best][0] > 1:
            break
        part, (key, other) = found[best][1], others.pop(best)
        pieces.add(key)
        seen = np.concatenate([whole.seen, other.seen[part]])
        order = np.argsort(seen)
        whole = Track(seen[order], np.concatenate([whole.points, other.points[part]])[order])
        if len(part) < len(other.seen):
            left = Track(np.delete(other.seen, part), np.delete(other.points, part, axis=0))
            others.insert(best, (key, left))
    order_of_names = sorted(pieces, key=lambda key: tracks[key].seen[:1].tolist())
    return list(dict.fromkeys(label for label, _ in order_of_names)), whole


def _unbroken(track: Track, t: Array) -> list[Track]:
    """Return the parts of a track between leaps that no hand makes, as where two swap names."""
    leap = np.linalg.norm(np.diff(track.points, axis=0), axis=1)
    cuts = np.flatnonzero(leap > LONGEST_LEAP + HAND_SPEED * np.diff(t[track.seen])) + 1
    if len(cuts) > min(MOST_LEAPS[0], MOST_LEAPS[1] * len(track.seen)):
        return [track]
    parts = zip(np.split(track.seen, cuts), np.split(track.points, cuts), strict=True)
    return [Track(*part) for part in parts]


def _nearest_part(pen: Track, other: Track, t: Array) -> tuple[float, np.ndarray]:
    """Return the part of a marker that fits best where the pen is lost.

    A marker that is ever seen beside the pen, and not where it is, is another thing.

    Returns:
        How far it begins or ends from where the pen is lost, 1 being as far as can be; and the
        part, as places in the track.
    """
    place = np.searchsorted(pen.seen, other.seen)
    beside = np.isin(other.seen, pen.seen)
    away_from_pen = other.points[beside] - pen.points[np.isin(pen.seen, other.seen)]
    alone = np.flatnonzero(~beside)
    if not len(alone) or np.abs(away_from_pen).max(initial=0.0) > SAME_PLACE:
        return np.inf, alone[:0]
    parts = np.split(alone, np.flatnonzero(np.diff(place[alone])) + 1)
    away = [_distance(pen, other, part, int(place[part[0]]), t) for part in parts]
    best = int(np.argmin(away))
    return away[best], parts[best]


def _distance(pen: Track, other: Track, part: np.ndarray, place: int, t: Array) -> float:
    """Return how far a part of a marker begins or ends from where the pen is lost."""
    first, last = other.seen[part[0]], other.seen[part[-1]]
    links = []
    if place > 0:
        step = other.points[part[0]] - pen.points[place - 1]
        links.append((t[first] - t[pen.seen[place - 1]], step))
    if place < len(pen.seen):
        links.append((t[pen.seen[place]] - t[last], pen.points[place] - other.points[part[-1]]))
    return max(
        np.inf
        if seconds > LATEST_RETURN
        else float(np.linalg.norm(step)) / (REJOIN_RADIUS + HAND_SPEED * seconds)
        for seconds, step in links
    )
