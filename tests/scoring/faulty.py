"""Letters that have one fault, by any amount: what a score must find."""

import numpy as np

from dmp_teach.trajectory import Trajectory


def ink(strokes):
    return np.concatenate([stroke.position for stroke in strokes])


def size_of(strokes):
    return np.ptp(ink(strokes), axis=0).max()


def linear(strokes, matrix):
    middle = ink(strokes).mean(axis=0)
    return [Trajectory(s.t, (s.position - middle) @ np.array(matrix).T + middle) for s in strokes]


def scaled(strokes, factor):
    return linear(strokes, [[factor, 0], [0, factor]])


def widened(strokes, factor):
    return linear(strokes, [[factor, 0], [0, 1]])


def leaned(strokes, degrees):
    return linear(strokes, [[1, np.tan(np.radians(degrees))], [0, 1]])


def turned(strokes, degrees):
    angle = np.radians(degrees)
    return linear(strokes, [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def mirrored(strokes):
    return linear(strokes, [[-1, 0], [0, 1]])


def bent(strokes, amount):
    low, size = ink(strokes).min(axis=0), size_of(strokes)
    wide = np.maximum(np.ptp(ink(strokes), axis=0), 0.3 * size)
    waves = [np.cos(2 * np.pi * (s.position - low) / wide)[:, ::-1] * [1, 0.6] for s in strokes]
    return [
        Trajectory(s.t, s.position + amount * size * wave)
        for s, wave in zip(strokes, waves, strict=True)
    ]


def loose(strokes, amount, rng):
    """As another day: every stroke a little elsewhere and a little bent."""
    size, found = size_of(strokes), []
    for stroke in strokes:
        along, bend = np.linspace(0, np.pi, len(stroke.position))[:, None], rng.normal(size=(4, 2))
        waves = sum(np.sin(k * along + rng.uniform(0, 6)) * bend[k] / k for k in (1, 2, 3))
        found.append(
            Trajectory(stroke.t, stroke.position + amount * size * (0.6 * waves + 0.5 * bend[0]))
        )
    return found


def shaken(strokes, amount):
    size = size_of(strokes)
    waves = [np.column_stack([np.sin(50 * s.t), np.cos(46 * s.t)]) for s in strokes]
    return [
        Trajectory(s.t, s.position + amount * size * wave)
        for s, wave in zip(strokes, waves, strict=True)
    ]


def moved(strokes, number, amount):
    step = np.array(amount) * size_of(strokes)
    return [Trajectory(s.t, s.position + (k == number) * step) for k, s in enumerate(strokes)]


def shortened(strokes, number, end, part):
    """A piece of one stroke left out, by the way along it."""
    return [
        _part(s, part if end == "start" else 0, 1 if end == "start" else 1 - part)
        if k == number
        else s
        for k, s in enumerate(strokes)
    ]


def _part(stroke, first, last):
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(stroke.position, axis=0), axis=1))])
    kept = (way >= first * way[-1]) & (way <= last * way[-1])
    return Trajectory(stroke.t[kept], stroke.position[kept])


def lengthened(strokes, number, part):
    """One stroke that goes straight on at its end, by a part of its length."""
    found = list(strokes)
    stroke = found[number]
    long = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1).sum()
    back = stroke.position[-1] - stroke.position[-8]
    on = stroke.position[-1] + np.linspace(0, 1, 30)[
        1:, None
    ] * part * long * back / np.linalg.norm(back)
    t = np.concatenate([stroke.t, stroke.t[-1] + np.arange(1, 30) * 0.002])
    found[number] = Trajectory(t, np.concatenate([stroke.position, on]))
    return found


def with_size(strokes, number, factor):
    """One stroke of another size, beginning where it began."""
    return [
        Trajectory(
            s.t, (s.position - s.position[0]) * (factor if k == number else 1) + s.position[0]
        )
        for k, s in enumerate(strokes)
    ]


def backwards(strokes, number):
    return [Trajectory(s.t, s.position[::-1]) if k == number else s for k, s in enumerate(strokes)]


def after_each_other(strokes):
    begins = np.cumsum([0.0, *(stroke.duration + 0.4 for stroke in strokes[:-1])])
    return [
        Trajectory(s.t - s.t[0] + begin, s.position)
        for s, begin in zip(strokes, begins, strict=True)
    ]


def swapped(strokes):
    return after_each_other([*strokes[1:], strokes[0]])


def without(strokes, number):
    return [stroke for k, stroke in enumerate(strokes) if k != number]


def with_one_more(strokes):
    size, way = size_of(strokes), np.linspace(0, 1, 60)[:, None]
    line = ink(strokes).min(axis=0) - [0, 0.25 * size] + way * [0.8 * size, 0]
    return after_each_other([*strokes, Trajectory(np.arange(60) / 100, line)])


def in_one(strokes):
    """Two strokes without a lift: the second from its end, where the first one is."""
    position = np.concatenate([strokes[0].position, strokes[1].position[::-1]])
    return [Trajectory(np.arange(len(position)) / 120, position)]


def gone_over(strokes, number, part):
    """One stroke gone back over from its end, by a part of its points."""
    stroke, found = strokes[number], list(strokes)
    back = stroke.position[::-1][: int(part * len(stroke))]
    position = np.concatenate([stroke.position, back])
    found[number] = Trajectory(np.arange(len(position)) / 120, position)
    return found


def loops(stroke):
    """Where along a stroke, from 0 to 1, loops begin and end that enclose more than a little."""
    points = _evenly(stroke, 64)
    size, found = np.ptp(points, axis=0).max(), []
    apart = np.linalg.norm(points[:, None] - points, axis=2)
    for i in range(64):
        for j in range(i + 13, 64):
            near = apart[max(0, i - 1) : i + 2, max(0, j - 1) : j + 2].min()
            x, y = points[[*range(i, j + 1), i]].T
            area = abs((x[:-1] * y[1:] - x[1:] * y[:-1]).sum()) / 2
            if apart[i, j] == near < 0.05 * size and area > 0.04 * size**2:
                found.append((i / 63, j / 63))
    return found


def turned_back(strokes, number, begin, end):
    """A part of one stroke written the other way, in its place."""
    points, found = _evenly(strokes[number], 240), list(strokes)
    part = slice(round(begin * 239), round(end * 239) + 1)
    points[part] = points[part][::-1].copy()
    found[number] = Trajectory(np.arange(240) / 120, points)
    return found


def _evenly(stroke, count):
    """Points at equal arc length."""
    way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(stroke.position, axis=0), axis=1))])
    at = np.linspace(0, way[-1], count)
    return np.column_stack([np.interp(at, way, axis) for axis in stroke.position.T])
