"""Writers drawn by lot: our letters in other sizes, speeds, habits of lifting and markers.

Unlike the scripts of `motive_csv.Pen`, whose steps are chosen, everything here is drawn from a
seed: how the hand lands (at once, hovering, pausing over or on the paper), how it lifts (low,
slowly, high), how it rests, hops before it writes or flies away, how the marker wanders and
trembles. What the pen did is known: `Take.ink`.
"""

from dataclasses import dataclass

import numpy as np

from dmp_teach.ink.alphabet import alphabets, recording_of

LETTERS = "aDBePiRtEkMAxTH"
FINE = 1 / 960  # the step in which the hand is drawn [s]
STEEPEST = 0.12  # no marker wanders up and down by more than this share of its letter


@dataclass(frozen=True)
class Take:
    """A take, and the truth about it.

    Args:
        t: Times, shape (T,) [s].
        page: The marker in the page's frame, shape (T, 3) [m].
        ink: For each stroke when the pen touched, began to move, stopped and left the paper [s].
        about: What was drawn by lot.
    """

    t: np.ndarray
    page: np.ndarray
    ink: tuple
    about: dict


class Hand:
    """A way that grows: points on a fine clock."""

    def __init__(self, random):
        """Begin nowhere."""
        self.random, self.points = random, []

    def now(self):
        """The time so far [s]."""
        return sum(len(p) for p in self.points) * FINE

    def here(self):
        """The last point (3,)."""
        return self.points[-1][-1]

    def begin(self, point):
        """At a point (3,)."""
        self.points.append(np.asarray(point, float)[None])

    def rest(self, seconds):
        """Stay."""
        self.points.append(np.tile(self.here(), (max(1, round(seconds / FINE)), 1)))

    def go(self, to, seconds, bump=0.0):
        """To a point (3,), from rest to rest, by way of a bump in height."""
        s = np.linspace(0, 1, max(2, round(seconds / FINE)) + 1)[1:, None]
        ease = 10 * s**3 - 15 * s**4 + 6 * s**5
        self.points.append(
            self.here()
            + (to - self.here()) * ease
            + np.array([0, 0, bump]) * np.sin(np.pi * ease) ** 2
        )

    def write(self, stroke, scale, pace):
        """A stroke of an alphabet, larger and faster, from where the pen stands."""
        t = (stroke.t - stroke.t[0]) / pace
        even = np.arange(FINE, t[-1] + FINE / 2, FINE)
        path = np.column_stack([np.interp(even, t, axis) for axis in stroke.position.T]) * scale
        self.points.append(np.column_stack([path, np.zeros(len(path))]))


def land(hand, to, habit, lift):
    """From the top of a lift down to a point (2,): returns when the pen touched."""
    random, to = hand.random, np.append(to, 0.0)
    if habit == "hovers":  # stands still a little over the paper, then sinks
        hand.go(
            to + np.array([*random.normal(0, 0.003, 2), random.uniform(0.002, 0.006)]),
            random.uniform(0.2, 0.35),
        )
        hand.rest(random.uniform(0.1, 0.5))
        hand.go(to, random.uniform(0.08, 0.2))
    elif habit == "creeps":  # sinks while it looks for the place
        hand.go(
            to + np.array([*random.normal(0, 0.006, 2), random.uniform(0.003, 0.006)]),
            random.uniform(0.2, 0.35),
        )
        hand.go(to, random.uniform(0.3, 0.6))
    else:
        hand.go(to, random.uniform(0.5, 1.0) * max(0.12, 4 * lift))
    touch = hand.now()
    if habit == "pauses":  # stands on the paper before it writes
        hand.rest(random.uniform(0.1, 0.6))
    elif random.random() < 0.5:
        hand.rest(random.uniform(0.0, 0.05))
    return touch


HABITS = ("at once", "pauses", "hovers", "creeps")


