"""What a pupil gets wrong: of the shape, by degrees, and of the way of writing, all or nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dmp_teach.ink import recording_of
from dmp_teach.scoring import size_of
from dmp_teach.trajectory import Array, Trajectory, interpolate_points, path_length

PupilStrokes = tuple[Trajectory, ...]

# Between two strokes of a letter whose order was changed [s].
PAUSE = 0.3
# Waves of a shaky hand over one stroke.
WAVES = 9


@dataclass(frozen=True)
class ShapeFault:
    """A fault that is more or less.

    Args:
        usual: A clear amount of it.
        none: The amount that changes nothing.
        low: The least that a pupil may have.
        high: The most.
        bend: Changes strokes by an amount.
    """

    usual: float
    none: float
    low: float
    high: float
    bend: Callable[[PupilStrokes, float], PupilStrokes]

    def share(self, amount: float, part: float) -> float:
        """Return the amount of which a part is left."""
        return self.none + part * (amount - self.none)


def _mapped(strokes: PupilStrokes, matrix: Sequence[Sequence[float]]) -> PupilStrokes:
    """Return strokes mapped by a matrix (2, 2), the writing line y = 0 and the middle staying."""
    middle = np.array([_middle(strokes), 0.0])
    turn = np.array(matrix).T
    return tuple(replace(s, position=(s.position - middle) @ turn + middle) for s in strokes)


def _middle(strokes: PupilStrokes) -> float:
    """Return the middle between left and right [m]."""
    x = np.concatenate([stroke.position[:, 0] for stroke in strokes])
    return float(x.min() + x.max()) / 2


def _lean(strokes: PupilStrokes, degrees: float) -> PupilStrokes:
    return _mapped(strokes, [[1, np.tan(np.radians(degrees))], [0, 1]])


def _rise(strokes: PupilStrokes, degrees: float) -> PupilStrokes:
    return _mapped(strokes, [[1, 0], [np.tan(np.radians(degrees)), 1]])


def _size(strokes: PupilStrokes, ratio: float) -> PupilStrokes:
    return _mapped(strokes, [[ratio, 0], [0, ratio]])


def _width(strokes: PupilStrokes, ratio: float) -> PupilStrokes:
    return _mapped(strokes, [[ratio, 0], [0, 1]])


def _open(strokes: PupilStrokes, share: float) -> PupilStrokes:
    """Stop the longest stroke before its end: in its last part the pen dawdles."""
    longest = max(range(len(strokes)), key=lambda k: path_length(strokes[k].position))
    way = share_of_way(strokes[longest].position)
    begin = 1 - 2 * share
    kept = np.where(way < begin, way, (way + begin) / 2)
    return _with(strokes, longest, follow_way(strokes[longest].position, kept))


def _shaky(strokes: PupilStrokes, share: float) -> PupilStrokes:
    """Let each stroke wave to both sides of its way, its ends staying."""
    size = size_of(strokes)
    waved = []
    for stroke in strokes:
        way = share_of_way(stroke.position)
        along = np.gradient(stroke.position, axis=0)
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
        aside = np.column_stack([-along[:, 1], along[:, 0]])
        high = share * min(size, path_length(stroke.position))
        wave = high * np.sin(2 * np.pi * WAVES * way) * np.sin(np.pi * way)
        waved.append(replace(stroke, position=stroke.position + wave[:, None] * aside))
    return tuple(waved)


SHAPE_FAULTS: Mapping[str, ShapeFault] = {
    "lean": ShapeFault(25.0, 0.0, -40.0, 40.0, _lean),
    "rise": ShapeFault(25.0, 0.0, -40.0, 40.0, _rise),
    "size": ShapeFault(1.7, 1.0, 0.5, 2.0, _size),
    "width": ShapeFault(1.7, 1.0, 0.5, 2.0, _width),
    "open": ShapeFault(0.2, 0.0, 0.0, 0.4, _open),
    "shaky": ShapeFault(0.03, 0.0, 0.0, 0.06, _shaky),
}
"""By the names that `score` gives them, in degrees, as ratios and as shares."""


def distort(strokes: PupilStrokes, faults: Mapping[str, float], part: float = 1.0) -> PupilStrokes:
    """Return strokes with a part of each fault of the shape."""
    for name, amount in faults.items():
        if name in SHAPE_FAULTS:
            fault = SHAPE_FAULTS[name]
            strokes = fault.bend(strokes, fault.share(amount, part))
    return strokes


def _mirrored(strokes: PupilStrokes) -> PupilStrokes:
    return _mapped(strokes, [[-1, 0], [0, 1]])


def _reversed(strokes: PupilStrokes) -> PupilStrokes:
    return tuple(replace(stroke, position=stroke.position[::-1]) for stroke in strokes)


def _order(strokes: PupilStrokes) -> PupilStrokes:
    return put_in_sequence(strokes[::-1])


WAY_FAULTS: Mapping[str, Callable[[PupilStrokes], PupilStrokes]] = {
    "mirrored": _mirrored,
    "order": _order,
    "reversed": _reversed,
}
"""What is or is not: left for right, the last stroke first, each stroke from its other end."""


def write_other(character: str, faults: Mapping[str, float], part: float) -> PupilStrokes:
    """Return another letter that is written instead, in a pupil's hand."""
    return distort(recording_of(character).strokes(), faults, part)


def put_in_sequence(strokes: PupilStrokes) -> PupilStrokes:
    """Return strokes one after the other on a clock that begins at 0."""
    clock, placed = 0.0, []
    for stroke in strokes:
        placed.append(replace(stroke, t=stroke.t - stroke.t[0] + clock))
        clock = float(placed[-1].t[-1]) + PAUSE
    return tuple(placed)


def share_of_way(points: Array) -> Array:
    """Return what share of its way a pen has gone at each point (P, 2), or of time in a dot."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    even = np.linspace(0, 1, len(points))
    if steps.sum() < 1e-9:
        return even
    # A pen that rests must not stop the clock for good.
    way = np.concatenate([[0.0], np.cumsum(steps / steps.sum())])
    return 0.999 * way + 0.001 * even


def follow_way(points: Array, way: Array) -> Array:
    """Return where a line (P, 2) is at shares of its way (T,), shape (T, 2)."""
    return _at(points, np.interp(way, share_of_way(points), np.arange(len(points))))


def _at(points: Array, places: Array) -> Array:
    """Return points (P, 2) between their rows, shape (T, 2)."""
    rows = np.arange(len(points))
    return interpolate_points(places, rows, points)


def _with(strokes: PupilStrokes, number: int, position: Array) -> PupilStrokes:
    """Return strokes of which one is elsewhere."""
    return tuple(
        replace(stroke, position=position) if k == number else stroke
        for k, stroke in enumerate(strokes)
    )
