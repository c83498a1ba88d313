"""Few moments instead of many: the keys between which a browser may interpolate without leaving the motion."""

from __future__ import annotations

import numpy as np

from dmp_teach.robot import Model, Motion
from dmp_teach.trajectory import Array

FRAMES_PER_SECOND = 15
TOLERANCE = 0.0001
"""How far any point of the robot may be from its place between two keys [m]."""

MOST_KEYS = 1200
"""A long text is shown a little less exactly, so that its file stays small."""

_PROBES = np.array([[0, 0, 0, 1], [0.1, 0, 0, 1], [0, 0.1, 0, 1], [0, 0, 0.1, 1]]).T
"""Four points on each link: its origin and one decimetre along each axis, as columns [m]."""


def key_rows(model: Model, motion: Motion, tolerance: float = TOLERANCE) -> Array:
    """Which samples of a motion are its keys: 15 a second, and more where the arm is too quick for that.

    Between two keys every joint moves evenly, which is what three.js does with the quaternions of a joint that
    turns about a fixed axis. A stretch that leaves the motion by more than the tolerance is cut in half.

    Args:
        model: The robot.
        motion: What it does.
        tolerance: Largest distance of any probe from its place [m].

    Returns:
        Row numbers, increasing, the first and the last always among them, shape (K,).
    """
    truth = _probes(model, motion, motion.q)
    while len(rows := _cut(model, motion, truth, tolerance)) > MOST_KEYS and tolerance < 0.01:
        tolerance *= 1.6
    return rows


def _cut(model: Model, motion: Motion, truth: Array, tolerance: float) -> Array:
    """The rows of the keys that keep the tolerance [m]."""
    last = len(motion.t) - 1
    stride = (
        max(1, round(last / (motion.duration * FRAMES_PER_SECOND))) if motion.duration > 0 else 1
    )
    rows = np.unique(np.append(np.arange(0, last + 1, stride), last))
    while True:
        off = np.linalg.norm(_probes(model, motion, _between(motion, rows)) - truth, axis=-1).max(
            axis=1
        )
        worst = np.maximum.reduceat(off, rows)[:-1] if len(rows) > 1 else np.empty(0)
        middle = (rows[:-1] + rows[1:]) // 2
        new = middle[(worst > tolerance) & (middle > rows[:-1])]
        if not len(new):
            return rows
        rows = np.union1d(rows, new)


def _between(motion: Motion, rows: Array) -> Array:
    """The joints at every sample, if they moved evenly from key to key, shape (T, J) [rad, m]."""
    return np.column_stack(
        [np.interp(motion.t, motion.t[rows], column) for column in motion.q[rows].T]
    )


def _probes(model: Model, motion: Motion, q: Array) -> Array:
    """All probes on all links, shape (T, L * 4, 3) [m]."""
    poses = model.link_poses(q, motion.joint_names)
    return np.concatenate([np.swapaxes(X @ _PROBES, 1, 2)[..., :3] for X in poses.values()], axis=1)
