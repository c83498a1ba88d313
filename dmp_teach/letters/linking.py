"""From one letter to the next without lifting the pen."""

from collections.abc import Sequence

import numpy as np

from dmp_teach.letters.outline import long
from dmp_teach.trajectory import Array, Trajectory

BRAKING = 0.6  # a stroke brakes, or gains speed, where it is slower than this part of its usual speed
REACH = 0.25  # no more than this is taken off a stroke's end, in x-heights
INNER = 0.4  # a pen that ends farther left than this part of its letter has to lift
MARK = 0.6  # a stroke shorter than this part of the longest is a dot, a cross or an accent
QUICKEST, SLOWEST = 0.06, 0.6  # how long the way between two letters takes [s]


def body_and_marks(
    character: str, strokes: Sequence[Trajectory]
) -> tuple[tuple[Trajectory, ...], tuple[Trajectory, ...]]:
    """The strokes that a word is joined by, and those that come after it: dots, crosses, accents of small letters.

    A mark is short, or leads back to the left as the second stroke of an x does. Capitals and digits have none.
    """
    if not character.islower():
        return tuple(strokes), ()
    longest = max(long(stroke.position) for stroke in strokes)

    def is_mark(stroke: Trajectory) -> bool:
        back = stroke.position[-1, 0] < stroke.position[0, 0]
        return bool(back or long(stroke.position) < MARK * longest)

    main = next(k for k, stroke in enumerate(strokes) if long(stroke.position) >= MARK * longest)
    body = tuple(s for k, s in enumerate(strokes) if k == main or (k > main and not is_mark(s)))
    return body, tuple(s for s in strokes if s not in body)


def can_leave(character: str, body: Sequence[Trajectory]) -> bool:
    """Whether the pen may go on without lifting: from a small letter that ends on its right, and not downwards."""
    path = np.concatenate([stroke.position for stroke in body])
    left, right = path[:, 0].min(), path[:, 0].max()
    end, ahead = path[-1], path[-1] - path[-min(len(body[-1]), 12)]
    falls = ahead[1] < -abs(ahead[0])
    return bool(character.islower() and end[0] >= left + INNER * (right - left) and not falls)


def can_arrive(character: str) -> bool:
    """Whether the pen may come to a letter without lifting: capitals and digits begin afresh."""
    return character.islower()


def linked(before: Trajectory, after: Trajectory, x_height: float) -> Trajectory:
    """Two strokes as one: the pen leaves the first before it has stopped, and arrives at the second on the move.

        y(s) = y0 + ... + c5 s^5    between both, with their positions and velocities, and no acceleration at its ends

    Args:
        before: The stroke so far.
        after: The stroke of the next letter; its clock is moved so that it follows.
        x_height: The height of a small letter without a stem [m].
    """
    after = _over_the_top(before.position[-1], after, x_height)
    a, v = _leaving(before, x_height)
    b, w = _leaving(_backwards(after), x_height)
    b, w = len(after) - 1 - b, -w
    if w @ (after.position[0] - before.position[a]) < 0:  # the pen comes from the other side: it turns at the start
        b, w = 0, np.zeros(2)
    far = float(np.linalg.norm(after.position[b] - before.position[a]))
    lasts = float(np.clip(1.2 * far / min(_pace(before), _pace(after)), QUICKEST, SLOWEST))
    steps = max(2, round(lasts / float(np.median(np.diff(before.t)))))
    s = np.linspace(0, 1, steps + 1)[:, None]
    way = quintic(s, before.position[a], after.position[b], v * lasts, w * lasts)
    t = np.concatenate([before.t[: a + 1], before.t[a] + lasts * s[1:, 0]])
    t = np.concatenate([t, t[-1] + after.t[b + 1 :] - after.t[b]])
    return Trajectory(t, np.concatenate([before.position[: a + 1], way[1:], after.position[b + 1 :]]))


def quintic(s: Array, start: Array, goal: Array, v: Array, w: Array) -> Array:
    """The way of least jerk from `start` with velocity v to `goal` with w, at parts s (T, 1) of it, shape (T, 2)."""
    rest = goal - start - v
    change = w - v
    return (
        start
        + v * s
        + (10 * rest - 4 * change) * s**3
        + (7 * change - 15 * rest) * s**4
        + (6 * rest - 3 * change) * s**5
    )


def _over_the_top(here: Array, after: Trajectory, x_height: float) -> Trajectory:
    """A stroke that begins on its right and leads left, as those of a, c, d and o do, with the way to its start.

    The pen gets to it where its bow is met by a tangent from `here` (2,), and follows the bow backwards to the start.
    """
    path, step = after.position, np.diff(after.position, axis=0)
    x = path[:, 0]
    rightwards = np.flatnonzero(x - np.minimum.accumulate(x) > 0.05 * x_height)
    leftmost = int(np.argmin(x[: rightwards[0]] if len(rightwards) else x))
    if x[0] - x[leftmost] < 0.2 * x_height or x[0] < here[0]:
        return after
    back, towards = -step[1:leftmost], path[1:leftmost] - here
    along = (back * towards).sum(axis=1) / np.maximum(
        np.prod([np.linalg.norm(v, axis=1) for v in (back, towards)], 0), 1e-15
    )
    k = 1 + int(np.argmax(along))
    t = np.concatenate([after.t[0] - after.t[k:0:-1], after.t - after.t[0] + 0.0])
    return Trajectory(t + after.t[k] - after.t[0], np.concatenate([path[k:0:-1], path]))


def _leaving(stroke: Trajectory, x_height: float) -> tuple[int, Array]:
    """The last sample at which a stroke is still fast, if it is near enough to its end, and its velocity there (2,)."""
    step = np.linalg.norm(np.diff(stroke.position, axis=0), axis=1)
    left = np.concatenate([np.cumsum(step[::-1])[::-1], [0.0]])  # the way that is left at each sample
    near = np.flatnonzero(left[:-1] < REACH * x_height)
    fast = near[step[near] > BRAKING * _pace(stroke) * np.diff(stroke.t)[near]]
    k = int(np.clip(fast[-1] if len(fast) else near[0], 1, len(stroke) - 2))
    return k, (stroke.position[k + 1] - stroke.position[k - 1]) / (stroke.t[k + 1] - stroke.t[k - 1])


def _pace(stroke: Trajectory) -> float:
    """The mean speed of a stroke [m/s]."""
    return max(long(stroke.position) / stroke.duration, 1e-9)


def _backwards(stroke: Trajectory) -> Trajectory:
    return Trajectory(stroke.t[-1] - stroke.t[::-1], stroke.position[::-1])
