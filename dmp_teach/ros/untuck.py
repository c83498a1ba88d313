"""Find a way from the tucked arm to the page that comes near neither the body nor the table.

A small lazy roadmap (Bohlin and Kavraki 2000) of straight legs between postures: the quickest way
over postures that people use to unfold a Fetch is looked at first, and only its legs are checked; a
leg that touches something is struck out, and so on.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.sparse.csgraph import dijkstra

from dmp_teach.errors import ReachError
from dmp_teach.progress import Progress
from dmp_teach.robot import Model, Motion, Proximity
from dmp_teach.trajectory import Array
from dmp_teach.values import locked

TUCKED = locked([0.05, 1.32, 1.40, -0.20, 1.72, 0.0, 1.66, 0.0])
"""How the Fetch folds its arm to drive: torso [m], then the joints from the shoulder [rad]."""

ROBOT_CLEARANCE = 0.01
"""The arm keeps this far from the robot [m], unless it starts or ends nearer: then so near."""

PAGE_CLEARANCE = 0.02
"""And this far from the page and what it lies on [m]."""

# First the Fetch's own posture between tucked and free, then others to its left and up [rad].
_UNFOLDED = (
    (1.32, 0.0, -1.4, 1.72, 0.0, 1.66, 0.0),
    (1.32, -0.6, -1.4, 1.72, 0.0, 1.66, 0.0),
    (1.32, -0.9, -0.2, 1.72, 0.0, 1.66, 0.0),
    (1.32, 0.0, -0.2, 1.72, 0.0, 1.66, 0.0),
)
# Shoulder lifts that take the pen off the page [rad].
_RAISED = (0.0, -0.2, -0.4, -0.8)
# What the page lies on goes on so far beyond it [m]: as much as leaves a way.
_AROUND = (0.2, 0.1, 0.05)
# A leg is looked at every so far [rad, m], after so many times as far.
_STEP = 0.05
_COARSE = 6
# What a stop between two legs costs [s].
_STOP = 0.5
_SLACK = 0.001


def find_way(motion: Motion, start: Array, report: Progress) -> Array:
    """Find postures (N, J) from a start (J,) to a motion's first, with straight ways between.

    The arm stays clear of the robot and of a block below the page that goes on for 20 cm beyond it,
    or for 10 or 5 cm where there is no other way. The last is the motion's first, but for whole
    turns of joints that turn for ever. The same input gives the same way.

    Raises:
        ReachError: No way was found.
    """
    for around in _AROUND:
        way = _Roadmap(motion, np.asarray(start, dtype=float), around).way(report)
        if way is not None:
            return way
    raise ReachError(
        "No way was found from the arm's start to the page that touches neither the robot nor what "
        "the page lies on. Move the page away from the robot, or write the letter alone "
        "(start=None) and bring the arm to it yourself."
    )


class _Roadmap:
    """The places, what a leg between two of them costs, and which legs are clear."""

    def __init__(self, motion: Motion, start: Array, around: float) -> None:
        model = Model.load()
        joints = [model.joint(name) for name in motion.joint_names]
        self.fastest = np.array([joint.velocity for joint in joints])
        turns = np.array([joint.type == "continuous" for joint in joints])
        goal = motion.q[0] - turns * 2 * np.pi * np.round((motion.q[0] - start) / (2 * np.pi))
        self.proximity = Proximity(motion.joint_names, motion.page, around)
        ends = self.proximity.distances(np.array([start, goal]))
        on_page = np.array([other == "page" for _, other in self.proximity.pairs])
        self.start_is_free = bool((ends[0, on_page] > PAGE_CLEARANCE).all())
        keep = np.where(on_page, PAGE_CLEARANCE, ROBOT_CLEARANCE)
        self.enough = np.minimum(keep, ends.min(axis=0) - _SLACK)
        lift = np.array([joint.name == "shoulder_lift_joint" for joint in joints])
        unfolded = [np.append(0.0, arm) for arm in _UNFOLDED]
        through = np.array([TUCKED, *unfolded, *(goal + by * lift for by in _RAISED)])
        lower, upper = np.array([(joint.lower, joint.upper) for joint in joints]).T
        # Each with the torso as it will be, and all the way up.
        places = np.clip(np.repeat(through, 2, axis=0), lower, upper)
        places[::2, 0] = goal[0]
        places[1::2, 0] = upper[0]
        self.places = np.array([start, goal, *places[self._clear(places)]])

    def _clear(self, q: Array) -> Array:
        """Return which postures (T, J) keep enough away from everything, shape (T,)."""
        return (self.proximity.distances(q) >= self.enough).all(axis=1)

    def _leg_is_clear(self, one: Array, other: Array) -> bool:
        """Whether the arm may go straight from one posture to another."""
        parts = np.linspace(0, 1, 2 + int(np.abs(other - one).max() / _STEP))[:, None]
        q = one + parts * (other - one)
        return bool(self._clear(q[::_COARSE]).all() and self._clear(q).all())

    def way(self, report: Progress) -> Array | None:
        """Return the quickest way whose legs are all clear, if there is one."""
        legs, tried = len(self.places) * (len(self.places) - 1) // 2, 0
        costs = (np.abs(self.places[:, None] - self.places) / self.fastest).max(axis=2) + _STOP
        clear: set[tuple[int, int]] = set()
        while self.start_is_free:
            length, before = dijkstra(costs, indices=0, return_predecessors=True)
            if not np.isfinite(length[1]):
                break
            way = [1]
            while way[0] != 0:
                way.insert(0, int(before[way[0]]))
            for leg in pairwise(way):
                report(tried, legs)
                tried += leg not in clear
                if leg not in clear and not self._leg_is_clear(*self.places[list(leg)]):
                    costs[leg] = costs[leg[::-1]] = np.inf
                    break
                clear.add(leg)
            else:
                report(legs, legs)
                return self.places[way]
        return None