def take(seed, rate=None, habit=None, letters=LETTERS, **fixed):
    """A take of a writer drawn by lot."""
    random = np.random.default_rng(seed)
    letter = str(random.choice(list(letters)))
    source = recording_of(letter, alphabets()[seed % len(alphabets())]).strokes()
    tall = max(np.ptp(np.concatenate([s.position for s in source]), axis=0))
    about = {
        "letter": letter,
        "size": random.uniform(0.047, 0.213),
        "speed": random.uniform(0.06, 0.35),
        "rate": rate or random.choice([100.0, 120.0, 200.0, 240.0]),
        "habit": habit or str(random.choice(HABITS)),
        "lift": random.choice([random.uniform(0.013, 0.02), random.uniform(0.02, 0.06)]),
        "wander": random.choice([0.0, 0.005, 0.01, 0.02]) * random.uniform(0.5, 1),
        "slope": random.normal(0, 0.01, 2),
        "noise": random.choice([0.00005, 0.0001, 0.0003]),
        "head": str(random.choice(["rests", "lands", "hops", "flies"])),
        "tail": str(random.choice(["rests", "ends", "flies", "lifts"])),
        **fixed,
    }
    about["wander"] = min(about["wander"], STEEPEST * about["size"])
    hand, ink = Hand(random), []
    scale = about["size"] / tall
    ways = [np.linalg.norm(np.diff(s.position, axis=0), axis=1).sum() * scale for s in source]
    pace = about["speed"] / (sum(ways) / sum(s.duration for s in source))
    start = source[0].position[0] * scale
    touch = _begin(hand, about, start)
    for number, stroke in enumerate(source):
        if number:
            touch = _over(hand, about, stroke.position[0] * scale)
        moves = hand.now()
        hand.write(stroke, scale, pace)
        stops = hand.now()
        if random.random() < 0.3:
            hand.rest(random.uniform(0.02, 0.3))
        ink.append([touch, moves, stops, hand.now()])
    _finish(hand, about, ink)
    return _sampled(hand, about, ink)


def _begin(hand, about, start):
    """What a hand does before it writes; when the pen touched, or None if it lay there."""
    random, lift = hand.random, about["lift"]
    if about["head"] == "rests":
        hand.begin([*start, 0.0])
        hand.rest(random.uniform(0.3, 4.0))
        return None
    if about["head"] == "hops":
        hand.begin([*(start + random.normal(0, 0.02, 2)), 0.0])
        hand.rest(random.uniform(0.3, 2.0))
        hand.go(hand.here() + np.array([0, 0, lift]), 0.12 + 3 * lift)
    else:
        hand.begin([*(start + random.normal(0, 0.03, 2)), random.uniform(0.02, 0.06)])
        hand.rest(0.1 if about["head"] == "flies" else random.uniform(0.2, 1.0))
    return land(hand, start, about["habit"], lift)


def _over(hand, about, to):
    """Off the paper and to the next stroke; when the pen touched."""
    random, lift = hand.random, about["lift"]
    here, to = hand.here(), np.asarray(to)
    middle = (here[:2] + to) / 2
    seconds = min(0.35, max(0.08, lift / random.uniform(0.07, 0.2)))
    hand.go([*middle, lift], seconds)
    return land(hand, to, about["habit"], lift)


def _finish(hand, about, ink):
    """What a hand does after it wrote."""
    random = hand.random
    if about["tail"] == "rests":
        hand.rest(random.uniform(0.3, 3.0))
        ink[-1][3] = None
    elif about["tail"] == "flies":
        hand.go(
            hand.here() + np.array([0.1, -0.03, random.uniform(0.03, 0.1)]),
            random.uniform(0.25, 0.5),
        )
    elif about["tail"] == "lifts":
        hand.go(hand.here() + np.array([0.05, -0.02, about["lift"]]), 0.12 + 2 * about["lift"])
        hand.go(hand.here() + np.array([0.02, -0.02, -about["lift"]]), 0.2 + 2 * about["lift"])
        hand.rest(random.uniform(0.3, 1.0))
    else:
        ink[-1][3] = None


def _sampled(hand, about, ink):
    """The marker on the cameras' clock: it wanders as the hand turns, and trembles."""
    random = hand.random
    fine = np.concatenate(hand.points)
    t = np.arange(0, len(fine) * FINE, 1 / about["rate"])
    page = np.column_stack([np.interp(t, np.arange(len(fine)) * FINE, axis) for axis in fine.T])
    size = about["size"]
    turn, phase = random.uniform(0.2, 0.8), random.uniform(0, 2 * np.pi)
    direction = random.normal(size=2)
    along = page[:, :2] @ (direction / np.linalg.norm(direction)) / size
    page[:, 2] += about["wander"] / 2 * np.sin(2 * np.pi * turn * along + phase)
    page[:, 2] += page[:, :2] @ about["slope"]
    page += random.normal(0, about["noise"], page.shape)
    return Take(t, page, tuple(tuple(each) for each in ink), about)
