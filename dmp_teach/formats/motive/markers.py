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
from dmp_teach.formats.motive.table import MarkerKey, Table, Track, list_names
from dmp_teach.trajectory import Array

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
        [key for key, axes in found.items() if len(axes) == 3]
        for found in (table.markers, table.bodies)
    )
    free = [key for key in markers if not _is_part(key[0], names)]
    named = [key for key in markers + bodies if key[0] == marker]
    needed = markers + bodies if marker is None else free + bodies + named
    tracks = {key: table.track(key) for key in dict.fromkeys(needed)}
    moves = {key: _moves(track, table.t) for key, track in tracks.items()}
    pools = [free, bodies, markers] if marker is None else [named]
    brisk = (pool for pool in pools if any(moves[key] >= FEWEST_MOVES for key in pool))
    pool = next(brisk, pools[0] or pools[-1])
    if not pool:
        wanted = "no marker that could be the pen" if marker is None else f"no marker {marker!r}"
        could = list_names(label for label, _ in free or markers + bodies)
        raise RecordingError(
            f"there is {wanted}. Markers that could be named with marker=...: "
            f"{could or 'none; export the positions of the markers'}."
        )
    most = max(moves[key] for key in pool)
    also = bodies if marker is None else []
    rivals = [key for key in dict.fromkeys(pool + also) if moves[key] > RIVAL_SHARE * most > 0]
    chosen = max(pool, key=lambda key: len(tracks[key].seen))
    if near := [key for key in rivals if key in pool]:
        chosen = min(near, key=lambda key: float(np.median(tracks[key].points @ out)))
    followed, track = _followed(chosen, {key: tracks[key] for key in free + pool}, table.t)
    others, moving = (
        [label for label in dict.fromkeys(label for label, _ in keys) if label not in followed]
        for keys in (free, rivals)
    )
    left = np.setdiff1d(tracks[chosen].seen, track.seen)
    return Pen(", then ".join(followed), track, others, moving, left)


def _is_part(label: str, bodies: set[str]) -> bool:
    """Tell whether a marker is a part of a rigid body: `Robot:Marker1`, not `Robot:Marker1 (2)`."""
    body, _, part = label.rpartition(":")
    return not part.endswith(")") and (body in bodies or BODY.fullmatch(body) is not None)


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
    parts = {key: _unbroken(track, t) for key, track in tracks.items()}
    whole, *rest = sorted(parts.pop(chosen), key=lambda part: -_moves(part, t))
    others = [(chosen, part) for part in rest]
    others += [(key, part) for key, some in parts.items() for part in some if len(part.seen)]
    names = {chosen}
    for _ in range(MOST_PIECES if len(whole.seen) else 0):
        found = [_nearest_part(whole, track, t) for _, track in others]
        best = min(range(len(found)), key=lambda k: found[k][0], default=None)
        if best is None or found[best][0] > 1:
            break
        part, (key, other) = found[best][1], others.pop(best)
        names.add(key)
        seen = np.concatenate([whole.seen, other.seen[part]])
        order = np.argsort(seen)
        whole = Track(seen[order], np.concatenate([whole.points, other.points[part]])[order])
        if len(part) < len(other.seen):
            left = Track(np.delete(other.seen, part), np.delete(other.points, part, axis=0))
            others.insert(best, (key, left))
    in_order = sorted(tracks.keys() & names, key=lambda key: (*tracks[key].seen[:1], key))
    return list(dict.fromkeys(label for label, _ in in_order)), whole


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
    ends = ((part[0], place - 1), (part[-1], place))
    links = [(mine, its) for mine, its in ends if 0 <= its < len(pen.seen)]
    seconds = np.array([abs(t[other.seen[mine]] - t[pen.seen[its]]) for mine, its in links])
    steps = [np.linalg.norm(other.points[mine] - pen.points[its]) for mine, its in links]
    if seconds.max() > LATEST_RETURN:
        return np.inf
    return float((np.array(steps) / (REJOIN_RADIUS + HAND_SPEED * seconds)).max())
